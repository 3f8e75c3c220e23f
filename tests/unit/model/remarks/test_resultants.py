"""Vertical forces of load cases on plates, by hand."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.model.model import Model
from groundslab.model.remarks.resultants import case_forces, case_sums

#: 6 m x 4 m, 0.3 m thick, with an opening of 1 m x 1 m; two zones that overlap by half.
PLATE: dict[str, Any] = {
    "outline": {"kind": "rectangle", "x": (0, 6), "y": (0, 4)},
    "openings": [{"kind": "rectangle", "x": (4, 5), "y": (1, 2)}],
    "zones": [
        {"shape": {"kind": "rectangle", "x": (1, 2), "y": (1, 2)}, "thickness": 0.5},
        {"shape": {"kind": "rectangle", "x": (1.5, 2.5), "y": (1, 2)}, "thickness": 0.7},
    ],
    "thickness": 0.3,
    "E": 30e9,
    "nu": 0.2,
}
SECOND = {
    "name": "annex", "outline": {"kind": "rectangle", "x": (10, 12), "y": (0, 3)}, "thickness": 0.2, "E": 30e9,
    "nu": 0.2,
}  # fmt: skip


def force(*loads: dict[str, Any], **parts: Any) -> float:
    """Return the vertical force of some loads in kN."""
    model = Model(**{"plate": PLATE, "ground": {"kind": "winkler", "k": 2e7}, "loads": loads} | parts)
    return case_forces(model)[""] / 1e3


def test_self_weight_of_zones() -> None:
    """23 m2 without the opening: 0.5 m2 are 0.5 m thick, 1 m2 where the last zone counts 0.7 m, 21.5 m2 0.3 m."""
    weight = {"kind": "self weight", "unit_weight": 25e3}
    assert force(weight) == pytest.approx(25 * (0.5 * 0.5 + 1.0 * 0.7 + 21.5 * 0.3))


def test_loads_of_one_plate() -> None:
    """A load that names a plate acts there alone, one without a name on all: 6 m2 and 23 m2."""
    pressure = {"kind": "uniform", "q": 1e3}
    assert force(pressure, plates=[SECOND]) == pytest.approx(29)
    assert force(pressure | {"plate": "annex"}, plates=[SECOND]) == pytest.approx(6)


def test_what_varies_and_what_lies_off() -> None:
    """Q = 1 kPa + 2 kPa/m (x - 5.5 m) on 5 m < x < 7 m, of which 5 m to 6 m bear 1 kPa in the mean on 4 m."""
    patch = {"kind": "patch", "q": 1e3, "slope": (2e3, 0), "about": (5.5, 0), "x": (5, 7), "y": (0, 4)}
    assert force(patch) == pytest.approx(4)
    line = {"kind": "line", "q": 10e3, "q_end": 20e3, "points": [(5.5, 3), (6.5, 3)]}
    assert force(line) == pytest.approx(0.5 * (10 + 15) / 2)


def test_what_has_no_force() -> None:
    """Temperature has none, pressure beside the plate none on it, and a couple sums up to nothing but rounding."""
    beside = {"kind": "patch", "q": 1e3, "x": (7, 8), "y": (0, 4), "on": "ground"}
    couple = [{"kind": "point", "P": sign * 0.1e3 / 3, "x": 3 + sign, "y": 3} for sign in (-1, 1)]
    ground = {"kind": "pasternak", "k0": 2e7, "k1": 1e7}
    loads = ({"kind": "temperature", "difference": 10}, beside, *couple)
    assert force(*loads, ground=ground, beyond={"kind": "infinite"}) == 0.0


PLAIN: dict[str, Any] = {"outline": {"kind": "rectangle", "x": (0, 6), "y": (0, 4)}, "thickness": 0.3, "E": 30e9,
                         "nu": 0.2}  # fmt: skip
WHOLE = {"kind": "patch", "x": (0, 6), "y": (0, 4)}


@pytest.mark.parametrize(
    ("load", "expected"),
    [
        ({"kind": "point", "P": 10e3, "x": 5, "y": 1, "M_x": 2e3, "M_y": 3e3}, (10, 10 * 2 + 2, -10 * 1 + 3)),
        ({"kind": "line", "q": 0, "q_end": 10e3, "points": [(0, 4), (6, 4)]}, (30, 30 * (4 - 3), 30 * 2)),
        ({"kind": "line moment", "m": 2e3, "points": [(0, 2), (6, 2)]}, (0, 0, 2 * 6)),
        ({"kind": "patch", "q": 5e3, "x": (0, 2), "y": (0, 4)}, (40, 40 * (1 - 3), 0)),
        (WHOLE | {"q": 1e3, "slope": (0.5e3, 0), "about": (3, 2)}, (24, 0.5 * 4 * 6**3 / 12, 0)),
        (WHOLE | {"q": 0, "bend": (1e3, 0, 0)}, (4 * 6**3 / 6, 4 * (6**4 / 8 - 3 * 6**3 / 6), 0)),
        ({"kind": "self weight", "unit_weight": 25e3}, (25 * 0.3 * 24, 0, 0)),
    ],
)
def test_moments_about_the_middle(load: dict[str, Any], expected: tuple[float, float, float]) -> None:
    """Force and moments about (3 m, 2 m) by hand; q = x**2 / 2 has the moment of a cubic function."""
    load = load | {"case": "A"}
    model = Model(plate=PLAIN, ground={"kind": "winkler", "k": 2e7}, loads=[load], cases=[{"name": "A"}])
    total = case_sums(model)["A"]
    assert (total.F / 1e3, total.M_x / 1e3, total.M_y / 1e3) == pytest.approx(expected)


def test_a_case_that_moves_is_where_its_force_is_largest() -> None:
    """Of two wheels of 10 kN both act at x = 5 m, one at x = 7 m; 5 kN stand beside them."""
    model = Model(
        plate=PLAIN,
        ground={"kind": "winkler", "k": 2e7},
        cases=[{"name": "A"}],
        loads=[{"kind": "point", "P": 5e3, "x": 3, "y": 3, "case": "A"}],
        patterns=[{"kind": "vehicle", "name": "cart", "wheels": [{"P": 10e3}, {"P": 10e3, "x": -2}]}],
        moves=[{"pattern": "cart", "case": "A", "points": [(5, 2), (7, 2)], "step": 2}],
    )
    total = case_sums(model)["A"]
    assert (total.F / 1e3, total.M_x / 1e3, total.M_y / 1e3) == pytest.approx((25, 10 * 2 + 10 * 0, 5 * 1))
