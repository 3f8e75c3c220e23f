"""Forces and moments along lines."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.plan import Segment, make_segments
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.base import Magnitude, _Load
from groundslab.model.shapes import BULGE, AnyShape, Place, Shape
from groundslab.schema.base import Check
from groundslab.schema.fields import ListOf, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.section_fields import Table

#: Lines shorter than this [m] go nowhere.
NO_LENGTH = 1e-9


def _check_line(
    points: tuple[tuple[float, float], ...] | None, shape: AnyShape | None, along: dict[str, object], value: str
) -> Iterator[RelativeIssue]:
    """Find a line that is given by neither points nor a shape, or by both; `along` holds what only points can have."""
    if points is None and shape is None:
        yield RelativeIssue(("points",), "nothing", "the line's points, or a shape whose edge is loaded")
    if shape is None:
        return
    for name, given in {"points": points, **along}.items():
        if given is not None:
            hint = f"all of a shape's edge bears the same {value}"
            yield RelativeIssue((name,), f"{name} together with a shape", "one of them", hint)


def _check_points_or_shape(
    points: tuple[tuple[float, float], ...] | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    q_end: float | None,
) -> Iterator[RelativeIssue]:
    yield from _check_line(points, shape, {"bulges": bulges or None, "q_end": q_end}, "q")


def _check_moment_points_or_shape(
    points: tuple[tuple[float, float], ...] | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    m_end: float | None,
) -> Iterator[RelativeIssue]:
    yield from _check_line(points, shape, {"bulges": bulges or None, "m_end": m_end}, "m")


def _check_line_length(
    points: tuple[tuple[float, float], ...] | None, bulges: tuple[float, ...]
) -> Iterator[RelativeIssue]:
    if points is None:
        return
    if len(points) < 2:
        yield RelativeIssue(("points",), f"{len(points)} point", "at least two")
    elif len(bulges) >= len(points):
        expected = f"at most {len(points) - 1}, one for each of the line's pieces"
        yield RelativeIssue(("bulges",), f"{len(bulges)} bulges", expected)
    for position, (a, b) in enumerate(itertools.pairwise(points), start=1):
        if math.dist(a, b) < NO_LENGTH:
            found = f"({b[0]!r}, {b[1]!r}) m twice"
            yield RelativeIssue(("points", position), found, "another place than the one before")


LinePoints = Annotated[
    tuple[tuple[float, float], ...] | None,
    ListOf(Place, "x, y", "the line's points, in order"),
]
LineBulges = Annotated[
    tuple[float, ...],
    ListOf(
        BULGE,
        "b",
        "for the piece after each point, tan of a quarter of its arc's angle, positive if counterclockwise; 0 for a "
        "straight piece",
        least=0,
    ),
]
LineShape = Annotated[Shape | None, Table("closed curve along which the load acts, such as a circle; not with points")]


def _line_segments(
    points: tuple[tuple[float, float], ...] | None, bulges: tuple[float, ...], shape: AnyShape | None
) -> tuple[Segment, ...]:
    """Return the straight pieces and arcs of a line, one after the other."""
    if shape is not None:
        return shape.ring().segments()
    assert points is not None
    return make_segments(points, bulges)


def _at_ends(start: float, end: float | None) -> tuple[float, float]:
    """Return a value at the start and at the end of a line, the same one by default."""
    return start, start if end is None else end


class LineLoad(_Load):
    """A force per length along a line of straight pieces and arcs, or along the edge of a shape."""

    checks: ClassVar[tuple[Check, ...]] = (_check_points_or_shape, _check_line_length)

    kind: Annotated[Literal["line"], Table("force per length along a line of straight pieces and arcs")] = "line"
    q: Annotated[float, Quantity("force per length", "q", "force per length, downwards positive")]
    q_end: Annotated[
        float | None, Quantity("force per length", "q_e", "at the end, linear from q at the start; q by default")
    ] = None
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is at its start and at its end."""
        start, end = _at_ends(self.q, self.q_end)
        return (("q", start, "force per length"), ("q_end", end, "force per length"))

    @property
    def acts(self) -> tuple[LineForce]:
        """The force along the line."""
        return (LineForce(_line_segments(self.points, self.bulges, self.shape), q=_at_ends(self.q, self.q_end)),)


class LineMoment(_Load):
    """A moment per length along a line of straight pieces and arcs, or along the edge of a shape."""

    checks: ClassVar[tuple[Check, ...]] = (_check_moment_points_or_shape, _check_line_length)

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
        ),
    ]
    m_end: Annotated[
        float | None, Quantity("moment per length", "m_e", "at the end, linear from m at the start; m by default")
    ] = None
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is at its start and at its end."""
        start, end = _at_ends(self.m, self.m_end)
        return (("m", start, "moment per length"), ("m_end", end, "moment per length"))

    @property
    def acts(self) -> tuple[LineForce]:
        """The couple along the line."""
        return (LineForce(_line_segments(self.points, self.bulges, self.shape), m=_at_ends(self.m, self.m_end)),)
