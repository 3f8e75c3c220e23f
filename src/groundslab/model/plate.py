"""Plate: outline, openings, zones, pits among them, material, element, supported edges."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.plan import Plan, Ring, format_place
from groundslab.geometry.validity import find_issues
from groundslab.model.ground import POISSON, POSITIVE
from groundslab.model.shapes import AnyShape, Rectangle, Shape
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import quote

#: Key of the shear correction factor.
SHEAR_FACTOR = Number("kappa", "shear correction factor, 5/6 by default", Range(above=0, at_most=1))
#: Key of the thermal expansion.
THERMAL_EXPANSION = Quantity(
    "strain per temperature", "alpha_T", "strain per temperature; of concrete by default", POSITIVE, example="1e-5 1/K"
)

#: Deepest level of a pit [m], and the thickest wall of one.
DEEPEST_LEVEL, THICKEST_WALL = -30.0, 3.0

Element = Literal["mitc9", "q9", "heterosis"]
Support = Literal["free", "hinged", "soft", "clamped"]


def _check_zone_differs(
    thickness: float | None, E: float | None, nu: float | None, level: float | None
) -> Iterator[RelativeIssue]:
    if thickness is None and E is None and nu is None and level is None:
        yield RelativeIssue((), "a zone like the rest of the plate", "a different thickness, E, nu or level")


def _check_wall(level: float | None, wall: float | None) -> Iterator[RelativeIssue]:
    if level is not None and wall is None:
        yield RelativeIssue(("wall",), "nothing, with a level", 'the thickness of the pit\'s walls, such as "0.3 m"')
    elif level is None and wall is not None:
        hint, repairs = "walls stand around a part that lies lower", (remove(("wall",)),)
        yield RelativeIssue(("wall",), "walls without a level", 'a level such as "-1.2 m"', hint, repairs)


class Zone(Section):
    """A part of the plate with another thickness, material or level; the last zone that covers a place counts."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_zone_differs, _check_wall)

    shape: Annotated[Shape, Table("where; what reaches over the plate's edge is cut off")]
    thickness: Annotated[
        float | None, Quantity("length", "t", "thickness there; else the plate's", POSITIVE, example="0.6 m")
    ] = None
    E: Annotated[
        float | None, Quantity("pressure", "E", "Young's modulus there; else the plate's", POSITIVE, example="30 GPa")
    ] = None
    nu: Annotated[float | None, Number("nu", "Poisson's ratio there; else the plate's", POISSON)] = None
    level: Annotated[
        float | None,
        Quantity(
            "length",
            "z",
            "top side of a pit, measured from that of the slab around it, negative below; the shape is that of the "
            "axes of the pit's walls",
            Range(at_least=DEEPEST_LEVEL, below=0),
            example="-1.2 m",
        ),
    ] = None
    wall: Annotated[
        float | None,
        Quantity(
            "length",
            "t_w",
            "thickness of a pit's walls, which weigh and join it to the slab around",
            Range(above=0, at_most=THICKEST_WALL),
            example="0.3 m",
        ),
    ] = None


class Edges(Section):
    """How the edges on the four sides of the rectangle around the plate are supported."""

    left: Annotated[Support, Choice(Support, "support of the edge on the left, where x is least")] = "free"
    right: Annotated[Support, Choice(Support, "support of the edge on the right, where x is largest")] = "free"
    bottom: Annotated[Support, Choice(Support, "support of the edge at the bottom, where y is least")] = "free"
    top: Annotated[Support, Choice(Support, "support of the edge at the top, where y is largest")] = "free"


def _check_outline(
    length_x: float | None, length_y: float | None, outline: AnyShape | None, given: set[str]
) -> Iterator[RelativeIssue]:
    hint = "length_x and length_y make a rectangle about the origin, outline any shape where it is drawn"
    if outline is None:
        for name, value in (("length_x", length_x), ("length_y", length_y)):
            if value is None:
                yield RelativeIssue((name,), "nothing", 'a length such as "6 m", or an outline', hint)
    else:
        for name in ("length_x", "length_y"):
            if name in given:
                yield RelativeIssue((name,), "a length together with an outline", "one of them", hint)


def _check_edges(support: str, edges: Edges) -> Iterator[RelativeIssue]:
    if support != "free" and edges != Edges():
        yield RelativeIssue(
            ("support",), quote(support), "either support or edges", "edges = {...} holds sides one by one"
        )


def _check_hinged_edges(outline: AnyShape | None, support: str) -> Iterator[RelativeIssue]:
    """Find a hinged edge that is not parallel to x or y, along which no single rotation is fixed."""
    if support != "hinged" or outline is None:
        return
    for edge in outline.ring().segments():
        if not (edge.straight and edge.along_axis):
            hinge = f'"hinged" on the edge from {format_place(edge.start)} to {format_place(edge.end)} m'
            yield RelativeIssue(("support",), hinge, 'edges along x or y, or support = "soft" (w = 0) or "clamped"')
            return


def _check_geometry(
    length_x: float | None,
    length_y: float | None,
    outline: AnyShape | None,
    openings: tuple[AnyShape, ...],
    zones: tuple[Zone, ...],
) -> Iterator[RelativeIssue]:
    """Find geometry that cannot be meshed: crossings, parts outside, narrow strips, sharp corners."""
    if outline is None and not openings and not zones:
        return
    if outline is None:
        if length_x is None or length_y is None:
            return
        outline = Rectangle(x=(-length_x / 2, length_x / 2), y=(-length_y / 2, length_y / 2))
    yield from check_geometry(outline, openings, zones)


def check_geometry(
    outline: AnyShape, openings: tuple[AnyShape, ...], zones: tuple[Zone, ...]
) -> Iterator[RelativeIssue]:
    """Find geometry of an outline with openings and zones that cannot be meshed."""
    rings = tuple(opening.ring() for opening in openings)
    plan = Plan(outline.ring(), rings, tuple((zone.shape.ring(), n) for n, zone in enumerate(zones, start=1)))
    for issue in find_issues(plan):
        name, _, number = issue.location.removeprefix("plate.").rstrip("]").partition("[")
        yield RelativeIssue((name, int(number) - 1) if number else (name,), issue.found, issue.expected, issue.hint)


class Plate(Section):
    """The plate: a rectangle about the origin, or any outline."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_outline, _check_edges, _check_hinged_edges, _check_geometry)

    name: Annotated[str, Text("name of the plate, needed if there are several and loads name it")] = ""
    length_x: Annotated[
        float | None,
        Quantity("length", "L_x", "side along x of a rectangle about the origin", POSITIVE, example="12 m"),
    ] = None
    length_y: Annotated[
        float | None, Quantity("length", "L_y", "side along y of a rectangle about the origin", POSITIVE, example="8 m")
    ] = None
    outline: Annotated[Shape | None, Table("outline of any shape, instead of length_x and length_y")] = None
    openings: Annotated[tuple[Shape, ...], Table("what is cut out of the plate")] = ()
    zones: Annotated[tuple[Zone, ...], Table("parts with another thickness, material or level")] = ()
    thickness: Annotated[float, Quantity("length", "t", "thickness", POSITIVE, example="0.4 m")]
    E: Annotated[float, Quantity("pressure", "E", "Young's modulus", POSITIVE, example="30 GPa")]
    nu: Annotated[float, Number("nu", "Poisson's ratio", POISSON)]
    shear_factor: Annotated[float, SHEAR_FACTOR] = 5 / 6
    thermal_expansion: Annotated[float, THERMAL_EXPANSION] = 1e-5
    element: Annotated[Element, Choice(Element, "plate element; mitc9 does not lock")] = "mitc9"
    edges: Annotated[Edges, Table("supports: hinged is w = 0 without tangential rotation, soft is w = 0 only")] = (
        Edges()
    )
    support: Annotated[Support, Choice(Support, "support of the whole outline, of any shape")] = "free"

    @property
    def plain(self) -> bool:
        """Return whether the plate is a rectangle about the origin with nothing cut out and one section."""
        return self.outline is None and not self.openings and not self.zones

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, x1, y0, y1 around the plate [m]."""
        if self.outline is None:
            assert self.length_x is not None
            assert self.length_y is not None
            return -self.length_x / 2, self.length_x / 2, -self.length_y / 2, self.length_y / 2
        return self.outline.ring().bounds

    def ring(self) -> Ring:
        """Return the outline as a curve."""
        return (self.outline or Rectangle(x=self.bounds[:2], y=self.bounds[2:])).ring()

    def rings(self) -> tuple[Ring, ...]:
        """Return the outline and the openings as curves."""
        return self.ring(), *(opening.ring() for opening in self.openings)

    @property
    def sides(self) -> tuple[float, float]:
        """Return the sides of the rectangle around the plate [m]."""
        x0, x1, y0, y1 = self.bounds
        return x1 - x0, y1 - y0
