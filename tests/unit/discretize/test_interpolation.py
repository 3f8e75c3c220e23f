"""Values between the places where they are known."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.discretize import interpolation
from groundslab.discretize.interpolation import interpolate_linearly, interpolate_smoothly


def test_two_places_are_joined_by_a_line() -> None:
    """On the line through two places values are linear between them and constant beyond."""
    places, values = np.array([[1.0, 2.0], [5.0, 5.0]]), np.array([[10.0, -1.0], [20.0, 3.0]])
    part = np.array([-3.0, 0.0, 0.25, 0.5, 1.0, 7.0])
    found = interpolate_linearly(places, values, places[0] + part[:, None] * (places[1] - places[0]))
    np.testing.assert_allclose(found, values[0] + part.clip(0, 1)[:, None] * (values[1] - values[0]), atol=1e-12)


def test_one_place_holds_everywhere() -> None:
    """What is known at one place only, or is the same at all, is that value everywhere, to the last digit."""
    wanted = np.array([[0.0, 0.0], [3.3, -8.1], [1e3, 1e3]])
    found = interpolate_linearly(np.array([[2.0, 1.0]]), np.array([[0.1, 0.7]]), wanted)
    np.testing.assert_array_equal(found[:, 1], 0.7)
    places = np.array([[0.0, 0.0], [4.0, 1.0], [1.0, 5.0]])
    np.testing.assert_array_equal(interpolate_linearly(places, np.full((3, 1), 0.1), wanted), 0.1)


def test_known_places_keep_their_values_in_any_unit_of_length() -> None:
    """Interpolation goes through what is known, and neither the unit of length nor the origin matters."""
    rng = np.random.default_rng(7)
    places, values, wanted = rng.uniform(-20, 20, (9, 2)), rng.uniform(1, 5, (9, 2)), rng.uniform(-30, 30, (40, 2))
    np.testing.assert_allclose(interpolate_linearly(places, values, places), values, rtol=1e-12)
    other = interpolate_linearly(1e3 * places + 5e3, values, 1e3 * wanted + 5e3)
    np.testing.assert_allclose(other, interpolate_linearly(places, values, wanted), rtol=1e-9)


def test_it_is_kriging_with_a_linear_variogram() -> None:
    """The weights are those of ordinary kriging for the variogram |r|: solved here as Matheron states them."""
    rng = np.random.default_rng(3)
    places, values, wanted = rng.uniform(0, 10, (6, 2)), rng.uniform(1, 5, (6, 1)), rng.uniform(-5, 15, (20, 2))
    system = np.ones((7, 7))
    system[:6, :6] = np.linalg.norm(places[:, None] - places, axis=2)
    system[6, 6] = 0.0
    right = np.ones((7, 20))
    right[:6] = np.linalg.norm(places[:, None] - wanted, axis=2)
    weights = np.linalg.solve(system, right)[:6]
    np.testing.assert_allclose(interpolate_linearly(places, values, wanted), weights.T @ values, rtol=1e-10)


def test_smooth_values_of_a_plane_lie_on_it() -> None:
    """From places anywhere a plane comes back, beside them too, as far again as the known values reach."""
    rng = np.random.default_rng(11)
    wanted = rng.uniform(-3, 3, (50, 2))
    corners = np.array([[-3.0, -2.0], [3.0, -2.0], [3.0, 2.0], [-3.0, 2.0]])
    for places in (corners, corners[:3], rng.uniform(-1.6, 1.6, (12, 2)), 1e-3 * corners + [50.0, 7.0]):
        at = places.mean(axis=0) + np.ptp(places, axis=0) / 6 * wanted
        values = [0.05 + 1e-3 * x - 2e-3 * y for x, y in (places.T, at.T)]
        np.testing.assert_allclose(interpolate_smoothly(places, values[0], at), values[1], rtol=1e-9)


def test_smooth_values_have_no_cones() -> None:
    """Where one of many values stands out, the slope passes through zero there instead of jumping."""
    x, y = np.meshgrid(np.arange(-2.0, 3.0), np.arange(-2.0, 3.0))
    places = np.column_stack([x.ravel(), y.ravel()])
    values = np.where(np.hypot(*places.T) < 0.5, 2.0, 1.0)
    slopes = []
    for step in (1e-1, 1e-2, 1e-3):
        left, middle, right = interpolate_smoothly(places, values, np.array([[-step, 0.0], [0.0, 0.0], [step, 0.0]]))
        slopes.append((2 * middle - left - right) / step)
    assert slopes[0] > 5 * slopes[1] > 25 * slopes[2] > 0


def test_smooth_values_go_through_the_known_ones_and_no_further_than_their_range() -> None:
    """Steep values far from each other are met, are not left by more than their range, and do not become negative."""
    rng = np.random.default_rng(5)
    for _ in range(20):
        places, values = rng.uniform(-1, 1, (7, 2)), rng.exponential(1.0, 7)
        np.testing.assert_allclose(interpolate_smoothly(places, values, places), values, rtol=1e-8)
        found = interpolate_smoothly(places, values, rng.uniform(-9, 9, (300, 2)))
        assert found.min() >= 0
        assert found.max() <= 2 * values.max() - values.min() + 1e-12
    assert (
        interpolate_smoothly(np.array([[0.0, 0.0], [1.0, 0.0]]), np.array([-1.0, 1.0]), np.array([[0.25, 3.0]])) == -0.5
    )


def test_smooth_values_along_a_line_and_at_one_place() -> None:
    """Places on a line, however it lies, say nothing across it; two make a straight line; one holds everywhere."""
    wanted = np.array([[0.0, 0.0], [3.0, -8.0], [1.0, 1.0]])
    np.testing.assert_array_equal(interpolate_smoothly(np.array([[2.0, 1.0]]), np.array([0.1]), wanted), 0.1)
    line = np.array([[0.0, 0.0], [3.0, 4.0], [6.0, 8.0]])
    across = np.array([-4.0, 3.0])
    for values in (np.array([1.0, 2.0]), np.array([1.0, 2.0, 3.0])):
        at = 0.3 * line[2] + np.array([[0.0], [1.0], [-2.0]]) * across
        np.testing.assert_allclose(interpolate_smoothly(line[: len(values)], values, at), 1.6, rtol=1e-12)


@pytest.mark.parametrize("apart", [1e-9, 1e-12])
def test_smooth_values_of_places_next_to_each_other(apart: float) -> None:
    """Two places that are nearly one count as one, with the mean of their values."""
    places = np.array([[0.0, 0.0], [apart, 0.0], [1.0, 0.0], [0.0, 1.0]])
    found = interpolate_smoothly(places, np.array([1.0, 3.0, 2.0, 2.0]), np.array([[0.3, 0.4]]))
    np.testing.assert_allclose(found, 2.0, rtol=1e-8)


def test_scipy_finds_the_same_in_parts_of_any_size(monkeypatch: pytest.MonkeyPatch) -> None:
    """Within the range of the known values they are those of SciPy's radial basis functions."""
    from scipy.interpolate import RBFInterpolator

    rng = np.random.default_rng(5)
    places, wanted = rng.uniform(-1, 1, (30, 2)), rng.uniform(-1, 1, (101, 2))
    values = 5 + places @ (1.0, 2.0) + rng.uniform(-1, 1, 30)
    monkeypatch.setattr(interpolation, "MOST_DISTANCES", 30 * 7)
    for found, kernel in (
        (interpolate_linearly(places, values[:, None], wanted)[:, 0], "linear"),
        (interpolate_smoothly(places, values, wanted), "thin_plate_spline"),
    ):
        degree = 0 if kernel == "linear" else 1
        expected = RBFInterpolator(places, values, kernel=kernel, degree=degree)(wanted)
        inside = (expected > values.min()) & (expected < values.max())
        assert inside.sum() > 80
        np.testing.assert_allclose(found[inside], expected[inside], rtol=1e-9)


def test_gaps_end_in_zero_without_a_crease() -> None:
    """A plane through three gaps that reaches below zero stays where it is a tenth of the largest, and ends smoothly.

    The slope falls from 1.25 mm/m to zero over some centimeters, by small steps: cut off it would do so in one.
    """
    places, gaps = np.array([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]), np.array([0.0, 5e-3, 0.0])
    x = np.linspace(-2.0, 4.0, 1201)
    found = interpolate_smoothly(places, gaps, np.column_stack([x, np.zeros_like(x)]))
    plane = 1.25e-3 * x
    np.testing.assert_allclose(interpolate_smoothly(places, gaps, np.vstack([places, [[-2, 0]]]))[:3], gaps, atol=1e-15)
    np.testing.assert_allclose(found[x >= 0.4], plane[x >= 0.4], rtol=1e-12)
    assert np.abs(found[x <= 0]).max() < 1e-12
    assert np.abs(found - plane.clip(0)).max() < 0.02 * gaps.max()
    slope = np.diff(found) / np.diff(x)
    assert slope.min() > -1e-12
    # of c t^3 (6 - 8 t + 3 t^2) the curvature is at most 4 / c, c = 0.5 mm
    assert np.abs(np.diff(slope) / np.diff(x)[1:]).max() < 4 * 1.25e-3**2 / 0.5e-3
