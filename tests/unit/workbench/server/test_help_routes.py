"""The routes of help: guarded as all others, and nothing but the listed pages and files is handed out."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from groundslab.workbench.events import Hub
from helpers import asgi, workers
from helpers.help_files import copied_help
from helpers.paths import ROOT

pytest.importorskip("fastapi")
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import HEADERS, Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
HOST = [("host", f"127.0.0.1:{PORT}")]
GOOD = [*HOST, ("x-groundslab-token", TOKEN)]


@pytest.fixture
def app(tmp_path: Path) -> Iterator[Any]:
    """Return the application of a new document."""
    hub = Hub()
    solver = Solver(hub.publish, workers.obey, None)
    session = Session(hub, solver, tmp_path / "state", "http://x", workers.Inline())
    with copied_help(tmp_path / "static"):
        yield create_app(session, Tickets(), PORT, TOKEN, tmp_path)
    session.close()


def post(app: Any, path: str, body: dict[str, Any], headers: Any = GOOD) -> asgi.Answer:
    """Send JSON."""
    content = json.dumps(body).encode()
    size = [("content-type", "application/json"), ("content-length", str(len(content)))]
    return asgi.ask(app, "POST", path, [*headers, *size], content)


def test_an_example_becomes_a_new_document(app: Any) -> None:
    """It has the example's text and no file, and is not taken for unsaved work."""
    listed = asgi.ask(app, "GET", "/api/examples", GOOD).json()
    assert "tank" in [example["name"] for example in listed]
    state = post(app, "/api/examples", {"name": "tank"}).json()
    assert state["text"] == (ROOT / "examples" / "tank.toml").read_text(encoding="utf-8")
    assert (state["file"], state["dirty"], state["can_undo"]) == (None, False, False)


def test_an_unknown_example_is_refused(app: Any) -> None:
    """The document stays what it was."""
    before = asgi.ask(app, "GET", "/api/state", GOOD).json()["text"]
    for name in ("../pyproject", "nothing", "tank.toml"):
        answer = post(app, "/api/examples", {"name": name})
        assert (answer.status, answer.json()["error"]["location"]) == (422, "the example"), name
    assert asgi.ask(app, "GET", "/api/state", GOOD).json()["text"] == before


def test_examples_need_the_token(app: Any) -> None:
    """Neither the list nor an example is handed out without it."""
    assert asgi.ask(app, "GET", "/api/examples", HOST).status == 403
    assert post(app, "/api/examples", {"name": "tank"}, HOST).status == 403


def test_pages_are_handed_out(app: Any) -> None:
    """The start, a page, its style and a picture have the headers that forbid to load anything from elsewhere."""
    for path, kind in [
        ("/docs/", "text/html"),
        ("/docs/input", "text/html"),
        ("/docs/howto/draw_a_slab", "text/html"),
        ("/docs/documentation.css", "text/css"),
        ("/docs/images/input.svg", "image/svg+xml"),
    ]:
        answer = asgi.ask(app, "GET", path, HOST)
        assert (answer.status, answer.headers["content-type"].split(";")[0]) == (200, kind), path
        assert HEADERS.items() <= answer.headers.items()
    page = asgi.ask(app, "GET", "/docs/input", HOST).text
    assert "https://" not in page.partition("<main>")[0]


def test_nothing_else_is_handed_out(app: Any) -> None:
    """Only names in the list are found, whatever way leads there."""
    for path in (
        "/docs/nothing",
        "/docs/input.md",
        "/docs/../../examples/tank.toml",
        "/docs/%2e%2e/%2e%2e/pyproject.toml",
        "/docs/..%2f..%2fexamples%2ftank.toml",
        "/docs//etc/passwd",
        "/docs/documentation.py",
        "/docs/<b>x",
    ):
        answer = asgi.ask(app, "GET", path, HOST)
        assert answer.status == 404, path
        assert "<b>x" not in answer.text


def test_pages_are_guarded(app: Any) -> None:
    """Pages of others do not get them, and nothing can be sent there."""
    for headers in (
        [("host", "evil.example")],
        [*HOST, ("origin", "http://evil.example")],
        [*HOST, ("sec-fetch-site", "cross-site")],
    ):
        assert asgi.ask(app, "GET", "/docs/input", headers).status == 403, headers
    assert post(app, "/docs/input", {}, HOST).status == 403


def test_results_that_are_only_shown_have_the_documentation_too(tmp_path: Path) -> None:
    """The server of kept results hands out the pages as well, without examples."""
    from groundslab.workbench.server.view import create_view_app

    view: Any = SimpleNamespace(
        get_state=lambda: {"version": 1},
        hub=Hub(),
        get_current_events=lambda: [("state", {})],
        export=None,
        write_difference=None,
    )
    app = create_view_app(view, Tickets(), PORT, TOKEN, tmp_path)
    with copied_help(tmp_path / "static"):
        assert asgi.ask(app, "GET", "/docs/results", HOST).status == 200
        assert asgi.ask(app, "GET", "/api/examples", GOOD).status == 404
