"""Lines joined end to end into closed curves."""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from groundslab.case.dxf.drawing import DOUBLE, ReadContext, Source
from groundslab.case.dxf.entities import DrawnLine
from groundslab.geometry.plan import Place, Ring, segment
from groundslab.geometry.regions import Region


class PointIndex:
    """Points that are one within a tolerance: the first of them stands for all."""

    def __init__(self, tolerance: float) -> None:
        self.points: list[Place] = []
        self._tolerance = tolerance
        self._cells: dict[tuple[int, int], list[int]] = defaultdict(list)

    def number(self, point: Place) -> int:
        """Return the number of a point, a new one if none is near."""
        column, row = (math.floor(value / self._tolerance) for value in point)
        for cell in ((column + i, row + j) for i in (0, -1, 1) for j in (0, -1, 1)):
            for known in self._cells.get(cell, ()):
                if math.dist(self.points[known], point) <= self._tolerance:
                    return known
        self.points.append(point)
        self._cells[column, row].append(len(self.points) - 1)
        return len(self.points) - 1


MOST_ENDS = 40  # open ends of a layer that are listed one by one


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
    found = []
    numbers = [nodes.number(point) for point in piece.points]
    for i, bulge in enumerate(piece.bulges):
        a, b = numbers[i], numbers[i + 1]
        if a != b:
            middle = middles.number(segment(piece.points[i], piece.points[i + 1], bulge).middle)
            found.append(_Link(a, b, bulge, source, (min(a, b), max(a, b), middle)))
    return found


def join_lines(lines: list[tuple[Source, DrawnLine]], tolerance: float, context: ReadContext) -> list[ClosedCurve]:
    """Return the closed curves that lines of one layer make, alone or end to end; doubles count once."""
    nodes, middles = PointIndex(tolerance), PointIndex(tolerance)
    remarks = {source: piece.remarks for source, piece in lines if piece.remarks}
    rings: list[list[_Link]] = []
    loose: list[_Link] = []
    opened: list[tuple[Source, list[_Link]]] = []
    seen: set[tuple[int, int, int]] = set()
    known: set[frozenset[tuple[int, int, int]]] = set()
    for source, piece in lines:
        links = _make_links(source, piece, nodes, middles)
        key = frozenset(link.key for link in links)
        if not links:
            context.report_entity(source, False, "it has no length")
        elif links[0].a != links[-1].b:
            opened.append((source, links))
        elif key in known:
            context.report_entity(source, False, DOUBLE)
        else:
            rings.append(links)
            known.add(key)
            seen |= key
    for source, links in opened:
        fresh = [link for link in links if link.key not in seen]
        if not fresh:
            context.report_entity(source, False, DOUBLE)
        loose += fresh
        seen |= {link.key for link in fresh}
    rings += _find_rings(loose, nodes, context)
    return [_close_ring(links, nodes, remarks) for links in rings]


def _ring_of(links: list[_Link], nodes: PointIndex) -> Ring:
    return Ring(tuple(nodes.points[link.a] for link in links), tuple(link.bulge or 0.0 for link in links))


def _close_ring(links: list[_Link], nodes: PointIndex, remarks: dict[Source, str]) -> ClosedCurve:
    """Return closed links as a curve that runs anticlockwise."""
    curve = _ring_of(links, nodes)
    if curve.signed_area < 0:
        curve = _ring_of([link.turned() for link in reversed(links)], nodes)
    sources = tuple(dict.fromkeys(link.source for link in links))
    return ClosedCurve(curve, sources, {source: remarks[source] for source in sources if source in remarks})


def _find_rings(loose: list[_Link], nodes: PointIndex, context: ReadContext) -> list[list[_Link]]:
    """Return the closed chains of links; open ends and branches are issues."""
    at: dict[int, list[int]] = defaultdict(list)
    for number, link in enumerate(loose):
        at[link.a].append(number)
        at[link.b].append(number)
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
            one, other = at[chain[-1].b]
            number = other if one == number else one
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
    some = ends[:MOST_ENDS]
    pairs = sorted((math.dist(nodes.points[a], nodes.points[b]), a, b) for i, a in enumerate(some) for b in some[:i])
    for gap, a, b in pairs:
        if not {a, b} & paired:
            paired |= {a, b}
            a, b = (b, a) if at[b] < at[a] else (a, b)
            found = f"a gap of {context.format_length(gap)}, to {context.format_point(nodes.points[b])}"
            hint = "join the ends, or move what is no edge to another layer"
            context.issue([loose[at[end][0]].source for end in (a, b)], nodes.points[a], found, expected, hint)
    for node in some:
        if node not in paired:
            context.issue([loose[at[node][0]].source], nodes.points[node], "an open end", expected)
    if len(ends) > len(some):
        node = ends[len(some)]
        found = f"{len(ends) - len(some)} more open ends, this being the next"
        context.issue([loose[at[node][0]].source], nodes.points[node], found, expected)
    for node, links in at.items():
        if len(links) > 2:
            hint = "leave one closed curve, and move the other lines to another layer"
            sources = [loose[number].source for number in links]
            context.issue(sources, nodes.points[node], f"{len(links)} lines that meet in one point", expected, hint)
