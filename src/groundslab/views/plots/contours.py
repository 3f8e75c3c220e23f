"""Filled contours of nodal fields on nine-node quadrilaterals, with a colour bar."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.views.plots.style import INK, SMALL

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.tri import Triangulation

    from groundslab.arrays import Array, Integers
    from groundslab.views.plots.scale import Scale

#: The eight triangles of a nine-node quadrilateral: all meet in its centre, two along each side.
TRIANGLES = np.array(
    [[0, 4, 8], [4, 1, 8], [1, 5, 8], [5, 2, 8], [2, 6, 8], [6, 3, 8], [3, 7, 8], [7, 0, 8]]
)  # fmt: skip
#: With more elements than this the colours in SVG and PDF files are pixels, so that the files stay small.
MOST_ELEMENTS = 20_000
#: Room for a label of the bar along it [mm].
LABEL = 4.6


def triangulate(elements: Integers) -> Integers:
    """Return the triangles (8 m, 3) that split nine-node quadrilaterals (m, 9) and use every node."""
    return elements[:, TRIANGLES].reshape(-1, 3)


def triangulation(nodes: Array, elements: Integers) -> Triangulation:
    """Return Matplotlib's triangulation of nine-node quadrilaterals."""
    from matplotlib.tri import Triangulation

    return Triangulation(nodes[:, 0], nodes[:, 1], triangulate(elements))


def fill(axes: Axes, triangles: Triangulation, values: Array, scale: Scale) -> None:
    """Fill the bands of nodal values (n,), with thin lines between them and a stronger one at zero."""
    colours, norm = scale.colours()
    levels = scale.levels
    # what lies on the last level, or by rounding below the first one, would leave a hole
    little = 1e-9 * (levels[-1] - levels[0])
    shown = np.clip(values, levels[0], levels[-1] - little)
    many = len(triangles.triangles) > len(TRIANGLES) * MOST_ELEMENTS
    drawn = axes.tricontourf(triangles, shown, levels=levels, cmap=colours, norm=norm, zorder=0.5)
    drawn.set_rasterized(many)
    between = levels[(levels > values.min()) & (levels < values.max())]
    if len(between):
        at_zero = np.abs(between) <= 1e-9 * np.abs(levels).max()
        widths = np.where(at_zero & scale.parts_at_zero, 0.7, 0.2)
        axes.tricontour(
            triangles, shown, levels=between, colors=INK, linewidths=widths, linestyles="solid", alpha=0.55, zorder=0.6
        ).set_rasterized(many)


def bar(axes: Axes, scale: Scale, label: str, place: tuple[float, float, float, float], height: float) -> None:
    """Draw the colour bar at a place in the axes' own coordinates; its height [mm] says how many labels it has."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, ListedColormap

    levels = scale.levels
    figure = axes.get_figure(root=True)
    assert figure is not None
    bands = ListedColormap(scale.of((levels[:-1] + levels[1:]) / 2).tolist())
    drawn = ScalarMappable(BoundaryNorm(levels, bands.N), bands)
    every = max(1, int(np.ceil(len(levels) * LABEL / height)))
    first = int(np.argmin(np.abs(levels))) % every
    ticks = levels[first::every]
    box = axes.inset_axes(place)
    box_bar = figure.colorbar(drawn, cax=box, label=label, ticks=ticks, spacing="proportional")
    box_bar.outline.set_linewidth(0.5)
    box.tick_params(labelsize=SMALL, width=0.5, length=2)
