"""Zones of additional bars cover any need, none lies over another, and no division by cuts is better."""

from __future__ import annotations

import itertools
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.arrays import Array
from groundslab.design.bars.proposal.covering import Field, Options, Zone, cover
from groundslab.design.bars.proposal.plan_grid import Window
from helpers.examples import examples

#: Bars of 2, 4 and 8 cm2/m that are anchored over 1, 2 and 3 cells.
OPTIONS = Options(area=np.array([2e-4, 4e-4, 8e-4]), anchorage=np.array([1.0, 2.0, 3.0]), least=(1, 1))
#: An area [m2/m] that is rounding: of 1e-6 cells of anchorage.
NOTHING = 1e-9
#: More blocks than cells: cuts are between any two cells.
ALL = 99


def field_of(excess: Array, every: int = 1, folded: tuple[bool, bool] = (False, False)) -> Field:
    """Return cells of 1 m2 that are all in the plan."""
    return Field(excess, np.ones_like(excess), every, folded)


def developed(cells: Window, option: int, inside: Array) -> Array:
    """Return the area [m2/m] of a zone that is anchored at the worse border of each cell, cell by cell.

    Ends at edges of the plan are held.
    """
    there = np.zeros(inside.shape)
    i0, i1, j0, j1 = cells
    for i, j in itertools.product(range(i0, i1), range(j0, j1)):
        if not inside[i, j]:
            continue
        before = next((i - k for k in range(i, i0 - 1, -1) if k == i0 and k > 0 and inside[k - 1, j]), np.inf)
        after = next((k - i - 1 for k in range(i + 1, i1 + 1) if k == i1 and k < len(inside) and inside[k, j]), np.inf)
        if not inside[i0 : i + 1, j].all():
            before = np.inf
        if not inside[i:i1, j].all():
            after = np.inf
        there[i, j] = OPTIONS.area[option] * min(1.0, min(before, after) / OPTIONS.anchorage[option])
    return there


@st.composite
def needs(draw: st.DrawFn, most: tuple[int, int] = (9, 7)) -> Array:
    """Return what cells need beyond a base, up to 8 cm2/m, 0 in many of them."""
    m, w = draw(st.integers(1, most[0])), draw(st.integers(1, most[1]))
    values = draw(st.lists(st.one_of(st.just(0), st.integers(1, 800)), min_size=m * w, max_size=m * w))
    return 1e-6 * np.array(values, dtype=float).reshape(m, w)


@settings(max_examples=examples(150), deadline=None)
@given(
    excess=needs(), most=st.integers(1, 9), price=st.floats(0, 1e-3), every=st.integers(1, 3), least=st.integers(1, 3),
    blocks=st.integers(2, 9), holes=st.lists(st.tuples(st.integers(0, 8), st.integers(0, 6)), max_size=4),
)  # fmt: skip
def test_any_need_is_covered_once(
    excess: Array, most: int, price: float, every: int, least: int, blocks: int, holes: list[tuple[int, int]]
) -> None:
    """No cell of a plan with holes has less than it needs, none lies in two zones, and there are not too many zones."""
    excess = np.pad(excess, ((0, -len(excess) % every), (0, 0)))
    inside = np.ones(excess.shape)
    for i, j in holes:
        inside[min(i, len(inside) - 1), min(j, inside.shape[1] - 1)] = 0
    excess = np.where(inside > 0, excess, 0.0)
    options = Options(OPTIONS.area, OPTIONS.anchorage, (least * every, least))
    zones = cover(Field(excess, inside, every), options, most, price, blocks)
    assert zones is not None
    assert sum(zone.count for zone in zones) <= most
    there = sum((developed(zone.cells, zone.option, inside) for zone in zones), np.zeros(excess.shape))
    assert (there >= excess - NOTHING).all()
    times = np.zeros(excess.shape)
    for zone in zones:
        i0, i1, j0, j1 = zone.cells
        assert 0 <= i0 < i1 <= excess.shape[0]
        assert 0 <= j0 < j1 <= excess.shape[1]
        assert i0 % every == 0
        assert i1 % every == 0
        assert i1 - i0 >= min(least * every, excess.shape[0])
        assert j1 - j0 >= min(least, excess.shape[1])
        assert zone.steel == pytest.approx(OPTIONS.area[zone.option] * inside[i0:i1, j0:j1].sum())
        times[i0:i1, j0:j1] += 1
    assert times.max() <= 1


def best_rectangle(excess: Array, window: Window) -> float:
    """Return the least steel of one zone in a window that covers the needs in it, of all rectangles and options."""
    inside, (a, b, c, d) = np.ones_like(excess), window
    within = np.zeros_like(excess)
    within[a:b, c:d] = excess[a:b, c:d]
    if not within.any():
        return 0.0
    least = np.inf
    for i0, i1 in itertools.combinations(range(a, b + 1), 2):
        for j0, j1 in itertools.combinations(range(c, d + 1), 2):
            for option, area in enumerate(OPTIONS.area):
                steel = area * (i1 - i0) * (j1 - j0)
                if steel < least and (developed((i0, i1, j0, j1), option, inside) >= within - NOTHING).all():
                    least = steel
    return float(least)


@settings(max_examples=examples(25), deadline=None)
@given(excess=needs((4, 4)), price=st.sampled_from([1e-3, 3e-4]))
def test_no_division_by_cuts_is_better(excess: Array, price: float) -> None:
    """Of all rectangles in all divisions by cuts from border to border, tried one by one, none takes less."""

    @cache
    def least(window: Window) -> float:
        a, b, c, d = window
        alone = best_rectangle(excess, window)
        found = [alone + price * (alone > 0)]
        found += [least((a, i, c, d)) + least((i, b, c, d)) for i in range(a + 1, b)]
        found += [least((a, b, c, j)) + least((a, b, j, d)) for j in range(c + 1, d)]
        return min(found)

    zones = cover(field_of(excess), OPTIONS, 99, price, ALL)
    assert zones is not None
    price_paid = sum(zone.steel + price for zone in zones)
    assert price_paid == pytest.approx(least((0, excess.shape[0], 0, excess.shape[1])))


def two_peaks() -> Array:
    """Return a need of 4 cm2/m in two cells far from each other."""
    excess = np.zeros((30, 10))
    excess[3, 2] = excess[26, 7] = 4e-4
    return excess


def test_zones_cost_their_price() -> None:
    """A zone more is taken only if it saves more than its price: here 28 x 6 - 2 x 5 cells of 4 cm2/m.

    4 cm2/m with 2 cells of anchorage at both ends of one cell: 5 cells long, one wide, twice; or from cell 1 to cell
    28, 6 wide.
    """
    saved = (28 * 6 - 2 * 5) * 4e-4
    for price, sizes in ((0.99 * saved, [5, 5]), (1.01 * saved, [28 * 6])):
        zones = cover(field_of(two_peaks()), OPTIONS, 4, price, ALL)
        assert zones is not None
        assert [zone.steel for zone in zones] == pytest.approx([4e-4 * size for size in sizes])
    # no more than one is allowed, whatever it saves
    (only,) = cover(field_of(two_peaks()), OPTIONS, 1, 0.0, ALL) or []
    assert only.steel == pytest.approx(28 * 6 * 4e-4)


def test_none_where_no_bars_are_enough() -> None:
    """More than the largest area cannot be covered, nor anything without zones; nothing needs none."""
    assert cover(field_of(np.full((2, 2), 9e-4)), OPTIONS, 3, 0.0, ALL) is None
    assert cover(field_of(np.full((2, 2), 1e-4)), OPTIONS, 0, 0.0, ALL) is None
    assert cover(field_of(np.zeros((2, 2))), OPTIONS, 0, 0.0, ALL) == []


def test_zones_go_on_over_the_middle_of_folded_cells() -> None:
    """A zone that begins at the middle is one with its image, and has its least size with it; another one is two.

    4 cm2/m at the middle and 2 cells of anchorage: 3 cells on each side; 8 cells off it 5 cells, of
    which 6 are laid, and as many there.
    """
    excess = np.zeros((30, 1))
    excess[0, 0] = excess[8, 0] = 4e-4
    folded = field_of(excess, folded=(True, False))
    options = Options(OPTIONS.area, OPTIONS.anchorage, (6, 1))
    zones = cover(folded, options, 3, 0.0, ALL)
    assert zones is not None
    assert sorted((zone.cells, zone.count) for zone in zones) == [((0, 3, 0, 1), 1), ((6, 12, 0, 1), 2)]
    (one,) = cover(folded, options, 2, 0.0, ALL) or []
    assert (one.cells, one.count) == ((0, 11, 0, 1), 1)


def test_bars_end_at_openings() -> None:
    """A need beside an opening has the zone end there, held, and beyond it none."""
    excess, inside = np.zeros((12, 1)), np.ones((12, 1))
    excess[4, 0], inside[5:8] = 4e-4, 0
    zones = cover(Field(excess, inside), OPTIONS, 1, 0.0, ALL)
    assert zones == [Zone((2, 5, 0, 1), 1, pytest.approx(3 * 4e-4), 1)]
