"""Punching of the slab around thicker zones, and of perimeters that leave them, by hand, and what both leave alone."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from shapely import box

import groundslab as gs
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.checks import punching
from groundslab.design.codes.aci318.checks.two_way_demand import two_way as column_two_way
from groundslab.design.codes.aci318.checks.two_way_demand import zone_two_way
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands as demands
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import zone_demands
from groundslab.design.codes.en1992_2004.perimeters import share_of_thinner
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.design.codes.en1992_2023.checks.punching_demand import zone_demands as second_zone_demands
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.demands.zones.thinner_slab import ThinnerPart
from groundslab.design.rules.check import DesignCheck
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import table_makers
from helpers import synthetic
from helpers.calculations import follow_steps
from helpers.synthetic import LENGTH_X, LENGTH_Y

H, D = 0.5, 0.455
#: Side of a square zone [m], and the pressure of the ground [Pa].
SIDE, PRESSURE = 2.4, 40e3
#: Arcs are chords, which are shorter than they are by 3e-5 at most.
CHORDS = {"rel": 1e-4}
CODES = ("EN 1992-1-1", "ACI 318", "EN 1992-1-1:2023")


def zone(x: tuple[float, float], y: tuple[float, float], thickness: float = 0.8) -> dict[str, Any]:
    """Return a zone of a thickness [m]."""
    return {"thickness": thickness, "shape": {"kind": "rectangle", "x": list(x), "y": list(y)}}


def square(thickness: float = 0.8) -> dict[str, Any]:
    """Return the square zone in the middle of the plate."""
    return zone((-SIDE / 2, SIDE / 2), (-SIDE / 2, SIDE / 2), thickness)


def results(
    *zones: dict[str, Any],
    code: str = "EN 1992-1-1",
    P: float = 3e6,
    columns: tuple[tuple[float, float], ...] = ((0.0, 0.0),),
    pressure: float = PRESSURE,
    thickness: float = H,
    more: tuple[dict[str, Any], ...] = (),
) -> Results:
    """Return results of columns that share a force [N] on a plate with zones, under an even pressure [Pa], and more."""
    names = [f"C{n}" for n, _ in enumerate(columns, start=1)]
    model = Model(
        plate={
            "length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": thickness, "E": 30e9, "nu": 0.2,
            "zones": list(zones),
        },
        ground={"kind": "winkler", "k": 20e6},
        columns=[
            {"name": name, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4}
            for name, (x, y) in zip(names, columns, strict=True)
        ],
        cases=[{"name": "G"}],
        loads=[*({"kind": "point", "P": P / len(names), "column": name, "case": "G"} for name in names), *more],
        combinations=[{"name": "ULS", "factors": {"G": 1.0}}],
        reinforcement={"code": code, "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
    )  # fmt: skip
    one = synthetic.results(24, model=model, combination="ULS", limit_state="ultimate", factors=(("G", 1.0),))
    plate = replace(one.plate, pressure=np.full(len(one.plate.nodes), pressure))
    found = synthetic.compared(replace(one, plate=plate), replace(plate, pressure=0.9 * plate.pressure))
    return Results(model, model.combinations, {"ULS": found}, {})


def named(checks: Any, words: str) -> DesignCheck:
    """Return the check whose name has some words."""
    (check,) = (each for each in checks if words in each.name)
    return check


def v_rd_c(d: float) -> float:
    """Return C_Rd,c k (100 rho f_ck)^(1/3) of 2 % of bars [MPa]."""
    return 0.18 / 1.5 * (1 + math.sqrt(200 / (d * 1e3))) * (100 * 0.02 * 30) ** (1 / 3)


def around(a: float, side: float = SIDE) -> tuple[float, float]:
    """Return length [m] and area [m2] of a perimeter with rounded corners at a distance [m] from a square."""
    return 4 * side + 2 * math.pi * a, side**2 + 4 * side * a + math.pi * a**2


def test_a_square_drop_panel_by_en_1992() -> None:
    """At 2 d from the panel, d of the slab: V less the pressure inside over u d; at the worst a, v_Rd,c 2 d / a."""
    combined = results(square())
    u, area = around(2 * D)
    V = 3e6 - PRESSURE * area
    demand = zone_demands(combined).found["ULS", "zone 1"]
    assert demand.at_2d is not None
    assert (demand.d, demand.at_2d.u, demand.at_2d.V_Ed) == pytest.approx((D, u, V), **CHORDS)
    assert demand.at_2d.v_Ed == pytest.approx(V / (u * D), **CHORDS)
    assert demand.v_Rd_c == pytest.approx(1e6 * v_rd_c(D), rel=1e-9)
    assert demand.face is None
    distances = np.linspace(0.2, 2, 200) * D
    used = [
        (3e6 - PRESSURE * area) / (u * D) / (1e6 * v_rd_c(D) * 2 * D / a)
        for a in distances
        for u, area in [around(float(a))]
    ]
    check = named(punching.checks(combined), "thicker zones")
    assert check.name == "punching around thicker zones within 2 d"
    assert (check.of, check.place, check.clause) == ("zone 1", (0, 0), "EN 1992-1-1 6.4.4(2)")
    assert check.utilization == pytest.approx(max(used), rel=1e-3)
    assert check.error == pytest.approx(0.1 * PRESSURE * area / (u * D) / 1e6, rel=2e-3)


def test_a_square_drop_panel_by_aci_318() -> None:
    """At d / 2 with square corners (22.6.4.1(b)), v_c by alpha_s d / b_o, as b_o is long."""
    combined = results(square(), code="ACI 318")
    b_o, area = 4 * (SIDE + D), (SIDE + D) ** 2
    v_u = (3e6 - PRESSURE * area) / (b_o * D) / 1e6
    factor = 0.083 * (2 + 40 * D / b_o)
    assert factor < 0.33
    check = named(punching.checks(combined), "thicker zones")
    assert (check.name, check.of) == ("two-way shear around thicker zones", "zone 1")
    assert check.demand == pytest.approx(v_u, rel=1e-6)
    assert check.resistance == pytest.approx(0.75 * factor * math.sqrt(2 / (1 + 0.004 * D * 1e3)) * math.sqrt(30))


def test_a_square_drop_panel_by_the_second_generation() -> None:
    """At d_v / 2, of straight sides 3 d_v; V less the pressure up to 0.67 d_v, beta_e at least 1.05."""
    combined = results(square(), code="EN 1992-1-1:2023")
    b_0 = 4 * 3 * D
    b_05 = b_0 + math.pi * D
    tau_Ed = 1.05 * (3e6 - PRESSURE * around(0.67 * D)[1]) / (b_05 * D) / 1e6
    k_pb = 3.6 * math.sqrt(1 - b_0 / b_05)
    tau_Rd = min(0.6 * k_pb * (100 * 0.02 * 30 * 32 / (D * 1e3)) ** (1 / 3), 0.5 * math.sqrt(30)) / 1.4
    check = named(punching.checks(combined), "thicker zones")
    assert (check.name, check.of) == ("punching around thicker zones", "zone 1")
    assert (check.demand, check.resistance) == pytest.approx((tau_Ed, tau_Rd), **CHORDS)


def test_columns_share_a_zone() -> None:
    """Two with half of the force each, alike on both sides, are one in the middle; one off it turns the zone, 6.41."""
    one, two = (results(square(), columns=some) for some in (((0.0, 0.0),), ((-0.6, 0.0), (0.6, 0.0))))
    alone, both = (zone_demands(each).found["ULS", "zone 1"].at_2d for each in (one, two))
    assert alone is not None
    assert both is not None
    assert (both.V_Ed, both.u, both.beta) == pytest.approx((alone.V_Ed, alone.u, 1.0), rel=1e-9)
    off = zone_demands(results(square(), columns=((0.6, 0.0),))).found["ULS", "zone 1"].at_2d
    assert off is not None
    W = SIDE**2 / 2 + SIDE**2 + 4 * SIDE * D + 16 * D**2 + 2 * math.pi * D * SIDE
    assert off.beta == pytest.approx(1 + 0.6 * 3e6 * 0.6 * off.u / (off.V_Ed * W), **CHORDS)


@pytest.mark.parametrize(
    ("code", "of_column", "thickness", "P"),
    [
        ("EN 1992-1-1", "punching within 2 d", 0.2, 2.8e6),
        ("ACI 318", "two-way shear", 0.19, 1.6e6),
        ("EN 1992-1-1:2023", "punching", 0.19, 0.8e6),
    ],
)
def test_the_slab_fails_around_a_panel_that_bears(code: str, of_column: str, thickness: float, P: float) -> None:
    """The panel bears its column; around it the thin slab fails, beyond what links can add or too thin for them."""
    combined = results(square(0.54), code=code, P=P, pressure=0.0, thickness=thickness)
    of = {each.name: each for each in punching.checks(combined)}
    (around_it,) = (check for name, check in of.items() if "thicker zones" in name)
    assert around_it.status == "fails"
    used = of[of_column].utilization
    assert used is not None
    assert used < 1


def test_what_needs_links_gets_them_in_the_slab_around() -> None:
    """Between once and k_max times v_Rd; legs are as long as the slab is thick there, and stand beyond the zone."""
    combined = results(square(), P=7.5e6)
    check = named(punching.checks(combined), "thicker zones")
    assert check.status == "fails"
    assert check.words.startswith("punching reinforcement is needed at 1 thicker zone; worst zone 1")
    (layout,) = (each for each in punching_links(combined) if each.support == "zone")
    assert layout.name == "zone 1"
    assert 0.0 < layout.leg < H
    first = layout.perimeters[0]
    assert np.abs(first.places).max(axis=1).min() >= SIDE / 2 + first.distance / math.sqrt(2)


@pytest.mark.parametrize(
    ("zones", "columns"),
    [
        ((), ((0.0, 0.0),)),
        ((square(H),), ((0.0, 0.0),)),
        ((square(0.3),), ((0.0, 0.0),)),
        ((square(),), ((2.0, 2.0),)),
        ((zone((-9, 9), (-9, 9)),), ((0.0, 0.0),)),
        ((zone((-3.2, 3.2), (-3.0, 3.0)),), ((0.0, 0.0),)),
    ],
    ids=["none", "as thick as the slab", "a pit", "no column on it", "all of the slab", "more than half of the slab"],
)
def test_what_is_no_thicker_zone_changes_nothing(zones: Any, columns: Any) -> None:
    """Neither check nor table; a column in a pit has the thickness of the pit."""
    combined = results(*zones, columns=columns)
    assert not zone_forces(combined)
    assert not [each for each in punching.checks(combined) if "zone" in each.name]
    assert "zone_punching" not in table_makers(combined)
    thickness = 0.3 if zones == (square(0.3),) else 0.8 if zones and zones[0] != square(H) and columns[0][0] == 0 else H
    demand = demands(combined).found["ULS", "C1"]
    assert demand.d == pytest.approx(thickness - 0.045)


def test_a_band_from_edge_to_edge_is_left_to_one_way_shear() -> None:
    """Nothing turns around it: no check is open for that, and a note says why."""
    for code in CODES:
        combined = results(zone((-0.8, 0.8), (-9, 9)), code=code)
        check = named(punching.checks(combined), "thicker zones")
        assert check.status == "no failure found"
        assert "one-way shear" in check.words
        notes = table_makers(combined)["zone_punching"]().notes
        assert any(note.startswith("no punching around zone 1: ") and "one-way shear" in note for note in notes)


def test_a_zone_at_an_edge_has_a_perimeter_with_two_ends() -> None:
    """Three sides and two quarter circles; at a corner two sides and one."""
    edge = zone_demands(results(zone((2.4, 9), (-1.2, 1.2)), columns=((3.6, 0.0),))).found["ULS", "zone 1"].at_2d
    corner = zone_demands(results(zone((2.4, 9), (1.2, 9)), columns=((3.6, 2.4),))).found["ULS", "zone 1"].at_2d
    assert edge is not None
    assert corner is not None
    assert edge.u == pytest.approx(3 * SIDE + 2 * math.pi * D, **CHORDS)
    assert corner.u == pytest.approx(2 * SIDE + math.pi * D, **CHORDS)


def test_a_column_on_a_zone_is_judged_within_it() -> None:
    """The zone's corner is 0.922 m from the column's: perimeters farther out are in the slab around, and the zone's.

    Up to there what is beyond the zone counts in full: 2 d_t / (a - 0.6) a d_t / (2 d^2) is more than 1.
    """
    combined = results(zone((-0.8, 0.8), (-0.9, 0.9)))
    d, last = 0.8 - 0.045, math.hypot(0.6, 0.7)
    demand = demands(combined).found["ULS", "C1"]
    assert demand.at_2d is None
    assert last - 0.02 < demand.around[-1].distance < last
    distances = [float(a) for a in np.linspace(0.25 * d, demand.around[-1].distance, 200)]
    used = []
    for a in distances:
        u, area = around(a, 0.4)
        used.append((3e6 - PRESSURE * area) / (u * d) / (1e6 * v_rd_c(d) * 2 * d / a))
    check = named(punching.checks(combined), "punching within 2 d")
    assert (check.of, check.utilization) == ("C1", pytest.approx(max(used), rel=1e-3))


def test_a_perimeter_beyond_a_step_counts_by_the_slab_there() -> None:
    """The slab is thinner from 0.2 m beyond the column on; at 2 d a_t = 1.31 m is beyond 2 d_t: w = a d_t / (2 d^2)."""
    combined = results(zone((-0.4, 9), (-9, 9)))
    d = 0.8 - 0.045
    a = 2 * d
    assert not zone_forces(combined)
    far = demands(combined).found["ULS", "C1"].at_2d
    assert far is not None
    beyond = 0.4 + 2 * a * (math.pi / 2 - math.asin(0.2 / a))
    w = a * D / (2 * d**2)
    u, area = around(a, 0.4)
    assert far.u == pytest.approx(u - (1 - w) * beyond, **CHORDS)
    assert far.v_Ed == pytest.approx(far.beta * (3e6 - PRESSURE * area) / (far.u * d), **CHORDS)
    assert far.control is not None
    assert far.control.thinned
    part = ThinnerPart(d - D, 0.2, box(-9, -9, -0.4, 9))
    for distance, share in ((0.21, 1.0), (1.0, 2 * D / 0.8 * D / (2 * d**2)), (a, w)):
        assert share_of_thinner(part, distance, d) == pytest.approx(share)


def test_critical_sections_that_leave_their_zone_count_by_the_depth() -> None:
    """Sides beyond the zone by d of the slab over d at the column, in ACI 318 and in the second generation."""
    narrow = zone((-0.4, 0.4), (-0.9, 0.9))
    d = 0.8 - 0.045
    half, share = 0.2 + d / 2, D / d
    assert 0.4 < half < 0.9
    demand = column_two_way(results(narrow, code="ACI 318")).found["ULS", "C1"]
    assert demand.b_o == pytest.approx(2 * 2 * half * share + 2 * (0.8 + 2 * (half - 0.4) * share), rel=1e-9)
    rounded = column_demands(results(narrow, code="EN 1992-1-1:2023")).found["ULS", "C1"]
    turn = math.asin(0.2 / (d / 2))  # of each quarter circle, up to the border of the zone
    inside = 4 * (d / 2) * turn
    assert rounded.b_05 == pytest.approx(2 * 0.4 + inside + share * (2 * 0.4 + math.pi * d - inside), **CHORDS)


def test_calculations_can_be_followed_by_hand() -> None:
    """Every formula with its numbers gives its value, around a zone and of a column whose perimeter leaves it."""
    for code in CODES:
        calculated = dict(punching.calculations(results(zone((-0.8, 0.8), (-0.9, 0.9)), code=code, P=5e6)))
        ((of, combination, steps, *_),) = calculated["punching around thicker zones"]
        assert (of, combination) == ("zone 1", "ULS")
        assert follow_steps(steps)
        ((*_, steps, _, _),) = calculated["punching"]
        assert follow_steps(steps)
    calculated = dict(punching.calculations(results(zone((-0.4, 0.4), (-0.3, 0.3)), P=5e6)))
    (words,) = (step.words for step in calculated["punching"][0].steps if step.symbol == "u")
    assert words == "what counts of it"


def test_the_table_has_a_row_for_each_zone_and_combination() -> None:
    """Of zones in each other both have one, with the columns on them."""
    inner = zone((-0.8, 0.8), (-0.9, 0.9), 1.2)
    table = table_makers(results(square(), inner))["zone_punching"]()
    assert table["zone"] == ("zones 1 and 2", "zone 2")
    assert table["columns"] == ("C1", "C1")
    assert table["d"] == pytest.approx((1e3 * D, 755.0))
    assert table["load"] == pytest.approx((3e3, 3e3))
    known = zone_two_way(results(square(), inner, code="ACI 318")).found
    assert {name for _, name in known} == {"zone 2", "zones 1 and 2"}


@pytest.mark.slow
def test_what_is_turned_stays_as_it_is() -> None:
    """A plate with a panel and its column off its middle, solved, and solved again turned by 30 degrees."""
    demands_of = []
    for angle in (0.0, 30.0):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))

        def polygon(a: float, b: float, c: float = c, s: float = s) -> dict[str, Any]:
            corners = ((-a, -b), (a, -b), (a, b), (-a, b))
            return {"kind": "polygon", "points": [(c * x - s * y, s * x + c * y) for x, y in corners]}

        column = {"name": "C", "x": c * 0.3, "y": s * 0.3, "width_x": 0.4, "width_y": 0.4, "angle": angle}
        solved = gs.solve(
            Model(
                plate={
                    "outline": polygon(3, 2.5), "thickness": 0.3, "E": 30e9, "nu": 0.2,
                    "zones": [{"thickness": 0.6, "shape": polygon(1, 0.7)}],
                },
                ground={"kind": "winkler", "k": 20e6},
                columns=[column],
                cases=[{"name": "G"}],
                loads=[{"kind": "point", "P": 1e6, "column": "C", "case": "G"}],
                combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
                reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.05), "top": (0.05, 0.05)},
                mesh={"size": 0.5},
            )
        )  # fmt: skip
        demands_of.append(zone_demands(solved).found["ULS", "zone 1"].at_2d)
    one, other = demands_of
    assert one is not None
    assert other is not None
    assert other.u == pytest.approx(one.u, **CHORDS)
    assert (other.V_Ed, other.beta) == pytest.approx((one.V_Ed, one.beta), rel=2e-3)


def test_loads_along_an_edge_that_a_section_runs_out_to_count() -> None:
    """A load of 100 kN/m near the edge, from one end of the section around the zone to the other."""
    edge, q = LENGTH_X / 2, 100e3
    line = {"kind": "line", "q": q, "case": "G", "points": [(edge - 0.05, -3.0), (edge - 0.05, 3.0)]}
    wide = zone((edge - 2.0, edge - 0.8), (-0.9, 0.9))
    combined = results(wide, code="ACI 318", columns=((edge - 1.4, 0.0),), more=(line,))
    demand = zone_two_way(combined).found["ULS", "zone 1"]
    assert demand.line is not None
    assert demand.line.setbacks == pytest.approx((0.8,))
    assert demand.others == pytest.approx(q * (1.8 + demand.d), **CHORDS)


def test_walls_on_a_zone_make_its_force_eccentric_in_the_second_generation() -> None:
    """2 MN of a wall 0.9 m off the middle and 0.1 MN of a column there act at 1.8 MNm / 2.1 MN."""
    wall = {"kind": "line", "q": 1e6, "case": "G", "points": [(-1.0, 0.9), (1.0, 0.9)]}
    combined = results(square(), code="EN 1992-1-1:2023", P=0.1e6, pressure=0.0, more=(wall,))
    demand = second_zone_demands(combined).found["ULS", "zone 1"]
    assert demand.V_Ed == pytest.approx(2.1e6, rel=1e-9)
    assert sorted(map(abs, demand.eccentricities)) == pytest.approx([0.0, 1.8 / 2.1], abs=1e-9)


def test_ground_in_a_recess_of_a_zone_takes_nothing_off() -> None:
    """Around an L of two arms, pressure counts up to d / 2 from its own sides, 24 m, and in four corners of d2 / 4."""
    arms = ((-2.8, -3.0), (3.2, -3.0), (3.2, -1.8), (-1.6, -1.8), (-1.6, 3.0), (-2.8, 3.0))
    corner = {"thickness": 0.9, "shape": {"kind": "polygon", "points": arms}}
    combined = results(corner, code="ACI 318", columns=((2.4, -2.4), (-2.2, 2.4), (-2.2, -2.4)), thickness=0.3)
    demand = zone_two_way(combined).found["ULS", "zone 1"]
    # five corners that stand out and one that does not
    area = 2 * 6.0 * 1.2 - 1.2**2 + 24 * demand.d / 2 + 4 * (demand.d / 2) ** 2
    assert demand.V_u == pytest.approx(3e6 - PRESSURE * area, rel=1e-3)


def test_a_zone_that_is_turned_alone_is_judged() -> None:
    """Two opposite forces on it push nothing down, but turn the slab around by 8 MNm, at d / 2 as 8.4.4.2 has it."""
    opposite = {"kind": "point", "P": -4e6, "column": "C2", "case": "G"}
    wide = zone((-2.5, 2.5), (-1.0, 1.0))
    turned = results(wide, P=4e6, columns=((-2.0, 0.0), (2.0, 0.0)), more=(opposite,), code="ACI 318")
    demand = zone_two_way(turned).found["ULS", "zone 1"]
    assert demand.transfer is not None
    assert sorted(map(abs, demand.transfer.moments)) == pytest.approx([0.0, 8e6], abs=1.0)
    assert "it turns the slab without a force" in named(punching.checks(turned), "thicker zones").words


def test_a_zone_that_is_pulled_punches_upwards() -> None:
    """A column on it pulls with 1 MN: V_u is that and the pressure up to d / 2, d that of the top bars around."""
    demand = zone_two_way(results(square(), P=-1e6, code="ACI 318")).found["ULS", "zone 1"]
    assert demand.force == pytest.approx(1e6)
    assert demand.V_u == pytest.approx(1e6 + PRESSURE * (SIDE + D) ** 2, rel=1e-6)


def test_shorter_sections_in_thinner_slab_do_not_make_concrete_stronger() -> None:
    """ACI's alpha_s d / b_o follows the mean depth over the whole length, not one over what counts of it."""
    combined = results(square(), code="ACI 318", columns=((0.9, 0.0),))
    demand = column_two_way(combined).found["ULS", "C1"]
    assert demand.line is not None
    assert demand.b_o < demand.line.u
    assert demand.alpha_s * demand.d / demand.b_o == pytest.approx(40 * demand.d * demand.b_o / demand.line.u**2)
