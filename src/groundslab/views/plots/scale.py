"""Colours of values: round levels that cover the data, one map for one sign, one that parts at zero for two."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.results.contact_zone import goes_below_zero

if TYPE_CHECKING:
    from matplotlib.colors import Colormap, Normalize

    from groundslab.arrays import Array

#: About so many bands of colour.
BANDS = 13
#: A map from dark to light for one sign, and one with white in the middle: red for what is positive, blue below zero.
ONE_SIGN, TWO_SIGNS = "viridis", "RdBu_r"


@dataclass(frozen=True, slots=True)
class Scale:
    """The borders of the bands, ascending, in units of display; how they are coloured."""

    levels: Array
    parts_at_zero: bool
    turned: bool = False  # the map runs from light to dark, for what is largest below zero

    def colours(self) -> tuple[Colormap, Normalize]:
        """Return the colour map, and what takes values to it."""
        from matplotlib import colormaps
        from matplotlib.colors import CenteredNorm, Normalize

        if self.parts_at_zero:
            norm: Normalize = CenteredNorm(0.0, float(np.abs(self.levels).max()))
            found = colormaps[TWO_SIGNS]
        else:
            norm = Normalize(float(self.levels[0]), float(self.levels[-1]))
            found = colormaps[ONE_SIGN + ("_r" if self.turned else "")]
        return found, norm

    def of(self, values: Array) -> Array:
        """Return the colours (n, 4) of the bands that values (n,) lie in."""
        colours, norm = self.colours()
        band = np.clip(np.searchsorted(self.levels, values, side="right") - 1, 0, len(self.levels) - 2)
        rgba: Array = np.asarray(colours(norm((self.levels[band] + self.levels[band + 1]) / 2)))
        return rgba


def scale_of(values: Sequence[Array], *, signed: bool) -> Scale:
    """Return the scale that several fields share, in units of display."""
    from matplotlib.ticker import MaxNLocator

    low, high = min(float(each.min()) for each in values), max(float(each.max()) for each in values)
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
    return Scale(levels, (signed or below) and not only_below, only_below)
