"""What punches at ends of walls against equilibrium: all that a short wall carries less the pressure inside."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from shapely import LineString, Polygon

import groundslab as gs
from groundslab.design.codes.en1992_2004.checks.wall_ends import STEPS, wall_demands
from groundslab.design.codes.en1992_2004.perimeters import openings
from groundslab.design.rules.wall_ends import WallPunching, punching_walls
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh
from groundslab.results.results import CombinationResult, Results

#: Thickness and length of a wall no longer than twice as thick, so that both ends together are all of it [m]; its load.
T, LENGTH, Q = 0.5, 0.9, 1000e3
A, B, H, K = 6.0, 5.0, 0.6, 40e6
STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.06), "top": (0.05, 0.06)}


def solve(E: float, *points: tuple[float, float], **changes: Any) -> Results:
    """Return results of a slab under one wall through points."""
    parts: dict[str, Any] = {
        "plate": {"length_x": A, "length_y": B, "thickness": H, "E": E, "nu": 0.2},
        "ground": {"kind": "winkler", "k": K},
        "walls": [{"name": "W", "thickness": T, "points": points}],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "line", "q": Q, "wall": "W", "case": "G"}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.0}}],
        "reinforcement": STEEL,
        "mesh": {"size": 0.1},
    }
    return gs.solve(gs.Model(**parts | changes))


def at_ends(combined: Results) -> list[WallPunching]:
    """Return what punches at the ends."""
    steel = combined.model.reinforcement
    assert steel is not None
    return [*punching_walls(combined, steel, STEPS, lambda _, d: openings(d))]


def pressure_inside(results: CombinationResult, part: Polygon) -> float:
    """Return the contact pressure on a part of the plate [N]."""
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    shares = load_vectors.integrate_over_polygon(mesh, np.arange(len(mesh.elements)), part)
    return float((shares * results.plate.pressure[mesh.elements]).sum())


@pytest.mark.parametrize("degrees", [90.0, 35.0])
def test_both_ends_of_a_short_wall_take_what_it_carries(degrees: float) -> None:
    """The perimeters of both ends close: their forces are the load less the pressure inside, at all distances."""
    along = np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])
    middle = np.array([0.4, -0.3])
    start, end = (tuple(map(float, middle + sign * LENGTH / 2 * along)) for sign in (-1, 1))
    combined = solve(30e9, start, end)
    first, last = at_ends(combined)
    results = combined["ULS"]
    area = LineString([start, end]).buffer(T / 2, cap_style="flat")
    for k, distance in enumerate(first.site.perimeters.distances):
        inside = area.buffer(distance, quad_segs=64)
        assert first.site.perimeters.u[k] + last.site.perimeters.u[k] == pytest.approx(inside.length, rel=1e-3)
        expected = Q * LENGTH - pressure_inside(results, inside)
        assert first.V[k] + last.V[k] == pytest.approx(expected, rel=5e-3), distance


def test_the_end_of_a_wall_on_a_rigid_slab() -> None:
    """An even pressure q l / A; through the middle of the wall no shear force passes: half of all of it at each end."""
    combined = solve(1e15, (-LENGTH / 2, 0.0), (LENGTH / 2, 0.0))
    even = Q * LENGTH / (A * B)
    d = H - 0.055
    demands = wall_demands(combined)
    for name in ("start of W", "end of W"):
        demand = demands.found["ULS", name]
        assert demand.d == pytest.approx(d)
        for stress in demand.around:
            a = stress.distance
            half = LENGTH / 2 * (T + 2 * a) + T * a + math.pi / 2 * a**2
            assert stress.V_Ed == pytest.approx(Q * LENGTH / 2 - even * half, rel=5e-3)
            u = LENGTH + T + math.pi * a
            assert stress.v_Ed == pytest.approx(1.35 * stress.V_Ed / (u * d), rel=1e-3)


def test_mirrored_walls_have_the_same_values() -> None:
    """An L of two walls, mirrored and drawn the other way around."""
    L = [(-1.0, -1.2), (1.5, -1.2), (1.5, 1.0)]
    both = []
    for points in (L, [(-x, y) for x, y in reversed(L)]):
        demands = wall_demands(solve(30e9, *points, mesh={"size": 0.25}))
        both.append({demand.place: demand.around for demand in demands.found.values()})
    there, mirrored = both
    assert len(there) == len(mirrored) == 3
    for (x, y), around in there.items():
        for one, other in zip(around, mirrored[-x, y], strict=True):
            assert (one.u, one.V_Ed) == pytest.approx((other.u, other.V_Ed), rel=1e-4)


def test_the_told_error_holds() -> None:
    """On a coarse mesh the force at each distance is off by no more than twice what is told, and 1 % of the largest."""
    points = (-1.5, -0.6), (1.0, -0.6)
    coarse, fine = (at_ends(solve(30e9, *points, mesh={"size": size})) for size in (0.4, 0.1))
    for one, other in zip(coarse, fine, strict=True):
        off = np.abs(one.V - other.V)
        told = np.array([one.error(k) for k in range(len(one.V))])
        assert (off <= 2 * told + 0.01 * other.V.max()).all()
