"""Files made of results in the workbench: each is what the command or the function of Python writes."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.workbench.exports import files
from groundslab.workbench.exports.case_writer import NO_RESULTS, CaseWriter
from groundslab.workbench.exports.files import Exported, ExportName, Wanted, export
from helpers.small_case import TEXT

CASE = (
    TEXT
    + """
[[cases]]
name = "G"

[[cases]]
name = "Q"
category = "E"

[[loads]]
kind = "point"
case = "Q"
P = "100 kN"
x = "1 m"
y = "0.5 m"

[combine]
sets = ["ultimate", "characteristic", "quasi-permanent"]

[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["46 mm", "58 mm"]
top = ["46 mm", "58 mm"]
bottom_x = { diameter = "12 mm", spacing = "150 mm" }
bottom_y = { diameter = "12 mm", spacing = "150 mm" }
top_x = { diameter = "12 mm", spacing = "150 mm" }
top_y = { diameter = "12 mm", spacing = "150 mm" }
"""
)


@pytest.fixture(scope="module")
def solved() -> gs.Results:
    """Results of a slab with bars in several combinations."""
    text = CASE.replace('q = "10 kPa"', 'q = "10 kPa"\ncase = "G"')
    return gs.solve(casefile.loads(text))


Write = Callable[[gs.Results, Path], object]
SAME: list[tuple[Wanted, Write]] = [
    (Wanted("tables.xlsx"), gs.write_workbook),
    (Wanted("bars.dxf"), gs.write_bars),
    (Wanted("bars.svg"), gs.write_bars),
    (Wanted("bars.csv"), gs.write_bars),
    (Wanted("bars.xlsx"), gs.write_bars),
    (Wanted("bars.ifc"), gs.write_bars),
    (Wanted("bars-a3.pdf"), lambda results, path: gs.write_bars(results, path, paper="a3")),
    (Wanted("plan.pdf", field="settlement"), lambda results, path: results.plot("settlement", to=path)),
    (
        Wanted("plan.dxf", field="moment_x", envelope="ultimate"),
        lambda results, path: results.plot("moment_x", envelope="ultimate", to=path),
    ),
    # the largest of all combinations, whichever is looked at
    (
        Wanted("plan.svg", field="required_bottom_x", envelope="ultimate"),
        lambda results, path: results.plot("required_bottom_x", to=path),
    ),
]


@pytest.mark.parametrize(("wanted", "write"), SAME, ids=[f"{wanted.file} {wanted.field}" for wanted, _ in SAME])
def test_files_are_those_of_python(wanted: Wanted, write: Write, solved: gs.Results, tmp_path: Path) -> None:
    """To the byte, whichever way they are made; lists of bars without detailing say what they lack."""
    path = tmp_path / wanted.file
    write(solved, path)
    exported = export(solved, wanted)
    assert exported.content == path.read_bytes()
    assert len(exported.notes) == (wanted.file in ("bars.csv", "bars.xlsx", "bars.ifc"))


def test_field_values_are_those_of_the_results_folder(solved: gs.Results, tmp_path: Path) -> None:
    """Those of the combination shown, and the envelope where several are; unknown combinations are refused."""
    folder = gs.save_results(solved, tmp_path / "results")
    name = next(iter(solved))
    one = export(solved, Wanted("plate.vtu", combination=name)).content
    assert one in [path.read_bytes() for path in folder.rglob("plate*.vtu")]
    assert export(solved, Wanted("plate.vtu")).content == (folder / "envelope.vtu").read_bytes()
    with pytest.raises(InputError, match="one that has results"):
        export(solved, Wanted("plate.vtu", combination="ULS 99"))


def test_tables_as_csv(solved: gs.Results) -> None:
    """One file for each table."""
    with zipfile.ZipFile(io.BytesIO(export(solved, Wanted("tables.zip")).content)) as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist()}
    assert texts == {f"{table.name}.csv": table.csv() for table in gs.tables_of(solved)}


def test_saf_tells_what_it_does_not_hold(solved: gs.Results, tmp_path: Path) -> None:
    """The notes are those of the function, and with results the file has their section forces."""
    pytest.importorskip("openpyxl")
    made = export(solved, Wanted("saf.xlsx"))
    (tmp_path / "made.xlsx").write_bytes(made.content)
    assert made.notes == gs.write_saf(solved, tmp_path / "written.xlsx")
    assert any("reinforcement" in note for note in made.notes)
    read = gs.read_saf(tmp_path / "made.xlsx")
    assert read.model.plate.bounds == solved.model.plate.bounds
    assert read.model.ground.k == solved.model.ground.k
    assert _sheets(made.content) == _sheets((tmp_path / "written.xlsx").read_bytes())
    assert "ResultInternalForce2DEdge" in _sheets(made.content)


def test_a_case_without_results(tmp_path: Path) -> None:
    """It is written in a process of its own; that it has no results is said, and one that takes too long is refused."""
    pytest.importorskip("openpyxl")
    made = CaseWriter().write_saf(TEXT)
    assert made.notes == (NO_RESULTS, *gs.write_saf(casefile.loads(TEXT), tmp_path / "written.xlsx"))
    assert _sheets(made.content) == _sheets((tmp_path / "written.xlsx").read_bytes())
    assert "ResultInternalForce2DEdge" not in _sheets(made.content)
    with pytest.raises(InputError, match=r"longer than 0.001 s"):
        CaseWriter(0.001).write_saf(TEXT)


def _sheets(content: bytes) -> dict[str, list[tuple[object, ...]]]:
    """Return the rows of a workbook by sheets; its properties have the time."""
    import openpyxl

    book = openpyxl.load_workbook(io.BytesIO(content))
    return {sheet.title: list(sheet.iter_rows(values_only=True)) for sheet in book}


@pytest.mark.parametrize(
    ("file", "field", "name"),
    [
        ("plan.dxf", "moment_x", "raft-moment_x.dxf"),
        ("saf.xlsx", "moment_x", "raft-saf.xlsx"),
        ("plan.png", "", "raft-plan.png"),
    ],
)
def test_names(file: ExportName, field: str, name: str) -> None:
    """Files are called after the case, plans also after their field."""
    assert Wanted(file, "raft.toml", field).name == name


def test_files_are_packed_with_their_notes() -> None:
    """Whatever bytes they are of; more notes than are listed are counted, long ones cut."""
    made = Exported(b"\x00\n[]\n", ("é, “q”", "two\nlines"))
    assert Exported.from_bytes(made.to_bytes()) == made
    many = files.limit_notes(b"", ["x" * 400] + ["short"] * 300)
    assert (len(many.notes), many.notes[-1]) == (files.LISTED + 1, "101 more")
    assert many.notes[0] == "x" * files.LONGEST + " ..."
