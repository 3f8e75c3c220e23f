"""Perimeters around ends and corners of walls against a published example, and shear forces across them by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from shapely import Polygon, box

from groundslab.arrays import Array
from groundslab.design.demands.wall_perimeters import Course, course, loaded_area, wall_perimeters
from groundslab.design.rules.wall_ends import BETA
from groundslab.model.structure.wall_ends import WallEnd, wall_ends
from groundslab.model.structure.walls import Wall
from groundslab.results.plate_result import PlateResult
from helpers import synthetic

#: The end of a wall after "Beispiele zur Bemessung nach DIN 1045-1", vol. 1: thickness and distance of the perimeter
#: [m], as lengths of its straight pieces and arcs and shear forces on them are printed, and their sum [kN].
THICKNESS, DISTANCE = 0.35, 0.283
STRAIGHT, ARCS, ON_STRAIGHT, ON_ARCS, FORCE, STRESS = 1.05, 0.889, 209.12, 221.04, 416.08, 289.69
NOTHING = Polygon()


def end_of(thickness: float, *points: tuple[float, float], which: int = -1) -> WallEnd:
    """Return an end or a corner of a wall through points."""
    return wall_ends([Wall(name="W", thickness=thickness, points=points)])[which]


def lengths(line: Course) -> tuple[float, float]:
    """Return the lengths [m] of the straight pieces and of the arcs."""
    each = np.linalg.norm(line.legs[:, 1] - line.legs[:, 0], axis=1)
    return float(each[~line.turns].sum()), float(each[line.turns].sum())


def plate(shear: object = None) -> PlateResult:
    """Return a plate whose shear forces are a function of places (n, 2)."""
    made = synthetic.results(24).plate
    if not callable(shear):
        return made
    q = shear(made.nodes)
    return replace(made, shear_x=q[:, 0], shear_y=q[:, 1])


def test_the_published_end_of_a_wall() -> None:
    """Straight pieces of 2 b along and b across, a half circle of 1.5 d, and the stress with beta."""
    area = loaded_area(end_of(THICKNESS, (0, 0), (5, 0)), DISTANCE / 1.5)
    straight, arcs = lengths(course(area, DISTANCE))
    assert straight == pytest.approx(STRAIGHT)
    assert arcs == pytest.approx(ARCS, abs=5e-4)
    assert ON_STRAIGHT * straight + ON_ARCS * arcs == pytest.approx(FORCE, abs=0.1)
    assert BETA["end"] * FORCE / (straight + arcs) == pytest.approx(STRESS, abs=0.05)


@pytest.mark.parametrize(
    ("thickness", "length", "d", "across", "along"),
    [
        (0.3, 5.0, 0.5, 0.3, 0.3),  # a_1 = 2 b
        (0.3, 0.5, 0.5, 0.3, 0.25),  # a_1 = a
        (1.0, 5.0, 0.5, 1.0, 0.9),  # a_1 = 5.6 d - b_1
        (2.0, 5.0, 0.5, 1.4, 0.7),  # b_1 = 2.8 d
    ],
)
def test_the_lengths_that_count(thickness: float, length: float, d: float, across: float, along: float) -> None:
    """Each of the limits of Figure NA.6.12.1 by hand."""
    area = loaded_area(end_of(thickness, (0, 0), (length, 0)), d)
    assert area.across == pytest.approx(across)
    assert area.along == pytest.approx((along, along))
    straight, arcs = lengths(course(area, d))
    assert straight == pytest.approx(across + 2 * along)
    assert arcs == pytest.approx(math.pi * d, rel=1e-3)


@pytest.mark.parametrize("degrees", [90, 60, 115])
def test_the_perimeter_of_a_corner_runs_along_the_outer_faces(degrees: float) -> None:
    """Of a corner that turns by an angle: b along each leg and an arc of that angle, all at the distance from faces."""
    t, a, turn = 0.3, 0.4, math.radians(degrees)
    points = [(-4.0, 0.0), (0.0, 0.0), (4 * math.cos(turn), 4 * math.sin(turn))]
    end = end_of(t, *points, which=1)
    line = course(loaded_area(end, 0.5), a)
    straight, arcs = lengths(line)
    assert straight == pytest.approx(2 * t)
    assert arcs == pytest.approx(turn * a, rel=1e-3)
    walls = Wall(name="W", thickness=t, points=points).area(1e-3)
    away = [Polygon(walls.exterior).exterior.distance(point) for point in map(_point, line.legs.reshape(-1, 2))]
    assert away == pytest.approx([a] * len(away), rel=1e-6)


def test_the_point_of_a_sharp_corner_is_cut_off() -> None:
    """Across the end of the axes, b sin(turn / 2) long between both faces, as the end of a wall is."""
    t, a, turn = 0.3, 0.4, math.radians(150)
    end = end_of(t, (-4.0, 0.0), (0.0, 0.0), (4 * math.cos(turn), 4 * math.sin(turn)), which=1)
    straight, arcs = lengths(course(loaded_area(end, 0.5), a))
    assert straight == pytest.approx(2 * t + t * math.sin(turn / 2))
    assert arcs == pytest.approx(turn * a, rel=1e-3)


def _point(place: Array) -> object:
    """Return a place as a point."""
    from shapely import Point

    return Point(*place)


def test_the_force_across_the_end_of_a_wall() -> None:
    """Q = - c r from the end's axis: int c r n ds along sides, across and around quarter circles by hand."""
    t, d, c = 0.4, 0.5, 1e5
    area = loaded_area(end_of(t, (-3, 0), (0, 0)), d)
    distances = np.array([0.3, 0.6, 1.0])
    found = wall_perimeters(plate(lambda x: -c * x), box(-4.8, -3.6, 4.8, 3.6), area, distances, NOTHING)
    for a, u, V in zip(distances, found.u, found.shear(plate(lambda x: -c * x)), strict=True):
        along = min(2 * t, 5.6 * d - t) / 2
        assert u == pytest.approx(t + 2 * along + math.pi * a, rel=1e-3)
        assert pytest.approx(c * (2 * along * (t / 2 + a) + t * a + math.pi * a**2 + t * a), rel=1e-3) == V


@pytest.mark.parametrize("turn", [1, -1])
def test_the_force_across_a_corner(turn: int) -> None:
    """The same field around a right angle: along both outer faces and around a quarter circle by hand."""
    t, d, a, c = 0.4, 0.5, 0.6, 1e5
    area = loaded_area(end_of(t, (-3, 0), (0, 0), (0, turn * 3), which=1), d)
    some = plate(lambda x: -c * x)
    found = wall_perimeters(some, box(-4.8, -3.6, 4.8, 3.6), area, np.array([a]), NOTHING)
    along = min(2 * t, 5.6 * d - t) / 2
    assert found.u == pytest.approx([2 * along + math.pi / 2 * a], rel=1e-3)
    assert found.shear(some) == pytest.approx([c * (2 * along * (t / 2 + a) + math.pi / 2 * a**2 + a * t)], rel=1e-3)


def test_a_flow_across_has_the_sign_of_the_way_out() -> None:
    """An even q_x = - q, which leaves the end of a wall along x: q (b + 2 a); nothing of it at its sides."""
    t, d, a, q = 0.4, 0.5, 0.5, 1e5

    def flow(x: Array) -> Array:
        return np.column_stack([np.full(len(x), -q), np.zeros(len(x))])

    plan = box(-4.8, -3.6, 4.8, 3.6)
    for points, sign in (((-3, 0), (0, 0)), 1), (((3, 0), (0, 0)), -1):
        area = loaded_area(end_of(t, *points), d)
        found = wall_perimeters(plate(flow), plan, area, np.array([a]), NOTHING)
        assert found.shear(plate(flow)) == pytest.approx([sign * q * (t + 2 * a)], rel=1e-3)


def test_what_lies_off_the_plate_does_not_count() -> None:
    """An end e before the edge: 2 a asin(e / a) of the arcs are left; where it is less than a quarter, no perimeter."""
    t, d, e, a = 0.3, 0.5, 0.3, 0.5
    area = loaded_area(end_of(t, (0, 0), (4.8 - e, 0)), d)
    plan = box(-4.8, -3.6, 4.8, 3.6)
    found = wall_perimeters(plate(), plan, area, np.array([0.2, a, 0.9]), NOTHING)
    assert found.distances == pytest.approx([0.2, a])
    step = math.pi / 2 * a / 32
    assert found.u[1] == pytest.approx(2 * t + 2 * a * math.asin(e / a), abs=2 * step)
    beside = loaded_area(end_of(t, (0, -3.6 + t / 2), (2, -3.6 + t / 2)), d)
    (u,) = wall_perimeters(plate(), plan, beside, np.array([a]), NOTHING).u
    assert u == pytest.approx(t + t + math.pi / 2 * a, rel=1e-3)


@pytest.mark.parametrize("points", [((0, 0), (4.8, 0)), ((-4.65, -3.0), (-4.65, -3.6))])
def test_an_end_at_the_edge_has_no_perimeter(points: tuple[tuple[float, float], tuple[float, float]]) -> None:
    """Nothing runs around it: the wall cuts the slab there."""
    area = loaded_area(end_of(0.3, *points), 0.5)
    found = wall_perimeters(plate(), box(-4.8, -3.6, 4.8, 3.6), area, np.array([0.25, 0.5, 1.0]), NOTHING)
    assert not len(found.distances)
    assert found.shear(plate()).shape == (0,)


def test_the_shadow_of_openings_takes_off_length_only() -> None:
    """The piece across in a shadow does not count in u; what crosses it does in the force."""
    t, d, c = 0.4, 0.5, 1e5
    area = loaded_area(end_of(t, (-3, 0), (0, 0)), d)
    plan, a = box(-4.8, -3.6, 4.8, 3.6), np.array([0.5])
    whole, less = (
        wall_perimeters(plate(), plan, area, a, shadow) for shadow in (NOTHING, box(0.4, -t / 2, 0.6, t / 2))
    )
    assert whole.u - less.u == pytest.approx([t])
    some = plate(lambda x: -c * x)
    assert less.shear(some) == pytest.approx(whole.shear(some))
