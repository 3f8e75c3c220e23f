"""Lines joined end to end into closed curves."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.exchange.dxf.curves import DrawnLine
from groundslab.exchange.dxf.drawing import DOUBLE, MOST_BESIDE, OF_EDGE, ReadContext, Source
from groundslab.geometry.plan import Place, Ring, segment
from groundslab.geometry.regions import Region


class PointIndex:
    """Points that are one within a tolerance: the first of them stands for all."""

    def __init__(self, tolerance: float) -> None:
        self.points: list[Place] = []
        self.tolerance = tolerance
        self._cells: dict[tuple[int, int], list[int]] = defaultdict(list)

    def number(self, point: Place) -> int:
        """Return the number of a point, a new one if none is near."""
        column, row = (math.floor(value / self.tolerance) for value in point)
        for cell in ((column + i, row + j) for i in (0, -1, 1) for j in (0, -1, 1)):
            for number in self._cells.get(cell, ()):
                if math.dist(self.points[number], point) <= self.tolerance:
                    return number
        self.points.append(point)
        self._cells[column, row].append(len(self.points) - 1)
        return len(self.points) - 1


MOST_ENDS = 40  # open ends of a layer that are listed one by one
FEW = 4  # nearest other ends of which one may close a gap
ROUNDING = 1e-9  # of a distance
MOST_GAPS = 2  # widths of a gap by which an edge is made longer or shorter to close it


@dataclass(frozen=True)
class ClosedCurve:
    """A closed curve and the entities that it was made of."""

    curve: Ring
    sources: tuple[Source, ...]
    remarks: dict[Source, str]

    @cached_property
    def region(self) -> Region:
        """What the curve encloses."""
        return Region(self.curve.segments())


class _Link(NamedTuple):
    """An edge between numbered points; ``key`` is the same for all edges that lie on top of each other."""

    a: int
    b: int
    bulge: float
    source: Source
    key: tuple[int, int, int]

    def turned(self) -> _Link:
        """Return the edge from b to a."""
        return self._replace(a=self.b, b=self.a, bulge=-self.bulge)


def _make_links(source: Source, piece: DrawnLine, nodes: PointIndex, middles: PointIndex) -> list[_Link]:
    """Return the edges of a line without those that have no length."""
    links = []
    numbers = [nodes.number(point) for point in piece.points]
    for i, bulge in enumerate(piece.bulges):
        a, b = numbers[i], numbers[i + 1]
        if a != b:
            middle = middles.number(segment(piece.points[i], piece.points[i + 1], bulge).middle)
            links.append(_Link(a, b, bulge, source, (min(a, b), max(a, b), middle)))
    return links


def join_lines(lines: list[tuple[Source, DrawnLine]], tolerance: float, context: ReadContext) -> list[ClosedCurve]:
    """Return the closed curves that lines of one layer make, alone or end to end; doubles count once."""
    nodes, middles = PointIndex(tolerance), PointIndex(tolerance)
    remarks = {source: piece.remarks for source, piece in lines if piece.remarks}
    rings: list[list[_Link]] = []
    loose: list[_Link] = []
    opened: list[tuple[Source, list[_Link]]] = []
    seen: set[tuple[int, int, int]] = set()
    keys: set[frozenset[tuple[int, int, int]]] = set()
    for source, piece in lines:
        links = _make_links(source, piece, nodes, middles)
        key = frozenset(link.key for link in links)
        if not links:
            context.report_entity(source, False, "it has no length")
        elif links[0].a != links[-1].b:
            opened.append((source, links))
        elif key in keys:
            context.report_entity(source, False, DOUBLE)
        else:
            rings.append(links)
            keys.add(key)
            seen |= key
    for source, links in opened:
        fresh = [link for link in links if link.key not in seen]
        if not fresh:
            context.report_entity(source, False, DOUBLE)
        loose += fresh
        seen |= {link.key for link in fresh}
    rings += _find_rings(_close_gaps(loose, nodes, context), nodes, context)
    return [_close_ring(links, nodes, remarks) for links in rings]


def join_outlines(curves: list[ClosedCurve], tolerance: float, context: ReadContext) -> list[ClosedCurve]:
    """Return closed curves without the edges that two of them share, so that those that adjoin each other are one."""
    nodes, middles = PointIndex(tolerance), PointIndex(tolerance)
    for closed in curves:
        for point in closed.curve.points:
            nodes.number(point)
    links: list[_Link] = []
    for closed in curves:
        ends = (*closed.curve.points[1:], closed.curve.points[0])
        for start, end, bulge in zip(closed.curve.points, ends, closed.curve.bulges, strict=True):
            a, b = nodes.number(start), nodes.number(end)
            links += _split(_Link(a, b, bulge, closed.sources[0], (0, 0, 0)), nodes, middles, context)
    shared = Counter(link.key for link in links)
    ways = Counter((link.key, link.a) for link in links)
    for link in links:
        if ways[link.key, link.a] > 1:
            overlap = "a part of two outlines that lie on each other"
            context.issue([link.source], nodes.points[link.a], overlap, "outlines side by side")
            return curves
    left = [link for link in links if shared[link.key] == 1]
    if len(left) == len(links):
        return curves
    layer = Source(curves[0].sources[0].layer, "LAYER", "")
    context.report_entity(layer, True, f"{len(curves)} outlines were joined where they adjoin")
    rings = [_close_ring(ring, nodes, {}) for ring in _find_rings(left, nodes, context)]
    rings.sort(key=lambda ring: -ring.curve.area)
    of_first = {closed.sources[0]: closed for closed in curves}
    parts_of = [[of_first.pop(first) for first in ring.sources if first in of_first] for ring in rings]
    if rings:
        parts_of[0] += of_first.values()  # all of whose edges are shared
    return [
        ClosedCurve(ring.curve, tuple(source for part in parts for source in part.sources),
                    {source: why for part in parts for source, why in part.remarks.items()})
        for ring, parts in zip(rings, parts_of, strict=True)
    ]  # fmt: skip


def _split(link: _Link, nodes: PointIndex, middles: PointIndex, context: ReadContext) -> list[_Link]:
    """Return the parts of an edge between the corners of all outlines that lie on it, straight ones only."""
    start, end = (np.array(nodes.points[number]) for number in (link.a, link.b))
    length = math.dist(start, end)
    numbers = [link.a, link.b]
    if not link.bulge and length:
        context.count_work(len(nodes.points), MOST_BESIDE, "corners beside edges of outlines")
        along, off = ((np.array(nodes.points) - start) @ axis for axis in _axes(end - start, length))
        between = np.flatnonzero((np.abs(off) <= nodes.tolerance) & (along > 0) & (along < length))
        inner = sorted(set(between.tolist()) - {link.a, link.b}, key=lambda number: float(along[number]))
        numbers[1:1] = inner
    parts = []
    for a, b in pairwise(numbers):
        if a != b:
            middle = middles.number(segment(nodes.points[a], nodes.points[b], link.bulge).middle)
            parts.append(link._replace(a=a, b=b, key=(min(a, b), max(a, b), middle)))
    return parts


def _axes(way: Array, length: float) -> tuple[Array, Array]:
    """Return the unit vectors along a way and across it."""
    x, y = way / length
    return np.array([x, y]), np.array([-y, x])


def _ring_of(links: list[_Link], nodes: PointIndex) -> Ring:
    return Ring(tuple(nodes.points[link.a] for link in links), tuple(link.bulge or 0.0 for link in links))


def _close_ring(links: list[_Link], nodes: PointIndex, remarks: dict[Source, str]) -> ClosedCurve:
    """Return closed links as a curve that runs anticlockwise."""
    curve = _ring_of(links, nodes)
    if curve.signed_area < 0:
        curve = _ring_of([link.turned() for link in reversed(links)], nodes)
    sources = tuple(dict.fromkeys(link.source for link in links))
    return ClosedCurve(curve, sources, {source: remarks[source] for source in sources if source in remarks})


def _close_gaps(loose: list[_Link], nodes: PointIndex, context: ReadContext) -> list[_Link]:
    """Return links whose open ends are joined where they are near each other, the shortest gaps first.

    Straight edges are joined where they would meet, others midway. A gap is closed if it is neither wider than the
    context's nor than OF_EDGE of an edge that ends there.
    """
    at = _links_at(loose)
    ends = [node for node, links in at.items() if len(links) == 1]
    length = {node: _length(loose[at[node][0]], nodes) for node in ends}
    joined: dict[int, int] = {}
    closed = []
    for gap, a, b in _near_pairs(ends, nodes, context.gap):
        if a in joined or b in joined or gap > OF_EDGE * min(length[a], length[b]):
            continue
        joined |= {a: a, b: a}
        nodes.points[a] = _meeting(loose[at[a][0]], a, loose[at[b][0]], b, nodes)
        closed.append((gap, nodes.points[a], [loose[at[node][0]].source for node in (a, b)]))
    _report_gaps(closed, context)
    return [link._replace(a=joined.get(link.a, link.a), b=joined.get(link.b, link.b)) for link in loose]


def _meeting(edge: _Link, a: int, other: _Link, b: int, nodes: PointIndex) -> Place:
    """Return where two straight edges that end at a and b would meet, midway between these if that is not near them."""
    (ax, ay), (bx, by) = nodes.points[a], nodes.points[b]
    middle = (ax + bx) / 2, (ay + by) / 2
    if edge.bulge or other.bulge:
        return middle
    (cx, cy), (dx, dy) = (nodes.points[link.b if link.a == end else link.a] for link, end in ((edge, a), (other, b)))
    (ux, uy), (vx, vy) = (ax - cx, ay - cy), (bx - dx, by - dy)
    across = ux * vy - uy * vx
    if abs(across) <= ROUNDING * math.hypot(ux, uy) * math.hypot(vx, vy):
        return middle
    way = ((bx - ax) * vy - (by - ay) * vx) / across
    met = ax + way * ux, ay + way * uy
    near = MOST_GAPS * math.dist((ax, ay), (bx, by))
    return met if max(math.dist(met, (ax, ay)), math.dist(met, (bx, by))) <= near else middle


def _near_pairs(ends: list[int], nodes: PointIndex, most: float) -> list[tuple[float, int, int]]:
    """Return distance and numbers of ends near each other, the nearest first; of many near one the nearest few."""
    if len(ends) < 2 or not most > 0:
        return []
    from scipy.spatial import KDTree

    places = np.array([nodes.points[end] for end in ends])
    distances, others = KDTree(places).query(places, k=min(1 + FEW, len(ends)))
    pairs = {
        (distance, min(ends[i], ends[j]), max(ends[i], ends[j]))
        for i, row in enumerate(zip(distances.tolist(), others.tolist(), strict=True))
        for distance, j in zip(*row, strict=True)
        if j != i and distance <= most * (1 + ROUNDING)
    }
    return sorted(pairs)


def _report_gaps(closed: list[tuple[float, Place, list[Source]]], context: ReadContext) -> None:
    """Report each gap that was closed, of very many the first."""
    for gap, place, sources in closed[:MOST_ENDS]:
        names = " and ".join(dict.fromkeys(f"{source.entity} {source.handle}".strip() for source in sources))
        where = f"at {context.format_point(place)}, {names}"
        layer = Source(sources[0].layer, "LAYER", "")
        context.report_entity(layer, True, f"a gap of {context.format_length(gap)} was closed {where}")
    if len(closed) > MOST_ENDS:
        widest, _, sources = closed[-1]
        why = f"{len(closed) - MOST_ENDS} more gaps were closed, the widest of {context.format_length(widest)}"
        context.report_entity(Source(sources[0].layer, "LAYER", ""), True, why)


def _length(link: _Link, nodes: PointIndex) -> float:
    return segment(nodes.points[link.a], nodes.points[link.b], link.bulge).length


def _links_at(loose: list[_Link]) -> dict[int, list[int]]:
    """Return the numbers of the links that end at each point."""
    at: dict[int, list[int]] = defaultdict(list)
    for number, link in enumerate(loose):
        at[link.a].append(number)
        at[link.b].append(number)
    return at


def _find_rings(loose: list[_Link], nodes: PointIndex, context: ReadContext) -> list[list[_Link]]:
    """Return the closed chains of links; open ends and branches are issues."""
    at = _links_at(loose)
    _check_ends(loose, at, nodes, context)
    rings: list[list[_Link]] = []
    used: set[int] = set()
    for first in range(len(loose)):
        number, chain = first, [loose[first]]
        while number not in used and len(at[chain[-1].b]) == 2:
            used.add(number)
            if chain[-1].b == chain[0].a:
                rings.append(chain)
                break
            candidate, other = at[chain[-1].b]
            number = other if candidate == number else candidate
            link = loose[number]
            chain.append(link if link.a == chain[-1].b else link.turned())
        used.add(number)
    return rings


def _check_ends(loose: list[_Link], at: dict[int, list[int]], nodes: PointIndex, context: ReadContext) -> None:
    """Add an issue for each gap between two ends, each end that is left, and each branch."""
    expected = "lines that close end to end"
    ends = [node for node, links in at.items() if len(links) == 1]
    paired: set[int] = set()
    # The shortest gaps first; nobody repairs hundreds of open ends from a list of them all.
    shown = ends[:MOST_ENDS]
    pairs = sorted((math.dist(nodes.points[a], nodes.points[b]), a, b) for i, a in enumerate(shown) for b in shown[:i])
    for gap, a, b in pairs:
        if not {a, b} & paired:
            paired |= {a, b}
            a, b = (b, a) if at[b] < at[a] else (a, b)
            wide_gap = f"a gap of {context.format_length(gap)}, to {context.format_point(nodes.points[b])}"
            hint = "join the ends, move anything that is not an edge to another layer, or allow wider gaps to be closed"
            context.issue([loose[at[end][0]].source for end in (a, b)], nodes.points[a], wide_gap, expected, hint)
    for node in shown:
        if node not in paired:
            context.issue([loose[at[node][0]].source], nodes.points[node], "an open end", expected)
    if len(ends) > len(shown):
        node = ends[len(shown)]
        more_ends = f"{len(ends) - len(shown)} more open ends, this being the next"
        context.issue([loose[at[node][0]].source], nodes.points[node], more_ends, expected)
    for node, links in at.items():
        if len(links) > 2:
            hint = "leave one closed curve, and move the other lines to another layer"
            sources = [loose[number].source for number in links]
            context.issue(sources, nodes.points[node], f"{len(links)} lines that meet in one point", expected, hint)
