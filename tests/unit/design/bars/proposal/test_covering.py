"""Zones of additional bars: they cover any need, and one alone is the best of all rectangles."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.arrays import Array
from groundslab.design.bars.proposal.covering import Options, Zone, cover

#: Bars of 2, 4 and 8 cm2/m that are anchored over 1, 2 and 3 cells; others may lie between the light ones.
OPTIONS = Options(
    area=np.array([2e-4, 4e-4, 8e-4]),
    anchorage=np.array([1.0, 2.0, 3.0]),
    nestable=np.array([True, True, False]),
    inner=np.array([True, True, False]),
    least=(1, 1),
)

#: An area [m2/m] that is rounding: of 1e-6 cells of anchorage.
NOTHING = 1e-9


def developed(zones: list[Zone], shape: tuple[int, int], options: Options) -> Array:
    """Return the area [m2/m] of all zones that is anchored at the worse border of each cell, cell by cell."""
    there = np.zeros(shape)
    for zone in zones:
        i0, i1, j0, j1 = zone.cells
        for i, j in itertools.product(range(i0, i1), range(j0, j1)):
            before = np.inf if i0 == 0 else i - i0  # bars of U shape hold ends at edges
            after = np.inf if i1 == shape[0] else i1 - (i + 1)
            share = min(1.0, min(before, after) / options.anchorage[zone.option])
            there[i, j] += options.area[zone.option] * share
    return there


@st.composite
def fields(draw: st.DrawFn) -> Array:
    """Return what cells need beyond a base, up to 8 cm2/m, 0 in many of them."""
    m, w = draw(st.integers(1, 9)), draw(st.integers(1, 7))
    values = draw(st.lists(st.one_of(st.just(0), st.integers(1, 800)), min_size=m * w, max_size=m * w))
    return 1e-6 * np.array(values, dtype=float).reshape(m, w)


@settings(max_examples=150, deadline=None)
@given(excess=fields(), most=st.integers(1, 5), price=st.floats(0, 1e-3), every=st.integers(1, 3))
def test_any_need_is_covered(excess: Array, most: int, price: float, every: int) -> None:
    """No cell has less than it needs, there are no more zones than allowed, and their steel is area times cells."""
    options = Options(OPTIONS.area, OPTIONS.anchorage, OPTIONS.nestable, OPTIONS.inner, (1, 1), every)
    zones = cover(excess, options, most, price)
    assert zones is not None
    assert len(zones) <= most
    assert (developed(zones, excess.shape, options) >= excess - NOTHING).all()
    for zone in zones:
        i0, i1, j0, j1 = zone.cells
        assert 0 <= i0 < i1 <= excess.shape[0]
        assert 0 <= j0 < j1 <= excess.shape[1]
        assert i0 % every == 0
        assert i1 % every == 0 or i1 == excess.shape[0]
        assert zone.steel == pytest.approx(options.area[zone.option] * (i1 - i0) * (j1 - j0))


@settings(max_examples=60, deadline=None)
@given(excess=fields())
def test_one_zone_is_the_best_rectangle(excess: Array) -> None:
    """Of all rectangles and options that cover the need, tried one by one, none has less steel."""
    m, w = excess.shape
    zones = cover(excess, OPTIONS, 1, 0.0)
    assert zones is not None
    if not excess.any():
        assert zones == []
        return
    least = np.inf
    for i0, i1, j0, j1 in itertools.product(range(m), range(1, m + 1), range(w), range(1, w + 1)):
        for option in range(3) if i0 < i1 and j0 < j1 else ():
            zone = Zone((i0, i1, j0, j1), option, float(OPTIONS.area[option] * (i1 - i0) * (j1 - j0)))
            if (developed([zone], excess.shape, OPTIONS) >= excess - NOTHING).all():
                least = min(least, zone.steel)
    assert zones[0].steel == pytest.approx(least)


def test_more_zones_never_take_more_steel() -> None:
    """Of two peaks far from each other, one zone takes all between; two zones leave it out."""
    excess = np.zeros((30, 10))
    excess[3, 2] = excess[26, 7] = 4e-4
    one, two = (cover(excess, OPTIONS, most, 0.0) for most in (1, 2))
    assert one is not None
    assert two is not None
    # 4 cm2/m, 2 cells of anchorage at both ends of one cell: 5 cells long, one wide, twice
    assert sum(zone.steel for zone in two) == pytest.approx(2 * 5 * 4e-4)
    # from cell 1 to cell 28, 6 wide
    assert one[0].steel == pytest.approx(28 * 6 * 4e-4)


def test_zones_cost_their_price() -> None:
    """A zone more is taken only if it saves more than its price: here 28 x 6 - 2 x 5 cells of 4 cm2/m."""
    excess = np.zeros((30, 10))
    excess[3, 2] = excess[26, 7] = 4e-4
    saved = (28 * 6 - 2 * 5) * 4e-4
    for price, number in ((0.99 * saved, 2), (1.01 * saved, 1)):
        zones = cover(excess, OPTIONS, 4, price)
        assert zones is not None
        assert len(zones) == number


def test_none_where_no_bars_are_enough() -> None:
    """More than the largest area cannot be covered, nor anything without zones; nothing needs none."""
    assert cover(np.full((2, 2), 9e-4), OPTIONS, 3, 0.0) is None
    assert cover(np.full((2, 2), 1e-4), OPTIONS, 0, 0.0) is None
    assert cover(np.zeros((2, 2)), OPTIONS, 0, 0.0) == []


def test_a_light_zone_with_a_smaller_one_within() -> None:
    """A wide field of 2 cm2/m with a peak of 4 in one cell takes light bars all over and as many more at the peak."""
    excess = np.full((20, 20), 2e-4)
    excess[10, 10] = 4e-4
    zones = cover(excess, OPTIONS, 2, 0.0)
    assert zones is not None
    # all of the plan, and one cell with an anchorage of one cell before and after it
    assert sorted(zone.steel for zone in zones) == pytest.approx([3 * 2e-4, 400 * 2e-4])
