"""Loads while their values are sought, and which text belongs to which."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.case.dxf.labels import DIMENSION, Label
from groundslab.case.dxf.nearest import NEAR, nearest
from groundslab.case.dxf.sheet import Sheet, Source
from groundslab.case.dxf.words import named
from groundslab.geometry.bulges import Point

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


@dataclass(slots=True)
class Mark:
    """A load while its value is sought."""

    source: Source
    point: Point
    shape: BaseGeometry | None  # what texts stand beside
    size: float = 0.0  # of loads in which a text stands, it is that of the smallest
    values: list[float] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    unclear: list[str] = field(default_factory=list)


def give_texts(marks: Sequence[Mark], texts: Sequence[Label], role: str, sheet: Sheet) -> None:
    """Give each text to the nearest mark; the nearest pairs first, and one value to a mark."""
    what = role.replace("_", " ").removesuffix("s")
    pairs = ((gap, marks[m].size, t, m) for gap, t, m in nearest(texts, [mark.shape for mark in marks], sheet))
    given: set[int] = set()
    near: set[int] = set()
    for _, _, t, m in sorted(pairs):
        text, mark = texts[t], marks[m]
        near.add(t)
        if t in given or (isinstance(text.value, float) and mark.values):
            continue
        given.add(t)
        mark.texts.append(text.words)
        if isinstance(text.value, float):
            mark.values.append(text.value)
        where = f"{mark.source.entity} {mark.source.handle}".strip()
        sheet.tell(text.source, True, f"{named(text.words)}, beside {where}")
    expected = units.expectation(DIMENSION[role])
    for t, text in enumerate(texts):
        if isinstance(text.value, str):
            sheet.issue([text.source], text.start, named(text.words), expected, text.value)
        elif t in given:
            continue
        elif text.value is None:
            sheet.tell(text.source, False, f"{named(text.words)}, which stands beside no {what}")
        elif t in near:
            hint = "write the sum, or move the text nearer to its own load"
            sheet.issue([text.source], text.start, f"{named(text.words)}, a second value", "one value a load", hint)
        else:
            hint = f"draw the load, at most {NEAR} heights of the text away, or move the text to another layer"
            sheet.issue([text.source], text.start, named(text.words), f"a {what} beside the value", hint)


def value_of(mark: Mark, role: str, sheet: Sheet) -> float | None:
    """Return the value of a load, None if it has none; several, or one that cannot be read, are faults."""
    dimension = DIMENSION[role]
    if len(mark.values) > 1:
        shown = " and ".join(units.show(value, dimension) for value in mark.values)
        sheet.issue([mark.source], mark.point, shown, "one value a load", "write the sum")
    if mark.unclear and not mark.values:
        sheet.issue([mark.source], mark.point, ", ".join(mark.unclear), units.expectation(dimension), "add the unit")
    return mark.values[0] if mark.values else None


def words_of(mark: Mark) -> str:
    """Return what is written beside a load."""
    return " ".join(" ".join(mark.texts).split())
