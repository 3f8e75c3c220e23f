"""Slabs of SAF files and of buildings in the workbench: their lists, the case made of one, and other files."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
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
from groundslab.workbench.server.security import Tickets
from groundslab.workbench.server.session import Session
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
        answer = asgi.ask(self.app, "GET", f"/api/slabs?file={quote(str(path))}", GOOD)
        assert answer.status == status, answer.text
        return answer.json()

    def open(self, path: Path, slab: str, status: int = 200, **place: bool) -> Any:
        """Return the answer to opening a slab."""
        content = json.dumps({"file": str(path), "slab": slab, **place}).encode()
        answer = asgi.ask(self.app, "POST", "/api/slabs", [*GOOD, ("content-length", str(len(content)))], content)
        assert answer.status == status, answer.text
        return answer.json()


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    """A session that is closed afterwards."""
    made = Bench(tmp_path)
    yield made
    made.session.close()


@pytest.mark.usefixtures("reading_here")
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


@pytest.mark.usefixtures("reading_here")
def test_what_is_wrong_is_said(bench: Bench, tmp_path: Path) -> None:
    """An unknown slab, and a row that cannot be read; the document stays."""
    sheets = saf_files.house()
    path = saf_files.write(tmp_path / "house.xlsx", sheets)
    before = bench.session.editor.revision.document.text
    assert "S5 at 3.6 m" in json.dumps(bench.open(path, "S99", 422))
    sheets["StructuralSurfaceConnection"][1][7] = "much"
    assert "much" in json.dumps(bench.open(saf_files.write(tmp_path / "wrong.xlsx", sheets), "S6", 422))
    assert bench.session.editor.revision.document.text == before


@pytest.mark.usefixtures("reading_here")
def test_other_workbooks_have_no_slabs(bench: Bench, tmp_path: Path) -> None:
    """So a table of reactions is taken as one; what is no workbook is refused."""
    table = [["Joint", "Case", "FZ [kN]"], ["A", "G", 100]]
    assert bench.slabs(saf_files.write(tmp_path / "table.xlsx", {"Sheet1": table})) == {"slabs": []}
    (tmp_path / "text.xlsx").write_text("no workbook")
    bench.slabs(tmp_path / "text.xlsx", 422)


@pytest.fixture
def building(tmp_path: Path) -> Path:
    """A house with a raft, two columns and a wall on it, a floor above, and a ramp that is no level slab."""
    pytest.importorskip("ifcopenshell")
    from helpers.ifc_files import Building, turned

    house = Building("mm")
    house.slab("Floor", place=turned(0, z=3.3))
    house.slab("Raft", place=turned(0, x=100, y=50))
    house.slab(
        "Ramp", place=turned(0, x=20) @ np.array([[0.8, 0, 0.6, 0], [0, 1, 0, 0], [-0.6, 0, 0.8, 0], [0, 0, 0, 1]])
    )
    square = house.profile("IfcRectangleProfileDef", XDim=0.4, YDim=0.4)
    for name, x in (("C1", 101), ("C2", 105)):
        house.add("IfcColumn", name, square, 3.0, turned(0, x=x, y=51))
    house.add("IfcColumn", "upstairs", square, 3.0, turned(0, x=1, y=1, z=3.3))
    house.add("IfcWall", "W1", house.profile("IfcRectangleProfileDef", XDim=4, YDim=0.2), 3.0, turned(0, x=103, y=53))
    return house.write(tmp_path / "house.ifc")


@pytest.mark.usefixtures("reading_here")
def test_the_slabs_of_a_building(bench: Bench, building: Path) -> None:
    """Storey, size, columns and walls of each, the lowest first; last the one that cannot be read, with the reason."""
    found = bench.slabs(building)["slabs"]
    counted = [(slab["name"], slab["storey"], slab["columns"], slab["walls"]) for slab in found[:2]]
    assert counted == [("Raft", "Ground floor", 2, 1), ("Floor", "Ground floor", 1, 0)]
    assert [slab["height"] for slab in found[:2]] == pytest.approx([0, 3.3], abs=1e-9)
    assert [side for slab in found[:2] for side in slab["sides"]] == pytest.approx([6, 4, 6, 4])
    assert (found[2]["name"], found[2]["sides"]) == ("Ramp", None)
    assert "tilted" in found[2]["problem"]


def test_a_slab_of_a_building_becomes_the_document(bench: Bench, building: Path) -> None:
    """Chosen by its GlobalId, it is the same as from the command line, where it lies or about its middle."""
    chosen = bench.slabs(building)["slabs"][0]["id"]
    answer = bench.open(building, chosen)
    assert answer["state"]["text"] == gs.read_ifc(building, "Raft").text
    assert "upstairs" in answer["report"]
    assert (answer["state"]["file"], answer["state"]["dirty"]) == (None, True)
    moved = bench.open(building, chosen, centered=True, aligned=True)["state"]["text"]
    assert moved == gs.read_ifc(building, "Raft", origin="center", align=True).text


@pytest.mark.usefixtures("reading_here")
def test_what_is_no_building(bench: Bench, building: Path, tmp_path: Path) -> None:
    """Other files, unknown slabs, and what only buildings allow are refused; the server and its document go on."""
    before = bench.session.editor.revision.document.text
    (tmp_path / "text.ifc").write_text("no building")
    (tmp_path / "half.ifc").write_bytes(building.read_bytes()[:2000])
    for name in ("text.ifc", "half.ifc", "missing.ifc", "house.pdf"):
        bench.slabs(tmp_path / name, 422)
    assert "Raft" in json.dumps(bench.open(building, "Rafft", 422))
    house = saf_files.write(tmp_path / "house.xlsx", saf_files.house())
    assert "its own coordinates" in json.dumps(bench.open(house, "S6", 422, centered=True))
    assert bench.session.editor.revision.document.text == before


def test_a_missing_package_is_named(bench: Bench, building: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The error has the line that installs the extra."""
    (building.parent / "ifcopenshell.py").write_text("raise ImportError('hidden')")
    monkeypatch.syspath_prepend(building.parent)
    assert "pip install groundslab[ifc]" in json.dumps(bench.slabs(building, 422))


def test_buildings_are_listed(bench: Bench, building: Path) -> None:
    """The dialog for opening shows them."""
    answer = asgi.ask(bench.app, "GET", f"/api/files?folder={quote(str(building.parent))}", GOOD)
    assert answer.json()["buildings"] == ["house.ifc"]


@pytest.mark.skipif(os.name != "posix", reason="memory is not limited here")
def test_reading_is_limited(tmp_path: Path) -> None:
    """A file that takes longer than it may is refused."""
    path = saf_files.write(tmp_path / "house.xlsx", saf_files.house())
    with pytest.raises(InputError, match=r"a workbook that takes longer than 0.001 s to read"):
        SafReader(seconds=0.001).survey(path)
