"""Legs of links lie where a hand calculation has them, off openings and edges, and are as many as the area needs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from shapely import Polygon, box
from shapely.geometry.base import BaseGeometry

from groundslab.arrays import Array
from groundslab.design.rules.punching_links.demand import Arrangement, LinkDemand, LinkRow, rounded_down, rounded_up
from groundslab.design.rules.punching_links.layout import LinkLayout, lay_links
from groundslab.errors import InputError, Issue

COLUMN = box(-0.2, -0.2, 0.2, 0.2)
SLAB = box(-3, -3, 3, 3)


def around(distance: float) -> Array:
    """Return the pieces of the perimeter around the column, 0.4 m x 0.4 m."""
    ring = np.array(COLUMN.buffer(distance, quad_segs=64).exterior.coords)
    return np.stack([ring[:-1], ring[1:]], axis=1)


def arrangement(options: Any, lines: Any, plan: BaseGeometry) -> Arrangement:
    """Return how links may be arranged in a slab of 0.5 m; what is asked of given ones is that of the codes."""
    return Arrangement(0.5, options, lines, plan, lambda _: (), lambda _: ())


def demand(rows: tuple[LinkRow, ...], plan: BaseGeometry = SLAB, most: float = 1.0) -> LinkDemand:
    """Return a demand for these rows at any diameter up to the largest."""

    def options(diameter: float) -> Iterator[tuple[LinkRow, ...]]:
        if diameter <= most:
            yield rows

    return LinkDemand("column", "C", (0.0, 0.0), "ULS", "by hand", arrangement(options, around, plan))


def test_legs_of_two_perimeters_are_those_of_a_hand_calculation() -> None:
    """Two perimeters of legs of 8 mm, 0.503 cm2 each, for 8.82 cm2.

    u = 1.6 + 2 pi 0.22 = 2.982 m takes 8.82 / 0.503 = 17.5 legs, 18 in fact, 166 mm apart; u = 1.6 + 2 pi 0.55 = 5.056
    m with legs at most 261 mm apart takes 19.4, 20. Each is 0.5 - 0.04 - 0.03 = 0.43 m long, all 38 weigh 6.45 kg.
    """
    rows = (LinkRow(0.22, 8.82e-4, 0.261), LinkRow(0.55, 8.82e-4, 0.261))
    layout = lay_links(demand(rows), [0.008], (0.04, 0.03))
    first, second = layout.perimeters
    assert [len(perimeter.places) for perimeter in layout.perimeters] == [18, 20]
    assert layout.counts == "18 + 20"
    assert (first.spacing, second.spacing) == pytest.approx((2.9823 / 18, 5.0558 / 20), abs=1e-4)
    assert first.provided == pytest.approx(18 * 0.50265e-4, rel=1e-4)
    assert (layout.leg, layout.radial) == pytest.approx((0.43, 0.33))
    assert layout.mass == pytest.approx(38 * 0.43 * 0.3946, rel=1e-3)  # 0.3946 kg/m
    for perimeter in layout.perimeters:
        line = Polygon(around(perimeter.distance)[:, 0]).exterior
        along = np.sort([line.project(place) for place in map(_point, perimeter.places)])
        assert np.diff(along) == pytest.approx(perimeter.spacing, abs=1e-6)
    # symmetric about the axes, as the column is
    assert first.places.sum(axis=0) == pytest.approx(0.0, abs=1e-3)


def test_diameter_with_the_least_steel_is_taken() -> None:
    """6 legs at least, by their distance: thin ones are enough for 2.5 cm2, and of the same mass the fewer legs."""
    rows = (LinkRow(0.22, 2.5e-4, 0.5), LinkRow(0.44, 2.5e-4, 0.8))
    assert lay_links(demand(rows), [0.008, 0.012], (0.04, 0.04)).diameter == 0.008
    # 8 mm would be closer than 100 mm: 18 cm2 are 36 legs on 2.98 m
    many = (LinkRow(0.22, 18e-4, 0.5),)
    layout = lay_links(demand(many), [0.008, 0.012], (0.04, 0.04))
    assert (layout.diameter, layout.number) == (0.012, 16)
    assert layout.radial is None


def test_no_leg_lies_in_an_opening_or_beyond_an_edge() -> None:
    """Those that remain are as many as the area needs, on both sides of an opening and beside an edge."""
    opening = box(0.3, -0.2, 0.7, 0.2)
    plan = SLAB.difference(opening).intersection(box(-3, -0.5, 3, 3))
    rows = (LinkRow(0.22, 6e-4, 0.3), LinkRow(0.44, 6e-4, 0.3))
    layout = lay_links(demand(rows, plan), [0.01], (0.05, 0.04))
    for perimeter in layout.perimeters:
        assert perimeter.provided >= perimeter.required
        assert perimeter.spacing <= perimeter.most_spacing
        assert perimeter.length < 1.6 + 2 * math.pi * perimeter.distance - 0.4
        for place in map(_point, perimeter.places):
            assert plan.contains(place)
            assert plan.boundary.distance(place) >= 0.05 + 0.005 - 1e-9
            assert COLUMN.distance(place) == pytest.approx(perimeter.distance, abs=1e-3)


def _layout_without(arrangement: Arrangement | str) -> LinkLayout:
    """Return the layout of an arrangement that leads to none."""
    layout = lay_links(LinkDemand("pile", "P", (0.0, 0.0), "ULS", "", arrangement), [0.008], (0.04, 0.04))
    assert (layout.number, layout.mass) == (0, 0.0)
    return layout


def test_reason_is_said_where_there_are_no_links() -> None:
    """A code that refuses them, a diameter too thick for the slab, legs too close, and no perimeter on the slab."""

    def nowhere(_: float) -> Array:
        raise InputError([Issue("column", "nothing", "some plate")])

    def one(_: float) -> Iterator[tuple[LinkRow, ...]]:
        yield (LinkRow(0.22, 50e-4, 0.5),)

    def none(_: float) -> Iterator[tuple[LinkRow, ...]]:
        yield from ()

    assert _layout_without("links do not help").why == "links do not help"
    assert "may be used" in _layout_without(arrangement(none, around, SLAB)).why
    assert "closer than 100 mm" in _layout_without(arrangement(one, around, SLAB)).why
    assert "some plate" in _layout_without(arrangement(one, nowhere, SLAB)).why
    assert "closer" in _layout_without(arrangement(one, around, box(5, 5, 6, 6))).why


def test_many_perimeters_are_counted_together() -> None:
    """The label names up to five counts, or how many of all."""
    rows = tuple(LinkRow(0.1 * n, 1e-4, 0.5) for n in range(2, 9))
    assert lay_links(demand(rows), [0.01], (0.04, 0.04)).counts.startswith("7 perimeters, ")
    same = tuple(LinkRow(0.1 * n, 4e-4, 2.0) for n in range(2, 5))
    assert lay_links(demand(same), [0.01], (0.04, 0.04)).counts == "3 x 6"


def test_distances_are_rounded_to_what_can_be_measured() -> None:
    """To 5 mm, and not by rounding errors."""
    assert (rounded_down(0.3315), rounded_down(0.33), rounded_up(0.1326), rounded_up(0.135)) == (
        0.33,
        0.33,
        0.135,
        0.135,
    )


def _point(place: Array) -> BaseGeometry:
    """Return a place as a point."""
    from shapely import Point

    return Point(place)
