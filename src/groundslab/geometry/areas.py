"""Areas in plan: polygons in place of closed curves, and their second moments."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Ring, Segment

if TYPE_CHECKING:
    from shapely import Polygon

#: A loaded area has its arcs replaced by chords of this angle [rad] at most, ARC_CHORDS of them at least.
ARC_STEP = 2 * math.pi / 512
ARC_CHORDS = 8


def equal_area_polygon(ring: Ring) -> Polygon:
    """Return the polygon inside a ring, its arcs replaced by chords that enclose the same area.

    The points between the ends of an arc lie a little off it, all as far: a uniform pressure keeps its force.
    """
    import shapely

    return shapely.Polygon(np.concatenate([_equal_area_points(edge)[:-1] for edge in ring.segments()]))


def _equal_area_points(edge: Segment) -> Array:
    """Return places (p, 2) from start to end of an edge, the area below their chords being that below the arc."""
    if edge.straight:
        return np.array([edge.start, edge.end])
    n = max(ARC_CHORDS, math.ceil(abs(edge.sweep) / ARC_STEP))
    step = abs(edge.sweep) / n
    places = edge.at(np.arange(n + 1) / n)
    # triangles with the centre: r and c r span the first and the last of them, c r and c r the n - 2 between; with
    # n step / sin(step) for the sectors' area, (n - 2) c^2 + 2 c equals it
    c = (math.sqrt(1 + (n - 2) * n * step / math.sin(step)) - 1) / (n - 2)
    centre = np.array(edge.centre)
    places[1:-1] = centre + c * (places[1:-1] - centre)
    return places


def inertia(part: Polygon) -> tuple[Array, Array]:
    """Return the center (2,) [m] of a polygon and its second moments of area about it (2, 2) [m4]."""
    from shapely import get_coordinates

    centre, moments = get_coordinates(part.centroid)[0], np.zeros((2, 2))
    for ring, sign in ((part.exterior, 1.0), *((hole, -1.0) for hole in part.interiors)):
        x = get_coordinates(ring) - centre
        a, b = x[:-1], x[1:]
        cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        # each edge makes a triangle with the center, whose moments its corners give
        total = np.einsum("e,ei,ej->ij", cross, a + b, a + b)
        total += np.einsum("e,ei,ej->ij", cross, a, a) + np.einsum("e,ei,ej->ij", cross, b, b)
        moments += sign * total / 24 * np.sign(cross.sum())
    return centre, moments
