"""What closed curves and points are: the outline, openings, zones, columns."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from groundslab.case.dxf.chains import Found
from groundslab.case.dxf.nodes import Nodes
from groundslab.case.dxf.sheet import DOUBLE, Sheet, Source
from groundslab.case.dxf.words import named
from groundslab.errors import Issue
from groundslab.geometry.bulges import Curve, Point, Region
from groundslab.geometry.intersections import meeting_of

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity


def tell_taken(found: Found, what: str, sheet: Sheet) -> None:
    """Report the entities of a curve as taken."""
    for source in found.sources:
        remark = found.remarks.get(source)
        text = what if len(found.sources) == 1 else f"part of {what}"
        sheet.tell(source, True, f"{text}, {remark}" if remark else text)


def choose(
    curves: list[Found],
    entities: list[tuple[Source, DXFEntity]],
    has_openings: bool,
    tolerance: float,
    sheet: Sheet,
) -> tuple[Curve | None, list[Found]]:
    """Return the outline, the greatest curve of its layer, and the openings that others of that layer are."""
    if not curves:
        where = f"{sheet.path}, layer {named(entities[0][0].layer)}" if entities else ""
        if entities and not any(issue.location.startswith(where) for issue in sheet.issues):
            kinds = Counter(entity.dxftype() for _, entity in entities).items()
            found = "only what cannot be taken: " + ", ".join(f"{count} {kind}" for kind, count in kinds)
            why = "; ".join(dict.fromkeys(line.why for line in sheet.report if line.layer == entities[0][0].layer))
            sheet.issues.append(Issue(where, found, "a closed curve", why))
        return None, []
    outline = max(curves, key=lambda each: each.curve.area)
    tell_taken(outline, "the outline", sheet)
    around, inner = Region(outline.edges()), Holders(curves, sheet)
    rest = sorted((each for each in curves if each is not outline), key=lambda each: -each.curve.area)
    for each in rest:
        start = each.curve.points[0]
        meeting = meeting_of(around, each.edges(), tolerance, sheet.near)
        if meeting is not None:
            found = "a second curve that crosses or touches the outline"
            sheet.issue(each.sources, meeting, found, "one outline")
        elif not around.holds(start, sheet.beside):
            found, hint = "a second curve beside the outline", "a file describes one plate: move the others elsewhere"
            sheet.issue(each.sources, start, found, "one outline", hint)
        elif has_openings:
            _tell_ignored(each, "it lies inside the outline, but openings have a layer of their own", sheet)
        elif inner.first(start) is not None:
            _tell_ignored(each, "it lies inside an opening", sheet)
        else:
            inner.add(each)
    return outline.curve, inner.in_order()


class Holders:
    """Closed curves, added one after the other, and a tree to find the first of them that holds a place."""

    def __init__(self, curves: list[Found], sheet: Sheet) -> None:
        from shapely import STRtree, box

        self._curves, self._sheet = curves, sheet
        self._number = {id(each): number for number, each in enumerate(curves)}
        self._rank: dict[int, int] = {}  # which of those added a curve is
        self._regions: dict[int, Region] = {}
        boxes = [[edge.box() for edge in each.edges()] for each in curves]
        self._tree = STRtree(
            [box(*map(min, list(zip(*each, strict=True))[:2]), *map(max, list(zip(*each, strict=True))[2:]))
             for each in boxes]
        )  # fmt: skip

    def add(self, curve: Found) -> None:
        """Add one of the curves."""
        self._rank[self._number[id(curve)]] = len(self._rank)

    def first(self, point: Point) -> Found | None:
        """Return the curve, of those added, that was the first to be added and holds a place; None if none does."""
        from shapely import Point as Place

        met: list[int] = self._tree.query(Place(point)).tolist()
        self._sheet.beside(len(met))
        for number in sorted((each for each in met if each in self._rank), key=self._rank.__getitem__):
            if self._region(number).holds(point, self._sheet.beside):
                return self._curves[number]
        return None

    def last(self, points: Sequence[Point]) -> Found | None:
        """Return the curve, of those added, that was the last to be added and holds all points; None if none does."""
        from shapely import Point as Place

        met: list[int] = self._tree.query(Place(points[0])).tolist()
        self._sheet.beside(len(met))
        for number in sorted((each for each in met if each in self._rank), key=self._rank.__getitem__, reverse=True):
            region = self._region(number)
            if all(region.holds(point, self._sheet.beside) for point in points):
                return self._curves[number]
        return None

    def _region(self, number: int) -> Region:
        """Return the region of a curve, made when it is first asked for."""
        if number not in self._regions:
            self._regions[number] = Region(self._curves[number].edges())
        return self._regions[number]

    def in_order(self) -> list[Found]:
        """Return the curves that were added, in the order of the drawing."""
        return [self._curves[number] for number in sorted(self._rank)]


def _tell_ignored(found: Found, why: str, sheet: Sheet) -> None:
    """Report the entities of a curve as ignored."""
    for source in found.sources:
        sheet.tell(source, False, why)


def spots_of(points: list[tuple[Source, Point]], count: int, tolerance: float, sheet: Sheet) -> list[Point]:
    """Return columns that are points, each once; ``count`` others were numbered before."""
    nodes = Nodes(tolerance)
    for source, point in points:
        number = nodes.number(point)
        fresh = number == len(nodes.points) - 1 and nodes.points[number] is point
        sheet.tell(source, fresh, f"column {count + number + 1}, a point" if fresh else DOUBLE)
    return nodes.points
