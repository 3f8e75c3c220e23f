"""Punching of isolated pads is judged by all codes wherever the perimeter all around lies on the pad."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.checks import check_design
from groundslab.design.demands.perimeter_loads import footprint_of
from groundslab.design.demands.perimeters import Openings, perimeter_at, surroundings
from groundslab.design.rules.check import DesignCheck
from groundslab.model.model import Model

#: A column of 0.4 m carries 1.35 x 800 kN; the depth is 0.5 m less the mean of 60 and 80 mm.
SIDE, FORCE, D = 0.4, 1.08, 0.43
BARS = {"diameter": "20 mm", "spacing": "100 mm"}


def punching(code: str) -> list[DesignCheck]:
    """Return the checks of punching of a pad of two meters."""
    made = check_design(gs.solve(pad(code, 2.0, 2.0))).checks
    return [each for each in made if "punching" in each.name or "two-way" in each.name]


def pad(code: str, length: float, width: float, counts: tuple[int, int] = (8, 8)) -> Model:
    """Return a pad of so many meters on stiff springs."""
    steel: dict[str, Any] = {
        "code": code, "f_ck": "25 MPa", "f_yk": "500 MPa", "bottom": ["60 mm", "80 mm"], "top": ["60 mm", "80 mm"],
        "bottom_x": BARS, "bottom_y": BARS, "top_x": BARS, "top_y": BARS,
    }  # fmt: skip
    return Model(
        plate={"length_x": length, "length_y": width, "thickness": 0.5, "E": 31e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=[{"name": "C", "x": 0, "y": 0, "width_x": SIDE, "width_y": SIDE}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "C", "P": 800e3}],
        combinations=[{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}],
        reinforcement=steel,
        mesh={"counts": counts},
    )


def test_by_en1992_2004() -> None:
    """At the face 1.51 of 3.6 MPa (6.4.5(3)), and within 2 d, which lies beyond the pad's edges all around.

    The pressure of 270 kPa under the column relieves its face: (1.08 - 0.16 x 0.27) / (1.6 x 0.43) MPa. Within 2 d
    v_Ed / v_Rd is largest near 0.8 d: 0.37 with an even pressure.
    """
    face, within = punching("EN 1992-1-1")
    assert (face.status, within.status) == ("no failure found", "no failure found")
    assert face.demand == pytest.approx((FORCE - SIDE**2 * FORCE / 4) / (4 * SIDE * D), rel=0.01)
    assert face.resistance == pytest.approx(0.4 * 0.6 * (1 - 25 / 250) * 25 / 1.5)
    a = 0.8 * D
    u, area = 4 * SIDE + 2 * math.pi * a, SIDE**2 + 4 * SIDE * a + math.pi * a**2
    v_Ed = FORCE * (1 - area / 4) / (u * D)
    v_Rd = 0.12 * (1 + math.sqrt(200 / 430)) * (100 * 31.4e-4 / D * 25) ** (1 / 3) * 2 * D / a
    assert within.demand is not None
    assert within.resistance is not None
    assert within.demand / within.resistance == pytest.approx(v_Ed / v_Rd, rel=0.03)


def test_by_en1992_2023() -> None:
    """b_0.5 is 4 x 0.4 + pi 0.43 = 2.95 m, the pressure relieves up to 0.67 d (8.4.2(2), (6)), beta_e is 1.05."""
    (check,) = punching("EN 1992-1-1:2023")
    assert check.status == "no failure found"
    a, u = 0.67 * D, 4 * SIDE + math.pi * D
    area = SIDE**2 + 4 * SIDE * a + math.pi * a**2
    assert check.demand == pytest.approx(1.05 * FORCE * (1 - area / 4) / (u * D), rel=0.02)


def test_by_aci318() -> None:
    """b_o = 4 (0.4 + 0.43) m (22.6.4.1), and phi v_c by a third of the root of f'c and lambda_s (22.6.5.2)."""
    (check,) = punching("ACI 318")
    b_o, area = 4 * (SIDE + D), (SIDE + D) ** 2
    assert check.demand == pytest.approx(FORCE * (1 - area / 4) / (b_o * D), rel=0.02)
    v_c = 0.75 * math.sqrt(2 / (1 + 0.004 * 430)) * math.sqrt(25) / 3
    assert check.resistance == pytest.approx(v_c, rel=0.01)


@pytest.mark.parametrize("code", ["EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318"])
def test_a_strip_no_wider_than_its_column(code: str) -> None:
    """On a strip of 0.4 m nothing runs around a column of 0.4 m: it is one-way shear, which is checked from d on.

    What the ground presses on the strip beyond the place is what is carried there, a little less in the middle of its
    width than at its edges.
    """
    results = gs.solve(pad(code, 6.0, 0.4, (60, 4)))
    made = check_design(results).checks
    around = [each for each in made if "punching" in each.name or "two-way" in each.name][-1]
    assert around.status == "no failure found"
    assert "cut the slab from edge to edge, which one-way shear judges" in around.words
    (shear,) = [each for each in made if each.name == "one-way shear"]
    assert shear.place is not None
    assert SIDE / 2 + D <= abs(shear.place[0]) + 1e-9 < SIDE / 2 + 1.5 * D
    plate = results["U"].plate
    middle = np.isclose(plate.nodes[:, 1], 0)
    x, p = plate.nodes[middle, 0], plate.pressure[middle]
    s = np.linspace(-3.0, -abs(shear.place[0]), 101)
    assert shear.demand == pytest.approx(np.trapezoid(np.interp(s, np.sort(x), p[np.argsort(x)]), s) / 1e3, rel=0.05)


@pytest.mark.parametrize("code", ["EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318"])
def test_pads_are_checked_across(code: str) -> None:
    """Beside punching, one-way shear at d from the face: 0.27 MPa on the 0.37 m beyond, over the whole width."""
    made = check_design(gs.solve(pad(code, 2.0, 2.0))).checks
    (shear,) = [each for each in made if each.name == "one-way shear"]
    assert shear.demand == pytest.approx(1e3 * FORCE / 4 * (1.0 - SIDE / 2 - D), rel=0.02)
    assert shear.steps[0].words == "shear force, mean over the cut"


@pytest.mark.parametrize("code", ["EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318"])
def test_a_wide_column_at_the_edge_of_a_pad(code: str) -> None:
    """On a pad of 4 m straight across is shorter than around three sides of 1.2 m and pi a; both are checked."""
    model = pad(code, 4.0, 4.0)
    column = model.columns[0].replace(x=1.4, width_x=1.2, width_y=1.2)
    weight = gs.SelfWeight(unit_weight=100e3, case="G")
    results = gs.solve(model.replace(columns=(column,), loads=(*model.loads, weight)))
    made = check_design(results).checks
    of_column = [each for each in made if "punching" in each.name or "two-way" in each.name]
    assert of_column
    assert all(each.demand is not None and "edge to edge" not in each.words for each in of_column)
    assert any(each.name == "one-way shear" for each in made)
    around = surroundings(results["U"].plate, footprint_of(column), 1.0, Openings())
    for a in (D / 2, 2 * D):
        assert perimeter_at(around, a).u == pytest.approx(3 * 1.2 + math.pi * a, rel=1e-3)


@pytest.mark.parametrize("code", ["EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318"])
def test_a_force_on_the_footprint_is_the_columns(code: str) -> None:
    """A force on the footprint that names no column punches as one that does, with the moment of its distance.

    800 kN 50 mm off the center are 800 kN and 40 kNm.
    """
    named = pad(code, 2.0, 2.0)
    there = {"kind": "point", "case": "G", "P": 800e3, "x": 0.05, "y": 0, "width_x": 0.2, "width_y": 0.2}
    as_column = {"kind": "point", "case": "G", "P": 800e3, "M_x": 40e3, "column": "C"}
    every = [
        [each for each in check_design(gs.solve(named.replace(loads=[load]))).checks if "punching" in each.name
         or "two-way" in each.name]
        for load in (there, as_column)
    ]  # fmt: skip
    for by_place, by_name in zip(*every, strict=True):
        assert by_place.demand is not None
        assert by_place.demand == pytest.approx(by_name.demand, rel=0.01)


@pytest.mark.parametrize("between", [("A", "B"), ("B", "A")])
def test_what_hangs_on_a_joint_punches(between: tuple[str, str]) -> None:
    """A bay of 3 m by 1 m without ground hangs on a slab beside its column: half of its 300 kN are inside at 2 d.

    The other half is on a line support. The pressure inside, which the joint raises as well, takes off.
    """
    slab = {"thickness": 0.5, "E": 31e9, "nu": 0.2}
    model = pad("EN 1992-1-1", 6.0, 6.0).replace(
        plate={"name": "A", "outline": {"kind": "rectangle", "x": (-3.0, 3.0), "y": (-3.0, 3.0)}, **slab},
        plates=[{"name": "B", "outline": {"kind": "rectangle", "x": (3.0, 6.0), "y": (-0.5, 0.5)}, **slab}],
        joints=[{"kind": "hinge", "between": between}],
        contact={"voids": [{"x": (3.0, 6.0), "y": (-0.5, 0.5)}]},
        supports=[{"kind": "line", "points": [(6.0, -0.5), (6.0, 0.5)], "acts": "in compression"}],
        columns=[{"name": "C", "x": 2.8, "y": 0, "width_x": SIDE, "width_y": SIDE}],
        loads=[{"kind": "point", "case": "G", "column": "C", "P": 800e3},
               {"kind": "uniform", "case": "G", "plate": "B", "q": 100e3}],
        mesh={"size": 0.5},
    )  # fmt: skip
    table = next(each for each in gs.tables_of(gs.solve(model)) if each.name == "columns")
    found = {column.name: column.values[0] for column in table.columns}
    assert found["other loads inside"] == pytest.approx(1.35 * 150, rel=1e-3)
    assert found["V_Ed"] == pytest.approx(1.35 * (800 + 150) - found["pressure inside"], rel=1e-3)
