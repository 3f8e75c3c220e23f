"""Doors of walls that have no height: where they may be, and how the load over them comes to both sides.

What acts on a wall is given all along it, over its doors, too. The lintel of a door carries it as a simple beam into
the wall on both sides. There each reaction is spread uniformly down to the plate, from the jamb at 60 degrees to the
horizontal, as EN 1996-1-1 6.1.3 spreads concentrated loads in walls: over the height of the door times tan 30 degrees,
or as far as the wall goes on straight, if that is less. The beam spans between the middles of both lengths, so that
force and moments of the load stay what they were.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from groundslab.geometry.plan import Segment
from groundslab.model.structure.lines import SAME
from groundslab.model.structure.walls import Wall, WallOpening
from groundslab.schema.issues import RelativeIssue

#: How far from a jamb the load of a lintel spreads, over the height of the door (EN 1996-1-1 6.1.3).
SPREAD = math.tan(math.radians(30))
#: Straight pieces that turn by less [rad] are one.
STRAIGHT = 1e-9


@dataclass(frozen=True, slots=True)
class LoadedPart:
    """A part of a wall, and what acts on it per length at both ends, linear between."""

    start: float  # along the wall [m]
    end: float
    values: tuple[float, float]


def carried_over_doors(wall: Wall, values: tuple[float, float]) -> tuple[LoadedPart, ...]:
    """Return what acts on the parts of a wall beside its doors, by what is given per length at both ends of its axis.

    Forces and couples about the axis, for the torsion of a lintel that is held at both ends, are carried alike.
    """
    length = wall.length

    def given(way: float) -> float:
        return values[0] + (values[1] - values[0]) * way / length

    added = [reaction for door, lengths in zip(wall.doors, _bearings(wall), strict=True)
             for reaction in _reactions(door, lengths, (given(door.start), given(door.end)))]  # fmt: skip
    cuts = [0.0, length, *(way for door in wall.doors for way in (door.start, door.end))]
    cuts += [way for low, high, _ in added for way in (low, high)]
    parts = []
    low = 0.0
    for cut in sorted(cuts):
        if cut - low <= SAME * length:
            continue
        start, low = low, cut
        middle = (start + cut) / 2
        if any(door.start < middle < door.end for door in wall.doors):
            continue
        more = sum(value for begin, end, value in added if begin < middle < end)
        parts.append(LoadedPart(start, cut, (given(start) + more, given(cut) + more)))
    return tuple(parts)


def _reactions(
    door: WallOpening, lengths: tuple[float, float], values: tuple[float, float]
) -> Iterator[tuple[float, float, float]]:
    """Yield from where to where [m] a lintel bears, and its reaction there per length, by what acts at both jambs."""
    before, after = lengths
    clear = door.end - door.start
    total = clear * sum(values) / 2
    # about the middle of the first bearing, half of its length from the jamb
    moment = total * before / 2 + clear**2 * (values[0] + 2 * values[1]) / 6
    last = moment / (before / 2 + clear + after / 2)
    yield door.start - before, door.start, (total - last) / before
    yield door.end, door.end + after, last / after


def _bearings(wall: Wall) -> tuple[tuple[float, float], ...]:
    """Return over which lengths [m] before and after each door its load is spread."""
    lengths = []
    bounds = [0.0, *(way for door in wall.doors for way in (door.start, door.end)), wall.length]
    for number, door in enumerate(wall.doors):
        low, high = _straight_part(wall, door)
        before = door.start - max(low, bounds[2 * number])
        after = min(high, bounds[2 * number + 3]) - door.end
        reach = SPREAD * door.height
        lengths.append((min(reach, before), min(reach, after)))
    return tuple(lengths)


def _straight_part(wall: Wall, door: WallOpening) -> tuple[float, float]:
    """Return from where to where [m] a wall is straight about the middle of a door; nowhere but there on an arc."""
    middle = (door.start + door.end) / 2
    parts = list[tuple[float, float, Segment]]()
    low = 0.0
    for edge in wall.edges:
        start, low = low, low + edge.length
        if parts and edge.straight and parts[-1][2].straight and _go_on(parts[-1][2], edge):
            start = parts.pop()[0]
        parts.append((start, low, edge))
    start, end, edge = next((part for part in parts if middle <= part[1]), parts[-1])
    return (start, end) if edge.straight else (middle, middle)


def _go_on(before: Segment, after: Segment) -> bool:
    """Return whether a straight piece goes on in the direction of the one before it."""
    return abs(math.remainder(after.direction(0.0) - before.direction(1.0), 2 * math.pi)) < STRAIGHT


def check_within(wall: Wall) -> Iterator[RelativeIssue]:
    """Find openings that end beyond a wall, which has its axis."""
    for position, opening in enumerate(wall.openings):
        if opening.end > wall.length * (1 + SAME):
            expected = f"at most the wall's length, {wall.length:.6g} m"
            yield RelativeIssue(("openings", position, "end"), f"{opening.end!r} m", expected)


def check_doors(wall: Wall, near: float) -> Iterator[RelativeIssue]:
    """Find doors without at least so much straight wall [m] on both sides; the wall has its axis."""
    beyond = [*check_within(wall)]
    yield from beyond
    if beyond or not wall.doors:
        return
    numbers = sorted(range(len(wall.openings)), key=lambda number: wall.openings[number].start)
    for before, number in pairwise(numbers):
        gap = wall.openings[number].start - wall.openings[before].end
        if gap < near:
            short_wall = f"{gap:.3g} m of wall between it and the opening before"
            yield RelativeIssue(("openings", number), short_wall, f"at least {near:.3g} m", "give both as one opening")
            return
    for position, door in enumerate(wall.openings):
        low, high = _straight_part(wall, door)
        if door.start - low >= near and high - door.end >= near:
            continue
        misplaced, hint = (
            "an opening in an arc or at a corner",
            "draw arcs by straight pieces, and begin a closed wall elsewhere",
        )
        if not wall.closed and (door.start < near or door.end > wall.length - near):
            misplaced, hint = (
                "an opening at the end of the wall",
                "let the wall end there, and give what a lintel beyond it brings as a load",
            )
        expected = f"one with at least {near:.3g} m of straight wall on both sides, which bear its lintel"
        yield RelativeIssue(("openings", position), misplaced, expected, hint)
