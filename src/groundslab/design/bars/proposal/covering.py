"""Rectangles of additional bars over cells that need some: which, and with what bars, so that the steel is least.

A zone's bars count in full as far from their ends as they are anchored, and in proportion before (EN 1992-1-1
9.2.1.3(3)). A cell that needs the share r of a zone's area must therefore be r l_b from the zone's ends, or at the edge
of the plan, where bars of U shape hold them.

To cover cells by a given number of rectangles of least weight is hard in general (NP-hard already for equal weights,
Culberson and Reckhow 1994). Here rectangles are cut in two where that saves most, again and again, as far as several
times the number allowed (guillotine cuts, as in Gilmore and Gomory 1965); then those are joined whose joint costs
least. Of the numbers on the way that are allowed each is tried further: the rectangle for which it saves most gets
lighter bars all over and a smaller rectangle of further bars within, as long as that saves steel. The best of all is
kept. The result is feasible and the same every time; it is not proved to be the least.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Flags, Integers

#: How far rectangles are cut beyond the number that is allowed.
FURTHER = 2
#: What counts as rounding, in cells.
ROUNDING = 1e-6
#: An area [m2/m] that is none.
TINY = 1e-12

#: First and last cell along and across the bars, the last one excluded.
Window = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True)
class Options:
    """The bars that a zone may have.

    Attributes
    ----------
    area : array (o,)
        [m2/m].
    anchorage : array (o,)
        Length that develops them, in cells.
    nestable, inner : array (o,)
        Whether others may lie between them, and whether they may lie between others.
    least : tuple of int
        Cells of a zone along and across, at least.
    every : int
        Zones end at multiples of so many cells along the bars.
    edge : float
        What a bar is longer where its zone ends at the edge of the plan, as it is held there, in cells.
    """

    area: Array
    anchorage: Array
    nestable: Flags
    inner: Flags
    least: tuple[int, int]
    every: int = 1
    edge: float = 0.0

    def only(self, option: int) -> Options:
        """Return one of the options."""
        one = slice(option, option + 1)
        return replace(
            self, area=self.area[one], anchorage=self.anchorage[one], nestable=self.nestable[one], inner=self.inner[one]
        )


@dataclass(frozen=True, slots=True)
class Zone:
    """A rectangle of additional bars: its cells, anchorage included, its option, and its steel [m2/m times cells]."""

    cells: Window
    option: int
    steel: float


@dataclass(frozen=True, slots=True)
class _Leaf:
    """What one zone covers: the cells that need it, and the zone."""

    needs: Window
    zone: Zone


def cover(excess: Array, options: Options, most: int, price: float) -> list[Zone] | None:
    """Return zones that cover the excess (m, w) [m2/m] of cells, along and across the bars; None if none can.

    Parameters
    ----------
    excess : array (m, w)
        What cells need beyond the base, 0 where that is enough.
    options : Options
        The bars that zones may have.
    most : int
        Zones at most.
    price : float
        What each zone costs besides its steel [m2/m times cells].
    """
    whole = _trim(excess, (0, excess.shape[0], 0, excess.shape[1]))
    if whole is None:
        return []
    first = _leaf(excess, whole, options)
    if most == 0 or np.isinf(first.zone.steel):
        return None
    leaves = [first]
    best = {1: leaves}  # by their number

    def keep() -> None:
        if len(leaves) <= most and (len(leaves) not in best or _steel(leaves) < _steel(best[len(leaves)])):
            best[len(leaves)] = list(leaves)

    cuts: dict[Window, tuple[float, _Leaf, _Leaf] | None] = {}
    while len(leaves) < max(most * FURTHER, most + 1):
        for leaf in leaves:
            if leaf.needs not in cuts:
                cuts[leaf.needs] = _best_cut(excess, leaf, options)
        split = [(cut[0], n) for n, leaf in enumerate(leaves) if (cut := cuts[leaf.needs]) is not None]
        if not split:
            break
        position = min(split)[1]
        cut = cuts[leaves[position].needs]
        assert cut is not None
        leaves = [*leaves[:position], *cut[1:], *leaves[position + 1 :]]
        keep()
    joints: dict[Window, _Leaf] = {}
    while len(leaves) > 1:
        leaves = _join(excess, leaves, options, joints)
        keep()
    nests: dict[Window, tuple[float, list[_Leaf]]] = {}
    tried = [_with_nests(excess, best[n], options, most, price, nests) for n in sorted(best)]
    return [leaf.zone for leaf in min(tried, key=lambda leaves: _steel(leaves) + price * len(leaves))]


def one_zone(excess: Array, options: Options) -> float:
    """Return the steel of the best zone over all cells that need bars [m2/m times cells], inf if there is none."""
    whole = _trim(excess, (0, excess.shape[0], 0, excess.shape[1]))
    return 0.0 if whole is None else _leaf(excess, whole, options).zone.steel


def _steel(leaves: list[_Leaf]) -> float:
    """Return the steel of zones."""
    return sum(leaf.zone.steel for leaf in leaves)


def _with_nests(
    excess: Array,
    leaves: list[_Leaf],
    options: Options,
    most: int,
    price: float,
    nests: dict[Window, tuple[float, list[_Leaf]]],
) -> list[_Leaf]:
    """Return zones with those replaced by a light one and a smaller one within that save most by it."""
    for leaf in leaves:
        if leaf.needs not in nests:
            nests[leaf.needs] = _nest(excess, leaf, options)
    savings = sorted((nests[leaf.needs][0], n) for n, leaf in enumerate(leaves))
    chosen = {n for more, n in savings[: max(most - len(leaves), 0)] if more + price < 0}
    return [part for n, leaf in enumerate(leaves) for part in (nests[leaf.needs][1] if n in chosen else [leaf])]


def _nest(excess: Array, leaf: _Leaf, options: Options) -> tuple[float, list[_Leaf]]:
    """Return the best pair of a light zone and a smaller one within in place of one zone, and its steel beyond that."""
    best: tuple[float, list[_Leaf]] = (np.inf, [leaf])
    i0, i1, j0, j1 = leaf.needs
    for option in np.flatnonzero(options.nestable & (options.area < options.area[leaf.zone.option])):
        light = options.only(int(option))
        outer = _leaf(np.minimum(excess, light.area[0]), leaf.needs, light)
        rest = np.zeros_like(excess)
        developed = _developed(outer.zone.cells, excess.shape[0], light)[i0:i1, None]
        rest[i0:i1, j0:j1] = np.maximum(excess[i0:i1, j0:j1] - developed * (1 + 1e-12), 0.0)
        window = _trim(rest, leaf.needs)
        if window is None:
            continue
        inner = _leaf(rest, window, replace(options, area=np.where(options.inner, options.area, TINY)))
        outer = replace(outer, zone=replace(outer.zone, option=int(option)))
        more = outer.zone.steel + inner.zone.steel - leaf.zone.steel
        if more < best[0]:
            best = more, [outer, inner]
    return best


def _developed(cells: Window, length: int, light: Options) -> Array:
    """Return the area (m,) [m2/m] of a zone's bars that counts in each cell along them."""
    place = np.arange(length)
    low, high = cells[:2]
    before = np.inf if low == 0 else place - low
    after = np.inf if high == length else high - place - 1
    distance = np.minimum(before, after) + np.zeros(length)
    counts = light.area[0] * np.clip(distance / light.anchorage[0], 0.0, 1.0)
    return np.asarray(np.where((place >= low) & (place < high), counts, 0.0))


def _trim(excess: Array, window: Window) -> Window | None:
    """Return the smallest window around the cells of a window that need bars, None if there are none."""
    i0, i1, j0, j1 = window
    needed = excess[i0:i1, j0:j1] > 0
    along, across = np.flatnonzero(needed.any(axis=1)), np.flatnonzero(needed.any(axis=0))
    if not len(along):
        return None
    return int(i0 + along[0]), int(i0 + along[-1] + 1), int(j0 + across[0]), int(j0 + across[-1] + 1)


@dataclass(frozen=True)
class _Spans:
    """How far each option's bars reach, (c, o) of c sets of cells.

    Attributes
    ----------
    low, high : array (c, o)
        The ends of what is to be covered, anchorage included, in cells; inf and -inf where nothing is needed.
    share : array (c, o)
        The largest share of the bars' area that is needed.
    """

    low: Array
    high: Array
    share: Array

    def grown(self, *, backwards: bool) -> _Spans:
        """Return the spans of all sets up to each one but the last; backwards, of all after each one but the last."""
        turn = slice(None, None, -1) if backwards else slice(None)
        kept = slice(1, None) if backwards else slice(None, -1)
        low, high, share = (
            of.accumulate(values[turn], axis=0)[turn][kept]
            for of, values in ((np.minimum, self.low), (np.maximum, self.high), (np.maximum, self.share))
        )
        return _Spans(low, high, share)


def _spans(profiles: Array, place: Integers, options: Options) -> _Spans:
    """Return the spans of profiles (c, m), what bars need along them in cells at places (m,) or (c, m)."""
    at = place[..., None]
    share = profiles[:, :, None] / options.area  # (c, m, o)
    none = share <= 0
    reach = share * options.anchorage
    low = np.where(none, np.inf, at - reach).min(axis=1)
    high = np.where(none, -np.inf, at + 1 + reach).max(axis=1)
    return _Spans(low, high, share.max(axis=1))


def _ends(spans: _Spans, length: int, width: Array, options: Options) -> tuple[Array, Integers, Integers, Integers]:
    """Return the steel, the option and the ends in cells of the best zone over each span, all (c,).

    The plan is so many cells long; width (c,) is that of the zones in cells. The steel is inf where no option is
    enough.
    """
    every = options.every
    low = np.maximum(np.floor((spans.low + ROUNDING) / every) * every, 0)
    high = np.minimum(np.ceil((spans.high - ROUNDING) / every) * every, length)
    size = np.minimum(np.maximum(high - low, options.least[0]), length)
    held = options.edge * ((low == 0).astype(float) + (high == length))
    steel = np.where(spans.share > 1 + 1e-12, np.inf, options.area * (size + held) * width[:, None])
    option = np.argmin(steel, axis=1)
    row = np.arange(len(steel))
    return steel[row, option], option, low[row, option].astype(int), high[row, option].astype(int)


def _leaf(excess: Array, needs: Window, options: Options) -> _Leaf:
    """Return the best zone over a window that is trimmed."""
    i0, i1, j0, j1 = needs
    m, w = excess.shape
    spans = _spans(excess[i0:i1, j0:j1].max(axis=1)[None], np.arange(i0, i1), options)
    width = np.array([min(max(j1 - j0, options.least[1]), w)])
    steel, option, low, high = _ends(spans, m, width, options)
    along = _at_least(int(low[0]), int(high[0]), options.least[0], m, options.every)
    across = _at_least(j0, j1, options.least[1], w, 1)
    return _Leaf(needs, Zone((*along, *across), int(option[0]), float(steel[0])))


def _at_least(low: int, high: int, least: int, length: int, every: int) -> tuple[int, int]:
    """Return an interval of at least so many cells around another one, within a length, at multiples of some cells."""
    least = min(least, length)
    if high - low >= least:
        return low, high
    low = max(low - (least - (high - low)) // (2 * every) * every, 0)
    high = min(max(high, low + least), length)
    return min(low, max(high - least, 0) // every * every), high


def _best_cut(excess: Array, leaf: _Leaf, options: Options) -> tuple[float, _Leaf, _Leaf] | None:
    """Return the cut of a rectangle in two after which the steel is least: how much more it is, and both parts."""
    i0, i1, j0, j1 = leaf.needs
    part = excess[i0:i1, j0:j1]
    candidates = []
    for axis in (0, 1):
        if part.shape[axis] > 1:
            steel = _cut(part, axis, leaf.needs, excess.shape, options)
            place = int(np.argmin(steel))
            candidates.append((float(steel[place]), axis, place + 1))
    if not candidates:
        return None
    _, axis, place = min(candidates)
    halves = ((i0, i0 + place, j0, j1), (i0 + place, i1, j0, j1)) if axis == 0 else (
        (i0, i1, j0, j0 + place), (i0, i1, j0 + place, j1))  # fmt: skip
    windows = [_trim(excess, half) for half in halves]
    parts = [_leaf(excess, window, options) for window in windows if window is not None]
    if len(parts) < 2:  # pragma: no cover - both borders of a trimmed window need bars
        return None
    return sum(half.zone.steel for half in parts) - leaf.zone.steel, parts[0], parts[1]


def _cut(part: Array, axis: int, needs: Window, shape: tuple[int, ...], options: Options) -> Array:
    """Return the steel (c,) of both zones over a window's cells (m, w) apart, for each cut across an axis."""
    place = np.arange(needs[0], needs[1])
    needed, w = part > 0, part.shape[1]
    if axis == 1:  # strips of whole bars
        spans, filled = _spans(part.T, place, options), needed.any(axis=0)
        first, last = np.where(filled, np.arange(w), w), np.where(filled, np.arange(w), -1)
    else:
        spans, filled = _spans(part.max(axis=1)[:, None], place[:, None], options), needed.any(axis=1)
        first = np.where(filled, needed.argmax(axis=1), w)
        last = np.where(filled, w - 1 - needed[:, ::-1].argmax(axis=1), -1)
    before = np.maximum.accumulate(last) - np.minimum.accumulate(first)
    after = np.maximum.accumulate(last[::-1])[::-1] - np.minimum.accumulate(first[::-1])[::-1]
    steel = [
        _ends(
            spans.grown(backwards=backwards), shape[0], np.minimum(np.maximum(of, options.least[1]), shape[1]), options
        )[0]
        for backwards, of in ((False, before[:-1] + 1), (True, after[1:] + 1))
    ]
    return steel[0] + steel[1]


def _join(excess: Array, leaves: list[_Leaf], options: Options, joints: dict[Window, _Leaf]) -> list[_Leaf]:
    """Return the leaves with those joined whose joint takes least more steel, and what lies within their rectangle."""
    steel = np.array([leaf.zone.steel for leaf in leaves])
    windows, inside = _around_pairs(np.array([leaf.needs for leaf in leaves]))
    for window in windows:
        key: Window = tuple(int(side) for side in window)  # type: ignore[assignment]
        if key not in joints:
            joints[key] = _leaf(excess, key, options)
    keys = [tuple(map(int, window)) for window in windows]
    more = np.array([joints[key].zone.steel for key in keys]) - inside @ steel  # type: ignore[index]
    best = int(np.argmin(more))
    return [leaf for leaf, gone in zip(leaves, inside[best], strict=True) if not gone] + [joints[keys[best]]]  # type: ignore[index]


def _around_pairs(needs: Integers) -> tuple[Integers, Flags]:
    """Return rectangles (p, 4) around each two of some (n, 4) that grow until they cut none; who is within (p, n)."""
    first, second = np.triu_indices(len(needs), 1)
    low, high = needs[:, ::2], needs[:, 1::2]
    start, end = np.minimum(low[first], low[second]), np.maximum(high[first], high[second])
    while True:
        inside = np.asarray(((low < end[:, None]) & (start[:, None] < high)).all(axis=2))
        grown_start = np.where(inside[:, :, None], low, start[:, None]).min(axis=1)
        grown_end = np.where(inside[:, :, None], high, end[:, None]).max(axis=1)
        if np.array_equal(grown_start, start) and np.array_equal(grown_end, end):
            return np.stack([start[:, 0], end[:, 0], start[:, 1], end[:, 1]], axis=1), inside
        start, end = grown_start, grown_end
