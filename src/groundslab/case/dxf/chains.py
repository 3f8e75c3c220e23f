"""Lines joined end to end to closed curves."""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass
from typing import NamedTuple

from groundslab.case.dxf.nodes import Nodes
from groundslab.case.dxf.pieces import Piece
from groundslab.case.dxf.sheet import DOUBLE, Sheet, Source
from groundslab.geometry.bulges import Curve, Edge, edges_of, signed_area

MOST_ENDS = 40  # open ends of a layer that are told one by one


@dataclass(frozen=True, slots=True)
class Found:
    """A closed curve and the entities that it was made of."""

    curve: Curve
    sources: tuple[Source, ...]
    remarks: dict[Source, str]

    def edges(self) -> list[Edge]:
        """Return the curve's edges."""
        return edges_of(self.curve)


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


def _links(source: Source, piece: Piece, nodes: Nodes, middles: Nodes) -> list[_Link]:
    """Return the edges of a line without those that have no length."""
    found = []
    numbers = [nodes.number(point) for point in piece.points]
    for i, bulge in enumerate(piece.bulges):
        a, b = numbers[i], numbers[i + 1]
        if a != b:
            middle = middles.number(Edge(piece.points[i], piece.points[i + 1], bulge).middle())
            found.append(_Link(a, b, bulge, source, (min(a, b), max(a, b), middle)))
    return found


def close(lines: list[tuple[Source, Piece]], tolerance: float, sheet: Sheet) -> list[Found]:
    """Return the closed curves that lines of one layer make, alone or end to end; doubles count once."""
    nodes, middles = Nodes(tolerance), Nodes(tolerance)
    remarks = {source: piece.remarks for source, piece in lines if piece.remarks}
    rings: list[list[_Link]] = []
    loose: list[_Link] = []
    opened: list[tuple[Source, list[_Link]]] = []
    seen: set[tuple[int, int, int]] = set()
    known: set[frozenset[tuple[int, int, int]]] = set()
    for source, piece in lines:
        links = _links(source, piece, nodes, middles)
        key = frozenset(link.key for link in links)
        if not links:
            sheet.tell(source, False, "it has no length")
        elif links[0].a != links[-1].b:
            opened.append((source, links))
        elif key in known:
            sheet.tell(source, False, DOUBLE)
        else:
            rings.append(links)
            known.add(key)
            seen |= key
    for source, links in opened:
        fresh = [link for link in links if link.key not in seen]
        if not fresh:
            sheet.tell(source, False, DOUBLE)
        loose += fresh
        seen |= {link.key for link in fresh}
    rings += _chains(loose, nodes, sheet)
    return [_ring(links, nodes, remarks) for links in rings]


def _ring(links: list[_Link], nodes: Nodes, remarks: dict[Source, str]) -> Found:
    """Return closed links as a curve that runs anticlockwise."""
    if signed_area([Edge(nodes.points[link.a], nodes.points[link.b], link.bulge) for link in links]) < 0:
        links = [link.turned() for link in reversed(links)]
    curve = Curve(tuple(nodes.points[link.a] for link in links), tuple(link.bulge or 0.0 for link in links))
    sources = tuple(dict.fromkeys(link.source for link in links))
    return Found(curve, sources, {source: remarks[source] for source in sources if source in remarks})


def _chains(loose: list[_Link], nodes: Nodes, sheet: Sheet) -> list[list[_Link]]:
    """Return the closed chains of links; open ends and branches are faults."""
    at: dict[int, list[int]] = defaultdict(list)
    for number, link in enumerate(loose):
        at[link.a].append(number)
        at[link.b].append(number)
    _ends_fit(loose, at, nodes, sheet)
    rings: list[list[_Link]] = []
    used: set[int] = set()
    for first in range(len(loose)):
        if first in used:
            continue
        # from node to node, so that one where many lines meet is looked at once
        nodes_seen, left, group = {loose[first].a}, [loose[first].a], {first}
        while left:
            for number in at[left.pop()]:
                group.add(number)
                fresh = {loose[number].a, loose[number].b} - nodes_seen
                nodes_seen |= fresh
                left += fresh
        used |= group
        if all(len(at[node]) == 2 for node in nodes_seen):
            rings.append(_around(first, loose, at))
    return rings


def _around(first: int, loose: list[_Link], at: dict[int, list[int]]) -> list[_Link]:
    """Return the chain from a link all the way around."""
    number, ring = first, [loose[first]]
    while ring[-1].b != ring[0].a:
        one, other = at[ring[-1].b]
        number = other if one == number else one
        link = loose[number]
        ring.append(link if link.a == ring[-1].b else link.turned())
    return ring


def _ends_fit(loose: list[_Link], at: dict[int, list[int]], nodes: Nodes, sheet: Sheet) -> None:
    """Add a fault for each gap between two ends, each end that is left, and each branch."""
    expected = "lines that close end to end"
    ends = [node for node, links in at.items() if len(links) == 1]
    paired: set[int] = set()
    # The shortest gaps first; a drawing with hundreds of open ends is not mended from a list of them all.
    some = ends[:MOST_ENDS]
    pairs = sorted((math.dist(nodes.points[a], nodes.points[b]), a, b) for i, a in enumerate(some) for b in some[:i])
    for gap, a, b in pairs:
        if not {a, b} & paired:
            paired |= {a, b}
            a, b = (b, a) if at[b] < at[a] else (a, b)
            found = f"a gap of {sheet.shown(gap)}, to {sheet.place(nodes.points[b])}"
            hint = "join the ends, or move what is no edge to another layer"
            sheet.issue([loose[at[end][0]].source for end in (a, b)], nodes.points[a], found, expected, hint)
    for node in some:
        if node not in paired:
            sheet.issue([loose[at[node][0]].source], nodes.points[node], "an open end", expected)
    if len(ends) > len(some):
        node = ends[len(some)]
        found = f"{len(ends) - len(some)} more open ends, this being the next"
        sheet.issue([loose[at[node][0]].source], nodes.points[node], found, expected)
    for node, links in at.items():
        if len(links) > 2:
            hint = "leave one closed curve, and move the other lines to another layer"
            sources = [loose[number].source for number in links]
            sheet.issue(sources, nodes.points[node], f"{len(links)} lines that meet in one point", expected, hint)
