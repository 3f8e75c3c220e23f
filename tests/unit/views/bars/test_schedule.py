"""The bending schedule: rows, sums, notes, the files that it is written into, and what they replace."""

from __future__ import annotations

import csv
import math
from dataclasses import replace
from pathlib import Path

import pytest

import groundslab
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.results.results import Results
from groundslab.views.bars import left_out
from groundslab.views.bars.bvbs import to_bvbs
from groundslab.views.files import results_folder
from groundslab.views.report.table_layout import summarize_table
from groundslab.views.tables.bending_schedule import bending_schedule
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.laid_slab import model_of
from helpers.linked_slab import LINKS, model

MESHES = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y")) | {"bottom_mesh": "Q335A", "top_mesh": "Q335A"}


def test_masses_by_diameter_and_altogether() -> None:
    """Of 8, 10, 12 and 16 mm bars, each number times length times area times 7850 kg/m3; the last row is their sum."""
    table = bending_schedule(model(**LINKS))
    rows = [dict(zip((column.name for column in table.columns), row, strict=True)) for row in table.rows()]
    bars, sums = ([row for row in rows if (row["mark"] is None) == is_sum] for is_sum in (False, True))
    assert [row["diameter"] for row in sums] == [8, 10, 12, 16, None]
    for row in sums:
        own = [bar for bar in bars if row["diameter"] in (None, bar["diameter"])]
        mass = sum(
            bar["number"] * bar["length"] * math.pi * bar["diameter"] ** 2 / 4e6 * 7850
            for bar in own  # type: ignore[operator]
        )
        assert row["mass"] == pytest.approx(mass)
        assert row["number"] == sum(bar["number"] for bar in own)  # type: ignore[misc]
    closed = next(bar for bar in bars if bar["shape"] == "link")
    assert (closed["a"], closed["b"], closed["c"]) == (pytest.approx(900), pytest.approx(500), None)
    assert (closed["hook"], closed["right-angled hook"]) == (pytest.approx(96), None)
    assert any("8.3, 8.5" in note for note in table.notes)


def test_schedule_and_records_say_the_same() -> None:
    """Marks, numbers and lengths of both lists, bar by bar."""
    slab = model_of(detailing={"bar_length": 12.0})
    records = [{part[0]: part[1:] for part in line.split("@")[1:9]} for line in to_bvbs(slab).splitlines()]
    table = bending_schedule(slab)
    listed = [(mark, count) for mark, count in zip(table["mark"], table["number"], strict=True) if mark]
    assert [(record["p"], int(record["n"])) for record in records] == listed
    lengths = [round(1000 * length) for mark, length in zip(table["mark"], table["length"], strict=True) if mark]  # type: ignore[operator]
    assert [int(record["l"]) for record in records] == lengths


def test_the_report_has_the_sums_of_a_long_schedule() -> None:
    """Whole while it fits; of one that is too long for the text the masses by diameter and altogether."""
    table = bending_schedule(model(**LINKS))
    assert summarize_table(table) is None
    columns = tuple(replace(column, values=20 * column.values[:-5] + column.values[-5:]) for column in table.columns)
    sums = summarize_table(replace(table, columns=columns))
    assert sums is not None
    assert [head.text for head in sums.heads] == ["layer", "diameter", "number", "total length", "mass"]
    assert [row[1].text and float(row[1].text) for row in sums.rows] == [8, 10, 12, 16, ""]


def test_meshes_are_told_and_weighed() -> None:
    """Where bars of a face are those of a mesh they are left out, and said to be; meshes alone have no schedule."""
    mixed = dict.fromkeys(("top_x", "top_y")) | {"top_mesh": "Q335A"}
    table = bending_schedule(model_of(**mixed))
    assert set(table["layer"]) == {"bottom x", "bottom y", "all bars"}
    # 9.6 m by 7.2 m: 7.2 m / 150 mm wires of 8 mm along x, 9.6 m / 150 mm along y
    mass = (48 * 9.6 + 64 * 7.2) * math.pi * 0.008**2 / 4 * 7850
    assert any(f"{mass:.5g} kg" in note for note in table.notes)
    assert left_out(model_of(**mixed), "bars.csv") == left_out(model_of(**mixed), "bars.abs") != []
    assert left_out(model_of(**mixed), "bars.svg") == left_out(model_of(detailing={}), "bars.csv") == []
    assert not len(bending_schedule(model_of(**MESHES)))


def test_files(tmp_path: Path) -> None:
    """CSV by the table's words, a workbook with one sheet; a second time the same bytes; others are not replaced."""
    pytest.importorskip("xlsxwriter")
    openpyxl = pytest.importorskip("openpyxl")
    slab = model(**LINKS)
    text = groundslab.write_bars(slab, tmp_path / "bars.csv")
    assert text.read_text(encoding="utf-8") == bending_schedule(slab).csv()
    book = groundslab.write_bars(slab, tmp_path / "bars.xlsx")
    (sheet,) = openpyxl.load_workbook(book)
    rows = list(sheet.iter_rows(min_row=2, values_only=True))
    heads = next(csv.reader([text.read_text(encoding="utf-8").splitlines()[0]]))
    assert (sheet.title, list(rows[0])) == ("bending_schedule", heads)
    for path in (text, book):
        content = path.read_bytes()
        assert groundslab.write_bars(slab, path).read_bytes() == content
        path.write_bytes(b"mark,layer\n1,2\n")
        with pytest.raises(InputError, match="did not write"):
            groundslab.write_bars(slab, path)
    with pytest.raises(InputError, match="welded meshes alone"):
        groundslab.write_bars(model_of(**MESHES), tmp_path / "meshes.csv")


def test_a_schedule_in_another_language_and_in_customary_units(tmp_path: Path) -> None:
    """Heads are translated, lengths are inches and feet; such a file is replaced by one in English.

    9.6 m are 377.95 in, of which 378 in are cut.
    """
    slab = model_of()
    project = {"name": "Halle", "language": "de", "units": "US"}
    path = groundslab.write_bars(slab.replace(project=project), tmp_path / "bars.csv")
    rows = list(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))
    assert float(rows[0]["Durchmesser [in]"]) == pytest.approx(12 / 25.4, rel=1e-6)
    assert float(rows[0]["a [in]"]) == pytest.approx(378, rel=1e-6)
    assert groundslab.write_bars(slab, path).read_text(encoding="utf-8").startswith("mark,layer")


def test_command_and_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command writes by the name's end and says what is left out; the tables of results have the schedule."""
    mixed = model_of(**dict.fromkeys(("top_x", "top_y")), top_mesh="Q335A")
    mixed = mixed.replace(combinations=mixed.combinations[:1])
    each = synthetic.results(model=mixed, combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    results = Results(mixed, mixed.combinations, {"ULS": each}, {})
    folder = tmp_path / "slab-results"
    results_folder.save_results(results, folder)
    table = {table.name: table for table in tables_of(results)}["bending_schedule"]
    assert (folder / "tables" / "bending_schedule.csv").read_text(encoding="utf-8") == table.csv()
    assert main.main(["bars", str(folder), "--out", str(tmp_path / "bars.csv")]) == 0
    assert (tmp_path / "bars.csv").read_text(encoding="utf-8") == table.csv()
    assert "note: welded meshes are not in it" in capsys.readouterr().err
