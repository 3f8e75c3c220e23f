"""The edges of a plan cut where they meet: pieces that share nothing but their ends, for meshers that cannot cut."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.geometry.intersections import find_crossings
from groundslab.geometry.plan import FLAT, SAME_PLACE, Place, Plan, Segment, bounding_box
from groundslab.geometry.regions import NOTHING, sections

#: Crossings this close to an end that both edges have, relative to the extent, are this end: an arc that leaves a line
#: as its tangent crosses it again nearby, by rounding.
AT_THE_END = 1e-4


class Piece(NamedTuple):
    """A piece of an edge, and whether anything is meshed on its left and on its right."""

    edge: Segment
    left: bool
    right: bool


def pieces(plan: Plan) -> tuple[list[Piece], list[Place]]:
    """Return the pieces that a mesh must follow, and those points of the plan that lie on none of them.

    Pieces with nothing meshed on either hand are left out, and pieces of zones with one section on both.
    """
    edges, optional, curve = _edges(plan)
    vertices = Vertices(plan)
    cuts = [{vertices.number(edge.start), vertices.number(edge.end)} for edge in edges]
    points = [vertices.number(point) for point in plan.points]
    places = np.array(vertices.places)
    for cut, edge in zip(cuts, edges, strict=True):
        cut |= set(np.flatnonzero(edge.distance(places) <= 2 * vertices.same).tolist())
    for i, j in _neighbours(edges, 4 * vertices.same):
        if curve[i] != curve[j]:
            _cut(edges[i], edges[j], cuts[i], cuts[j], vertices)
    kept: list[tuple[Segment, bool]] = []
    by_ends: dict[frozenset[Place], list[int]] = {}
    for edge, cut, optionally in zip(edges, cuts, optional, strict=True):
        for piece in _split_edge(edge, [vertices.places[k] for k in cut], 2 * vertices.same):
            alike = by_ends.setdefault(frozenset((piece.start, piece.end)), [])
            twin = [k for k in alike if math.dist(kept[k][0].middle, piece.middle) <= vertices.near]
            if twin:
                kept[twin[0]] = kept[twin[0]][0], kept[twin[0]][1] and optionally
            else:
                alike.append(len(kept))
                kept.append((piece, optionally))
    result = _label_sides(plan, kept)
    ends = {vertices.number(place) for piece in result for place in (piece.edge.start, piece.edge.end)}
    return result, [vertices.places[k] for k in dict.fromkeys(points) if k not in ends]


class Vertices:
    """Places where pieces end, each once: those the plan names first, then crossings."""

    def __init__(self, plan: Plan) -> None:
        self.same, self.near, self.end = (part * plan.extent for part in (SAME_PLACE, FLAT, AT_THE_END))
        self.places: list[Place] = []

    def number(self, place: Place, tolerance: float = 0.0) -> int:
        """Return the number of a place, a new one if there is none yet as close as the tolerance [m]."""
        if self.places:
            distance = np.linalg.norm(np.array(self.places) - place, axis=1)
            nearest = int(distance.argmin())
            if distance[nearest] <= max(self.same, tolerance):
                return nearest
        self.places.append((float(place[0]), float(place[1])))
        return len(self.places) - 1


def _edges(plan: Plan) -> tuple[list[Segment], list[bool], list[int]]:
    """Return all edges, whether a mesh need follow them only where sections change, and the curve of each."""
    edges: list[Segment] = []
    optional: list[bool] = []
    curve: list[int] = []
    for k, (name, ring) in enumerate(plan.rings().items()):
        segments = ring.segments()
        edges += segments
        optional += [name.startswith("plate.zones")] * len(segments)
        curve += [k] * len(segments)
    lines = plan.line_segments()
    return edges + lines, optional + [False] * len(lines), curve + [-1 - k for k in range(len(lines))]


def _neighbours(edges: list[Segment], distance: float) -> list[tuple[int, int]]:
    """Return pairs of edges whose boxes are no further apart than a distance [m]."""
    import shapely

    boxes = [bounding_box([edge]) for edge in edges]
    pairs = shapely.STRtree(boxes).query(boxes, predicate="dwithin", distance=distance).T
    return sorted((i, j) for i, j in pairs.tolist() if i < j)


def _cut(first: Segment, second: Segment, cuts: set[int], others: set[int], vertices: Vertices) -> None:
    """Add the places where two edges cross to the ends of the pieces of both."""
    shared = [vertices.places[k] for k in cuts & others]
    for place in find_crossings(first, second):
        if any(math.dist(place, end) <= vertices.end for end in shared):
            continue
        if all(edge.holds(place, 2 * vertices.same) for edge in (first, second)):
            k = vertices.number(place, vertices.near)
            cuts.add(k)
            others.add(k)


def _part(edge: Segment, place: Place, same: float) -> float:
    """Return after which part of an edge a place comes that is on it but for rounding [m]."""
    if math.dist(place, edge.start) <= same:
        return 0.0
    return 1.0 if math.dist(place, edge.end) <= same else edge.part(place)


def _split_edge(edge: Segment, places: list[Place], same: float) -> list[Segment]:
    """Return the pieces of an edge between places on it, in any order, its ends among them."""
    parts = sorted((_part(edge, place, same), place) for place in places)
    if edge.straight:
        return [Segment(a, b) for (_, a), (_, b) in pairwise(parts)]
    return [
        Segment(a, b, edge.centre, edge.radius, edge.angle + first * edge.sweep, (last - first) * edge.sweep)
        for (first, a), (last, b) in pairwise(parts)
    ]


def _label_sides(plan: Plan, kept: list[tuple[Segment, bool]]) -> list[Piece]:
    """Return pieces with what lies beside their middles, without those that no mesh need follow."""
    middles = np.array([edge.middle for edge, _ in kept])
    angle = np.array([edge.direction(0.5) for edge, _ in kept]) + math.pi / 2
    length = np.array([edge.length for edge, _ in kept])
    step = np.clip(0.02 * length, 3 * FLAT * plan.extent, 100 * FLAT * plan.extent)[:, None]
    aside: Array = step * np.column_stack([np.cos(angle), np.sin(angle)])
    left, right = sections(plan, middles + aside), sections(plan, middles - aside)
    needed: Flags = (left != right) | ~np.array([optional for _, optional in kept])
    needed &= (left != NOTHING) | (right != NOTHING)
    return [Piece(kept[k][0], bool(left[k] != NOTHING), bool(right[k] != NOTHING)) for k in np.flatnonzero(needed)]
