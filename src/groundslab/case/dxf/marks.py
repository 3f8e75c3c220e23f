"""Point loads and their values."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab import units
from groundslab.case.dxf.beside import Mark, give_texts, value_of, words_of
from groundslab.case.dxf.drawing import PointMark
from groundslab.case.dxf.labels import LONGEST, Label, label_of, value_in
from groundslab.case.dxf.nodes import Nodes
from groundslab.case.dxf.pieces import spot_of
from groundslab.case.dxf.sheet import DOUBLE, FARTHEST, Sheet, Source
from groundslab.case.dxf.words import named

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity, Insert


def marks_of(entities: list[tuple[Source, DXFEntity]], tolerance: float, sheet: Sheet) -> list[PointMark]:
    """Return the point loads with the values that stand beside them or in their attributes."""
    from ezdxf.entities import Insert
    from shapely import points

    marks: list[Mark] = []
    texts: list[Label] = []
    nodes = Nodes(tolerance)
    for source, entity in entities:
        try:
            text = label_of(source, entity, sheet)
            spot = spot_of(entity, sheet)
        except Exception as error:  # of any kind, as what is damaged may be anything
            sheet.issue([source], None, f"a damaged entity ({error})", "a point load or a text")
            continue
        if text is not None:
            texts.append(text)
        elif spot is None:
            sheet.tell(source, False, "a point load is a POINT, a CIRCLE or a block")
        else:
            radius = sheet.metres(abs(entity.dxf.radius)) if entity.dxftype() == "CIRCLE" else 0.0
            radius = radius if radius < FARTHEST else 0.0
            mark = Mark(source, spot, None, radius)
            if isinstance(entity, Insert):
                _read_attributes(entity, mark)
            number = nodes.number(spot)
            if number == len(marks):
                marks.append(mark)
            else:
                _merge(marks[number], mark)
                sheet.tell(source, False, DOUBLE)
    for mark, shape in zip(marks, points(np.reshape([mark.point for mark in marks], (-1, 2))), strict=True):
        mark.shape = shape.buffer(mark.size) if mark.size else shape
    give_texts(marks, texts, "point_loads", sheet)
    return [_point_mark(mark, sheet) for mark in marks]


def _read_attributes(insert: Insert, mark: Mark) -> None:
    """Give a mark what the attributes of its block say."""
    for attribute in insert.attribs:
        words = attribute.plain_text().strip()[:LONGEST]
        value = value_in(words)
        if isinstance(value, float):
            mark.values.append(value)
        elif isinstance(value, str):
            mark.unclear.append(f"{attribute.dxf.tag} = {named(words)}")
        if words:
            mark.texts.append(words)


def _merge(mark: Mark, double: Mark) -> None:
    """Add what a mark at the same place knows."""
    mark.size = max(mark.size, double.size)
    mark.values += [value for value in double.values if value not in mark.values]
    mark.texts += [text for text in double.texts if text not in mark.texts]
    mark.unclear += double.unclear


def _point_mark(mark: Mark, sheet: Sheet) -> PointMark:
    """Return a point load for the result."""
    value = value_of(mark, "point_loads", sheet)
    why = "point load, no value" if value is None else f"point load of {units.show(value, 'force')}"
    sheet.tell(mark.source, True, why)
    return PointMark(*mark.point, value, words_of(mark))
