"""Filled contours of nodal fields on nine-node quadrilaterals, with a colour bar."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.readings import goes_below_zero

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.tri import Triangulation

    from groundslab.results import Array, Integers

#: The eight triangles of a nine-node quadrilateral: all meet in its centre, two along each side.
TRIANGLES = np.array(
    [[0, 4, 8], [4, 1, 8], [1, 5, 8], [5, 2, 8], [2, 6, 8], [6, 3, 8], [3, 7, 8], [7, 0, 8]]
)  # fmt: skip
OVER = "#b30000"


def triangulate(elements: Integers) -> Integers:
    """Return the triangles (8 m, 3) that split nine-node quadrilaterals (m, 9) and use every node."""
    return elements[:, TRIANGLES].reshape(-1, 3)


def filled(
    axes: Axes,
    triangles: Triangulation,
    values: Array,
    span: tuple[float, float],
    label: str,
    *,
    above: bool = False,
) -> None:
    """Draw filled contours with a colour bar; colours are centred on zero if the span crosses it."""
    from matplotlib import colormaps
    from matplotlib.colors import CenteredNorm, Normalize
    from matplotlib.ticker import MaxNLocator

    low, high = span
    if high - low <= 1e-12 * max(abs(low), abs(high), 1e-300):
        low, high = low - 0.5 * abs(low) - 1e-12, high + 0.5 * abs(high) + 1e-12
    levels = np.asarray(MaxNLocator(nbins=14, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    if above:
        # The scale ends at the largest value inside, not at the next round number.
        levels = np.append(levels[levels < high], high)
    norm: Normalize
    if goes_below_zero(values):
        colours, norm = colormaps["RdBu"], CenteredNorm(0.0, float(np.abs(levels).max()))
    else:
        colours, norm = colormaps["viridis"], Normalize(float(levels[0]), float(levels[-1]))
    if above:
        colours = colours.with_extremes(over=OVER)
    drawn = axes.tricontourf(
        triangles, values, levels=levels, cmap=colours, norm=norm, extend="max" if above else "neither"
    )
    # Beside the panel in its own coordinates, so that the bar is as high as the plate.
    figure = axes.get_figure(root=True)
    assert figure is not None
    length, height = np.ptp(triangles.x), np.ptp(triangles.y)
    every = 1 if height > 0.4 * length else 2
    first = int(np.argmin(np.abs(levels))) % every
    bar = axes.inset_axes((1.03, 0.0, 0.04, 1.0))
    figure.colorbar(drawn, cax=bar, label=label, ticks=levels[first::every])
