"""Columns on the plate: position and footprint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, ClassVar

from groundslab.geometry.plan import Place, Ring, circle
from groundslab.geometry.rectangles import extents_at, rectangle_at
from groundslab.model.axes.crossings import AtCrossing
from groundslab.model.ground import POSITIVE
from groundslab.model.structure.beta import Beta, beta_field
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Footprints that share less than this part of their area touch each other.
SAME = 1e-6
#: By how much something is turned [degrees].
TURN = Range(at_least=-360, at_most=360)


def check_footprint(width_x: float | None, width_y: float | None, diameter: float | None) -> Iterator[RelativeIssue]:
    """Find a footprint that is given by neither both widths nor a diameter."""
    if diameter is not None and (width_x is not None or width_y is not None):
        widths = [(key,) for key, width in (("width_x", width_x), ("width_y", width_y)) if width is not None]
        repairs = (remove(("diameter",)), remove(*widths))
        expected = "width_x and width_y, or diameter"
        yield RelativeIssue(("diameter",), "a diameter together with a width", expected, repairs=repairs)
    if (width_x is None) != (width_y is None):
        missing = "width_x" if width_x is None else "width_y"
        yield RelativeIssue((missing,), "nothing", "width_x and width_y, both of them")


def check_angle(width_x: float | None, diameter: float | None, angle: float) -> Iterator[RelativeIssue]:
    """Find an angle of what has no sides."""
    if angle and width_x is None:
        idle_angle = "an angle of a circle" if diameter is not None else "an angle without widths"
        repairs = (remove(("angle",)),)
        yield RelativeIssue(("angle",), idle_angle, "width_x and width_y, or no angle", repairs=repairs)


def footprint(
    centre: Place, widths: tuple[float | None, float | None], diameter: float | None, angle: float = 0.0
) -> Ring | None:
    """Return the curve around a footprint, its widths [m] turned by an angle [degrees]; None if it is a point."""
    if diameter is not None:
        return circle(centre, diameter / 2)
    width_x, width_y = widths
    if width_x is not None and width_y is not None:
        return rectangle_at(centre, (width_x, width_y), angle)
    return None


def _check_footprint_given(
    width_x: float | None, width_y: float | None, diameter: float | None
) -> Iterator[RelativeIssue]:
    if width_x is None and width_y is None and diameter is None:
        yield RelativeIssue(("width_x",), "nothing", "width_x and width_y, or diameter")


class Column(Section):
    """A column that stands on the plate."""

    constraints: ClassVar[tuple[Check, ...]] = (check_footprint, _check_footprint_given, check_angle)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("x", "y")}

    name: Annotated[str, Text("name of the column, used by loads")]
    x: Annotated[float, coordinate(0, "its center")]
    y: Annotated[float, coordinate(1, "its center")]
    width_x: Annotated[float | None, Quantity("length", "c_x", "width along x", POSITIVE, example="0.4 m")] = None
    width_y: Annotated[float | None, Quantity("length", "c_y", "width along y", POSITIVE, example="0.4 m")] = None
    diameter: Annotated[
        float | None, Quantity("length", "d", "diameter, instead of both widths", POSITIVE, example="0.4 m")
    ] = None
    angle: Annotated[
        float,
        Number("alpha", "angle of its widths from x and y in degrees, counterclockwise", TURN),
    ] = 0.0
    beta: Annotated[Beta | None, beta_field("at this column, by default that of the reinforcement")] = None
    at: AtCrossing = ""

    def ring(self) -> Ring:
        """Return the curve around the column."""
        ring = footprint((self.x, self.y), (self.width_x, self.width_y), self.diameter, self.angle)
        assert ring is not None
        return ring

    @property
    def extents(self) -> tuple[float, float]:
        """Return how wide it is along x and along y [m]."""
        if self.diameter is not None:
            return self.diameter, self.diameter
        assert self.width_x is not None
        assert self.width_y is not None
        return extents_at((self.width_x, self.width_y), self.angle)

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the footprint, arcs replaced by chords at most so far off [m]."""
        return self.ring().polygon(chord)


def overlapping_columns(columns: tuple[Column, ...]) -> Iterator[str]:
    """Yield a remark for each two columns whose footprints overlap: punching of one then counts the other as a load."""
    from shapely import STRtree

    if len(columns) < 2:
        return
    shapes = [column.to_shapely(1e-3 * math.sqrt(column.ring().area)) for column in columns]
    first, other = STRtree(shapes).query(shapes, predicate="intersects")
    for i, j in sorted(zip(first.tolist(), other.tolist(), strict=True)):
        shared = shapes[i].intersection(shapes[j]).area if i < j else 0.0
        if shared > SAME * shapes[i].area:
            yield f"columns {columns[i].name} and {columns[j].name} overlap by {shared:.3g} m2 of their footprints"
