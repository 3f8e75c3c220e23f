"""A dimensioned sketch of the perimeter of a calculation of punching: its pieces, and what openings take off."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.demands.line_properties import total_length
from groundslab.design.demands.perimeter_pieces import WeightedLegs, pieces_of
from groundslab.design.demands.perimeters import outside
from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.messages import Name
from groundslab.views.plots import style
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from markupsafe import Markup
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.design.demands.perimeter_pieces import Piece
    from groundslab.design.demands.perimeters import SketchedPerimeter
    from groundslab.model.model import Model

#: Width of a sketch, its largest and its least height [mm].
WIDTH, HEIGHT, LEAST_HEIGHT = 62.0, 52.0, 30.0
#: What stays free for dimensions around the perimeter, beside and above it [mm].
BESIDE, ABOVE = 12.0, 7.0
#: Letters of dimensions are so far from what they are of, and axes so long [mm].
OFF, AXIS = 1.0, 6.0
#: At these shares of a piece its dimension may stand, the first one where nothing is in its way.
PLACES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9)
#: Lengths less than this are none [m].
NONE = 1e-6
#: So many places of a line are looked at for dimensions at most.
MOST_DENSE = 400


def draw_sketch(model: Model, sketch: SketchedPerimeter, number: int, label: str) -> Markup:
    """Return the sketch as an SVG element for an HTML page; its label is its title for screen readers."""
    draw, say = (lambda: _figure(model, sketch)), words_of(model)
    return to_inline_svg(draw, f"sketch{number}", label, units=model.units, translate=say)


@dataclass
class _Dimensions:
    """Dimensions on axes, each where it is on none that stands already and on no line, if there is such a place."""

    axes: Axes
    per_meter: float  # [mm/m]
    low: Array  # (2,): lower left corner of the picture [m]
    size: Array  # (2,): of the picture [mm]
    lines: Array  # (n, 2): places along what is drawn [mm]
    boxes: list[Array] = field(default_factory=list)  # (2, 2) each: lower left and upper right corner [mm]

    def write(self, text: str, candidates: list[tuple[Array, Array]], color: str) -> None:
        """Write a text beside one of some places (2,) [m], to the side that a vector (2,) points to."""
        width, high = style.text_width(text, style.FOOT), style.FOOT * style.PT
        half = np.array([width, high]) / 2
        best, least = None, np.inf
        for k, (place, side) in enumerate(candidates):
            # as far that way that the box of the text does not reach back
            middle = (place - self.low) * self.per_meter + side * (OFF + np.abs(half * side).sum())
            box = np.array([middle - half, middle + half])
            cost = self._covers(box) + 1e-3 * k
            if cost < least:
                best, least = box, cost
        assert best is not None
        self.boxes.append(best)
        x, y = (self.low + best.mean(axis=0) / self.per_meter).tolist()
        self.axes.text(
            x, y, Name(text), fontsize=style.FOOT, color=color, ha="center", va="center_baseline", zorder=6,
            parse_math=False,
        )  # fmt: skip

    def _covers(self, box: Array) -> float:
        """Return how much a box covers: other texts most, then the picture's border, then lines."""
        (x0, y0), (x1, y1) = box
        over = sum(
            float(np.prod(np.maximum(np.minimum(box[1], b[1]) - np.maximum(box[0], b[0]), 0.0))) for b in self.boxes
        )
        beyond = float(max(0.0, -x0, -y0, x1 - self.size[0], y1 - self.size[1]))
        on = ((self.lines > [x0, y0]) & (self.lines < [x1, y1])).all(axis=1).sum()
        return float(100.0 * over + 50.0 * beyond + 0.2 * on)


def _figure(model: Model, sketch: SketchedPerimeter) -> Figure:
    """Return the sketch as a figure."""
    low, size, per_meter = _scale(sketch)
    page = style.Page(WIDTH)
    axes = page.add_axes(0.0, 0.0, *size)
    high = low + size / per_meter
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_axis_off()
    drawn = [*_draw_slab(axes, model, sketch)]
    pieces = sketch.pieces
    for end in (ends := tangents(sketch)):
        drawn.append(np.array([sketch.center, end]))
        axes.plot(*drawn[-1].T, color=style.GREY, linewidth=0.5, linestyle=(0, (4, 2)), zorder=2)
    cuts = pieces_of((WeightedLegs(_cut(sketch)),), np.eye(2), sketch.origin)
    for cut in cuts:
        drawn.append(_places(cut.legs))
        axes.plot(*drawn[-1].T, color=style.GREY, linewidth=0.8, linestyle=(0, (2, 2)), zorder=4.5)
    for piece in pieces:
        drawn.append(_places(piece.legs))
        axes.plot(*drawn[-1].T, color=style.LOAD, linewidth=1.4, zorder=5)
        if len(pieces) > 1:
            axes.plot(*drawn[-1][[0, -1]].T, ".", color=style.LOAD, markersize=3, zorder=5.5)
    lines = np.concatenate([_dense(line) for line in drawn])
    dimensions = _Dimensions(axes, per_meter, low, size, (lines - low) * per_meter)
    _draw_axes(dimensions, sketch)
    for number, piece in enumerate(pieces, 1):
        dimensions.write(f"{number}: {_dimension(piece)}", [*_beside(piece)], style.LOAD)
    for cut in cuts:
        dimensions.write(_millimeters(total_length(cut.legs)), [*_beside(cut)], style.GREY)
    for end in ends:
        length = _millimeters(float(np.linalg.norm(end - sketch.center)))
        dimensions.write(length, [*_along(sketch.center, end)], style.GREY)
    return page.finish(float(size[1]), signed=False)


def _draw_slab(axes: Axes, model: Model, sketch: SketchedPerimeter) -> Iterator[Array]:
    """Draw the slab inside the perimeter, edges, openings, steps and columns; yield the lines (n, 2) near it [m]."""
    from shapely import get_coordinates, get_parts, intersection

    line = sketch.line
    axes.fill(*np.array(line.inside.exterior.coords).T, facecolor=style.PANEL, edgecolor="none", zorder=1)
    chord = DRAWN_CHORD * max(model.sides)
    for plate in model.every_plate:
        for ring in (plate.ring(), *(hole.ring() for hole in plate.openings)):
            places = np.array(ring.flat(chord))
            axes.plot(*np.vstack([places, places[:1]]).T, color=style.INK, linewidth=1.1, zorder=3)
            yield np.vstack([places, places[:1]])
        area = plate.ring().polygon(chord)
        for zone in plate.zones:
            if zone.thickness is not None:
                for part in get_parts(intersection(zone.shape.ring().polygon(chord).exterior, area)):
                    axes.plot(*get_coordinates(part).T, color=style.INK, linewidth=0.5, zorder=3)
    walls = [] if sketch.parts[0].shear is None else get_parts(line.loaded)
    bases = [get_coordinates(wall.exterior) for wall in walls]
    for places in (*(np.array(column.ring().flat(chord)) for column in model.columns), *bases):
        axes.fill(*places.T, facecolor=style.FAINT, edgecolor=style.INK, linewidth=0.6, zorder=4)
        yield np.vstack([places, places[:1]])


def _draw_axes(dimensions: _Dimensions, sketch: SketchedPerimeter) -> None:
    """Draw axes 1 and 2 from where places are measured."""
    for name, axis in zip("12", sketch.axes, strict=True):
        tip = sketch.origin + axis * AXIS / dimensions.per_meter
        dimensions.axes.annotate(
            "", tuple(tip), tuple(sketch.origin), zorder=5.8,
            arrowprops={"arrowstyle": "->", "color": style.ACCENT, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0,
                        "mutation_scale": 5},
        )  # fmt: skip
        across = np.array([-axis[1], axis[0]])
        dimensions.write(name, [(tip, axis), (tip, across), (tip, -across)], style.ACCENT)


def _dimension(piece: Piece) -> str:
    """Return the length of a piece on the plan, and the radius of an arc in brackets [m]."""
    length = _millimeters(total_length(piece.legs))
    return length if piece.radius is None or np.isnan(piece.radius) else f"{length} ({_millimeters(piece.radius)})"


def _millimeters(length: float) -> str:
    """Return a length in meters to the millimeter, halves up, the same of two that differ by rounding."""
    return f"{math.floor(round(length * 1e3, 3) + 0.5) / 1e3:.3f}"


def _beside(piece: Piece) -> Iterator[tuple[Array, Array]]:
    """Yield places (2,) along a piece, and the side (2,) away from what it cuts off, then the other one."""
    legs = piece.legs
    length = np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)
    ways = np.concatenate([[0.0], np.cumsum(length)])
    for sign in (1.0, -1.0):
        for share in PLACES:
            way = share * ways[-1]
            leg = min(int(np.searchsorted(ways, way, side="right")) - 1, len(legs) - 1)
            along = (legs[leg, 1] - legs[leg, 0]) / length[leg]
            place = legs[leg, 0] + (way - ways[leg]) * along
            yield place, sign * np.array([along[1], -along[0]])


def _along(start: Array, end: Array) -> Iterator[tuple[Array, Array]]:
    """Yield places (2,) along a line, and both sides (2,) of it."""
    along = (end - start) / np.linalg.norm(end - start)
    for share in (0.6, 0.7, 0.8, 0.5, 0.9):
        for sign in (1.0, -1.0):
            yield start + share * (end - start), sign * np.array([along[1], -along[0]])


def _dense(line: Array, step: float = 0.05) -> Array:
    """Return places (n, 2) along a line (k, 2), no farther apart than a step [m]."""
    counts = np.ceil(np.minimum(np.linalg.norm(np.diff(line, axis=0), axis=1) / step, MOST_DENSE)).astype(int)
    parts = [
        a + np.linspace(0, 1, 1 + count)[:, None] * (b - a)
        for count, (a, b) in zip(counts, pairwise(line), strict=True)
    ]
    return np.concatenate(parts)


def _places(legs: Array) -> Array:
    """Return the places (l + 1, 2) along legs (l, 2, 2), each of which begins where the one before ends."""
    return np.vstack([legs[:1, 0], legs[:, 1]])


def _cut(sketch: SketchedPerimeter) -> Array:
    """Return the legs (k, 2, 2) of a perimeter on the slab that do not count at all."""
    from shapely import linestrings, multilinestrings

    cut = outside(sketch.line.whole, multilinestrings(linestrings(sketch.legs)).buffer(NONE))
    long: Array = cut[np.linalg.norm(cut[:, 1] - cut[:, 0], axis=1) > 10 * NONE]
    return long


def _scale(sketch: SketchedPerimeter) -> tuple[Array, Array, float]:
    """Return the lower left corner of the picture (2,) [m], its size (2,) [mm], and its scale [mm/m]."""
    places = np.vstack([sketch.line.whole.reshape(-1, 2), np.array(sketch.line.inside.exterior.coords)])
    least, most = places.min(axis=0), places.max(axis=0)
    space = np.array([WIDTH - 2 * BESIDE, HEIGHT - 2 * ABOVE])
    per_meter = float((space / (most - least)).min())
    height = max(LEAST_HEIGHT, float((most - least)[1]) * per_meter + 2 * ABOVE)
    size = np.array([WIDTH, height])
    return (least + most) / 2 - size / per_meter / 2, size, per_meter


def tangents(sketch: SketchedPerimeter) -> list[Array]:
    """Return where what counts of the perimeter ends within it (k, 2) [m], as at the tangents to openings."""
    ends = np.round(sketch.legs.reshape(-1, 2), 6)
    rim = np.round(sketch.line.whole.reshape(-1, 2), 6)
    once = {tuple(end) for end in ends if (ends == end).all(axis=1).sum() == 1}
    edges = {tuple(end) for end in rim if (rim == end).all(axis=1).sum() == 1}
    return [np.array(end) for end in sorted(once - edges)]
