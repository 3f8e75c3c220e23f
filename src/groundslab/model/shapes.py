"""Shapes in plan: rectangles, polygons with arcs, circles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.plan import LARGEST_BULGE, Ring, circle, rectangle
from groundslab.model.ground import POSITIVE
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import ListOf, Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import extent, place_in_plan
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table

#: Two points make a curve if one of its edges has at least this bulge.
FLATTEST = 1e-3
#: Arcs are judged by chords that are at most this far off, relative to the size of the curve.
CHORD = 1e-4

AcrossX = Annotated[tuple[float, float], extent(0, "extent along x")]
AcrossY = Annotated[tuple[float, float], extent(1, "extent along y")]
Place = place_in_plan("a place in plan")
BULGE = Number("b", "", Range(at_least=-LARGEST_BULGE, at_most=LARGEST_BULGE))


class Rectangle(Section):
    """A rectangle along x and y."""

    kind: Annotated[Literal["rectangle"], Table("a rectangle along x and y")] = "rectangle"
    x: AcrossX
    y: AcrossY

    def ring(self) -> Ring:
        """Return the curve around it."""
        return rectangle(*self.x, *self.y)


def _check_points(points: tuple[tuple[float, float], ...], bulges: tuple[float, ...]) -> Iterator[RelativeIssue]:
    least = 2 if any(abs(bulge) >= FLATTEST for bulge in bulges) else 3
    if len(points) < least:
        yield RelativeIssue(("points",), f"{len(points)} points", f"at least {least}")
    if len(bulges) > len(points):
        yield RelativeIssue(("bulges",), f"{len(bulges)} bulges", f"at most one for each of the {len(points)} points")


def _check_crossings(points: tuple[tuple[float, float], ...], bulges: tuple[float, ...]) -> Iterator[RelativeIssue]:
    from shapely.validation import explain_validity

    if any(_check_points(points, bulges)):
        return
    ring = Ring(points, bulges)
    x0, x1, y0, y1 = ring.bounds
    size = max(x1 - x0, y1 - y0)
    reason = "all points at one place"
    if size > 0:
        reason = explain_validity(ring.polygon(CHORD * size))
    if reason != "Valid Geometry":
        crossing = reason.replace("[", " at (").replace("]", ") m").lower()
        yield RelativeIssue(("points",), crossing, "a curve that neither crosses nor touches itself")


class Polygon(Section):
    """A closed curve through points, its edges straight or arcs."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_points, _check_crossings)

    kind: Annotated[Literal["polygon"], Table("a closed curve through points")] = "polygon"
    points: Annotated[
        tuple[tuple[float, float], ...],
        ListOf(Place, "x, y", "the corners in order; the last is joined to the first"),
    ]
    bulges: Annotated[
        tuple[float, ...],
        ListOf(
            BULGE,
            "b",
            "for the edge after each point, tan of a quarter of its arc's angle, positive if counterclockwise",
            least=0,
        ),
    ] = ()

    def ring(self) -> Ring:
        """Return the curve."""
        return Ring(self.points, self.bulges)


class Circle(Section):
    """A circle."""

    kind: Annotated[Literal["circle"], Table("a circle")] = "circle"
    centre: Annotated[tuple[float, float], place_in_plan("its center")] = (0.0, 0.0)
    radius: Annotated[float, Quantity("length", "r", "its radius", POSITIVE, example="5 m")]

    def ring(self) -> Ring:
        """Return the curve."""
        return circle(self.centre, self.radius)


AnyShape = Rectangle | Polygon | Circle
Shape = Annotated[AnyShape, ByKind()]
