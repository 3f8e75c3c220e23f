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
#: Largest number of places along an edge at which smaller elements are required.
MAX_SOURCES = 200

#: Places and the largest size [m] of elements around each: (k, 2) and (k,).
Sources = tuple[Array, Array]


def sources(plan: Plan, size: float, edge_size: float) -> Sources:
    """Return where a plan needs elements smaller than `size`, and how small: short edges, arcs, narrow places.

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
            ask(where, edges[j].distance(where) / 2)
    for ring in plan.edges_on_ground():
        where = along(ring, edge_size)
        ask(where, np.full(len(where), edge_size))
    return np.concatenate(places), np.concatenate(sizes)


def along(ring: Ring, spacing: float) -> Array:
    """Return places along a ring about a spacing apart."""
    edges = ring.segments()
    counts = [max(1, math.ceil(edge.length / spacing)) for edge in edges]
    return np.concatenate([edge.at(np.arange(n) / n) for edge, n in zip(edges, counts, strict=True)])


def growth_distance(plan: Plan, given: float | None) -> float:
    """Return the distance from the plate at which elements are twice as large [m]."""
    if given is not None and not given > 0:
        raise InputError([Issue("mesh.beyond_growth", f"{given!r}", "a length greater than 0")])
    outline = np.array(plan.outline.flat(FLAT * plan.extent))
    return float(np.ptp(outline, axis=0).max()) / 2 if given is None else given


def cell_sizes(plan: Plan, size: float, smaller: Sources, scale: float) -> Callable[[Array], Array]:
    """Return a function from places (p, 2) to twice the wanted sizes (p,) [m] there.

    Twice, since cells are halved afterwards: `size` on the plate, growing on the ground beyond until it is twice that
    at a distance `scale` [m], less near `smaller`.
    """
    import shapely
    from scipy.spatial import KDTree

    places, sizes = smaller
    level = np.ceil(2 * np.log2(size / sizes)).astype(np.int64)
    near = [(2 * size * 2 ** (-k / 2), KDTree(places[level == k])) for k in np.unique(level)]
    plate = plan.outline.polygon(1e-3 * plan.extent)
    shapely.prepare(plate)

    def wanted(at: Array) -> Array:
        result = np.full(len(at), 2 * size)
        if plan.beyond is not None:
            result *= 1 + shapely.distance(plate, shapely.points(at)) / scale
        for least, tree in near:
            result = np.minimum(result, least + GRADING * tree.query(at)[0])
        return result

    return wanted
