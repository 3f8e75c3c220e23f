"""Punching at ends and corners of walls in checks and tables, of shear forces that are a formula, by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import punching
from groundslab.design.rules.check import DesignCheck
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.report.drawings.perimeter_tables import tables_of_pieces
from groundslab.views.tables.calculations import perimeters
from groundslab.views.tables.result_tables import table_makers
from groundslab.views.tables.table import Table
from helpers import synthetic
from helpers.calculations import follow_steps
from helpers.synthetic import LENGTH_X, LENGTH_Y

H, D, T, C = 0.5, 0.455, 0.4, 90e3
ALONG = T  # a_1 / 2: half of 2 b
W = {"name": "W", "thickness": T, "points": [(-3, 0), (0, 0)]}
#: A load that presses at the end of the wall in the middle of the plate and not at its start.
LOAD = {"kind": "line", "q": 0.0, "q_end": 100e3, "wall": "W", "case": "G"}


def results(code: str = "EN 1992-1-1", q: float = C, **changes: Any) -> Results:
    """Return results whose shear forces are -q r from the end of a wall in the middle, 10 % less on a coarser mesh."""
    parts: dict[str, Any] = {
        "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "walls": [W],
        "cases": [{"name": "G"}],
        "loads": [LOAD],
        "combinations": [{"name": "ULS", "factors": {"G": 1.35}}],
        "reinforcement": {"code": code, "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
    }
    model = Model(**parts | changes)
    one = synthetic.results(24, model=model, combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    x, y = one.plate.nodes.T
    plate = replace(one.plate, shear_x=-q * x, shear_y=-q * y)
    coarser = replace(plate, shear_x=-0.9 * q * x, shear_y=-0.9 * q * y)
    found = synthetic.compared(replace(one, plate=plate), coarser)
    return Results(model, model.combinations, {"ULS": found}, {})


def at(a: float) -> tuple[float, float]:
    """Return u [m] and the force [N] at a distance from the end's faces."""
    return T + 2 * ALONG + math.pi * a, C * (2 * ALONG * (T / 2 + a) + T * a + math.pi * a**2 + T * a)


def of_walls(checks: Any) -> DesignCheck:
    """Return the check of walls' ends."""
    (check,) = (each for each in checks if "walls' ends" in each.name)
    return check


def table_of(combined: Results) -> Table:
    """Return the table of punching at ends and corners of walls."""
    return table_makers(combined)["wall_punching"]()


def row_of(table: Table, number: int = 0) -> dict[str, Any]:
    """Return a row by the names of its columns."""
    return dict(zip([column.name for column in table.columns], table.rows()[number], strict=True))


@pytest.mark.parametrize(("code", "a"), [("EN 1992-1-1", 2 * D), ("ACI 318", D / 2), ("EN 1992-1-1:2023", D / 2)])
def test_the_pieces_of_its_perimeter_bear_the_force(code: str, a: float) -> None:
    """By hand: c (t / 2 + a) l along both sides, c a t across the end, of arcs (c r . n) their length by its mean.

    On a quarter circle r . n = a + t / 2 sin w, so that it bears c (pi / 2 a^2 + t / 2 a).
    """
    ((_, sketch),) = perimeters(results(code)).items()
    straight = [piece for piece in sketch.pieces if piece.radius is None]
    arcs = [piece for piece in sketch.pieces if piece.radius is not None]
    forces = [C * (T / 2 + a) * ALONG, C * (T / 2 + a) * ALONG, C * a * T]
    assert [piece.shear for piece in straight] == pytest.approx(forces, rel=1e-6)
    assert [piece.shear for piece in arcs] == pytest.approx([C * (math.pi / 2 * a**2 + T / 2 * a)] * 2, rel=1e-4)
    assert [piece.radius for piece in arcs] == pytest.approx([a, a])
    u, V = at(a)
    assert sum(piece.length for piece in sketch.pieces) == pytest.approx(u, rel=3e-5)
    assert sum(piece.shear or 0.0 for piece in sketch.pieces) == pytest.approx(V, rel=1e-4)
    (table,) = tables_of_pieces(sketch, {"u", "b_o", "b_05", "V_Ed", "V_u"})
    assert float(table.rows[-1][-1].text) == pytest.approx(V / 1e6, rel=1e-4)


def test_punching_by_en_1992() -> None:
    """The force grows faster than the resistance falls: at 2 d beta V / (u d) over C_Rd,c k (100 rho f_ck)^(1/3)."""
    combined = results()
    u, V = at(2 * D)
    v_Ed = 1.35 * V / (u * D) / 1e6
    v_Rd = 0.18 / 1.5 * (1 + math.sqrt(200 / (D * 1e3))) * (100 * 0.02 * 30) ** (1 / 3)
    check = of_walls(punching.checks(combined))
    assert check.name == "punching at walls' ends within 2 d"
    assert check.status == "no failure found"
    assert (check.of, check.combination, check.place) == ("end of W", "ULS", (0, 0))
    assert check.demand == pytest.approx(v_Ed, rel=2e-3)
    assert check.resistance == pytest.approx(v_Rd, rel=1e-6)
    assert check.error == pytest.approx(0.1 * v_Ed, rel=2e-3)
    row = row_of(table_of(combined))
    assert (row["combination"], row["wall"], row["place"], row["x"], row["y"]) == ("ULS", "W", "end", 0, 0)
    assert (row["d"], row["a"], row["beta"]) == pytest.approx((1e3 * D, 2 * D, 1.35))
    assert (row["u at a"], row["V_Ed at a"]) == pytest.approx((u, V / 1e3), rel=2e-3)
    assert row["v_Ed / v_Rd"] == pytest.approx(v_Ed / v_Rd, rel=2e-3)
    assert row["error of v_Ed / v_Rd"] == pytest.approx(0.1 * v_Ed / v_Rd, rel=2e-3)


def test_two_way_shear_by_aci_318() -> None:
    """At d / 2: beta V / (b_o d) over 0.75 times 0.33 lambda_s f'c^(1/2), of a loaded area b by b."""
    combined = results("ACI 318")
    b_o, V = at(D / 2)
    v_u = 1.35 * V / (b_o * D) / 1e6
    phi_v_c = 0.75 * 0.33 * math.sqrt(2 / (1 + 0.004 * D * 1e3)) * math.sqrt(30)
    assert 0.083 * (2 + 30 * D / b_o) > 0.33
    check = of_walls(punching.checks(combined))
    assert check.name == "two-way shear at walls' ends"
    assert check.of == "end of W"
    assert (check.demand, check.resistance) == pytest.approx((v_u, phi_v_c), rel=2e-3)
    assert check.error == pytest.approx(0.1 * v_u, rel=2e-3)
    row = row_of(table_of(combined))
    assert (row["b_o"], row["V_u"]) == pytest.approx((b_o, V / 1e3), rel=2e-3)
    assert row["v_u / phi v_c"] == pytest.approx(v_u / phi_v_c, rel=2e-3)


def test_punching_by_the_second_generation() -> None:
    """At d / 2: 1.4 V / (b_0.5 d) over tau_Rd,c of 2 % of bars; half of b counts along each side, as b < 1.5 d."""
    combined = results("EN 1992-1-1:2023")
    b_05, V = at(D / 2)
    tau_Ed = 1.4 * V / (b_05 * D) / 1e6
    k_pb = 3.6 * math.sqrt(1 - (T + 2 * ALONG) / b_05)
    tau_Rd = min(0.6 * k_pb * (100 * 0.02 * 30 * 32 / (D * 1e3)) ** (1 / 3), 0.5 * math.sqrt(30)) / 1.4
    check = of_walls(punching.checks(combined))
    assert check.name == "punching at walls' ends"
    assert check.of == "end of W"
    assert (check.demand, check.resistance) == pytest.approx((tau_Ed, tau_Rd), rel=2e-3)
    assert check.error == pytest.approx(0.1 * tau_Ed, rel=2e-3)
    row = row_of(table_of(combined))
    assert (row["b_0.5"], row["V_Ed"], row["k_pb"]) == pytest.approx((b_05, V / 1e3, k_pb), rel=2e-3)
    assert row["tau_Ed / tau_Rd,c"] == pytest.approx(tau_Ed / tau_Rd, rel=2e-3)


def test_links_are_needed_where_the_concrete_is_not_enough_and_none_help_beyond() -> None:
    """v_Ed between one and k_max = 1.5 times v_Rd needs links, beyond it none help; resistance is 1.5 v_Rd there."""
    used = row_of(table_of(results()))["v_Ed / v_Rd"]
    needed = of_walls(punching.checks(results(q=1.2 / used * C)))
    assert needed.status == "fails"
    assert needed.words.startswith("punching reinforcement is needed at 1 wall end; worst end of W")
    assert "m from the wall end (6.4.5(4), 6.54)" in needed.words
    failing = of_walls(punching.checks(results(q=1.6 / used * C)))
    assert failing.status == "fails"
    assert failing.utilization == pytest.approx(1.6 / 1.5, rel=1e-6)


def test_only_walls_that_press_or_pull_punch() -> None:
    """A wall that carries nothing, or whose load acts at its other end only, has no demand at the end."""
    idle = results(loads=[{**LOAD, "q_end": 0.0}, {"kind": "uniform", "q": 1e3, "case": "G"}])
    check = of_walls(punching.checks(idle))
    assert check.words == "no wall pushes or pulls at an end or corner with slab beyond it"
    assert not table_of(idle).rows()
    at_start = results(loads=[{**LOAD, "q": 100e3, "q_end": 0.0}])
    assert table_of(at_start)["place"] == ("start",)


@pytest.mark.parametrize(
    ("code", "v_Ed"), [("EN 1992-1-1", "v_Ed at a"), ("EN 1992-1-1:2023", "tau_Ed"), ("ACI 318", "v_u")]
)
def test_a_wall_that_pulls_punches_upwards(code: str, v_Ed: str) -> None:
    """The slab's shear force runs to the end from all sides, d is that of the bars at the top: as pressed, mirrored."""
    steel = {"code": code, "f_ck": 30e6, "f_yk": 500e6}
    turned = steel | {"bottom": (0.06, 0.08), "top": (0.04, 0.05)}
    pulled = results(code, q=-C, loads=[{**LOAD, "q_end": -100e3}], reinforcement=turned)
    row, pressed = row_of(table_of(pulled)), row_of(table_of(results(code)))
    assert (row["place"], row[v_Ed]) == ("end", pytest.approx(pressed[v_Ed], rel=1e-9))
    check = of_walls(punching.checks(pulled))
    assert check.utilization == pytest.approx(of_walls(punching.checks(results(code))).utilization, rel=1e-9)
    assert check.words.endswith("it pulls and is taken as tied to the far face")


def test_walls_without_ends_have_no_check() -> None:
    """A circle has none; a wall from edge to edge has no slab beyond its ends."""
    ring = {"name": "W", "thickness": T, "shape": {"kind": "circle", "radius": 1.0}}
    round_wall = results(walls=[ring], loads=[{"kind": "line", "q": 100e3, "wall": "W", "case": "G"}])
    assert not [*punching.checks(round_wall)]
    assert "wall_punching" not in table_makers(round_wall)
    across = results(walls=[{**W, "points": [(-LENGTH_X / 2, 0), (LENGTH_X / 2, 0)]}])
    assert of_walls(punching.checks(across)).demand is None
    assert not table_of(across).rows()


def test_a_corner_has_beta_1_2() -> None:
    """With two sides and a quarter circle, of the same field."""
    corner = results(walls=[{**W, "points": [(-3, 0), (0, 0), (0, 3)]}])
    rows = [row_of(table_of(corner), number) for number in range(2)]
    assert [row["place"] for row in rows] == ["corner", "end"]
    row, a = rows[0], 2 * D
    u = 2 * ALONG + math.pi / 2 * a
    V = C * (2 * ALONG * (T / 2 + a) + math.pi / 2 * a**2 + a * T)
    assert (row["beta"], row["a"]) == pytest.approx((1.2, a))
    assert (row["u at a"], row["V_Ed at a"]) == pytest.approx((u, V / 1e3), rel=2e-3)


def test_zones_of_bars_count() -> None:
    """Bars all over and more of them where the end is raise v_Rd as the cube root of their ratio."""
    bars = {"diameter": 0.016, "spacing": 0.2}
    laid = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), bars)
    steel = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05), **laid}
    base = results(reinforcement=steel)
    zone = {"name": "Z", "layers": ["bottom_x", "bottom_y"], **bars,
            "shape": {"kind": "rectangle", "x": (-3.0, 3.0), "y": (-3.0, 3.0)}}  # fmt: skip
    more = results(reinforcement={**steel, "zones": [zone]})
    v_Rd = [row_of(table_of(each))["v_Rd at a"] for each in (base, more)]
    rho = math.pi / 4 * 0.016**2 / 0.2 / D
    own = 0.18 / 1.5 * (1 + math.sqrt(200 / (D * 1e3))) * (100 * rho * 30) ** (1 / 3)
    doubled = 0.18 / 1.5 * (1 + math.sqrt(200 / (D * 1e3))) * (200 * rho * 30) ** (1 / 3)
    least = 0.035 * (1 + math.sqrt(200 / (D * 1e3))) ** 1.5 * math.sqrt(30)
    assert v_Rd == pytest.approx([max(own, least), max(doubled, least)], rel=1e-6)
    assert np.ptp(v_Rd) > 0


@pytest.mark.parametrize("code", ["EN 1992-1-1", "ACI 318", "EN 1992-1-1:2023"])
def test_walls_along_edges_of_the_plate_stand_beside(code: str) -> None:
    """A wall that is given by an edge is placed for its loads, too; the end of another one is told as without it."""
    edge = {"name": "edge", "thickness": 0.3, "edge": "left"}
    loads = [LOAD, {"kind": "line", "q": 10e3, "wall": "edge", "case": "G"}]
    alone, beside = (table_of(results(code, walls=walls, loads=some))
                     for walls, some in (([W], [LOAD]), ([W, edge], loads)))  # fmt: skip
    assert [row for row in zip(*(column.values for column in beside.columns), strict=True) if "W" in row] == list(
        zip(*(column.values for column in alone.columns), strict=True)
    )


def test_calculations_by_en_1992() -> None:
    """Each value follows from those above it; stress and share are those of the check, which is by hand above."""
    combined = results()
    ((_, ((of, combination, steps, *_),)),) = punching.calculations(combined)
    known = follow_steps(steps)
    check = of_walls(punching.checks(combined))
    assert (of, combination) == (check.of, check.combination)
    assert known["beta"] == 1.35
    assert known["rho_l"] == 0.02
    assert (known["v_Ed"], known["v_Rd"]) == pytest.approx((check.demand, check.resistance))
    assert known["eta"] == pytest.approx(check.utilization)


def test_calculations_by_aci_318() -> None:
    """The same on the critical section at d / 2."""
    combined = results("ACI 318")
    ((_, ((of, combination, steps, *_),)),) = punching.calculations(combined)
    known = follow_steps(steps)
    check = of_walls(punching.checks(combined))
    assert (of, combination) == (check.of, check.combination)
    assert known["beta_e"] == 1.35
    assert known["v_u"] == pytest.approx(check.demand)
    assert known["phi"] * known["v_c"] == pytest.approx(check.resistance)
    assert known["eta"] == pytest.approx(check.utilization)
