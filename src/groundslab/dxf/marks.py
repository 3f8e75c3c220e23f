"""Point loads, and which label belongs to which."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.dxf.curves import Point, from_line
from groundslab.dxf.drawing import PointMark
from groundslab.dxf.labels import Label, label_of, value_in
from groundslab.dxf.nodes import Nodes
from groundslab.dxf.pieces import spot_of
from groundslab.dxf.sheet import DOUBLE, Sheet, Source
from groundslab.dxf.words import named

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity, Insert

NEAR = 10  # heights of a text between it and the load that it belongs to


@dataclass(slots=True)
class _Mark:
    """A point load while its value is sought."""

    source: Source
    point: Point
    radius: float
    values: list[float] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    unclear: list[str] = field(default_factory=list)


def marks_of(entities: list[tuple[Source, DXFEntity]], tolerance: float, sheet: Sheet) -> list[PointMark]:
    """Return the point loads with the values that stand beside them or in their attributes."""
    from ezdxf.entities import Insert

    marks: list[_Mark] = []
    texts: list[Label] = []
    nodes = Nodes(tolerance)
    for source, entity in entities:
        try:
            text = label_of(source, entity, sheet)
            spot = spot_of(entity, sheet)
        except Exception as error:  # of any kind, as what is damaged may be anything
            sheet.fault([source], None, f"a damaged entity ({error})", "a point load or a text")
            continue
        if text is not None:
            texts.append(text)
        elif spot is None:
            sheet.tell(source, False, "a point load is a POINT, a CIRCLE or a block")
        else:
            radius = sheet.metres(abs(entity.dxf.radius)) if entity.dxftype() == "CIRCLE" else 0.0
            mark = _Mark(source, spot, radius)
            if isinstance(entity, Insert):
                _read_attributes(entity, mark)
            number = nodes.number(spot)
            if number == len(marks):
                marks.append(mark)
            else:
                _merge(marks[number], mark)
                sheet.tell(source, False, DOUBLE)
    _give_texts(marks, texts, sheet)
    return [_mark(mark, sheet) for mark in marks]


def _read_attributes(insert: Insert, mark: _Mark) -> None:
    """Give a mark what the attributes of its block say."""
    for attribute in insert.attribs:
        words = attribute.plain_text().strip()
        value = value_in(words)
        if isinstance(value, float):
            mark.values.append(value)
        elif isinstance(value, str):
            mark.unclear.append(f"{attribute.dxf.tag} = {named(words)}")
        if words:
            mark.texts.append(words)


def _merge(mark: _Mark, double: _Mark) -> None:
    """Add what a mark at the same place knows."""
    mark.radius = max(mark.radius, double.radius)
    mark.values += [value for value in double.values if value not in mark.values]
    mark.texts += [text for text in double.texts if text not in mark.texts]
    mark.unclear += double.unclear


def _give_texts(marks: list[_Mark], texts: list[Label], sheet: Sheet) -> None:
    """Give each text to the nearest mark; the nearest pairs first, and one value to a mark."""
    pairs = []
    for t, text in enumerate(texts):
        for m, mark in enumerate(marks):
            gap = from_line(mark.point, text.start, text.end) - mark.radius
            if gap <= NEAR * text.height:
                pairs.append((gap, t, m))
    given: set[int] = set()
    near: dict[int, _Mark] = {}
    for _, t, m in sorted(pairs):
        text, mark = texts[t], marks[m]
        near.setdefault(t, mark)
        if t in given or (isinstance(text.value, float) and mark.values):
            continue
        given.add(t)
        mark.texts.append(text.words)
        if isinstance(text.value, float):
            mark.values.append(text.value)
        where = f"{mark.source.entity} {mark.source.handle}".strip()
        sheet.tell(text.source, True, f"{named(text.words)}, beside {where}")
    expected = units.expectation("force")
    for t, text in enumerate(texts):
        if isinstance(text.value, str):
            sheet.fault([text.source], text.start, named(text.words), expected, text.value)
        elif t in given:
            continue
        elif text.value is None:
            sheet.tell(text.source, False, f"{named(text.words)}, which stands beside no point load")
        elif t in near:
            mend = "write the sum, or move the text nearer to its own load"
            sheet.fault([text.source], text.start, f"{named(text.words)}, a second value", "one value a load", mend)
        else:
            mend = f"draw the load, at most {NEAR} heights of the text away, or move the text to another layer"
            sheet.fault([text.source], text.start, named(text.words), "a point load beside the value", mend)


def _mark(mark: _Mark, sheet: Sheet) -> PointMark:
    """Return a point load for the result."""
    if len(mark.values) > 1:
        shown = " and ".join(units.show(value, "force") for value in mark.values)
        sheet.fault([mark.source], mark.point, shown, "one value a load", "write the sum")
    if mark.unclear and not mark.values:
        sheet.fault([mark.source], mark.point, ", ".join(mark.unclear), units.expectation("force"), "add the unit")
    value = mark.values[0] if mark.values else None
    why = "point load, no value" if value is None else f"point load of {units.show(value, 'force')}"
    sheet.tell(mark.source, True, why)
    return PointMark(*mark.point, value, " ".join(" ".join(mark.texts).split()))
