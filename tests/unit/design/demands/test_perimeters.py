"""Control perimeters against lengths found by hand; what openings leave of them; u_0 at the face."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.design.codes.en1992_2004.perimeters import face_length
from groundslab.design.codes.en1992_2004.punching import raised
from groundslab.design.demands.line_properties import centroid, moduli
from groundslab.design.demands.perimeters import (
    Footprint,
    Openings,
    RectangularColumn,
    RoundColumn,
    outline,
    perimeter,
    surroundings,
)
from groundslab.fem.mesh import Mesh
from helpers.plates import parted, plate_of, straight, without

SLAB = plate_of(straight(16, 12, 8.0, 6.0))
#: Circles are followed by chords, a little shorter than their arcs.
CHORDS = 5e-5


def u(column: Footprint, distance: float, plate=SLAB, reach: float = 0.0) -> float:
    """Return the length of a control perimeter."""
    return perimeter(plate, column, distance, Openings(reach)).u


def u_0(column: Footprint, d: float, plate=SLAB, reach: float = 0.0) -> float:
    """Return the length at the face."""
    return face_length(surroundings(plate, column, 0.0, Openings(reach)), d)


@pytest.mark.parametrize("distance", [0.0, 0.3, 1.0])
def test_around_an_inner_column(distance: float) -> None:
    """Far from edges: the column's own sides and a circle of the distance; round columns have a larger circle."""
    rectangle, circle = RectangularColumn(4, 3, 0.5, 0.3), RoundColumn(4, 3, 0.4)
    assert u(rectangle, distance) == pytest.approx(1.6 + 2 * np.pi * distance, rel=CHORDS)
    assert u(circle, distance) == pytest.approx(2 * np.pi * (0.2 + distance), rel=CHORDS)


@pytest.mark.parametrize("back", [0.0, 0.2, 0.5])
def test_an_edge_column(back: float) -> None:
    """Near an edge: straight out at a right angle from both sides, and two quarters of a circle (Figure 6.15)."""
    column = RectangularColumn(back + 0.2, 3, 0.4, 0.6)
    assert u(column, 0.7) == pytest.approx(0.6 + 2 * (0.4 + back) + np.pi * 0.7, rel=CHORDS)


@pytest.mark.parametrize("angle", [30.0, 45.0, -20.0, 120.0])
def test_a_column_at_an_angle(angle: float) -> None:
    """Far from edges as one along x and y; near an edge straight out from its outermost corners, by hand."""
    assert u(RectangularColumn(4, 3, 0.5, 0.3, angle), 0.7) == pytest.approx(1.6 + 2 * np.pi * 0.7, rel=CHORDS)
    a, b, back = 0.5, 0.3, 0.1
    c, s = abs(np.cos(np.radians(angle))), abs(np.sin(np.radians(angle)))
    wide, deep = c * a + s * b, s * a + c * b  # along the edge x = 0 it measures deep, across it wide
    column = RectangularColumn(back + wide / 2, 3, a, b, angle)
    # the two sides that look inwards; the outermost corners lie opposite, so that their distances to the edge add up to
    # twice that of the center
    out = 2 * (back + wide / 2)
    assert u(column, 0.7) == pytest.approx(out + a + b + np.pi * 0.7, rel=CHORDS)
    # the corner nearest to the edge is at `back`: at the face 3 d + the width along the edge + twice the setback
    assert u_0(column, 0.05) == pytest.approx(deep + 2 * back + 0.15, rel=1e-9)
    assert u_0(column, 0.5) == pytest.approx(min(2 * (a + b), out + a + b), rel=1e-9)


def test_square_corners_of_a_column_at_an_angle() -> None:
    """By ACI 318 sides run parallel to the column's at the distance: b_o = 2 (a + b) + 8 distances."""
    line = perimeter(SLAB, RectangularColumn(4, 3, 0.5, 0.3, 25.0), 0.2, square=True, near=np.inf)
    assert line.u == pytest.approx(1.6 + 8 * 0.2, rel=1e-9)


def test_the_shadow_of_an_opening_at_a_column_at_an_angle() -> None:
    """At 45 degrees the perimeter before an opening is an arc about the corner, which the tangents cut by the sines."""
    plate = plate_of(without(straight(16, 12, 8.0, 6.0), (6.0, 7.0), (2.5, 3.5)))
    column, distance = RectangularColumn(4, 3, 0.4, 0.4, 45.0), 0.5
    whole, theta, corner = 1.6 + 2 * np.pi * distance, np.arctan(0.5 / 2), 0.2 * np.sqrt(2)
    half = theta + np.arcsin(corner * np.sin(theta) / distance)
    assert u(column, distance, plate, reach=1.6) == pytest.approx(whole, rel=CHORDS)
    assert u(column, distance, plate, reach=1.8) == pytest.approx(whole - 2 * half * distance, rel=CHORDS)


def test_a_corner_column() -> None:
    """Near a corner: out to both edges and a quarter of a circle between."""
    column = RectangularColumn(8 - 0.3, 6 - 0.4, 0.4, 0.6)
    assert u(column, 0.7) == pytest.approx((0.4 + 0.1) + (0.6 + 0.1) + np.pi / 2 * 0.7, rel=CHORDS)


def test_the_shorter_perimeter_counts() -> None:
    """Long before the distance reaches the edge, running out to it is longer or shorter; the shorter one is taken."""
    column, distance = RectangularColumn(4, 1.1, 0.4, 0.4), 1.0
    back = 1.1 - 0.2  # the offset is cut off by the edge, by arcs that reach 0.1 beyond it
    offset = 1.6 + 2 * np.pi * distance - (0.4 + 2 * np.arccos(back / distance) * distance)
    straight_out = 0.4 + 2 * (0.4 + back) + np.pi * distance
    assert straight_out < offset
    assert u(column, distance) == pytest.approx(straight_out, rel=CHORDS)
    wide = RectangularColumn(4, 1.25, 0.4, 0.4)  # the offset ends 0.05 before the edge, which is not near
    assert u(wide, 1.0) == pytest.approx(1.6 + 2 * np.pi, rel=CHORDS)


@pytest.mark.parametrize("square", [False, True])
@pytest.mark.parametrize("back", [0.1, 0.19, 0.21, 0.3, 0.4, 0.6, 0.9])
def test_a_column_set_back_farther_than_the_distance(back: float, square: bool) -> None:
    """The least of all around, out to an edge, and out to a corner: nothing jumps where the setback is the distance."""
    distance, c = 0.2, 0.4
    corner = 2 * distance if square else np.pi / 2 * distance
    closed, edge = 4 * (c + corner), c + 2 * (c + back) + 2 * corner
    at_edge = perimeter(SLAB, RectangularColumn(back + c / 2, 3, c, c), distance, square=square, near=np.inf)
    assert at_edge.u == pytest.approx(min(closed, edge), rel=CHORDS)
    both = RectangularColumn(back + c / 2, back + c / 2, c, c)
    at_corner = perimeter(SLAB, both, distance, square=square, near=np.inf)
    assert at_corner.u == pytest.approx(min(closed, edge, 2 * (c + back) + corner), rel=CHORDS)


def test_between_two_edges() -> None:
    """Across a plate as narrow as the perimeter only two straight lines from edge to edge are left."""
    narrow = plate_of(straight(16, 4, 8.0, 1.0))
    assert u(RectangularColumn(4, 0.5, 0.4, 0.4), 0.6, narrow) == pytest.approx(2.0, rel=1e-9)


def test_free_edges_do_not_count() -> None:
    """A perimeter that runs along the plate's edge is not counted there."""
    column = RectangularColumn(0.2, 3, 0.4, 0.6)
    assert u(column, 0.0) == pytest.approx(0.6 + 2 * 0.4, rel=1e-9)


def test_cut_off_at_an_opening() -> None:
    """What of the perimeter lies in an opening is missing; no point of the legs lies in it or on its rim."""
    plate = plate_of(without(straight(16, 12, 8.0, 6.0), (4.5, 6.0), (2.5, 3.5)))
    column, distance = RoundColumn(4, 3, 0.4), 0.8
    angle = np.arcsin(0.5)  # the circle of radius 1 meets the opening's sides y = 2.5 and 3.5
    assert u(column, distance, plate) == pytest.approx(2 * np.pi - 2 * angle, rel=CHORDS)


def test_openings_that_leave_strips_are_edges() -> None:
    """At the corner of a frame, or between long shafts, perimeters at 2 d cut strips; nearer ones lose no shadow.

    Between the shafts they run all around; at the corner, 0.2 m from two edges and the opening, out to both edges.
    """
    d = 0.5
    frame = plate_of(without(straight(44, 34, 8.8, 6.8), (0.8, 8.0), (0.8, 6.0)))
    corner = RectangularColumn(0.4, 0.4, 0.4, 0.4)
    near, far = (perimeter(frame, corner, a, Openings(6 * d, widened=True)) for a in (0.25, 2 * d))
    assert (near.cut, near.u) == (False, pytest.approx(2 * 0.6 + np.pi / 2 * 0.25, rel=CHORDS))
    assert far.cut
    shafts = without(without(straight(40, 40, 8.0, 8.0), (2.6, 3.4), (1.0, 7.0)), (4.6, 5.4), (1.0, 7.0))
    between = RectangularColumn(4.0, 4.0, 0.4, 0.4)
    near, far = (perimeter(plate_of(shafts), between, a, Openings(6 * d, widened=True)) for a in (0.25, 2 * d))
    assert (near.cut, near.u) == (False, pytest.approx(1.6 + 2 * np.pi * 0.25, rel=CHORDS))
    assert far.cut


def test_openings_that_leave_no_strips_take_off_their_shadow() -> None:
    """Between short shafts a perimeter at 2 d passes their ends, and loses what lies between the tangents to both."""
    d = 0.5
    shafts = without(without(straight(40, 40, 8.0, 8.0), (2.6, 3.4), (3.6, 4.4)), (4.6, 5.4), (3.6, 4.4))
    between = RectangularColumn(4.0, 4.0, 0.4, 0.4)
    near, far = (perimeter(plate_of(shafts), between, a, Openings(6 * d)) for a in (0.25, 2 * d))
    assert not near.cut
    assert not far.cut
    # tangents at y / x = 0.4 / 0.6 cut the arcs about the column's corners where 0.2 + a sin = (0.2 + a cos) 2 / 3
    for line, a in ((near, 0.25), (far, 1.0)):
        tangent = np.arctan(2 / 3)
        angle = tangent - np.arcsin(0.2 / 3 / a * np.cos(tangent))
        assert line.u == pytest.approx(2 * (0.4 + 2 * a * (np.pi / 2 - angle)), rel=CHORDS)


@pytest.mark.parametrize("distance", [0.3, 0.5])
def test_an_opening_in_front_of_a_column_at_an_edge_is_no_side_of_a_strip(distance: float) -> None:
    """At 2 d it parts the perimeter in two that turn by less than 90 degrees each; its tangents count all the same.

    The opening, 0.4 m wide, is 0.6 m from the column, 0.8 m from its center: of the side in front of it, 0.2 m + a from
    the center, 2 (0.2 + a) / 4 are between the tangents.
    """
    plate = plate_of(without(straight(40, 30, 8.0, 6.0), (3.8, 4.2), (1.0, 1.4)))
    column = RectangularColumn(4.0, 0.2, 0.4, 0.4)
    line = perimeter(plate, column, distance, Openings(6 * 0.35))
    whole = 3 * 0.4 + np.pi * distance
    assert line.u == pytest.approx(whole - (0.2 + distance) / 2, rel=CHORDS)
    assert not line.cut


@pytest.mark.slow
def test_the_shadow_of_an_opening() -> None:
    """Within six depths of the column, what lies between the tangents to an opening does not count (Figure 6.14)."""
    plate = plate_of(without(straight(16, 12, 8.0, 6.0), (6.0, 7.0), (2.5, 3.5)))
    column, distance = RoundColumn(4, 3, 0.4), 0.5
    whole = 2 * np.pi * 0.7
    assert u(column, distance, plate, reach=1.7) == pytest.approx(whole, rel=CHORDS)
    assert u(column, distance, plate, reach=1.9) == pytest.approx(whole - 2 * np.arctan(0.5 / 2) * 0.7, rel=CHORDS)
    assert perimeter(plate, column, distance, Openings(1.9)).length == pytest.approx(whole, rel=CHORDS)


def test_the_border_of_two_sections_is_no_edge() -> None:
    """A change of thickness within the perimeter changes nothing of it, and the plate's outline is one rectangle."""
    plate = plate_of(parted(straight(16, 12, 8.0, 6.0), 4.0)[0])
    assert outline(plate).area == pytest.approx(48.0)
    assert outline(plate).length == pytest.approx(28.0)
    assert u(RoundColumn(4, 3, 0.4), 0.5, plate) == pytest.approx(2 * np.pi * 0.7, rel=CHORDS)


def test_a_round_plate() -> None:
    """On a plate whose edge is curved, one element with sides that are parabolas, the outline follows them."""
    corner, middle = (
        np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]),
        np.array([[0, -1.4], [1.4, 0], [0, 1.4], [-1.4, 0]]),
    )
    plate = plate_of(Mesh(np.vstack([corner, middle, [[0, 0]]]), np.arange(9)[None]))
    assert outline(plate).area == pytest.approx(4 + 4 * 2 / 3 * 2 * 0.4, rel=5e-3)
    assert u(RoundColumn(0, 0, 0.5), 0.5, plate) == pytest.approx(2 * np.pi * 0.75, rel=CHORDS)


def test_length_at_the_face_by_hand() -> None:
    """u_0 of 6.4.5(3): all around inside, c_2 + 3 d <= c_2 + 2 c_1 at an edge, 3 d <= c_1 + c_2 at a corner."""
    assert u_0(RectangularColumn(4, 3, 0.5, 0.3), 0.2) == pytest.approx(1.6)
    assert u_0(RoundColumn(4, 3, 0.4), 0.2) == pytest.approx(np.pi * 0.4, rel=CHORDS)
    # at the edge x = 0: c_2 = 0.6 along it, c_1 = 0.4 across
    edge = RectangularColumn(0.2, 3, 0.4, 0.6)
    assert u_0(edge, 0.2) == pytest.approx(0.6 + 0.6)
    assert u_0(edge, 0.5) == pytest.approx(0.6 + 0.8)
    along = RectangularColumn(4, 0.2, 0.6, 0.4)
    assert u_0(along, 0.2) == pytest.approx(0.6 + 0.6)
    corner = RectangularColumn(0.2, 0.3, 0.4, 0.6)
    assert u_0(corner, 0.2) == pytest.approx(0.6)
    assert u_0(corner, 0.5) == pytest.approx(1.0)


@pytest.mark.parametrize(("c_1", "c_2", "d"), [(0.4, 0.4, 0.3), (0.3, 0.6, 0.25), (0.8, 0.3, 0.2)])
def test_modulus_of_a_rectangle(c_1: float, c_2: float, d: float) -> None:
    """W_1 of an inner column is c_1^2 / 2 + c_1 c_2 + 4 c_2 d + 16 d^2 + 2 pi d c_1 (EN 1992-1-1 (6.41))."""
    legs = perimeter(SLAB, RectangularColumn(4, 3, c_1, c_2), 2 * d).legs
    center = centroid(legs)
    assert center == pytest.approx([4, 3], abs=1e-9)
    for along, first, second in ((0, c_1, c_2), (1, c_2, c_1)):
        wanted = first**2 / 2 + first * second + 4 * second * d + 16 * d**2 + 2 * np.pi * d * first
        assert moduli(legs, center)[along] == pytest.approx(wanted, rel=2e-4)


def test_beta_of_a_round_column() -> None:
    """Beta = 1 + 0.6 pi e / (D + 4 d) (EN 1992-1-1 (6.42)) of an inner round column, whatever the force."""
    D, d, e, V = 0.5, 0.3, 0.1, 7e5
    line = perimeter(SLAB, RoundColumn(4, 3, D), 2 * d)
    W = moduli(line.legs, centroid(line.legs))
    raised_by = raised((V * e, 0.0), (0.6, 0.6), V, line.u, W) / V
    assert raised_by == pytest.approx(1 + 0.6 * np.pi * e / (D + 4 * d), rel=2e-4)


def test_center_of_an_edge_column() -> None:
    """Of three sides a by b the centroid lies at b^2 / (2 b + a) from the side that is alone."""
    legs = perimeter(SLAB, RectangularColumn(0.3, 3, 0.6, 0.8), 0.0).legs
    assert centroid(legs) == pytest.approx([0.6 - 0.6**2 / (2 * 0.6 + 0.8), 3])


def at_corner(s_x: float, s_y: float) -> RectangularColumn:
    """Return a column of 0.4 m x 0.6 m set back from the edges at a corner."""
    return RectangularColumn(0.2 + s_x, 0.3 + s_y, 0.4, 0.6)


@pytest.mark.parametrize("d", [0.15, 0.3, 0.6])
def test_length_at_the_face_grows_steadily_with_the_setback(d: float) -> None:
    """u_0 of a column that moves inside by steps of 10 mm grows by 10 mm for each leg, up to its periphery: no jump."""
    edge = [u_0(RectangularColumn(0.2 + s, 3, 0.4, 0.6), d) for s in np.arange(0, 1.0, 0.01)]
    corner = [u_0(at_corner(s, s), d) for s in np.arange(0, 1.0, 0.01)]
    assert edge[0] == pytest.approx(0.6 + min(0.8, 3 * d))
    assert corner[0] == pytest.approx(min(1.0, 3 * d))
    for lengths in (edge, corner):
        steps = np.diff(lengths)
        assert lengths[-1] == pytest.approx(2.0)
        assert (steps > -1e-9).all()
        assert steps.max() == pytest.approx(0.02, abs=1e-6)


def test_length_at_the_face_of_a_column_set_back_by_hand() -> None:
    """0.1 m inside both edges: 3 d + 0.2 m, not the whole 2 m; at one edge c_2 + 3 d + 0.2 m."""
    assert u_0(at_corner(0.1, 0.1), 0.2) == pytest.approx(0.6 + 0.2)
    assert u_0(RectangularColumn(0.3, 3, 0.4, 0.6), 0.2) == pytest.approx(0.6 + 0.6 + 0.2)
    assert u_0(RoundColumn(0.3, 3, 0.4), 0.5) == pytest.approx(np.pi * 0.2 + 2 * 0.3, rel=1e-3)
    assert u_0(RoundColumn(0.2, 3, 0.4), 0.1) == pytest.approx(0.4 + 0.3)


def test_an_opening_at_the_face() -> None:
    """The part of a face between the tangents to an opening does not count at the column either."""
    plate = plate_of(without(straight(16, 12, 8.0, 6.0), (4.5, 5.5), (2.5, 3.5)))
    column = RectangularColumn(4.0, 3.0, 0.4, 0.4)
    assert u_0(column, 0.3, plate, reach=1.8) == pytest.approx(1.6 - 0.4)


def test_an_opening_longer_along_its_ray_counts_as_wider() -> None:
    """Figure 6.14: l_2 becomes (l_1 l_2)^(1/2) where l_1 along the ray is longer; not where it is shorter."""
    plate = plate_of(without(straight(16, 12, 8.0, 6.0), (6.0, 7.5), (2.5, 3.5)))
    column, whole = RoundColumn(4, 3, 0.4), 2 * np.pi * 0.7
    half = np.sqrt(1.5 * 1.0) / 2
    narrow, wide = (perimeter(plate, column, 0.5, Openings(1.9, widened=widened)).u for widened in (False, True))
    assert narrow == pytest.approx(whole - 2 * np.arctan(0.5 / 2) * 0.7, rel=CHORDS)
    assert wide == pytest.approx(whole - 2 * np.arctan(half / 2) * 0.7, rel=CHORDS)


def test_an_opening_that_reaches_around_the_column() -> None:
    """An L around a corner of the column, which fills more than half of the view, takes off as much."""
    mesh = without(without(straight(32, 24, 8.0, 6.0), (4.5, 4.75), (1.0, 4.5)), (1.5, 4.75), (4.25, 4.5))
    column = RoundColumn(4.0, 3.0, 0.4)
    line = perimeter(plate_of(mesh), column, 0.2, Openings(2.0))
    low, high = np.arctan2(-2.0, 0.5), np.pi - np.arctan2(1.25, 2.5)
    assert line.u == pytest.approx((2 * np.pi - (high - low)) * 0.4, rel=1e-4)


@pytest.mark.parametrize(("length_x", "length_y", "expected"), [(2.0, 2.0, np.pi * (1.0 + 0.6)), (8.0, 1.58, 2 * 1.58)])
def test_a_perimeter_on_a_pad_is_closed_where_it_lies_on_it(length_x: float, length_y: float, expected: float) -> None:
    """0.3 m around 1 m: pi (1 + 0.6) m on a pad of 2 m, though straight cuts are shorter; cuts of 1.58 m on a strip."""
    plate = plate_of(straight(8, 8, length_x, length_y))
    line = perimeter(plate, RoundColumn(length_x / 2, length_y / 2, 1.0), 0.3, near=0.6)
    assert line.u == pytest.approx(expected, rel=CHORDS)


def test_a_perimeter_on_a_pad_runs_out_to_the_nearer_edge() -> None:
    """0.15 m off the middle of a pad of 2 m: half around, and two legs of 0.85 m to the nearer edge, which is shorter.

    0.3 m around 1 m all around are pi (1 + 0.6) = 5.03 m; half of it and the legs are 4.21 m, a cut across 2 m.
    """
    plate = plate_of(straight(8, 8, 2.0, 2.0))
    line = perimeter(plate, RoundColumn(0.85, 1.0, 1.0), 0.3, near=0.6)
    assert line.u == pytest.approx(np.pi * 0.8 + 2 * 0.85, rel=CHORDS)


def test_on_a_tapered_strip_the_sides_cut_perimeters() -> None:
    """Around a column 0.8 m from the end of a strip that narrows from 3 m to 1.8 m over 6 m.

    0.1 m from it a perimeter runs all around. 1.5 m from it the sides cut off the arcs: what is left, though it turns
    by more than 45 degrees, cuts the strip.
    """
    tapered = straight(24, 12, 6.0, 3.0)
    x, y = tapered.nodes.T
    plate = plate_of(Mesh(np.column_stack([x, (y - 1.5) * (1 - 0.4 * x / 6)]), tapered.elements))
    column = RectangularColumn(5.2, 0.0, 0.4, 0.4)
    near, far = (perimeter(plate, column, a) for a in (0.1, 1.5))
    assert (near.cut, near.u) == (False, pytest.approx(1.6 + 2 * np.pi * 0.1, rel=CHORDS))
    assert far.cut
