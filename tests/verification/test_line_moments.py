"""Moments along lines against statics and a beam on springs (Hetenyi 1946)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult

#: Sides of the plate [m], modulus of its springs [Pa/m], moment along the line [N m/m].
A, B, K, M = 6.0, 4.0, 20e6, 5e3


def solve(plate: dict[str, Any], mesh: dict[str, Any], *loads: dict[str, Any]) -> CombinationResult:
    """Return the results of a plate on springs that pull, too."""
    return groundslab.solve(
        Model(
            plate=plate,
            ground={"kind": "winkler", "k": K},
            contact={"tensionless": False},
            loads=[{"kind": "line moment", **load} for load in loads],
            mesh=mesh,
        )
    ).only


ARC = {"points": [(1.0, 0.0), (0.0, 1.0)], "bulges": [math.tan(math.pi / 8)]}


@pytest.mark.parametrize(
    ("line", "moments"),
    [
        ({"points": [(0.7, -1.0), (0.7, 1.5)]}, (-2.5 * M, 0.0)),
        ({"points": [(-1.0, -1.0), (2.0, 1.0)]}, (-2.0 * M, 3.0 * M)),
        ({"points": [(-1.0, 0.5), (2.0, 0.5)], "m_end": 3 * M}, (0.0, 3.0 * 2 * M)),
        ({"points": [(-1.0, 0.0), (5.0, 0.0)]}, (0.0, 4.0 * M)),
        (ARC, (-M, -M)),
        ({"shape": {"kind": "circle", "radius": 1.5}}, (0.0, 0.0)),
    ],
    ids=["along y", "oblique", "growing", "over the edge", "quarter of a circle", "circle"],
)
def test_a_rigid_slab_tilts_by_the_sum_of_the_couples(line: dict[str, Any], moments: tuple[float, float]) -> None:
    """The couples m n ds, n to the left of the line, tilt it by their sum over k times the moment of inertia."""
    plate = {"length_x": A, "length_y": B, "thickness": 1.0, "E": 3e15, "nu": 0.2}
    result = solve(plate, {"size": 0.5}, {"m": M, **line}).plate
    x, y = result.nodes.T
    tilt_x, tilt_y = moments[0] / (K * B * A**3 / 12), moments[1] / (K * A * B**3 / 12)
    largest = M / (K * B * A**2 / 12)
    np.testing.assert_allclose(result.settlement, tilt_x * x + tilt_y * y, atol=1e-5 * largest)


def test_a_strip_bends_as_a_beam_under_a_couple() -> None:
    """Half of the couple goes to either side; settlements and moments of an infinite beam, away from the line."""
    t, E = 0.3, 30e9
    wave = (K / (4 * E * t**3 / 12)) ** 0.25
    plate = {"length_x": 24.0, "length_y": 0.5, "thickness": t, "E": E, "nu": 0.0}
    result = solve(plate, {"counts": (96, 2)}, {"m": M, "points": [(0.0, 0.25), (0.0, -0.25)]})
    x = np.array([0.5, 1.0, 1.5, 2.5, 4.0])
    decay = np.exp(-wave * x)
    settlement = M * wave**2 / K * decay * np.sin(wave * x)
    moment = M / 2 * decay * np.cos(wave * x)
    for side in (1, -1):
        found = result.plate.value_at("settlement", side * x, 0.0)
        np.testing.assert_allclose(found, side * settlement, atol=0.005 * settlement.max())
        found = result.plate.value_at("moment_x", side * x, 0.0)
        np.testing.assert_allclose(found, side * moment, atol=0.005 * M / 2)


def test_a_ring_bends_the_middle_of_a_round_slab_uniformly() -> None:
    """A free round slab on soft springs under a couple m on a circle, inside pressed down, by Kirchhoff's theory.

    Slopes are continuous at the circle of radius b, and the radial moment jumps by m there and vanishes at the edge
    r = a: inside it is m / 2 (1 + nu + (1 - nu) b^2 / a^2) in every direction.
    """
    a, b, nu = 3.0, 1.5, 0.2
    outline = {"kind": "circle", "radius": a}
    plate = {"outline": outline, "thickness": 0.3, "E": 30e9, "nu": nu}
    model = Model(
        plate=plate,
        ground={"kind": "winkler", "k": 1e3},
        contact={"tensionless": False},
        loads=[{"kind": "line moment", "m": M, "shape": {"kind": "circle", "radius": b}}],
        mesh={"size": 0.15},
    )
    result = groundslab.solve(model).plate
    inside = np.hypot(*result.nodes.T) < b - 0.5
    wanted = M / 2 * (1 + nu + (1 - nu) * (b / a) ** 2)
    np.testing.assert_allclose(result.moment_x[inside], wanted, rtol=0.01)
