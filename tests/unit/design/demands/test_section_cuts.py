"""Sections, cuts and strips read from fields that are formulas: what is read must be what the formulas say."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, box

from groundslab.design.demands.cuts.section_cuts import cut_along, strip
from groundslab.design.demands.design_moments import wood_armer
from groundslab.errors import InputError
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import PlateResult
from helpers.cuts import cut_plate
from helpers.examples import examples
from helpers.plates import crooked, parted, plate_of, straight, without

FORMULAS = {
    "settlement": lambda x, y: 1e-3 * (3 - x + x * y),
    "moment_x": lambda x, y: 4 - x**2 + x * y,
    "moment_y": lambda x, y: 1 + 0.5 * y**2 - x,
    "moment_xy": lambda x, y: x * y - 2,
    "shear_x": lambda x, y: -2 * x + y,
    "shear_y": lambda x, y: x - 0.3 * y**2,
}
PLATE = plate_of(crooked(), **FORMULAS)
PLACES = st.tuples(st.floats(-1, 7).map(lambda v: round(v, 2)), st.floats(-1, 5).map(lambda v: round(v, 2)))


def stepped() -> PlateResult:
    """Return a plate whose moment m_x is 1 left of x = 2 and 5 right of it."""
    mesh, right = parted(straight(), 2.0)
    return plate_of(mesh, moment_x=np.where(right, 5.0, 1.0), settlement=lambda x, _: x)


def by_hand(a: np.ndarray, b: np.ndarray) -> tuple[float, float, float]:
    """Return int m_n, int q_n and the length on the 6 x 4 rectangle, from tensors and Gauss on the line."""
    on = LineString([a, b]).intersection(box(0, 0, 6, 4))
    (a, b), length = np.array(on.coords), on.length
    t = (b - a) / length
    n = np.array([t[1], -t[0]])
    points, weights = np.polynomial.legendre.leggauss(6)
    x, y = (a + (points[:, None] + 1) / 2 * (b - a)).T
    f = {name: formula(x, y) for name, formula in FORMULAS.items()}
    M = np.array([[f["moment_x"], f["moment_xy"]], [f["moment_xy"], f["moment_y"]]])
    Q = np.array([f["shear_x"], f["shear_y"]])
    ds = weights * length / 2
    return (
        np.einsum("i,ijp,j,p", n, M, n, ds),
        np.einsum("i,ip,p", n, Q, ds),
        length,
    )


@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(a=PLACES, b=PLACES)
def test_a_cut_integrates_quadratic_fields_exactly(a: tuple, b: tuple) -> None:
    """On crooked elements, which hold quadratics exactly, forces and length are those of the formulas."""
    on = LineString([a, b]).intersection(box(0, 0, 6, 4))
    if on.length < 0.1:
        return
    found = cut_plate(PLATE, a, b)
    np.testing.assert_allclose(found, by_hand(np.array(a), np.array(b)), atol=1e-5)


@pytest.mark.slow
@settings(max_examples=examples(40), deadline=None, derandomize=True)
@given(a=PLACES, b=PLACES, part=st.floats(0.2, 0.8))
def test_a_cut_from_behind_and_in_two(a: tuple, b: tuple, part: float) -> None:
    """Seen from the other end shear turns its sign, the moment does not; the forces of two halves add up."""
    if LineString([a, b]).intersection(box(0, 0, 6, 4)).length < 0.1:
        return
    whole, back = cut_plate(PLATE, a, b), cut_plate(PLATE, b, a)
    np.testing.assert_allclose([back.moment, -back.shear], [whole.moment, whole.shear], 1e-6)
    middle = tuple((1 - part) * np.array(a) + part * np.array(b))
    halves = []
    for ends in ((a, middle), (middle, b)):
        try:
            halves.append(cut_plate(PLATE, *ends))
        except InputError:
            continue  # this half lies beside the plate
    for name in ("moment", "shear", "length"):
        assert sum(getattr(half, name) for half in halves) == pytest.approx(getattr(whole, name), abs=1e-5)


def test_a_cut_towards_y_has_x_as_its_normal() -> None:
    """The convention of the normal: a cut upwards gives m_x and q_x; one to the left m_y and q_y."""
    plate = plate_of(
        straight(),
        moment_x=1.0,
        moment_y=2.0,
        shear_x=4.0,
        shear_y=5.0,
    )
    up = cut_plate(plate, (2.5, -1), (2.5, 5))
    assert up == pytest.approx((1 * 4, 4 * 4, 4))
    left = cut_plate(plate, (7, 2.5), (-1, 2.5))
    assert left == pytest.approx((2 * 6, 5 * 6, 6))


def test_a_cut_counts_the_plate_only() -> None:
    """The length and the forces of a cut through an opening are those of what is left of the plate."""
    plate = plate_of(without(straight(), (2, 4), (1, 3)), moment_x=2.0)
    found = cut_plate(plate, (2.5, 0), (2.5, 4))
    assert (found.length, found.moment) == pytest.approx((2.0, 4.0))


def test_either_side_of_a_change_of_section() -> None:
    """A cut moved by a millionth of its length to one side of the border takes that side's moments."""
    assert cut_plate(stepped(), (2 - 4e-6, 0), (2 - 4e-6, 4)).moment == pytest.approx(4 * 1.0)
    assert cut_plate(stepped(), (2 + 4e-6, 0), (2 + 4e-6, 4)).moment == pytest.approx(4 * 5.0)


@pytest.mark.parametrize("spacing", [None, 0.1, 0.37, 1.0, 50.0])
def test_a_section_reads_every_field(spacing: float | None) -> None:
    """At all samples every field is its formula; s is the length on the way, and it ends where the line ends."""
    points = np.array([[0.2, 0.3], [5.5, 1.1], [3.0, 3.9]])
    found = cut_along(PLATE, points, spacing)
    assert found.values.keys() == PLATE_FIELDS.keys()
    for name, formula in FORMULAS.items():
        np.testing.assert_allclose(found.values[name], formula(found.x, found.y), atol=1e-8)
    assert (np.diff(found.s) >= 0).all()
    first = np.hypot(*(points[1] - points[0]))
    on_first = found.s <= first
    np.testing.assert_allclose(
        np.hypot(found.x - points[0, 0], found.y - points[0, 1])[on_first], found.s[on_first], atol=1e-9
    )
    corner = np.flatnonzero(np.isclose(found.s, first))
    assert len(corner) == 1
    np.testing.assert_allclose([found.x[-1], found.y[-1]], points[2], atol=1e-9)
    assert found.parts() == [slice(0, len(found.s))]


def test_stations_of_a_section() -> None:
    """With a spacing the samples stand at its multiples, once each, though some fall on sides of elements."""
    found = cut_along(plate_of(straight()), np.array([[0.0, 0.5], [6.0, 0.5]]), 0.25)
    np.testing.assert_allclose(found.s, np.arange(25) * 0.25)
    found = cut_along(plate_of(straight()), np.array([[0.0, 0.5], [6.0, 0.5]]), 0.1)
    np.testing.assert_allclose(found.s, np.arange(61) * 0.1, atol=1e-12)


def test_both_values_at_a_change_of_section() -> None:
    """At the border the place stands twice, once in each part, with the moment of either side and one settlement."""
    for spacing in (None, 0.5, 0.7):
        found = cut_along(stepped(), np.array([[0.0, 0.5], [6.0, 0.5]]), spacing)
        at = np.flatnonzero(np.isclose(found.x, 2.0))
        assert found.values["moment_x"][at].tolist() == [1.0, 5.0]
        assert found.part[at].tolist() == [0, 1]
        assert len(found.parts()) == 2
        np.testing.assert_allclose(found.values["settlement"], found.x, atol=1e-12)


def test_an_opening_parts_a_section() -> None:
    """There are samples up to both sides of an opening, none within it, and no value is NaN."""
    plate = plate_of(without(straight(), (2, 4), (1, 3)), moment_x=lambda x, _: x)
    found = cut_along(plate, np.array([[-1.0, 2.5], [8.0, 2.5]]), 0.3)
    one, two = found.parts()
    assert (found.x[one][0], found.x[one][-1], found.x[two][0], found.x[two][-1]) == pytest.approx((0, 2, 4, 6))
    np.testing.assert_allclose(found.values["moment_x"], found.x, atol=1e-12)


def test_a_strip_is_its_cuts() -> None:
    """At each station of a slanting strip, totals and means are those of the formulas across it."""
    start, end, width = np.array([1.0, 1.0]), np.array([5.0, 2.5]), 1.2
    found = strip(PLATE, start, end, width, 5)
    axis = (end - start) / np.hypot(*(end - start))
    across = np.array([-axis[1], axis[0]])
    np.testing.assert_allclose(found.s, np.linspace(0, np.hypot(*(end - start)), 5))
    for i, centre in enumerate(np.column_stack([found.x, found.y])):
        M, V, length = by_hand(centre - width / 2 * across, centre + width / 2 * across)
        assert (found.moment[i], found.shear[i], found.length[i]) == pytest.approx((M, V, length))
        assert (found.mean_moment[i], found.mean_shear[i]) == pytest.approx((M / length, V / length))
    assert (found.least <= found.mean_moment).all()
    assert (found.mean_moment <= found.largest).all()


def test_extremes_and_design_moments_of_a_strip() -> None:
    """With m_x linear across the strip the extremes are its ends'; constant moments give Wood's and Armer's own."""
    found = strip(plate_of(straight(), moment_x=lambda _, y: y), (0, 2), (6, 2), 3.0, 4)
    np.testing.assert_allclose(found.largest, 3.5)
    np.testing.assert_allclose(found.least, 0.5)
    np.testing.assert_allclose(found.bottom, 2.0)
    np.testing.assert_allclose(found.top, 0.0)
    m = (3.0, -4.0, 1.5)
    names = ("moment_x", "moment_y", "moment_xy")
    constant = plate_of(straight(), **dict(zip(names, m, strict=True)))
    wood = wood_armer(*(np.array([v]) for v in m))
    along_x, along_y = strip(constant, (1, 2), (5, 2), 1, 2), strip(constant, (3, 0), (3, 4), 1, 2)
    for one, bottom, top in ((along_x, "bottom", "top"), (along_y, "bottom_across", "top_across")):
        np.testing.assert_allclose(getattr(one, bottom), wood.bottom_x[0])
        np.testing.assert_allclose(getattr(one, top), wood.top_x[0])
    for one, bottom, top in ((along_y, "bottom", "top"), (along_x, "bottom_across", "top_across")):
        np.testing.assert_allclose(getattr(one, bottom), wood.bottom_y[0])
        np.testing.assert_allclose(getattr(one, top), wood.top_y[0])


def test_stations_off_the_plate_are_left_out() -> None:
    """A strip over a hole wider than itself keeps the stations at its two ends; partly covered cuts are shorter."""
    plate = plate_of(without(straight(), (2, 4), (1, 3)), moment_x=1.0)
    found = strip(plate, (0, 2), (6, 2), 1.0, 7)
    np.testing.assert_allclose(found.s, [0, 1, 2, 4, 5, 6])
    wider = strip(plate, (0, 2), (6, 2), 3.0, 7)
    np.testing.assert_allclose(wider.length, [3, 3, 3, 1, 3, 3, 3])


@pytest.mark.parametrize(
    ("call", "place"),
    [
        (lambda: cut_along(PLATE, np.array([[0.0, 0.0]])), "points"),
        (lambda: cut_along(PLATE, np.array([[0.0, 0.0], [np.nan, 1.0]])), "points"),
        (lambda: cut_along(PLATE, np.array([[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]])), "points[3]"),
        (lambda: cut_along(PLATE, np.array([[0.0, 9.0], [1.0, 9.0]])), "points"),
        (lambda: cut_along(PLATE, np.array([[0.0, 0.0], [1.0, 1.0]]), 0.0), "spacing"),
        (lambda: strip(PLATE, (1, 1), (2, 1), 1e-300, 3), "cut"),
        (lambda: strip(PLATE, (1, 1), (1, 1), 1.0, 3), "points[2]"),
        (lambda: strip(PLATE, (1, 1), (2, 1), 0.0, 3), "width"),
        (lambda: strip(PLATE, (1, 1), (2, 1), 1.0, 1), "count"),
        (lambda: strip(PLATE, (1, 9), (2, 9), 1.0, 3), "cut"),
    ],
)
def test_faults(call, place: str) -> None:
    """What cannot be a section, cut or strip of this plate is refused with its place."""
    with pytest.raises(InputError) as caught:
        call()
    assert [issue.location for issue in caught.value.issues] == [place]
