"""Curves beside others: as far off as asked, mitered at corners, refused where there is no room."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from groundslab.geometry.offsets import NoRoomError, counterclockwise, inset
from groundslab.geometry.plan import Place, Ring, circle, rectangle

QUARTER = math.tan(math.pi / 8)
#: A rectangle with a quarter circle for a corner, a half circle bitten out of a side, a bay with arcs at no tangents.
ROUNDED = Ring(((0, 0), (4, 0), (4, 2), (3, 3), (0, 3)), (0, 0, QUARTER))
BITTEN = Ring(((0, 0), (2, 0), (4, 0), (6, 0), (6, 4), (0, 4)), (0, -1.0))
BAYS = Ring(((0, 0), (5, 0.5), (6, 4), (1, 5)), (0.2, -0.15, 0.3))
SLANTED = Ring(((0, 0), (4, -1), (6, 2), (3, 5), (-1, 3)))
L_SHAPE = Ring(((0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)))
#: Two halves with a neck between.
NECK = Ring(((0, 0), (4, 0), (4, 1.6), (6, 1.6), (6, 0), (10, 0), (10, 4), (6, 4), (6, 2.4), (4, 2.4), (4, 4), (0, 4)))
RINGS = {
    "rounded": ROUNDED,
    "bitten": BITTEN,
    "bays": BAYS,
    "slanted": SLANTED,
    "L": L_SHAPE,
    "circle": circle((1, 2), 3),
}


def reverse(ring: Ring) -> Ring:
    """Return the same curve in the other direction."""
    bulges = (*ring.bulges, *[0.0] * (len(ring.points) - len(ring.bulges)))
    return Ring(ring.points[::-1], tuple(-bulge for bulge in (*bulges[-2::-1], bulges[-1])))


@pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
@pytest.mark.parametrize("turned", [False, True])
def test_every_place_of_an_inset_is_as_far_inside(ring: Ring, turned: bool) -> None:
    """Measured to the curve, flattened finely: nowhere nearer, and just so far beside the middle of each edge."""
    distance = 0.3
    beside = inset(reverse(ring) if turned else ring, distance)
    assert beside.signed_area > 0
    fine = ring.polygon(1e-8)
    for edge in beside.segments():
        ways = np.linspace(0, 1, 11)
        distances = fine.exterior.distance(shapely.points(edge.at(ways)))
        assert shapely.contains(fine, shapely.points(edge.at(ways))).all()
        # at a corner that reenters it is farther from the corner than from the edges' lines
        assert distances.min() > distance - 1e-6
        assert distances[5] == pytest.approx(distance, abs=1e-6)


def test_edges_along_axes_stay_along_them() -> None:
    """To the last digit, as grids are made for these only."""
    ring = Ring(((0.1, 0.7), (6.3, 0.7), (7.1, 3.3), (0.1, 3.3)))
    for each in (ring, rectangle(-5.3, 5.3, -0.7, 3.1)):
        along = [edge.along_axis for edge in each.segments()]
        assert [edge.along_axis for edge in inset(each, 0.15).segments()] == along


def test_edges_counterclockwise_have_the_inside_to_their_left() -> None:
    """In their order, whichever way the curve runs."""
    for ring in (BITTEN, reverse(BITTEN)):
        edges = counterclockwise(ring)
        for given, edge in zip(ring.segments(), edges, strict=True):
            np.testing.assert_allclose(edge.middle, given.middle, atol=1e-12)
            here = np.array(edge.middle) + 1e-3 * edge.left(np.array([0.5]))[0]
            assert ring.polygon(1e-6).contains(shapely.Point(here))


@pytest.mark.parametrize(
    ("ring", "distance", "number"),
    [
        (rectangle(0, 6, 0, 1), 0.6, 2),
        (rectangle(0, 6, 0, 1), 0.5, 2),
        (circle((0, 0), 0.3), 0.3, 1),
        (ROUNDED, 1.2, 3),
        (NECK, 0.5, None),
    ],
)  # fmt: skip
def test_where_there_is_no_room_the_edge_is_named(ring: Ring, distance: float, number: int | None) -> None:
    """By its number, none where two parts of the curve meet."""
    with pytest.raises(NoRoomError) as refused:
        inset(ring, distance)
    assert refused.value.number == number


def test_corners_between_arcs_are_their_crossings() -> None:
    """Two half discs, of which the arcs beside have other ends: by Pythagoras."""
    lens = Ring(((-3.0, 0.0), (3.0, 0.0)), (0.5, 0.5))
    radius = 3 * (1 + 0.5**2) / (2 * 0.5)
    height = radius - 3 * 0.5  # of the centers above and below the chord
    corners: tuple[Place, ...] = inset(lens, 0.4).points
    half = math.sqrt((radius - 0.4) ** 2 - height**2)
    np.testing.assert_allclose(sorted(corners), [(-half, 0), (half, 0)], atol=1e-12)
