"""Reactions in the workbench: shown before they are taken, in one step of undo."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from groundslab.workbench.events import Hub
from helpers import asgi, workers
from helpers.reactions import BY_HAND, CASE, ETABS, write_case, write_table

pytest.importorskip("fastapi")
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
GOOD = [("host", f"127.0.0.1:{PORT}"), ("x-groundslab-token", TOKEN), ("content-type", "application/json")]

pytestmark = pytest.mark.slow


class Bench:
    """A session with the slab of the helpers, and a client that has the token."""

    def __init__(self, folder: Path) -> None:
        hub = Hub()
        self.session = Session(hub, Solver(hub.publish, workers.obey, None), folder / "state", "", workers.Inline())
        self.app = create_app(self.session, Tickets(), PORT, TOKEN, folder)
        self.session.open(str(write_case(folder)))

    def ask(self, status: int = 200, **body: Any) -> Any:
        """Return the answer about a table."""
        content = json.dumps(body).encode()
        answer = asgi.ask(self.app, "POST", "/api/reactions", [*GOOD, ("content-length", str(len(content)))], content)
        assert answer.status == status, answer.text
        return answer.json()

    @property
    def text(self) -> str:
        """The text of the document."""
        return self.session.editor.revision.document.text

    @property
    def version(self) -> int:
        """The version of the document."""
        return self.session.editor.revision.version


@pytest.fixture
def bench(tmp_path: Path) -> Any:
    """A session that is closed afterwards."""
    made = Bench(tmp_path)
    yield made
    made.session.close()


def test_a_look_changes_nothing_and_taking_is_one_step(bench: Bench, tmp_path: Path) -> None:
    """The changes are those of the command line; undo brings the text back."""
    file = str(write_table(tmp_path, BY_HAND))
    seen = bench.ask(file=file)
    assert seen["changes"][0] == "new: A in G: P 1.8124 MN, M_x 20 kNm, M_y 10 kNm"
    assert seen["sums"][0].startswith("G: P 0 -> 2.3124 MN")
    assert "state" not in seen
    assert bench.text == CASE
    taken = bench.ask(file=file, base=bench.version)
    assert taken["state"]["undo_text"] == "Import reactions"
    assert bench.text.count('source = "A"') == 2
    assert bench.ask(file="reactions.csv")["changes"] == []  # beside the case
    bench.session.editor.undo()
    assert bench.text == CASE


@pytest.mark.usefixtures("reading_here")
def test_choices_reach_the_table(bench: Bench, tmp_path: Path) -> None:
    """What it leaves open is an error with a list, until it is said."""
    file = str(write_table(tmp_path, ETABS.replace(",Q,", ",LIVE,")))
    error = bench.ask(422, file=file)["error"]
    assert len(error["issues"]) == 3
    given = {"new_cases": {"LIVE": "B"}, "supports": {"101": "A", "102": "B"}, "reading": {"positive": "lifts"}}
    seen = bench.ask(file=file, **given)
    assert "new: A in LIVE: P -300 kN" in "\n".join(seen["changes"])
    assert bench.ask(422, file=file, **given | {"reading": {"sign": 1}})["error"]["issues"]
    assert bench.ask(422, file=str(tmp_path / "none.csv"))["error"]["issues"]


def test_an_old_version_is_not_edited(bench: Bench, tmp_path: Path) -> None:
    """Then the answer is the present state."""
    file = str(write_table(tmp_path, BY_HAND))
    old = bench.version
    bench.session.editor.edit([{"op": "set", "path": ["title"], "value": "Mat"}], "Title", None)
    state = bench.ask(409, file=file, base=old)
    assert state["version"] == bench.version
    assert "source" not in bench.text


def test_tables_are_listed_among_files(bench: Bench, tmp_path: Path) -> None:
    """So that they can be chosen."""
    write_table(tmp_path, BY_HAND)
    assert bench.session.list_folder()["tables"] == ["reactions.csv"]
