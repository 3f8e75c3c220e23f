"""Rectangles of additional bars over cells that need some, none over another: which, with what bars, of least steel.

A zone's bars count in full as far from their ends as they are anchored, and in proportion before (EN 1992-1-1
9.2.1.3(3)). A cell that needs the share r of a zone's area must therefore be r l_b from the zone's ends, or reach an
edge of the plan, where bars of U shape hold them.

Windows are all rectangles of blocks of cells. The least cost of a window is the least of three: nothing, if none of its
cells needs bars; one zone that lies in the window with its anchorage; and the sum of the least costs of the two windows
into which a cut from border to border parts it (guillotine cuts, Gilmore and Gomory 1965). From small windows to large
ones this finds the best of all divisions by such cuts between blocks. No zone lies over another, as each has a window
of its own.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars.proposal.plan_grid import Window

#: Where there are more zones than allowed, their price grows by this factor, so many times at most, from a share of the
#: steel of the strongest bars all over the plan at least.
GROWTH, TRIALS, LEAST_PRICE = 1.4, 30, 1e-3
#: Numbers, whole numbers or flags.
Values = np.ndarray[Any, Any]
#: What counts as rounding, in cells, and relative.
IN_CELLS, ROUNDING = 1e-6, 1e-9


@dataclass(frozen=True)
class Field:
    """What cells need, along and across the bars.

    Attributes
    ----------
    excess : array (m, w)
        What they need beyond the base [m2/m], 0 where that is enough.
    area : array (m, w)
        What of them is in the plan [m2].
    every : int
        Zones end at multiples of so many cells along the bars, of which m is one.
    folded : tuple of bool
        Whether cells go on before the first one, along and across, by their mirror image.
    """

    excess: Array
    area: Array
    every: int = 1
    folded: tuple[bool, bool] = (False, False)

    @cached_property
    def runs(self) -> tuple[Integers, Integers]:
        """Return the first cell of the row of cells in the plan that each lies in along the bars, and that after it."""
        place = np.arange(len(self.area))[:, None]
        inside = self.area > 0
        start = np.maximum.accumulate(np.where(inside, 0, place + 1), axis=0)
        end = np.minimum.accumulate(np.where(inside, len(self.area), place)[::-1], axis=0)[::-1]
        return start, end

    @cached_property
    def area_before(self) -> Array:
        """Return the area (m + 1, w + 1) [m2] of all cells before one along and across."""
        return np.pad(self.area.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))


@dataclass(frozen=True, slots=True)
class Options:
    """The bars that a zone may have: areas (o,) [m2/m], lengths (o,) that develop them and its least size in cells."""

    area: Array
    anchorage: Array
    least: tuple[int, int]


@dataclass(frozen=True, slots=True)
class Zone:
    """A rectangle of additional bars: its cells, anchorage included, and which of the options it has.

    Where cells are folded it stands for its images, too: they are so many, and have so much steel [m3].
    """

    cells: Window
    option: int
    steel: float
    count: int


def cover(field: Field, options: Options, most: int, price: float, blocks: int) -> list[Zone] | None:
    """Return zones that cover what cells need, none over another; None if none can.

    Parameters
    ----------
    field : Field
        What cells need.
    options : Options
        The bars that zones may have.
    most : int
        Zones at most.
    price : float
        What each zone costs besides its steel [m3].
    blocks : int
        Into how many blocks cells are put together along and across, at most.
    """
    if not field.excess.any():
        return []
    if most == 0 or not len(options.area):
        return None
    best = _zones_of_windows(field, options, blocks)
    of_all = float(options.area.max() * field.area_before[-1, -1])
    for _ in range(TRIALS):
        zones = best.chosen(price)
        if zones is None or sum(zone.count for zone in zones) <= most:
            return zones
        price = max(GROWTH * price, LEAST_PRICE * of_all)
    return None


@dataclass(frozen=True, slots=True)
class Pairs:
    """Intervals of n blocks, the shortest first, those of one length by their start."""

    lines: Integers  # (n + 1,): cells before each line between blocks

    @property
    def blocks(self) -> int:
        """Return n."""
        return len(self.lines) - 1

    def of(self, length: int, start: int = 0, count: int | None = None) -> slice:
        """Return where intervals of some length are: all, or so many from a start."""
        first = (length - 1) * (2 * self.blocks - length + 2) // 2 + start
        return slice(first, first + (self.blocks - length + 1 - start if count is None else count))

    def ends(self) -> tuple[Integers, Integers]:
        """Return the cells at which intervals begin and end (p,)."""
        n = self.blocks
        start = np.concatenate([np.arange(n - length + 1) for length in range(1, n + 1)])
        length = np.repeat(np.arange(1, n + 1), np.arange(n, 0, -1))
        return self.lines[start], self.lines[start + length]

    def over(self, of: np.ufunc, values: Values) -> Values:
        """Return the least or the largest of values (n, ...) of blocks over each interval (p, ...)."""
        grown = [values]
        for length in range(1, self.blocks):
            grown.append(of(grown[-1][:-1], values[length:]))
        return np.concatenate(grown)


@dataclass(frozen=True, slots=True)
class _Windows:
    """The best zone of each window by itself: all arrays (p, q) over intervals along and across."""

    pairs: tuple[Pairs, Pairs]
    needed: Flags
    steel: Array  # [m3]; inf where no zone is enough
    count: Integers
    option: Integers
    cells: tuple[Integers, Integers, Integers, Integers]

    def chosen(self, price: float) -> list[Zone] | None:
        """Return the zones of the best division of all cells at a price [m3] for each; None if there is none."""
        along, across = self.pairs
        cost = np.where(self.needed, self.steel + price * self.count, 0.0)
        cuts = np.zeros(cost.shape, dtype=int)  # blocks before the cut: > 0 along, < 0 across, 0 none

        def part(where: tuple[slice, slice], sum_of_parts: Array, cut: int) -> None:
            better = sum_of_parts < cost[where] * (1 - ROUNDING)
            cost[where][better], cuts[where][better] = sum_of_parts[better], cut

        for m in range(1, along.blocks + 1):
            rows, number = along.of(m), along.blocks - m + 1
            for k in range(1, m):
                parts = cost[along.of(k, 0, number)] + cost[along.of(m - k, k, number)]
                part((rows, slice(None)), parts, k)
            for w in range(2, across.blocks + 1):
                columns, number_across = across.of(w), across.blocks - w + 1
                for k in range(1, w):
                    parts = cost[rows, across.of(k, 0, number_across)] + cost[rows, across.of(w - k, k, number_across)]
                    part((rows, columns), parts, -k)
        if not np.isfinite(cost[-1, -1]):
            return None
        zones, windows = list[Zone](), [(0, along.blocks, 0, across.blocks)]
        while windows:
            i, m, j, w = windows.pop()
            at = along.of(m, i).start, across.of(w, j).start
            cut = int(cuts[at])
            if cut > 0:
                windows += [(i, cut, j, w), (i + cut, m - cut, j, w)]
            elif cut < 0:
                windows += [(i, m, j, -cut), (i, m, j - cut, w + cut)]
            elif self.needed[at]:
                i0, i1, j0, j1 = (int(cells[at]) for cells in self.cells)
                zones.append(Zone((i0, i1, j0, j1), int(self.option[at]), float(self.steel[at]), int(self.count[at])))
        return zones


def block_lines(size: int, every: int, blocks: int) -> Pairs:
    """Return lines between no more than so many blocks of cells, at multiples of some cells."""
    places = np.arange(0, size + 1, every)
    number = min(blocks, len(places) - 1)
    return Pairs(places[np.round(np.linspace(0, len(places) - 1, number + 1)).astype(int)])


def _zones_of_windows(field: Field, options: Options, blocks: int) -> _Windows:
    """Return the best zone of each window by itself."""
    m, w = field.excess.shape
    along, across = block_lines(m, field.every, blocks), block_lines(w, 1, blocks)
    share = field.excess[..., None] / options.area  # (m, w, o)
    none = share <= 0
    place, (start, end) = np.arange(m)[:, None, None], (side[..., None] for side in field.runs)
    begin = np.where(none, m, np.maximum(place - share * options.anchorage, start))
    after = np.where(none, 0, np.minimum(place + 1 + share * options.anchorage, end))
    needed, column = field.excess > 0, np.arange(w)

    def over(of: np.ufunc, values: Values) -> Values:
        in_rows = of.reduceat(values, along.lines[:-1], axis=0)
        in_blocks = of.reduceat(in_rows, across.lines[:-1], axis=1)
        return np.swapaxes(across.over(of, np.swapaxes(along.over(of, in_blocks), 0, 1)), 0, 1)

    first, last = over(np.minimum, np.where(needed, column, w)), over(np.maximum, np.where(needed, column + 1, 0))
    (i0, i1), (j0, j1) = along.ends(), across.ends()
    every = field.every
    low = np.floor((over(np.minimum, begin) + IN_CELLS) / every).astype(int) * every
    high = np.ceil((over(np.maximum, after) - IN_CELLS) / every).astype(int) * every
    rows, folded = (i0[:, None, None], i1[:, None, None]), field.folded
    low, high, fits = _at_least(low, high, rows, options.least[0], every, m, folded=folded[0])
    first, last, fits_across = _at_least(first, last, (j0, j1), options.least[1], 1, w, folded=folded[1])
    enough = (over(np.maximum, share) <= 1 + ROUNDING) & fits & fits_across[..., None]
    option = np.argmin(np.where(enough, options.area * (high - low), np.inf), axis=2)
    chosen = (*np.ogrid[: len(i0), : len(j0)], option)
    low, high = low[chosen], high[chosen]
    before = field.area_before
    low, high, first, last = (np.clip(side, 0, size) for side, size in ((low, m), (high, m), (first, w), (last, w)))
    covered = before[high, last] - before[low, last] - before[high, first] + before[low, first]
    steel = np.where(enough[chosen], options.area[option] * covered, np.inf)
    count = (1 + (folded[0] & (low > 0))) * (1 + (folded[1] & (first > 0)))
    return _Windows((along, across), over(np.logical_or, needed), steel, count, option, (low, high, first, last))


def _at_least(
    low: Integers, high: Integers, window: tuple[Integers, Integers], least: int, every: int, size: int, *, folded: bool
) -> tuple[Integers, Integers, Flags]:
    """Return intervals that are no shorter than the least, at multiples of some cells, and whether they fit a window.

    One that begins at the middle of folded cells has half of its length there.
    """
    start, end = window
    least_each = np.minimum(np.where(folded & (low == 0), -(-least // (2 * every)) * every, least), size)
    fits = (low >= start) & (high <= end) & (end - start >= least_each)
    missing = np.maximum(least_each - (high - low), 0)
    low = np.maximum(low - missing // (2 * every) * every, start)
    high = np.minimum(np.maximum(high, low + least_each), end)
    return np.minimum(low, np.maximum(high - least_each, start)), high, fits
