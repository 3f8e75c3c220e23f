"""Bars of one layer on a sheet: of each set one bar, the line over which all of them lie, their label."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.bar_layout import BarSet
from groundslab.design.bars.positions import CutBar, Position, cut_bars
from groundslab.languages import Translator
from groundslab.messages import Message, Name
from groundslab.model.model import Model
from groundslab.unit_systems import System, bars_at
from groundslab.views.drawing.bars import BROKEN, line_across, shown_bar
from groundslab.views.drawing.shapes import Circle, Line, Shape, moved, rings, scaled
from groundslab.views.drawing.sheets.dimensions import long_words, written
from groundslab.views.drawing.sheets.marks import MARGIN, Label, interrupted, labels_of
from groundslab.views.drawing.sheets.paper import Box, Sheet
from groundslab.views.drawing.sheets.placing import Candidate, Taken, thin_box, turned

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Which bar of a set may be drawn, and where along it the label and the line across may be: parts of the whole. Beside
#: its ends the label may be so far off [mm], with a line to it where that is far.
BARS = (0.36, 0.5, 0.64, 0.25, 0.75, 0.15, 0.85, 0.08, 0.92)
ALONG = (0.12, 0.18, 0.24, 0.3, 0.36, 0.42, 0.5, 0.58, 0.66, 0.74, 0.82, 0.9, 0.06, 0.0)
ACROSS = (0.75, 0.9, 0.05, 0.2, 0.5)
BESIDE, NEAR = (2.0, 8.0, 16.0, 26.0, 38.0), 4.0
#: Half of the tick at the ends of the line across, of the dot where it meets the bar, and of the offset of pieces that
#: lap [mm].
TICK, DOT, APART = 1.3, 0.6, 0.45


def draw_bars(
    model: Model, sheet: Sheet, taken: Taken, sets: Sequence[BarSet], listed: Sequence[Position], say: Translator
) -> None:
    """Add the bars of a layer to a sheet: those of zones first, whose labels have the least space."""
    for bar_set in sorted(sets, key=lambda laid_set: laid_set.region.area):
        of_set = [bar for bar in listed if (bar.layer, bar.zone) == (bar_set.layer, bar_set.zone)]
        if not of_set:
            continue
        if bar_set.zone:
            sheet.shapes.extend([scaled(shape, sheet.per_meter, sheet.origin) for shape in _zone(bar_set.region)])
        above, below = _words(bar_set, of_set, model.units, say)
        first, last = of_set[0].mark, of_set[-1].mark
        marks = f"{first}" if first == last else f"{first}\N{EN DASH}{last}"
        labels = labels_of(f"BARS_{bar_set.layer.upper()}", marks, list(map(say, above)), list(map(say, below)))
        sheet.shapes.extend(taken.place(list(_candidates(model, sheet, bar_set, labels))))


def _zone(region: BaseGeometry) -> Iterator[Line]:
    """Yield the border of a zone."""
    for piece in getattr(region, "geoms", [region]):
        if piece.geom_type == "Polygon":
            yield from (Line(BROKEN, np.asarray(ring.coords)[:-1], closed=True) for ring in rings(piece))


def _words(bar_set: BarSet, of_set: Sequence[Position], units: System, say: Translator) -> tuple[list[str], list[str]]:
    """Return what the label of a set says above the bar and below it."""
    count = sum(len(bar.lengths) for bar in of_set)
    mesh = f"{bar_set.mesh}: " if bar_set.mesh else ""
    below = [long_words(np.concatenate([bar.lengths for bar in of_set]), units)]
    if of_set[0].lap is not None:
        below.append(Message("lap {lap:.2f m}", lap=of_set[0].lap).in_units(units))
    if bar_set.zone:
        x0, y0, x1, y1 = bar_set.region.bounds
        sides = " \N{MULTIPLICATION SIGN} ".join(say(written(side, units)) for side in (x1 - x0, y1 - y0))
        below.append(Name(sides))
    return [Name(f"{mesh}{count} {bars_at(bar_set.bars.diameter, bar_set.bars.spacing, units)}")], below


def _candidates(model: Model, sheet: Sheet, bar_set: BarSet, labels: tuple[Label, Label]) -> Iterator[Candidate]:
    """Yield where a set may be drawn: each bar that may stand for it, with its label and the line across anywhere."""
    assert model.reinforcement is not None
    axis, layer = bar_set.axis, f"BARS_{bar_set.layer.upper()}"
    bars_cut = cut_bars(model, model.reinforcement, bar_set)
    laid = replace(bar_set, ends=np.array([bar.ends for bar in bars_cut]))
    for n, part in enumerate(BARS):
        cut_bar = bars_cut[shown_bar(laid, part)]
        bar = cut_bar.ends
        ends = bar * sheet.per_meter + sheet.origin
        pieces = _pieces(layer, cut_bar, axis, sheet)
        across = [line_across(laid, bar[0] + share * (bar[1] - bar[0])) for share in ACROSS]
        lines = [line * sheet.per_meter + sheet.origin for line in across]
        for k, (shown, start) in enumerate(_starts(float(ends[0, axis]), float(ends[1, axis]), labels)):
            put, box = put_label(shown, axis, start, float(ends[0, 1 - axis]))
            half = min(start - box[axis], box[axis + 2] - start) - MARGIN  # of the circle, which interrupts the bar
            leader = _leader(ends, axis, box[axis], box[axis + 2])
            bars = (
                *leader,
                *(part for piece in pieces for part in interrupted(piece, axis, start - half, start + half)),
            )
            thin = (thin_box(ends), *(thin_box(stroke.points) for stroke in leader))
            free = [line for line in lines if not box[axis] - 1.0 < line[0, axis] < box[axis + 2] + 1.0]
            for m, line in enumerate(free):
                shapes = (*bars, *_extent(layer, line, ends, axis), *put)
                yield Candidate(shapes, box, (*thin, thin_box(line)), 0.3 * n + 0.2 * k + 0.02 * m)


def put_label(shown: Label, axis: int, along: float, across: float) -> tuple[list[Shape], Box]:
    """Return a label at a place of a bar along an axis, turned if that runs upwards, and its box."""
    shapes, (left, low, right, high) = shown
    if axis == 0:
        return [moved(shape, (along, across)) for shape in shapes], (
            left + along, low + across, right + along, high + across,
        )  # fmt: skip
    return [moved(turned(shape), (across, along)) for shape in shapes], (
        across - high, along + left, across - low, along + right,
    )  # fmt: skip


def _starts(start: float, end: float, labels: tuple[Label, Label]) -> Iterator[tuple[Label, float]]:
    """Yield labels with the place of their origin: on a bar that is longer, behind its end, or before its start."""
    behind, before = labels
    _, (left, _, right, _) = behind
    spare = end - start - (right - left)
    if spare > 0:
        yield from ((behind, start - left + along * spare) for along in ALONG)
    for off in BESIDE:
        yield behind, end + off - left
        yield before, start - off - before[1][2]


def _leader(ends: Array, axis: int, low: float, high: float) -> tuple[Line, ...]:
    """Return a line from the end of a bar to a label from low to high along it that is not near [mm]."""
    for first, last in ((float(ends[1, axis]), low), (high, float(ends[0, axis]))):
        if last - first > NEAR:
            points = ends.copy()
            points[:, axis] = first, last
            return (Line("LABELS", points),)
    return ()


def _pieces(layer: str, bar: CutBar, axis: int, sheet: Sheet) -> tuple[Line, ...]:
    """Return the pieces of a bar on paper, those that lap beside each other."""
    pieces = bar.pieces(axis) * sheet.per_meter + sheet.origin
    if bar.parts > 1:
        pieces[::2, :, 1 - axis] -= APART
        pieces[1::2, :, 1 - axis] += APART
    return tuple(Line(layer, piece) for piece in pieces)


def _extent(layer: str, line: Array, bar: Array, axis: int) -> Iterator[Shape]:
    """Yield the line over which bars lie, with a tick at each end, and a dot where it meets the bar that is drawn."""
    yield Line(layer, line)
    for end in line:
        yield Line(layer, np.array([end - TICK, end + TICK]))
    meeting = line[0].copy()
    meeting[1 - axis] = bar[0, 1 - axis]
    yield Circle(layer, (float(meeting[0]), float(meeting[1])), DOT)
