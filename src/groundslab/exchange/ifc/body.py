"""Bodies as triangles in space: their level faces, and the rings, strips and thicknesses of these in plan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.geometry.plan import Place, Ring, circle

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Places so near in height are on one level [m]; corners so near a straight edge are none [m].
LEVEL, STRAIGHT = 1e-4, 1e-6
#: Shapes that differ by less than this part of an area are the same.
SAME_AREA = 1e-3
#: Curves become chords that turn by so much at most [radians].
TURN = 0.2
#: A ring of so many corners at one distance of its center is a circle, if that differs by less than this part.
ROUND_CORNERS, ROUND = 24, 1e-5
FARTHEST = 1e9  # m


@dataclass(frozen=True, slots=True)
class Body:
    """Points (n, 3) [m] and triangles (m, 3) between them."""

    points: Array
    triangles: Integers

    @property
    def top(self) -> float:
        """The largest height [m]."""
        return float(self.points[:, 2].max())

    @property
    def bottom(self) -> float:
        """The smallest height [m]."""
        return float(self.points[:, 2].min())

    def face(self, height: float) -> BaseGeometry:
        """Return the level face at a height in plan, empty if there is none."""
        off = np.abs(self.points[:, 2] - height)
        return self._in_plan(self.triangles[off[self.triangles].max(axis=1) <= LEVEL])

    def plan(self) -> BaseGeometry:
        """Return all that the body covers in plan."""
        return self._in_plan(self.triangles)

    def tilt(self) -> float:
        """Return the angle [degrees] between the largest faces that are not upright and a level plane."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        areas = np.linalg.norm(normals, axis=1)
        angles = np.degrees(np.arccos(np.clip(np.abs(normals[:, 2]) / np.maximum(areas, 1e-300), 0, 1)))
        lying = np.where(angles < 80, areas, 0.0)
        values, place = np.unique(np.round(angles, 2), return_inverse=True)
        return float(values[np.bincount(place, lying).argmax()])

    def _in_plan(self, triangles: Integers) -> BaseGeometry:
        """Return the union of triangles in plan."""
        import shapely

        corners = self.points[triangles][:, :, :2]
        (x1, y1), (x2, y2) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
        sizes = np.abs(x1 * y2 - x2 * y1)
        # upright triangles are lines in plan
        lying = sizes > STRAIGHT * np.abs(corners - corners[:, :1]).sum(axis=(1, 2))
        return shapely.union_all(shapely.polygons(corners[lying]))


def is_prismatic(body: Body) -> bool:
    """Return whether a body is a level plate: its corners are on two levels, which cover the same plan."""
    heights = body.points[:, 2]
    on_levels = np.minimum(np.abs(heights - body.top), np.abs(heights - body.bottom)) <= LEVEL
    top, bottom = body.face(body.top), body.face(body.bottom)
    alike = top.symmetric_difference(bottom).area <= SAME_AREA * top.area
    return bool(on_levels.all() and alike and body.top - body.bottom > LEVEL)


def to_ring(places: Array) -> Ring:
    """Return the curve through places (k, 2) [m], closed by repeating the first, without corners that are none.

    It runs counter-clockwise, coordinates are to a nanometer; many corners on a circle are that circle.
    """
    corners = _without_straight(np.asarray(places, dtype=float)[:-1])
    round_one = _circle_through(corners)
    if round_one is not None:
        return round_one
    ring = Ring(tuple(map(_rounded, corners)), (0.0,) * len(corners))
    return ring if ring.signed_area > 0 else Ring(ring.points[::-1], ring.bulges)


def _circle_through(corners: Array) -> Ring | None:
    """Return the circle that corners (k, 2) all around it lie on, None if there is none."""
    if len(corners) < ROUND_CORNERS:
        return None
    # x^2 + y^2 = 2 a x + 2 b y + c holds for all places on a circle about (a, b)
    local = corners - corners.mean(axis=0)
    (a, b, _), *_ = np.linalg.lstsq(np.column_stack((2 * local, np.ones(len(local)))), (local**2).sum(axis=1))
    radii = np.hypot(*(local - (a, b)).T)
    sides = np.hypot(*(np.roll(local, -1, axis=0) - local).T)
    if np.ptp(radii) > ROUND * radii.mean() or sides.max() > 2 * TURN * radii.mean():
        return None
    return circle(_rounded(corners.mean(axis=0) + np.array([a, b])), round(float(radii.mean()), 9))


def _without_straight(corners: Array) -> Array:
    """Return corners (k, 2) of a closed curve without those on the line between their neighbors."""
    kept = corners
    while len(kept) > 3:
        before, after = np.roll(kept, 1, axis=0), np.roll(kept, -1, axis=0)
        (x1, y1), (x2, y2) = (after - before).T, (kept - before).T
        off = np.abs(x1 * y2 - x2 * y1) / np.maximum(np.hypot(x1, y1), 1e-300)
        if off.min() > STRAIGHT:
            break
        kept = np.delete(kept, int(off.argmin()), axis=0)
    return kept


def _rounded(place: Array) -> Place:
    return round(float(place[0]), 9) + 0.0, round(float(place[1]), 9) + 0.0
