"""The pieces of perimeters: lengths, centers, moduli and second moments by hand, from the geometry."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import Point, box

from groundslab.arrays import Array
from groundslab.design.demands import line_properties
from groundslab.design.demands.perimeter_pieces import Piece, WeightedLegs, pieces_of, what_counts
from groundslab.design.demands.perimeters import outside
from groundslab.design.demands.zones.thinner_slab import ThinnerPart, depth_share, weighted

A = 0.8  # distance of the perimeters from the face [m]
X, Y = 0.2, 0.15  # half of the column's sides [m]
QUARTER = math.pi / 2 * A
AXES, ORIGIN = np.eye(2), np.zeros(2)
#: Chords are shorter than arcs by this share at most.
CHORDS = 3e-5


def around(x0: float = -X, y0: float = -Y, x1: float = X, y1: float = Y) -> Array:
    """Return the legs (l, 2, 2) around a rectangle at a distance A."""
    places = np.array(box(x0, y0, x1, y1).buffer(A, quad_segs=64).exterior.coords)[::-1]
    return np.stack([places[:-1], places[1:]], axis=1)


def within(legs: Array, x: float, y: float = math.inf) -> Array:
    """Return the legs on the slab that ends at x and y."""
    return outside(legs, box(-9, -9, 9, 9) - box(-9, -9, x, min(y, 9)))


def sums(pieces: list[Piece]) -> tuple[float, Array, Array, Array]:
    """Return length, center, moduli and second moments as a reader adds them up."""
    u = sum(piece.length for piece in pieces)
    center = sum(piece.length * piece.middle for piece in pieces) / u
    return u, center, sum(piece.moduli for piece in pieces), sum(piece.second for piece in pieces)


def arc_center(r: float) -> float:
    """Return how far the center of a quarter of a circle lies from both its radii."""
    return 2 * r / math.pi


def test_inside_there_are_four_sides_and_four_arcs() -> None:
    """W = c_1^2 / 2 + c_1 c_2 + 2 c_2 a + 4 a^2 + pi a c_1 (6.41, here at a instead of 2 d)."""
    legs = around()
    pieces = pieces_of((WeightedLegs(legs),), AXES, ORIGIN)
    straight = [piece for piece in pieces if piece.radius is None]
    arcs = [piece for piece in pieces if piece.radius is not None]
    assert sorted(piece.length for piece in straight) == pytest.approx([2 * Y, 2 * Y, 2 * X, 2 * X])
    assert [piece.length for piece in arcs] == pytest.approx([QUARTER] * 4, rel=CHORDS)
    assert [piece.radius for piece in arcs] == pytest.approx([A] * 4)
    u, center, W, _ = sums(pieces)
    c_1, c_2 = 2 * X, 2 * Y
    assert u == pytest.approx(2 * (c_1 + c_2) + 2 * math.pi * A, rel=CHORDS)
    assert center == pytest.approx([0.0, 0.0], abs=1e-12)
    by_clause = [c**2 / 2 + c * b + 2 * b * A + 4 * A**2 + math.pi * A * c for c, b in ((c_1, c_2), (c_2, c_1))]
    assert pytest.approx(by_clause, rel=2 * CHORDS) == W


def test_each_arc_has_the_center_and_the_modulus_of_a_quarter_of_a_circle() -> None:
    """At X + 2 a / pi and Y + 2 a / pi; int |e| dl is the length times that, as it lies on one side of the axis."""
    arcs = [piece for piece in pieces_of((WeightedLegs(around()),), AXES, ORIGIN) if piece.radius is not None]
    for arc in arcs:
        assert np.abs(arc.middle) == pytest.approx([X + arc_center(A), Y + arc_center(A)], rel=2 * CHORDS)
        assert arc.moduli == pytest.approx(arc.length * np.abs(arc.middle))
        # about its own radii a quarter has r^3 pi / 4, moved by X: + 2 X r^2 + X^2 r pi / 2
        I_1 = math.pi / 4 * A**3 + 2 * X * A**2 + X**2 * QUARTER
        assert arc.second[0, 0] == pytest.approx(I_1, rel=5 * CHORDS)


def test_at_an_edge_it_runs_straight_out() -> None:
    """An edge at s = 0.1 m right of the column, as Figure 6.15: three straight pieces and two arcs, in their order."""
    s = 0.1
    legs = within(around(x1=X + 3), X + s)
    pieces = pieces_of((WeightedLegs(legs),), AXES, ORIGIN)
    assert [piece.radius is None for piece in pieces] == [True, False, True, False, True]
    assert [piece.length for piece in pieces] == pytest.approx(
        [2 * X + s, QUARTER, 2 * Y, QUARTER, 2 * X + s], rel=CHORDS
    )
    assert np.abs(pieces[0].start) == pytest.approx([X + s, Y + A])
    assert np.abs(pieces[-1].end) == pytest.approx([X + s, Y + A])
    u, center, W, _ = sums(pieces)
    first = 2 * (2 * X + s) * s / 2 - 2 * QUARTER * (X + arc_center(A)) - 2 * Y * (X + A)
    assert center == pytest.approx([first / u, 0.0], rel=5 * CHORDS, abs=1e-12)
    # of axis 2 all lies on one side but for the side across, int |e| dl of which is 2 Y^2 / 2
    assert W[1] == pytest.approx(2 * (2 * X + s) * (Y + A) + 2 * QUARTER * (Y + arc_center(A)) + Y**2, rel=3 * CHORDS)


def test_at_a_corner_sums_are_those_of_the_whole() -> None:
    """Two straight pieces and one arc between them, by hand along x; the sums are those of the checks."""
    s = 0.1
    legs = within(around(x1=X + 3, y1=Y + 3), X + s, Y + s)
    pieces = pieces_of((WeightedLegs(legs),), AXES, ORIGIN)
    assert sorted(piece.length for piece in pieces) == pytest.approx(
        sorted([2 * X + s, QUARTER, 2 * Y + s]), rel=CHORDS
    )
    u, center, W, second = sums(pieces)
    first = (2 * X + s) * s / 2 - QUARTER * (X + arc_center(A)) - (2 * Y + s) * (X + A)
    assert center[0] == pytest.approx(first / u, rel=3 * CHORDS)
    assert (u, *center) == pytest.approx((line_properties.total_length(legs), *line_properties.centroid(legs)))
    assert pytest.approx(line_properties.moduli(legs, center)) == W
    assert second == pytest.approx(line_properties.second_moments(legs, center))


def test_an_opening_cuts_a_piece_in_two() -> None:
    """Between tangents at y = -0.1 m and 0.05 m nothing counts: of the right side 0.05 m and 0.1 m are left."""
    legs = outside(around(), box(0.5, -0.1, 2.0, 0.05))
    lengths = sorted(piece.length for piece in pieces_of((WeightedLegs(legs),), AXES, ORIGIN))
    assert lengths[:3] == pytest.approx([0.05, 0.1, 2 * Y])
    assert len(lengths) == 9


def test_around_a_round_column_it_is_one_circle() -> None:
    """All of it is one arc of the radius D / 2 + a."""
    places = np.array(Point(1.0, 2.0).buffer(0.25, quad_segs=64).buffer(A, quad_segs=64).exterior.coords)
    (piece,) = pieces_of((WeightedLegs(np.stack([places[:-1], places[1:]], axis=1)),), AXES, np.array([1.0, 2.0]))
    assert piece.radius == pytest.approx(0.25 + A, rel=1e-4)
    assert piece.length == pytest.approx(2 * math.pi * (0.25 + A), rel=1e-4)
    assert piece.moduli == pytest.approx([4 * (0.25 + A) ** 2] * 2, rel=1e-4)


def test_in_thinner_slab_a_share_of_a_piece_counts() -> None:
    """A square 2 m wide, 0.2 m thinner beyond x = 0.5 m with d = 0.5 m: there 0.6 counts of what begins anew."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)], dtype=float)
    legs = np.stack([corners[:-1], corners[1:]], axis=1)
    parts = weighted(legs, (ThinnerPart(0.2, 0.0, box(0.5, -2, 2, 2)),), depth_share, 1.0, 0.5)
    pieces = pieces_of(parts, AXES, ORIGIN)
    assert sorted((piece.share, round(piece.length, 9)) for piece in pieces) == [
        (0.6, 0.3), (0.6, 0.3), (0.6, 1.2), (1.0, 1.5), (1.0, 1.5), (1.0, 2.0),
    ]  # fmt: skip
    u, center, W, _ = sums(pieces)
    whole = what_counts(parts)
    assert (u, *center) == pytest.approx((line_properties.total_length(whole), *line_properties.centroid(whole)))
    assert pytest.approx(line_properties.moduli(whole, center)) == W


def test_places_are_along_the_axes_from_the_origin() -> None:
    """Axes turned by 90 degrees: what lies along x is along -2."""
    legs = np.array([[[1.0, 2.0], [3.0, 2.0]]])
    (piece,) = pieces_of((WeightedLegs(legs),), np.array([[0.0, 1.0], [-1.0, 0.0]]), np.array([1.0, 1.0]))
    assert piece.start == pytest.approx([1.0, 0.0])
    assert piece.end == pytest.approx([1.0, -2.0])
    assert piece.second == pytest.approx(np.diag([0.0, 2.0**3 / 12]))
    assert piece.along == pytest.approx(np.diag([0.0, 2.0]))
