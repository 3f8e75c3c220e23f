"""A part of the slab whose base has more bars: the rectangle that saves most, as under a core.

Zones are rectangles of even bars, none over another, so that they have two to three times the steel that is needed
beyond the base. Where much of a slab needs far more than the rest, bars in one rectangle beside the base leave less to
zones.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.proposal.covering import IN_CELLS, Field, block_lines
from groundslab.design.bars.proposal.plan_grid import Window
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import bar_area

#: Zones have about so many times the steel that is needed beyond the base: few wide ones, and many sharp peaks.
OVER = (2.0, 3.0)
#: The rectangle is found in so many blocks of cells along and across, at most.
BLOCKS = 24


@dataclass(frozen=True, slots=True)
class BasePart:
    """Bars beside those of the base in a rectangle of cells, with the length that develops them, in cells."""

    bars: Bars
    cells: Window
    anchorage: float

    def steel(self, field: Field) -> float:
        """Return their steel [m3]."""
        i0, i1, j0, j1 = self.cells
        return bar_area(self.bars) * float(field.area[i0:i1, j0:j1].sum())

    def count(self, field: Field) -> int:
        """Return how many rectangles it is, with its images."""
        i0, _, j0, _ = self.cells
        return (1 + (field.folded[0] and i0 > 0)) * (1 + (field.folded[1] and j0 > 0))

    def developed(self, field: Field, shift: Array | float = 0.0) -> Array:
        """Return what of them is developed in cells (m, w) [m2/m], in proportion to the way to their ends.

        Moments are shifted towards both ends, in cells.
        """
        i0, i1, j0, j1 = self.cells
        start, end = field.runs
        place = np.arange(len(field.area))[:, None]
        to_end = np.minimum(
            np.where(i0 <= start, np.inf, place - i0), np.where(i1 >= end, np.inf, i1 - place - 1)
        )  # held at edges
        share = np.clip((to_end - shift) / self.anchorage, 0.0, 1.0)
        across = np.arange(field.area.shape[1])
        return np.where((j0 <= across) & (across < j1), bar_area(self.bars) * share, 0.0)


def best_part(field: Field, bars: Bars, anchorage: float, least: tuple[int, int], over: float) -> BasePart | None:
    """Return the rectangle in which bars save most, developed where they are needed; None if they save nothing.

    Parameters
    ----------
    field : Field
        What cells need beyond the base.
    bars : Bars
        That lie in the rectangle beside the base.
    anchorage : float
        That develops them, in cells.
    least : tuple of int
        Size of the rectangle at least, in cells.
    over : float
        The steel of zones over what is needed beyond the base.
    """
    area = bar_area(bars)
    saved = (over * np.minimum(field.excess, area) - area) * field.area
    along, across = (
        block_lines(size, every, BLOCKS) for size, every in zip(saved.shape, (field.every, 1), strict=True)
    )
    before = np.pad(saved.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    (i0, i1), (j0, j1) = along.ends(), across.ends()
    start, end = before[i0], before[i1]
    of_windows = (end - start).take(j1, axis=1) - end.take(j0, axis=1) + start.take(j0, axis=1)
    best = np.unravel_index(int(np.argmax(of_windows)), of_windows.shape)
    window = int(i0[best[0]]), int(i1[best[0]]), int(j0[best[1]]), int(j1[best[1]])
    cells = _with_anchorage(field, window, np.minimum(field.excess / area, 1.0) * anchorage)
    big_enough = cells is not None and cells[1] - cells[0] >= least[0] and cells[3] - cells[2] >= least[1]
    if cells is None or not big_enough or of_windows[best] <= 0:
        return None
    return BasePart(bars, cells, anchorage)


def _with_anchorage(field: Field, window: Window, reach: Array) -> Window | None:
    """Return a window (cells) that holds what is needed in it with a reach (m, w) along, None if nothing is."""
    i0, i1, j0, j1 = window
    part = np.s_[i0:i1, j0:j1]
    needed = field.excess[part] > 0
    if not needed.any():
        return None
    place = np.arange(i0, i1)[:, None]
    start, end = (side[part] for side in field.runs)
    begin = np.where(needed, np.maximum(place - reach[part], start), len(field.area)).min()
    after = np.where(needed, np.minimum(place + 1 + reach[part], end), 0).max()
    every, columns = field.every, np.flatnonzero(needed.any(axis=0))
    low = int(np.floor((begin + IN_CELLS) / every)) * every
    high = int(np.ceil((after - IN_CELLS) / every)) * every
    return low, high, j0 + int(columns[0]), j0 + int(columns[-1]) + 1
