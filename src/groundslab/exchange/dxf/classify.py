"""What closed curves and points are: the outline, openings, zones, columns."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.errors import Issue
from groundslab.exchange.dxf.chaining import ClosedCurve, PointIndex
from groundslab.exchange.dxf.drawing import DOUBLE, GAP, Drawing, ReadContext, ReportLine, Source, place
from groundslab.geometry.intersections import find_meeting
from groundslab.geometry.plan import Place, Ring, bounding_box
from groundslab.geometry.rectangles import direction_at, extents_at, rectangle_at
from groundslab.geometry.regions import Region
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity
    from shapely import Polygon


def report_taken(curve: ClosedCurve, what: str, context: ReadContext) -> None:
    """Report the entities of a curve as taken."""
    for source in curve.sources:
        remark = curve.remarks.get(source)
        text = what if len(curve.sources) == 1 else f"part of {what}"
        context.report_entity(source, True, f"{text}, {remark}" if remark else text)


def find_outline(
    curves: list[ClosedCurve],
    entities: list[tuple[Source, DXFEntity]],
    has_openings: bool,
    tolerance: float,
    context: ReadContext,
) -> tuple[Ring | None, list[ClosedCurve]]:
    """Return the outline, the greatest curve of its layer, and the openings that others of that layer are."""
    if not curves:
        where = f"{context.path}, layer {describe(entities[0][0].layer)}" if entities else ""
        if entities and not any(issue.location.startswith(where) for issue in context.issues):
            kinds = Counter(entity.dxftype() for _, entity in entities).items()
            untaken = "only what cannot be taken: " + ", ".join(f"{count} {kind}" for kind, count in kinds)
            why = "; ".join(dict.fromkeys(line.why for line in context.report if line.layer == entities[0][0].layer))
            context.issues.append(Issue(where, untaken, "a closed curve", why))
        return None, []
    outline = max(curves, key=lambda closed: closed.curve.area)
    report_taken(outline, "the outline", context)
    inner = EnclosingCurves(curves, context)
    for number, closed in sorted(enumerate(curves), key=lambda pair: -pair[1].curve.area):
        if closed is outline:
            continue
        start = closed.curve.points[0]
        meeting = find_meeting(outline.region, closed.curve.segments(), tolerance, context.count_pairs)
        if meeting is not None:
            crossing = "a second curve that crosses or touches the outline"
            hint = "let outlines side by side be joined (--union), or draw what is around them"
            context.issue(closed.sources, meeting, crossing, "one outline", hint)
        elif not outline.region.holds(start, context.count_edges):
            beside, hint = "a second curve next to the outline", "a file describes one plate: move the others elsewhere"
            context.issue(closed.sources, start, beside, "one outline", hint)
        elif has_openings:
            report_ignored(closed, "it lies inside the outline, but openings have their own layer", context)
        elif inner.find([start]) is not None:
            report_ignored(closed, "it lies inside an opening", context)
        else:
            inner.add(number)
    return outline.curve, [curves[number] for number in sorted(inner.added)]


class EnclosingCurves:
    """Closed curves, added one after the other, and a tree to find those that enclose a place."""

    def __init__(self, curves: list[ClosedCurve], context: ReadContext) -> None:
        from shapely import STRtree

        self._curves, self._context = curves, context
        self.added: dict[int, int] = {}  # by the number of a curve the how manieth to be added it is
        self._tree = STRtree([bounding_box(closed.curve.segments()) for closed in curves])

    def add(self, number: int) -> None:
        """Add one of the curves."""
        self.added[number] = len(self.added)

    def find(self, points: Sequence[Place], last: bool = False) -> int | None:
        """Return the number of the first (or last) curve to be added that encloses all points; None if none does."""
        from shapely import Point

        met: list[int] = self._tree.query(Point(points[0])).tolist()
        self._context.count_edges(len(met))
        for number in sorted(self.added.keys() & met, key=self.added.__getitem__, reverse=last):
            region = self._curves[number].region
            if all(region.holds(point, self._context.count_edges) for point in points):
                return number
        return None


def report_ignored(curve: ClosedCurve, why: str, context: ReadContext) -> None:
    """Report the entities of a curve as ignored."""
    for source in curve.sources:
        context.report_entity(source, False, why)


def read_column_points(
    points: list[tuple[Source, Place]], count: int, tolerance: float, context: ReadContext
) -> list[Place]:
    """Return columns that are points, each once; ``count`` others were numbered before."""
    nodes = PointIndex(tolerance)
    for source, point in points:
        number = nodes.number(point)
        fresh = number == len(nodes.points) - 1 and nodes.points[number] is point
        context.report_entity(source, fresh, f"column {count + number + 1}, a point" if fresh else DOUBLE)
    return nodes.points


#: What differs by less than this part of a column's size is the same; corners of a rectangle may be off by GAP, if that
#: is less than a part of its size.
SAME, OF_SIDE = 1e-6, 0.01
#: 4 pi A / P^2 of a column that counts as a circle, at least: that of a rectangle whose sides are as 1 to 2.
COMPACT = 4 * math.pi * 2 / 36
#: What the report calls the entities of a column.
_NUMBERED = re.compile(r"(?:part of )?column (\d+)")
#: A closed strip on the layer of walls is the faces of one, if no wider than this [m] and than this part of its length.
WIDEST_WALL, SLENDER = 1.0, 0.5
#: A strip fills this part of the rectangle around it at least.
STRIP = 0.9
#: Decimal places of turned coordinates [m], fewer than of those that were rounded before, so that none ends in ...0001.
DIGITS = 7
#: An edge whose ends are off an axis by no more than this runs along it [m].
ALIGNED = 1e-6


@dataclass(frozen=True, slots=True)
class Footprint:
    """A column that a case can hold: a rectangle at an angle [degrees], or a circle if both widths are its diameter.

    A column of another compact shape has a circle of the same area, and ``shape`` as it is drawn.
    """

    name: str
    centre: Place
    widths: Place
    round: bool
    shape: Ring | None = None
    angle: float = 0.0

    @property
    def reach(self) -> Place:
        """How far it reaches from its center along x and along y [m]."""
        along_x, along_y = extents_at(self.widths, self.angle)
        return along_x / 2, along_y / 2

    def covers(self, x: float, y: float) -> bool:
        """Return whether a place lies on it."""
        if self.shape is not None:
            return Region(self.shape.segments()).holds((x, y))
        (c, s), dx, dy = direction_at(self.angle), x - self.centre[0], y - self.centre[1]
        reach = 0.5 + SAME
        if self.round:
            return math.hypot(dx, dy) <= reach * self.widths[0]
        return abs(c * dx + s * dy) <= reach * self.widths[0] and abs(c * dy - s * dx) <= reach * self.widths[1]


def footprint_of(curve: Ring, name: str) -> Footprint | None:
    """Return a closed curve as a column, None if it is neither a circle nor a rectangle nor compact."""
    return _exact_footprint(curve, name) or _turned_footprint(curve, name) or _equal_circle(curve, name)


def _exact_footprint(curve: Ring, name: str) -> Footprint | None:
    """Return a closed curve as a column, None if it is neither a circle nor a rectangle along x and y."""
    xs, ys = zip(*curve.points, strict=True)
    if all(curve.bulges):
        arcs = curve.segments()
        centre, radius = arcs[0].centre, arcs[0].radius
        alike = all(math.dist(arc.centre, centre) + abs(arc.radius - radius) <= SAME * radius for arc in arcs)
        whole = abs(abs(sum(arc.sweep for arc in arcs)) - 2 * math.pi) <= SAME
        return Footprint(name, centre, (2 * radius, 2 * radius), round=True) if alike and whole else None
    low, high = (min(xs), min(ys)), (max(xs), max(ys))
    near = _rounding(curve)
    corners = {(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])}
    rectangle = len(curve.points) == 4 and not any(curve.bulges)
    if not rectangle or any(min(math.dist(corner, point) for point in curve.points) > near for corner in corners):
        return None
    centre = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
    return Footprint(name, centre, (high[0] - low[0], high[1] - low[1]), round=False)


def _rounding(curve: Ring) -> float:
    """Return how far corners may be off those of a rectangle [m]."""
    size = max(curve.sides)
    return max(SAME * size, min(GAP, OF_SIDE * size))


def _turned_footprint(curve: Ring, name: str) -> Footprint | None:
    """Return a closed curve as a column at an angle, of its widths the first closest to x; None if no rectangle."""
    if len(curve.points) != 4 or any(curve.bulges):
        return None
    a, b, c, d = np.array(curve.points)
    sides = [(b - a + c - d) / 2, (d - a + c - b) / 2]
    u, v = (
        sides if abs(sides[0][0]) * math.hypot(*sides[1]) >= abs(sides[1][0]) * math.hypot(*sides[0]) else sides[::-1]
    )
    u, v = u * math.copysign(1.0, u[0]), v * math.copysign(1.0, v[1])
    # the longer side tells the direction best
    along = u if math.hypot(*u) >= math.hypot(*v) else np.array([v[1], -v[0]])
    angle = float(f"{math.degrees(math.atan2(along[1], along[0])):.9g}")
    centre, widths = (a + b + c + d) / 4, (math.hypot(*u), math.hypot(*v))
    corners = rectangle_at((float(centre[0]), float(centre[1])), widths, angle).points
    if any(min(math.dist(corner, point) for point in curve.points) > _rounding(curve) for corner in corners):
        return None
    return Footprint(name, (float(centre[0]), float(centre[1])), widths, round=False, angle=angle)


def _equal_circle(curve: Ring, name: str) -> Footprint | None:
    """Return the circle of the same area about a curve's center, None if the curve is no compact convex one.

    Of all shapes of an area the circle has the shortest edge, and so have, inside the slab, the perimeters of punching
    around it: they are on the safe side.
    """
    polygon = curve.polygon(SAME * max(curve.bounds[1] - curve.bounds[0], curve.bounds[3] - curve.bounds[2]))
    if not polygon.is_valid or polygon.convex_hull.area > (1 + 1e-3) * polygon.area:
        return None
    if 4 * math.pi * polygon.area < (1 - 1e-3) * COMPACT * polygon.length**2:
        return None
    diameter = 2 * math.sqrt(polygon.area / math.pi)
    centre = polygon.centroid
    return Footprint(name, (centre.x, centre.y), (diameter, diameter), round=True, shape=curve)


def circle_of(curve: Ring) -> tuple[Place, float] | None:
    """Return center and radius of a curve that is a circle, None of any other."""
    footprint = _exact_footprint(curve, "")
    return (footprint.centre, footprint.widths[0] / 2) if footprint is not None and footprint.round else None


def remark_on_column(curve: Ring) -> str:
    """Return the note on a column that is not read as drawn, none for others."""
    footprint = footprint_of(curve, "")
    if footprint is None:
        return "neither a rectangle nor compact; a force on it is spread over it, punching is not checked"
    if footprint.shape is None:
        return ""
    return f"taken as a circle of the same area, {footprint.widths[0]:.4g} m in diameter, also for punching"


def strip_of(foot: Polygon) -> tuple[tuple[Place, Place], float] | None:
    """Return the axis and the width [m] of a straight strip, None if a polygon is none."""
    box = foot.minimum_rotated_rectangle
    if box.geom_type != "Polygon" or foot.area < STRIP * box.area:
        return None
    a, b, c, d = list(box.exterior.coords)[:4]
    if math.dist(a, b) < math.dist(b, c):
        a, b, c, d = b, c, d, a
    # a and b are the ends of one long side, c and d those of the other one
    start, end = sorted([((a[0] + d[0]) / 2, (a[1] + d[1]) / 2), ((b[0] + c[0]) / 2, (b[1] + c[1]) / 2)])
    return (start, end), math.dist(b, c)


def faces_of_wall(points: Sequence[Place], bulges: Sequence[float]) -> tuple[tuple[Place, Place], float] | None:
    """Return the axis and the thickness [m] of a wall whose faces are a closed curve, None if this is no such strip."""
    from shapely import Polygon

    if len(points) < 4 or any(bulges):
        return None
    polygon = Polygon(points)
    strip = strip_of(polygon) if polygon.is_valid and polygon.area > 0 else None
    if strip is None or not strip[1] <= min(WIDEST_WALL, SLENDER * math.dist(*strip[0])):
        return None
    return strip


def align(drawing: Drawing) -> Drawing:
    """Return a drawing turned so that the longest straight edge of its outline runs along x or y.

    It is turned by at most 45 degrees about the origin. Rectangular columns of the same direction then
    run along x and y.
    """
    straight = [edge for edge in drawing.outline.segments() if edge.straight]
    if not straight:
        return drawing
    longest = max(straight, key=lambda edge: edge.length)
    dx, dy = longest.end[0] - longest.start[0], longest.end[1] - longest.start[1]
    angle = math.atan2(dy, dx)
    angle -= math.pi / 2 * round(angle / (math.pi / 2))
    if abs(angle) * longest.length <= ALIGNED:
        return drawing
    c, s = math.cos(angle), math.sin(angle)
    turned = place(drawing, lambda point: (c * point[0] + s * point[1], c * point[1] - s * point[0]), DIGITS)
    # remarks on columns no longer hold for all of them
    report = [line for line in drawing.report if not (line.entity == "LAYER" and line.why.startswith("column "))]
    read_from = {int(match[1]): line.layer for line in report if (match := _NUMBERED.match(line.why))}
    for number, column in enumerate(turned.columns, 1):
        if isinstance(column, Ring) and (remark := remark_on_column(column)):
            report.append(ReportLine(read_from.get(number, ""), "LAYER", "", True, f"column {number}: {remark}"))
    return replace(turned, report=tuple(report), turned=math.degrees(angle))
