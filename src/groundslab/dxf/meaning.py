"""What closed curves and points are: the outline, openings, zones, columns."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from groundslab.dxf.chains import Found
from groundslab.dxf.crossings import first_meeting
from groundslab.dxf.curves import Curve, Point, inside
from groundslab.dxf.nodes import Nodes
from groundslab.dxf.sheet import DOUBLE, Sheet, Source
from groundslab.dxf.words import named
from groundslab.errors import Fault

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
        if entities and not any(fault.where.startswith(where) for fault in sheet.faults):
            kinds = Counter(entity.dxftype() for _, entity in entities).items()
            got = "only what cannot be taken: " + ", ".join(f"{count} {kind}" for kind, count in kinds)
            why = "; ".join(dict.fromkeys(line.why for line in sheet.report if line.layer == entities[0][0].layer))
            sheet.faults.append(Fault(where, got, "a closed curve", why))
        return None, []
    outline = max(curves, key=lambda each: each.curve.area)
    tell_taken(outline, "the outline", sheet)
    inner: list[Found] = []
    for each in sorted((each for each in curves if each is not outline), key=lambda each: -each.curve.area):
        meeting = first_meeting(outline.edges(), each.edges(), tolerance)
        if meeting is not None:
            got = "a second curve that crosses or touches the outline"
            sheet.fault(each.sources, meeting, got, "one outline")
        elif not inside(each.curve.points[0], outline.edges()):
            got, mend = "a second curve beside the outline", "a file describes one plate: move the others elsewhere"
            sheet.fault(each.sources, each.curve.points[0], got, "one outline", mend)
        elif has_openings:
            _tell_ignored(each, "it lies inside the outline, but openings have a layer of their own", sheet)
        elif any(inside(each.curve.points[0], hole.edges()) for hole in inner):
            _tell_ignored(each, "it lies inside an opening", sheet)
        else:
            inner.append(each)
    inner.sort(key=curves.index)
    return outline.curve, inner


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
