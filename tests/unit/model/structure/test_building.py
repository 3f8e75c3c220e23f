"""Buildings that cannot be, with what is said of them, and matrices from files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.case.casefile import load, loads, to_toml
from groundslab.cli.main import main
from groundslab.views.report.changes import changes_since
from groundslab.views.scene.plan import plan_of

SECTION = {"kind": "rectangle", "width": 0.3, "height": 0.5}
FRAME: dict[str, Any] = {"storeys": [3.0], "E": 30e9, "beams": [{"through": ["A", "B"], "section": SECTION}]}
#: A beam of the length 3 m, 3 m and one that lies over three columns in a row.
SEESAW = [[1.0, -2.0, 1.0], [-2.0, 4.0, -2.0], [1.0, -2.0, 1.0]]


def case(**others: Any) -> dict[str, Any]:
    """Return the parts of a case with four columns and three walls."""
    places = {"A": (-4.0, 0.0), "M": (0.0, 0.0), "B": (4.0, 0.0), "C": (4.0, 0.0)}
    parts: dict[str, Any] = {
        "plate": {"length_x": 12.0, "length_y": 8.0, "thickness": 0.5, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [{"name": name, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4} for name, (x, y) in places.items()],
        "walls": [
            {"name": "W", "thickness": 0.3, "points": [(-4.0, 2.0), (1.0, 2.0)]},
            {"name": "stiff", "thickness": 0.3, "height": 3.0, "points": [(-4.0, -2.0), (0.0, -2.0)]},
            {"name": "bent", "thickness": 0.3, "points": [(-4.0, 3.0), (0.0, 3.0), (0.0, 3.5)]},
        ],
        "loads": [{"kind": "point", "column": "A", "P": 100e3}],
    }
    return parts | others


def matrix(rows: list[list[float]], *nodes: str, **others: Any) -> dict[str, Any]:
    """Return a building as a matrix."""
    return {"nodes": nodes, "matrix": rows, "unit": "kN"} | others


def beams(*through: str, **others: Any) -> dict[str, Any]:
    """Return a frame with one beam."""
    return FRAME | {"beams": [{"through": through, "section": SECTION} | others]}


def columns(*names: str, **others: Any) -> dict[str, Any]:
    """Return a frame with columns of a section of their own."""
    return FRAME | {"columns": [{"names": names, "section": SECTION} | others]}


WRONG = {
    "nothing": ({}, "building.storeys: found nothing"),
    "no beams": ({"storeys": [3.0], "E": 30e9}, "building.beams: found nothing, expected beams that join columns"),
    "no E": ({**FRAME, "E": None}, "building.E: found nothing, expected Young's modulus of the frame"),
    "unknown column": (beams("A", "X"), 'building.beams[1].through[2]: found "X"'),
    "from A to A": (beams("A", "A"), 'found "A" twice'),
    "at one place": (beams("B", "C"), 'found no length from "B" to "C"'),
    "inside a wall": (
        beams("W", "V"),
        'building.beams[1].through[2]: found "V"',
    ),
    "stiff wall": (beams("A", "stiff"), "a wall without a height, as its stiffness would count twice"),
    "bent wall": (beams("A", "bent"), "expected a straight wall"),
    "no such storey": (beams("A", "B", storeys=[2]), "building.beams[1].storeys[1]: found 2, expected at most 1"),
    "column without a beam": (columns("M"), 'building.columns[1].names[1]: found "M", which no beam joins'),
    "two sections": (
        {**FRAME, "columns": [{"names": ["A"], "section": SECTION}, {"names": ["A"], "section": SECTION}]},
        'building.columns[2].names[1]: found "A" with a second section',
    ),
    "frame and matrix": (matrix(SEESAW, "A", "M", "B", storeys=[3.0]), "found storeys together with a matrix"),
    "no unit": (matrix(SEESAW, "A", "M", "B", unit=None), "building.unit: found nothing"),
    "unit alone": ({**FRAME, "unit": "kN"}, "building.unit: found unit without a matrix"),
    "a beam twice": (
        {**FRAME, "beams": [*FRAME["beams"], {"through": ["B", "A"], "section": SECTION}]},
        'building.beams[2].through[2]: found a second beam between "B" and "A"',
    ),
    "unknown node": (matrix(SEESAW, "A", "M", "Z"), 'building.nodes[3]: found "Z"'),
    "not square": (matrix([[1.0, -1.0], [-1.0]], "A", "B"), "building.matrix[2]: found 1 numbers, expected 2"),
    "rows too many": (matrix(SEESAW, "A", "B"), "found 3 rows, expected 2 rows for settlements alone, or 6"),
    "zeros": (matrix([[0.0, 0.0], [0.0, 0.0]], "A", "B"), "found zeros alone"),
    "not symmetric": (
        matrix([[1.0, -2.0, 1.0], [-2.0, 4.0, -2.0], [1.0, -1.9, 1.0]], "A", "M", "B"),
        "building.matrix[2][3]: found -2.0 in row 2, column 3, and -1.9 in row 3, column 2",
    ),
    "not positive": (matrix([[-one for one in row] for row in SEESAW], "A", "M", "B"), "a matrix that is not positive"),
    "held": (matrix([[2.0, -1.0], [-1.0, 2.0]], "A", "B"), "resists settling as a whole"),
    "against tilting": (matrix([[1.0, -1.0], [-1.0, 1.0]], "A", "B"), "a matrix that resists tilting along x"),
    "file": ({"file": "k.csv", "unit": "kN"}, "only a case that is read from a folder can name a file there"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_cannot_be_is_refused(name: str) -> None:
    """Each says where, what and what else."""
    building, found = WRONG[name]
    with pytest.raises(gs.InputError) as refused:
        gs.Model(**case(building=building))
    assert found in str(refused.value)


def test_a_building_on_an_industrial_floor_is_refused() -> None:
    """The checks of a floor take its loads as they are given."""
    floor = {"kind": "TR34", "f_ck": 32e6, "f_R1": 2.4e6, "f_R4": 1.8e6}
    with pytest.raises(gs.InputError, match="a building on an industrial floor"):
        gs.Model(**case(building=FRAME, floor=floor))


def test_a_building_on_several_plates_on_a_continuum_is_refused() -> None:
    """Their rigid motions are sought for each by itself there, which a building joins."""
    parts = case(building=FRAME, ground={"kind": "continuum", "layers": [{"thickness": 8.0, "E": 40e6, "nu": 0.3}]})
    parts["plate"] = {"name": "one", "outline": {"kind": "rectangle", "x": [-6, 6], "y": [-4, 4]}, "thickness": 0.5,
                      "E": 30e9, "nu": 0.2}  # fmt: skip
    other = parts["plate"] | {"name": "other", "outline": {"kind": "rectangle", "x": [7, 9], "y": [-4, 4]}}
    with pytest.raises(gs.InputError, match='a building on several plates on "continuum" ground'):
        gs.Model(**parts | {"plates": [other]})


def test_a_beam_to_what_stands_on_the_same_wall_is_refused() -> None:
    """A beam starts where a wall is nearest to its other end, which stands on the wall here."""
    near = {"name": "N", "x": 0.5, "y": 2.0, "width_x": 0.4, "width_y": 0.4}
    parts = case()
    with pytest.raises(gs.InputError, match="one of them stands where the other one does"):
        gs.Model(**parts | {"columns": [*parts["columns"], near], "building": beams("W", "N")})


def write_case(folder: Path, csv: str) -> Path:
    """Write a case whose building is in a file, and return where."""
    (folder / "frame.csv").write_text(csv, encoding="utf-8")
    text = to_toml(gs.Model(**case())) + '\n[building]\nfile = "frame.csv"\nunit = "kN"\n'
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "csv",
    [
        "A,M,B\n1,-2,1\n-2,4,-2\n1,-2,1\n",
        '"A";"M";"B"\r\n1,0;-2;1\r\n-2;4,0;-2\r\n\r\n1;-2;1\r\n',
        "A\tM\tB\n1\t-2\t1\n-2\t4\t-2\n1\t-2\t1\n",
        "A;M;B\n1.0;-2;1\n-2;4.000;-2\n1;-2;1\n",
        "A;M;B\n1,000;-2;1\n-2;4,000E+000;-2\n1;-2;1\n",
    ],
)
def test_a_matrix_from_a_file(tmp_path: Path, csv: str) -> None:
    """The first line has the names; cells stand between commas, or semicolons with decimal commas."""
    building = load(write_case(tmp_path, csv)).building
    assert building is not None
    assert building.nodes == ("A", "M", "B")
    assert building.matrix == tuple(map(tuple, SEESAW))
    # it has become a part of the case, which needs the file no more
    model = load(tmp_path / "case.toml")
    assert loads(to_toml(model)) == model
    assert main(["check", str(tmp_path / "case.toml")]) == 0
    (tmp_path / "case-results").mkdir()
    assert changes_since(tmp_path / "case-results", model) == ""


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    """All that is no number is said at once, with its line; so is a file that is not there, or empty."""
    path = write_case(tmp_path, "A,M,B\n1,-2,x\n-2,y,-2\n1,-2,1\n")
    with pytest.raises(gs.InputError) as refused:
        load(path)
    assert 'line 2, value 3: found "x", expected a number' in str(refused.value)
    assert 'line 3, value 2: found "y", expected a number' in str(refused.value)
    write_case(tmp_path, "\n")
    with pytest.raises(gs.InputError, match="found 0 lines"):
        load(path)
    write_case(tmp_path, "A,M,B\n1,-2,1,\n-2,4_0,-2\n1,-2,1\n")
    with pytest.raises(gs.InputError, match="line 2, value 4: found nothing") as refused:
        load(path)
    assert 'line 3, value 2: found "4_0"' in str(refused.value)
    write_case(tmp_path, '"A,M,B\n1,-2,"1\n-2,4,-2\n' + "9" * 200_000 + "\n")
    with pytest.raises(gs.InputError, match="line 4, value 1"):
        load(path)
    write_case(tmp_path, "A;M;B\n1,5;-2;1.5\n-2;4;-2\n1;-2;1\n")
    with pytest.raises(gs.InputError, match="commas or points may group digits"):
        load(path)
    (tmp_path / "frame.csv").unlink()
    with pytest.raises(gs.InputError, match=r'building\.file: found "frame.csv", expected the name of a file in'):
        load(path)
    path.write_text(path.read_text(encoding="utf-8").replace("frame.csv", "../frame.csv"), encoding="utf-8")
    with pytest.raises(gs.InputError, match="expected the name of a file in"):
        load(path)


def test_digits_of_a_printed_matrix_do_not_matter() -> None:
    """What a thousandth of the largest entry of its kind gains is taken as none, in any unit."""
    rows = np.array(SEESAW) * 1e6 - np.diag([1.0, 0.0, 1.0])
    for unit in ("N", "MN"):
        assert gs.Model(**case(building=matrix(rows.tolist(), "A", "M", "B", unit=unit))).building is not None


def test_its_beams_are_drawn_from_base_to_base() -> None:
    """In plan and in figures; a beam to a wall ends on its axis, where that is nearest."""
    beams = [{"through": ["A", "M", "B"], "section": SECTION}, {"through": ["M", "W"], "section": SECTION}]
    model = gs.Model(**case(building=FRAME | {"beams": beams}))
    lines = (((-4.0, 0.0), (0.0, 0.0), (4.0, 0.0)), ((0.0, 0.0), (0.0, 2.0)))
    for found, expected in zip(model.building_lines, lines, strict=True):
        assert np.array(found) == pytest.approx(np.array(expected), abs=0.6)
    drawn = plan_of(model)["building"]
    assert [part["path"] for part in drawn] == ["building.beams[1]", "building.beams[2]"]
    assert drawn[0]["points"] == [[-4.0, 0.0], [0.0, 0.0], [4.0, 0.0]]
    assert gs.Model(**case()).building_lines == ()
