"""From a file to a Drawing: each step of the reading, one after the other."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.case.dxf.blocks import Blocks, walk
from groundslab.case.dxf.chains import Found, close
from groundslab.case.dxf.classify import choose, spots_of, tell_taken
from groundslab.case.dxf.document import open_drawing, take_unit
from groundslab.case.dxf.drawing import Drawing
from groundslab.case.dxf.labels import DIMENSION, Label, label_of
from groundslab.case.dxf.layers import WITH_VALUE, Layers, Roles, look_at, roles_of
from groundslab.case.dxf.marks import marks_of
from groundslab.case.dxf.pieces import Piece, piece_of, spot_of
from groundslab.case.dxf.sheet import CLOSE, LARGEST, MOST_EDGES, Sheet, Source, stop
from groundslab.case.dxf.spread import areas_of, lines_of
from groundslab.geometry.bulges import Point
from groundslab.geometry.intersections import first_meeting

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity

#: Entities that say something.
WRITTEN = ("TEXT", "MTEXT", "ATTRIB", "ATTDEF")
#: What is drawn as closed curves.
CURVES = ("outline", "openings", "zones", "columns")


def read(path: str | Path, layers: Layers | None = None, unit: str | None = None) -> Drawing:
    """Return what a drawing's layers hold; raises InputError with all that is wrong.

    ``unit`` (such as "mm") is needed if the drawing does not say its own, and wins over it.
    """
    sheet, layers = Sheet(str(path)), layers or Layers()
    document = open_drawing(sheet.path)
    take_unit(document, unit, sheet)
    roles = roles_of(layers, sheet)
    entities = _entities(document, roles, sheet)
    look_at(document, layers, roles, entities, sheet)
    texts = {role: _texts(entities[role], DIMENSION[role], sheet) for role in WITH_VALUE}
    lines, points = _lines(entities, sheet)
    tolerance = _tolerance(lines, points)
    found = {role: close(lines[role], tolerance, sheet) for role in (*CURVES, "area_loads")}
    _check(found, tolerance, sheet)
    outline, inner = choose(found["outline"], entities["outline"], bool(found["openings"]), tolerance, sheet)
    openings = [*inner, *found["openings"]]
    for name, curves in (("opening", openings), ("zone", found["zones"]), ("column", found["columns"])):
        for number, each in enumerate(curves, 1):
            tell_taken(each, f"{name} {number}", sheet)
    columns = [each.curve for each in found["columns"]] + spots_of(points, len(found["columns"]), tolerance, sheet)
    marks = marks_of(entities["point_loads"], tolerance, sheet)
    line_loads = lines_of(lines["line_loads"], texts["line_loads"], roles, tolerance, sheet)
    area_loads = areas_of(found["area_loads"], texts["area_loads"], roles, sheet)
    if sheet.issues or outline is None:
        raise sheet.refused()
    return Drawing(
        outline=outline,
        openings=tuple(each.curve for each in openings),
        zones=tuple(each.curve for each in found["zones"]),
        columns=tuple(columns),
        point_loads=tuple(marks),
        line_loads=tuple(line_loads),
        area_loads=tuple(area_loads),
        report=tuple(sheet.report),
        unit=sheet.unit,
        scale=float(sheet.scale),
    )


def _entities(document: Document, roles: Roles, sheet: Sheet) -> dict[str, list[tuple[Source, DXFEntity]]]:
    """Return what lies on the layers asked for, by what it stands for."""
    entities: dict[str, list[tuple[Source, DXFEntity]]] = defaultdict(list)
    blocks = Blocks(document, roles, sheet)
    for role, source, entity in walk(document.modelspace(), roles, blocks, sheet):
        entities[role].append((source, entity))
        if sum(map(len, entities.values())) > LARGEST:
            stop(sheet, f"more than {LARGEST:,} entities on these layers", "fewer", "leave only what is needed there")
    return entities


def _lines(
    entities: dict[str, list[tuple[Source, DXFEntity]]], sheet: Sheet
) -> tuple[dict[str, list[tuple[Source, Piece]]], list[tuple[Source, Point]]]:
    """Return the lines on the layers of curves, and the points that are columns; what is neither is reported."""
    lines: dict[str, list[tuple[Source, Piece]]] = defaultdict(list)
    points: list[tuple[Source, Point]] = []
    for role in (*CURVES, *WITH_VALUE):
        for source, entity in entities[role]:
            if role in WITH_VALUE and entity.dxftype() in WRITTEN:
                continue
            spot = spot_of(entity, sheet) if role == "columns" and entity.dxftype() == "POINT" else None
            if spot is not None:
                points.append((source, spot))
                continue
            piece = piece_of(entity, sheet)
            if isinstance(piece, Piece):
                sheet.spend(len(piece.bulges), MOST_EDGES, "edges of curves", "draw curves with fewer edges")
                lines[role].append((source, piece))
            else:
                sheet.tell(source, False, piece)
    return lines, points


def _texts(entities: list[tuple[Source, DXFEntity]], dimension: str, sheet: Sheet) -> list[Label]:
    """Return what is written on the layers of loads."""
    found = [label_of(source, entity, sheet, dimension) for source, entity in entities]
    return [label for label in found if label is not None]


def _tolerance(lines: dict[str, list[tuple[Source, Piece]]], points: list[tuple[Source, Point]]) -> float:
    """Return how near ends are one point [m], by the size of what is drawn."""
    every = [point for each in lines.values() for _, piece in each for point in piece.points]
    every += [point for _, point in points]
    return CLOSE * max((max(values) - min(values) for values in zip(*every, strict=True)), default=0.0) or CLOSE


def _check(found: dict[str, list[Found]], tolerance: float, sheet: Sheet) -> None:
    """Add a fault for each curve that crosses or touches itself."""
    for each in (each for curves in found.values() for each in curves):
        meeting = first_meeting(each.edges(), tolerance, sheet.near)
        if meeting is not None:
            hint = "mend the curve so that it neither crosses nor touches itself"
            sheet.issue(each.sources, meeting, "a curve that crosses or touches itself", "a simple closed curve", hint)
