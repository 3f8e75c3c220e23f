"""The public routes: their description is the one in docs, is not served, and their documents have the shapes in it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.workbench.events import Hub
from groundslab.workbench.solver import process
from helpers import asgi, small_case, workers
from helpers.paths import DOCS

pytest.importorskip("fastapi")
from groundslab.workbench.server.public import PUBLIC, openapi
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import Guard, Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
GOOD = [("host", f"127.0.0.1:{PORT}"), ("x-groundslab-token", TOKEN)]


@pytest.fixture
def app(tmp_path: Path) -> Iterator[Guard]:
    """Return the application of a workbench whose solver solves nothing."""
    hub = Hub()
    session = Session(hub, Solver(hub.publish, workers.obey, None), tmp_path, "", workers.Inline())
    yield create_app(session, Tickets(), PORT, TOKEN, tmp_path)
    session.close()


def test_public_routes_are_documented(app: Guard) -> None:
    """Those of docs are those of the application, each with a summary; the routes of the page are not among them."""
    described: dict[str, Any] = json.loads((DOCS / "interface" / "openapi.json").read_text(encoding="utf-8"))
    present = openapi(app.app)
    assert {path: sorted(of) for path, of in present["paths"].items()} == {
        path: sorted(of) for path, of in described["paths"].items()
    }
    operations = [operation for of in described["paths"].values() for operation in of.values()]
    assert all(operation["summary"] and operation["tags"] == [PUBLIC] for operation in operations)
    assert described["components"]["schemas"].keys() == present["components"]["schemas"].keys()
    assert described["security"] == [{"token": []}]
    assert not described["paths"].keys() & {"/api/ticket", "/api/results/{run}/scene", "/api/undo"}


def test_the_description_is_not_served(app: Guard) -> None:
    """No route gives the description, to whoever asks; the public ones ask for the token as all others do."""
    for path in ("/openapi.json", "/api/openapi.json", "/redoc"):
        assert asgi.ask(app, "GET", path, GOOD).status == 404
    for path in ("/api/results/1/documents/summary", "/api/schema"):
        assert asgi.ask(app, "GET", path, GOOD[:1]).status == 403
        assert asgi.ask(app, "GET", path, [*GOOD, ("origin", "http://evil.example")]).status == 403


def test_documents_are_those_of_the_commands(app: Guard) -> None:
    """The solver writes the documents; there is none of other runs, and none of other names."""
    jsonschema = pytest.importorskip("jsonschema")
    results = groundslab.solve(casefile.loads(small_case.TEXT))
    solved = process.Solved(small_case.TEXT, results, {}, small_case.TEXT)
    for name in ("summary", "design", "tables"):
        document = json.loads(process.WRITERS["document"](solved, name, lambda _title, _share: None))
        schema = json.loads((DOCS / "interface" / f"{name}.schema.json").read_text(encoding="utf-8"))
        jsonschema.validate(document, schema)
    assert asgi.ask(app, "GET", "/api/results/7/documents/summary", GOOD).status == 404
    assert asgi.ask(app, "GET", "/api/results/7/documents/others", GOOD).status == 422
