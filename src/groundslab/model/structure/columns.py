"""Columns on the plate: position and footprint."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar

from groundslab.geometry.plan import Ring, circle, rectangle
from groundslab.model.ground import POSITIVE
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate
from groundslab.schema.repairs import remove

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Footprints that share less than this part of their area touch each other.
SAME = 1e-6


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


def footprint(x: float, y: float, width_x: float | None, width_y: float | None, diameter: float | None) -> Ring | None:
    """Return the curve around a footprint centred at (x, y) [m], None if it is a point."""
    if diameter is not None:
        return circle((x, y), diameter / 2)
    if width_x is not None and width_y is not None:
        return rectangle(x - width_x / 2, x + width_x / 2, y - width_y / 2, y + width_y / 2)
    return None


def _check_footprint_given(
    width_x: float | None, width_y: float | None, diameter: float | None
) -> Iterator[RelativeIssue]:
    if width_x is None and width_y is None and diameter is None:
        yield RelativeIssue(("width_x",), "nothing", "width_x and width_y, or diameter")


class Column(Section):
    """A column that stands on the plate."""

    checks: ClassVar[tuple[Check, ...]] = (check_footprint, _check_footprint_given)

    name: Annotated[str, Text("name of the column, used by loads")]
    x: Annotated[float, coordinate(0, "its center")]
    y: Annotated[float, coordinate(1, "its center")]
    width_x: Annotated[float | None, Quantity("length", "c_x", "width along x", POSITIVE)] = None
    width_y: Annotated[float | None, Quantity("length", "c_y", "width along y", POSITIVE)] = None
    diameter: Annotated[float | None, Quantity("length", "d", "diameter, instead of both widths", POSITIVE)] = None

    def ring(self) -> Ring:
        """Return the curve around the column."""
        ring = footprint(self.x, self.y, self.width_x, self.width_y, self.diameter)
        assert ring is not None
        return ring

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the footprint, arcs replaced by chords at most so far off [m]."""
        return self.ring().polygon(chord)


def overlapping_columns(columns: tuple[Column, ...]) -> Iterator[str]:
    """Yield a remark for each two columns whose footprints overlap: punching of one then counts the other as a load."""
    from shapely import STRtree

    if len(columns) < 2:
        return
    shapes = [column.to_shapely(1e-3 * math.sqrt(column.ring().area)) for column in columns]
    one, other = STRtree(shapes).query(shapes, predicate="intersects")
    for i, j in sorted(zip(one.tolist(), other.tolist(), strict=True)):
        shared = shapes[i].intersection(shapes[j]).area if i < j else 0.0
        if shared > SAME * shapes[i].area:
            yield f"columns {columns[i].name} and {columns[j].name} overlap by {shared:.3g} m2 of their footprints"
