"""Loads that act in no combination are no green light: rows of the checks, a table, lines of the summary."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from groundslab.analysis.driver import solve
from groundslab.cli.main import main
from groundslab.design.checks import check_design
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.report.html import render_report
from groundslab.views.summary.json_summary import json_text
from groundslab.views.tables.result_tables import tables_of
from helpers.pages import page

#: A column of 600 kN in a case that the only combination leaves out.
UNUSED = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "400 mm"
E = "33 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[mesh]
counts = [18, 12]

[[cases]]
name = "G"

[[cases]]
name = "Q"
action = "variable"

[[columns]]
name = "C1"
x = "1 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"

[[loads]]
kind = "point"
case = "G"
column = "C1"
P = "600 kN"

[[loads]]
kind = "uniform"
case = "Q"
q = "5 kPa"

[[combinations]]
name = "U"
factors = { Q = 1.5 }

[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["50 mm", "60 mm"]
top = ["50 mm", "60 mm"]
"""
SLAB: dict[str, Any] = {
    "plate": {"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 20e6},
    "mesh": {"counts": (4, 4)},
    "cases": [{"name": "G"}, {"name": "Q"}],
    "loads": [{"kind": "uniform", "q": 10e3, "case": "G"}, {"kind": "uniform", "q": 10e3, "case": "Q"}],
}


def solved(**parts: Any) -> Results:
    """Return the results of a slab of 6 m x 4 m with 240 kN in each of two cases."""
    return solve(Model(**SLAB | parts))


def test_a_column_that_is_never_used(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command line, the table of checks and that of what acts where tell of the 600 kN."""
    case = tmp_path / "unused.toml"
    case.write_text(UNUSED, encoding="utf-8")
    assert main(["solve", str(case), "--out", str(tmp_path / "out")]) == 0
    printed = capsys.readouterr()
    assert "DESIGN NEEDS ATTENTION: 1 of 6 checks needs it." in printed.err
    assert 'loads: case "G" acts in no combination: its load is left out (600 kN)' in printed.out
    assert "  G (permanent, 1 load): in no combination\n  Q (variable, 1 load): ultimate 1.5 (1 of 1)" in printed.out
    rows = (tmp_path / "out/tables/acting.csv").read_text(encoding="utf-8").splitlines()
    assert rows == [
        "case,action,combination,limit state,factor,force of the case [kN],force with the factor [kN]",
        "G,permanent,,,0,600,0",
        "Q,variable,U,ultimate,1.5,120,180",
    ]
    summary = json.loads((tmp_path / "out/summary.json").read_text(encoding="utf-8"))
    assert summary["design"]["status"] == "attention"
    assert summary["remarks"] == ['case "G" acts in no combination: its load is left out (600 kN)']
    assert [(each["name"], each["acting"]) for each in summary["cases"]] == [
        ("G", {}), ("Q", {"ultimate": {"combinations": 1, "total": 1, "least": 1.5, "greatest": 1.5}}),
    ]  # fmt: skip


def test_two_permanent_cases() -> None:
    """1.35 G + 1.35 Q is in doubt, although nothing else is checked; both forces stand in the table."""
    found = solved(combine={"sets": ["ultimate", "characteristic"]})
    design = check_design(found)
    assert design.status == "attention"
    assert [each.words for each in design.checks] == [
        'no case is variable: "G" and "Q" are combined as permanent; a live load needs action = "variable"'
    ]
    tables = {table.name: table for table in tables_of(found)}
    assert tables["checks"]["verdict"] == ("attention",)
    acting = tables["acting"]
    assert acting["combination"] == 2 * ("ULS 1", "ULS 2", "characteristic 1")
    assert acting["factor"] == 2 * (1.35, 1.0, 1.0)
    assert acting["force with the factor"] == pytest.approx(2 * (324.0, 240.0, 240.0))


def test_nothing_in_doubt_is_nothing_to_see() -> None:
    """Where all loads take part there is no row."""
    cases = [{"name": "G"}, {"name": "Q", "action": "variable"}]
    found = solved(cases=cases, combine={"sets": ["ultimate", "characteristic"]})
    assert check_design(found).status == "not checked"
    assert json.loads(json_text(found))["remarks"] == []


def test_the_report_has_what_acts_where() -> None:
    """The chapter of load cases has a row for each limit state in which a case acts, and remarks below."""
    found = solved(cases=[{"name": "G"}, {"name": "Q", "action": "variable"}, {"name": "S"}],
                   combine={"sets": ["ultimate", "characteristic"]})  # fmt: skip
    parts = page(render_report(found, chapters=["case"])).one("section", id="case").all("section")
    (section,) = (part for part in parts if part.one("h3").text == "Load cases")
    *_, table = section.all("table")
    assert [[cell.text for cell in row.all("td")] for row in table.one("tbody").all("tr")] == [
        ["G", "1", "ultimate", "1 to 1.35 (4 of 4)"],
        ["G", "1", "characteristic", "1 (2 of 2)"],
        ["Q", "1", "ultimate", "1.5 (2 of 4)"],
        ["Q", "1", "characteristic", "1 (1 of 2)"],
        ["S", "0", "ultimate", "1 to 1.35 (4 of 4)"],
        ["S", "0", "characteristic", "1 (2 of 2)"],
    ]
    assert 'Remark: case "S" has no loads.' in section.text


def test_a_force_without_a_column_lifts() -> None:
    """Uplift by hand: 1.5 x 100 kN that lift at a place of their own, against 0.9 x 480 kN."""
    loads = [
        {"kind": "uniform", "q": 20e3, "case": "G"},
        {"kind": "point", "P": -100e3, "x": 0, "y": 0, "case": "W"},
    ]
    cases = [{"name": "G"}, {"name": "W", "action": "variable"}]
    (check,) = check_design(solved(cases=cases, loads=loads, combine={"sets": ["uplift"]})).checks
    assert (check.name, check.status) == ("uplift by actions", "no failure found")
    assert (check.demand, check.resistance) == (pytest.approx(150.0), pytest.approx(432.0))
