"""Ends and corners of walls: where an axis ends at no other wall, or has a kink, and which walls run away from there.

Ends of two walls are at one place if their axes end no farther apart than those of walls that meet at a right angle and
are drawn to each other's faces. An end within half the thickness of another wall's axis meets this wall.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import FLAT, Place, Segment, get_bounds
from groundslab.messages import Message, Name, series
from groundslab.model.structure.lines import line_segments, part_of_line
from groundslab.model.structure.spans import Ways
from groundslab.model.structure.walls import Wall, WallPiece

#: An axis that turns by more has a corner, and of walls that meet the outer angle is larger than 180 degrees by more.
KINK = math.radians(15.0)


@dataclass(frozen=True, slots=True)
class WallLeg:
    """A wall as it runs away from one of its ends or corners."""

    wall: str
    thickness: float  # [m]
    place: Place  # where its axis begins [m]
    angle: float  # of its direction there [rad]
    length: float  # of its axis up to its next end or corner [m]
    share: float  # of the wall's length that lies before the place
    over: float | None = None  # that length [m] where the wall goes on over an opening of the plate
    jamb: float | None = None  # that length [m] where a door begins or ends


@dataclass(frozen=True, slots=True)
class WallEnd:
    """A free end of a wall, or a corner of one or several walls.

    At an end there is one leg. At a corner there are two, and the outer side lies to the left of the first one and to
    the right of the last one.
    """

    kind: Literal["end", "corner"]
    legs: tuple[WallLeg, ...]
    number: int = 0  # of several corners of the same walls, from 1

    @property
    def walls(self) -> str:
        """Return the names of its walls."""
        return series(Name(wall) for wall in sorted({leg.wall for leg in self.legs}))

    @property
    def label(self) -> str:
        """Return which end or corner it is."""
        if self.kind == "end":
            leg = self.legs[0]
            if leg.over is not None:
                return Message("edge at {over:.6g m}", over=leg.over)
            if leg.jamb is not None:
                return Message("jamb at {way:.6g m}", way=leg.jamb)
            return "end" if leg.share else "start"
        return Message("corner {number}", number=self.number) if self.number else "corner"

    @property
    def name(self) -> str:
        """Return what checks call it."""
        return Message("{end} of {walls}", end=self.label, walls=self.walls)

    @property
    def place(self) -> Place:
        """Return where it is [m]."""
        return self.legs[0].place

    @property
    def outer_angle(self) -> float:
        """Return the angle [rad] on the outer side, from the first leg to the last one."""
        turn = (self.legs[-1].angle - self.legs[0].angle) % (2 * math.pi)
        return turn or 2 * math.pi


@dataclass(frozen=True, slots=True)
class _Run:
    """A part of a wall's axis between ends and corners."""

    thickness: float
    edges: tuple[Segment, ...]
    tips: tuple[WallLeg, WallLeg]


def wall_ends(walls: Sequence[Wall], spans: Mapping[str, Ways] | None = None) -> tuple[WallEnd, ...]:
    """Return the free ends and the corners of walls.

    Where a wall spans an opening of the plate, from way to way along it [m] by its name, it ends at both edges, as it
    does at the jambs of its doors.
    """
    known_spans = spans or {}
    runs = [
        part for wall in walls for run in _runs(wall) for part in _beside(run, wall, known_spans.get(wall.name, ()))
    ]
    tips = [(number, tip) for number, run in enumerate(runs) for tip in run.tips]
    boxes = np.array([get_bounds(run.edges) for run in runs]).reshape(-1, 2, 2)
    found_ends = [end for group in _groups(tips) for end in _ends([tips[i] for i in group], runs, boxes)]
    corners = Counter(end.walls for end in found_ends if end.kind == "corner")
    counted = Counter[str]()
    numbered = []
    for end in found_ends:
        if end.kind == "corner" and corners[end.walls] > 1:
            counted[end.walls] += 1
            numbered.append(replace(end, number=counted[end.walls]))
        else:
            numbered.append(end)
    return tuple(numbered)


def _runs(wall: Wall) -> Iterator[_Run]:
    """Yield the parts of a wall's axis between its ends, jambs and corners; none of a closed one without any."""
    for piece in wall.pieces:
        edges = piece.edges
        turned = [_turn(before, after) > KINK for before, after in pairwise((edges[-1], *edges))]
        corners = [number for number, has in enumerate(turned) if has and (number or piece.closed)]
        around = [number + len(edges) for number in corners[:1]]
        bounds = [*corners, *around] if piece.closed else [0, *corners, len(edges)]
        for first, last in pairwise(bounds):
            yield _run_of(wall, piece, first, last)


def _run_of(wall: Wall, piece: WallPiece, first: int, last: int) -> _Run:
    """Return the part of a piece of a wall from one of its edges to another, counted on around a closed one."""
    ways = np.cumsum([piece.start, *(edge.length for edge in piece.edges)]).tolist()
    ways[-1] = piece.end
    run_edges = tuple(piece.edges[number % len(piece.edges)] for number in range(first, last))
    length, whole = sum(edge.length for edge in run_edges), wall.length
    after = (last - 1) % len(piece.edges) + 1
    start, end = (way if way <= whole else way - whole for way in (ways[first], ways[after]))
    begin = WallLeg(wall.name, wall.thickness, run_edges[0].start, run_edges[0].direction(0.0), length, start / whole)
    back = run_edges[-1].direction(1.0) + math.pi
    finish = WallLeg(wall.name, wall.thickness, run_edges[-1].end, back, length, end / whole)
    if not piece.closed and first == 0 and piece.start > 0:
        begin = replace(begin, jamb=start)
    if not piece.closed and last == len(piece.edges) and piece.end != whole:
        finish = replace(finish, jamb=end)
    return _Run(wall.thickness, run_edges, (begin, finish))


def _beside(run: _Run, wall: Wall, spans: Ways) -> Iterator[_Run]:
    """Yield the parts of a run on the plate, beside spans over openings."""
    whole, length = wall.length, run.tips[0].length
    begin = run.tips[0].share * whole
    inside = [(a - begin, b - begin) for a, b in spans if a > begin and b < begin + length]
    if not inside:
        yield run
        return
    low: tuple[float, WallLeg] = (0.0, run.tips[0])
    for start, end in (*inside, (length, None)):
        edges = line_segments(*part_of_line(run.edges, low[0], start), None)
        last = run.tips[1]
        if end is not None:
            angle = edges[-1].direction(1.0) + math.pi
            last = replace(last, place=edges[-1].end, angle=angle, share=(begin + start) / whole, over=begin + start)
        parts = tuple(replace(tip, length=start - low[0]) for tip in (low[1], last))
        yield replace(run, edges=edges, tips=(parts[0], parts[1]))
        if end is not None:
            ((place, *_), _) = part_of_line(run.edges, end, length)
            low = (
                end,
                replace(run.tips[0], place=place, angle=angle + math.pi, share=(begin + end) / whole, over=begin + end),
            )


def _turn(before: Segment, after: Segment) -> float:
    """Return by what angle [rad] a line turns from one edge to the next."""
    return abs(math.remainder(after.direction(0.0) - before.direction(1.0), 2 * math.pi))


def _groups(tips: list[tuple[int, WallLeg]]) -> list[list[int]]:
    """Return the positions of the tips at each place, in the order of the first of them."""
    from shapely import STRtree, points

    if not tips:
        return []
    places = points([tip.place for _, tip in tips])
    thickest = max(tip.thickness for _, tip in tips)
    numbers, others = STRtree(places).query(places, predicate="dwithin", distance=thickest)
    first = list(range(len(tips)))

    def root(i: int) -> int:
        while first[i] != i:
            i = first[i]
        return i

    for i, j in zip(numbers.tolist(), others.tolist(), strict=True):
        (run, a), (other_run, b) = tips[i], tips[j]
        apart = math.dist(a.place, b.place)
        if i < j and apart <= (1 + FLAT) * math.hypot(a.thickness, b.thickness) / 2 and (run != other_run or not apart):
            low, high = sorted((root(i), root(j)))
            first[high] = low
    groups: dict[int, list[int]] = {}
    for i in range(len(tips)):
        groups.setdefault(root(i), []).append(i)
    return list(groups.values())


def _ends(tips: list[tuple[int, WallLeg]], runs: list[_Run], boxes: Array) -> Iterator[WallEnd]:
    """Yield the end or the corners at a place with the tips of some runs, boxes (r, 2, 2) being those of all runs."""
    count = Counter(number for number, _ in tips)
    # a run between two tips of the group is no longer than walls are thick, unless it runs back to where it began
    short = {number for number, many in count.items() if many > 1 and len(set(_places(runs[number]))) > 1}
    legs = [tip for number, tip in tips if number not in short]
    places = np.array([tip.place for _, tip in tips])
    reach = max(run.thickness for run in runs)
    (x0, y0), (x1, y1) = places.min(axis=0) - reach, places.max(axis=0) + reach
    near = (boxes[:, 0, 0] <= x1) & (boxes[:, 0, 1] >= x0) & (boxes[:, 1, 0] <= y1) & (boxes[:, 1, 1] >= y0)
    others = [runs[number] for number in np.flatnonzero(near) if number not in count]
    angles = [angle for run in others for angle in _through(run, places)]
    kept: list[WallLeg] = []
    for leg in sorted(legs, key=lambda leg: -leg.thickness):
        if all(abs(math.remainder(leg.angle - other.angle, 2 * math.pi)) > KINK for other in kept):
            kept.append(leg)
    if len(kept) == 1 and not angles:
        yield WallEnd("end", tuple(kept))
        return
    around = sorted([(leg.angle % (2 * math.pi), leg) for leg in kept], key=lambda pair: pair[0])
    for (angle, leg), (after, next_leg) in zip(around, around[1:] + around[:1], strict=True):
        gap = (after - angle) % (2 * math.pi)
        crossed = any(0 < (between - angle) % (2 * math.pi) < gap for between in angles)
        if len(kept) > 1 and gap > math.pi + KINK and not crossed:
            yield WallEnd("corner", (leg, next_leg))


def _places(run: _Run) -> tuple[Place, Place]:
    """Return where a run begins and ends."""
    return run.tips[0].place, run.tips[1].place


def _through(run: _Run, places: Array) -> Iterator[float]:
    """Yield the two directions [rad] in which a run goes away from places (p, 2) that meet it between its ends."""
    distances = np.array([edge.distance(places) for edge in run.edges])
    number, which = np.unravel_index(distances.argmin(), distances.shape)
    if distances[number, which] <= (1 + FLAT) * run.thickness / 2:
        edge = run.edges[number]
        x, y = places[which]
        forward = edge.direction(min(edge.part((float(x), float(y))), 1.0))
        yield forward
        yield forward + math.pi
