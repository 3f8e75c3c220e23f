"""The HTTP interface of the server; what the routes do is in ``session``."""

from __future__ import annotations

import mimetypes
import pickle
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Annotated, Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import RedirectResponse, Response, StreamingResponse
from fastapi.staticfiles import StaticFiles
from pydantic import BaseModel, ConfigDict, Field

from groundslab.errors import InputError, Issue
from groundslab.exchange.reactions import Choices
from groundslab.languages import Language, page_messages
from groundslab.messages import Label, Message, joined
from groundslab.model.model import json_schema
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.exports.files import Exported, Wanted
from groundslab.workbench.exports.routes import add_export_route, respond_download, respond_export
from groundslab.workbench.persistence import files
from groundslab.workbench.saying import Answer, Route, present_translator, say_refusals
from groundslab.workbench.server.case_file import Conflict, OpenElsewhere
from groundslab.workbench.server.file_routes import add_accuracy_routes, add_changed_file_routes, add_difference_routes
from groundslab.workbench.server.help_routes import add_documentation_routes, add_example_routes
from groundslab.workbench.server.public import Run, add_document_route, describe
from groundslab.workbench.server.security import Guard, Tickets
from groundslab.workbench.server.session import Session, State
from groundslab.workbench.solver.comparer import TASKS, Kind

UNTITLED = Path("case.toml")
#: What is read of an issue.
_READ = ("location", "found", "expected", "hint")
STATIC = Path(__file__).parents[1] / "static"
#: A system may register other types, and a browser runs no script of type text/plain.
TYPES = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2"}


class _Body(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Edits(_Body):
    """Edits of the version ``base``, as one step of the undo history."""

    edits: Annotated[list[dict[str, Any]], Field(max_length=10_000)]
    text: Annotated[str, Field(max_length=1000)] = ""
    base: int | None = None
    merge: bool = False


class Save(_Body):
    """Another file to save to; whether an existing one is overwritten."""

    file: Annotated[str, Field(min_length=1)] | None = None
    over: bool = False


class Open(_Body):
    """The file to open."""

    file: Annotated[str, Field(min_length=1)]


class OpenDrawing(_Body):
    """A drawing: what its layers hold, its unit, whether its middle is the origin, gaps closed, outlines joined."""

    file: Annotated[str, Field(min_length=1)]
    layers: Annotated[dict[str, str], Field(max_length=1000)]
    unit: Annotated[str, Field(max_length=100)] | None = None
    centered: bool = False
    gap: Annotated[str, Field(max_length=100)] = "1 mm"
    union: bool = False


class OpenSlab(_Body):
    """A slab of a SAF file or a building; of that, whether its middle is the origin, whether it is turned along x."""

    file: Annotated[str, Field(min_length=1)]
    slab: Annotated[str, Field(min_length=1, max_length=1000)]
    centered: bool = False
    aligned: bool = False


class ImportReactions(_Body):
    """A table of reactions, what is said of it, keys of [reactions]; with the version to take it into, else to look."""

    file: Annotated[str, Field(min_length=1)]
    new_cases: Annotated[dict[str, str], Field(max_length=1000)] = {}
    cases: Annotated[dict[str, str], Field(max_length=1000)] = {}
    supports: Annotated[dict[str, str], Field(max_length=10_000)] = {}
    move_columns: bool = False
    reading: Annotated[dict[str, Any], Field(max_length=100)] = {}
    base: int | None = None


class Restore(_Body):
    """Whether unsaved work is restored or declined."""

    take: bool


class Autosolve(_Body):
    """Whether every change is solved at once."""

    on: bool


class Shown(_Body):
    """The combination that is looked at, None if several are."""

    combination: str | None


def create_app(session: Session, tickets: Tickets, port: int, token: str, static: Path = STATIC) -> Guard:
    """Return the server's application."""
    app = make_app()
    add_error_handlers(app)
    _add_conflict_handler(app, session)
    _add_document_routes(app, session)
    _add_import_routes(app, session)
    add_difference_routes(app, session.analyses)
    _add_solver_routes(app, session)
    _add_file_routes(app, session)
    _add_table_routes(app, session)
    add_example_routes(app, session)
    add_changed_file_routes(app, session)
    add_accuracy_routes(app, session.analyses)
    return guard_app(app, tickets, port, token, static)


def make_app() -> FastAPI:
    """Return an application without routes, which answers in the language of each request."""
    app = FastAPI(docs_url=None, redoc_url=None, openapi_url=None, default_response_class=Answer)
    app.router.route_class = Route
    return app


def guard_app(app: FastAPI, tickets: Tickets, port: int, token: str, static: Path = STATIC) -> Guard:
    """Return an application with the entrance and the files of the page, behind the guard."""
    _add_ticket_routes(app, tickets, token)
    add_documentation_routes(app)
    for suffix, kind in TYPES.items():
        mimetypes.add_type(kind, suffix)
    app.mount("/", StaticFiles(directory=static, html=True, check_dir=False))
    return Guard(app, port, token)


def add_error_handlers(app: FastAPI) -> None:
    """Return errors as {"error": ...}."""

    @app.exception_handler(InputError)
    async def handle_input_error(_: Request, error: InputError) -> Answer:
        return Answer({"error": _error_to_json(error.issues)}, 422)

    @app.exception_handler(OSError)
    async def handle_os_error(_: Request, error: OSError) -> Answer:
        location = str(error.filename or "the system")
        issue = Issue(location, files.describe_error(error), Label("a place that can be used"))
        return Answer({"error": _error_to_json([issue])}, 422)

    @app.exception_handler(RequestValidationError)
    async def handle_validation_error(_: Request, error: RequestValidationError) -> Answer:
        messages = [f"{'.'.join(map(str, error['loc']))}: {error['msg']}" for error in error.errors()]
        return Answer({"error": {"message": "; ".join(messages), "issues": []}}, 422)


def _add_conflict_handler(app: FastAPI, session: Session) -> None:
    """Return conflicts as errors; an edit of an old version is answered with the present state."""

    @app.exception_handler(Conflict)
    def handle_conflict(_: Request, error: Conflict) -> Answer:
        if error.kind == "version":
            return Answer(session.get_state(), 409)
        url = {"url": error.url} if isinstance(error, OpenElsewhere) else {}
        return Answer({"error": {"kind": error.kind, **url, **_error_to_json(error.issues)}}, 409)


def _error_to_json(issues: Sequence[Issue]) -> dict[str, Any]:
    """Return issues as data for the page; a single one also without the list."""
    data = [about | {key: Label(about[key]) for key in _READ} for about in diagnostics.issues_to_json(issues)]
    return {**(data[0] if len(data) == 1 else {"message": joined(map(_line, issues), "\n")}), "issues": data}


def _line(issue: Issue) -> str:
    """Return an issue on one line."""
    found, expected, hint = map(Label, (issue.found, issue.expected, issue.hint))
    template = "found {found}, expected {expected} — {hint}" if hint else "found {found}, expected {expected}"
    return joined((Label(issue.location), Message(template, found=found, expected=expected, hint=hint)), ": ")


def _add_ticket_routes(app: FastAPI, tickets: Tickets, token: str) -> None:
    """Add the entrance for a browser, whose start address other users may see."""

    @app.post("/api/ticket")
    def issue_ticket() -> dict[str, str]:
        return {"ticket": tickets.issue()}

    @app.get("/open")
    def redirect_to_page(ticket: str = "") -> Response:
        if tickets.redeem(ticket):
            return RedirectResponse(f"/?token={token}", 303)
        return Response("This address worked once. The terminal shows one that works again.", 403)


def _add_document_routes(app: FastAPI, session: Session) -> None:
    """Add the routes of the document and its file."""
    app.get("/api/state", **describe("The document: its text, its version, its issues"))(session.get_state)
    app.get("/api/files")(session.list_folder)
    add_schema_route(app)

    @app.post("/api/edits", **describe("Edit the document: op set, add, remove or rename at a path, or text for all"))
    def edit(body: Edits) -> State:
        session.editor.edit(body.edits, body.text, body.base, body.merge)
        return session.get_state()

    @app.post("/api/undo")
    def undo() -> State:
        session.editor.undo()
        return session.get_state()

    @app.post("/api/redo")
    def redo() -> State:
        session.editor.redo()
        return session.get_state()

    @app.post("/api/restore")
    def restore(body: Restore) -> State:
        session.editor.restore(body.take)
        return session.get_state()

    @app.post("/api/new")
    def new() -> State:
        session.new()
        return session.get_state()

    @app.post("/api/save", **describe("Save the document"))
    def save(body: Save) -> State:
        session.save(body.file, body.over)
        return session.get_state()

    @app.post("/api/open", **describe("Open a case file"))
    def open_file(body: Open) -> State:
        session.open(body.file)
        return session.get_state()


def _add_import_routes(app: FastAPI, session: Session) -> None:
    """Add the routes of files of other programs: drawings, slabs, tables of reactions."""

    @app.get("/api/drawing")
    def survey_drawing(file: str) -> Answer:
        return Answer(session.survey_drawing(file))

    @app.post("/api/drawing")
    def open_drawing(body: OpenDrawing) -> dict[str, Any]:
        converted = session.open_drawing(body.file, body.layers, body.unit, body.centered, body.gap, body.union)
        return {"state": session.get_state(), "report": converted.report, "origin": converted.origin}

    @app.get("/api/slabs")
    def survey_slabs(file: str) -> Answer:
        return Answer({"slabs": session.survey_slabs(file)})

    @app.post("/api/slabs")
    def open_slab(body: OpenSlab) -> dict[str, Any]:
        converted = session.open_slab(body.file, body.slab, body.centered, body.aligned)
        return {"state": session.get_state(), "report": converted.report}

    @app.post("/api/reactions")
    def import_reactions(body: ImportReactions) -> dict[str, Any]:
        choices = Choices(body.new_cases, body.cases, body.supports, body.move_columns, body.reading)
        imported = session.import_reactions(body.file, choices, body.base)
        state = {} if body.base is None else {"state": session.get_state()}
        return {"changes": imported.changes, "sums": imported.sums, "remarks": imported.remarks, **state}


def add_schema_route(app: FastAPI) -> None:
    """Add the schema of a case file, and the messages of the page in other languages."""

    @app.get("/api/schema", **describe("The JSON schema of a case file"))
    @cache
    def get_schema() -> Answer:
        return Answer(json_schema())

    @app.get("/api/languages/{language}")
    @cache
    def get_messages(language: Language) -> Answer:
        return Answer(page_messages(language))


def _add_solver_routes(app: FastAPI, session: Session) -> None:
    """Add the routes of the solver and its results."""
    analyses = session.analyses
    schedule = analyses.solver.schedule

    @app.post("/api/solve", **describe("Solve the document at once; returns the number of the run"))
    def solve() -> dict[str, int]:
        return {"run": session.solve()}

    @app.post("/api/cancel", **describe("Stop the run in progress"))
    def cancel() -> dict[str, Any]:
        analyses.solver.cancel()
        return {}

    @app.post("/api/autosolve")
    def set_autosolve(body: Autosolve) -> dict[str, Any]:
        analyses.set_autosolve(body.on)
        return {}

    @app.get("/api/events", **describe("What happens: progress, solved, refused, ...", None, "text/event-stream"))
    async def stream_events() -> StreamingResponse:
        return StreamingResponse(
            session.hub.listen(session.get_current_events, present_translator()), media_type="text/event-stream"
        )

    @app.get("/api/results/{run}/scene")
    def get_scene(run: int) -> Response:
        result = schedule.results.get(run)
        if result is None:
            return respond_not_kept()
        scene = say_refusals(result.scene, result.answer.refused)
        return Response(scene, media_type="application/octet-stream")

    @app.get("/api/results/{run}/preview")
    def get_preview(run: int) -> Response:
        scene = schedule.get_preview(run)
        return respond_not_kept() if scene is None else Response(scene, media_type="application/octet-stream")

    @app.post("/api/shown")
    def set_shown(body: Shown) -> dict[str, Any]:
        analyses.solver.shown = body.combination
        return {}

    @app.get("/api/results/{run}/summary")
    def get_summary(run: int) -> Response:
        result = schedule.results.get(run)
        return respond_not_kept() if result is None else Answer(result.answer.summary)


def _add_file_routes(app: FastAPI, session: Session) -> None:
    """Add the routes of what is made of the results of a run."""
    analyses = session.analyses
    schedule = analyses.solver.schedule

    def get_document(run: int, name: str) -> Response:
        if schedule.results.get(run) is None:
            return respond_not_kept()
        return Response(analyses.solver.make_view(("document", run, name)), media_type="application/json")

    add_document_route(app, get_document)

    @app.get("/api/results/{run}/report", **describe("The report of a run", None, "text/html"))
    def get_report(run: Run) -> Response:
        name, content = analyses.write_report(run, session.file.path or UNTITLED)
        return respond_download(name, content, "text/html; charset=utf-8")

    @app.get("/api/results/{run}/bars")
    def propose_bars(run: int) -> Response:
        text = analyses.propose_bars(run, session.file.path or UNTITLED)
        return Response(text, media_type="text/plain; charset=utf-8")

    @app.get("/api/results/{run}/archive", **describe("Case, results, figures and report", None, "application/zip"))
    def get_archive(run: Run) -> Response:
        name, content = analyses.write_archive(run, session.file.path or UNTITLED)
        return respond_download(name, content, "application/zip")

    def export(run: int, wanted: Wanted, reference: int | None) -> tuple[str, Exported]:
        return analyses.export(run, replace(wanted, case=(session.file.path or UNTITLED).name), reference)

    add_export_route(app, export)

    @app.get("/api/saf")
    def write_saf() -> Response:
        return respond_export(*session.write_saf(UNTITLED))


def _add_table_routes(app: FastAPI, session: Session) -> None:
    """Add the routes of the tables of results, and of comparisons, each of which is a table when it has been made."""
    solver, comparer = session.analyses.solver, session.analyses.comparer

    @app.get("/api/results/{run}/tables")
    def list_tables(run: int) -> Response:
        result = solver.schedule.results.get(run)
        if result is None:
            return respond_not_kept()
        return Answer([*result.answer.tables, *comparer.list_kinds(run)])

    @app.get("/api/results/{run}/tables/{name}")
    def get_table(run: int, name: str) -> Response:
        result = solver.schedule.results.get(run)
        compared = next((comparer.get(kind, run) for kind in TASKS if kind == name), None)
        if compared is not None:
            return Answer(compared.table)
        if result is None or name not in result.answer.tables:
            return respond_not_kept()
        return Answer(pickle.loads(solver.make_view(("table", run, name))))

    @app.post("/api/results/{run}/{kind}")
    def compare(run: int, kind: Kind) -> Response:
        result = solver.schedule.results.get(run)
        if result is None:
            return respond_not_kept()
        comparer.start(kind, run, result.text, session.file.folder)
        return Answer({})

    @app.get("/api/results/{run}/alternatives")
    def get_alternatives(run: int) -> Response:
        compared = comparer.get("alternatives", run)
        return respond_not_kept() if compared is None else Answer(compared.cases)

    @app.post("/api/comparison/cancel")
    def cancel_comparison() -> dict[str, Any]:
        comparer.cancel()
        return {}


def respond_not_kept() -> Answer:
    """Return the answer about a run whose results are gone."""
    return Answer({"error": {"message": Label("the results of that run are not kept any more")}}, 404)
