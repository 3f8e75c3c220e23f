"""What closed curves and points are: the outline, openings, zones, columns."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from groundslab.case.dxf.chaining import ClosedCurve, PointIndex
from groundslab.case.dxf.drawing import DOUBLE, ReadContext, Source
from groundslab.errors import Issue
from groundslab.geometry.intersections import find_meeting
from groundslab.geometry.plan import Place, Ring, bounding_box
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity


def report_taken(found: ClosedCurve, what: str, context: ReadContext) -> None:
    """Report the entities of a curve as taken."""
    for source in found.sources:
        remark = found.remarks.get(source)
        text = what if len(found.sources) == 1 else f"part of {what}"
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
            found = "only what cannot be taken: " + ", ".join(f"{count} {kind}" for kind, count in kinds)
            why = "; ".join(dict.fromkeys(line.why for line in context.report if line.layer == entities[0][0].layer))
            context.issues.append(Issue(where, found, "a closed curve", why))
        return None, []
    outline = max(curves, key=lambda each: each.curve.area)
    report_taken(outline, "the outline", context)
    inner = EnclosingCurves(curves, context)
    for number, each in sorted(enumerate(curves), key=lambda pair: -pair[1].curve.area):
        if each is outline:
            continue
        start = each.curve.points[0]
        meeting = find_meeting(outline.region, each.curve.segments(), tolerance, context.count_pairs)
        if meeting is not None:
            found = "a second curve that crosses or touches the outline"
            context.issue(each.sources, meeting, found, "one outline")
        elif not outline.region.holds(start, context.count_edges):
            found, hint = "a second curve beside the outline", "a file describes one plate: move the others elsewhere"
            context.issue(each.sources, start, found, "one outline", hint)
        elif has_openings:
            report_ignored(each, "it lies inside the outline, but openings have a layer of their own", context)
        elif inner.find([start]) is not None:
            report_ignored(each, "it lies inside an opening", context)
        else:
            inner.add(number)
    return outline.curve, [curves[number] for number in sorted(inner.added)]


class EnclosingCurves:
    """Closed curves, added one after the other, and a tree to find those that enclose a place."""

    def __init__(self, curves: list[ClosedCurve], context: ReadContext) -> None:
        from shapely import STRtree

        self._curves, self._context = curves, context
        self.added: dict[int, int] = {}  # by the number of a curve the how manieth to be added it is
        self._tree = STRtree([bounding_box(each.curve.segments()) for each in curves])

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


def report_ignored(found: ClosedCurve, why: str, context: ReadContext) -> None:
    """Report the entities of a curve as ignored."""
    for source in found.sources:
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
