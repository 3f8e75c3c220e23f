"""Filled contours of nodal fields on nine-node quadrilaterals: color scales with round levels, fillings, color bars."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.results.contact_zone import goes_below_zero
from groundslab.views.plots.style import INK, SMALL

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap, Normalize
    from matplotlib.path import Path
    from matplotlib.tri import Triangulation

    from groundslab.arrays import Array, Integers

#: About so many bands of color.
BANDS = 13
#: A map from dark to light for one sign, and one with white in the middle: red for what is positive, blue below zero.
ONE_SIGN, TWO_SIGNS = "viridis", "RdBu_r"


@dataclass(frozen=True, slots=True)
class ColorScale:
    """The borders of the bands, ascending, in units of display; how they are colored."""

    levels: Array
    parts_at: float | None  # where the two colors of the map meet, None of a map of one color
    reversed: bool = False  # the map runs from light to dark, for what is largest below zero

    def color_map(self) -> tuple[Colormap, Normalize]:
        """Return the color map, and what takes values to it."""
        from matplotlib import colormaps
        from matplotlib.colors import CenteredNorm, Normalize

        if self.parts_at is not None:
            norm: Normalize = CenteredNorm(self.parts_at, float(np.abs(self.levels - self.parts_at).max()))
            colors = colormaps[TWO_SIGNS]
        else:
            norm = Normalize(float(self.levels[0]), float(self.levels[-1]))
            colors = colormaps[ONE_SIGN + ("_r" if self.reversed else "")]
        return colors, norm

    def colors_at(self, values: Array) -> Array:
        """Return the colors (n, 4) of the bands that values (n,) lie in."""
        colors, norm = self.color_map()
        band = np.clip(np.searchsorted(self.levels, values, side="right") - 1, 0, len(self.levels) - 2)
        rgba: Array = np.asarray(colors(norm((self.levels[band] + self.levels[band + 1]) / 2)))
        return rgba


def make_scale(values: Sequence[Array], *, signed: bool, limit: float | None = None) -> ColorScale:
    """Return the scale that several fields share, in units of display; it parts at zero, or at a limit if given."""
    from matplotlib.ticker import MaxNLocator

    low = min(float(value.min()) for value in values)
    high = max(float(value.max()) for value in values)
    size = max(abs(low), abs(high))
    below = goes_below_zero(np.array([low, high]))
    if not signed and not below and low < 0.5 * high:
        low = 0.0
    if size == 0:
        high = 1.0
    elif high - low <= 1e-9 * size:
        low, high = low - 0.5 * abs(low), high + 0.5 * abs(high)
    levels = np.asarray(MaxNLocator(nbins=BANDS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    only_below = below and not signed and high <= 1e-9 * size
    if limit is None and (signed or below) and not only_below:
        limit = 0.0
    return ColorScale(levels, limit, only_below)


#: The eight triangles of a nine-node quadrilateral: all meet in its center, two along each side.
TRIANGLES = np.array(
    [[0, 4, 8], [4, 1, 8], [1, 5, 8], [5, 2, 8], [2, 6, 8], [6, 3, 8], [3, 7, 8], [7, 0, 8]]
)  # fmt: skip
#: With more elements than this the colors in SVG and PDF files are pixels, so that the files stay small.
MOST_ELEMENTS = 20_000
#: Space for a label of the bar along it [mm].
LABEL = 4.6


def triangulate(elements: Integers) -> Integers:
    """Return the triangles (8 m, 3) that split nine-node quadrilaterals (m, 9) and use every node."""
    return elements[:, TRIANGLES].reshape(-1, 3)


def triangulation(nodes: Array, elements: Integers) -> Triangulation:
    """Return Matplotlib's triangulation of nine-node quadrilaterals."""
    from matplotlib.tri import Triangulation

    return Triangulation(nodes[:, 0], nodes[:, 1], triangulate(elements))


def draw_contours(axes: Axes, triangles: Triangulation, values: Array, scale: ColorScale) -> None:
    """Fill the bands of nodal values (n,), with thin lines between them and a stronger one where the colors meet."""
    colors, norm = scale.color_map()
    levels = scale.levels
    shown = _within(values, levels)
    many = len(triangles.triangles) > len(TRIANGLES) * MOST_ELEMENTS
    drawn = axes.tricontourf(triangles, shown, levels=levels, cmap=colors, norm=norm, zorder=0.5)
    drawn.set_rasterized(many)
    between = levels_with_lines(values, scale)
    if len(between):
        parted = np.abs(between - (scale.parts_at or 0.0)) <= 1e-9 * np.abs(levels).max()
        widths = np.where(parted & (scale.parts_at is not None), 0.7, 0.2)
        axes.tricontour(
            triangles, shown, levels=between, colors=INK, linewidths=widths, linestyles="solid", alpha=0.55, zorder=0.6
        ).set_rasterized(many)


def _within(values: Array, levels: Array) -> Array:
    """Return values within levels: what lies on the last one, or by rounding below the first, would leave a hole."""
    return np.asarray(np.clip(values, levels[0], levels[-1] - 1e-9 * (levels[-1] - levels[0])))


def levels_with_lines(values: Array, scale: ColorScale) -> Array:
    """Return the levels that have a line."""
    between = (scale.levels > values.min()) & (scale.levels < values.max())
    return np.asarray(scale.levels[between])


def contour_lines(triangles: Triangulation, values: Array, levels: Array) -> Iterator[tuple[float, Array]]:
    """Yield each line of nodal values (n,) with its level, as places (k, 2) [m]; closed ones end where they start."""
    from matplotlib.figure import Figure

    if not len(levels):
        return
    drawn = Figure().add_subplot().tricontour(triangles, values, levels=levels)
    for level, lines in zip(levels.tolist(), drawn.allsegs, strict=True):
        yield from ((level, np.asarray(line)) for line in lines if len(line) > 1)


def bands(axes: Axes, triangles: Triangulation, values: Array, levels: Sequence[float] | Array) -> list[Path]:
    """Return the polygons between each level and the next one; those of one band are one path.

    What lies beyond the levels counts as on the first or the last one. Nothing is left in the axes.
    """
    drawn = axes.tricontourf(triangles, _within(values, np.asarray(levels)), levels=levels)
    paths = list(drawn.get_paths())
    drawn.remove()
    return paths


def draw_color_bar(
    axes: Axes, scale: ColorScale, label: str, place: tuple[float, float, float, float], height: float
) -> None:
    """Draw the color bar at a place in the axes' own coordinates; its height [mm] says how many labels it has."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, ListedColormap

    levels = scale.levels
    figure = axes.get_figure(root=True)
    assert figure is not None
    bands = ListedColormap(scale.colors_at((levels[:-1] + levels[1:]) / 2).tolist())
    drawn = ScalarMappable(BoundaryNorm(levels, bands.N), bands)
    every = max(1, int(np.ceil(len(levels) * LABEL / height)))
    first = int(np.argmin(np.abs(levels))) % every
    ticks = levels[first::every]
    box = axes.inset_axes(place)
    box_bar = figure.colorbar(drawn, cax=box, label=label, ticks=ticks, spacing="proportional")
    box_bar.outline.set_linewidth(0.5)
    box.tick_params(labelsize=SMALL, width=0.5, length=2)
