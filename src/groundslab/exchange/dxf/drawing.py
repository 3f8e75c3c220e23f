"""What is read from a drawing, and the state while it is read: unit, issues, report, work done."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn

from groundslab.errors import InputError, Issue
from groundslab.exchange.size import remark_on_size
from groundslab.geometry.plan import Place, Ring, Segment, make_segments
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.math import Vec3


@dataclass(frozen=True, slots=True)
class PointMark:
    """A point load: place [m], value [N] (None if the drawing has none), and what is written beside it."""

    x: float
    y: float
    value: float | None
    text: str


@dataclass(frozen=True, slots=True)
class LineMark:
    """A line load, a wall or a beam: points [m], the bulge of the edge after each, value or None, the text beside it.

    The value is a force per length [N/m], or a thickness [m]; a beam's section is in its text.
    """

    points: tuple[Place, ...]
    bulges: tuple[float, ...]  # one less than points if it is open
    value: float | None
    text: str

    @property
    def closed(self) -> bool:
        """Return whether the last point is joined to the first."""
        return len(self.bulges) == len(self.points)

    def corners(self) -> tuple[Place, ...]:
        """Return the points, the first again at the end if the line is closed."""
        return self.points + (self.points[:1] if self.closed else ())

    def segments(self) -> tuple[Segment, ...]:
        """Return the edges that it stands on."""
        return make_segments(self.corners(), self.bulges)


@dataclass(frozen=True, slots=True)
class AreaMark:
    """An area load: its edge, the edges of its holes, value [Pa] or None, what is written beside it."""

    curve: Ring
    holes: tuple[Ring, ...]
    value: float | None
    text: str


@dataclass(frozen=True, slots=True)
class ReportLine:
    """What became of one entity; a note on a whole layer or on the header has LAYER or HEADER for its entity."""

    layer: str
    entity: str
    handle: str
    taken: bool
    why: str


@dataclass(frozen=True, slots=True)
class Drawing:
    """What was taken from a drawing, in meters; ``scale`` is the size of its ``unit`` in meters.

    ``origin`` is the place of the drawing [m] from which coordinates are measured, and the x axis is ``turned`` by an
    angle from the drawing's [degrees]. What no drawing says, but other
    files do, is None or empty.
    """

    outline: Ring
    openings: tuple[Ring, ...]
    zones: tuple[Ring, ...]
    columns: tuple[Ring | Place, ...]
    walls: tuple[LineMark, ...]  # their values are thicknesses
    beams: tuple[LineMark, ...]
    point_loads: tuple[PointMark, ...]
    line_loads: tuple[LineMark, ...]
    area_loads: tuple[AreaMark, ...]
    report: tuple[ReportLine, ...]
    unit: str
    scale: float
    origin: Place = (0.0, 0.0)
    turned: float = 0.0
    thickness: float | None = None  # of the slab [m]
    column_names: tuple[str, ...] = ()  # C1, C2 and so on if there are none
    wall_names: tuple[str, ...] = ()

    @property
    def remark_on_size(self) -> str:
        """Return what of its size contradicts its unit, nothing if nothing does."""
        widths = [max(column.sides) for column in self.columns if isinstance(column, Ring)]
        return remark_on_size(self.outline.sides, widths, self.unit, self.scale)


def center(drawing: Drawing) -> Drawing:
    """Return a drawing whose origin is the middle of the outline's sides, with coordinates to a nanometer."""
    x0, x1, y0, y1 = drawing.outline.bounds
    origin = (x0 + x1) / 2, (y0 + y1) / 2
    return replace(place(drawing, lambda point: (point[0] - origin[0], point[1] - origin[1])), origin=origin)


def place(drawing: Drawing, to: Callable[[Place], Place], digits: int = 9) -> Drawing:
    """Return a drawing whose points are moved or turned, with coordinates of so many decimal places [m]."""

    def move(point: Place) -> Place:
        x, y = to(point)
        return round(x, digits) + 0.0, round(y, digits) + 0.0

    def move_ring(ring: Ring) -> Ring:
        return replace(ring, points=tuple(map(move, ring.points)))

    def move_area(area: AreaMark) -> AreaMark:
        return replace(area, curve=move_ring(area.curve), holes=tuple(map(move_ring, area.holes)))

    def move_line(line: LineMark) -> LineMark:
        return replace(line, points=tuple(map(move, line.points)))

    columns = tuple(move_ring(column) if isinstance(column, Ring) else move(column) for column in drawing.columns)
    loads = [(load, move((load.x, load.y))) for load in drawing.point_loads]
    return replace(
        drawing,
        outline=move_ring(drawing.outline),
        openings=tuple(map(move_ring, drawing.openings)),
        zones=tuple(map(move_ring, drawing.zones)),
        columns=columns,
        point_loads=tuple(replace(load, x=x, y=y) for load, (x, y) in loads),
        walls=tuple(map(move_line, drawing.walls)),
        beams=tuple(map(move_line, drawing.beams)),
        line_loads=tuple(map(move_line, drawing.line_loads)),
        area_loads=tuple(map(move_area, drawing.area_loads)),
    )


CLOSE = 1e-6  # ends so near, as a part of the drawing's size, are one point
#: Open ends so near each other [m] are joined, unless told otherwise, if that moves none by much of its edge.
GAP, OF_EDGE = 1e-3, 0.1
MOST_ENTITIES = 50_000  # entities on the layers that are read
MOST_ISSUES = 100  # that are listed
MOST_EDGES = 50_000  # of all curves
MOST_PAIRS = 250_000  # of edges that are compared
MOST_BESIDE = 2_000_000  # edges that are looked at to see what lies inside what
FARTHEST = 1e9  # m
DOUBLE = "it lies on top of what was taken already"


@dataclass(frozen=True, slots=True)
class Source:
    """Where something comes from: layer and name as drawn, handle (of the outermost block reference)."""

    layer: str
    entity: str
    handle: str


@dataclass(slots=True)
class ReadContext:
    """What is known and found while a drawing is read."""

    path: str
    unit: str = "units"
    scale: Fraction = Fraction(1, 1000)
    gap: float = GAP  # that is closed between two open ends [m]
    issues: list[Issue] = field(default_factory=list)
    report: list[ReportLine] = field(default_factory=list)
    more: int = 0  # issues beyond the first MOST_ISSUES
    spent: Counter[str] = field(default_factory=Counter)  # work done so far, by what it was

    def to_meters(self, value: float) -> float:
        """Return a length of the drawing in meters, rounded once if it can be."""
        return value * self.scale.numerator / self.scale.denominator

    def point(self, vector: Vec3) -> Place:
        """Return a point of the drawing in meters."""
        return self.to_meters(vector.x), self.to_meters(vector.y)

    def format_length(self, length: float) -> str:
        """Return a length in the drawing's unit, as it is seen there."""
        return f"{float(length / self.scale):.6g} {self.unit}"

    def format_point(self, point: Place) -> str:
        """Return a place as it is seen in the drawing."""
        x, y = (f"{round(float(value / self.scale), 10) + 0.0:.10g}" for value in point)
        return f"({x}, {y}) {self.unit}"

    def report_entity(self, source: Source, taken: bool, why: str) -> None:
        """Add a line to the report."""
        self.report.append(ReportLine(source.layer, source.entity, source.handle, taken, why))

    def issue(self, sources: Sequence[Source], point: Place | None, found: str, expected: str, hint: str = "") -> None:
        """Add an issue with file, layer, entities and place."""
        names = " and ".join(dict.fromkeys(f"{source.entity} {source.handle}".strip() for source in sources[:3]))
        where = f"{self.path}, layer {describe(sources[0].layer)}, {names}"
        if len(sources) > 3:
            where += f" and {len(sources) - 3} more"
        self.add(Issue(f"{where} at {self.format_point(point)}" if point else where, found, expected, hint))

    def add(self, issue: Issue) -> None:
        """Add an issue; of very many only the first are kept."""
        if len(self.issues) < MOST_ISSUES:
            self.issues.append(issue)
        else:
            self.more += 1

    def count_work(self, count: int, limit: int, what: str, hint: str = "") -> None:
        """Count work before it is done; raises InputError where a drawing wants more of one kind than the limit."""
        self.spent[what] += count
        if self.spent[what] > limit:
            abort(self, f"more than {limit:,} {what}", "fewer", hint or "leave only what is needed on these layers")

    def count_pairs(self, count: int) -> None:
        """Count pairs of edges that are about to be compared."""
        self.count_work(count, MOST_PAIRS, "pairs of edges near each other", "draw curves with fewer edges")

    def count_edges(self, count: int) -> None:
        """Count edges beside points, of which is about to be seen what lies inside them."""
        self.count_work(count, MOST_BESIDE, "edges beside points", "draw fewer curves, or curves with fewer edges")

    def to_error(self) -> InputError:
        """Return the error with all issues."""
        more = [Issue(self.path, f"{self.more:,} more issues", "none")] if self.more else []
        return InputError([*self.issues, *more])


def abort(context: ReadContext, found: str, expected: str, hint: str = "") -> NoReturn:
    """Raise the error that ends the reading at once."""
    raise InputError([*context.issues, Issue(context.path, found, expected, hint)])
