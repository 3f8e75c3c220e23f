"""What describes the same problem has the same answer: elsewhere, in other units, in another order, beside others."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, NoEquilibrium, check_design, solve
from groundslab.design.codes.en1992_2004 import perimeter_demand
from groundslab.design.demands import line_properties
from groundslab.results.results import CombinationResult, results_of
from groundslab.views.tables.result_tables import tables_of
from helpers.similar import move_validated, rescale
from helpers.solve_once import solve_once

#: Answers may differ by this share of their largest value.
SAME = 1e-6
FIELDS = ("settlement", "pressure", "moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
GROUNDS: dict[str, dict[str, Any]] = {
    "springs": {"kind": "winkler", "k": 2e7},
    "pasternak": {"kind": "pasternak", "k0": 2e7, "k1": 3e7},
    "vlasov": {"kind": "vlasov", "layers": [{"thickness": 4.0, "E": 20e6, "nu": 0.3}]},
    "continuum": {"kind": "continuum", "layers": [{"thickness": 4.0, "E": 20e6, "nu": 0.3}], "cell": 0.5},
    "modulus": {"kind": "constrained modulus", "layers": [{"thickness": 4.0, "E": 20e6, "nu": 0.3}]},
}
#: A rectangle, an angle, and a curved outline, of which none lies about x = y = 0.
OUTLINES: dict[str, dict[str, Any]] = {
    "rectangle": {"kind": "rectangle", "x": (0, 6), "y": (0, 4)},
    "angle": {"kind": "polygon", "points": [(0, 0), (6, 0), (6, 3), (3, 3), (3, 5), (0, 5)]},
    "circle": {"kind": "circle", "centre": (3, 2.5), "radius": 2.5},
}
FAR_AWAY = {"rectangle": (1e7, 1e7), "angle": (32_450_000.0, 5_400_000.0), "circle": (-4e5, 3.1)}


def slab(ground: str, outline: str = "rectangle", **keys: Any) -> Model:
    """Return a slab that lifts off at a side, under a force at the other one and its own weight."""
    usual: dict[str, Any] = {
        "plate": {"name": "A", "outline": OUTLINES[outline], "thickness": 0.25, "E": 30e9, "nu": 0.2},
        "ground": GROUNDS[ground],
        "beyond": {"kind": "infinite"},
        "loads": [
            {"kind": "self weight", "unit_weight": 25e3},
            {"kind": "point", "P": 400e3, "x": 1.25, "y": 1.25, "width_x": 0.4, "width_y": 0.4},
            {"kind": "line", "q": 20e3, "points": [(1, 2), (2.5, 2.5)]},
        ],
        "mesh": {"size": 0.8},
    }
    return Model.model_validate(usual | keys)


def assert_same(one: CombinationResult, other: CombinationResult, length: float = 1.0, force: float = 1.0) -> None:
    """Hold the fields of two results to each other, of which the second one has other units of length and force."""
    assert other.certificate.holds
    units = {"settlement": length, "pressure": force / length**2} | dict.fromkeys(FIELDS[2:5], force)
    for name in FIELDS:
        a, b = getattr(one.plate, name), getattr(other.plate, name) / units.get(name, force / length)
        np.testing.assert_allclose(b, a, rtol=0, atol=SAME * np.abs(a).max(), err_msg=name)
    assert one.plate.contact_share == pytest.approx(other.plate.contact_share, abs=SAME)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ground", "outline"),
    [
        ("springs", "rectangle"),
        ("pasternak", "circle"),
        ("vlasov", "angle"),
        ("continuum", "circle"),
        ("modulus", "angle"),
    ],
)
def test_where_a_plan_lies_changes_nothing(ground: str, outline: str) -> None:
    """A slab in a national grid, with its zone in front or not, has the answer of the slab near x = y = 0."""
    here, by = slab(ground, outline), FAR_AWAY[outline]
    there = solve(move_validated(here, by)).only
    one = solve(here).only
    assert 0.3 < one.plate.contact_share < 1
    assert_same(one, there)
    np.testing.assert_allclose(there.plate.nodes - by, one.plate.nodes, atol=2e-8)


def test_tables_tell_places_in_a_national_grid() -> None:
    """Tables hold coordinates of the plan as it was given, and CSV files keep their millimeters."""
    by = FAR_AWAY["angle"]
    points = [{"name": "corner", "x": 0.5, "y": 0.75}]
    model = move_validated(slab("springs", output={"points": points}), by)
    tables = {table.name: table for table in tables_of(results_of(solve(model).only))}
    (x,), (y,) = tables["points"]["x"], tables["points"]["y"]
    assert (x, y) == (by[0] + 0.5, by[1] + 0.75)
    assert "32450000.5,5400000.75" in tables["points"].csv()


@pytest.mark.slow
@pytest.mark.parametrize(("lengths", "forces"), [(1e-3, "pressures stay"), (1e3, "forces stay")])
@pytest.mark.parametrize("ground", GROUNDS)
def test_the_unit_of_length_changes_nothing(ground: str, lengths: float, forces: str) -> None:
    """All lengths times a factor, loads and moduli with them by their dimensions: settlements are times the factor."""
    supports = [{"kind": "point", "x": 5.0, "y": 3.0, "stiffness": 2e7, "acts": "in compression"}]
    if ground in ("continuum", "modulus"):
        supports = []
    model, factor = slab(ground, supports=supports), lengths**2 if forces == "pressures stay" else 1.0
    assert_same(solve_once(model).only, solve(rescale(model, lengths, factor)).only, lengths, factor)


@pytest.mark.parametrize("lengths", [1e-3, 1e3])
def test_thin_slab_on_a_support_in_other_units(lengths: float) -> None:
    """A slab of which rotations are large beside settlements, on a stiff support, is certified in any unit."""
    model = Model.model_validate(
        {
            "plate": {"length_x": 2.0, "length_y": 1.4, "thickness": 0.0014, "E": 153.57e9, "nu": 0.0},
            "ground": {"kind": "pasternak", "k0": 334.83e6, "k1": 37.203e9},
            "beyond": {"kind": "infinite"},
            "supports": [{"kind": "point", "x": 0.5, "y": 0.35, "stiffness": 1e10}],
            "loads": [
                {"kind": "uniform", "q": 7732.8},
                {"kind": "line", "q": 10826.0, "points": [(-1.0, -0.7), (2 / 3, 0.7)]},
            ],
            "mesh": {"size": 0.467},
        }
    )
    assert_same(solve(model).only, solve(rescale(model, lengths, lengths**2)).only, lengths, lengths**2)


#: Ground that carries nothing over so far, and a layer on a rigid base, in which nothing is left there, either. Cells
#: of pressure are the same with and without the other plate.
APART: dict[str, dict[str, Any]] = {"springs": {}, "pasternak": {"beyond": {"kind": "none"}}, "continuum": {}}
DISTANCE = 250


@pytest.mark.slow
@pytest.mark.parametrize("load", [1e-9, 1e9])
@pytest.mark.parametrize("ground", APART)
def test_a_plate_far_away_changes_nothing(ground: str, load: float) -> None:
    """A second plate far away, its load from next to nothing to a thousand million times as much, is not felt."""
    alone = slab(ground, **APART[ground])
    far = {"name": "B", "outline": {"kind": "rectangle", "x": (DISTANCE, DISTANCE + 6), "y": (0, 4)}}
    plates = [far | {"thickness": 0.25, "E": 30e9, "nu": 0.2}]
    loads = [load.model_copy(update={"plate": "A"}) if load.kind == "self weight" else load for load in alone.loads]
    press = {"kind": "uniform", "q": 1e4 * load, "plate": "B"}
    results = solve(slab(ground, plates=plates, loads=[*loads, press], **APART[ground])).only
    one = solve_once(alone).only
    assert results.certificate.holds
    first = results.plate.part(results.plate.nodes[results.plate.elements[:, 8], 0] < DISTANCE / 2)
    for name in FIELDS:
        a, b = getattr(one.plate, name), getattr(first, name)
        np.testing.assert_allclose(b, a, rtol=0, atol=SAME * np.abs(a).max(), err_msg=name)


@pytest.mark.slow
@pytest.mark.parametrize("ground", GROUNDS)
def test_order_and_cases_change_nothing(ground: str) -> None:
    """Loads in another order, and one case split in two that act together, have the same answer."""
    model = slab(ground)
    one = solve(model).only
    assert_same(one, solve(model.replace(loads=model.loads[::-1])).only)
    cases = [{"name": name, "action": "permanent"} for name in ("G", "H")]
    named = [load.replace(case=case) for load, case in zip(model.loads, ("G", "H", "G"), strict=True)]
    together = [{"name": "both", "limit_state": "characteristic", "factors": {"G": 1.0, "H": 1.0}}]
    assert_same(one, solve(slab(ground, loads=named, cases=cases, combinations=together)).only)


@pytest.mark.parametrize("ground", ["springs", "pasternak"])
def test_order_of_columns_changes_nothing(ground: str) -> None:
    """Columns and their loads in another order carry and punch the same."""
    columns = [{"name": n, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4} for n, x, y in (("a", 1, 1), ("b", 5, 3))]
    loads = [{"kind": "point", "P": P, "column": n, "case": "G"} for n, P in (("a", 3e5), ("b", 1e5))]
    checked: dict[str, Any] = {
        "cases": [{"name": "G"}],
        "combinations": [{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}],
        "reinforcement": {"concrete": "C30/37", "steel": "B500B", "bottom": (0.05, 0.06), "top": (0.05, 0.06)},
    }
    one, other = (
        solve(slab(ground, columns=some, loads=acting, **checked))
        for some, acting in ((columns, loads), (columns[::-1], loads[::-1]))
    )
    assert_same(one.only, other.only)
    used, used_too = (
        {(check.name, check.of): check.utilization for check in check_design(results).checks if check.utilization}
        for results in (one, other)
    )
    assert any("punching" in name for name, _ in used)
    assert used == pytest.approx(used_too, rel=1e-5)


def test_columns_punch_alike_in_a_national_grid() -> None:
    """Perimeters at an edge and inside have the lengths, shapes and forces that they have near x = y = 0."""
    here, by = slab("springs", mesh={"size": 0.5}), np.array(FAR_AWAY["angle"])
    plates = [solve(each).only.plate for each in (here, move_validated(here, FAR_AWAY["angle"]))]
    for x, y in ((0.2, 2.0), (0.2, 0.2), (3.0, 2.0)):
        near = perimeter_demand.RectangularColumn(x, y, 0.4, 0.4)
        far = perimeter_demand.RectangularColumn(x + by[0], y + by[1], 0.4, 0.4)
        one, other = (perimeter_demand.demand(p, c, 0.2, 1e5) for p, c in zip(plates, (near, far), strict=True))
        assert (other.u, other.V_Ed) == pytest.approx((one.u, one.V_Ed), rel=SAME)
        shapes = [line_properties.shape_of(each.perimeter.legs)[0] for each in (one, other)]
        assert shapes[0] == shapes[1]
        np.testing.assert_allclose(other.perimeter.legs - by, one.perimeter.legs, atol=2e-8)


def test_messages_say_where_things_are_in_the_plan_that_was_given() -> None:
    """A load that topples a slab in a national grid is named where it is, to the millimeter."""
    loads = [{"kind": "point", "P": 2e5, "x": 5.999, "y": 2.0}, {"kind": "point", "P": -1e5, "x": 1.0, "y": 2.0}]
    toppling = move_validated(slab("springs", loads=loads), FAR_AWAY["angle"])
    with pytest.raises(NoEquilibrium, match=r"x = 32450010\.998 m, y = 5400002 m.*\(x 32450000 \.\. 32450006 m"):
        solve(toppling)
