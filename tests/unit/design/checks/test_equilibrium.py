"""Equilibrium and uplift: slabs that float or overturn, and forces upwards and downwards by hand."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.analysis.driver import solve, solve_combinations
from groundslab.design.checks import DesignCheck, check_design
from groundslab.model.model import Model

#: A slab of 6 m x 4 m x 0.3 m, 7.5 kPa.
SLAB: dict[str, Any] = {
    "plate": {"length_x": 6, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 20e6},
    "mesh": {"counts": (6, 4)},
}
WEIGHT = {"kind": "self weight", "unit_weight": 25e3, "case": "G"}


def uplift(q: float, **changes: Any) -> DesignCheck:
    """Return the check of the slab under so much water pressure [Pa]."""
    parts = {
        "cases": [{"name": "G"}, {"name": "water"}],
        "loads": [WEIGHT, {"kind": "uniform", "q": -q, "case": "water"}],
        "combine": {"sets": ["uplift", "quasi-permanent"]},
    }
    checks = check_design(solve(Model(**SLAB | parts | changes))).checks
    (check,) = [check for check in checks if check.name == "uplift by actions"]
    return check


def test_uplift_by_hand() -> None:
    """Against 0.9 x 7.5 x 24 = 162 kN, 6 kPa of water lift with 144 kN, and 7 kPa with 168 kN."""
    check = uplift(6e3)
    assert (check.name, check.status) == ("uplift by actions", "no failure found")
    assert (check.demand, check.resistance) == (pytest.approx(144), pytest.approx(162))
    check = uplift(7e3)
    assert check.status == "fails"
    assert check.words.startswith('none in "UPL 3": the loads do not press the plate down: their sum is -6 kN')
    assert check.foundation
    assert (check.demand, check.resistance) == (pytest.approx(168), pytest.approx(162))
    assert check.combination == "UPL 3"


def test_glued_ground_hides_no_uplift() -> None:
    """Glued to the ground: 1 x 40 x 24 = 960 kN against 0.9 x 7.5 x 24 = 162 kN fail 5.93 times."""
    check = uplift(40e3, contact={"tensionless": False})
    assert (check.name, check.status, check.combination) == ("uplift by actions", "fails", "UPL 3")
    assert (check.demand, check.resistance) == (pytest.approx(960), pytest.approx(162))
    assert check.utilization == pytest.approx(5.926, abs=1e-3)
    assert uplift(6e3, contact={"tensionless": False}).status == "no failure found"
    supports = [{"kind": "point", "x": 0, "y": 0, "stiffness": 50e6}]
    assert uplift(7e3, contact={"tensionless": False}, supports=supports, mesh={"size": 1.0}).status == "attention"


def glued(P: float, x: float, state: str = "ultimate", **changes: Any) -> dict[str, DesignCheck]:
    """Return the checks of the slab, glued to the ground, under its weight and a force [N] on its middle line."""
    parts = {
        "contact": {"tensionless": False},
        "cases": [{"name": "G"}],
        "loads": [WEIGHT, {"kind": "point", "P": P, "x": x, "y": 0.0, "case": "G"}],
        "combinations": [{"name": "C", "limit_state": state, "factors": {"G": 1.0}}],
        "mesh": {"size": 1.0},
    }
    return {check.name: check for check in check_design(solve(Model(**SLAB | parts | changes))).checks}


@pytest.mark.parametrize("state", ["ultimate", "accidental", "characteristic", "equilibrium", "uplift"])
def test_only_ground_in_tension_balances_the_loads(state: str) -> None:
    """-100 kN at x = 2.6 m leave 80 kN at -260 / 80 = -3.25 m, beyond the edge at -3 m; -85 kN leave 95 kN at -2.33 m.

    So it is in every limit state: the one topples without glue, the other does not. Where the ground pulls is said.
    """
    fails = [check for check in glued(-100e3, 2.6, state).values() if check.status == "fails"]
    assert [check.foundation for check in fails] == [True]
    assert all(check.status != "fails" for check in glued(-85e3, 2.6, state).values())
    if state in ("equilibrium", "uplift"):
        assert "only ground that pulls at the plate, to which it is glued, balances" in fails[0].words
    else:
        assert fails[0].name == "ground in tension"
        assert fails[0].words.endswith("only that balances the loads")
        assert fails[0].place is not None
        assert fails[0].place[0] == pytest.approx(2.6, abs=0.5)


def test_ground_that_pulls_though_the_loads_press() -> None:
    """In ultimate combinations it needs attention, with share and place; where nothing pulls there is no row."""
    check = glued(-85e3, 2.6)["ground in tension"]
    assert check.status == "attention"
    assert check.words.startswith('in "C" the ground pulls at ')
    assert check.words.endswith("set contact.tensionless = true")
    assert "ground in tension" not in glued(0.0, 2.6)
    assert "ground in tension" not in glued(-85e3, 2.6, contact={"tensionless": True})
    supports = [{"kind": "point", "x": 2.6, "y": 0.0, "stiffness": 1e6}]
    assert glued(-100e3, 2.6, supports=supports)["ground in tension"].status == "attention"


SHEAR_GROUND = {"ground": {"kind": "pasternak", "k0": 20e6, "k1": 10e6}}
OPTIONS: dict[str, dict[str, Any]] = {
    "none": {},
    "glued": {"contact": {"tensionless": False}},
    "limit pressure": {"contact": {"limit_pressure": 200e3}},
    "stiff plate": {"plate": SLAB["plate"] | {"E": 3e12}},
    "stiff springs": {"ground": {"kind": "winkler", "k": 2e9}},
    "ground with shear": SHEAR_GROUND,
    "ground beyond": SHEAR_GROUND | {"beyond": {"kind": "infinite"}},
    "anchors": {"supports": [{"kind": "point", "x": x, "y": y, "stiffness": 50e6} for x in (-2, 2) for y in (-1, 1)]},
    "clamped edges": {"plate": SLAB["plate"] | {"support": "clamped"}},
    "clamped edge": {"plate": SLAB["plate"] | {"edges": {"left": "clamped"}}},
    "hinged edge": {"plate": SLAB["plate"] | {"edges": {"left": "hinged"}}},
    "line": {"supports": [{"kind": "line", "points": [(x, -2.0), (x, 2.0)]} for x in (-2.0, 2.0)]},
}


@pytest.mark.parametrize("option", OPTIONS)
@pytest.mark.parametrize("load", ["floats", "topples"])
def test_options_hide_no_failure(option: str, load: str) -> None:
    """Water of 9 kPa under 7.5 kPa, or 100 kN that pull at x = 2.6 m: a failure, or attention to what holds it down."""
    lifting: dict[str, Any] = {
        "floats": {"kind": "uniform", "q": -9e3, "case": "G"},
        "topples": {"kind": "point", "P": -100e3, "x": 2.6, "y": 0.0, "case": "G"},
    }
    parts = {
        "cases": [{"name": "G"}],
        "loads": [WEIGHT, lifting[load]],
        "combinations": [{"name": "C", "limit_state": "ultimate", "factors": {"G": 1.0}}],
        "mesh": {"size": 1.0},
    }
    design = check_design(solve_combinations(Model(**SLAB | parts | OPTIONS[option])))
    if "clamped" in option:
        (check,) = [each for each in design.checks if each.name == "edges that hold down"]
        assert design.status == check.status == "attention"
        assert check.words.startswith("not judged: ")
    elif "supports" in OPTIONS[option]:
        (check,) = [each for each in design.checks if each.name == "supports that hold down"]
        assert design.status == check.status == "attention"
        assert check.words.startswith("not judged: what holds the plate down has no limit, ")
    else:
        assert design.status == "fails"
        assert design.checks[0].foundation


def test_supports_that_hold_the_slab_down() -> None:
    """With anchors the analysis alone decides: no forces are compared, in which theirs would be missing."""
    anchors = [{"kind": "point", "x": x, "y": y, "stiffness": 50e6} for x in (-2, 2) for y in (-1, 1)]
    check = uplift(7e3, supports=anchors, mesh={"size": 1.0})
    assert (check.status, check.utilization) == ("no failure found", None)


def test_overturning_by_hand() -> None:
    """Of 180 kN 0.9 are 162 kN: 1.5 x 320 kNm act within its half length of 3 m, 1.5 x 330 kNm do not."""
    for moment, status in ((320e3, "no failure found"), (330e3, "fails")):
        wind = {"kind": "point", "P": 0, "M_x": moment, "x": 0, "y": 0, "width_x": 1, "width_y": 1, "case": "wind"}
        case = {"name": "wind", "action": "variable"}
        model = Model(
            **SLAB, cases=[{"name": "G"}, case], loads=[WEIGHT, wind],
            combine={"sets": ["equilibrium", "characteristic"]},
        )  # fmt: skip
        (check,) = check_design(solve(model)).checks
        assert (check.name, check.status) == ("static equilibrium", status)


def test_nothing_without_such_combinations() -> None:
    """A case without the two limit states has no such check."""
    model = Model(**SLAB, loads=[{"kind": "uniform", "q": 1e3}])
    assert check_design(solve(model)).checks == ()
