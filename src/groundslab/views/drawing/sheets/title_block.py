"""Frame, title block and the list of bars of a sheet, in the column at its right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from groundslab.languages import Translator
from groundslab.messages import Message, Name
from groundslab.model.model import Model
from groundslab.units import format_number
from groundslab.views.drawing.shapes import Line, Shape, Text
from groundslab.views.drawing.sheets.paper import (
    COLUMN,
    EDGE,
    FILED,
    LARGE,
    LETTERS,
    SIZES,
    SMALL,
    Paper,
    Sheet,
    scale_words,
)
from groundslab.views.drawing.sheets.placing import width_of
from groundslab.views.tables.table import Table

FRAME, TITLE, TABLE = "FRAME", "TITLE", "TABLE"
#: Height of a row of the title block, of one of the list, and inside of their borders [mm].
ROW, LINE, INSIDE = 9.0, 4.2, 2.0
#: Between columns of the list, over the height of letters.
APART = 2.0
#: Columns of the list.
COLUMNS = ("mark", "diameter", "number", "length", "total length", "mass")


def draw_frame(model: Model, sheet: Sheet, number: int, count: int, say: Translator) -> None:
    """Add the frame and the title block to a sheet, which is one of several."""
    width, height = SIZES[sheet.paper]
    sheet.shapes.append(_box(FILED, EDGE, width - EDGE, height - EDGE))
    left = width - EDGE - COLUMN[sheet.paper]
    rows = list(_rows(model, sheet, number, count, say))
    top = EDGE + ROW * len(rows)
    sheet.shapes.append(_box(left, EDGE, width - EDGE, top))
    for line, cells in enumerate(rows):
        y = top - ROW * (line + 1)
        if line:
            sheet.shapes.append(Line(FRAME, np.array([(left, y + ROW), (width - EDGE, y + ROW)])))
        sheet.shapes.extend(_cells(cells, left, y, COLUMN[sheet.paper]))


def title_height(model: Model) -> float:
    """Return how high the title block is [mm]."""
    project = model.project
    people = bool(project and (project.author or project.checker or project.client))
    return ROW * (4 + people)


def _rows(model: Model, sheet: Sheet, number: int, count: int, say: Translator) -> Iterator[list[tuple[str, str]]]:
    """Yield the rows of the title block, each cell its head and what stands there."""
    project = model.project

    def given(key: str) -> str:
        return "" if project is None else str(getattr(project, key))

    yield [(say("Project"), given("name") or model.title), (say("Project number"), given("number"))]
    yield [
        (say("Part"), given("part") or (model.title if given("name") else "")),
        (say("Sheet"), f"{number} / {count}"),
    ]
    yield [(say("Layer"), say(sheet.title)), (say("Scale"), scale_words(sheet.scale, model.units))]
    if any(map(given, ("client", "author", "checker"))):
        yield [(say(key.capitalize()), given(key)) for key in ("client", "author", "checker")]
    yield [(say("Revision"), given("revision")), (say("Date"), given("date")), ("", sheet.paper.upper())]


def _cells(cells: Sequence[tuple[str, str]], left: float, y: float, width: float) -> Iterator[Shape]:
    """Yield the cells of a row: the first of two is the wider one."""
    shares = (0.7, 0.3) if len(cells) == 2 else (0.35, 0.35, 0.3)
    x = left
    for n, ((head, words), share) in enumerate(zip(cells, shares, strict=True)):
        if n:
            yield Line(FRAME, np.array([(x, y), (x, y + ROW)]))
        space = share * width - 2 * INSIDE
        if head:
            yield Text(TITLE, (x + INSIDE, y + ROW - 1.2 - SMALL), _fitting(head, SMALL, space), Name(head))
        if words:
            yield Text(TITLE, (x + INSIDE, y + 1.6), _fitting(words, 1.3 * LETTERS, space), Name(words))
        x += share * width


def draw_list(model: Model, sheet: Sheet, table: Table, marks: Sequence[str], say: Translator) -> None:
    """Add the list of the bars on a sheet above its title block, as far as there is space."""
    rows = [row for row in table.rows() if row[0] is not None and str(row[0]).partition("-")[0] in marks]
    width, height = SIZES[sheet.paper]
    left, space = width - EDGE - COLUMN[sheet.paper] + INSIDE, COLUMN[sheet.paper] - 2 * INSIDE
    top, bottom = height - EDGE - INSIDE, EDGE + title_height(model) + 2 * INSIDE
    most = int((top - bottom - 2.2 * LARGE) / LINE) - 2
    sheet.shapes.append(_box(left - INSIDE, EDGE, width - EDGE, height - EDGE))
    sheet.shapes.append(Text(TITLE, (left, top - LARGE), _fitting(say(sheet.title), LARGE, space), say(sheet.title)))
    if not rows:
        return
    columns = [next(column for column in table.columns if column.name == name) for name in COLUMNS]
    heads = [f"{say(column.name)} [{column.unit}]" if column.unit else say(column.name) for column in columns]
    at = [table.columns.index(column) for column in columns]
    listed = [[say(_cell(row[i], table.columns[i].unit)) for i in at] for row in rows[:most]]
    y, h = top - 2.2 * LARGE, LETTERS
    for shape in _aligned([heads, *listed], left, y, space):
        sheet.shapes.append(shape)
        h = shape.height
    if len(rows) > most:
        more = say(Message("{count} more: the bending schedule", count=len(rows) - most))
        sheet.shapes.append(Text(TABLE, (left, y - LINE * (most + 1)), h, more))


def _aligned(rows: Sequence[Sequence[str]], left: float, top: float, space: float) -> Iterator[Text]:
    """Yield the cells of rows, each at the right of its column, with smaller letters where space is little."""
    widths = [max(width_of(row[i], 1.0) for row in rows) + APART for i in range(len(rows[0]))]
    h = min(LETTERS, space / sum(widths))
    for line, row in enumerate(rows):
        x = left - APART * h
        for words, wide in zip(row, widths, strict=True):
            x += wide * h
            yield Text(TABLE, (x - width_of(words, h), top - LINE * line), h, Name(words))


def _cell(value: str | float | int | None, unit: str) -> str:
    """Return a cell of the list as it is written."""
    if not isinstance(value, float):
        return "" if value is None else str(value)
    if unit in ("mm", "in"):
        return format_number(value, 4, trim=True)
    return f"{value:.3f}" if unit in ("m", "ft") else f"{value:.1f}"


def _fitting(words: str, height: float, space: float) -> float:
    """Return the height of letters, less where words have too little space [mm]."""
    return min(height, space / max(width_of(words, 1.0), 1e-9))


def _box(x0: float, y0: float, x1: float, y1: float) -> Line:
    """Return a rectangle of the frame."""
    return Line(FRAME, np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), closed=True)


def paper_box(paper: Paper) -> Line:
    """Return the edge of the paper."""
    return _box(0.0, 0.0, *SIZES[paper])
