"""Axes of a building as drawings have them: parallel ones, rays from a center, and rings about it."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.plan import Place
from groundslab.geometry.rectangles import direction_at
from groundslab.schema.base import Check, Section
from groundslab.schema.distances import MOST, Distances
from groundslab.schema.fields import ListOf, Number, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import place_in_plan
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe

#: Stands between the names of axes that cross.
BETWEEN = "/"
#: Crossings are rounded to so many digits after the point [m], so that they have no noise of sines.
DIGITS = 9
_DEGREES = Range(at_least=-360, at_most=360)
_NUMBERED = re.compile(r"(.*?)([0-9]{1,6})")


@dataclass(frozen=True, slots=True)
class Axis:
    """One axis: a straight one through a place in a direction, a ray that begins there, or a ring about it."""

    name: str
    place: Place  # [m]
    direction: Place | None = None  # of length 1, None of rings
    radius: float = 0.0  # [m]
    ray: bool = False


def count_on(first: str, number: int) -> tuple[str, ...]:
    """Return so many names from the first one on: A, B, C or 1, 2, 3; after Z comes AA."""
    numbered = _NUMBERED.fullmatch(first)
    if numbered:
        return tuple(f"{numbered[1]}{int(numbered[2]) + n}" for n in range(number))
    start = _number_of(first) if first.isascii() and first.isalpha() else None
    if start is None:
        return tuple(first if n == 0 else f"{first}{n + 1}" for n in range(number))
    lower = first.islower()
    return tuple(_letters(start + n).lower() if lower else _letters(start + n) for n in range(number))


def _number_of(letters: str) -> int:
    """Return the position of letters among A, B, ..., Z, AA, AB, ..., from 0."""
    position = 0
    for letter in letters.upper():
        position = 26 * position + ord(letter) - ord("A") + 1
    return position - 1


def _letters(position: int) -> str:
    """Return the letters at a position."""
    above, last = divmod(position, 26)
    return (_letters(above - 1) if above else "") + chr(ord("A") + last)


def _check_names(first: str, names: tuple[str, ...]) -> Iterator[RelativeIssue]:
    """Find names that references could not hold."""
    places = [("first",)] if not names else [("names", n) for n in range(len(names))]
    for place, name in zip(places, names or (first,), strict=True):
        if not name.strip() or BETWEEN in name or name != name.strip():
            expected = f"a name without blanks around it and without {BETWEEN}"
            yield RelativeIssue(place, describe(name), expected, f"{BETWEEN} stands between axes that cross")


def _check_count(names: tuple[str, ...], count: int) -> Iterator[RelativeIssue]:
    if names and len(names) != count:
        yield RelativeIssue(("names",), f"{len(names)} names", f"one for each of the {count} axes")


def _check_count_of_straight(names: tuple[str, ...], distances: tuple[float, ...]) -> Iterator[RelativeIssue]:
    yield from _check_count(names, len(distances) + 1)


def _check_count_of_rings(names: tuple[str, ...], distances: tuple[float, ...]) -> Iterator[RelativeIssue]:
    yield from _check_count(names, len(distances))


def _check_count_of_rays(names: tuple[str, ...], angles: tuple[float, ...]) -> Iterator[RelativeIssue]:
    yield from _check_count(names, len(angles))


FirstName = Annotated[str, Text("name of the first axis, from which the others count on: A, B, C or 1, 2, 3")]
Names = Annotated[
    tuple[str, ...], ListOf(Text(""), "", "names of all of them, instead of counting", least=0, most=MOST + 1)
]


class StraightAxes(Section):
    """Parallel axes."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_names, _check_count_of_straight)

    kind: Annotated[Literal["straight"], Table("parallel axes")] = "straight"
    first: FirstName = "A"
    names: Names = ()
    distances: Annotated[tuple[float, ...], Distances("a", "distances from each axis to the next one")]
    origin: Annotated[tuple[float, float], place_in_plan("a place on the first axis")] = (0.0, 0.0)
    angle: Annotated[
        float,
        Number(
            "alpha",
            "direction in which they follow one another [degrees], from x counterclockwise: 0 for axes that cross x, "
            "90 for those that cross y",
            _DEGREES,
        ),
    ] = 0.0

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes, one after the other."""
        ways = (0.0, *itertools.accumulate(self.distances))
        u, v = direction_at(self.angle)
        (x, y), names = self.origin, self.names or count_on(self.first, len(ways))
        places = ((x + way * u, y + way * v) for way in ways)
        return tuple(Axis(name, place, (-v, u)) for name, place in zip(names, places, strict=True))


class RayAxes(Section):
    """Axes that begin at a center."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_names, _check_count_of_rays)

    kind: Annotated[Literal["ray"], Table("axes that begin at a center")] = "ray"
    first: FirstName = "1"
    names: Names = ()
    centre: Annotated[tuple[float, float], place_in_plan("where they begin")] = (0.0, 0.0)
    angles: Annotated[
        tuple[float, ...],
        ListOf(
            Number("alpha", "", _DEGREES), "alpha", "their directions [degrees], from x counterclockwise", most=MOST
        ),
    ]

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes, one after the other."""
        names = self.names or count_on(self.first, len(self.angles))
        rays = zip(names, map(direction_at, self.angles), strict=True)
        return tuple(Axis(name, self.centre, direction, ray=True) for name, direction in rays)


class RingAxes(Section):
    """Axes that are circles about a center."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_names, _check_count_of_rings)

    kind: Annotated[Literal["ring"], Table("axes that are circles about a center")] = "ring"
    first: FirstName = "A"
    names: Names = ()
    centre: Annotated[tuple[float, float], place_in_plan("their center")] = (0.0, 0.0)
    distances: Annotated[tuple[float, ...], Distances("a", "radius of the first, then distances from each to the next")]

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes, from the innermost one on."""
        names = self.names or count_on(self.first, len(self.distances))
        radii = itertools.accumulate(self.distances)
        return tuple(Axis(name, self.centre, radius=radius) for name, radius in zip(names, radii, strict=True))


AnyAxes = StraightAxes | RayAxes | RingAxes
AxesFamily = Annotated[AnyAxes, ByKind()]


def check_axes(axes: tuple[AnyAxes, ...]) -> Iterator[RelativeIssue]:
    """Find axes of the same name."""
    positions: dict[str, int] = {}
    for position, family in enumerate(axes):
        for name in (axis.name for axis in family.axes):
            if name in positions:
                place = ("axes", position, "names" if family.names else "first")
                hint = f"axes[{positions[name] + 1}] has one of that name"
                yield RelativeIssue(place, f"a second axis {describe(name)}", "a name for each axis of its own", hint)
                break
        positions |= {axis.name: position for axis in family.axes}


def crossings(axis: Axis, other: Axis) -> tuple[Place, ...]:
    """Return where two axes cross [m], none if they do not; where they only touch counts."""
    if axis.direction is None and other.direction is None:
        return ()  # rings about one center do not cross, and others would twice
    if axis.direction is None:
        return crossings(other, axis)
    ways = _ways_to_ring(axis, other) if other.direction is None else _ways_to_line(axis, other)
    (x, y), (u, v) = axis.place, axis.direction
    return tuple((round(x + way * u, DIGITS) + 0.0, round(y + way * v, DIGITS) + 0.0) for way in ways)


def _ways_to_line(axis: Axis, other: Axis) -> Sequence[float]:
    """Return how far along one line the other one crosses it."""
    assert axis.direction is not None
    assert other.direction is not None
    (u, v), (s, t) = axis.direction, other.direction
    dx, dy = other.place[0] - axis.place[0], other.place[1] - axis.place[1]
    cross = u * t - v * s
    if abs(cross) < 1e-9:
        return ()
    way, way_of_other = (dx * t - dy * s) / cross, (dx * v - dy * u) / cross
    starts = (axis.ray and way < -1e-9) or (other.ray and way_of_other < -1e-9)
    return () if starts else (way,)


def _ways_to_ring(line: Axis, ring: Axis) -> Sequence[float]:
    """Return how far along a line a ring crosses it."""
    assert line.direction is not None
    (u, v), dx, dy = line.direction, ring.place[0] - line.place[0], ring.place[1] - line.place[1]
    middle, off = dx * u + dy * v, dx * v - dy * u
    half = math.sqrt(max(ring.radius**2 - off**2, 0.0))
    if abs(off) > ring.radius + 1e-9:
        return ()
    ways = (middle,) if half < 1e-9 else (middle - half, middle + half)
    return tuple(way for way in ways if not line.ray or way >= -1e-9)
