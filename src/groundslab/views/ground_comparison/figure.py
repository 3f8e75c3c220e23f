"""Settlement, moment and pressure of all grounds along the lines through the largest settlement, in one figure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.messages import Message
from groundslab.views.ground_comparison.rows import headings, source_of
from groundslab.views.plots import style
from groundslab.views.plots.request import DOWNWARDS, QUANTITIES
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundslab.analysis.ground_comparison.comparison import GroundComparison

#: Fields that are drawn along each axis: the moment is that of strips along the line.
ROWS = {"x": ("settlement", "moment_x", "pressure"), "y": ("settlement", "moment_y", "pressure")}
#: Boxes of the curves [mm].
LEFT, WIDTH, BETWEEN, HIGH, GAP, AXIS = 15.0, 70.0, 20.0, 36.0, 5.0, 11.0
#: Pressures are drawn up to so many times the one that is exceeded on 5 % of the area on the continuum: at edges its
#: curve grows without a limit.
MOST_PRESSURE = 2.0


def plot_comparison(comparison: GroundComparison, to: str | Path | None = None) -> Figure:
    """Draw settlement, moment and pressure of all grounds along x and y through the largest settlement.

    Parameters
    ----------
    comparison : GroundComparison
        The comparison.
    to : str or Path, optional
        File to write: .pdf, .svg or .png. An existing file is replaced only if groundslab drew it.

    Returns
    -------
    matplotlib.figure.Figure
        The figure, which notebooks show by themselves.

    Raises
    ------
    InputError
        If the file cannot be written.

    Examples
    --------
    >>> import groundslab
    >>> comparison = groundslab.compare_grounds(groundslab.load("case.toml"))
    >>> figure = groundslab.plot_comparison(comparison)
    """
    from groundslab.views.plots import export

    with style.apply_style():
        figure = style.show_in(draw_comparison(comparison), comparison.model.units)
    if to is not None:
        export.save([figure], to)
    return figure


def draw_comparison(comparison: GroundComparison, titled: bool = True) -> Figure:
    """Return the figure, in the style that is in force."""
    page = style.Page(style.PAGE_WIDTH, words_of(comparison.model))
    source = source_of(comparison) if comparison.model.cases else ""
    top = page.write_heading(comparison.model.title, [source]) if titled else style.MARGIN
    legend: dict[str, Any] = {}
    for column, (axis, fields) in enumerate(ROWS.items()):
        for row, field in enumerate(fields):
            left, below = LEFT + column * (WIDTH + BETWEEN), top + row * (HIGH + GAP)
            axes = page.add_axes(left, below, WIDTH, HIGH)
            legend |= _draw_curves(axes, comparison, axis, field)
            axes.tick_params(labelbottom=row == len(fields) - 1)
        across, where = ("y", comparison.place[1]) if axis == "x" else ("x", comparison.place[0])
        place = Message(f"{{axis}}, at {across} = {{where:number m}}", axis=axis, where=round(where, 3))
        axes.set_xlabel(style.label_of_length(place))
    return page.finish(top + 3 * HIGH + 2 * GAP + AXIS, legend)


def _draw_curves(axes: Axes, comparison: GroundComparison, axis: str, field: str) -> dict[str, Any]:
    """Draw a field of all grounds along a line; return the entries in the legend."""
    quantity = QUANTITIES[field].in_units(comparison.model.units)
    about = quantity.field
    along = np.array(comparison.lines[axis])
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=1)
    entries = {}
    for name, ground, color, stroke in zip(
        headings(comparison), comparison.grounds, style.CYCLE, style.STROKES, strict=False
    ):
        # beside the plate there is nothing, which breaks the curve
        values = np.array(ground.curves[axis][field], dtype=float) * about.scale
        (entries[name],) = axes.plot(along, values, color=color, linestyle=stroke, linewidth=1.1)
    axes.set(xlim=(along[0], along[-1]), ylabel=quantity.label)
    axes.margins(y=0.08)
    if field == "pressure":
        limit = MOST_PRESSURE * comparison.grounds[0].figures["exceeded_pressure"] * about.scale
        axes.set_ylim(top=min(axes.get_ylim()[1], limit))
    if field in DOWNWARDS:
        axes.invert_yaxis()
    axes.grid(color=style.FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return entries
