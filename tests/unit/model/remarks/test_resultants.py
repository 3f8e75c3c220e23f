"""Vertical forces of load cases on plates, by hand."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.model.model import Model
from groundslab.model.remarks.resultants import case_forces

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
