"""Links that are proposed keep to every rule of their code, recomputed here from what the checks find."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from shapely import Point, box

from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.checks import check_design
from groundslab.design.codes.aci318.checks import links as aci318_links
from groundslab.design.codes.aci318.checks.two_way_demand import two_way
from groundslab.design.codes.en1992_2004.checks import links as en1992_links
from groundslab.design.codes.en1992_2004.checks import punching_demand
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.model.model import Model
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.solve_once import solve_once
from helpers.synthetic import LENGTH_X, LENGTH_Y

#: Axes of the bars, so that d = 0.5 - 0.058 m.
D = 0.442
STEEL: dict[str, Any] = {"concrete": "C30/37", "steel": "B500B"}
ACI: dict[str, Any] = {"code": "ACI 318", "f_ck": 30e6, "f_yk": 500e6}
OPENING = (-1.5, -1.0, -0.3, 0.3)


def raft(force: float, steel: dict[str, Any] = STEEL, x: float = 2.0, **plate: Any) -> Model:
    """Return a raft under two columns, 0.4 m x 0.4 m, with bars of 14 mm in all layers."""
    grid = {layer: {"diameter": 0.014, "spacing": 0.15} for layer in LAYERS}
    return Model(
        plate={"length_x": 8, "length_y": 5, "thickness": 0.5, "E": 33e9, "nu": 0.2} | plate,
        ground={"kind": "pasternak", "k0": 25e6, "k1": 15e6},
        columns=[{"name": n, "x": at, "y": 0, "width_x": 0.4, "width_y": 0.4} for n, at in (("A", -x), ("B", x))],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "P": force, "column": name, "case": "G"} for name in "AB"],
        combine={"sets": ["ultimate"]},
        reinforcement={"bottom": (0.05, 0.066), "top": (0.05, 0.066)} | grid | steel,
        mesh={"size": 0.4},
    )


def required_by_hand(found: list[Demand], start: float, s_r: float) -> float:
    """Return A_sw [m2] by 6.52 of all perimeters with v_Ed > v_Rd: v_Rd,c = 0.12 k (100 rho f_ck)^(1/3) 2 d / a."""
    k, rho = 1 + math.sqrt(0.2 / D), math.pi * 0.014**2 / 4 / 0.15 / D
    v_Rd_c = max(0.12 * k * (100 * rho * 30) ** (1 / 3), 0.035 * k**1.5 * 30**0.5)
    f_ywd_ef = min(250 + 0.25 * 442, 500 / 1.15)
    areas = []
    for stress in (stress for demand in found for stress in demand.around):
        v_Ed, v_Rd = stress.v_Ed / 1e6, v_Rd_c * 2 * D / stress.distance
        if v_Ed > v_Rd:
            # links at the start and from there s_r apart, as far as they are within the section
            within = 1 + math.floor((stress.distance - start) / s_r + 1e-6)
            count = min(1.5 * D / s_r, max(1, within))
            areas.append((v_Ed - 0.75 * v_Rd) * stress.u * D / (count * f_ywd_ef))
    return max(areas)


def outer_by_hand(found: list[Demand]) -> float:
    """Return how far from the face v_Ed <= v_Rd again [m], of the check's perimeters, or by 6.54 beyond."""
    farthest = 0.0
    for demand in found:
        inner, last = demand.around[-2:]
        grows = (last.u - inner.u) / (last.distance - inner.distance)
        beyond = last.distance + (last.v_Ed / demand.v_Rd_c - 1) * last.u / grows
        ends = [*(stress.distance for stress in demand.around[1:]), beyond]
        needing = [stress.v_Ed > demand.resistance(stress) for stress in demand.around]
        farthest = max([farthest, *(end for end, needed in zip(ends, needing, strict=True) if needed)])
    return farthest


def assert_rules_of_en1992(results: Results, layout: LinkLayout) -> None:
    """Hold a layout to 6.4.5 and 9.4.3 of EN 1992-1-1 with the recommended values."""
    found = [demand for demand in column_demands(results).found.values() if demand.name == layout.name]
    leg = math.pi * layout.diameter**2 / 4
    distances = [perimeter.distance for perimeter in layout.perimeters]
    s_r = distances[1] - distances[0]
    assert 0.3 * D <= distances[0] <= 0.5 * D
    assert np.diff(distances) == pytest.approx(s_r)
    assert s_r <= 0.75 * D + 1e-9
    assert distances[-1] >= outer_by_hand(found) - 1.5 * D
    for perimeter in layout.perimeters:
        assert perimeter.required == pytest.approx(
            required_by_hand(found, layout.perimeters[0].distance, s_r), rel=1e-6
        )
        assert perimeter.provided == pytest.approx(leg * len(perimeter.places))
        assert perimeter.provided >= perimeter.required
        assert perimeter.spacing <= (1.5 if perimeter.distance <= 2 * D else 2.0) * D
        assert 1.5 * leg / (s_r * perimeter.spacing) >= 0.08 * math.sqrt(30) / 500  # 9.11
        column = box(-0.2, -0.2, 0.2, 0.2)
        for place in perimeter.places - layout.place:
            assert column.distance(Point(place)) == pytest.approx(perimeter.distance, abs=1e-3)


def test_inner_column_by_en1992() -> None:
    """All rules of an inner column, recomputed; the governing A_sw is no less than that of the check."""
    results = solve_once(raft(1500e3))
    layouts = punching_links(results)
    assert [layout.name for layout in layouts] == ["A", "B"]
    for layout in layouts:
        assert_rules_of_en1992(results, layout)
        for perimeter in layout.perimeters:
            assert perimeter.length == pytest.approx(1.6 + 2 * math.pi * perimeter.distance, rel=1e-4)
        assert layout.leg == pytest.approx(0.5 - 2 * 0.043)  # 0.05 less half of 14 mm at both faces
        assert layout.mass == pytest.approx(7850 * math.pi * layout.diameter**2 / 4 * 0.414 * layout.number)
    check = next(check for check in check_design(results).checks if "within 2 d" in check.name)
    said = float(check.words.split(" cm2 of vertical links")[0].split()[-1])
    s_r = layouts[0].radial
    assert s_r is not None
    assert layouts[0].perimeters[0].required * 1e4 >= said * s_r / (0.75 * D) * 0.999


def test_column_at_an_edge_by_en1992() -> None:
    """The perimeters end at the edge, 0.1 m from the column; legs keep off it, and are enough without those beyond."""
    results = solve_once(raft(800e3, x=3.7))
    layouts = punching_links(results)
    assert layouts
    for layout in layouts:
        assert_rules_of_en1992(results, layout)
        for perimeter in layout.perimeters:
            assert (np.abs(perimeter.places[:, 0]) <= 4 - 0.043).all()
            assert perimeter.length < 1.2 + math.pi * perimeter.distance + 0.4


def test_column_beside_an_opening_by_en1992() -> None:
    """No leg in the opening, nor behind it as seen from the column, where the perimeter does not count."""
    x0, x1, y0, y1 = OPENING
    opening = {"kind": "rectangle", "x": (x0, x1), "y": (y0, y1)}
    results = solve_once(raft(1250e3, openings=[opening]))
    layout = punching_links(results)[0]
    assert layout.name == "A"
    assert_rules_of_en1992(results, layout)
    # longer across than along the ray, so it is not widened: tangents from (-2, 0) by its corners nearest to it
    tangent = 0.3 / 0.5
    for perimeter in layout.perimeters:
        x, y = (perimeter.places - layout.place).T
        assert not ((x > 0) & (np.abs(y) < tangent * x - 1e-6)).any()
        hole = box(x0, y0, x1, y1)
        assert min(hole.distance(Point(place)) for place in perimeter.places) >= 0.043


def test_first_two_rows_carry_all_by_the_german_annex() -> None:
    """At 0.3 d and 0.8 d half of beta V_Ed,red / f_ywd,ef each, a third of both on each further row, phi <= 0.05 d."""
    results = solve_once(raft(1500e3, STEEL | {"annex": "Germany"}))
    layout = punching_links(results)[0]
    found = [demand for demand in column_demands(results).found.values() if demand.name == "A"]
    worst = max((demand.used(stress), demand, stress) for demand in found for stress in demand.around)[2]
    whole = worst.v_Ed * worst.u * D / (min(250 + 0.25 * 442, 500 / 1.15) * 1e6)
    first, second, *further = layout.perimeters
    assert (first.distance, second.distance) == pytest.approx((0.135, 0.355))
    assert (first.required, second.required) == pytest.approx((whole / 2, whole / 2))
    assert further
    assert [row.required for row in further] == pytest.approx([0.33 * whole] * len(further))
    assert layout.diameter <= 0.05 * D


def test_inner_column_by_aci318() -> None:
    """Half of d from the face and from each other, 2 d along, A_v / s of the check, as far as v_u exceeds phi v_c."""
    results = solve_once(raft(1700e3, ACI))
    layout = punching_links(results)[0]
    demand = max((each for (_, name), each in two_way(results).found.items() if name == "A"), key=lambda each: each.v_u)
    lambda_s = math.sqrt(2 / (1 + 0.004 * 442))
    v_c = 0.166 * lambda_s * math.sqrt(30)
    per_meter = (demand.v_u / 1e6 / 0.75 - v_c) * demand.b_o / 413.6
    s = 0.22
    for number, perimeter in enumerate(layout.perimeters, start=1):
        assert perimeter.distance == pytest.approx(number * s)
        assert perimeter.required == pytest.approx(per_meter * s, rel=1e-6)
        assert perimeter.provided >= perimeter.required
        assert perimeter.spacing <= 2 * D
    assert layout.diameter <= D / 16
    # beyond: V_u on the perimeter d / 2 outside the outermost, which all pressure inside only relieves
    a = layout.perimeters[-1].distance + D / 2
    assert demand.force / ((1.6 + 2 * math.pi * a) * D) < 1.3 * 0.75 * v_c * 1e6


@pytest.mark.parametrize(
    ("steel", "force", "changes", "why"),
    [
        (STEEL, 2000e3, {}, "more than 1.5 v_Rd,c"),
        (STEEL, 2500e3, {}, "v_Rd,max at the face"),
        (STEEL, 320e3, {"thickness": 0.19}, "thinner than 200 mm"),
        (ACI, 3000e3, {}, "stirrups do not suffice"),
        ({"code": "EN 1992-1-1:2023"} | STEEL, 1200e3, {}, "12.5.1"),
        (STEEL | {"proposal": {"link_diameters": [0.004]}}, 1500e3, {}, "closer than 100 mm"),
    ],
)
def test_reason_is_given_where_no_links_are_laid(
    steel: dict[str, Any], force: float, changes: dict[str, Any], why: str
) -> None:
    """In the layout and in the table: links that do not help, or that cannot be laid."""
    results = solve_once(raft(force, steel, **changes))
    layouts = punching_links(results)
    assert why in layouts[0].why
    table = next(table for table in tables_of(results) if table.name == "shear_reinforcement")
    assert why in str(table["remark"][0])
    assert table["legs"] == (None,) * len(layouts)


def test_nothing_is_said_where_concrete_alone_resists() -> None:
    """No layout and no table; none without reinforcement either."""
    results = solve_once(raft(600e3))
    assert punching_links(results) == ()
    assert "shear_reinforcement" not in {table.name for table in tables_of(results)}
    without = replace(results, model=results.model.model_copy(update={"reinforcement": None}))
    assert punching_links(without) == ()


def test_tables_have_legs_and_mass_of_links() -> None:
    """Perimeter by perimeter with a total, and a row for each column in the quantities of bars."""
    results = solve_once(raft(1500e3))
    layouts = punching_links(results)
    tables = {table.name: table for table in tables_of(results)}
    links, bars = tables["shear_reinforcement"], tables["bars"]
    number, mass = sum(layout.number for layout in layouts), sum(layout.mass for layout in layouts)
    assert sum(int(n) for n in links["legs"][:-1] if n is not None) == links["legs"][-1] == number
    assert links["mass"][-1] == pytest.approx(mass)
    rows = [row for row in bars.rows() if row[1] == "links"]
    assert [(row[2], row[7]) for row in rows] == [(f"column {each.name}", each.number) for each in layouts]
    marks = [row[0] for row in bars.rows()[:-1]]
    assert marks == list(range(1, len(marks) + 1))
    alone = sum(float(row[12] or 0) for row in bars.rows()[:-1] if row[1] != "links")
    schedule = tables["bending_schedule"]
    of_links = [layer == "links" for layer in schedule["layer"]]
    bent = sum(mass for mass, is_link in zip(schedule["mass"], of_links, strict=True) if is_link)
    assert bent > mass  # with their hooks
    assert bars["mass"][-1] == pytest.approx(alone + bent)


def test_links_at_ends_of_walls_follow_their_perimeters() -> None:
    """A wall 0.4 m thick: legs along a_1 / 2 = 0.4 m of both sides, around the corners and across the end."""
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.5, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        walls=[{"name": "W", "thickness": 0.4, "points": [(-3, 0), (0, 0)]}],
        cases=[{"name": "G"}],
        loads=[{"kind": "line", "q": -1.0, "q_end": 100e3, "wall": "W", "case": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
    )
    one = synthetic.results(24, model=model, combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    x, y = one.plate.nodes.T
    plate = replace(one.plate, shear_x=-350e3 * x, shear_y=-350e3 * y)
    results = Results(model, model.combinations, {"ULS": replace(one, plate=plate)}, {})
    (layout,) = punching_links(results)
    assert (layout.support, layout.place) == ("wall end", (0.0, 0.0))
    wall = box(-0.4, -0.2, 0.0, 0.2)
    for perimeter in layout.perimeters:
        a = perimeter.distance
        assert perimeter.length == pytest.approx(0.4 + 2 * 0.4 + math.pi * a, rel=1e-3)
        assert perimeter.provided >= perimeter.required
        assert perimeter.spacing <= 1.5 * 0.455
        for place in perimeter.places:
            assert wall.distance(Point(place)) == pytest.approx(a, abs=1e-3)
            assert place[0] >= -0.4


def test_links_over_a_pile() -> None:
    """A pile that pushes needs links from below: around its circle, by the demand of punching over piles."""
    model = raft(1.0).replace(
        columns=[],
        loads=[{"kind": "uniform", "q": 55e3, "case": "G"}],
        ground={"kind": "winkler", "k": 2e6},
        supports=[{"kind": "point", "name": "P", "x": 0.0, "y": 0.0, "stiffness": 200e6, "diameter": 0.4}],
    )
    results = solve_once(model)
    (layout,) = punching_links(results)
    assert (layout.support, layout.name) == ("pile", "P")
    for perimeter in layout.perimeters:
        assert np.hypot(*perimeter.places.T) == pytest.approx(0.2 + perimeter.distance, rel=1e-3)
        assert perimeter.provided >= perimeter.required


def test_links_that_would_never_end_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where perimeters do not grow outwards, or no section beyond stirrups resists, no row after row is laid."""
    # forces of no other test, which would have the same results
    monkeypatch.setattr(aci318_links, "MOST_ROWS", 1)
    assert "would go on beyond" in punching_links(solve_once(raft(1710e3, ACI)))[0].why
    monkeypatch.setattr(en1992_links, "FARTHEST", 0.5)
    assert "would go on beyond" in punching_links(solve_once(raft(1520e3)))[0].why


def test_no_links_are_told_that_cannot_be_built(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where links would end nowhere, neither the check nor its calculation has their area, number or distance."""
    monkeypatch.setattr(punching_demand, "FARTHEST", 0.5)
    results = solve_once(raft(1510e3))
    (check,) = [each for each in check_design(results).checks if each.name == "punching within 2 d"]
    assert check.status == "fails"
    assert check.words.endswith("; links would go on beyond 10 d from the face, as perimeters hardly grow outwards")
    assert "cm2" not in check.words
    assert not {"A_sw", "n_L", "a_out"} & symbols(results)


def symbols(results: Results) -> set[Any]:
    """Return the symbols of the calculations of a case."""
    (steps,) = [table for table in tables_of(results) if table.name == "calculations"]
    return set(steps["symbol"])


def test_no_links_are_told_that_do_not_suffice() -> None:
    """Above 1.5 v_Rd,c the calculation ends with that; below it has area, number and distance."""
    assert {"A_sw", "n_L", "a_out"} <= symbols(solve_once(raft(1500e3)))
    assert not {"A_sw", "n_L", "a_out"} & symbols(solve_once(raft(4000e3)))


def test_column_at_a_corner_by_en1992() -> None:
    """Perimeters of a quarter: legs keep off both edges and are enough."""
    model = raft(1.0).replace(
        columns=[{"name": "A", "x": 3.7, "y": 2.2, "width_x": 0.4, "width_y": 0.4}],
        loads=[{"kind": "point", "P": 360e3, "column": "A", "case": "G"}],
    )
    results = solve_once(model)
    (layout,) = punching_links(results)
    assert_rules_of_en1992(results, layout)
    for perimeter in layout.perimeters:
        assert (perimeter.places <= np.array([4.0, 2.5]) - 0.043).all()
