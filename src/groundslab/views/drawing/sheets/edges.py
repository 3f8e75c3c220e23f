"""U-shaped bars at edges on a sheet: at each edge a leg, the line along which they stand, and their label."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.positions import Position, inside_of
from groundslab.languages import Translator
from groundslab.messages import Message, Name
from groundslab.model.model import Model
from groundslab.unit_systems import bars_at
from groundslab.views.drawing.shapes import Circle, Line, Shape
from groundslab.views.drawing.sheets.bars import DOT, TICK, put_label
from groundslab.views.drawing.sheets.dimensions import long_words
from groundslab.views.drawing.sheets.marks import Label, labels_of
from groundslab.views.drawing.sheets.paper import Sheet
from groundslab.views.drawing.sheets.placing import Candidate, Taken, thin_box

LAYER = "BARS_EDGES"
#: Which of the bars at an edge may be drawn: parts of all of them.
BARS = (0.5, 0.35, 0.65, 0.2, 0.8, 0.08, 0.92)
#: From a leg to its label [mm].
BESIDE = (1.5, 6.0, 12.0)
#: Bars are at one edge if they are so near to each other along themselves, and no farther apart than so many spacings
#: [m].
ALIKE, FARTHEST = 0.01, 1.5


def draw_edges(model: Model, sheet: Sheet, taken: Taken, listed: Sequence[Position], say: Translator) -> None:
    """Add the U-shaped bars of all edges along one direction to a sheet."""
    inside = inside_of(model)
    for position in listed:
        assert position.lap is not None
        axis = "xy".index(position.layer[-1])
        for places in _at_edges(position, axis):
            sign = 1.0 if inside(places[len(places) // 2], axis, 1e-3) else -1.0
            bars = bars_at(position.bars.diameter, position.bars.spacing, model.units)
            legs = Message("legs {lap:.2f m}", lap=position.lap).in_units(model.units)
            below = [say(long_words(position.lengths, model.units)), say(legs)]
            above = [Name(f"{len(places)} U {bars}")]
            labels = labels_of(LAYER, f"{position.mark}", above, below)
            sheet.shapes.extend(taken.place(list(_candidates(sheet, places, axis, sign * position.lap, labels))))


def _at_edges(position: Position, axis: int) -> Iterator[Array]:
    """Yield the places (k, 2) [m] of the bars at each edge, from the first to the last one."""
    assert position.places is not None
    at = position.places[np.lexsort((position.places[:, 1 - axis], np.round(position.places[:, axis] / ALIKE)))]
    steps = np.abs(np.diff(at, axis=0))
    parts = (steps[:, axis] > ALIKE) | (steps[:, 1 - axis] > FARTHEST * position.bars.spacing)
    yield from np.split(at, np.flatnonzero(parts) + 1)


def _candidates(sheet: Sheet, places: Array, axis: int, leg: float, labels: tuple[Label, Label]) -> Iterator[Candidate]:
    """Yield where the bars at an edge may be drawn: which leg, with its label inward or outward of its end."""
    behind, before = labels
    for n, part in enumerate(BARS):
        start = places[round(part * (len(places) - 1))] * sheet.per_meter + sheet.origin
        end = start.copy()
        end[axis] += leg * sheet.per_meter
        line = np.stack([places[0], places[-1]]) * sheet.per_meter + sheet.origin
        line[:, axis] = (start[axis] + end[axis]) / 2
        dot = start.copy()
        dot[axis] = line[0, axis]
        lines: list[Shape] = [Line(LAYER, np.array([start, end])), Line(LAYER, line)]
        lines += [Line(LAYER, np.array([tip - TICK, tip + TICK])) for tip in line]
        lines.append(Circle(LAYER, (float(dot[0]), float(dot[1])), DOT))
        low, high = sorted((float(start[axis]), float(end[axis])))
        thin = (thin_box(np.array([start, end])), thin_box(line))
        for k, off in enumerate(BESIDE):
            for shown, at in ((behind, high + off - behind[1][0]), (before, low - off - before[1][2])):
                put, box = put_label(shown, axis, at, float(start[1 - axis]))
                outward = (shown is before) == (leg > 0)
                yield Candidate((*lines, *put), box, thin, 0.3 * n + 0.2 * k + 0.1 * outward)
