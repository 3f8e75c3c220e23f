"""Several plates, and loads beside them, on an elastic continuum."""

from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab import CombinationResult
from groundslab.verification.analytic_half_space import surface_settlement

E_SOIL, NU = 30e6, 0.3
STIFF, SOFT = {"thickness": 0.5, "E": 30e9, "nu": 0.2}, {"thickness": 0.05, "E": 3e8, "nu": 0.2}


def square(x: float) -> dict[str, Any]:
    """Return a square of 4 m whose middle lies at x."""
    return {"kind": "rectangle", "x": (x - 2.0, x + 2.0), "y": (-2.0, 2.0)}


def pressure(x: float, q: float, **more: Any) -> dict[str, Any]:
    """Return a pressure on such a square."""
    return {"kind": "patch", "x": (x - 2.0, x + 2.0), "y": (-2.0, 2.0), "q": q, **more}


def solve(plates: list[tuple[float, dict[str, Any]]], loads: list[dict[str, Any]], **more: Any) -> CombinationResult:
    """Return the results of square plates with their middles at some x, on a half-space."""
    first, *others = [{"name": f"at {x:g}", "outline": square(x), **sheet} for x, sheet in plates]
    ground = {"kind": "continuum", "half_space": {"E": E_SOIL, "nu": NU}}
    case = {"plate": first, "plates": others, "ground": ground, "loads": loads, "mesh": {"size": 0.5}, **more}
    found = groundslab.solve(groundslab.Model.model_validate(case)).only
    assert found.certificate.holds
    return found


def test_a_far_plate_settles_the_other_as_a_force() -> None:
    """P (1 - nu^2) / (pi E r) at 60 m, where either is a point for the other."""
    load = [pressure(0.0, 50e3), pressure(60.0, 50e3)]
    both, alone = solve([(0.0, STIFF), (60.0, STIFF)], load), solve([(0.0, STIFF)], load[:1])
    more = both.plate.value_at("settlement", 0.0, 0.0) - alone.plate.value_at("settlement", 0.0, 0.0)
    assert more == pytest.approx(16 * 50e3 * (1 - NU**2) / (np.pi * E_SOIL * 60.0), rel=5e-3)


def test_neighbors_lean_towards_each_other() -> None:
    """Two plates alike are mirror images, deeper where they are close."""
    found = solve([(-2.5, STIFF), (2.5, STIFF)], [pressure(-2.5, 50e3), pressure(2.5, 50e3)])
    inner, outer = (found.plate.value_at("settlement", [-x, x], [0.0, 0.0]) for x in (0.6, 4.4))
    assert inner[0] == pytest.approx(inner[1], rel=1e-5)
    assert inner[0] > 1.05 * outer[0]


def test_a_surcharge_acts_as_a_plate_without_stiffness() -> None:
    """Pressure on the ground beside a plate, or on a plate so thin that it hands on what presses it."""
    beyond = {"kind": "infinite", "width": 2.0}
    surcharge = solve([(0.0, STIFF)], [pressure(0.0, 5e3), pressure(5.0, 50e3, on="ground")], beyond=beyond)
    thin = solve([(0.0, STIFF), (5.0, SOFT)], [pressure(0.0, 5e3), pressure(5.0, 50e3)])
    places = [-1.9, 0.0, 1.9], [0.0, 0.0, 0.0]
    expected = thin.plate.value_at("settlement", *places)
    np.testing.assert_allclose(surcharge.plate.value_at("settlement", *places), expected, rtol=3e-3)
    assert surcharge.certificate.ground_load == pytest.approx(16 * 50e3, rel=1e-9)


def test_the_ground_settles_under_a_surcharge() -> None:
    """As Love found, where the plate itself presses next to nothing."""
    loads = [pressure(0.0, 1.0), pressure(8.0, 50e3, on="ground")]
    found = solve([(0.0, SOFT)], loads, beyond={"kind": "infinite", "width": 2.0}, contact={"tensionless": False})
    for x in (8.0, 4.0, -1.0):
        expected = 50e3 * float(surface_settlement(x - 8.0, 0.0, (4.0, 4.0), E_SOIL, NU))
        value = found.ground.value_at(x, 0.0) if x > 2 else found.plate.value_at("settlement", x, 0.0)
        assert value == pytest.approx(expected, rel=2e-2)


def test_a_glued_plate_follows_a_surcharge_beside_it() -> None:
    """Without loads of its own it carries none, tilts towards the surcharge, and knows its error."""
    loads = [pressure(5.0, 50e3, on="ground")]
    found = solve([(0.0, STIFF)], loads, beyond={"kind": "infinite", "width": 2.0}, contact={"tensionless": False})
    near, far = found.plate.value_at("settlement", [1.9, -1.9], [0.0, 0.0])
    assert near > far > 0
    assert abs(found.plate.contact_force.sum()) < 1e-3
    assert found.comparison is not None
