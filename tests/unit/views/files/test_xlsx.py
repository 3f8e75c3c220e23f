"""The workbook of tables: what is in it, that it is the same each time, and what it replaces."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import pytest

import groundslab as gs
from groundslab.cli import main
from groundslab.views.tables.result_tables import tables_of

pytest.importorskip("xlsxwriter")


@pytest.fixture(scope="module")
def results() -> gs.Results:
    """Return results of two combinations; the name of one looks like a formula."""
    return gs.solve(
        gs.Model(
            title="Workbook",
            plate=gs.Plate(length_x=4, length_y=3, thickness=0.2, E=30e9, nu=0.2),
            ground=gs.Winkler(k=20e6),
            cases=[gs.LoadCase(name="G"), gs.LoadCase(name="Q", action="variable")],
            loads=[gs.UniformLoad(q=10e3, case="G"), gs.PointLoad(P=50e3, x=1, y=0.5, case="Q")],
            combinations=[
                gs.Combination(name="=1+1", factors={"G": 1.35}),
                gs.Combination(name="both", factors={"G": 1.35, "Q": 1.5}),
            ],
            mesh=gs.Mesh(size=0.5),
        )
    )


def part(path: Path, name: str) -> str:
    """Return a part of a workbook as text."""
    with zipfile.ZipFile(path) as book:
        return book.read(name).decode()


def test_every_table_is_a_sheet_with_all_digits(results: gs.Results, tmp_path: Path) -> None:
    """Sheets are called as the tables; a number stands there as it is, a text that looks like a formula as a text."""
    path = gs.write_workbook(results, tmp_path / "tables.xlsx")
    tables = tables_of(results)
    assert re.findall(r'<sheet name="([^"]+)"', part(path, "xl/workbook.xml")) == [table.name for table in tables]
    number = [table.name for table in tables].index("extremes") + 1
    sheet = part(path, f"xl/worksheets/sheet{number}.xml")
    found = {float(value) for value in re.findall(r"<v>([^<]+)</v>", sheet)}
    for column in tables[number - 1].columns:
        numbers = {value for value in column.values if isinstance(value, float)}
        assert all(any(value == pytest.approx(each, rel=1e-15, abs=0) for each in found) for value in numbers)
    assert "<f>" not in sheet
    assert "=1+1" in part(path, "xl/sharedStrings.xml")


def test_the_same_results_give_the_same_bytes(results: gs.Results, tmp_path: Path) -> None:
    """Also over an older workbook of its own, which it replaces."""
    first, second = tmp_path / "a.xlsx", tmp_path / "b.xlsx"
    gs.write_workbook(results, first)
    gs.write_workbook(results, second)
    gs.write_workbook(results, second)
    assert first.read_bytes() == second.read_bytes()


def test_a_strange_file_is_left_alone(results: gs.Results, tmp_path: Path) -> None:
    """A workbook of somebody else's is none of ours."""
    path = tmp_path / "tables.xlsx"
    path.write_bytes(b"PK not ours")
    with pytest.raises(gs.InputError, match="did not write"):
        gs.write_workbook(results, path)
    assert path.read_bytes() == b"PK not ours"


def test_the_command_writes_beside_the_folder(results: gs.Results, tmp_path: Path) -> None:
    """RESULTS.xlsx, or where --out says."""
    gs.save_results(results, tmp_path / "slab-results")
    assert main.main(["tables", str(tmp_path / "slab-results")]) == 0
    assert main.main(["tables", str(tmp_path / "slab-results"), "--out", str(tmp_path / "other.xlsx")]) == 0
    assert (tmp_path / "slab-results.xlsx").read_bytes() == (tmp_path / "other.xlsx").read_bytes()
