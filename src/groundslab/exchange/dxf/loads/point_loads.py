"""Point loads and their values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.exchange.dxf.chaining import PointIndex
from groundslab.exchange.dxf.classify import SAME, footprint_of
from groundslab.exchange.dxf.curves import read_position
from groundslab.exchange.dxf.drawing import DOUBLE, FARTHEST, PointMark, ReadContext, Source
from groundslab.exchange.dxf.loads import labelling
from groundslab.geometry.plan import Place, Ring
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity, Insert


def read_point_loads(
    entities: list[tuple[Source, DXFEntity]],
    columns: Sequence[Ring | Place],
    tolerance: float,
    context: ReadContext,
) -> list[PointMark]:
    """Return the point loads with the values that stand beside them or in their attributes.

    A value that stands beside a column, and beside no load, is that of a load on the column.
    """
    from ezdxf.entities import Insert
    from shapely import points

    marks: list[labelling.PendingLoad] = []
    texts: list[labelling.Label] = []
    nodes = PointIndex(tolerance)
    for source, entity in entities:
        try:
            text = labelling.read_label(source, entity, context)
            spot = read_position(entity, context)
        except Exception as error:  # of any kind, as what is damaged may be anything
            context.issue([source], None, f"a damaged entity ({error})", "a point load or a text")
            continue
        if text is not None:
            texts.append(text)
        elif spot is None:
            context.report_entity(source, False, "a point load is a POINT, a CIRCLE or a block")
        else:
            radius = context.to_meters(abs(entity.dxf.radius)) if entity.dxftype() == "CIRCLE" else 0.0
            radius = radius if radius < FARTHEST else 0.0
            mark = labelling.PendingLoad(source, spot, None, radius)
            if isinstance(entity, Insert):
                _read_attributes(entity, mark)
            number = nodes.number(spot)
            if number == len(marks):
                marks.append(mark)
            else:
                _merge(marks[number], mark)
                context.report_entity(source, False, DOUBLE)
    for mark, shape in zip(marks, points(np.reshape([mark.point for mark in marks], (-1, 2))), strict=True):
        mark.shape = shape.buffer(mark.size) if mark.size else shape
    on_columns = list(_column_marks(columns, marks)) if texts else []
    labelling.assign_texts([*marks, *on_columns], texts, "point_loads", context)
    placed = [PointMark(*mark.point, mark.values[0], labelling.join_texts(mark)) for mark in on_columns if mark.values]
    return [*(_point_mark(mark, context) for mark in marks), *placed]


def _column_marks(
    columns: Sequence[Ring | Place], marks: Sequence[labelling.PendingLoad]
) -> Iterator[labelling.PendingLoad]:
    """Yield a mark in the middle of each column on which no load stands."""
    from shapely import Point, STRtree

    tree = STRtree([mark.shape for mark in marks])
    for number, column in enumerate(columns, 1):
        if isinstance(column, Ring):
            shape, footprint = column.polygon(SAME * max(column.sides)), footprint_of(column, "")
            middle = (shape.centroid.x, shape.centroid.y) if footprint is None else footprint.centre
        else:
            shape, middle = Point(column), column
        if not len(tree.query(shape, predicate="intersects")):
            yield labelling.PendingLoad(Source("", f"column {number}", ""), middle, shape, column=True)


def _read_attributes(insert: Insert, mark: labelling.PendingLoad) -> None:
    """Give a mark what the attributes of its block say."""
    for attribute in insert.attribs:
        words = attribute.plain_text().strip()[: labelling.LONGEST]
        value = labelling.find_quantity(words)
        if isinstance(value, float):
            mark.values.append(value)
        elif isinstance(value, str):
            mark.unclear.append(f"{attribute.dxf.tag} = {describe(words)}")
        if words:
            mark.texts.append(words)


def _merge(mark: labelling.PendingLoad, double: labelling.PendingLoad) -> None:
    """Add what a mark at the same place knows."""
    mark.size = max(mark.size, double.size)
    mark.values += [value for value in double.values if value not in mark.values]
    mark.texts += [text for text in double.texts if text not in mark.texts]
    mark.unclear += double.unclear


def _point_mark(mark: labelling.PendingLoad, context: ReadContext) -> PointMark:
    """Return a point load for the result."""
    value, how = labelling.choose_value(mark, "point_loads", context)
    context.report_entity(mark.source, True, f"point load{how}")
    return PointMark(*mark.point, value, labelling.join_texts(mark))
