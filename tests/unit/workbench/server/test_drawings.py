"""Drawings in the workbench: their layers, the cases made from them, and files of strangers."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import ezdxf
import pytest

from groundslab.errors import InputError
from groundslab.exchange.dxf import survey as surveying
from groundslab.workbench.events import Hub
from helpers import asgi, bombs, workers

pytest.importorskip("fastapi")
from groundslab.workbench.checking.drawings import DrawingReader, convert_drawing, survey_drawing
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver

PORT, TOKEN = 8765, "secret"
GOOD = [("host", f"127.0.0.1:{PORT}"), ("x-groundslab-token", TOKEN)]
CORNERS = [(1000, 2000), (7000, 2000), (7000, 6000), (1000, 6000)]

pytestmark = pytest.mark.slow


class Bench:
    """A session and a client that has the token."""

    def __init__(self, folder: Path) -> None:
        hub = Hub()
        solver = Solver(hub.publish, workers.obey, None)
        self.session = Session(hub, solver, folder / "state", "", workers.Inline())
        self.app = create_app(self.session, Tickets(), PORT, TOKEN, folder)

    def get(self, path: str, status: int = 200) -> Any:
        """Return the JSON of an answer."""
        answer = asgi.ask(self.app, "GET", path, GOOD)
        assert answer.status == status, answer.text
        return answer.json()

    def survey(self, file: Path | str, status: int = 200) -> Any:
        """Return the layers of a drawing, or an error."""
        return self.get(f"/api/drawing?file={quote(str(file), safe='')}", status)

    def convert(self, file: Path | str, layers: dict[str, str], status: int = 200, **more: Any) -> Any:
        """Make a case from a drawing, and return the answer."""
        content = json.dumps({"file": str(file), "layers": layers, **more}).encode()
        about = [("content-type", "application/json"), ("content-length", str(len(content)))]
        answer = asgi.ask(self.app, "POST", "/api/drawing", [*GOOD, *about], content)
        assert answer.status == status, answer.text
        return answer.json()


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    """Return a workbench with a new case."""
    made = Bench(tmp_path)
    yield made
    made.session.close()


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Return a drawing in millimeters: a slab, columns on two layers, a wall whose layer names its load, an arc."""
    document = ezdxf.new("R2010", units=4)
    space = document.modelspace()
    space.add_lwpolyline(CORNERS, close=True, dxfattribs={"layer": "A-SLAB"})
    for layer, x in (("A-COL-1", 2000), ("A-COL-2", 5000)):
        space.add_lwpolyline([(x, 3000), (x + 400, 3000), (x + 400, 3400), (x, 3400)], close=True,
                             dxfattribs={"layer": layer})  # fmt: skip
    space.add_line((1000, 5000), (7000, 5000), dxfattribs={"layer": "LOAD_LINE 25 kN_m"})
    space.add_arc((3000, 3000), 500, 0, 90, dxfattribs={"layer": "A-DOORS"})
    space.add_text("ground floor", dxfattribs={"layer": "A-DOORS"})
    document.layers.get("A-DOORS") if document.layers.has_entry("A-DOORS") else document.layers.add("A-DOORS").off()
    path = tmp_path / "plan.dxf"
    document.saveas(path)
    return path


@pytest.mark.usefixtures("reading_here")
def test_the_layers_of_a_drawing(bench: Bench, drawing: Path) -> None:
    """Its unit, each layer with its entities by kind, what its name says it is, and its lines [m], arcs as chords."""
    assert bench.get(f"/api/files?folder={drawing.parent}")["drawings"] == ["plan.dxf"]
    found = bench.survey(drawing)
    assert (found["unit"], found["scale"], found["remarks"]) == ("mm", 0.001, [])
    layers = {layer["name"]: layer for layer in found["layers"]}
    assert next(iter(layers)) == "LOAD_LINE 25 kN_m"
    assert layers["LOAD_LINE 25 kN_m"]["role"] == "line_loads"
    assert layers["A-SLAB"]["role"] is None
    assert layers["A-SLAB"]["lines"] == [[1, 2, 7, 2, 7, 6, 1, 6, 1, 2]]
    assert layers["A-DOORS"]["kinds"] == {"ARC": 1, "TEXT": 1}
    assert layers["A-DOORS"]["hidden"] is True
    assert layers["A-DOORS"]["lines"] == []
    arc = layers["A-DOORS"]["curves"][0]
    assert arc[:2] == pytest.approx([3.5, 3.0])
    assert arc[-2:] == pytest.approx([3.0, 3.5])
    assert all((x - 3) ** 2 + (y - 3) ** 2 == pytest.approx(0.25) for x, y in zip(arc[::2], arc[1::2], strict=True))


ROLES = {
    "A-SLAB": "outline",
    "A-COL-1": "columns",
    "a-col-2": "columns",
    "LOAD_LINE 25 kN_m": "line_loads",
}


def test_a_case_from_a_drawing(bench: Bench, drawing: Path) -> None:
    """It is a new document that is not saved; several layers hold the same; a layer's name keeps its value."""
    answer = bench.convert(drawing, ROLES)
    state = answer["state"]
    assert (state["file"], state["dirty"], state["can_undo"]) == (None, True, False)
    assert answer["origin"] == [0, 0]
    data = tomllib.loads(state["text"])
    assert data["title"] == "plan"
    assert data["plate"]["outline"]["points"][0] == ["1 m", "2 m"]
    assert [(each["x"], each["width_x"]) for each in data["columns"]] == [("2.2 m", "0.4 m"), ("5.2 m", "0.4 m")]
    assert [(each["kind"], each["q"]) for each in data["loads"]] == [("line", "25 kN/m")]
    assert "columns: 2" in answer["report"]
    assert "A-DOORS" not in answer["report"]


@pytest.mark.usefixtures("reading_here")
def test_the_gaps_that_are_closed(bench: Bench, tmp_path: Path) -> None:
    """A gap of 3 mm is an issue, unless wider ones are to be closed; the report names it."""
    document = ezdxf.new(units=6)
    for start, end in (((0, 0), (4, 0.003)), ((4, 0), (4, 3)), ((4, 3), (0, 0))):
        document.modelspace().add_line(start, end, {"layer": "SLAB"})
    path = tmp_path / "gap.dxf"
    document.saveas(path)
    assert "a gap of 0.003 m" in str(bench.convert(path, {"SLAB": "outline"}, status=422))
    report = bench.convert(path, {"SLAB": "outline"}, gap="5 mm")["report"]
    assert "a gap of 0.003 m was closed at (4, 0.003) m" in report


@pytest.mark.usefixtures("reading_here")
def test_outlines_side_by_side(bench: Bench, tmp_path: Path) -> None:
    """A house and its garage are refused, unless they are to be one."""
    document = ezdxf.new(units=6)
    for x0, x1 in ((0, 10), (10, 14)):
        corners = [(x0, 0), (x1, 0), (x1, 6), (x0, 6)]
        document.modelspace().add_lwpolyline(corners, close=True, dxfattribs={"layer": "SLAB"})
    path = tmp_path / "house.dxf"
    document.saveas(path)
    assert "touches the outline" in str(bench.convert(path, {"SLAB": "outline"}, status=422))
    report = bench.convert(path, {"SLAB": "outline"}, union=True)["report"]
    assert "outline: 14 m x 6 m, 84 m^2" in report


@pytest.mark.usefixtures("reading_here")
def test_the_origin_and_the_unit_that_are_chosen(bench: Bench, drawing: Path) -> None:
    """The middle of the slab becomes the origin; a unit that is given wins over that of the drawing."""
    answer = bench.convert(drawing, ROLES, centered=True)
    centered = answer["state"]["text"]
    assert answer["origin"] == [4, 4]
    assert "The origin is the drawing's point (4, 4) m." in centered
    data = tomllib.loads(centered)
    assert data["plate"]["outline"]["points"][0] == ["-3 m", "-2 m"]
    assert [each["x"] for each in data["columns"]] == ["-1.8 m", "1.2 m"]
    assert data["loads"][0]["points"] == [["-3 m", "1 m"], ["3 m", "1 m"]]
    answer = bench.convert(drawing, ROLES, unit="cm")
    assert tomllib.loads(answer["state"]["text"])["plate"]["outline"]["points"][0] == ["10 m", "20 m"]
    assert "the drawing says that its unit is mm; it was read in cm as given" in answer["report"]


@pytest.mark.usefixtures("reading_here")
def test_wrong_choices_are_issues_and_leave_the_document(bench: Bench, drawing: Path) -> None:
    """No outline, a role that there is not, a unit that is none, a missing unit: all of them in words."""
    before = bench.get("/api/state")["text"]
    issues = bench.convert(drawing, {"A-COL-1": "colums"}, 422, unit="kN")["error"]["issues"]
    assert [each["location"] for each in issues[:3]] == [
        "the drawing's unit",
        'layer "A-COL-1"',
        "layer for outline",
    ]
    error = bench.convert(drawing, {"NONE": "outline"}, 422)["error"]
    assert (error["found"], error["expected"]) == ("nothing on it", "entities for outline")
    document = ezdxf.readfile(drawing)
    document.header["$INSUNITS"] = 0
    document.saveas(drawing)
    assert bench.survey(drawing)["unit"] is None
    assert bench.convert(drawing, ROLES, 422)["error"]["found"] == "no unit"
    bench.convert(drawing, {f"L{n}": "columns" for n in range(1001)}, 422)
    bench.convert(drawing, ROLES, 422, origin="here")
    assert bench.get("/api/state")["text"] == before


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no named pipes")
@pytest.mark.usefixtures("reading_here")
def test_files_that_are_no_drawings(bench: Bench, tmp_path: Path) -> None:
    """Pipes, devices, folders, other files, names that no file can have: refused in words, never waited for."""
    os.mkfifo(tmp_path / "pipe.dxf")
    (tmp_path / "link.dxf").symlink_to(tmp_path / "pipe.dxf")
    (tmp_path / "to_device.dxf").symlink_to("/dev/zero")
    (tmp_path / "secret.dxf").symlink_to("/etc/passwd")
    (tmp_path / "folder.dxf").mkdir()
    (tmp_path / "empty.dxf").write_bytes(b"")
    (tmp_path / "noise.dxf").write_bytes(bytes(range(256)) * 40)
    (tmp_path / "drawing.dxf").write_bytes(b"AC1032" + bytes(1000))
    names = ["folder.dxf", "pipe.dxf", "empty.dxf", "noise.dxf", "drawing.dxf", "none.dxf"]
    for name in [*map(str, map(tmp_path.joinpath, names)), str(tmp_path / "link.dxf")]:
        assert bench.survey(name, 422)["error"]["found"], name
    for name in ("to_device.dxf", "secret.dxf", "../../../etc/passwd", "x" * 300 + ".dxf", "a\0b.dxf", ".."):
        error = bench.survey(name if "/" in name else tmp_path / name, 422)["error"]
        assert "root:" not in json.dumps(error)
    assert bench.get(f"/api/files?folder={tmp_path}")["drawings"] == [
        "drawing.dxf",
        "empty.dxf",
        "noise.dxf",
        "secret.dxf",
    ]


@pytest.mark.parametrize("name", bombs.SMALL)
def test_small_drawings_that_are_much(name: str, tmp_path: Path) -> None:
    """Their layers are listed all the same, with what could not be counted."""
    path = tmp_path / "plan.dxf"
    path.write_text(bombs.SMALL[name][0])
    found = survey_drawing(str(path))
    assert found["layers"]
    assert all(each.startswith("what lies in blocks is not counted: ") for each in found["remarks"])
    with pytest.raises(InputError):
        convert_drawing(str(path), {"NONE": "outline"}, "m", centered=False, gap="1 mm")


def test_a_drawing_that_takes_too_long_or_too_much(drawing: Path, tmp_path: Path) -> None:
    """The process is ended, and the words say so; the next drawing is read by another."""
    long = tmp_path / "long.dxf"
    long.write_text(bombs.circles(5000, "HOLES"))
    with pytest.raises(InputError, match=r"found a drawing that takes longer than 0.01 s to read, expected a sound"):
        DrawingReader(seconds=0.01).survey(long)
    with pytest.raises(InputError, match="a drawing that takes too much memory to read"):
        DrawingReader(memory=1_000_000).survey(long)
    assert DrawingReader().survey(drawing)["unit"] == "mm"


def test_a_drawing_that_breaks_the_reader_is_an_issue(drawing: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the error of reading is, it is told in words."""
    monkeypatch.setattr("groundslab.workbench.checking.drawings.survey_drawing", int)  # fails in the process
    with pytest.raises(InputError, match=r"found a damaged file \(ValueError: invalid literal"):
        DrawingReader().survey(drawing)


def test_arcs_and_straight_lines_are_told_apart(drawing: Path) -> None:
    """A slot is two lines and two arcs; an ellipse and a circle are curves."""
    document = ezdxf.readfile(drawing)
    space = document.modelspace()
    space.add_lwpolyline(
        [(0, 0, 0), (2000, 0, 1), (2000, 1000, 0), (0, 1000, 1)], format="xyb", close=True, dxfattribs={"layer": "SLOT"}
    )
    space.add_ellipse((0, 0), (500, 0), 0.5, dxfattribs={"layer": "ROUND"})
    space.add_circle((0, 0), 500, dxfattribs={"layer": "ROUND"})
    document.saveas(drawing)
    found = {layer.name: layer for layer in surveying.survey(drawing).layers}
    assert found["SLOT"].lines == [[(0, 0), (2, 0)], [(2, 1), (0, 1)]]
    assert [(curve[0], curve[-1]) for curve in found["SLOT"].curves] == [((2, 0), (2, 1)), ((0, 1), (0, 0))]
    assert (len(found["ROUND"].lines), len(found["ROUND"].curves)) == (0, 3)


def test_lines_beyond_a_number_are_not_shown(drawing: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """They are counted, and how many are left out is said."""
    monkeypatch.setattr(surveying, "MOST_POINTS", 7)
    found = surveying.survey(drawing)
    assert sum(len(line) for layer in found.layers for line in (*layer.lines, *layer.curves)) == 7
    assert found.remarks == ("3 lines are not shown, as there are more than 7 points",)
    assert sum(sum(layer.kinds.values()) for layer in found.layers) == 6
