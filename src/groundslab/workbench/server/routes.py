"""The addresses of the server: what each takes and gives. All else is in ``session``."""

from __future__ import annotations

import json
import mimetypes
import secrets
import threading
from collections.abc import AsyncIterator
from functools import cache
from pathlib import Path
from typing import Annotated, Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, RedirectResponse, Response, StreamingResponse
from fastapi.staticfiles import StaticFiles
from pydantic import BaseModel, ConfigDict, Field

from groundslab.errors import InputError, Issue
from groundslab.model.model import json_schema
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.persistence import files
from groundslab.workbench.server.security import Guard
from groundslab.workbench.server.session import Conflict, OpenElsewhere, Session, State

STATIC = Path(__file__).parents[1] / "static"
#: Systems may call these otherwise, and a browser runs no script that is called text.
TYPES = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2"}


class _Body(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Edits(_Body):
    """What the user did, as edits of the document that has this version."""

    edits: Annotated[list[dict[str, Any]], Field(max_length=10_000)]
    text: Annotated[str, Field(max_length=1000)] = ""
    base: int | None = None
    merge: bool = False


class Save(_Body):
    """Where to save, if not where it was; whether what is there may be overwritten."""

    file: Annotated[str, Field(min_length=1)] | None = None
    over: bool = False


class Open(_Body):
    """What to open."""

    file: Annotated[str, Field(min_length=1)]


class Restore(_Body):
    """Whether the unsaved work is wanted."""

    take: bool


class Autosolve(_Body):
    """Whether every change is solved."""

    on: bool


class Tickets:
    """Secrets that let in once: other users may see the address with which a browser is started, but only then."""

    def __init__(self) -> None:
        self._valid: set[str] = set()
        self._lock = threading.Lock()

    def issue(self) -> str:
        """Return a new one."""
        ticket = secrets.token_urlsafe(32)
        with self._lock:
            self._valid.add(ticket)
        return ticket

    def redeem(self, ticket: str) -> bool:
        """Return whether a ticket is valid, which it is no longer then."""
        with self._lock:
            valid = ticket in self._valid
            self._valid.discard(ticket)
            return valid


def application(session: Session, tickets: Tickets, port: int, token: str, static: Path = STATIC) -> Guard:
    """Return the server's application behind its guard."""
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None)
    _answer_errors(app, session)
    _documents(app, session)
    _solving(app, session)
    _doors(app, tickets, token)
    for suffix, kind in TYPES.items():
        mimetypes.add_type(kind, suffix)
    app.mount("/", StaticFiles(directory=static, html=True, check_dir=False))
    return Guard(app, port, token)


def _answer_errors(app: FastAPI, session: Session) -> None:
    """Have errors told as {"error": ...}; a version that is too old is answered with the present state."""

    @app.exception_handler(InputError)
    async def wrong(_: Request, error: InputError) -> JSONResponse:
        return JSONResponse({"error": _told(error.issues)}, 422)

    @app.exception_handler(OSError)
    async def unavailable(_: Request, error: OSError) -> JSONResponse:
        where = str(error.filename or "the system")
        return JSONResponse({"error": _told([Issue(where, files.reason(error), "a place that can be used")])}, 422)

    @app.exception_handler(RequestValidationError)
    async def unreadable(_: Request, error: RequestValidationError) -> JSONResponse:
        words = [f"{'.'.join(map(str, each['loc']))}: {each['msg']}" for each in error.errors()]
        return JSONResponse({"error": {"message": "; ".join(words), "faults": []}}, 422)

    @app.exception_handler(Conflict)
    def conflict(_: Request, error: Conflict) -> JSONResponse:
        if error.kind == "version":
            return JSONResponse(session.state(), 409)
        url = {"url": error.url} if isinstance(error, OpenElsewhere) else {}
        return JSONResponse({"error": {"kind": error.kind, **url, **_told(error.issues)}}, 409)


def _told(wrong: Any) -> dict[str, Any]:
    """Return faults as an answer: the only one's parts beside the list, so that it can be shown as it is."""
    told = diagnostics.issues_to_json(wrong)
    head = told[0] if len(told) == 1 else {"message": "\n".join(map(str, wrong))}
    return {**head, "faults": told}


def _doors(app: FastAPI, tickets: Tickets, token: str) -> None:
    """Add the way in for a browser that is started with an address that others may see."""

    @app.post("/api/ticket")
    def ticket() -> dict[str, str]:
        return {"ticket": tickets.issue()}

    @app.get("/open")
    def enter(ticket: str = "") -> Response:
        if tickets.redeem(ticket):
            return RedirectResponse(f"/?token={token}", 303)
        return Response("This address worked once. The terminal shows one that works again.", 403)


def _documents(app: FastAPI, session: Session) -> None:
    """Add what concerns the document and its file."""

    @app.get("/api/state")
    def state() -> State:
        return session.state()

    @app.get("/api/schema")
    def schema() -> Response:
        return Response(_schema(), media_type="application/json")

    @app.post("/api/edits")
    def edits(body: Edits) -> State:
        return session.edit(body.edits, body.text, body.base, body.merge)

    @app.post("/api/undo")
    def undo() -> State:
        return session.undo()

    @app.post("/api/redo")
    def redo() -> State:
        return session.redo()

    @app.post("/api/save")
    def save(body: Save) -> State:
        return session.save(body.file, body.over)

    @app.post("/api/open")
    def open_file(body: Open) -> State:
        return session.open(body.file)

    @app.post("/api/new")
    def new() -> State:
        return session.new()

    @app.post("/api/restore")
    def restore(body: Restore) -> State:
        return session.restore(body.take)

    @app.get("/api/files")
    def listing(folder: str | None = None) -> dict[str, Any]:
        return session.listing(folder)


def _solving(app: FastAPI, session: Session) -> None:
    """Add what concerns the solver and its results."""

    @app.post("/api/solve")
    def solve() -> dict[str, int]:
        return {"run": session.solve()}

    @app.post("/api/cancel")
    def cancel() -> dict[str, Any]:
        session.cancel()
        return {}

    @app.post("/api/autosolve")
    def autosolve(body: Autosolve) -> dict[str, Any]:
        session.autosolve(body.on)
        return {}

    @app.get("/api/events")
    async def events() -> StreamingResponse:
        stream: AsyncIterator[bytes] = session.hub.listen(session.present)
        return StreamingResponse(stream, media_type="text/event-stream")

    @app.get("/api/results/{run}/scene")
    def scene(run: int) -> Response:
        result = session.solver.result(run)
        return _gone() if result is None else Response(result.scene, media_type="application/octet-stream")

    @app.get("/api/results/{run}/summary")
    def summary(run: int) -> Response:
        result = session.solver.result(run)
        return _gone() if result is None else JSONResponse(result.answer.summary)

    @app.get("/api/results/{run}/report")
    def report(run: int) -> Response:
        name, content = session.report(run)
        headers = {"Content-Disposition": f"attachment; filename*=UTF-8''{_quoted(name)}"}
        return Response(content, media_type="text/html; charset=utf-8", headers=headers)


def _gone() -> JSONResponse:
    return JSONResponse({"error": {"message": "the results of that run are not kept any more"}}, 404)


def _quoted(name: str) -> str:
    """Return a file's name as a header holds it."""
    from urllib.parse import quote

    return quote(name, safe="")


@cache
def _schema() -> str:
    """Return the JSON schema of a case file."""
    return json.dumps(json_schema())
