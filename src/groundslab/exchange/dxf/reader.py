"""From a file to a Drawing: each step of the reading, one after the other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.errors import InputError, Issue
from groundslab.exchange.dxf.chaining import ClosedCurve, join_lines, join_outlines
from groundslab.exchange.dxf.classify import find_outline, read_column_points, remark_on_column, report_taken
from groundslab.exchange.dxf.curves import DrawnLine, is_filling, read_lines, read_position
from groundslab.exchange.dxf.document import (
    WITH_VALUE,
    Layers,
    Roles,
    assign_roles,
    check_layers,
    check_named_layers,
    name_roles,
    open_drawing,
    set_unit,
)
from groundslab.exchange.dxf.drawing import (
    CLOSE,
    GAP,
    MOST_EDGES,
    MOST_ENTITIES,
    Drawing,
    ReadContext,
    ReportLine,
    Source,
    abort,
)
from groundslab.exchange.dxf.entities import BlockCounts, iterate_entities
from groundslab.exchange.dxf.loads.distributed_loads import read_area_loads, read_lines_with_values
from groundslab.exchange.dxf.loads.labelling import DIMENSION, Label, read_label
from groundslab.exchange.dxf.loads.point_loads import read_point_loads
from groundslab.geometry.intersections import find_self_meeting
from groundslab.geometry.plan import Place, Ring
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity

#: Entities that say something.
WRITTEN = ("TEXT", "MTEXT", "ATTRIB", "ATTDEF")
#: The widest gap that can be asked to be closed [m].
WIDEST = 0.1
#: What is drawn as closed curves.
CURVES = ("outline", "openings", "zones", "columns")


def read(
    path: str | Path,
    layers: Layers | Mapping[str, str] | None = None,
    unit: str | None = None,
    gap: float = GAP,
    union: bool = False,
) -> Drawing:
    """Return the contents of a drawing's layers; raises InputError with all issues.

    ``layers`` names one for each thing, or says what each holds of all that are read. ``unit`` (such as "mm") is needed
    if the drawing does not say its own, and wins over it. Gaps between the ends of lines up to ``gap`` [m] are closed,
    if they are no wider than a tenth of the edges that end there; each is reported. With ``union`` outlines that adjoin
    each other are one.
    """
    context = ReadContext(str(path), gap=gap)
    document = open_drawing(context.path)
    set_unit(document, unit, context)
    roles, entities = _find_entities(document, layers, context)
    texts = {role: _texts(entities[role], DIMENSION[role], context) for role in WITH_VALUE}
    lines, points = _lines(entities, context)
    tolerance = _tolerance(lines, points)
    curves_of = {role: join_lines(lines[role], tolerance, context) for role in (*CURVES, "area_loads")}
    if union:
        curves_of["outline"] = join_outlines(curves_of["outline"], max(tolerance, gap), context)
    _check_crossings(curves_of, tolerance, context)
    outline, inner = find_outline(
        curves_of["outline"], entities["outline"], bool(curves_of["openings"]) and not union, tolerance, context
    )
    openings = [*inner, *curves_of["openings"]]
    for name, curves in (("opening", openings), ("zone", curves_of["zones"]), ("column", curves_of["columns"])):
        for number, closed in enumerate(curves, 1):
            report_taken(closed, f"{name} {number}", context)
            if name == "column" and (remark := remark_on_column(closed.curve)):
                context.report_entity(Source(closed.sources[0].layer, "LAYER", ""), True, f"column {number}: {remark}")
    drawn: list[Ring | Place] = [closed.curve for closed in curves_of["columns"]]
    columns = [*drawn, *read_column_points(points, len(drawn), tolerance, context)]
    marks = read_point_loads(entities["point_loads"], columns, tolerance, context)
    walls, beams, line_loads = (
        read_lines_with_values(role, lines[role], texts[role], roles, tolerance, context)
        for role in ("walls", "beams", "line_loads")
    )
    area_loads = read_area_loads(curves_of["area_loads"], texts["area_loads"], roles, context)
    if context.issues or outline is None:
        raise context.to_error()
    drawing = Drawing(
        outline=outline,
        openings=tuple(opening.curve for opening in openings),
        zones=tuple(closed.curve for closed in curves_of["zones"]),
        columns=tuple(columns),
        walls=tuple(walls),
        beams=tuple(beams),
        point_loads=tuple(marks),
        line_loads=tuple(line_loads),
        area_loads=tuple(area_loads),
        report=tuple(context.report),
        unit=context.unit,
        scale=float(context.scale),
    )
    return _with_remark(drawing)


def _with_remark(drawing: Drawing) -> Drawing:
    """Return a drawing with what contradicts its unit in its report."""
    size = drawing.remark_on_size
    return replace(drawing, report=(*drawing.report, ReportLine("", "HEADER", "", False, size))) if size else drawing


def _find_entities(
    document: Document, layers: Layers | Mapping[str, str] | None, context: ReadContext
) -> tuple[Roles, dict[str, list[tuple[Source, DXFEntity]]]]:
    """Return what layers hold, and the entities on them by role; faults of layers are the context's."""
    if isinstance(layers, Mapping):
        roles = name_roles(layers, context)
        entities = _entities(document, roles, context)
        check_named_layers(document, layers, entities, context)
    else:
        layers = layers or Layers()
        roles = assign_roles(layers, context)
        entities = _entities(document, roles, context)
        check_layers(document, layers, roles, entities, context)
    return roles, entities


def parse_gap(text: str) -> float:
    """Return the width of gaps to be closed [m] from a length with its unit; raises InputError."""
    try:
        gap = units.parse(text, "length")
    except units.QuantityError as error:
        raise InputError([Issue("width of gaps", describe(text), 'a length such as "1 mm"', error.reason)]) from None
    if not 0 <= gap <= WIDEST:
        expected = f"0 mm to {WIDEST * 1e3:g} mm"
        raise InputError([Issue("width of gaps", describe(text), expected, "what is wider is to be drawn")])
    return gap


def _entities(document: Document, roles: Roles, context: ReadContext) -> dict[str, list[tuple[Source, DXFEntity]]]:
    """Return the entities on the layers that are read, by role."""
    entities: dict[str, list[tuple[Source, DXFEntity]]] = defaultdict(list)
    blocks = BlockCounts(document, roles, context)
    for role, source, entity in iterate_entities(document.modelspace(), roles, blocks, context):
        entities[role].append((source, entity))
        if sum(map(len, entities.values())) > MOST_ENTITIES:
            excess = f"more than {MOST_ENTITIES:,} entities on these layers"
            abort(context, excess, "fewer", "leave only what is needed there")
    return entities


def _lines(
    entities: dict[str, list[tuple[Source, DXFEntity]]], context: ReadContext
) -> tuple[dict[str, list[tuple[Source, DrawnLine]]], list[tuple[Source, Place]]]:
    """Return the lines on the layers of curves, and the points that are columns; what is neither is reported."""
    lines: dict[str, list[tuple[Source, DrawnLine]]] = defaultdict(list)
    points: list[tuple[Source, Place]] = []
    for role in (*CURVES, *WITH_VALUE):
        for source, entity in entities[role]:
            if role in WITH_VALUE and entity.dxftype() in WRITTEN:
                continue
            spot = read_position(entity, context) if role == "columns" and entity.dxftype() == "POINT" else None
            if spot is not None:
                points.append((source, spot))
                continue
            pieces = _why_no_filling(role, entity, entities) or read_lines(entity, context)
            if isinstance(pieces, str):
                context.report_entity(source, False, pieces)
                continue
            for piece in pieces:
                context.count_work(len(piece.bulges), MOST_EDGES, "edges of curves", "draw curves with fewer edges")
                lines[role].append((source, piece))
    return lines, points


def _why_no_filling(role: str, entity: DXFEntity, entities: dict[str, list[tuple[Source, DXFEntity]]]) -> str | None:
    """Return why a filling is ignored, None if it is not, or if the entity is none."""
    if not is_filling(entity):
        return None
    if role == "line_loads":
        return "a filling is not a line"
    # what is filled in an outline drawn as lines need not be an opening
    if role == "outline" and not all(is_filling(other) for _, other in entities[role]):
        return "a filling is taken for the outline only where the layer has nothing else"
    return None


def _texts(entities: list[tuple[Source, DXFEntity]], dimension: str, context: ReadContext) -> list[Label]:
    """Return the texts on the layers of loads."""
    read_texts = [read_label(source, entity, context, dimension) for source, entity in entities]
    return [label for label in read_texts if label is not None]


def _tolerance(lines: dict[str, list[tuple[Source, DrawnLine]]], points: list[tuple[Source, Place]]) -> float:
    """Return how near ends are one point [m], by the size of what is drawn."""
    every = [point for line in lines.values() for _, piece in line for point in piece.points]
    every += [point for _, point in points]
    return CLOSE * max((max(values) - min(values) for values in zip(*every, strict=True)), default=0.0) or CLOSE


def _check_crossings(curves_of: dict[str, list[ClosedCurve]], tolerance: float, context: ReadContext) -> None:
    """Add an issue for each curve that crosses or touches itself."""
    for closed in (closed for curves in curves_of.values() for closed in curves):
        meeting = find_self_meeting(closed.curve.segments(), tolerance, context.count_pairs)
        if meeting is not None:
            hint = "change the curve so that it neither crosses nor touches itself"
            context.issue(
                closed.sources, meeting, "a curve that crosses or touches itself", "a simple closed curve", hint
            )
