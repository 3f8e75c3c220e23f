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

import math
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
#: No division costs less than the one found by more than this, relative: rounding at each cut, some 50 in a row.
SURELY = 1e-6


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


def cover(
    field: Field, options: Options, most: int, price: float, blocks: int, limit: float = math.inf
) -> list[Zone] | None:
    """Return zones that cover what cells need, none over another; None if none can, or all that can cost too much.

    At a higher price zones are no more, so that the lowest price at which they are few enough is found by bisection:
    at prices a < b, with zones of steel S and number N, S_a + a N_a <= S_b + a N_b and S_b + b N_b <= S_a + b N_a,
    whose sum is (b - a) (N_b - N_a) <= 0.

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
    limit : float
        Zones are of no use if their steel and price together are so much [m3] or more.
    """
    if not field.excess.any():
        return []
    if most == 0 or not len(options.area):
        return None
    best = _zones_of_windows(field, options, blocks)
    prices, of_all = [price], float(options.area.max() * field.area_before[-1, -1])
    for _ in range(TRIALS - 1):
        prices.append(max(GROWTH * prices[-1], LEAST_PRICE * of_all))
    low, trial, few = 0, 0, None
    high = len(prices)
    while low < high:
        zones, cost = best.chosen(prices[trial])
        # zones that are few enough cost so much more at this price than at the first one, at most
        if zones is None or cost * (1 - SURELY) - (prices[trial] - price) * most >= limit:
            return None
        if sum(zone.count for zone in zones) <= most:
            high, few = trial, zones
        else:
            low = trial + 1
        trial = (low + high) // 2
    return few


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

    def chosen(self, price: float) -> tuple[list[Zone] | None, float]:
        """Return the zones of the best division of all cells at a price [m3] for each, and its cost [m3].

        None, and inf, if there is no division.
        """
        along, across = self.pairs
        alone = np.where(self.needed, self.steel + price * self.count, 0.0)
        least = _Least.of(alone, along, across)
        all_blocks = 0, along.blocks, 0, across.blocks
        cost = least.cost(all_blocks)
        zones, windows = list[Zone](), [all_blocks]
        while windows and np.isfinite(cost):
            i, m, j, w = windows.pop()
            at = along.of(m, i).start, across.of(w, j).start
            parts = least.parts((i, m, j, w), float(alone[at]))
            windows += parts
            if not parts and self.needed[at]:
                i0, i1, j0, j1 = (int(cells[at]) for cells in self.cells)
                zones.append(Zone((i0, i1, j0, j1), int(self.option[at]), float(self.steel[at]), int(self.count[at])))
        return (zones, cost) if np.isfinite(cost) else (None, cost)


#: A window by its first block along and how many, and by those across.
_Blocks = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class _Least:
    """The least costs [m3] of windows of m blocks along from block i: (m, i, q) over intervals across."""

    across: Pairs
    costs: Array

    @classmethod
    def of(cls, alone: Array, along: Pairs, across: Pairs) -> _Least:
        """Return them from the costs of windows that are not cut (p, q), all cuts of those of one size at once."""
        n = along.blocks
        costs = np.empty((n + 1, n, alone.shape[1]))
        by_end = np.empty((n + 1, n + 1, alone.shape[1]))  # so that the parts after all cuts are a slice, too
        for m in range(1, n + 1):
            number = n - m + 1
            cost = alone[along.of(m)]
            if m > 1:
                cost = _cheaper(cost, costs[1:m, :number] + by_end[m - 1 : 0 : -1, m:])
            costs[m, :number] = by_end[m, m:] = _cut_across(cost, across)
        return cls(across, costs)

    def cost(self, window: _Blocks) -> float:
        """Return the least cost of a window."""
        i, m, j, w = window
        return float(self.costs[m, i, self.across.of(w, j).start])

    def parts(self, window: _Blocks, alone: float) -> list[_Blocks]:
        """Return the two parts of the best cut of a window that costs so much if not cut; none if that is best."""
        i, m, j, w = window
        cuts = [[(i, k, j, w), (i + k, m - k, j, w)] for k in range(1, m)]
        cuts += [[(i, m, j, k), (i, m, j + k, w - k)] for k in range(1, w)]
        best = list[_Blocks]()
        for parts in cuts:
            cost = sum(self.cost(part) for part in parts)
            if cost < alone * (1 - ROUNDING):
                alone, best = cost, parts
        return best


def _cut_across(cost: Array, across: Pairs) -> Array:
    """Return the least costs (i, q) of windows of one length, from those that they have if not cut across."""
    n, least = across.blocks, np.empty_like(cost)
    by_start, by_end = (np.empty((n + 1, len(cost), n + 1)) for _ in range(2))
    for w in range(1, n + 1):
        columns, number = across.of(w), n - w + 1
        of_width = cost[:, columns]
        if w > 1:
            of_width = _cheaper(of_width, by_start[1:w, :, :number] + by_end[w - 1 : 0 : -1, :, w:])
        least[:, columns] = by_start[w, :, :number] = by_end[w, :, w:] = of_width
    return least


def _cheaper(cost: Array, of_cuts: Array) -> Array:
    """Return costs, or the least of those of cuts (k, ...) where that is less."""
    least = of_cuts.min(axis=0)
    return np.where(least < cost * (1 - ROUNDING), least, cost)


def block_lines(size: int, every: int, blocks: int) -> Pairs:
    """Return lines between no more than so many blocks of cells, at multiples of some cells."""
    places = np.arange(0, size + 1, every)
    number = min(blocks, len(places) - 1)
    return Pairs(places[np.round(np.linspace(0, len(places) - 1, number + 1)).astype(int)])


def _zones_of_windows(field: Field, options: Options, blocks: int) -> _Windows:
    """Return the best zone of each window by itself."""
    m, w = field.excess.shape
    along, across = block_lines(m, field.every, blocks), block_lines(w, 1, blocks)
    (i0, i1), windows_across = along.ends(), across.ends()
    every, folded, windows = field.every, field.folded, (i0[:, None], i1[:, None])

    def over(of: np.ufunc, values: Values) -> Values:
        in_rows = of.reduceat(values, along.lines[:-1], axis=0)
        in_blocks = of.reduceat(in_rows, across.lines[:-1], axis=1)
        return across.over(of, along.over(of, in_blocks).T).T

    needed, column = field.excess > 0, np.arange(w)
    first, last = over(np.minimum, np.where(needed, column, w)), over(np.maximum, np.where(needed, column + 1, 0))
    first, last, fits_across = _at_least(first, last, windows_across, options.least[1], 1, w, folded=folded[1])
    largest = over(np.maximum, field.excess)
    least = np.full(largest.shape, np.inf)  # area times length of the bars
    option, low, high = (np.zeros(least.shape, dtype=int) for _ in range(3))
    for number, (area, anchorage) in enumerate(zip(options.area.tolist(), options.anchorage.tolist(), strict=True)):
        begin, after = _developed_at(field, area, anchorage)
        start = np.floor((over(np.minimum, begin) + IN_CELLS) / every).astype(int) * every
        end = np.ceil((over(np.maximum, after) - IN_CELLS) / every).astype(int) * every
        start, end, fits = _at_least(start, end, windows, options.least[0], every, m, folded=folded[0])
        enough = (largest / area <= 1 + ROUNDING) & fits & fits_across
        of_option = np.where(enough, area * (end - start), np.inf)
        better = of_option < least
        for best, value in ((least, of_option), (option, number), (low, start), (high, end)):
            np.copyto(best, value, where=better)
    before = field.area_before
    low, high, first, last = (np.clip(side, 0, size) for side, size in ((low, m), (high, m), (first, w), (last, w)))
    covered = before[high, last] - before[low, last] - before[high, first] + before[low, first]
    steel = np.where(np.isfinite(least), options.area[option] * covered, np.inf)
    count = (1 + (folded[0] & (low > 0))) * (1 + (folded[1] & (first > 0)))
    return _Windows((along, across), over(np.logical_or, needed), steel, count, option, (low, high, first, last))


def _developed_at(field: Field, area: float, anchorage: float) -> tuple[Array, Array]:
    """Return where bars (m, w) must begin and end at least along them, to be developed in cells that need them."""
    share, place, (start, end) = field.excess / area, np.arange(len(field.excess))[:, None], field.runs
    none = share <= 0
    begin = np.where(none, len(share), np.maximum(place - share * anchorage, start))
    return begin, np.where(none, 0, np.minimum(place + 1 + share * anchorage, end))


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
