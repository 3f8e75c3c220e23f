"""One-way shear beside walls and beside the slab's edge, held against rigid strips whose forces are known by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.one_way_shear.faces import bearers, pressing
from groundslab.design.demands.edge_strip import line_force_share, spread_edge_force, strip_width
from groundslab.model.model import Model
from groundslab.results.records import Constants
from groundslab.results.results import Results
from helpers import synthetic
from helpers.calculations import follow_steps
from helpers.solve_once import solve_once

STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
D = 0.4 - 0.045
B = 2.4
WALL = {"kind": "line", "q": 300e3, "points": [(-3, 0.3), (3, 0.3)], "case": "G"}
RIGID = 1e15


def strip(loads: list[dict[str, Any]], factors: dict[str, float], **changes: Any) -> Model:
    """Return a rigid strip of 6 x 2.4 x 0.4 m on springs with loads of two cases, and one ultimate combination."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 6, "length_y": B, "thickness": 0.4, "E": RIGID, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "cases": [{"name": "G"}, {"name": "W", "action": "variable"}],
        "loads": loads,
        "combinations": [{"name": "ULS", "factors": factors}],
        "reinforcement": STEEL,
        "mesh": {"size": 0.3},
    }
    return Model(**parts | changes)


def shear_of(combined: Results) -> DesignCheck:
    """Return the check of one-way shear."""
    return next(each for each in check_design(combined).checks if each.name == "one-way shear")


def test_shear_begins_at_d_from_a_wall_on_its_worse_side() -> None:
    """A wall 0.3 m off the middle: p = q / B (1 + 12 e y / B^2), v is what presses beyond d on either side.

    450 kN/m make 161.4 kN/m at d on the side of the nearer edge, 130.5 kN/m on the other one.
    """
    q, e = 1.5 * 300e3, 0.3

    def beyond(y: float, edge: float) -> float:
        return q / B * abs(edge - y + 12 * e / B**2 * (edge**2 - y**2) / 2)

    near, far = beyond(e + D, B / 2), beyond(e - D, -B / 2)
    assert (near / 1e3, far / 1e3) == pytest.approx((161.4, 130.5), abs=0.1)
    check = shear_of(solve_once(strip([WALL], {"G": 1.5})))
    assert check.demand == pytest.approx(near / 1e3, rel=0.01)
    assert check.place is not None
    assert check.place[1] == pytest.approx(e + D)


def test_shear_begins_at_d_from_the_faces_of_a_thick_wall() -> None:
    """With half of 0.2 m more on either side, 134.4 kN/m are left on the side of the nearer edge."""
    q, e, half = 1.5 * 300e3, 0.3, 0.1
    y = e + D + half
    near = q / B * (B / 2 - y + 12 * e / B**2 * ((B / 2) ** 2 - y**2) / 2)
    wall = {"name": "W", "thickness": 2 * half, "points": WALL["points"]}
    on_wall = {"kind": "line", "q": 300e3, "wall": "W", "case": "G"}
    check = shear_of(solve_once(strip([on_wall], {"G": 1.5}, walls=[wall])))
    assert near / 1e3 == pytest.approx(134.4, abs=0.1)
    assert check.demand == pytest.approx(near / 1e3, rel=0.01)
    assert check.place is not None
    assert check.place[1] == pytest.approx(y)


CODES = ("EN 1992-1-1", "ACI 318", "EN 1992-1-1:2023")


@pytest.mark.parametrize("code", CODES)
def test_shear_begins_at_d_from_a_line_support(code: str) -> None:
    """A slab of 1 m on supports 5 m apart, under 400 kPa: v = 400 (2.5 - d) = 618 kN/m at d from their axes.

    Nearer than 2 d = 1.91 m no other check looks. Without nu the slab bends as a strip.
    """
    supports = [{"kind": "line", "points": [(x, -3), (x, 3)], "acts": "in compression"} for x in (-2.5, 2.5)]
    model = strip(
        [{"kind": "uniform", "q": 400e3, "case": "G"}], {"G": 1.0},
        plate={"length_x": 6, "length_y": 6, "thickness": 1.0, "E": 31e9, "nu": 0.0},
        ground={"kind": "winkler", "k": 1e3}, supports=supports, reinforcement={**STEEL, "code": code},
    )  # fmt: skip
    check = shear_of(solve_once(model))
    assert check.demand == pytest.approx(400 * (2.5 - (1.0 - 0.045)), rel=0.01)


def test_columns_without_a_force_hide_no_shear() -> None:
    """Columns along a wall that carry nothing punch nothing: 161.4 kN/m at d from the wall, as without them."""
    columns = [{"name": f"C{x}", "x": x, "y": 0.3, "width_x": 0.2, "width_y": 0.2} for x in range(-2, 3)]
    check = shear_of(solve_once(strip([WALL], {"G": 1.5}, columns=columns)))
    assert check.demand == pytest.approx(161.4, rel=0.01)


@pytest.mark.parametrize("code", CODES)
def test_thinner_slab_near_a_column_counts(code: str) -> None:
    """A block of 1 m across a strip of 0.25 m, below a column as wide, under 960 kN / (6 x 1.5 m2) from the ground.

    Beyond d from the block v = 106.7 (3 - 0.6 - 0.205) = 234 kN/m, which is read at a node up to 0.1 m farther out; the
    column's own depth of 0.955 m is none of the strip's.
    """
    block = {"thickness": 1.0, "shape": {"kind": "rectangle", "x": (-0.6, 0.6), "y": (-0.75, 0.75)}}
    model = strip(
        [{"kind": "point", "P": 960e3, "column": "C", "case": "G"}], {"G": 1.0},
        plate={"length_x": 6, "length_y": 1.5, "thickness": 0.25, "E": RIGID, "nu": 0.0, "zones": [block]},
        columns=[{"name": "C", "x": 0, "y": 0, "width_x": 0.4, "width_y": 1.5}],
        reinforcement={**STEEL, "code": code}, mesh={"size": 0.2},
    )  # fmt: skip
    p, d = 960 / (6 * 1.5), 0.25 - 0.045
    check = shear_of(solve_once(model))
    assert check.demand is not None
    assert p * (3 - 0.6 - d - 0.1) * 0.99 < check.demand < p * (3 - 0.6 - d) * 1.01


def test_shear_counts_up_to_a_wall_that_pulls() -> None:
    """A wall that pulls 100 kN/m out of a slab under 100 kPa: the force nearer than d counts (ACI 7.4.3.2(a))."""
    loads = [{"kind": "uniform", "q": 100e3, "case": "G"}, {**WALL, "q": -100e3, "case": "W"}]
    check = shear_of(solve_once(strip(loads, {"G": 1.0, "W": 1.0})))
    assert check.place is not None
    assert abs(check.place[1] - 0.3) < D - 0.01


def test_the_sum_of_loads_on_a_piece_of_a_line_decides() -> None:
    """100 kN/m all along and -150 kN/m on one half: only the other half presses; a footprint does by its sum."""
    half = {**WALL, "q": -150e3, "points": [(0, 0.3), (3, 0.3)], "case": "W"}
    leg = {"kind": "point", "P": 50e3, "x": 0, "y": -0.6, "width_x": 0.2, "width_y": 0.2, "case": "G"}
    model = strip([{**WALL, "q": 100e3}, half, leg, {**leg, "P": -60e3, "case": "W"}], {"G": 1.0, "W": 1.0})
    every = bearers(model)
    (combination,) = model.combinations
    for factors, spans in ((combination.factors, [(-3.0, 0.0)]), ((("G", 1.0),), [(-3.0, 0.0), (0.0, 3.0)])):
        results = synthetic.results(2, model=model, factors=factors)
        shapes = [every[position].shape for position in pressing(results, every)]
        lines = sorted(shape.bounds[::2] for shape in shapes if shape.geom_type == "LineString")
        assert lines == spans
        assert any(shape.area > 0 for shape in shapes) == (len(spans) == 2)


K0, K1, Q = 10e6, 40e6, 500e3


@cache
def edge_walls(relieves: bool = False) -> Results:
    """Return a rigid plate of 16 x 8 m with a wall 0.5 m inside each long edge, on ground with shear."""
    walls = [{"kind": "line", "q": Q, "points": [(-8, y), (8, y)], "case": "G"} for y in (-3.5, 3.5)]
    model = strip(
        walls, {"G": 1.0},
        plate={"length_x": 16, "length_y": 8, "thickness": 0.4, "E": RIGID, "nu": 0.2},
        ground={"kind": "pasternak", "k0": K0, "k1": K1}, beyond={"kind": "infinite"}, mesh={"size": 0.5},
        combinations=[{"name": "ULS", "factors": {"G": 1.0}},
                      {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0}}],
        reinforcement={**STEEL, "line_force_relieves": relieves},
        limits={"pressure": 400e3}, soil_strength={"phi": 30, "unit_weight": 18e3},
    )  # fmt: skip
    return solve_once(model)


def test_the_line_force_along_the_edge_relieves_no_shear() -> None:
    """Along a rigid plate's edge f = (k0 k1)^(1/2) w takes f off the shear inside a wall, at s = 0.5 m + d.

    Spread over b = (k1/k0)^(1/2) = 2 m only f s / b of it lies ahead of the cut. The file can let it relieve.
    """
    combined, results = edge_walls(), edge_walls()["ULS"]
    f, s, b = math.sqrt(K0 * K1) * float(results.plate.settlement.mean()), 0.5 + D, math.sqrt(K1 / K0)
    assert strip_width(results) == pytest.approx(b) == pytest.approx(2.0)
    with_it, spread = (plate.value_at("shear_y", 0.0, 4 - s) for plate in (results.plate, spread_edge_force(results)))
    assert with_it > 0
    assert spread - with_it == pytest.approx(f * (1 - s / b), rel=0.01)
    counted, relieved = shear_of(combined), shear_of(edge_walls(True))
    assert 'm in "ULS", with the line force along the edge as pressure on a strip, is ' in counted.words
    assert "strip" not in relieved.words
    assert counted.demand is not None
    assert relieved.demand is not None
    assert counted.demand > max(spread / 1e3, relieved.demand)


def test_the_line_force_is_pressure_for_limits_and_whole_for_bearing() -> None:
    """In the middle of an edge k0 w + f / b = 2 k0 w press; all of the load does on the ground in bearing."""
    combined = edge_walls()
    found = {each.name: each for each in check_design(combined).checks}
    plate = combined["SLS"].plate
    w, spread = float(plate.settlement.mean()), spread_edge_force(combined["SLS"])
    middle = np.hypot(plate.nodes[:, 0], plate.nodes[:, 1] - 4).argmin()
    assert spread.pressure[middle] == pytest.approx(2 * K0 * w, rel=0.01)
    pressure = found["pressure"]
    assert pressure.demand == pytest.approx(spread.pressure.max() / 1e3)
    assert pressure.demand > 1.9 * plate.pressure.max() / 1e3
    assert "of the edge's line force over 2 m" in pressure.words
    known = follow_steps(pressure.steps)
    assert known["p_max"] == pytest.approx(known["p"] + known["f"] / 2.0)
    assert known["p"] == pytest.approx(K0 * w / 1e3, rel=0.02)
    assert known["p_max"] == pytest.approx(pressure.demand)
    assert found["bearing resistance"].demand == pytest.approx(2 * 16 * Q / 1e3, rel=1e-6)


def test_much_line_force_needs_attention() -> None:
    """Its share is what the ground's pressure, k0 w A, leaves of the load: above 10 % a row says so."""
    combined = edge_walls()
    (row,) = [each for each in check_design(combined).checks if each.name == "edge line force"]
    results = combined["ULS"]
    w = float(results.plate.settlement.mean())
    share = 1 - K0 * w * 16 * 8 / (2 * 16 * Q)
    assert row.status == "attention"
    assert row.demand == pytest.approx(100 * share, rel=0.01)
    assert line_force_share(results) == pytest.approx(share, rel=0.01)
    springs = check_design(solve_once(strip([WALL], {"G": 1.0})))
    assert "edge line force" not in {each.name for each in springs.checks}


def test_a_line_force_spread_over_a_strip_stays_as_large() -> None:
    """What pressure is added together is the line force; shear changes by f (1 - s / b) across the nearest edge."""
    one = synthetic.results(24, shear=True, lifts=False)
    one = replace(one, constants=Constants((synthetic.K0,), (synthetic.K1,), None, 0))
    spread, b = spread_edge_force(one), strip_width(one)
    assert b == pytest.approx(math.sqrt(synthetic.K1 / synthetic.K0))
    # nodes 0.15 m apart across the strip: its border is met to half of that, 6 % of its width
    added = float((spread.pressure - one.plate.pressure) @ one.plate.area)
    assert added == pytest.approx(float(one.plate.line_force @ one.plate.edge_length), rel=0.06)
    x, y = one.plate.nodes.T
    node = int(np.hypot(x + synthetic.LENGTH_X / 2 - 0.4, y).argmin())
    edge = int(np.hypot(x + synthetic.LENGTH_X / 2, y).argmin())
    change = spread.shear_x[node] - one.plate.shear_x[node]
    assert change == pytest.approx(-one.plate.line_force[edge] * (1 - 0.4 / b))
    assert spread.shear_y[node] == one.plate.shear_y[node]


def test_the_line_force_is_spread_the_same_at_some_nodes() -> None:
    """Shear forces at every seventh node are those of the whole plate; the others are left as they are."""
    results = edge_walls()["ULS"]
    some = np.arange(0, len(results.plate.nodes), 7)
    whole, part = spread_edge_force(results), spread_edge_force(results, some)
    others = np.setdiff1d(np.arange(len(results.plate.nodes)), some)
    for name in ("shear_x", "shear_y", "pressure"):
        assert getattr(part, name)[some] == pytest.approx(getattr(whole, name)[some])
        assert (getattr(part, name)[others] == getattr(results.plate, name)[others]).all()
    assert not np.allclose(whole.shear_y[some], results.plate.shear_y[some])
