"""Labels of bars: their marks in a circle, and lines of text above and below the bar at which they stand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from groundslab.views.drawing.shapes import Circle, Line, Shape, Text
from groundslab.views.drawing.sheets.paper import LETTERS, Box
from groundslab.views.drawing.sheets.placing import width_of

#: Radius of the circle, from it to the text, and from the bar to the text [mm].
RADIUS, GAP, OFF = 3.0, 1.2, 1.0
#: What is kept free around a label [mm].
MARGIN = 0.5


Label = tuple[list[Shape], Box]


def label(layer: str, marks: str, above: Sequence[str], below: Sequence[str], *, before: bool = False) -> Label:
    """Return a label of marks in a circle at the origin, with text above and below a bar along x, and its box.

    The circle is longer where it holds several marks; the text stands behind it, or before it.
    """
    height = LETTERS if len(marks) < 4 else 0.85 * LETTERS
    longer = max(0.0, width_of(marks, height) - 1.5 * RADIUS)
    shapes: list[Shape] = [_circle(layer, longer), Text(layer, (0.0, 0.0), height, marks, centered=True)]
    half, line = RADIUS + longer / 2, 1.45 * LETTERS
    widest = max((width_of(words, LETTERS) for words in (*above, *below)), default=0.0)
    rows = [(OFF + line * n, words) for n, words in enumerate(reversed(above))]
    rows += [(-OFF - LETTERS - line * n, words) for n, words in enumerate(below)]
    for y, words in rows:
        x = -half - GAP - width_of(words, LETTERS) if before else half + GAP
        shapes.append(Text(layer, (x, y), LETTERS, words))
    high = max(RADIUS, OFF + line * len(above) if above else 0.0)
    low = max(RADIUS, OFF + line * len(below) if below else 0.0)
    left, right = (-half - GAP - widest, half) if before else (-half, half + GAP + widest)
    return shapes, (left - MARGIN, -low - MARGIN, right + MARGIN, high + MARGIN)


def labels_of(layer: str, marks: str, above: Sequence[str], below: Sequence[str]) -> tuple[Label, Label]:
    """Return a label with its text behind the circle, and with its text before it."""
    return label(layer, marks, above, below), label(layer, marks, above, below, before=True)


def _circle(layer: str, longer: float) -> Shape:
    """Return a circle about the origin, or one that is longer along x [mm]."""
    if longer == 0.0:
        return Circle(layer, (0.0, 0.0), RADIUS)
    turns = np.linspace(-np.pi / 2, np.pi / 2, 13)
    right = RADIUS * np.stack([np.cos(turns), np.sin(turns)], axis=1) + [longer / 2, 0.0]
    return Line(layer, np.vstack([right, -right]), closed=True)


def interrupted(line: Line, axis: int, low: float, high: float) -> list[Line]:
    """Return what of a line along an axis is not between two places [mm]."""
    start, end = line.points
    parts = []
    for first, last in ((start[axis], min(end[axis], low)), (max(start[axis], high), end[axis])):
        if last > first:
            points = line.points.copy()
            points[:, axis] = first, last
            parts.append(Line(line.layer, points))
    return parts
