"""Sizes of elements: where a plan requires smaller ones, and how they grow away from there."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import GRADING
from groundslab.geometry.plan import FLAT, Plan, Ring, Segment

#: An element's side turns by no more than this on an arc [rad].
TURN = math.pi / 8
#: Narrow places have so many elements across.
ACROSS = 2
#: Largest number of places along an edge at which smaller elements are required.
MAX_SOURCES = 200

#: Places and the largest size [m] of elements around each: (k, 2) and (k,).
Sources = tuple[Array, Array]


def sources(plan: Plan, size: float, edge_size: float, across: float = ACROSS) -> Sources:
    """Return where a plan needs elements smaller than `size`, and how small: short edges, arcs, narrow places.

    Narrow places have so many elements across.
    Along the plate's edges on ground that reaches beyond them elements are at most of `edge_size` [m].
    """
    import shapely

    edges = [edge for ring in plan.rings().values() for edge in ring.segments()] + plan.line_segments()
    same = FLAT * plan.extent
    flat = [shapely.LineString(edge.at(np.linspace(0, 1, edge.chords(same) + 1))) for edge in edges]
    flat += [shapely.Point(point) for point in plan.points]
    edges += [Segment(point, point) for point in plan.points]
    places, sizes = [np.zeros((0, 2))], [np.zeros(0)]

    def ask(where: Array, wanted: Array) -> None:
        small = wanted < size * (1 - 1e-9)
        places.append(where[small])
        sizes.append(wanted[small])

    for edge in edges:
        if edge.length > 0:
            wanted = edge.length if edge.straight else edge.length / math.ceil(abs(edge.sweep) / TURN - 1e-9)
            n = min(MAX_SOURCES, math.ceil(edge.length / min(wanted, size)) + 1)
            ask(edge.at(np.linspace(0, 1, n)), np.full(n, wanted))
    tree = shapely.STRtree(flat)
    for i, j in tree.query(flat, predicate="dwithin", distance=2 * size).T:
        gap = 0.0 if i == j else flat[i].distance(flat[j])
        if gap > 2 * same:
            n = min(MAX_SOURCES, math.ceil(2 * edges[i].length / gap) + 1)
            where = edges[i].at(np.linspace(0, 1, n))
            ask(where, edges[j].distance(where) / across)
    for ring in plan.edges_on_ground():
        where = along(ring, edge_size)
        ask(where, np.full(len(where), edge_size))
    return np.concatenate(places), np.concatenate(sizes)


def join(first: Sources, other: Sources | None) -> Sources:
    """Return the places of both, and the sizes around them."""
    if other is None:
        return first
    return np.concatenate([first[0], other[0]]), np.concatenate([first[1], other[1]])


def along(ring: Ring, spacing: float) -> Array:
    """Return places along a ring about a spacing apart."""
    edges = ring.segments()
    counts = [max(1, math.ceil(edge.length / spacing)) for edge in edges]
    return np.concatenate([edge.at(np.arange(n) / n) for edge, n in zip(edges, counts, strict=True)])


def growth_distance(plan: Plan, growth: float | None) -> float:
    """Return the distance from the plate at which elements are twice as large [m]."""
    if growth is not None and not growth > 0:
        raise InputError([Issue("mesh.beyond_growth", f"{growth!r}", "a length greater than 0")])
    x0, y0, x1, y1 = plan.plate_polygon(FLAT * plan.extent).bounds
    return max(x1 - x0, y1 - y0) / 2 if growth is None else growth


def limit_of(smaller: Sources, size: float, slope: float = GRADING) -> Callable[[Array], Array]:
    """Return a function from places (p, d) to the largest sizes (p,) [m] of elements that grow from smaller ones.

    The places of the smaller ones are (k, 2); their sizes are rounded down to `size` [m] over a power of
    the eighth root of 2. They grow by `slope` of the distance.
    """
    from scipy.spatial import KDTree

    places, sizes = smaller
    level = np.ceil(8 * np.log2(size / sizes)).astype(np.int64)
    near = [(size * 2 ** (-k / 8), KDTree(places[level == k])) for k in np.unique(level)[::-1]]

    def limit(at: Array) -> Array:
        result = np.full(len(at), np.inf)
        for least, tree in near:
            # the smallest come first: where they have been found, larger ones need not be looked for
            left = np.flatnonzero(result > least)
            reach = (result[left].max(initial=least) - least) / slope
            distance = tree.query(at[left], distance_upper_bound=reach)[0]
            result[left] = np.minimum(result[left], least + slope * distance)
        return result

    return limit


def quarter(bounds: tuple[float, float, float, float], wanted: Callable[[Array], Array]) -> tuple[Array, Array]:
    """Return squares about as large as the sizes wanted in their middles: their lower corners (k, 2) and sides (k,).

    They cover the rectangle x0, y0, x1, y1: one square is quartered until it is so.
    """
    x0, y0, x1, y1 = bounds
    side = max(x1 - x0, y1 - y0)
    corner = np.array([[(x0 + x1 - side) / 2, (y0 + y1 - side) / 2]])
    corners, sides = [np.zeros((0, 2))], [np.zeros(0)]
    while len(corner):
        small = wanted(corner + side / 2) < side
        corners.append(corner[~small])
        sides.append(np.full(int((~small).sum()), side))
        side /= 2
        corner = np.concatenate([corner[small] + side * np.array(step) for step in ((0, 0), (1, 0), (0, 1), (1, 1))])
        inside = (corner[:, 0] <= x1) & (corner[:, 1] <= y1) & (corner[:, 0] + side >= x0) & (corner[:, 1] + side >= y0)
        corner = corner[inside]
    return np.concatenate(corners), np.concatenate(sides)


def cell_sizes(plan: Plan, size: float, smaller: Sources, scale: float) -> Callable[[Array], Array]:
    """Return a function from places (p, 2) to twice the wanted sizes (p,) [m] there.

    Twice, since cells are halved afterwards: `size` on the plate, growing on the ground beyond until it is twice that
    at a distance `scale` [m], less near `smaller`.
    """
    import shapely

    limit = limit_of((smaller[0], 2 * smaller[1]), 2 * size)
    plate = plan.plate_polygon(1e-3 * plan.extent)
    shapely.prepare(plate)

    def wanted(at: Array) -> Array:
        result = np.full(len(at), 2 * size)
        if plan.beyond is not None:
            result *= 1 + shapely.distance(plate, shapely.points(at)) / scale
        smaller: Array = np.minimum(result, limit(at))
        return smaller

    return wanted
