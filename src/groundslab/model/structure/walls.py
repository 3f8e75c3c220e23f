"""Walls on the plate: where they stand, and how thick they are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar

from groundslab.geometry.plan import Segment
from groundslab.model.ground import POSITIVE
from groundslab.model.shapes import AnyShape
from groundslab.model.structure.lines import (
    LineBulges,
    LinePoints,
    LineShape,
    check_line,
    check_line_length,
    flat_line,
    line_area,
    line_segments,
)
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.issues import RelativeIssue

if TYPE_CHECKING:
    from shapely import LineString, Polygon


def _check_points_or_shape(
    points: tuple[tuple[float, float], ...] | None, bulges: tuple[float, ...], shape: AnyShape | None
) -> Iterator[RelativeIssue]:
    yield from check_line(points, shape, {"bulges": bulges or None}, "a closed curve has no ends", "the axis")


class Wall(Section):
    """A wall that stands on the plate."""

    checks: ClassVar[tuple[Check, ...]] = (_check_points_or_shape, check_line_length)

    name: Annotated[str, Text("name of the wall, used by loads")]
    thickness: Annotated[float, Quantity("length", "t_w", "thickness of the wall", POSITIVE)]
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None

    @property
    def edges(self) -> tuple[Segment, ...]:
        """Return the straight pieces and arcs of its axis, one after the other."""
        return line_segments(self.points, self.bulges, self.shape)

    @property
    def closed(self) -> bool:
        """Return whether the axis ends where it starts."""
        return self.shape is not None or (self.points is not None and self.points[0] == self.points[-1])

    def to_shapely(self, chord: float) -> LineString:
        """Return the axis, arcs as chords at most so far off [m]."""
        return flat_line(self.edges, chord)

    def area(self, chord: float) -> Polygon:
        """Return what the wall stands on, arcs as chords at most so far off [m]."""
        return line_area(self.to_shapely(chord), self.thickness, closed=self.closed)

    @property
    def length(self) -> float:
        """Return the length of its axis [m]."""
        return sum(edge.length for edge in self.edges)
