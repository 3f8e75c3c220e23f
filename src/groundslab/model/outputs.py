"""Requested outputs: title block and chapters of the report, points, section lines, strips."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, get_args

from groundslab.languages import Language
from groundslab.model.ground import POSITIVE, AnyGround, ContinuousGround
from groundslab.model.loads.placement import on_plate
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, list_plates
from groundslab.model.plates.region import PlateRegion
from groundslab.model.shapes import Place
from groundslab.model.structure.walls import Wall
from groundslab.model.supports import check_names
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, Integer, ListOf, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import quote
from groundslab.unit_systems import System

if TYPE_CHECKING:
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

#: A strip that is a beam ends at the plate's edges, within such a share of its width; what is wider than so many times
#: its thickness is a slab (EN 1992-1-1 5.3.1(4)).
AT_EDGE, WIDEST = 0.01, 5.0


class Project(Section):
    """What stands in the title block of the report, and units of output; none of it takes part in the analysis."""

    name: Annotated[str, Text("name of the project")] = ""
    number: Annotated[str, Text("its number")] = ""
    part: Annotated[str, Text("part of the structure")] = ""
    client: Annotated[str, Text("for whom")] = ""
    author: Annotated[str, Text("who made the calculation")] = ""
    checker: Annotated[str, Text("who checked it")] = ""
    revision: Annotated[str, Text("revision of the calculation")] = ""
    date: Annotated[str, Text("its date, as it should be shown")] = ""
    units: Annotated[
        System,
        Choice(
            System,
            "units of results in the summary, tables, report, figures and workbench: SI, or those customary in the "
            "United States (kip, ft, in, psf, psi, and bars by number)",
        ),
    ] = "SI"
    language: Annotated[
        Language,
        Choice(
            Language,
            "language of the report, summary and headings of tables: English, German, French, Spanish or Polish",
        ),
    ] = "en"


#: How much of all that was computed the report holds.
Length = Literal["short", "full"]
#: Chapters of the report, in their order.
Chapter = Literal[
    "drawings", "loads", "extremes", "pictures", "grounds", "assumptions", "calculations", "tables", "viewer",
    "case", "certificate", "convergence", "long_tables",
]  # fmt: skip
#: Those that it has by default in full.
CHAPTERS: tuple[Chapter, ...] = tuple(chapter for chapter in get_args(Chapter) if chapter != "long_tables")


class Report(Section):
    """What the report holds beside its first page."""

    length: Annotated[
        Length | None,
        Choice(
            Length,
            "short: what governs, one calculation of each kind and a row for each thing designed; full: all chapters, "
            "tables and calculations; by default short on paper and full on the page",
        ),
    ] = None
    paper: Annotated[
        Literal["A4", "letter"] | None,
        Choice(
            Literal["A4", "letter"], "size of the paper; by default letter with units of the United States, else A4"
        ),
    ] = None
    chapters: Annotated[
        tuple[Chapter, ...],
        ListOf(
            Choice(Chapter, ""),
            "",
            "its chapters, in the report's own order; by default those of its length, in full all but long_tables",
            unique=True,
        ),
    ] = CHAPTERS
    sheets: Annotated[
        Literal["governing", "all", "none"],
        Choice(
            Literal["governing", "all", "none"],
            "calculations to be followed by hand: with the column, pile and wall end that govern, with all, or none",
            "",
        ),
    ] = "governing"


class OutputPoint(Section):
    """A point at which all fields are listed."""

    name: Annotated[str, Text("name of the point")]
    x: Annotated[float, coordinate(0, "position")]
    y: Annotated[float, coordinate(1, "position")]

    def to_shapely(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the point."""
        from shapely import Point

        return Point(self.x, self.y)


def _check_line_length(start: tuple[float, float], end: tuple[float, float]) -> Iterator[RelativeIssue]:
    if start == end:
        yield RelativeIssue(("end",), "the place where it starts", "another place")


class OutputLine(Section):
    """A straight section line along which all fields are listed."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_line_length,)

    name: Annotated[str, Text("name of the line")]
    start: Annotated[tuple[float, float], Place]
    end: Annotated[tuple[float, float], Place]


class OutputStrip(Section):
    """A design strip: forces across it, as integrals over its width and per meter; it may be designed as a beam."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_line_length,)

    name: Annotated[str, Text("name of the strip")]
    start: Annotated[tuple[float, float], Place]
    end: Annotated[tuple[float, float], Place]
    width: Annotated[
        float, Quantity("length", "b", "its width, half of it on each side of the axis", POSITIVE, example="1 m")
    ]
    stations: Annotated[
        int, Integer("number of cuts across it, evenly spaced from start to end", at_least=2, at_most=1000)
    ] = 21
    design: Annotated[
        Literal["plate", "beam"],
        Choice(
            Literal["plate", "beam"],
            "what the slab is designed as along it: a plate, or a beam from edge to edge, as a grade beam",
            "",
        ),
    ] = "plate"
    torsion: Annotated[
        Literal["resisted", "released"],
        Choice(
            Literal["resisted", "released"],
            "whether as a beam it is designed for torsion; released where compatibility alone twists it",
            "",
        ),
    ] = "resisted"

    def area(self) -> Polygon:
        """Return what it covers in plan, on the plate and beside it."""
        from shapely import LineString

        return LineString([self.start, self.end]).buffer(self.width / 2, cap_style="flat")

    def beyond(self, shape: BaseGeometry) -> float:
        """Return how far the strip, along x or y, goes beyond a shape on the side on which it does so more [m]."""
        across = int(self.start[1] == self.end[1])
        low, high = (shape.bounds[across + 2 * upper] - self.start[across] for upper in (0, 1))
        return float(max(self.width / 2 - high, self.width / 2 + low))


def _check_point_names(points: tuple[OutputPoint, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("points", [point.name for point in points], needed=True)


def _check_line_names(lines: tuple[OutputLine, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("lines", [line.name for line in lines], needed=True)


def _check_strip_names(strips: tuple[OutputStrip, ...]) -> Iterator[RelativeIssue]:
    yield from check_names("strips", [strip.name for strip in strips], needed=True)


class Output(Section):
    """Where values are listed."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_point_names, _check_line_names, _check_strip_names)

    points: Annotated[tuple[OutputPoint, ...], Table("points at which all fields are listed", 10_000)] = ()
    lines: Annotated[tuple[OutputLine, ...], Table("section lines along which all fields are listed")] = ()
    strips: Annotated[tuple[OutputStrip, ...], Table("design strips")] = ()
    wall_limits: Annotated[
        bool, Boolean("whether to solve with none and with all of the stiffness of walls that have a height, too")
    ] = False

    @property
    def beams(self) -> tuple[OutputStrip, ...]:
        """Return the strips that are designed as beams."""
        return tuple(strip for strip in self.strips if strip.design == "beam")


def check_wall_limits(output: Output, walls: tuple[Wall, ...]) -> Iterator[RelativeIssue]:
    """Find limits that are asked for without walls that have any."""
    if output.wall_limits and all(wall.height is None for wall in walls):
        yield RelativeIssue(("output", "wall_limits"), "true, without such a wall", "a wall with a height, or false")


def check_output(
    plate: Plate, plates: tuple[FurtherPlate, ...], ground: AnyGround, output: Output
) -> Iterator[RelativeIssue]:
    """Find points that do not lie on the plate, and lines and strips that miss it.

    In the depth of a continuum there are values below openings and beside the plate as well.
    """
    from shapely import LineString, union_all

    covered = PlateRegion(plate, plates)
    for position, point in enumerate(() if isinstance(ground, ContinuousGround) else output.points):
        yield from on_plate(covered, point, ("output", "points", position))
    if not (output.lines or output.strips):
        return
    outline = union_all([slab.ring().polygon(1e-4 * max(slab.sides)) for slab in list_plates(plate, plates)])
    wanted: dict[str, tuple[OutputLine | OutputStrip, ...]] = {"lines": output.lines, "strips": output.strips}
    for part, lines in wanted.items():
        for position, line in enumerate(lines):
            if not outline.intersects(LineString([line.start, line.end])):
                yield RelativeIssue(("output", part, position), "a line off the plate", "one that crosses it")
    yield from _check_beams(covered, output.strips)


def _check_beams(covered: PlateRegion, strips: tuple[OutputStrip, ...]) -> Iterator[RelativeIssue]:
    """Find strips that are beams whose axis leaves the plate, beside which it goes on, too wide or on each other."""
    from shapely import LineString, union_all

    beams = [(position, strip) for position, strip in enumerate(strips) if strip.design == "beam"]
    if not beams:
        return
    every = union_all([strip.area() for _, strip in beams])
    for position, strip in beams:
        axis, near = LineString([strip.start, strip.end]), AT_EDGE * strip.width
        if not covered.area.buffer(near).covers(axis):
            yield RelativeIssue(("output", "strips", position), "a beam off the plate", "one whose axis lies on it")
        beside = strip.area().buffer(near, cap_style="flat").difference(every).intersection(covered.area)
        if beside.buffer(-near / 4).area > 0:
            narrow_beam, expected = "a beam beside which the plate goes on", "one that reaches from edge to edge"
            hint = 'widen it, give the beams that cross it, too, or design = "plate"'
            yield RelativeIssue(("output", "strips", position, "width"), narrow_beam, expected, hint)
        yield from (issue.below(("output", "strips", position)) for issue in _check_beam(covered, strip, beams))


def _check_beam(
    covered: PlateRegion, strip: OutputStrip, beams: list[tuple[int, OutputStrip]]
) -> Iterator[RelativeIssue]:
    """Find that a strip is too wide for a beam, or lies on another one along it, so that neither has all forces."""
    along = int(strip.start[0] == strip.end[0])
    on_plate = strip.area().intersection(covered.area)
    across = (on_plate.bounds[3 - along] - on_plate.bounds[1 - along]) if on_plate.area else 0.0
    thickest = max(slab.thickness for slab in covered.every)
    if across > WIDEST * thickest * (1 + AT_EDGE):
        width, expected = f"a beam {across:.4g} m wide", f"at most {WIDEST * thickest:.4g} m, five times the thickness"
        yield RelativeIssue(("width",), width, expected, 'what is wider is a slab: design = "plate"')
    for _, other in beams:
        if other is strip or int(other.start[0] == other.end[0]) != along:
            continue
        if strip.area().intersection(other.area()).area > AT_EDGE * strip.width**2:
            yield RelativeIssue((), f"a beam on the beam {quote(other.name)}", "one that ends where the other begins")
            return
