"""A drawing of bars as a figure of Matplotlib, for SVG, PDF and PNG."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.views.drawing.bars import BROKEN, WIDE
from groundslab.views.drawing.shapes import Circle, Line, Shape, Text
from groundslab.views.plots import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from groundslab.arrays import Array

#: Color and width [pt] of the lines of a layer; of bars by their direction.
LOOKS = {
    "OUTLINE": (style.INK, 1.2), "OPENINGS": (style.INK, 0.8), "COLUMNS": (style.GREY, 0.8), "WALLS": (style.GREY, 0.8),
    "BEAMS": (style.GREY, 0.8),
    BROKEN: (style.LOAD, 0.7), "BARS_EDGES": (style.GREY, 0.9), "LINKS": (style.INK, 0.6),
    "LABELS": (style.INK, 0.5), "TABLE": (style.INK, 0.5),
}  # fmt: skip
ALONG_X, ALONG_Y = (style.ACCENT, 0.9), (style.SUPPORT, 0.9)
#: Height of capitals over the size of letters, and the margin of the sheet [mm].
CAPITALS, MARGIN = 0.73, 2.0


def to_figure(title: str, shapes: Sequence[Shape]) -> Figure:
    """Return a drawing as one sheet."""
    places = np.concatenate([_extent(shape) for shape in shapes])
    (x0, y0), (x1, y1) = places.min(axis=0), places.max(axis=0)
    y1 += 0.02 * (x1 - x0)
    page = style.Page(style.WIDE)
    top = page.write_heading(title)
    scale = (style.WIDE - 2 * MARGIN) / (x1 - x0)  # [mm/m]
    height = scale * (y1 - y0)
    axes = page.add_axes(MARGIN, top, style.WIDE - 2 * MARGIN, height)
    axes.set(xlim=(x0, x1), ylim=(y0, y1))
    axes.set_axis_off()
    for shape in shapes:
        color, width = LOOKS.get(shape.layer, ALONG_X if shape.layer.endswith("X") else ALONG_Y)
        if isinstance(shape, Line):
            points = np.vstack([shape.points, shape.points[:1]]) if shape.closed else shape.points
            axes.plot(*points.T, color=color, linewidth=width, linestyle="--" if shape.layer == BROKEN else "-")
        elif isinstance(shape, Circle):
            angle = np.linspace(0, 2 * np.pi, 33)
            x, y = shape.center
            axes.plot(x + shape.radius * np.cos(angle), y + shape.radius * np.sin(angle), color=color, linewidth=width)
        else:
            axes.text(
                *shape.place, style.plain_text(shape.words), fontsize=shape.height * scale / style.PT / CAPITALS,
                color=color, rotation=shape.turned, rotation_mode="anchor", va="baseline", parse_math=False,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.3},
            )  # fmt: skip
    return page.finish(top + height)


def _extent(shape: Shape) -> Array:
    """Return places (k, 2) between which a shape lies [m]; of a text about so."""
    if isinstance(shape, Line):
        return shape.points
    if isinstance(shape, Circle):
        return np.array(shape.center) + shape.radius * np.array([[-1.0, -1.0], [1.0, 1.0]])
    assert isinstance(shape, Text)
    length, angle = len(shape.words) * WIDE * shape.height, np.radians(shape.turned)
    end = np.array(shape.place) + length * np.array([np.cos(angle), np.sin(angle)])
    return np.array([shape.place, end])
