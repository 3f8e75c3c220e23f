"""Forces and moments along lines and on walls."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from groundslab.model.axes.crossings import AtCrossings
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.base import Magnitude, Source, _Load
from groundslab.model.shapes import AnyShape
from groundslab.model.structure.doors import carried_over_doors
from groundslab.model.structure.lines import (
    LineBulges,
    LinePoints,
    LineShape,
    Points,
    check_line,
    check_line_length,
    line_segments,
    part_of_line,
)
from groundslab.model.structure.walls import Wall
from groundslab.schema.base import Check
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.section_fields import Table


def _check_place(
    points: Points | None, shape: AnyShape | None, wall: str, along: Mapping[str, object], end: str, value: str
) -> Iterator[RelativeIssue]:
    """Find a line that is given twice, or not at all; `along` holds what only points can have, `end` one of them."""
    if not wall:
        if points is None and shape is None:
            expected = "the line's points, a shape whose edge is loaded, or the name of a wall"
            yield RelativeIssue(("points",), "nothing", expected)
            return
        yield from check_line(points, shape, along, f"all of a shape's edge bears the same {value}")
        return
    keys = {"points": points, "shape": shape, **{name: what for name, what in along.items() if name != end}}
    for name in (name for name, what in keys.items() if what is not None):
        yield RelativeIssue((name,), f"{name} together with a wall", "one of them", "the wall says where its load acts")


def _check_force(
    points: Points | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    width: float | None,
    wall: str,
    q_end: float | None,
) -> Iterator[RelativeIssue]:
    along = {"bulges": bulges or None, "q_end": q_end}
    yield from _check_place(points, shape, wall, along, "q_end", "q")
    yield from _check_width(width, wall)


def _check_moment(
    points: Points | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    width: float | None,
    wall: str,
    m_end: float | None,
) -> Iterator[RelativeIssue]:
    along = {"bulges": bulges or None, "m_end": m_end}
    yield from _check_place(points, shape, wall, along, "m_end", "m")
    yield from _check_width(width, wall)


def _check_width(width: float | None, wall: str) -> Iterator[RelativeIssue]:
    if wall and width is not None:
        yield RelativeIssue(("width",), "width together with a wall", "one of them", "the wall has a thickness")


def _at_ends(start: float, end: float | None) -> tuple[float, float]:
    """Return a value at the start and at the end of a line, the same one by default."""
    return start, start if end is None else end


#: A part of a line, and what acts on it per length at both of its ends.
Part = tuple[LineForce, tuple[float, float]]

LineWidth = Annotated[
    float | None,
    Quantity(
        "length",
        "t",
        "width across the line over which it is spread, as of a wall; none by default",
        POSITIVE,
        example="0.25 m",
    ),
]
OnWall = Annotated[
    str, Text("wall along which it acts and over whose thickness it is spread, one of [[walls]]; instead of points")
]


def _along(load: LineLoad | LineMoment, walls: Iterable[Wall], ends: tuple[float, float]) -> Iterator[Part]:
    """Yield the parts of a load's line, each with what acts at both of its ends."""
    if not load.wall:
        yield LineForce(line_segments(load.points, load.bulges, load.shape), width=load.width or 0.0), ends
        return
    wall = next(wall for wall in walls if wall.name == load.wall)
    line = LineForce(wall.edges, width=wall.thickness, wall=wall.name)
    if not wall.doors:
        yield line, ends
    for part in carried_over_doors(wall, ends) if wall.doors else ():
        edges = line_segments(*part_of_line(wall.edges, part.start, part.end), None)
        yield replace(line, edges=edges, start=part.start), part.values


class LineLoad(_Load):
    """A force per length along a line of straight pieces and arcs, along the edge of a shape, or on a wall."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_force, check_line_length)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("points",)}

    kind: Annotated[Literal["line"], Table("force per length along a line of straight pieces and arcs")] = "line"
    q: Annotated[float, Quantity("force per length", "q", "force per length, downwards positive", example="80 kN/m")]
    q_end: Annotated[
        float | None,
        Quantity("force per length", "q_e", "at the end, linear from q at the start; q by default", example="40 kN/m"),
    ] = None
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None
    width: LineWidth = None
    wall: OnWall = ""
    at: AtCrossings = ()
    source: Source = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is at its start and at its end."""
        start, end = _at_ends(self.q, self.q_end)
        return (("q", start, "force per length"), ("q_end", end, "force per length"))

    @property
    def acts(self) -> tuple[LineForce, ...]:
        """The force along the line, if that is its own."""
        return self.acts_on(())

    def acts_on(self, walls: Iterable[Wall]) -> tuple[LineForce, ...]:
        """Return the force along the line, or along its wall and over the thickness of that."""
        ends = _at_ends(self.q, self.q_end)
        return tuple(replace(line, q=values) for line, values in _along(self, walls, ends))


class LineMoment(_Load):
    """A moment per length along a line of straight pieces and arcs, along the edge of a shape, or on a wall."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_moment, check_line_length)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("points",)}

    kind: Annotated[
        Literal["line moment"], Table("moment per length about a line, as from a wall fixed in the plate")
    ] = "line moment"
    m: Annotated[
        float,
        Quantity(
            "moment per length",
            "m",
            "moment about the line, positive if it presses down the side to the left of the line's direction; for a "
            "circle this is the inside",
            example="25 kNm/m",
        ),
    ]
    m_end: Annotated[
        float | None,
        Quantity(
            "moment per length", "m_e", "at the end, linear from m at the start; m by default", example="10 kNm/m"
        ),
    ] = None
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None
    width: LineWidth = None
    wall: OnWall = ""
    at: AtCrossings = ()
    source: Source = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is at its start and at its end."""
        start, end = _at_ends(self.m, self.m_end)
        return (("m", start, "moment per length"), ("m_end", end, "moment per length"))

    @property
    def acts(self) -> tuple[LineForce, ...]:
        """The couple along the line, if that is its own."""
        return self.acts_on(())

    def acts_on(self, walls: Iterable[Wall]) -> tuple[LineForce, ...]:
        """Return the couple along the line, or along its wall and over the thickness of that."""
        ends = _at_ends(self.m, self.m_end)
        return tuple(replace(line, m=values) for line, values in _along(self, walls, ends))
