"""Requested outputs: points, section lines, design strips, reinforcement."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar

from groundslab.model.ground import POSITIVE
from groundslab.model.loads.placement import on_plate
from groundslab.model.plate import Plate, PlateRegion
from groundslab.model.shapes import Place
from groundslab.model.supports import check_names
from groundslab.schema.base import Check, Section, Table
from groundslab.schema.fields import Integer, Number, Quantity, Text, list_quantities
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Strengths for which EN 1992-1-1 has rules (3.1.2(2), 3.2.2(3)).
CONCRETE, STEEL = Range(at_least=12e6, at_most=90e6), Range(at_least=400e6, at_most=600e6)
PARTIAL = Range(at_least=0.1, at_most=10)


class OutputPoint(Section):
    """A point at which all fields are listed."""

    name: Annotated[str, Text("name of the point")]
    x: Annotated[float, Quantity("length", "x", "position")]
    y: Annotated[float, Quantity("length", "y", "position")]

    def to_shapely(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the point."""
        from shapely import Point

        return Point(self.x, self.y)


def _check_line_length(start: tuple[float, float], end: tuple[float, float]) -> Iterator[RelativeIssue]:
    if start == end:
        yield RelativeIssue(("end",), "the place where it starts", "another place")


class OutputLine(Section):
    """A straight section line along which all fields are listed."""

    checks: ClassVar[tuple[Check, ...]] = (_check_line_length,)

    name: Annotated[str, Text("name of the line")]
    start: Annotated[tuple[float, float], Place]
    end: Annotated[tuple[float, float], Place]


class OutputStrip(Section):
    """A design strip: moments across it, as integrals over its width and per meter."""

    checks: ClassVar[tuple[Check, ...]] = (_check_line_length,)

    name: Annotated[str, Text("name of the strip")]
    start: Annotated[tuple[float, float], Place]
    end: Annotated[tuple[float, float], Place]
    width: Annotated[float, Quantity("length", "b", "its width, half of it on each side of the axis", POSITIVE)]
    stations: Annotated[
        int, Integer("number of cuts across it, evenly spaced from start to end", at_least=2, at_most=1000)
    ] = 21


def _check_point_names(points: tuple[OutputPoint, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("points", [point.name for point in points], needed=True)


def _check_line_names(lines: tuple[OutputLine, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("lines", [line.name for line in lines], needed=True)


def _check_strip_names(strips: tuple[OutputStrip, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("strips", [strip.name for strip in strips], needed=True)


class Output(Section):
    """Where values are listed."""

    checks: ClassVar[tuple[Check, ...]] = (_check_point_names, _check_line_names, _check_strip_names)

    points: Annotated[tuple[OutputPoint, ...], Table("points at which all fields are listed", 10_000)] = ()
    lines: Annotated[tuple[OutputLine, ...], Table("section lines along which all fields are listed")] = ()
    strips: Annotated[tuple[OutputStrip, ...], Table("design strips")] = ()


class Reinforcement(Section):
    """Concrete, steel and where the bars lie, for reinforcement by EN 1992-1-1."""

    f_ck: Annotated[float, Quantity("pressure", "f_ck", "characteristic strength of the concrete", CONCRETE)]
    f_yk: Annotated[float, Quantity("pressure", "f_yk", "characteristic yield strength of the steel", STEEL)]
    gamma_c: Annotated[float, Number("gamma_C", "partial factor of concrete", PARTIAL)] = 1.5
    gamma_s: Annotated[float, Number("gamma_S", "partial factor of steel", PARTIAL)] = 1.15
    alpha_cc: Annotated[
        float, Number("alpha_cc", "long-term effects on the strength of concrete", Range(above=0, at_most=1))
    ] = 1.0
    bottom: Annotated[
        tuple[float, float],
        list_quantities("length", "d_1", "bottom face to the axis of bars along x, along y", 2, POSITIVE),
    ]
    top: Annotated[
        tuple[float, float],
        list_quantities("length", "d_1", "top face to the axis of bars along x, along y", 2, POSITIVE),
    ]


def check_output(plate: Plate, output: Output) -> Iterator[RelativeIssue]:
    """Find points that do not lie on the plate, and lines and strips that miss it."""
    from shapely import LineString

    covered = PlateRegion(plate)
    for position, point in enumerate(output.points):
        yield from on_plate(covered, point, ("output", "points", position))
    if not (output.lines or output.strips):
        return
    outline = plate.ring().polygon(1e-4 * max(plate.sides))
    wanted: dict[str, tuple[OutputLine | OutputStrip, ...]] = {"lines": output.lines, "strips": output.strips}
    for part, lines in wanted.items():
        for position, line in enumerate(lines):
            if not outline.intersects(LineString([line.start, line.end])):
                yield RelativeIssue(("output", part, position), "a line beside the plate", "one that crosses it")


def check_bar_distances(plate: Plate, reinforcement: Reinforcement | None) -> Iterator[RelativeIssue]:
    """Find bars that do not fit into the thinnest part of the plate."""
    if reinforcement is None:
        return
    thinnest = min([plate.thickness, *(zone.thickness for zone in plate.zones if zone.thickness is not None)])
    for face in ("bottom", "top"):
        for position, distance in enumerate(getattr(reinforcement, face)):
            if distance >= thinnest / 2:
                expected = f"less than half of the least thickness, {thinnest / 2!r} m"
                yield RelativeIssue(("reinforcement", face, position), f"{distance!r} m", expected)
