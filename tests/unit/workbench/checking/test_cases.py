"""Load cases and combinations as the page shows them."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip("filelock")
from groundslab.workbench.checking.parsing import check
from groundslab.workbench.editing.document import Document

RAFT = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "20 MPa/m"
[[cases]]
name = "G"
[[cases]]
name = "Q"
action = "variable"
category = "B"
[[loads]]
kind = "self weight"
unit_weight = "25 kN/m^3"
case = "G"
[[loads]]
kind = "point"
P = "200 kN"
x = "-2 m"
y = "1 m"
case = "Q"
"""


def _cases(more: str) -> dict[str, Any]:
    found = check(Document(RAFT + more))
    assert found.issues == ()
    assert found.cases is not None
    return found.cases


def test_sums_and_combinations_by_hand() -> None:
    """25 * 6 * 4 * 0.25 = 150 kN, and 200 kN at (-2, 1) m; the quasi-permanent factor of offices is psi_2 = 0.3."""
    cases = _cases('[combine]\nsets = ["ultimate", "quasi-permanent"]\nexpression = "6.10a and 6.10b"\nxi = 0.9')
    weight, live = cases["cases"]
    assert weight == {"name": "G", "F": pytest.approx(150), "M_x": 0.0, "M_y": 0.0, "acts": True, "positions": []}
    assert live == {"name": "Q", "F": 200.0, "M_x": -400.0, "M_y": 200.0, "acts": True, "positions": []}
    assert (cases["about"], cases["force"], cases["moment"]) == ([0.0, 0.0], "kN", "kNm")
    rules = {(each["rule"], tuple(each["factors"].items())) for each in cases["made"]}
    assert ("EN 1990 6.10a", (("G", 1.35), ("Q", 1.05))) in rules
    assert ("EN 1990 6.10b", (("G", 1.215), ("Q", 1.5))) in rules
    assert ("EN 1990 6.16b", (("G", 1.0), ("Q", 0.3))) in rules


def test_listed_combinations_are_not_made() -> None:
    """Those that the file lists are not among those that are made; a case that none names does not act."""
    cases = _cases('[[combinations]]\nname = "C"\nfactors = { G = 1.35 }')
    assert cases["made"] == []
    assert [each["acts"] for each in cases["cases"]] == [True, False]


def test_each_case_by_itself() -> None:
    """Without combinations each case is one."""
    assert [each["factors"] for each in _cases("")["made"]] == [{"G": 1.0}, {"Q": 1.0}]


def test_a_case_that_moves_has_its_positions() -> None:
    """A wheel from (0, 0) to (1.5, 0) m in steps of 1 m: the places on its path by hand; the matrix has it once."""
    wheel = '[[patterns]]\nkind = "vehicle"\nname = "truck"\nwheels = [{ P = "10 kN" }]'
    path = '[[moves]]\npattern = "truck"\ncase = "Q"\npoints = [["0 m", "0 m"], ["1.5 m", "0 m"]]\nstep = "1 m"'
    cases = _cases(f"{wheel}\n{path}")
    positions = [f"Q at {way} m" for way in ("0.00", "1.00", "1.50")]
    assert [each["positions"] for each in cases["cases"]] == [[], positions]
    assert [each["name"] for each in cases["made"]] == ["G", "Q"]


def test_units_of_the_country_and_faults() -> None:
    """With US units sums are in kip and feet; of a case with issues nothing is known."""
    cases = _cases('[project]\nunits = "US"')
    assert (cases["force"], cases["moment"], cases["length"]) == ("kip", "kip ft", "ft")
    assert cases["cases"][1]["F"] == pytest.approx(200 / 4.4482216)
    assert check(Document(RAFT + "[combine]\nsets = []")).cases is None
