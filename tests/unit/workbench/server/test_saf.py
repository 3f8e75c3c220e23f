"""SAF files in the workbench: their slabs, the case made of one, and other workbooks."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.workbench.events import Hub
from helpers import asgi, saf_files, workers

pytest.importorskip("fastapi")
pytest.importorskip("openpyxl")
from groundslab.workbench.checking.saf import SafReader
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.session import Session
from groundslab.workbench.server.tickets import Tickets
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
GOOD = [("host", f"127.0.0.1:{PORT}"), ("x-groundslab-token", TOKEN), ("content-type", "application/json")]

pytestmark = pytest.mark.slow


class Bench:
    """A session and a client that has the token."""

    def __init__(self, folder: Path) -> None:
        hub = Hub()
        self.session = Session(hub, Solver(hub.publish, workers.obey, None), folder / "state", "", workers.Inline())
        self.app = create_app(self.session, Tickets(), PORT, TOKEN, folder)

    def slabs(self, path: Path, status: int = 200) -> Any:
        """Return the slabs of a file."""
        answer = asgi.ask(self.app, "GET", f"/api/saf?file={quote(str(path))}", GOOD)
        assert answer.status == status, answer.text
        return answer.json()

    def open(self, path: Path, slab: str, status: int = 200) -> Any:
        """Return the answer to opening a slab."""
        content = json.dumps({"file": str(path), "slab": slab}).encode()
        answer = asgi.ask(self.app, "POST", "/api/saf", [*GOOD, ("content-length", str(len(content)))], content)
        assert answer.status == status, answer.text
        return answer.json()


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    """A session that is closed afterwards."""
    made = Bench(tmp_path)
    yield made
    made.session.close()


def test_the_slabs_of_a_house(bench: Bench, tmp_path: Path) -> None:
    """The one on ground comes first, then the others by their heights, with their extent."""
    found = bench.slabs(saf_files.write(tmp_path / "house.xlsx", saf_files.house()))["slabs"]
    assert [(slab["name"], slab["height"], slab["on_ground"]) for slab in found] == [
        ("S6", 0, True),
        ("S5", 3.6, False),
        ("S7", 7.2, False),
    ]
    assert found[0]["sides"] == [5, 12]


def test_a_slab_becomes_the_document(bench: Bench, tmp_path: Path) -> None:
    """With the report of what was taken and left; it is unsaved, and the same as from the command line."""
    path = saf_files.write(tmp_path / "house.xlsx", saf_files.house())
    answer = bench.open(path, "S6")
    assert "StructuralSurfaceMember S6: plate" in answer["report"]
    assert casefile.loads(answer["state"]["text"]) == gs.read_saf(path).model
    assert (answer["state"]["file"], answer["state"]["dirty"]) == (None, True)


def test_what_is_wrong_is_said(bench: Bench, tmp_path: Path) -> None:
    """An unknown slab, and a row that cannot be read; the document stays."""
    sheets = saf_files.house()
    path = saf_files.write(tmp_path / "house.xlsx", sheets)
    before = bench.session.editor.revision.document.text
    assert "S5 at 3.6 m" in json.dumps(bench.open(path, "S99", 422))
    sheets["StructuralSurfaceConnection"][1][7] = "much"
    assert "much" in json.dumps(bench.open(saf_files.write(tmp_path / "wrong.xlsx", sheets), "S6", 422))
    assert bench.session.editor.revision.document.text == before


def test_other_workbooks_have_no_slabs(bench: Bench, tmp_path: Path) -> None:
    """So a table of reactions is taken as one; what is no workbook is refused."""
    table = [["Joint", "Case", "FZ [kN]"], ["A", "G", 100]]
    assert bench.slabs(saf_files.write(tmp_path / "table.xlsx", {"Sheet1": table})) == {"slabs": []}
    (tmp_path / "text.xlsx").write_text("no workbook")
    bench.slabs(tmp_path / "text.xlsx", 422)


@pytest.mark.skipif(os.name != "posix", reason="memory is not limited here")
def test_reading_is_limited(tmp_path: Path) -> None:
    """A file that takes longer than it may is refused."""
    path = saf_files.write(tmp_path / "house.xlsx", saf_files.house())
    with pytest.raises(InputError, match=r"a workbook that takes longer than 0.001 s to read"):
        SafReader(seconds=0.001).survey(path)
