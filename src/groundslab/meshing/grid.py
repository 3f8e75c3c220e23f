"""Grids on plans in which everything runs along x and y."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import GRADING, count_intervals, divide_graded, graded_size, grid
from groundslab.geometry.plan import MOST_ELEMENTS, Plan
from groundslab.geometry.regions import NOTHING, sections
from groundslab.meshing.plan_mesh import PlanMesh, check, finish, too_many_elements
from groundslab.meshing.sizing import growth_distance

#: Neighboring intervals of a grid may differ by this factor before the longer one is graded.
SIMILAR = 1.5


def rectilinear(
    plan: Plan, size: float, beyond_growth: float | None = None, edge_size: float | None = None
) -> PlanMesh:
    """Return a grid with lines through all corners and points of a plan in which everything runs along x or y."""
    check(plan, size)
    if not plan.rectilinear:
        raise InputError([Issue("plan", "an oblique edge or an arc", "edges along x and y", "mesh it unstructured")])
    scale = growth_distance(plan, beyond_growth)
    corners = np.array([point for ring in plan.rings().values() for point in ring.points])
    others = np.array([*plan.points, *(point for line in plan.lines for point in line)]).reshape(-1, 2)
    outline = np.array([point for ring in plan.outlines for point in ring.points])
    domain = outline if plan.beyond is None else np.array(plan.beyond.points)
    lines = []
    for axis in (0, 1):
        breaks = _apart(np.concatenate([corners[:, axis], others[:, axis]]), plan.extent)
        low, high = domain[:, axis].min(), domain[:, axis].max()
        plate = outline[:, axis].min(), outline[:, axis].max()
        edges = [np.array(ring.points)[:, axis] for ring in plan.edges_on_ground()]
        limit = graded_size(np.unique(np.concatenate([np.zeros(0), *edges])), edge_size or size)
        lines.append(_divide(breaks[(breaks >= low) & (breaks <= high)], size, plate, scale, limit))
    x, y = lines
    if (len(x) - 1) * (len(y) - 1) > 4 * MOST_ELEMENTS:
        raise InputError([too_many_elements()])
    whole = grid(x, y)
    section = sections(plan, whole.nodes[whole.elements[:, 8]])
    kept = section != NOTHING
    return finish(plan, whole.nodes, whole.elements[kept], section[kept])


def _apart(values: Array, extent: float) -> Array:
    """Return values ascending, of those that are one place only the first given: an edge before a support on it."""
    ascending, first = np.unique(values, return_index=True)
    place = np.concatenate([[0], np.cumsum(np.diff(ascending) > 1e-8 * extent)])
    order = np.lexsort((first, place))
    different: Array = ascending[order[np.unique(place[order], return_index=True)[1]]]
    return different


def _divide(
    breaks: Array, size: float, plate: tuple[float, float], scale: float, limit: Callable[[Array], Array]
) -> Array:
    """Return lines through all breaks, at most `size` apart, further where d / scale says so at d from the plate.

    Nowhere are they further apart than `limit` says.

    Each interval is divided evenly at first; then those beside shorter ones are graded towards these.
    """

    def wanted(x: Array) -> Array:
        beyond: Array = np.maximum(0.0, np.maximum(plate[0] - x, x - plate[1]))
        return np.minimum(size * (1 + beyond / scale), limit(x))

    spans = list(pairwise(breaks.tolist()))
    counts = np.array([count_intervals(wanted, low, high) for low, high in spans])
    even = counts / np.ceil(counts - 1e-9)
    lows, highs = breaks[:-1], breaks[1:]
    at_low, at_high = even * wanted(lows), even * wanted(highs)
    lines = [breaks[:1]]
    for i, (low, high) in enumerate(spans):

        def wanted_here(x: Array, i: int = i) -> Array:
            target: Array = even[i] * wanted(x)
            near, sides = [*highs[:i], *lows[i + 1 :]], [*at_high[:i], *at_low[i + 1 :]]
            for place, side in zip(near, sides, strict=True):
                target = np.minimum(target, SIMILAR * side + GRADING * np.abs(x - place))
            return target

        lines.append(divide_graded(wanted_here, low, high))
    return np.concatenate(lines)
