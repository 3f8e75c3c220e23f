"""What lies inside closed curves of straight edges and arcs, and in which section of a plan."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.geometry.plan import FLAT, Place, Plan, Ring, Segment, bounding_box

#: Section of a place that is not meshed at all; see `sections`.
NOTHING = -2
#: Section of a place where ground lies and no plate.
GROUND = -1

#: Counts work that is about to be done, and raises where it is too much.
Spend = Callable[[int], None]


class Region:
    """Closed edges with a search tree, for repeated tests of what lies inside or near."""

    def __init__(self, edges: Iterable[Segment]) -> None:
        from shapely import STRtree

        self.edges = tuple(edges)
        self.tree = STRtree([bounding_box([edge]) for edge in self.edges])
        self.far = max((edge.bounds[1] for edge in self.edges), default=-math.inf)

    def holds(self, place: Place, spend: Spend | None = None) -> bool:
        """Return whether the edges wind around a place; none counts but those that meet the ray to its right."""
        from shapely import LineString

        met = self.tree.query(LineString([place, (max(self.far, place[0]), place[1])]))
        if spend is not None:
            spend(len(met))
        return _wind_around(place, [self.edges[k] for k in met])

    def find_near(self, edge: Segment, tolerance: float) -> list[int]:
        """Return the numbers of the edges whose boxes come near that of an edge."""
        near = self.tree.query(bounding_box([edge]), predicate="dwithin", distance=tolerance)
        return sorted(near.tolist())


def _wind_around(place: Place, edges: Iterable[Segment]) -> bool:
    """Return whether closed edges wind around a place: around by the chords, once more between an arc and its chord."""
    winding = 0
    for edge in edges:
        side = _side(edge, place)
        if edge.start[1] <= place[1] < edge.end[1] and side > 0:
            winding += 1
        elif edge.end[1] <= place[1] < edge.start[1] and side < 0:
            winding -= 1
        if side * edge.sweep < 0 and math.dist(place, edge.centre) < edge.radius:
            winding += 1 if edge.sweep > 0 else -1
    return winding != 0


def _side(edge: Segment, place: Place) -> float:
    """Return a positive number for a place on the left; on a chord it counts as slightly higher, then farther right."""
    return edge.side(place) or (edge.end[0] - edge.start[0]) or (edge.start[1] - edge.end[1])


def sections(plan: Plan, places: Array) -> Integers:
    """Return the section at each place (p, 2): GROUND where there is ground only, NOTHING where nothing is meshed."""
    import shapely

    def inside(ring: Ring) -> Flags:
        return np.asarray(shapely.contains_xy(ring.polygon(FLAT * plan.extent), places[:, 0], places[:, 1]), dtype=bool)

    section = np.full(len(places), NOTHING, dtype=np.int64)
    if plan.beyond is not None:
        section[inside(plan.beyond)] = GROUND
    empty = section.copy()
    starts = np.array([0, *(number for _, number in plan.others)])
    for ring, number in zip(plan.outlines, starts, strict=True):
        section[inside(ring)] = number
    of_plates = section.copy()
    for ring, number in plan.zones:
        section[inside(ring) & (of_plates == starts[starts <= number].max())] = number
    for ring in plan.openings:
        cut = inside(ring)
        section[cut] = empty[cut]
    return section
