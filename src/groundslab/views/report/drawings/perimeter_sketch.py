"""A sketch of the perimeter of a calculation of punching: what counts of it, what openings and edges take off."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.geometry.plan import DRAWN_CHORD
from groundslab.views.plots import style
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from markupsafe import Markup
    from matplotlib.figure import Figure

    from groundslab.arrays import Array
    from groundslab.design.demands.perimeters import SketchedPerimeter
    from groundslab.model.model import Model

#: Width of a sketch, its largest height, and what stays free around it [mm].
WIDTH, HEIGHT, FREE = 62.0, 44.0, 2.0
#: So much around the perimeter is shown, over its size.
AROUND = 0.15


def draw_sketch(model: Model, sketch: SketchedPerimeter, number: int, label: str) -> Markup:
    """Return the sketch as an SVG element for an HTML page; its label is its title for screen readers."""
    draw, say = (lambda: _figure(model, sketch)), words_of(model)
    return to_inline_svg(draw, f"sketch{number}", label, units=model.units, translate=say)


def _figure(model: Model, sketch: SketchedPerimeter) -> Figure:
    """Return the sketch as a figure."""
    from shapely import get_coordinates, get_parts, intersection

    line = sketch.line
    (x0, y0), (x1, y1) = _limits(sketch)
    per_meter = min((WIDTH - 2 * FREE) / (x1 - x0), HEIGHT / (y1 - y0))
    width, height = (x1 - x0) * per_meter, (y1 - y0) * per_meter
    page = style.Page(WIDTH)
    axes = page.add_axes((WIDTH - width) / 2, FREE, width, height)
    axes.set(xlim=(x0, x1), ylim=(y0, y1))
    axes.set_axis_off()
    axes.fill(*np.array(line.inside.exterior.coords).T, facecolor=style.PANEL, edgecolor="none", zorder=1)
    chord = DRAWN_CHORD * max(model.sides)
    for plate in model.every_plate:
        for ring in (plate.ring(), *(hole.ring() for hole in plate.openings)):
            places = np.array(ring.flat(chord))
            axes.plot(*np.vstack([places, places[:1]]).T, color=style.INK, linewidth=1.1, zorder=3)
        area = plate.ring().polygon(chord)
        for zone in plate.zones:
            if zone.thickness is not None:
                for part in get_parts(intersection(zone.shape.ring().polygon(chord).exterior, area)):
                    axes.plot(*get_coordinates(part).T, color=style.INK, linewidth=0.5, zorder=3)
    for column in model.columns:
        axes.fill(*np.array(column.ring().flat(chord)).T, facecolor=style.GREY, edgecolor=style.INK, zorder=4)
    for end in tangents(sketch):
        axes.plot(*np.array([sketch.center, end]).T, color=style.GREY, linewidth=0.6, linestyle=(0, (4, 2)), zorder=2)
    for part in _joined(line.whole):
        axes.plot(*part.T, color=style.GREY, linewidth=0.8, linestyle=(0, (2, 2)), zorder=4.5)
    for part in _joined(sketch.legs):
        axes.plot(*part.T, color=style.LOAD, linewidth=1.6, zorder=5)
    return page.finish(FREE + height, signed=False)


def _joined(legs: Array) -> list[Array]:
    """Return legs (k, 2, 2) as lines (n, 2) of those that go on where the one before ends, which are drawn quickly."""
    starts = np.flatnonzero((legs[1:, 0] != legs[:-1, 1]).any(axis=1)) + 1
    return [np.vstack([part[:1, 0], part[:, 1]]) for part in np.split(legs, starts) if len(part)]


def _limits(sketch: SketchedPerimeter) -> Array:
    """Return the lower left and the upper right corner (2, 2) of what is shown [m]."""
    places = np.vstack([sketch.line.whole.reshape(-1, 2), np.array(sketch.line.inside.exterior.coords)])
    low, high = places.min(axis=0), places.max(axis=0)
    around = AROUND * float((high - low).max())
    return np.array([low - around, high + around])


def tangents(sketch: SketchedPerimeter) -> list[Array]:
    """Return where what counts of the perimeter ends within it (k, 2) [m], as at the tangents to openings."""
    ends = np.round(sketch.legs.reshape(-1, 2), 6)
    rim = np.round(sketch.line.whole.reshape(-1, 2), 6)
    once = {tuple(end) for end in ends if (ends == end).all(axis=1).sum() == 1}
    edges = {tuple(end) for end in rim if (rim == end).all(axis=1).sum() == 1}
    return [np.array(end) for end in sorted(once - edges)]
