"""Each way in which checks end without a verdict: a case that rightly ends so, and the nearest one that is judged."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from groundslab.design.checks import Design, check_design
from groundslab.design.rules.check import UNJUDGED, Unjudged
from groundslab.model.model import Model
from helpers.solve_once import solve_once

STEEL: dict[str, Any] = {"f_ck": "30 MPa", "f_yk": "500 MPa", "bottom": ["40 mm", "60 mm"], "top": ["40 mm", "60 mm"]}
BARS = {layer: {"diameter": "16 mm", "spacing": "150 mm"} for layer in ("bottom_x", "bottom_y", "top_x", "top_y")}
ULS = {"name": "ULS", "limit_state": "ultimate", "factors": {"G": 1.35}}
QUASI = {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}}
LOAD = {"kind": "point", "case": "G", "column": "C", "P": 300e3}
WEIGHT = {"kind": "self weight", "case": "G", "unit_weight": 25e3}
COLUMN = {"name": "C", "x": 0.0, "y": 0.0, "width_x": 0.4, "width_y": 0.4}
PILE = {"kind": "point", "y": 0.6, "stiffness": "50 MN/m", "diameter": 0.3}


def slab(**changes: Any) -> Model:
    """Return a raft of 4 m by 4 m with a column in its middle."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 4.0, "length_y": 4.0, "thickness": 0.4, "E": 31e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 40e6},
        "columns": [COLUMN],
        "cases": [{"name": "G"}],
        "loads": [LOAD],
        "combinations": [ULS],
        "reinforcement": STEEL,
        "mesh": {"size": 0.5},
    }
    return Model(**parts | changes)


def made(model: Model) -> Design:
    """Return the checks of a model."""
    return check_design(solve_once(model))


def plate(*, sides: int) -> dict[str, Any]:
    """Return a plate with openings on so many sides of the column, which leave nothing all around it."""
    x_y = [((0.3, 0.6), (-0.6, 0.6)), ((-0.6, -0.3), (-0.6, 0.6)), ((-0.28, 0.28), (0.3, 0.6)),
           ((-0.28, 0.28), (-0.6, -0.3))]  # fmt: skip
    holes = [{"kind": "rectangle", "x": x, "y": y} for x, y in x_y[:sides]]
    return {"length_x": 4.0, "length_y": 4.0, "thickness": 0.4, "E": 31e9, "nu": 0.2, "openings": holes}


def crack_width(case: dict[str, Any]) -> dict[str, Any]:
    """Return a reinforcement with bars and so much besides."""
    return {"reinforcement": STEEL | BARS | case, "combinations": [ULS, QUASI]}


def dowels(**case: Any) -> dict[str, Any]:
    """Return two bays joined by dowels."""
    joint = {"kind": "elastic", "between": ("A", "B"), "stiffness": 150e6,
             "dowels": {"diameter": 0.02, "spacing": 0.3, "opening": 2e-3, "f_yk": 500e6}}  # fmt: skip
    bay = {"thickness": 0.4, "E": 31e9, "nu": 0.2}
    first = {"name": "A", "outline": {"kind": "rectangle", "x": (-2.0, 0.0), "y": (-2.0, 2.0)}, **bay}
    second = {"name": "B", "outline": {"kind": "rectangle", "x": (0.0, 2.0), "y": (-2.0, 2.0)}, **bay}
    wheel = {"kind": "point", "case": "G", "P": 60e3, "x": -0.5, "y": 0.0, "width_x": 0.3, "width_y": 0.3}
    return {"plate": first, "plates": [second], "joints": [joint], "columns": (), "loads": [wheel, WEIGHT],
            "mesh": {"size": 0.5}} | case  # fmt: skip


def lifted(P: float) -> dict[str, Any]:
    """Return a plate glued to springs, with a support and a force, in a combination of equilibrium."""
    return {
        "combinations": [{"name": "EQU", "limit_state": "equilibrium", "factors": {"G": 1.0}}],
        "reinforcement": None,
        "contact": {"tensionless": False},
        "loads": [LOAD | {"P": P}],
        "supports": [PILE | {"x": 0.5}],
    }


def beam(section: dict[str, Any]) -> dict[str, Any]:
    """Return a slab with a beam in its middle."""
    return {"beams": [{"name": "B", "points": [(-1.0, 0.0), (1.0, 0.0)], "section": section, "E": 31e9, "nu": 0.2}]}


#: Nowhere 2 d away from supports of unknown size.
POINTS = [{"kind": "point", "x": x, "y": y, "acts": "in compression"} for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
BAY = {"length_x": 2.4, "length_y": 2.4, "thickness": 0.8, "E": 31e9, "nu": 0.2}
ON_POINTS = {"plate": BAY, "columns": (), "loads": [WEIGHT], "supports": POINTS}
#: A plate whose edges are held, and what presses on it.
HELD = {"length_x": 4.0, "length_y": 4.0, "thickness": 0.4, "E": 31e9, "nu": 0.2, "support": "hinged"}
WATER = {"kind": "uniform", "case": "G", "q": 40e3}
GIVEN = {"kind": "properties", "second_moment": 1e-4, "torsion_constant": 1e-4, "shear_area": 0.01}
CONCRETE = {"kind": "rectangle", "width": 0.3, "height": 0.6}
#: By the reason: what of the slab differs where it is so, and where it is nearly so, and how the check is called.
FLOOR = {"kind": "TR34", "concrete": "C30/37"}
WHEEL = {"kind": "point", "case": "G", "P": 60e3, "x": 0.5, "y": 0.0}
CASES: dict[str, tuple[dict[str, Any], dict[str, Any], str]] = {
    "support-inside": (
        {"supports": [PILE | {"x": 0.0}], "loads": [LOAD | {"P": 4e6}]},
        {"supports": [PILE | {"x": 0.0}]},
        "punching within 2 d",
    ),
    "no-perimeter": ({"plate": plate(sides=4)}, {"plate": plate(sides=2)}, "punching within 2 d"),
    "no-footprint": (
        {"floor": FLOOR, "loads": [WHEEL]}, {"floor": FLOOR, "loads": [WHEEL | {"width_x": 0.2, "width_y": 0.2}]},
        "punching",
    ),
    "no-place": (ON_POINTS, ON_POINTS | {"plate": BAY | {"thickness": 0.3}}, "one-way shear"),
    "glued-to-the-ground": (lifted(-300e3), lifted(300e3), "static equilibrium"),
    "no-combination": (
        {"limits": {"settlement": 0.02}}, {"limits": {"settlement": 0.02}, "combinations": [ULS, QUASI]}, "settlement",
    ),
    "fewer-than-two-columns": (
        {"limits": {"angular_distortion": 0.02}, "combinations": [ULS, QUASI]},
        {"limits": {"angular_distortion": 0.02}, "combinations": [ULS, QUASI],
         "columns": [COLUMN, COLUMN | {"name": "D", "x": 1.5}]},
        "angular distortion",
    ),
    "section-by-its-properties": (beam(GIVEN), beam(CONCRETE), "beams"),
    "no-limit": (
        crack_width({"code": "EN 1992-1-1:2023"}),
        crack_width({"code": "EN 1992-1-1:2023", "w_max": 0.3e-3}),
        "crack width",
    ),
    "supported-edge": (
        {"plate": HELD, "columns": (), "loads": [WATER | {"q": -40e3}]},
        {"plate": HELD, "columns": (), "loads": [WATER]}, "edges that hold down",
    ),
    "no-bars": ({"reinforcement": STEEL | {"restraint": {}}}, crack_width({"restraint": {}}), "bars against restraint"),
    "bars-yield": (
        crack_width({"restraint": {}, "w_max": 0.3e-3} | {key: {"diameter": 0.006, "spacing": 0.3} for key in BARS}),
        crack_width({"restraint": {}, "w_max": 0.3e-3}),
        "crack width by restraint",
    ),
    "another-standard": (
        crack_width({"annex": "United Kingdom", "exposure": "XC2"}),
        crack_width({"annex": "Germany", "exposure": "XC2"}),
        "cover",
    ),
    "no-concrete": (dowels(reinforcement=None), dowels(), "dowels"),
}  # fmt: skip


def test_a_straight_piece_of_a_perimeter() -> None:
    """Openings on three sides leave a straight piece of the perimeter, which resists no moment (6.40 gives W = 0)."""
    (check,) = [each for each in made(slab(plate=plate(sides=3))).checks if each.unjudged is not None]
    assert check.name == "punching within 2 d without a perimeter"
    assert "straight" in check.words


@pytest.mark.parametrize("name", CASES)
def test_both_ways(name: str) -> None:
    """The one case ends without a verdict for that reason and for no other; the nearest one has none that does."""
    open_case, judged_case, about = CASES[name]
    design = made(slab(**open_case))
    ends = design.checks
    reasons = {each.unjudged.name: each for each in ends if each.unjudged is not None}
    assert name in reasons
    check = reasons[name]
    assert check.name.startswith(about)
    assert check.status == "attention"
    assert check.unjudged is not None
    assert check.words.startswith("not judged: ")
    assert check.words.endswith(check.unjudged.do)
    assert f"Not judged: {len([each for each in ends if each.unjudged])} of {len(ends)} (" in design.headline
    judged = made(slab(**judged_case)).checks
    assert name not in {each.unjudged.name for each in judged if each.unjudged is not None}


@pytest.mark.parametrize("load", [{"P": -10e3}, {"P": 0.0, "M_x": 10e3}])
def test_what_pulls_or_only_turns_is_judged(load: dict[str, float]) -> None:
    """A column that pulls at the slab, or turns it without a force, is judged as one that pushes is."""
    ends = made(slab(loads=[LOAD | load, WEIGHT])).checks
    assert not [each.words for each in ends if each.unjudged is not None]
    assert [each.of for each in ends if each.name == "punching within 2 d"] == ["C"]


def test_the_documentation_lists_them_all() -> None:
    """The table of docs/results.md has the names and what to do, in the same order."""
    text = (Path(__file__).parents[4] / "docs/results.md").read_text(encoding="utf-8")
    rows = re.findall(
        r"^\| `([a-z-]+)` \| .* \| (.*) \|$", text.partition("### Checks without a verdict")[2], re.MULTILINE
    )
    assert [Unjudged(*row) for row in rows[: len(UNJUDGED)]] == list(UNJUDGED)


def test_all_have_a_case() -> None:
    """Two are made elsewhere: a code without a rule (test_new_code), an unsolved combination (test_strength)."""
    assert {each.name for each in UNJUDGED} == CASES.keys() | {"no-rule", "no-certified-result"}
