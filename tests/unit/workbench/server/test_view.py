"""Results that are looked at: the same guard as the workbench, the same answers, and nothing that changes anything."""

from __future__ import annotations

import asyncio
import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.views.files import archive
from groundslab.views.interface import documents
from groundslab.views.scene.binary import pack
from groundslab.views.scene.fields import scene_of
from groundslab.workbench.solver.summary import build_summary
from helpers import asgi
from helpers.asgi import Headers
from helpers.small_case import TEXT

pytest.importorskip("fastapi")
from groundslab.workbench.server.security import HEADERS, Tickets
from groundslab.workbench.server.view import ResultsView, create_view_app

PORT, TOKEN = 8765, "secret"
HOST = ("host", f"127.0.0.1:{PORT}")
GOOD = [HOST, ("x-groundslab-token", TOKEN)]
PARTS = ("scene", "summary", "documents/tables", "report")


@pytest.fixture(scope="module")
def solved() -> groundslab.Results:
    """Results of a small slab."""
    return groundslab.solve(casefile.loads(TEXT))


@pytest.fixture(params=["folder", "archive"])
def kept(solved: groundslab.Results, tmp_path: Path, request: pytest.FixtureRequest) -> Path:
    """The results in a folder, or in one file."""
    if request.param == "folder":
        return groundslab.save_results(solved, tmp_path / "slab-results")
    path = tmp_path / "slab-results.zip"
    path.write_bytes(archive.pack_results(solved, TEXT, "<p>report</p>"))
    return path


def test_the_answers_are_those_of_the_workbench(kept: Path, solved: groundslab.Results, tmp_path: Path) -> None:
    """State, summary, scene, report and event are those of the results; nothing is written beside them."""
    view = ResultsView.read(kept)
    app = create_view_app(view, Tickets(), PORT, TOKEN, tmp_path)
    before = sorted(tmp_path.rglob("*"))
    state = asgi.ask(app, "GET", "/api/state", GOOD).json()
    assert state["view"] == str(kept)
    assert ("# The comment" in state["text"]) == kept.is_file()
    assert asgi.ask(app, "GET", "/api/results/1/summary", GOOD).json() == build_summary(solved)
    assert asgi.ask(app, "GET", "/api/results/1/scene", GOOD).content == pack(scene_of(solved))
    for name, document in documents.DOCUMENTS.items():
        assert asgi.ask(app, "GET", f"/api/results/1/documents/{name}", GOOD).json() == json.loads(
            documents.to_text(document(solved))
        )
    report = asgi.ask(app, "GET", "/api/results/1/report", GOOD)
    assert report.content.startswith(b"<!doctype html>") or b"<html" in report.content[:300]
    assert "slab-results-report.html" in report.headers["content-disposition"]
    [(name, about)] = view.get_current_events()
    assert (name, about["run"], about["seconds"]) == ("solved", 1, None)
    assert [asgi.ask(app, "GET", f"/api/results/2/{part}", GOOD).status for part in PARTS] == [404] * len(PARTS)
    assert sorted(tmp_path.rglob("*")) == before


def test_others_are_refused_and_nothing_changes(solved: groundslab.Results, tmp_path: Path) -> None:
    """The guard stands before every route; there is none that edits, opens, saves or solves."""
    app = create_view_app(ResultsView("slab", solved, TEXT, None), Tickets(), PORT, TOKEN, tmp_path)
    paths = ["state", "schema", "events", *(f"results/1/{part}" for part in PARTS)]
    wrong: list[Headers] = [[HOST], [HOST, ("x-groundslab-token", "guess")], [("host", "evil.example"), GOOD[1]]]
    wrong += [[*GOOD, ("origin", "http://evil.example")], [*GOOD, ("sec-fetch-site", "cross-site")]]
    for path in paths:
        for headers in wrong:
            answer = asgi.ask(app, "GET", f"/api/{path}", headers)
            assert answer.status == 403
            assert HEADERS.items() <= answer.headers.items()
    body = [*GOOD, ("content-type", "application/json"), ("content-length", "2")]
    for path in ("edits", "save", "open", "new", "undo", "redo", "restore", "solve", "cancel", "autosolve"):
        assert asgi.ask(app, "POST", f"/api/{path}", body, b"{}").status in (404, 405)
    assert asgi.ask(app, "GET", "/api/files", GOOD).status == 404


def test_what_holds_no_results_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A missing path, an empty folder and another file are refused with words, by the command too."""
    (tmp_path / "empty").mkdir()
    (tmp_path / "x.zip").write_bytes(b"PK")
    for name, words in (("none", "no folder or file"), ("empty", "no summary.json"), ("x.zip", "not a zip file")):
        with pytest.raises(InputError, match=words):
            ResultsView.read(tmp_path / name)
        assert main.main(["view", str(tmp_path / name), "--no-browser"]) == 2
        assert words in capsys.readouterr().err


def test_the_events_are_a_stream(solved: groundslab.Results) -> None:
    """A page that connects is told at once that there is a result."""
    view = ResultsView("slab", solved, TEXT, None)

    async def first() -> bytes:
        stream = view.hub.listen(view.get_current_events)
        try:
            return await anext(stream)
        finally:
            await stream.aclose()  # type: ignore[attr-defined]

    # in a thread of its own, since a browser of other tests keeps a loop running in this one
    with ThreadPoolExecutor(1) as pool:
        assert pool.submit(lambda: asyncio.run(first())).result().startswith(b"event: solved\n")
