"""Dowels across joints: resistances by TR34 in other forms and by hand, and the check of what a joint carries."""

from __future__ import annotations

import math
from typing import Any

import pytest

import groundslab as gs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.codes.floors import dowel_checks
from groundslab.design.codes.floors.dowels import Dowel, bending_resistance, shear_resistance
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import Results
from helpers.calculations import follow_steps

ROUND = {"diameter": 0.02, "spacing": 0.3, "opening": 0.01, "f_yk": 500e6}
PLATE = {"width": 0.15, "height": 0.008, "spacing": 0.6, "opening": 0.02, "f_yk": 355e6}
STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
FLOOR = {"kind": "TR34", "concrete": "C35/45", "f_R1": 2e6, "f_R4": 1.5e6}


@pytest.mark.parametrize("e", [0.0, 0.005, 0.02])
def test_a_round_dowel_that_bends(e: float) -> None:
    """TR34 writes d^2 (f_cd f_yd)^(1/2) ((1 + alpha^2)^(1/2) - alpha), alpha = 3 e / d (f_cd / f_yd)^(1/2)."""
    d, f_cd, f_yd = 0.02, 20e6, 435e6
    alpha = 3 * e / d * math.sqrt(f_cd / f_yd)
    by_hand = d**2 * math.sqrt(f_cd * f_yd) * (math.sqrt(1 + alpha**2) - alpha)
    assert bending_resistance(Dowel(d, None, f_yd), f_cd, e) == pytest.approx(by_hand)
    assert shear_resistance(Dowel(d, None, f_yd)) == pytest.approx(0.6 * 435e6 * 0.9 * math.pi * 0.02**2 / 4)


def test_a_plate_that_bends() -> None:
    """0.5 ((b_1^2 + c_1)^(1/2) - b_1) with b_1 = 2 e k_3 f_cd W, c_1 = 2 k_3 f_cd W^2 T^2 f_yd, k_3 = 3.

    So a maker of plates (Dewmark) quotes TR34, fourth edition, 6.5.
    """
    W, T, f_cd, f_yd, e = 150.0, 8.0, 20.0, 355 / 1.15, 10.0  # mm, MPa
    b_1 = 2 * e * 3 * f_cd * W
    by_hand = 0.5 * (math.sqrt(b_1**2 + 2 * 3 * f_cd * W**2 * T**2 * f_yd) - b_1)
    plate = Dowel(W / 1e3, T / 1e3, f_yd * 1e6)
    assert bending_resistance(plate, f_cd * 1e6, e / 1e3) == pytest.approx(by_hand)
    assert shear_resistance(plate) == pytest.approx(0.6 * f_yd * 0.9 * W * T)


def bays(dowels: dict[str, Any] | None, q: float = 30e3, **changes: Any) -> Results:
    """Return two bays of 4 m by 4 m, of which only the first is loaded, joined along 4 m."""
    sides = {"thickness": 0.5, "E": 30e12, "nu": 0.2}
    joint = {"kind": "elastic", "between": ("A", "B"), "stiffness": 1e8}
    parts: dict[str, Any] = {
        "plate": {"name": "A", "outline": {"kind": "rectangle", "x": (-4, 0), "y": (-2, 2)}} | sides,
        "plates": [{"name": "B", "outline": {"kind": "rectangle", "x": (0, 4), "y": (-2, 2)}} | sides],
        "ground": {"kind": "winkler", "k": 10e6},
        "joints": [joint if dowels is None else joint | {"dowels": dowels}],
        "cases": [{"name": "G"}],
        "loads": [
            {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
            {"kind": "uniform", "q": q, "plate": "A", "case": "G"},
        ],
        "combinations": [{"name": "low", "factors": {"G": 1.0}}, {"name": "high", "factors": {"G": 1.35}}],
        "reinforcement": STEEL,
        "mesh": {"size": 1.0},
    }
    return gs.solve(Model(**parts | changes))


def rows(name: str, of: Results) -> list[DesignCheck]:
    """Return the checks of a name."""
    return [each for each in check_design(of).checks if each.name == name]


@pytest.mark.parametrize("dowels", [ROUND, PLATE])
def test_dowels_of_a_joint(dowels: dict[str, Any]) -> None:
    """The largest force per length of the table times the spacing, over the resistance by hand, in the calculation."""
    of = bays(dowels)
    (check,) = rows(dowel_checks.DOWELS, of)
    table = next(each for each in gs.tables_of(of) if each.name == "joints")
    q = max(abs(float(value)) for value in table["greatest force per length"])
    assert q > 1
    assert (check.of, check.combination) == ("A - B", "high")
    assert check.demand == pytest.approx(q * dowels["spacing"])
    steel = dowels["f_yk"] / 1.15
    dowel = Dowel(dowels.get("diameter", dowels.get("width")), dowels.get("height"), steel)
    most = min(shear_resistance(dowel), bending_resistance(dowel, 20e6, dowels["opening"] / 2))
    assert check.resistance == pytest.approx(most / 1e3)
    known = follow_steps(check.steps)
    assert (known["eta"], known["P_R"]) == (pytest.approx(check.utilization), pytest.approx(most / 1e6))
    assert check.status == ("fails" if check.utilization > 1 else "no failure found")
    assert "bursting of the concrete at dowels is not checked" in check_design(bays(dowels, q=0.0)).headline


def test_dowels_that_are_too_far_apart_fail() -> None:
    """Twice the spacing is twice the force; under so much they fail."""
    one, two = (rows(dowel_checks.DOWELS, bays(ROUND | {"spacing": s}, q=60e3))[0] for s in (0.3, 0.6))
    assert two.demand == pytest.approx(2 * one.demand)
    (far,) = rows(dowel_checks.DOWELS, bays(ROUND | {"spacing": 2.0}, q=100e3))
    assert (far.status, far.utilization > 1) == ("fails", True)


def test_the_concrete_around_dowels() -> None:
    """That of the floor, else of the reinforcement; without either they are not checked."""
    (by_floor,) = rows(dowel_checks.DOWELS, bays(ROUND, floor=FLOOR))
    assert follow_steps(by_floor.steps)["f_cd"] == pytest.approx(35 / 1.5)
    (bare,) = rows(dowel_checks.DOWELS, bays(ROUND, reinforcement=None))
    assert (bare.status, bare.utilization) == ("attention", None)
    assert bare.words.startswith("not judged: neither [floor] by TR34 nor [reinforcement] gives the concrete")


def test_joints_without_dowels_are_told() -> None:
    """They are listed as not checked."""
    design = check_design(bays(None, q=0.0))
    assert 'what the joints "A - B" carry is not checked, as they have no dowels' in design.headline
    assert not rows(dowel_checks.DOWELS, bays(None))


@pytest.mark.parametrize(
    "dowels", [{"width": 0.1}, {"diameter": 0.02, "width": 0.1, "height": 0.01}, {"diameter": 0.02, "height": 0.01}, {}]
)
def test_dowels_are_round_or_plates(dowels: dict[str, float]) -> None:
    """A diameter, or width and height."""
    with pytest.raises(InputError, match="width and height of plates"):
        bays({"spacing": 0.3, "opening": 0.01, "f_yk": 500e6} | dowels)
