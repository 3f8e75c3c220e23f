"""The house raft's own loads, written as a table of reactions and imported, are its loads and give its results."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.helpers.paths import EXAMPLES

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.cli.main import main
from groundslab.exchange.reactions import ImportedReactions, read_reactions
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from helpers.reaction_tables import Row, Writer, acting_of, as_csv, long_table, wide_table
from helpers.reactions import write_case, write_workbook

#: Names of walls on the straight pieces of the line along which the example has its line loads.
WALLS = ("AB", "BC", "CD", "DE", "EF", "FA")
Z_DOWN = (1.0, -1.0, -1.0)
WRITERS = {
    "on the structure, z up": Writer(),
    "on the slab, z down": Writer(Z_DOWN, 1, reading={"mirrored": True}),
    "on the slab, z up, kip and ft": Writer(sign=1, force="kip", length="ft", reading={"positive": "lifts"}),
    "left-handed, kip": Writer(left_handed=True, force="kip", reading={"moments": "about axes, left-handed"}),
}
TABLES = {"long": long_table, "wide": wide_table}


#: Moments of the wind at a column, along a wall and across one, of which the example has none.
MOMENTS: list[dict[str, Any]] = [
    {"kind": "point", "case": "W", "column": "C1", "P": "-12 kN", "M_x": "14 kNm", "M_y": "-9 kNm"},
    {"kind": "line", "case": "W", "wall": "EF", "q": "-6 kN/m", "q_end": "6.5 kN/m"},
    {"kind": "line moment", "case": "W", "wall": "CD", "m": "3 kNm/m"},
]


@cache
def house(walls: bool = True) -> tuple[Model, Model]:
    """Return the example and the same without loads on columns and walls; with walls, those bear its line loads."""
    data = tomllib.loads((EXAMPLES / "house_raft.toml").read_text(encoding="utf-8"))
    taken = [load for load in data["loads"] if load["kind"] == "point"]
    others = [load for load in data["loads"] if load not in taken]
    if walls:
        lines = [load for load in others if load["kind"] == "line"]
        others = [load for load in others if load not in lines]
        taken += [
            {"kind": "line", "case": load["case"], "wall": wall, "q": load["q"]} for load in lines for wall in WALLS
        ]
        taken += MOMENTS
        places = lines[0]["points"]
        data["walls"] = [
            {"name": name, "thickness": "0.3 m", "points": [start, end]}
            for name, start, end in zip(WALLS, places[:-1], places[1:], strict=True)
        ]
    return casefile.from_table({**data, "loads": [*others, *taken]}), casefile.from_table({**data, "loads": others})


def write_table(folder: Path, rows: list[Row], file: str) -> Path:
    """Write a table as a file of a kind."""
    if file == "xlsx":
        return write_workbook(folder / "reactions.xlsx", {"Reactions": rows})
    path = folder / "reactions.csv"
    path.write_text(as_csv(rows, ";", ",") if file == "decimal commas" else as_csv(rows), encoding="utf-8")
    return path


def imported(
    folder: Path, writer: Writer, layout: str = "long", file: str = "csv", walls: bool = True
) -> ImportedReactions:
    """Return the example without loads on columns and walls, with those of its table."""
    original, without = house(walls)
    table = write_table(folder, TABLES[layout](original, writer), file)
    return read_reactions(table, write_case(folder, casefile.to_toml(without)), **writer.reading)


def loads_of(model: Model) -> dict[tuple[Any, ...], dict[str, float]]:
    """Return the values of all loads by kind, name, case, column and wall [SI]."""
    found = {}
    for load in model.loads:
        key = (load.kind, load.name, load.case, getattr(load, "column", ""), getattr(load, "wall", ""))
        assert key not in found
        numbers = {name: getattr(load, name) for name in type(load).model_fields}
        found[key] = {name: value for name, value in numbers.items() if isinstance(value, float)}
    return found


def assert_same_loads(model: Model, original: Model) -> None:
    """Compare two cases load by load, value by value; sums by support and case, and all else."""
    loads, expected = loads_of(model), loads_of(original)
    assert loads.keys() == expected.keys()
    for key, values in expected.items():
        assert loads[key] == pytest.approx(values, rel=1e-9), key
    acting, of_original = acting_of(model), acting_of(original)
    assert acting.keys() == of_original.keys()
    for key, vectors in of_original.items():
        for vector, expectation in zip(acting[key], vectors, strict=True):
            np.testing.assert_allclose(vector, expectation, rtol=1e-9, atol=1e-9 * np.abs(vectors[0]).max())
    assert model.replace(loads=original.loads, reactions=None) == original


@pytest.mark.parametrize(
    ("writer", "layout", "file"),
    [
        ("on the structure, z up", "long", "csv"),
        ("on the structure, z up", "wide", "decimal commas"),
        ("on the slab, z down", "wide", "xlsx"),
        ("on the slab, z up, kip and ft", "long", "decimal commas"),
        ("on the slab, z up, kip and ft", "wide", "csv"),
        ("left-handed, kip", "long", "xlsx"),
    ],
)
def test_its_own_table_gives_its_loads(writer: str, layout: str, file: str, tmp_path: Path) -> None:
    """Whatever layout, file, units, axes and signs: the same 32 loads to 1e-9; sums by case as added up by hand."""
    result = imported(tmp_path, WRITERS[writer], layout, file)
    assert_same_loads(result.model, house()[0])
    assert len(result.changes) == 29
    assert {change.kind for change in result.changes} == {"new"}
    # 6 columns with 160 and 70 kN, 42.8 m of walls with 45 and 12 kN/m; three columns and 6.7 m of a wall in the wind
    sums = {each.case: each.after.P / 1e3 for each in result.sums}
    length = 11.7 + 4.7 + 5 + 5 + 6.7 + 9.7
    expected = {"G": 6 * 160 + 45 * length, "Q": 6 * 70 + 12 * length, "W": -252 + 0.25 * 6.7}
    assert sums == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("writer", "walls"), [("on the slab, z down", True), ("left-handed, kip", False)])
def test_its_own_table_gives_its_results(writer: str, walls: bool, tmp_path: Path) -> None:
    """Every field of every combination is that of the original to 1e-9 of its largest value."""
    original = house(walls)[0]
    assert walls or original == casefile.load(EXAMPLES / "house_raft.toml")
    coarse = {"mesh": {"size": 2.0}}
    expected = solve(original.replace(**coarse))
    results = solve(imported(tmp_path, WRITERS[writer], "wide", "xlsx", walls).model.replace(**coarse))
    assert list(results) == list(expected)
    for name in expected:
        for field in PLATE_FIELDS:
            values, others = (np.asarray(getattr(each[name].plate, field)) for each in (results, expected))
            limit = 1e-9 * np.abs(others).max()
            np.testing.assert_allclose(values, others, rtol=0, atol=limit, err_msg=f"{name} {field}")


def test_its_table_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same table changes nothing; a later one lists exactly what is new, gone, moved and changed."""
    writer = WRITERS["on the structure, z up"]
    first = imported(tmp_path, writer)
    case = write_case(tmp_path, first.text)
    assert read_reactions(tmp_path / "reactions.csv", case).changes == ()
    rows = [[*row[:2], *places(row[0], first.model), *row[2:]] for row in long_table(first.model, writer)]
    values = {(row[0], row[1]): row for row in rows}
    values["C1", "G"][4] *= 1.0099  # less than 1 %
    values["C2", "G"][4] *= 1.0101  # more
    values["C1", "W"][5] *= 1.02  # a moment alone
    values["EF", "Q"][4] *= 0.98
    rows.remove(values["C3", "Q"])
    rows.append([*values["C5", "G"][:1], "W", *values["C5", "G"][2:4], 25.0, 0.0, 0.0])
    for name, case_of in values:
        if name == "C6":
            values[name, case_of][3] += 0.25
    table = tmp_path / "later.csv"
    table.write_text(as_csv(rows), encoding="utf-8")
    changes = read_reactions(table, case).changes
    assert {(change.kind, change.name, change.case) for change in changes} == {
        ("less", "C1", "G"), ("changed", "C2", "G"), ("changed", "C1", "W"), ("changed", "EF", "Q"),
        ("gone", "C3", "Q"), ("new", "C5", "W"), ("moved", "C6", ""),
    }  # fmt: skip
    assert len(changes) == 7
    assert main(["import-reactions", str(table), str(case)]) == 0
    listed = [line.strip() for line in capsys.readouterr().out.splitlines() if line.startswith("  ")]
    assert "moved: C6 from (3.5, 7.5) m to (3.5, 7.75) m" in listed
    assert "gone: C3 in Q: P 70 kN" in listed
    assert "changed: C2 in G: P 160 -> 161.62 kN" in listed
    assert "1 change by less" in listed


def places(name: str, model: Model) -> list[Any]:
    """Return cells with the place of a column, nothing for a wall, headings and units above."""
    if name in ("Support", ""):
        return ["x", "y"] if name else ["m", "m"]
    return next(([column.x, column.y] for column in model.columns if column.name == name), ["", ""])
