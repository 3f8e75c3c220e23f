"""Where labels go: of several candidates the one that covers the least of what is there already."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.messages import Name
from groundslab.schema.wording import printable
from groundslab.views.drawing.shapes import Line, Shape, Text
from groundslab.views.drawing.sheets.paper import Box

if TYPE_CHECKING:
    from matplotlib.ft2font import FT2Font
    from shapely.geometry.base import BaseGeometry

#: What it costs that a label covers another one [1/mm2], that a line of bars crosses a label, and that a label covers
#: such a line, and one of the plan [1/mm], and that it stands outside of where it may [1/mm2].
OVER_LABEL, THROUGH_LABEL, OVER_BARS, OVER_PLAN, OUTSIDE = 100.0, 50.0, 20.0, 2.0, 100.0
#: Size in which texts are measured [pt], the height of capitals over it, and what is kept free around a text [mm].
SIZE, CAPITALS, AROUND = 100.0, 0.729, 0.5
#: What stands for letters that the font lacks, and how many letters of a name are shown at most.
WIDEST, LONGEST = "W", 24
#: What it costs that a label covers a column [1/mm2].
OVER_COLUMN = 20.0


@dataclass(frozen=True, slots=True)
class Candidate:
    """A label with the lines that come with it, and where both are: boxes and thin boxes [mm]."""

    shapes: tuple[Shape, ...]
    label: Box
    lines: tuple[Box, ...] = ()
    cost: float = 0.0  # how little it is liked, whatever is there


@dataclass(slots=True)
class Taken:
    """What stands on a sheet already."""

    area: Box
    plan: BaseGeometry
    labels: list[Box] = field(default_factory=list)
    lines: list[Box] = field(default_factory=list)
    columns: list[Box] = field(default_factory=list)

    def place(self, candidates: Sequence[Candidate]) -> tuple[Shape, ...]:
        """Return the shapes of the candidate that costs least, which takes its place; of equal ones the first."""
        fixed = {label: self._cost_of(label) for label in dict.fromkeys(candidate.label for candidate in candidates)}
        best = min(candidates, key=lambda candidate: candidate.cost + fixed[candidate.label] + self._crossed(candidate))
        self.labels.append(best.label)
        self.lines += best.lines
        return best.shapes

    def _cost_of(self, label: Box) -> float:
        """Return what it costs that a label is somewhere."""
        from shapely import box

        x0, y0, x1, y1 = label
        cost = OUTSIDE * ((x1 - x0) * (y1 - y0) - _covered([self.area], label))
        cost += OVER_COLUMN * _covered(self.columns, label) + OVER_LABEL * _covered(self.labels, label)
        cost += OVER_BARS * _met(self.lines, label)
        return cost + OVER_PLAN * float(self.plan.intersection(box(*label)).length)

    def _crossed(self, candidate: Candidate) -> float:
        """Return what it costs that the lines of a candidate cross labels."""
        return THROUGH_LABEL * sum(_met(self.labels, line) for line in candidate.lines)


def _covered(boxes: Sequence[Box], other: Box) -> float:
    """Return the area of a box that others cover [mm2]."""
    sides = np.array(boxes).reshape(-1, 4)
    low, high = np.maximum(sides[:, :2], other[:2]), np.minimum(sides[:, 2:], other[2:])
    return float((high - low).clip(0.0).prod(axis=1).sum())


def _met(boxes: Sequence[Box], other: Box) -> float:
    """Return over which length a box meets others, of which either may be thin [mm]."""
    sides = np.array(boxes).reshape(-1, 4)
    low, high = np.maximum(sides[:, :2], other[:2]), np.minimum(sides[:, 2:], other[2:])
    meets = (high >= low).all(axis=1)
    return float((high - low).max(axis=1, initial=0.0)[meets].sum())


def thin_box(points: Array) -> Box:
    """Return the box around points (k, 2)."""
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return (float(x0), float(y0), float(x1), float(y1))


def width_of(words: str, height: float) -> float:
    """Return how wide a text is at most [mm]: in DejaVu Sans, which is wider than what sheets are written with."""
    return _width(words) * height


@cache
def _width(words: str) -> float:
    """Return the width of a text over the height of its capitals."""
    font, glyphs = _font(), _font().get_charmap()
    font.set_text("".join(letter if ord(letter) in glyphs else WIDEST for letter in words))
    return float(font.get_width_height()[0]) / 64 / (SIZE * CAPITALS)


@cache
def _font() -> FT2Font:
    """Return the font in which texts are measured."""
    import matplotlib
    from matplotlib.ft2font import FT2Font

    font = FT2Font(str(Path(matplotlib.get_data_path(), "fonts", "ttf", "DejaVuSans.ttf")))
    font.set_size(SIZE, 72)
    return font


def shortened(name: str) -> str:
    """Return a name, the beginning of one that is long."""
    shown = printable(name)
    return Name(shown if len(shown) <= LONGEST else f"{shown[:LONGEST]}\N{HORIZONTAL ELLIPSIS}")


def box_of(text: Text) -> Box:
    """Return about where a text is, that is written across or upwards [mm]."""
    (x, y), h = text.place, text.height
    width = width_of(text.words, h)
    if text.centered:
        return (x - width / 2, y - h / 2, x + width / 2, y + h / 2)
    if text.turned:
        return (x - h - AROUND, y - AROUND, x + AROUND, y + width + AROUND)
    return (x - AROUND, y - AROUND, x + width + AROUND, y + h + AROUND)


def turned(shape: Shape) -> Shape:
    """Return a shape turned by a right angle counterclockwise about the origin."""
    if isinstance(shape, Line):
        return Line(shape.layer, np.column_stack([-shape.points[:, 1], shape.points[:, 0]]), shape.closed)
    if isinstance(shape, Text):
        x, y = shape.place
        return Text(shape.layer, (-y, x), shape.height, shape.words, shape.turned + 90.0, shape.centered)
    x, y = shape.center
    return type(shape)(shape.layer, (-y, x), shape.radius)
