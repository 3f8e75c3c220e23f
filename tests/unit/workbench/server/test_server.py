"""The server's interface: who may talk to it, what it says, and that nothing is lost on the way."""

from __future__ import annotations

import asyncio
import json
import os
import socket
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.languages import page_messages
from groundslab.results.results import results_of
from groundslab.storage import atomic
from groundslab.workbench import events
from groundslab.workbench.events import Event, Hub
from groundslab.workbench.persistence import files
from helpers import asgi, synthetic, workers
from helpers.asgi import Answer, Headers

pytest.importorskip("fastapi")
from groundslab.workbench.checking import parsing
from groundslab.workbench.server import case_file as locks
from groundslab.workbench.server.routes import UNTITLED, create_app
from groundslab.workbench.server.security import HEADERS, MAX_BODY, Tickets, check_request
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.process import OUTDATED, WRITERS, Solved
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
HOST = f"127.0.0.1:{PORT}"
PATIENCE = 120.0
GOOD = [("host", HOST), ("x-groundslab-token", TOKEN)]
CASE = """\
# A plate to edit.
[plate]
length_x = "6 m"      # along x
length_y = "4 m"
thickness = "250 mm"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[[loads]]
kind = "uniform"
q = "10 kPa"
"""


def of_json(content: bytes) -> Headers:
    """Return the headers of a body."""
    return [("content-type", "application/json"), ("content-length", str(len(content)))]


class RecordingHub(Hub):
    """A hub that records its events."""

    def __init__(self) -> None:
        super().__init__()
        self.events: list[Event] = []
        self.more = threading.Condition()

    def publish(self, name: str, about: dict[str, Any]) -> None:
        """Remember and hand on."""
        with self.more:
            self.events.append((name, dict(about)))
            self.more.notify_all()
        super().publish(name, about)

    def wait(self, name: str, **wanted: Any) -> dict[str, Any]:
        """Return the first event of that name with these values."""

        def found() -> list[dict[str, Any]]:
            return [about for word, about in self.events if word == name and wanted.items() <= about.items()]

        with self.more:
            assert self.more.wait_for(found, PATIENCE), self.events
            return found()[0]


class Bench:
    """A session, its hub, and a client that has the token."""

    def __init__(self, state: Path, static: Path, case: Path | None = None) -> None:
        self.hub = RecordingHub()
        self.solver = Solver(self.hub.publish, workers.obey, None)
        self.session = Session(self.hub, self.solver, state, f"http://{HOST}/?token={TOKEN}", workers.Inline())
        self.tickets = Tickets()
        self.app = create_app(self.session, self.tickets, PORT, TOKEN, static)
        if case is not None:
            self.session.open(str(case))
            with self.hub.more:  # the empty case that was there before may have been solved
                del self.hub.events[: [name for name, _ in self.hub.events].index("opened")]

    def ask(self, method: str, path: str, headers: Headers = GOOD, content: bytes = b"") -> Answer:
        """Return the answer to a request."""
        return asgi.ask(self.app, method, path, headers, content)

    def get(self, path: str, status: int = 200) -> Any:
        """Return the JSON of an answer."""
        answer = self.ask("GET", path)
        assert answer.status == status, answer.text
        return answer.json()

    def post(self, path: str, body: Any = None, status: int = 200) -> Any:
        """Return the JSON of an answer."""
        content = json.dumps({} if body is None else body).encode()
        answer = self.ask("POST", path, [*GOOD, *of_json(content)], content)
        assert answer.status == status, answer.text
        return answer.json()

    def set(self, path: list[str | int], value: Any, **more: Any) -> Any:
        """Set a value, and return the state."""
        edit = {"op": "set", "path": path, "value": value}
        return self.post("/api/edits", {"edits": [edit], "text": f"Set {path[-1]}", **more})

    def close(self) -> str:
        """End as the server does."""
        return self.session.close()


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a case file."""
    path = tmp_path / "work" / "raft.toml"
    path.parent.mkdir()
    path.write_text(CASE, encoding="utf-8")
    return path


@pytest.fixture
def static(tmp_path: Path) -> Path:
    """Return a folder with a page."""
    folder = tmp_path / "static"
    folder.mkdir()
    (folder / "index.html").write_text("<!doctype html><title>page</title>", encoding="utf-8")
    (folder / "index.js").write_text("1;", encoding="utf-8")
    return folder


@pytest.fixture
def bench(tmp_path: Path, static: Path, case: Path) -> Iterator[Bench]:
    """Return a workbench with the case."""
    made = Bench(tmp_path / "state", static, case)
    yield made
    made.close()


#: Requests that are none of the page's: method, path, query, headers.
STRANGE: list[tuple[str, str, str, Headers]] = [
    ("GET", "/api/state", "", [("host", HOST)]),
    ("GET", "/api/state", "", [("host", HOST), ("x-groundslab-token", "wrong")]),
    ("GET", "/api/state", "token=wrong", [("host", HOST)]),
    ("GET", "/api/state", "token=&token=secret", [("host", HOST)]),
    ("GET", "/api/state", "token=secret", [("host", HOST), ("x-groundslab-token", "wrong")]),
    ("GET", "/api/state", "", [*GOOD, ("x-groundslab-token", TOKEN)]),
    ("GET", "/api/state", "", [("host", "evil.example"), GOOD[1]]),
    ("GET", "/api/state", "", [("host", f"evil.example:{PORT}"), GOOD[1]]),
    ("GET", "/api/state", "", [("host", "127.0.0.1"), GOOD[1]]),
    ("GET", "/api/state", "", [("host", "127.0.0.1:1"), GOOD[1]]),
    ("GET", "/api/state", "", [GOOD[1]]),
    ("GET", "/api/state", "", [*GOOD, ("host", HOST)]),
    ("POST", "/api/edits", "", [*GOOD, ("origin", "http://evil.example")]),
    ("POST", "/api/edits", "", [*GOOD, ("origin", "null")]),
    ("POST", "/api/edits", "", [*GOOD, ("origin", f"https://{HOST}")]),
    ("POST", "/api/edits", "", [*GOOD, ("origin", "http://127.0.0.1:1")]),
    ("POST", "/api/edits", "", [*GOOD, ("origin", f"http://{HOST}"), ("origin", f"http://{HOST}")]),
    ("POST", "/api/edits", "", [*GOOD, ("sec-fetch-site", "cross-site")]),
    ("POST", "/api/edits", "", [*GOOD, ("sec-fetch-site", "same-site")]),
    ("GET", "/index.js", "", [("host", "evil.example")]),
    ("GET", "/", "", [("host", HOST), ("origin", "http://evil.example")]),
    ("POST", "/", "", GOOD),
    ("GET", "/api/state", "token=" + "&a=" * 30, [("host", HOST)]),
]


@pytest.mark.slow
def test_requests_of_others_are_refused(bench: Bench) -> None:
    """Wrong tokens, names, origins, sites, all of them twice: 403, and nothing has changed."""
    for method, path, query, headers in STRANGE:
        refused = check_request(asgi.scope_of(method, f"{path}?{query}", headers), PORT, TOKEN)
        assert refused is not None, headers
        assert refused[0] == 403
        answer = bench.ask(method, f"{path}?{query}", [*headers, *of_json(b"{}")], b"{}")
        assert answer.status == 403, headers
        assert bench.session.get_state()["version"] == 2


@pytest.mark.parametrize(
    "headers",
    [GOOD, [("host", f"localhost:{PORT}"), GOOD[1]], [*GOOD, ("origin", f"http://{HOST}")],
     [*GOOD, ("sec-fetch-site", "same-origin")], [*GOOD, ("sec-fetch-site", "none")]],
)  # fmt: skip
def test_its_own_page_is_not_refused(headers: list[tuple[str, str]]) -> None:
    """The page itself, under both names of this machine, by header or address."""
    for method, address, given in (
        ("POST", "/api/edits", [*headers, *of_json(b"{}")]),
        ("GET", f"/api/events?token={TOKEN}", [headers[0]]),
        ("GET", "/", [headers[0]]),
    ):
        assert check_request(asgi.scope_of(method, address, given), PORT, TOKEN) is None


def test_a_ticket_lets_in_once(bench: Bench) -> None:
    """The address that a browser is started with leads to the page once; without a ticket nobody is let in."""
    ticket = bench.post("/api/ticket")["ticket"]
    host = [("host", HOST)]
    answer = bench.ask("GET", f"/open?ticket={ticket}", host)
    assert (answer.status, answer.headers["location"]) == (303, f"/?token={TOKEN}")
    for address in (f"/open?ticket={ticket}", "/open?ticket=", "/open"):
        answer = bench.ask("GET", address, host)
        assert answer.status == 403
        assert TOKEN not in answer.text
    assert bench.ask("POST", "/api/ticket", [*host, *of_json(b"{}")], b"{}").status == 403


def test_bodies_that_are_not_taken(bench: Bench) -> None:
    """Only JSON of a stated and bounded length is read, so that no form of another page counts."""
    kind, length = of_json(b"{}")
    for headers, status in (
        ([length, ("content-type", "text/plain")], 415),
        ([length], 415),
        ([kind], 411),
        ([kind, ("content-length", "-1")], 411),
        ([kind, ("content-length", str(MAX_BODY + 1))], 413),
        ([kind, ("content-length", "9" * 5000)], 413),
    ):
        assert bench.ask("POST", "/api/undo", [*GOOD, *headers], b"{}").status == status
    assert bench.ask("POST", "/api/edits", [*GOOD, *of_json(b"[")], b"[").status == 422
    assert bench.post("/api/edits", {"edits": [], "more": 1}, 422)["error"]["message"].startswith("body.more")


@pytest.mark.slow
def test_every_answer_has_the_headers(bench: Bench) -> None:
    """The page, its script, data, errors and refusals: content policy, no store, no sniffing, no referrer."""
    answers = [bench.ask("GET", path) for path in ("/", "/index.js", "/api/state", "/none", "/api/results/9/scene")]
    answers.append(bench.ask("GET", "/api/state", [("host", HOST)]))
    assert [answer.status for answer in answers] == [200, 200, 200, 404, 404, 403]
    for answer in answers:
        assert {name: answer.headers[name] for name in HEADERS} == dict(HEADERS)
    assert answers[0].text.startswith("<!doctype html>")
    assert answers[1].headers["content-type"].startswith("text/javascript")
    assert "unsafe" not in HEADERS["content-security-policy"]
    for path in ("/../state", "/..%2f..%2fetc/passwd", "//etc/passwd", "/../../../../../../etc/passwd"):
        assert bench.ask("GET", path).status == 404


def test_the_state_says_all(bench: Bench, case: Path) -> None:
    """Text, data, plan, file and what can be done, right after a case is opened; the schema is the program's."""
    state = bench.get("/api/state")
    assert state["text"] == CASE
    assert state["data"]["plate"]["thickness"] == "250 mm"
    assert (state["issues"], state["dirty"], state["offer"]) == ([], False, None)
    assert (state["file"], state["autosolve"]) == (str(case), True)
    assert (state["can_undo"], state["can_redo"]) == (False, False)
    assert state["plan"]["bounds"] == [-3, -2, 3, 2]
    assert state["factors"]["permanent"] == [1.35, 1.0]  # EN 1990 Table A1.2(B)
    assert state["factors"]["psi"]["wind"] == [0.6, 0.2, 0.0]  # Table A1.1
    assert "plate" in bench.get("/api/schema")["properties"]


def test_the_page_gets_its_messages(bench: Bench) -> None:
    """The messages of a language as the catalogue has them, none of English; another language is refused."""
    assert bench.get("/api/languages/fr") == page_messages("fr")
    assert bench.get("/api/languages/en")["messages"] == {}
    assert bench.ask("GET", "/api/languages/xx").status == 422


def test_editing_undoing_and_doing_again(bench: Bench) -> None:
    """Each change is a version of its own with its words; undone, the text is the same to the byte."""
    first = bench.get("/api/state")["version"]
    state = bench.set(["plate", "thickness"], "300 mm", base=first)
    assert state["version"] == first + 1
    assert (state["dirty"], state["undo_text"]) == (True, "Set thickness")
    assert state["text"] == CASE.replace("250 mm", "300 mm")
    assert bench.set(["plate", "thickness"], "300 mm")["version"] == first + 1, "nothing changed"
    bench.set(["plate", "thickness"], "310 mm", merge=True)
    state = bench.post("/api/undo")
    assert (state["text"], state["dirty"], state["redo_text"]) == (CASE, False, "Set thickness")
    assert "310 mm" in bench.post("/api/redo")["text"]
    assert bench.post("/api/undo")["text"] == CASE
    assert bench.post("/api/undo")["text"] == CASE
    versions = [about["version"] for name, about in bench.hub.events if name == "state"]
    assert versions == sorted(versions)


def test_an_edit_of_an_old_version_is_refused(bench: Bench) -> None:
    """Two pages: the second one's edit meets a newer version, changes nothing and gets the present state."""
    old = bench.get("/api/state")["version"]
    bench.set(["plate", "nu"], 0.3, base=old)
    body = {"edits": [{"op": "set", "path": ["plate", "nu"], "value": 0.1}], "base": old}
    state = bench.post("/api/edits", body, 409)
    assert (state["version"], state["data"]["plate"]["nu"]) == (old + 1, 0.3)


def test_wrong_edits_are_reported(bench: Bench) -> None:
    """An invalid edit is reported as an issue; the document stays as it was."""
    body = {
        "edits": [
            {"op": "set", "path": ["plate", "nu"], "value": 0.1},
            {"op": "move", "path": ["ground"], "by": [1, 1]},
        ]
    }
    error = bench.post("/api/edits", body, 422)["error"]
    assert error["location"] == "ground"
    assert error["issues"][0]["found"] == error["found"]
    assert bench.get("/api/state")["text"] == CASE


@pytest.mark.slow
def test_a_state_that_is_wrong_keeps_the_last_good_result(bench: Bench) -> None:
    """A wrong value, then broken TOML: issues with paths or lines, the data read last; the previous result stays."""
    run = bench.hub.wait("solved")["run"]
    state = bench.set(["plate", "thickness"], "25")
    (issue,) = state["issues"]
    assert (issue["path"], issue["line"]) == (["plate", "thickness"], 5)
    assert state["plan"] is None
    state = bench.post("/api/edits", {"edits": [{"op": "text", "value": "a = = 1"}], "text": "Text"})
    assert state["data"] is None
    assert state["readable"]["plate"]["thickness"] == "25"
    assert (state["issues"][0]["path"], state["issues"][0]["line"]) == ([], 1)
    assert bench.ask("GET", f"/api/results/{run}/scene").status == 200
    assert bench.post("/api/solve", status=422)["error"]["issues"][0]["location"].startswith("the text, line 1")
    assert [name for name, _ in bench.session.get_current_events()] == ["state", "solved"]
    bench.post("/api/undo")
    assert bench.post("/api/undo")["text"] == CASE


@pytest.mark.slow
def test_a_report_on_an_earlier_case_says_so(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    """After a change the report on the last run is that of a case which has changed since; undone, it is not."""
    run = bench.hub.wait("solved")["run"]
    asked: list[str] = []
    monkeypatch.setattr(bench.solver, "make_view", lambda view: asked.append(view[0]) or b"")
    bench.session.analyses.set_autosolve(False)
    bench.session.analyses.write_report(run, UNTITLED)
    bench.set(["plate", "thickness"], "0.3 m")
    bench.session.analyses.write_report(run, UNTITLED)
    bench.post("/api/undo")
    bench.session.analyses.write_report(run, UNTITLED)
    assert asked == ["report", OUTDATED, "report"]


def test_the_outdated_report_has_a_remark(monkeypatch: pytest.MonkeyPatch) -> None:
    """It says that the case has changed, by its name; the report on the same case says nothing."""
    remarks: list[str] = []

    def render_report(*_: Any, remark: str, **__: Any) -> str:
        remarks.append(remark)
        return ""

    monkeypatch.setattr("groundslab.views.report.html.render_report", render_report)
    solved = Solved("", results_of(synthetic.results()), {}, "")
    for kind in ("report", OUTDATED):
        WRITERS[kind](solved, "pad.toml", lambda *_: None)
    assert remarks[0] == ""
    assert remarks[1].startswith("pad.toml has changed since this analysis.")


@pytest.mark.slow
def test_results_of_a_run(bench: Bench) -> None:
    """Opened, the case is solved; scene and summary can be had; a run that is not kept is not found."""
    run = bench.hub.wait("solved")["run"]
    answer = bench.ask("GET", f"/api/results/{run}/scene")
    assert answer.headers["content-type"] == "application/octet-stream"
    assert answer.content == CASE.encode() * 1000
    assert bench.get(f"/api/results/{run}/summary") == {"text": CASE}
    assert bench.get("/api/results/99/summary", 404)["error"]["message"]
    assert bench.get("/api/results/99/preview", 404)["error"]["message"]
    assert bench.post("/api/shown", {"combination": "ULS 1"}) == {}
    assert bench.solver.shown == "ULS 1"
    bench.post("/api/shown", {"combination": 1}, 422)
    assert bench.get("/api/results/99/report", 422)["error"]["found"]
    assert bench.get(f"/api/results/{run}/tables") == ["words"]
    assert bench.get(f"/api/results/{run}/tables/words")["title"] == CASE
    for path in (f"/api/results/{run}/tables/other", "/api/results/99/tables/words", "/api/results/99/tables"):
        assert bench.get(path, 404)["error"]["message"]
    assert bench.post("/api/results/99/comparison", status=404)["error"]["message"]
    assert bench.post("/api/comparison/cancel") == {}
    assert bench.get("/api/results/99/archive", 422)["error"]["location"] == "the archive"


@pytest.mark.slow
def test_solving_only_when_asked_to(bench: Bench) -> None:
    """With autosolve off a change is not solved until it is asked for; on again, it is solved at once."""
    bench.hub.wait("solved")
    bench.post("/api/autosolve", {"on": False})
    assert bench.get("/api/state")["autosolve"] is False
    version = bench.set(["plate", "nu"], 0.1)["version"]
    assert bench.solver.schedule.current is None
    run = bench.post("/api/solve")["run"]
    assert bench.hub.wait("solved", run=run)["version"] == version
    version = bench.set(["plate", "nu"], 0.15)["version"]
    bench.post("/api/autosolve", {"on": True})
    bench.hub.wait("solved", version=version)
    assert bench.post("/api/cancel") == {}


def test_saving(bench: Bench, case: Path) -> None:
    """A save writes the text as it is, announces it, and removes the unsaved work."""
    bench.set(["plate", "thickness"], "300 mm")
    kept = case.with_name(".raft.toml.unsaved")
    assert kept.read_text(encoding="utf-8").endswith(CASE.replace("250 mm", "300 mm"))
    state = bench.post("/api/save")
    assert state["dirty"] is False
    assert case.read_text(encoding="utf-8") == CASE.replace("250 mm", "300 mm")
    assert not kept.exists()
    assert bench.hub.wait("saved") == {"file": str(case)}
    # undone after the save, it differs from the file again, and is kept again
    assert bench.post("/api/undo")["dirty"] is True
    assert kept.exists()


def test_a_file_changed_by_others_is_not_overwritten(bench: Bench, case: Path) -> None:
    """Another program's change is noticed, reported, and overwritten only if the user says so."""
    bench.set(["plate", "thickness"], "300 mm")
    case.write_text(CASE + "# by others\n", encoding="utf-8")
    assert bench.get("/api/state")["outside"] is True
    error = bench.post("/api/save", status=409)["error"]
    assert error["kind"] == "changed"
    assert "another program" in error["found"]
    assert case.read_text(encoding="utf-8").endswith("# by others\n")
    assert case.with_name(".raft.toml.unsaved").exists()
    assert bench.post("/api/save", {"over": True})["outside"] is False
    assert case.read_text(encoding="utf-8") == CASE.replace("250 mm", "300 mm")
    case.unlink()
    assert bench.get("/api/state")["outside"] is True
    bench.post("/api/save")
    assert case.exists()


def test_a_file_touched_by_others_is_not_changed(bench: Bench, case: Path) -> None:
    """A file with a newer time but the same content is no reason to ask."""
    os.utime(case, (1, 1))
    assert bench.get("/api/state")["outside"] is False
    bench.set(["plate", "nu"], 0.3)
    bench.post("/api/save")


def test_saving_elsewhere(bench: Bench, case: Path) -> None:
    """Another name: what is there is not overwritten unasked; later saves go there; only case files are written."""
    other = case.with_name("other.toml")
    other.write_text("precious", encoding="utf-8")
    bench.set(["plate", "nu"], 0.3)
    assert bench.post("/api/save", {"file": "other"}, 409)["error"]["kind"] == "exists"
    assert other.read_text(encoding="utf-8") == "precious"
    for name in ("case.py", "x.bashrc", "", "a\0b.toml", "none/case.toml"):
        bench.post("/api/save", {"file": name}, 422)
    (case.parent / "folder.toml").mkdir()
    bench.post("/api/save", {"file": "folder.toml"}, 422)
    state = bench.post("/api/save", {"file": "other.toml", "over": True})
    assert (state["file"], state["dirty"]) == (str(other), False)
    assert case.read_text(encoding="utf-8") == CASE
    assert not case.with_name(".raft.toml.unsaved").exists()
    bench.set(["plate", "nu"], 0.35)
    bench.post("/api/save")
    assert "0.35" in other.read_text(encoding="utf-8")


def test_a_full_disk(bench: Bench, case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nothing can be written the edit still counts, and the page learns that it is neither kept nor saved."""

    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(atomic, "write", full)
        state = bench.set(["plate", "nu"], 0.3)
        assert "no space left" in state["unkept"]
        assert "no space left" in bench.post("/api/save", status=422)["error"]["found"]
    assert case.read_text(encoding="utf-8") == CASE
    assert bench.set(["plate", "nu"], 0.31)["unkept"] == ""


def test_a_new_document(bench: Bench, case: Path, tmp_path: Path) -> None:
    """A new one starts with the commented case; it has no file until it is saved under a name."""
    state = bench.post("/api/new")
    assert (state["text"], state["file"], state["dirty"]) == (casefile.starter(), None, False)
    assert bench.post("/api/save", status=422)["error"]["location"] == "file"
    bench.set(["title"], "mine")
    assert len(list((tmp_path / "state" / "unsaved").glob("*.unsaved"))) == 1
    state = bench.post("/api/save", {"file": str(case.parent / "mine")})
    assert state["file"] == str(case.parent / "mine.toml")
    assert list((tmp_path / "state" / "unsaved").iterdir()) == []


def test_the_matrix_of_a_building_is_read_beside_the_case(bench: Bench, case: Path, tmp_path: Path) -> None:
    """From the folder of the case, also of one it is saved to; what is solved has it in its text, comments too."""
    columns = "".join(f'[[columns]]\nname = "{name}"\nx = "{x} m"\ny = "0 m"\ndiameter = "0.3 m"\n'
                      for name, x in (("A", -1), ("B", 0), ("C", 1)))  # fmt: skip
    text = CASE + columns + '[building] # above\nunit = "kN"\nfile = "frame.csv"\n'
    (case.parent / "frame.csv").write_text("A,B,C\n1,-2,1\n-2,4,-2\n1,-2,1\n", encoding="utf-8")
    bench.post("/api/edits", {"edits": [{"op": "text", "value": text}], "text": "a building"})
    revision = bench.session.editor.revision
    assert revision.result is not None
    assert revision.result.issues == ()
    assert casefile.loads(revision.text).building is not None
    assert "[building] # above\n" in revision.text
    assert bench.get("/api/state")["text"] == text
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    bench.post("/api/save", {"file": str(elsewhere / "raft.toml")})
    (issue,) = bench.get("/api/state")["issues"]
    assert issue["location"] == "building.file"


def test_opening_another_file_loses_nothing(bench: Bench, case: Path) -> None:
    """Unsaved work stays kept when another file is opened, and is offered when one comes back."""
    other = case.with_name("other.toml")
    other.write_bytes(b"\xef\xbb\xbf" + CASE.replace("\n", "\r\n").encode())
    bench.set(["plate", "thickness"], "300 mm")
    state = bench.post("/api/open", {"file": "other.toml"})
    assert (state["text"], state["can_undo"], state["offer"]) == (CASE, False, None)
    offer = bench.post("/api/open", {"file": str(case)})["offer"]
    assert (offer["file"], offer["changed"]) == (str(case), False)
    state = bench.post("/api/restore", {"take": True})
    assert "300 mm" in state["text"]
    assert (state["offer"], state["dirty"], state["undo_text"]) == (None, True, "Restore unsaved work")
    assert len(list(case.parent.glob(".raft.toml.unsaved*"))) == 1
    assert bench.post("/api/undo")["text"] == CASE
    for name in ("none.toml", "..", "none/none.toml"):
        bench.post("/api/open", {"file": name}, 422)
    assert bench.get("/api/state")["file"] == str(case)


def test_work_that_is_not_wanted(bench: Bench, case: Path) -> None:
    """Declined work is offered no more; edits made before the answer do not overwrite it."""
    bench.set(["plate", "thickness"], "300 mm")
    bench.post("/api/open", {"file": str(case)})
    bench.set(["plate", "thickness"], "310 mm")
    state = bench.post("/api/restore", {"take": False})
    assert state["offer"] is None
    assert "310 mm" in state["text"]
    declined = case.with_name(".raft.toml.unsaved-declined")
    assert "300 mm" in declined.read_text(encoding="utf-8")
    assert bench.post("/api/restore", {"take": True})["text"] == state["text"], "nothing is offered"


def test_what_is_written_right_after_a_save_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another program writes before the server has looked at the file it has just saved."""
    path = tmp_path / "slab.toml"
    write = atomic.write

    def write_and_lose(target: Path, content: bytes) -> None:
        write(target, content)
        target.write_bytes(b"theirs")

    file = locks.CaseFile(path, None)
    assert not file.has_changed()  # it is not there yet, as when it was opened
    monkeypatch.setattr(atomic, "write", write_and_lose)
    file.save(path, b"mine", overwrite=False, lock=lambda _: pytest.fail("it is locked"))
    assert file.has_changed()
    file.adopt(b"theirs")
    assert not file.has_changed()
    path.unlink()
    assert file.has_changed()


def test_restored_work_on_a_file_that_has_changed_since(bench: Bench, case: Path) -> None:
    """Work that builds on an older file is offered as such, and does not overwrite the newer one unasked."""
    bench.set(["plate", "thickness"], "300 mm")
    bench.post("/api/new")
    case.write_text(CASE + "# newer\n", encoding="utf-8")
    assert bench.post("/api/open", {"file": str(case)})["offer"]["changed"] is True
    bench.post("/api/restore", {"take": True})
    assert bench.post("/api/save", status=409)["error"]["kind"] == "changed"
    assert case.read_text(encoding="utf-8").endswith("# newer\n")


def test_kept_work_whose_file_is_gone(bench: Bench, case: Path) -> None:
    """The work is opened in the file's place."""
    bench.set(["plate", "thickness"], "300 mm")
    bench.post("/api/new")
    case.unlink()
    state = bench.post("/api/open", {"file": str(case)})
    assert "300 mm" in state["text"]
    assert (state["dirty"], state["file"]) == (True, str(case))
    bench.post("/api/save")
    assert "300 mm" in case.read_text(encoding="utf-8")


def test_work_that_was_saved_in_the_end_is_not_offered(bench: Bench, case: Path) -> None:
    """Kept work that says what the file says is removed."""
    bench.set(["plate", "thickness"], "300 mm")
    bench.post("/api/new")
    case.write_text(CASE.replace("250 mm", "300 mm"), encoding="utf-8")
    assert bench.post("/api/open", {"file": str(case)})["offer"] is None
    assert list(case.parent.glob(".*")) == []


def test_a_file_that_is_open_elsewhere(bench: Bench, case: Path, static: Path, tmp_path: Path) -> None:
    """A second workbench gets the address of the first, for opening as for saving; the first one's end frees it."""
    other = Bench(tmp_path / "state", static)
    error = other.post("/api/open", {"file": str(case)}, 409)["error"]
    assert (error["kind"], error["url"]) == ("open", f"http://{HOST}/?token={TOKEN}")
    assert other.post("/api/save", {"file": str(case), "over": True}, 409)["error"]["kind"] == "open"
    assert case.read_text(encoding="utf-8") == CASE
    bench.post("/api/new")
    assert other.post("/api/open", {"file": str(case)})["file"] == str(case)
    other.close()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no named pipes")
def test_only_regular_files_are_read(bench: Bench, case: Path, tmp_path: Path) -> None:
    """A pipe without a writer, a socket, a device, links to nowhere, in a circle: refused at once, never waited for."""
    folder = case.parent
    os.mkfifo(folder / "pipe.toml")
    (folder / "link.toml").symlink_to(folder / "pipe.toml")
    (folder / "dangling.toml").symlink_to(tmp_path / "none" / "none.toml")
    (folder / "circle.toml").symlink_to(folder / "circle.toml")
    names = ["pipe.toml", "link.toml", "dangling.toml", "circle.toml"]
    with socket.socket(socket.AF_UNIX) as end, pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)  # the names of sockets are short
        end.bind("socket.toml")
        for name in (*names, "socket.toml"):
            assert bench.post("/api/open", {"file": name}, 422)["error"]["found"]
            assert bench.post("/api/save", {"file": name, "over": True}, 422)["error"]["found"]
            assert (folder / name).is_symlink() or not (folder / name).is_file()
    assert "a pipe" in bench.post("/api/open", {"file": "pipe.toml"}, 422)["error"]["found"]
    assert "a pipe" in bench.post("/api/open", {"file": os.devnull}, 422)["error"]["found"]
    assert bench.get("/api/files")["files"] == ["raft.toml"]
    # work kept under such a name is none, and the file itself may become one
    os.mkfifo(folder / ".raft.toml.unsaved")
    assert bench.post("/api/open", {"file": "raft.toml"})["offer"] is None
    bench.set(["plate", "nu"], 0.3)
    case.unlink()
    os.mkfifo(case)
    assert bench.get("/api/state")["outside"] is True
    assert "a pipe" in bench.post("/api/save", {"over": True}, 422)["error"]["found"]


@pytest.mark.slow
def test_names_that_no_file_can_have(bench: Bench) -> None:
    """Too long, folders, zero characters, halves of letters: a refusal in words for opening, saving and listing."""
    for name in ("x" * 300, "x" * 300 + ".toml", "a/" * 3000, "/", ".", "..", "a\0b", "\ud800", "~none/x"):
        for path in ("/api/open", "/api/save"):
            error = bench.post(path, {"file": name}, 422)["error"]
            assert error.get("found") or error["message"]
        if name.isascii() and "\0" not in name and not name.startswith((".", "/")):
            bench.get(f"/api/files?folder={name}", 422)
        assert bench.get("/api/state")["text"] == CASE


def test_folders_that_cannot_be_used(bench: Bench, case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder that cannot be read or locked in is reported; a name that is not text is left out of a list."""
    odd = os.fsencode(case.parent) + b"/\xff.toml"
    with suppress(OSError):  # of a system whose names are all text
        os.close(os.open(odd, os.O_CREAT | os.O_WRONLY))
    assert bench.get("/api/files")["files"] == ["raft.toml"]

    def denied(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", str(case))

    for place, name in ((os, "scandir"), (files, "list_folder"), (Path, "is_dir")):
        with monkeypatch.context() as patch:
            patch.setattr(place, name, denied)
            assert bench.ask("GET", "/api/files").status == (200 if place is Path else 422)
    with monkeypatch.context() as patch:
        patch.setattr(locks.Lock, "acquire", denied)
        assert "permission denied" in bench.post("/api/save", {"file": "other.toml"}, 422)["error"]["found"]


def test_listing(bench: Bench, case: Path) -> None:
    """By default the folder of the case; others relative to it; one that does not exist is an error."""
    assert bench.get("/api/files")["files"] == ["raft.toml"]
    assert bench.get("/api/files?folder=..")["folder"] == str(case.parent.parent)
    bench.get("/api/files?folder=none", 422)


def test_an_error_of_the_program_is_an_issue(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    """A bug in reading the model does not end the session: it is reported, the text can be edited and saved."""

    def broken(*_: object) -> None:
        raise ZeroDivisionError("by zero")

    with monkeypatch.context() as patch:
        patch.setattr(parsing.casefile, "from_table", broken)
        state = bench.set(["plate", "nu"], 0.3)
        assert "ZeroDivisionError" in state["issues"][0]["found"]
        assert "line" not in state["issues"][0]
        bench.post("/api/save")
    assert bench.set(["plate", "nu"], 0.31)["issues"] == []


def test_data_that_json_lacks(bench: Bench) -> None:
    """Dates, infinities and numbers that are none come as texts."""
    text = CASE.replace("nu = 0.2", "nu = nan\nwhen = 1979-05-27\ninfinite = [inf]")
    state = bench.post("/api/edits", {"edits": [{"op": "text", "value": text}]})
    assert state["data"]["plate"] | {"nu": "nan", "when": "1979-05-27", "infinite": ["inf"]} == state["data"]["plate"]


def test_closing_returns_where_the_work_is(tmp_path: Path, static: Path, case: Path) -> None:
    """At the end unsaved work stays on the disk, its path is returned, and the case is free again."""
    bench = Bench(tmp_path / "state", static, case)
    bench.set(["plate", "nu"], 0.3)
    assert bench.close() == str(case.with_name(".raft.toml.unsaved"))
    again = Bench(tmp_path / "state", static, case)
    assert again.get("/api/state")["offer"]["kept"] == str(case.with_name(".raft.toml.unsaved"))
    again.post("/api/restore", {"take": True})
    again.post("/api/undo")
    assert again.close() == ""


def test_events_are_sent_to_all_in_order() -> None:
    """Each page gets the present state first, then every event, comments in between, and the end."""

    async def run() -> tuple[list[bytes], list[bytes]]:
        hub = Hub()

        async def page() -> list[bytes]:
            received = []
            async for piece in hub.listen(lambda: [("state", {"version": 1})], keep_alive=0.01):
                received.append(piece)
                if piece.startswith(b":"):
                    waiting.set()
            return received

        waiting = asyncio.Event()
        pages = [asyncio.create_task(page()) for _ in range(2)]
        await waiting.wait()
        await asyncio.to_thread(hub.publish, "progress", {"run": 1, "text": "a\nb"})
        await asyncio.to_thread(hub.close)
        first, second = await asyncio.gather(*pages)
        assert [piece async for piece in hub.listen(list)] == []
        return first, second

    for received in asgi.run(run()):
        assert received[0] == b'event: state\ndata: {"version": 1}\n\n'
        assert b": here\n\n" in received or len(received) == 2
        assert received[-1] == b'event: progress\ndata: {"run": 1, "text": "a\\nb"}\n\n'


def test_a_page_that_falls_behind_is_disconnected(monkeypatch: pytest.MonkeyPatch) -> None:
    """Too many events waiting end the stream; nothing piles up."""
    monkeypatch.setattr(events, "MAX_QUEUE", 3)

    async def run() -> int:
        hub = Hub()
        stream = hub.listen(lambda: [("state", {})])
        await anext(stream)
        for number in range(10):
            hub.publish("progress", {"run": number})
        return len([piece async for piece in stream])

    assert asgi.run(run()) == 3


def test_a_case_that_is_none(tmp_path: Path, static: Path) -> None:
    """A file that does not exist is an error, and the session goes on without it."""
    bench = Bench(tmp_path / "state", static)
    with pytest.raises(InputError, match="no file of that name"):
        bench.session.open(str(tmp_path / "none.toml"))
    assert bench.get("/api/state")["file"] is None
    bench.close()


def test_a_file_changed_by_others_is_compared_and_taken(bench: Bench, case: Path) -> None:
    """Theirs, mine, or both merged: each a step of undo that leaves nothing to ask when it is saved."""
    bench.set(["plate", "thickness"], "300 mm")
    mine = CASE.replace("250 mm", "300 mm")
    theirs, both = CASE.replace("20 MPa/m", "30 MPa/m"), mine.replace("20 MPa/m", "30 MPa/m")
    for which, expected in (("theirs", theirs), ("mine", mine), ("merged", both)):
        case.write_text(theirs, encoding="utf-8")
        assert bench.get("/api/file") == {"outside": True}
        compared = bench.get("/api/file/changes")
        assert '+k = "30 MPa/m"' in compared["lines"]
        assert compared["merged"] == both
        state = bench.post("/api/file", {"which": which, "digest": compared["digest"]})
        assert (state["text"], state["outside"], state["dirty"]) == (expected, False, expected != theirs)
        assert bench.post("/api/save")["dirty"] is False
        assert case.read_text(encoding="utf-8") == expected
        case.write_text(CASE, encoding="utf-8")
        bench.post("/api/file", {"which": "theirs", "digest": bench.get("/api/file/changes")["digest"]})
        bench.set(["plate", "thickness"], "300 mm")
    assert bench.post("/api/undo")["text"] == CASE


def test_an_edit_while_texts_are_merged_is_kept(bench: Bench, case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What was merged is of an earlier text then, and not taken."""
    case.write_text(CASE.replace("20 MPa/m", "30 MPa/m"), encoding="utf-8")
    digest = bench.get("/api/file/changes")["digest"]
    checker = bench.session.editor.checker
    compare = checker.compare

    def edit_meanwhile(base: str | None, mine: str, theirs: str) -> Any:
        compared = compare(base, mine, theirs)
        bench.set(["plate", "thickness"], "777 mm")
        return compared

    monkeypatch.setattr(checker, "compare", edit_meanwhile)
    assert bench.post("/api/file", {"which": "merged", "digest": digest}, 409)["error"]["kind"] == "changed"
    assert "777 mm" in bench.get("/api/state")["text"]


def test_a_file_that_changes_again_is_not_taken(bench: Bench, case: Path) -> None:
    """What was not seen is neither taken nor overwritten; what both changed, or is gone, is not merged."""
    bench.set(["ground", "k"], "40 MPa/m")
    case.write_text(CASE.replace("20 MPa/m", "30 MPa/m"), encoding="utf-8")
    compared = bench.get("/api/file/changes")
    assert compared["merged"] is None
    take = {"digest": compared["digest"]}
    assert bench.post("/api/file", {"which": "merged", **take}, 409)["error"]["kind"] == "changed"
    case.write_text(CASE.replace("20 MPa/m", "50 MPa/m"), encoding="utf-8")
    assert bench.post("/api/file", {"which": "mine", **take}, 409)["error"]["kind"] == "changed"
    assert "40 MPa/m" in bench.get("/api/state")["text"]
    case.unlink()
    bench.get("/api/file/changes", 422)


def test_work_that_was_left_for_something_new_is_not_offered(bench: Bench, tmp_path: Path) -> None:
    """Neither at once nor at the next start; it stays in the folder of unsaved work, as what is declined does."""
    bench.post("/api/new")
    bench.set(["title"], "left")
    assert bench.post("/api/new")["offer"] is None
    (kept,) = (tmp_path / "state" / "unsaved").iterdir()
    assert kept.name == "untitled.unsaved-declined"
    assert 'title = "left"' in kept.read_text(encoding="utf-8")


def test_pages_learn_that_another_document_was_opened(bench: Bench) -> None:
    """Before anything of it is solved, so that no results of the one before stay."""
    bench.hub.events.clear()
    bench.post("/api/new")
    names = [name for name, _ in bench.hub.events]
    assert names.index("opened") < names.index("state")


def test_costs_are_told_before_a_run(bench: Bench) -> None:
    """By the accuracy; the choice of one is solved for without a word in the text, and ends with the document."""
    bench.post("/api/autosolve", {"on": False})
    costs = bench.get("/api/cost")
    assert set(costs) == {"", "draft", "normal", "strict"}
    assert costs[""] == costs["normal"]
    assert costs["draft"]["unknowns"] < costs["strict"]["unknowns"]
    assert costs["draft"]["seconds"] < costs["strict"]["seconds"]
    text = bench.get("/api/state")["text"]
    bench.post("/api/accuracy", {"accuracy": "draft"})
    state = bench.get("/api/state")
    assert (state["accuracy"], state["text"]) == ("draft", text)
    run = bench.post("/api/solve")["run"]
    bench.hub.wait("solved", run=run)
    bench.post("/api/accuracy", {"accuracy": "exact"}, 422)
    assert bench.post("/api/new")["accuracy"] == ""
    bench.set(["plate", "thickness"], "none")
    assert bench.get("/api/cost") == {}
