"""Loads on the ground beside the plate against closed forms of strips on Pasternak ground, and by reciprocity."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.results.results import CombinationResult

#: Ground [Pa/m], [Pa m] and the length over which its surface dies out [m].
K0, K1 = 20e6, 45e6
A = math.sqrt(K0 / K1)
#: Half the width of a strip of plate, and where the load on the ground begins and ends [m].
L, X1, X2, Q = 2.0, 3.0, 5.0, 60e3
PASTERNAK = {"kind": "pasternak", "k0": K0, "k1": K1}
SOIL = [{"thickness": 3.0, "E": 20e6, "nu": 0.3}, {"thickness": 4.0, "E": 50e6, "nu": 0.25}]
LAYERS = [{"k0": 4e7, "k1": 2e7}, {"k0": 6e7, "k1": 5e7}]
GROUNDS: dict[str, dict[str, Any]] = {
    "pasternak": PASTERNAK,
    "vlasov": {"kind": "vlasov", "layers": SOIL, "gamma": 1.5},
    "interface": {
        "kind": "layered",
        "coupling": "interface",
        "layers": LAYERS,
    },
    "consistent": {"kind": "layered", "coupling": "consistent", "layers": SOIL},
}


def on_ground(q: float = Q, x: tuple[float, float] = (X1, X2), y: tuple[float, float] = (-0.5, 0.5)) -> dict[str, Any]:
    """Return a pressure on a rectangle of the ground."""
    return {"kind": "patch", "on": "ground", "q": q, "x": x, "y": y}


def strip(E: float, loads: list[dict[str, Any]], size: float = 0.125, **changes: object) -> CombinationResult:
    """Return the results of a strip of plate, 1 m long, on ground that goes on at its sides and ends with it."""
    plate = {"length_x": 2 * L, "length_y": 1.0, "thickness": 0.5, "E": E, "nu": 0.0}
    parts = {
        "plate": plate,
        "ground": PASTERNAK,
        "beyond": {"kind": "infinite", "sides": ["left", "right"]},
        "contact": {"tensionless": False},
        "loads": loads,
        "mesh": {"size": size},
    }
    return solve(Model.model_validate(parts | changes)).only


def alone(x: float) -> float:
    """Return the settlement [m] of ground without a plate at x <= X1, from k1 w'' - k0 w + q = 0."""
    return Q / (2 * K0) * (math.exp(-A * (X1 - x)) - math.exp(-A * (X2 - x)))


def test_ground_alone_settles_as_by_the_closed_form() -> None:
    """A plate of next to no stiffness follows the ground beside a loaded strip."""
    results = strip(1e4, [on_ground()])
    for x in (-L, 0.0, 1.0, L):
        assert results.plate.value_at("settlement", x, 0.0) == pytest.approx(alone(x), rel=2e-5)
    inside = Q / K0 * (1 - (math.exp(-A * 1.0) + math.exp(-A * 1.0)) / 2)
    assert results.ground.value_at(4.0, 0.0) == pytest.approx(inside, rel=1e-4)
    assert results.certificate.ground_load == pytest.approx(Q * 2.0 * 1.0)


def test_rigid_strip_tilts_towards_the_load() -> None:
    """A rigid strip glued to the ground: w = c0 + c1 x from the balance of pressures and both line forces.

    Outside, w = alone(L) exp(a s) + B exp(-a s) with s from the edge; the jump of k1 w' there is the line force.
    """
    results, w_p = strip(3e15, [on_ground()]), alone(L)
    c0 = K1 * A * w_p / (K0 * L + K1 * A)
    c1 = K1 * A * w_p / (K0 * L**2 / 3 + K1 + K1 * A * L)
    for x in (-L, L):
        assert results.plate.value_at("settlement", x, 0.0) == pytest.approx(c0 + c1 * x, rel=1e-4)
    assert results.certificate.holds


def test_load_that_begins_at_the_edge() -> None:
    """What presses on nodes that plate and ground share presses on the ground alone: rigid strip as before."""
    results = strip(3e15, [on_ground(x=(L, X2))])
    w_p = Q / (2 * K0) * (1 - math.exp(-A * (X2 - L)))
    c0 = K1 * A * w_p / (K0 * L + K1 * A)
    c1 = K1 * A * w_p / (K0 * L**2 / 3 + K1 + K1 * A * L)
    for x in (-L, L):
        assert results.plate.value_at("settlement", x, 0.0) == pytest.approx(c0 + c1 * x, rel=1e-4)
    plate = results.plate
    assert (plate.pressure * plate.area + plate.line_force * plate.edge_length).sum() == pytest.approx(0, abs=1e-3 * Q)
    assert results.certificate.load == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("kind", GROUNDS)
def test_reciprocity(kind: str) -> None:
    """A load on the plate moves the ground under a load beside it as much as this one moves the plate under it.

    Both are of the same size, and each way is the work of one load on the settlement by the other (Betti).
    """
    parts: dict[str, Any] = {
        "plate": {"length_x": 4.0, "length_y": 3.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": GROUNDS[kind],
        "beyond": {"kind": "infinite", "width": 5.0},
        "contact": {"tensionless": False},
        "mesh": {"size": 0.5},
    }
    beside = on_ground(x=(2.5, 4.5), y=(-1.0, 2.0))
    on_plate = {"kind": "patch", "q": Q, "x": (0.5, 1.5), "y": (-1.0, 0.5)}
    by_beside, by_plate = (solve(Model.model_validate(parts | {"loads": [load]})).only for load in (beside, on_plate))
    points, weights = np.polynomial.legendre.leggauss(12)

    def mean(x: tuple[float, float], y: tuple[float, float], value: Any) -> float:
        X, Y = np.meshgrid(*((b + a) / 2 + (b - a) / 2 * points for a, b in (x, y)))
        area = (x[1] - x[0]) * (y[1] - y[0])
        return float(area / 4 * (weights @ value(X, Y) @ weights))

    moved_plate = mean((0.5, 1.5), (-1.0, 0.5), lambda x, y: by_beside.plate.value_at("settlement", x, y))
    moved_ground = mean((2.5, 4.5), (-1.0, 2.0), by_plate.ground.value_at)
    assert moved_plate == pytest.approx(moved_ground, rel=2e-3)
    assert by_beside.certificate.holds
    assert by_plate.certificate.holds


@pytest.mark.parametrize("kind", GROUNDS)
def test_one_sided_contact(kind: str) -> None:
    """A slab that its own weight presses down stays in equilibrium, tilts towards the load, and the proof holds."""
    results = solve(
        Model.model_validate(
            {
                "plate": {"length_x": 4.0, "length_y": 3.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
                "ground": GROUNDS[kind],
                "beyond": {"kind": "infinite", "width": 5.0},
                "loads": [{"kind": "self weight", "unit_weight": 25e3}, on_ground(x=(2.0, 6.0), y=(-2.0, 2.0))],
                "mesh": {"size": 0.5},
            }
        )
    ).only
    assert results.certificate.holds
    assert results.certificate.load == pytest.approx(25e3 * 0.3 * 12.0, rel=1e-12)
    assert results.plate.contact_force.sum() == pytest.approx(results.certificate.load, rel=1e-6)
    near, far = (results.plate.value_at("settlement", x, 0.0) for x in (2.0, -2.0))
    assert near > 1.2 * far


def test_a_load_in_an_opening_is_one_on_the_ground() -> None:
    """What fills an opening presses on the ground there: its mean settlement grows by a load that the slab lacks."""
    plate = {
        "outline": {"kind": "rectangle", "x": (0, 6), "y": (0, 6)},
        "openings": [{"kind": "rectangle", "x": (2, 4), "y": (2, 4)}],
        "thickness": 0.3, "E": 30e9, "nu": 0.2,
    }  # fmt: skip
    weight = {"kind": "self weight", "unit_weight": 25e3}
    parts = {"plate": plate, "ground": PASTERNAK, "beyond": {"kind": "infinite"}, "mesh": {"size": 0.5}}
    empty, filled = (
        solve(Model.model_validate(parts | {"loads": loads})).only
        for loads in ([weight], [weight, on_ground(x=(1.0, 5.0), y=(2.0, 4.0))])
    )
    assert filled.certificate.holds
    assert filled.certificate.ground_load == pytest.approx(Q * 4.0)
    assert filled.ground.value_at(3.0, 3.0) > empty.ground.value_at(3.0, 3.0) + 0.2 * Q / K0


def test_half_and_whole_plate_settle_alike() -> None:
    """Of loads on both sides that are alike a quarter is computed, with the same result."""
    loads = [on_ground(), on_ground(x=(-X2, -X1)), {"kind": "uniform", "q": 10e3}]
    quarter = strip(30e9, loads)
    full = strip(30e9, loads, mesh={"size": 0.125, "symmetry": "off"})
    assert quarter.symmetry == (True, True)
    assert strip(30e9, loads[1:]).symmetry == (False, True)
    assert quarter.plate.settlement.max() == pytest.approx(full.plate.settlement.max(), rel=1e-9)
    assert quarter.certificate.ground_load == pytest.approx(full.certificate.ground_load, rel=1e-12)
