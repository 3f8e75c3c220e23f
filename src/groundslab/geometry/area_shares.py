"""What share of each element lies inside regions, whether the mesh follows their borders or not."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.geometry.plan import FLAT, Ring

#: Eight nodes around an element, in their order.
AROUND = np.array([0, 4, 1, 5, 2, 6, 3, 7])
#: A share of an element that differs from none or all by less than this does so by rounding.
ROUNDING = 1e-6


def shares(xy: Array, rings: Sequence[Ring], followed: Collection[int], extent: float) -> Array:
    """Return the share (m, 1 + r) of the area of each element (m, 9, 2) in no ring, and in each of r rings.

    Where rings overlap, the last one counts. Those that the mesh follows along arcs, by their numbers from 0 in
    `followed`, are judged by the centers of the elements, whose sides are parabolas there; all others by area.
    """
    import shapely

    share = np.zeros((len(xy), 1 + len(rings)))
    polygons = [ring.polygon(FLAT * extent) for ring in rings]
    x, y = xy[:, 8].T
    holder, crossed = np.zeros(len(xy), dtype=np.int64), np.zeros(len(xy), dtype=bool)
    cells = shapely.polygons(xy[:, AROUND]) if rings else np.zeros(0, dtype=object)
    tree = shapely.STRtree(cells)
    for number, (ring, polygon) in enumerate(zip(rings, polygons, strict=True), start=1):
        holder[shapely.intersects_xy(polygon, x, y)] = number
        if ring.straight or number - 1 not in followed:
            crossed[tree.query(polygon.boundary, predicate="intersects")] = True
    share[np.arange(len(xy)), holder] = 1.0
    cut = np.flatnonzero(crossed)
    if len(cut):
        share[cut] = _by_area(cells[cut], polygons)
    return share


def _by_area(cells: Array, polygons: Sequence[object]) -> Array:
    """Return the share (c, 1 + r) of the area of cells (c,) in no polygon and in each of r, the last one counting."""
    import shapely

    whole = shapely.area(cells)
    left, result = cells, np.zeros((len(cells), 1 + len(polygons)))
    for number in range(len(polygons), 0, -1):
        polygon = polygons[number - 1]
        shapely.prepare(polygon)
        meets: Flags = shapely.intersects(left, polygon)
        result[meets, number] = shapely.area(shapely.intersection(left[meets], polygon)) / whole[meets]
        left = left.copy()
        left[meets] = shapely.difference(left[meets], polygon)
    result[:, 0] = shapely.area(left) / whole
    result[result < ROUNDING] = 0.0
    exact: Array = result / result.sum(axis=1, keepdims=True)
    return exact
