"""Files that the server makes of results and of the case as it stands."""

from __future__ import annotations

import io
import json
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlencode

import pytest

import groundslab as gs
from groundslab.workbench.events import Hub
from helpers import asgi, workers
from helpers.small_case import TEXT

pytest.importorskip("fastapi")
pytest.importorskip("openpyxl")
from groundslab.workbench.exports.case_writer import NO_RESULTS
from groundslab.workbench.exports.files import Exported, Wanted
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.server.view import ResultsView, create_view_app
from groundslab.workbench.solver.process import solve
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
HOST = ("host", f"127.0.0.1:{PORT}")
GOOD = [HOST, ("x-groundslab-token", TOKEN)]
PATIENCE = 120.0

pytestmark = pytest.mark.slow


class Bench:
    """A session that solves, and a client that has the token."""

    def __init__(self, folder: Path, text: str = TEXT) -> None:
        hub = Hub()
        self.folder = folder
        self.solved = threading.Event()

        def publish(name: str, data: dict[str, object]) -> None:
            hub.publish(name, data)
            if name in ("solved", "refused"):
                self.solved.set()

        self.session = Session(hub, Solver(publish, solve, None), folder / "state", "", workers.Inline())
        self.app = create_app(self.session, Tickets(), PORT, TOKEN, folder)
        (folder / "slab.toml").write_text(text, encoding="utf-8")
        self.session.open(str(folder / "slab.toml"))

    def wait(self) -> int:
        """Return the run when it is solved."""
        assert self.solved.wait(PATIENCE)
        latest = self.session.analyses.solver.schedule.results.latest
        assert latest is not None
        return latest.run

    def get(self, path: str, status: int = 200, **query: str) -> asgi.Answer:
        """Return an answer."""
        answer = asgi.ask(self.app, "GET", f"/api/{path}?{urlencode(query)}", GOOD)
        assert answer.status == status, answer.text
        return answer


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    """A workbench with a small case, which is being solved."""
    made = Bench(tmp_path)
    yield made
    made.session.close()


@pytest.fixture(scope="module")
def solved_bench(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bench]:
    """A workbench with a small case that is solved, whose document stays as it is."""
    made = Bench(tmp_path_factory.mktemp("solved"))
    made.wait()
    yield made
    made.session.close()


@pytest.fixture(scope="module")
def kept(solved_bench: Bench) -> Path:
    """The results of that case in a folder."""
    return gs.save_results(gs.solve(gs.load(solved_bench.folder / "slab.toml")), solved_bench.folder / "slab")


def notes_of(answer: asgi.Answer) -> list[str]:
    """Return what an answer says of its file."""
    notes = json.loads(unquote(answer.headers["x-groundslab-notes"]))
    assert isinstance(notes, list)
    return notes


def head_of(answer: asgi.Answer) -> Any:
    """Return the head of a packed scene."""
    content = answer.content
    return json.loads(content[4 : 4 + int.from_bytes(content[:4], "little")])


def test_saf_has_the_results_of_the_case_as_it_stands(bench: Bench, tmp_path: Path) -> None:
    """Solved, it has section forces; changed, it has no results and says so; undone, it has them again."""
    run = bench.wait()
    answer = bench.get("saf")
    assert answer.headers["content-disposition"].endswith("slab-saf.xlsx")
    (tmp_path / "solved.xlsx").write_bytes(answer.content)
    assert NO_RESULTS not in notes_of(answer)
    assert any(note.startswith("section forces along edges") for note in notes_of(answer))
    bench.session.analyses.set_autosolve(False)
    bench.session.editor.edit([{"op": "set", "path": ["plate", "thickness"], "value": "400 mm"}], "", None)
    answer = bench.get("saf")
    assert notes_of(answer)[0] == NO_RESULTS
    (tmp_path / "changed.xlsx").write_bytes(answer.content)
    thickness = [gs.read_saf(tmp_path / f"{name}.xlsx").model.plate.thickness for name in ("solved", "changed")]
    assert thickness == [0.25, 0.4]
    bench.session.editor.undo()
    assert NO_RESULTS not in notes_of(bench.get("saf"))
    assert bench.wait() == run


def test_a_case_with_errors_has_no_file(bench: Bench) -> None:
    """What is wrong with it is said, as where it is solved."""
    bench.session.editor.edit([{"op": "set", "path": ["plate", "thickness"], "value": "-1 mm"}], "", None)
    assert "thickness" in json.dumps(bench.get("saf", 422).json())


def test_files_of_a_run(solved_bench: Bench) -> None:
    """They have names; what cannot be made is explained, and so are runs that are not kept and names of no file."""
    run = solved_bench.wait()
    plan = solved_bench.get(f"results/{run}/exports/plan.dxf", field="pressure")
    assert plan.headers["content-disposition"].endswith("slab-pressure.dxf")
    assert b"drawn by groundslab" in plan.content[:100_000]
    assert notes_of(plan) == []
    assert solved_bench.get(f"results/{run}/exports/tables.xlsx").content.startswith(b"PK")
    assert "bottom_x" in solved_bench.get(f"results/{run}/exports/bars.dxf", 422).json()["error"]["hint"]
    assert (
        "one of" in solved_bench.get(f"results/{run}/exports/plan.pdf", 422, field="colour").json()["error"]["expected"]
    )
    assert solved_bench.get("results/99/exports/plan.pdf", 422).json()["error"]["location"] == "the export"
    for name in ("plan.exe", "..%2fslab.toml", "saf.dxf"):
        solved_bench.get(f"results/{run}/exports/{name}", 422)
    solved_bench.get(f"results/{run}/exports/plan.dxf", 422, field="w" * 1001)


def test_requests_of_others_are_refused(solved_bench: Bench) -> None:
    """Without the token, under another host, or from another page nothing is made."""
    for path in ("/api/saf", "/api/results/1/exports/plan.dxf", "/api/slabs?file=x.ifc"):
        for headers in ([HOST], [("host", "other"), GOOD[1]], [*GOOD, ("origin", "http://other")]):
            assert asgi.ask(solved_bench.app, "GET", path, headers).status == 403, (path, headers)


def test_the_server_answers_while_a_file_is_made(solved_bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    """Making one waits in a thread; the state is answered meanwhile."""
    run, begun, go_on = solved_bench.wait(), threading.Event(), threading.Event()

    def make_view(_: object) -> bytes:
        begun.set()
        assert go_on.wait(PATIENCE)
        return Exported(b"made").to_bytes()

    monkeypatch.setattr(solved_bench.session.analyses.solver, "make_view", make_view)
    answers: list[asgi.Answer] = []
    path = f"results/{run}/exports/plan.dxf"
    waiting = threading.Thread(target=lambda: answers.append(solved_bench.get(path)))
    waiting.start()
    assert begun.wait(PATIENCE)
    assert solved_bench.get("state").json()["version"]
    assert answers == []
    go_on.set()
    waiting.join()
    assert answers[0].content == b"made"


def _layers_of(content: bytes) -> set[str]:
    """Return the layers of a drawing on which something is drawn."""
    ezdxf = pytest.importorskip("ezdxf")
    return {entity.dxf.layer for entity in ezdxf.read(io.StringIO(content.decode())).modelspace()}


def test_results_that_are_looked_at_give_the_same_files(solved_bench: Bench, kept: Path, tmp_path: Path) -> None:
    """A plan of a kept folder is that of the command, with the workbench's layers; other runs are refused."""
    app = create_view_app(ResultsView.read(kept), Tickets(), PORT, TOKEN, tmp_path)
    run = solved_bench.wait()
    name = "exports/plan.dxf?field=settlement"
    looked_at = asgi.ask(app, "GET", f"/api/results/1/{name}", GOOD)
    made = asgi.ask(solved_bench.app, "GET", f"/api/results/{run}/{name}", GOOD)
    assert (looked_at.status, made.status) == (200, 200)
    # that of the folder to the last byte; another run differs by rounding, which moves contours
    gs.load_results(kept).plot("settlement", to=tmp_path / "plan.dxf")
    assert looked_at.content == (tmp_path / "plan.dxf").read_bytes()
    assert _layers_of(looked_at.content) == _layers_of(made.content)
    assert asgi.ask(app, "GET", "/api/results/1/exports/saf.xlsx", GOOD).content.startswith(b"PK")
    assert asgi.ask(app, "GET", f"/api/results/2/{name}", GOOD).status == 422


def test_the_report_as_pdf(solved_bench: Bench) -> None:
    """It is typeset, as by the command."""
    answer = solved_bench.get(f"results/{solved_bench.wait()}/exports/report.pdf")
    assert answer.headers["content-disposition"].endswith("slab-report.pdf")
    assert answer.content.startswith(b"%PDF-")


def test_a_difference_to_a_combination_and_to_a_reference(bench: Bench) -> None:
    """The same run minus itself is zero everywhere; it is drawn as a plan; what is not kept cannot be subtracted."""
    run = bench.wait()
    assert bench.get(f"results/{run}/difference", 422, reference=str(run)).text.find("not kept any more") > 0
    headers = [*GOOD, ("content-type", "application/json"), ("content-length", "2")]
    assert asgi.ask(bench.app, "POST", f"/api/results/{run}/reference", headers, b"{}").status == 200
    head = head_of(bench.get(f"results/{run}/difference", reference=str(run)))
    (one,) = head["combinations"]
    assert head["difference"] == "reference"
    assert one["minus"] == one["name"]
    assert all(ends["max"][0] == ends["min"][0] == 0 for ends in one["extremes"].values())
    answer = bench.get(f"results/{run}/exports/plan.svg", field="settlement", reference=str(run))
    assert answer.headers["content-disposition"].endswith("slab-settlement-difference.svg")
    assert bench.get(f"results/{run}/difference", 422, minus="wind").text.find("wind") > 0
    bench.session.new()
    with pytest.raises(gs.InputError, match="not kept any more"):
        bench.session.analyses.write_difference(run, Wanted("plan.pdf"), run)


def test_results_that_are_looked_at_have_differences_of_combinations_alone(kept: Path, tmp_path: Path) -> None:
    """The scene is that of the workbench; another run and a reference are refused."""
    view = create_view_app(ResultsView.read(kept), Tickets(), PORT, TOKEN, tmp_path)
    (name,) = gs.load_results(kept).results

    def ask(path: str, **query: str) -> asgi.Answer:
        return asgi.ask(view, "GET", f"/api/results/{path}?{urlencode(query)}", GOOD)

    packed = ask("1/difference", minus=name)
    assert packed.status == 200
    assert head_of(packed)["difference"] == "combination"
    assert ask("2/difference", minus=name).status == 422
    assert ask("1/difference", reference="1").status == 422
