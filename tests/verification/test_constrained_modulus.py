"""Ground that settles by constrained moduli, against stresses of the half-space in closed form."""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import groundslab
from groundslab import CombinationResult
from groundslab.verification.analytic_half_space import compression, vertical_stress

LAYERS = [{"E": 10e6, "nu": 0.0, "thickness": 2.0}, {"E": 30e6, "nu": 0.0, "thickness": 6.0}]
SIDES = 4.0, 3.0
Q = 50e3


def solve_flexible(ground: dict[str, Any] | None = None, **more: Any) -> CombinationResult:
    """Return the results of a plate so soft that it follows the ground (elastic length 0.1 m), under a uniform load."""
    plate = {"length_x": SIDES[0], "length_y": SIDES[1], "thickness": 0.05, "E": 2e8, "nu": 0.2}
    kind = {"kind": "constrained modulus", "layers": LAYERS}
    loads = [{"kind": "uniform", "q": Q}]
    case = {"plate": plate, "ground": kind | (ground or {}), "loads": loads, "mesh": {"size": 0.25}, **more}
    return groundslab.solve(groundslab.Model.model_validate(case)).only


def settle(x: float, y: float, pressure: float = Q, deepest: float = np.inf) -> float:
    """Return the settlement of the layers by a uniform pressure on the rectangle, in closed form."""
    total, top = 0.0, 0.0
    for layer in LAYERS:
        bottom = top + layer["thickness"]
        if top < deepest:
            total += float(compression(x, y, top, min(bottom, deepest), SIDES)) * pressure / layer["E"]
        top = bottom
    return total


@pytest.mark.parametrize("place", [(0.0, 0.0), (1.0, 0.5), (0.0, 1.0)])
def test_a_flexible_slab_settles_by_the_stresses_below_it(place: tuple[float, float]) -> None:
    """Boussinesq's stresses, integrated by Steinbrenner, over each layer's modulus."""
    found = solve_flexible()
    assert found.plate.value_at("settlement", *place) == pytest.approx(settle(*place), rel=5e-3)


def test_beyond_the_slab_the_ground_settles_too() -> None:
    """The same integrals, beside the loaded rectangle."""
    found = solve_flexible(beyond={"kind": "infinite", "width": 4.0})
    assert found.ground.value_at(4.0, 0.0) == pytest.approx(settle(4.0, 0.0), rel=2e-2)
    assert found.ground.value_at(0.0, 3.5) == pytest.approx(settle(0.0, 3.5), rel=2e-2)


def test_pressures_up_to_the_relief_settle_by_reloading() -> None:
    """Q - sigma_e by first loading, sigma_e with moduli four times as large."""
    found = solve_flexible({"relief": 20e3, "reloading": 4.0})
    expected = settle(0.0, 0.0, Q - 20e3) + settle(0.0, 0.0, 20e3) / 4
    assert found.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(expected, rel=5e-3)


def test_nothing_settles_below_the_limit_depth() -> None:
    """There the stress below the middle is a fifth of the overburden, with water from 1 m."""
    weights = {"unit_weight": 19e3, "groundwater": 1.0, "unit_weight_below_water": 9e3}
    found = solve_flexible({"limit_ratio": 0.2} | weights)

    def excess(z: float) -> float:
        overburden = 19e3 * min(z, 1.0) + 9e3 * max(z - 1.0, 0.0)
        return float(vertical_stress(0.0, 0.0, z, SIDES)) * Q - 0.2 * overburden

    depth = brentq(excess, 0.5, 8.0)
    assert found.constants.limit_depth == pytest.approx(depth, rel=2e-3)
    expected = settle(0.0, 0.0, deepest=depth)
    assert found.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(expected, rel=5e-3)


def test_between_boreholes_settlements_are_interpolated() -> None:
    """Along their line linearly, from the settlement of one column to twice as much, but for kinks at its ends."""
    soft = [layer | {"E": layer["E"] / 2} for layer in LAYERS]
    holes = [{"x": -1.5, "y": 0.0, "layers": LAYERS}, {"x": 1.5, "y": 0.0, "layers": soft}]
    found = solve_flexible(boreholes=holes)
    assert found.certificate.holds
    for x, factor in ((-0.75, 1.25), (0.0, 1.5), (0.75, 1.75)):
        assert found.plate.value_at("settlement", x, 0.0) == pytest.approx(factor * settle(x, 0.0), rel=2e-3)
