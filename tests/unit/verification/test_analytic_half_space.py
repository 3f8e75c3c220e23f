"""The half-space under a rectangle: printed values, quadrature of a force's field, limits, equilibrium, far points."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.verification.analytic_half_space import FAR, REMOTE, compression, surface_settlement, vertical_stress

SIDES = (3.0, 2.0)
#: Under the centre, an edge, a corner, beside the rectangle, off its corner, further away.
POINTS = [(0.0, 0.0), (1.5, 0.3), (1.5, 1.0), (2.2, 0.4), (-2.0, 1.7), (7.0, -3.0), (30.0, 20.0), (0.0, 45.0)]
DEPTHS = [0.2, 1.0, 6.0, 40.0]


def force_stress(x: Array | float, y: Array | float, z: float) -> Array | float:
    """Return Boussinesq's stress by a unit force."""
    return 3 * z**3 / (2 * math.pi * (x * x + y * y + z * z) ** 2.5)


def gauss(marks: Array, n: int) -> tuple[Array, Array]:
    """Return points and weights of Gauss's rule, n points between any two marks."""
    points, weights = np.polynomial.legendre.leggauss(n)
    half, middle = np.diff(marks)[:, None] / 2, (marks[1:] + marks[:-1])[:, None] / 2
    return (middle + half * points).ravel(), (half * weights).ravel()


def test_printed_stress() -> None:
    """Das, Principles of Foundation Engineering, SI 7th edition, example 5.1: 19.65 kPa, by tabled factors."""
    assert 150 * vertical_stress(0, 0, 6.25, (2.5, 5)) == pytest.approx(19.65, abs=0.05)


def test_stress_of_another_program() -> None:
    """50 kPa on 6 m x 3 m, 3 m deep (ELPLA's example 1, Das 1983): 9.997 kPa under a corner, 24.035 under the centre.

    The numbers are an independent evaluation of Boussinesq's integral; those that are printed could not be read.
    """
    np.testing.assert_allclose(50 * vertical_stress([3, 0], [1.5, 0], 3, (6, 3)), [9.997, 24.035], atol=6e-4)


def test_stress_by_forces() -> None:
    """Four forces of 250 N in a square of 0.5 m, 1 m under one: 299.341104612446 Pa in a test of the program XC."""
    x, y = np.array([0, 0.5, 0, 0.5]), np.array([0, 0, 0.5, 0.5])
    stress = 250 * vertical_stress(x, y, 1, (1e-4, 1e-4)).sum() / 1e-8
    assert stress == pytest.approx(299.341104612446, rel=1e-7)


def test_stress_is_the_integral_over_the_rectangle() -> None:
    """Corners near the rectangle and Gauss's rule further away both integrate Boussinesq's stress by a force."""
    for x, y in POINTS:
        for z in DEPTHS:
            (u, du), (v, dv) = (gauss(np.linspace(-side / 2, side / 2, 31), 8) for side in SIDES)
            expected = du @ force_stress(x - u[:, None], y - v, z) @ dv
            assert vertical_stress(x, y, z, SIDES) == pytest.approx(expected, rel=1e-10, abs=1e-14)


def test_compression_is_the_integral_over_the_layer() -> None:
    """The closed form of int sigma_z dz agrees with quadrature of sigma_z to 1e-10."""
    for x, y in POINTS:
        for top, bottom in [(0.0, 0.5), (0.5, 3.0), (3.0, 50.0), (0.0, 400.0), (2.0, 2.0)]:
            marks = top + (bottom - top) * np.concatenate([[0], 2.0 ** np.arange(-14, 1)])
            z, dz = gauss(marks, 20)
            expected = vertical_stress(x, y, z, SIDES) @ dz
            assert compression(x, y, top, bottom, SIDES) == pytest.approx(expected, rel=1e-10, abs=1e-14)


@pytest.mark.parametrize("mean", [False, True])
@pytest.mark.parametrize(("x", "y"), POINTS)
def test_layers_add_up(x: float, y: float, mean: bool) -> None:
    """A column cut into layers is compressed by the sum of them, down to an infinite depth, wherever methods change."""
    depths = np.array([0.0, 0.3, 1.0, 4.0, 9.0, 25.0, 200.0, np.inf])
    parts = compression(x, y, depths[:-1], depths[1:], SIDES, mean)
    assert (parts > 0).all()
    assert parts.sum() == pytest.approx(compression(x, y, 0, np.inf, SIDES, mean), rel=1e-12)


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (3.0, 0.0), (3.0, -2.0), (1.1, 0.7), (9.0, 4.0), (60.0, 10.0)])
def test_means_are_averages_of_points(x: float, y: float) -> None:
    """The second differences are what Gauss's rule finds as the mean of the points' values over the other rectangle."""
    points, weights = np.polynomial.legendre.leggauss(24)
    u, v = x + SIDES[0] / 2 * points[:, None], y + SIDES[1] / 2 * points
    area = np.outer(weights, weights) / 4
    for z in (1.0, 5.0, 30.0):
        stress = (area * vertical_stress(u, v, z, SIDES)).sum()
        assert vertical_stress(x, y, z, SIDES, mean=True) == pytest.approx(stress, rel=2e-7)
        layer = (area * compression(u, v, z, 2 * z, SIDES)).sum()
        assert compression(x, y, z, 2 * z, SIDES, mean=True) == pytest.approx(layer, rel=2e-7)


def test_surface() -> None:
    """At z = 0 the stress is the pressure: all of it inside, half on an edge, a quarter at a corner, nothing beside."""
    x, y = np.array([0.0, 1.5, -1.5, 0.2, 1.6, 80.0]), np.array([0.9, 0.5, 1.0, -1.0, 0.0, 3.0])
    expected = [1, 1 / 2, 1 / 4, 1 / 2, 0, 0]
    np.testing.assert_allclose(vertical_stress(x, y, 0, SIDES), expected, atol=1e-15)
    np.testing.assert_allclose(vertical_stress(x, y, 1e-9, SIDES), expected, atol=1e-8)
    assert vertical_stress([0, 3, 60], 0, 0, SIDES, mean=True) == pytest.approx([1, 0, 0], abs=1e-14)


def test_every_depth_carries_the_load() -> None:
    """Stresses over a plane in depth add up to the pressure's force: means over all cells of a plane to 1."""
    n = np.arange(-150, 151)
    total = vertical_stress(3.0 * n[:, None], 2.0 * n, 4.0, SIDES, mean=True).sum()
    tail = (4 / (150 * 2.0)) ** 3  # of a force's share outside a radius, (z / s)^3
    assert total == pytest.approx(1, abs=tail)


def test_methods_meet() -> None:
    """Where corners, Gauss's rule and its remote form hand over, the values on both sides agree."""
    for mean in [False, True]:
        for direction in [(1.0, 0.0, 0.0), (0.6, 0.8, 0.0), (0.0, 0.6, 0.8), (0.0, 0.0, 1.0)]:
            for where in [FAR, 2 * FAR, REMOTE, 2 * REMOTE]:
                distance = where * math.hypot(*SIDES)
                x, y, z = (np.array([1 - 1e-12, 1 + 1e-12]) * distance * c for c in direction)
                inside, outside = vertical_stress(x, y, z + 1e-3, SIDES, mean)
                assert inside == pytest.approx(outside, rel=1e-9, abs=1e-12)
                inside, outside = compression(x, y, z, z + 5, SIDES, mean)
                assert inside == pytest.approx(outside, rel=1e-9, abs=1e-12)


def test_far_points_feel_a_force() -> None:
    """A thousand diagonals away the rectangle is its force, to 1e-6 of values that are below 1e-11: no cancellation."""
    x, y, z = 3000.0, 2000.0, 5.0
    assert vertical_stress(x, y, z, SIDES) == pytest.approx(6 * force_stress(x, y, z), rel=1e-6, abs=0)
    r = math.hypot(x, y)
    for mean in (False, True):
        shallow = compression(x, y, 0, z, SIDES, mean)
        assert shallow == pytest.approx(6 * 3 * z**4 / (8 * math.pi * r**5), rel=2e-5, abs=0)
        assert compression(x, y, 0, np.inf, SIDES, mean) == pytest.approx(6 / (math.pi * r), rel=1e-6, abs=0)


def test_settlement_of_a_square() -> None:
    """A flexible square settles at its centre by 4 / pi ln(1 + sqrt 2) = 1.1222 q B (1 - nu^2) / E, half at corners."""
    w = surface_settlement([0, 1], [0, 1], (2, 2), 30e6, 0.3)
    assert w[0] == pytest.approx(4 / math.pi * math.log(1 + math.sqrt(2)) * 2 * 0.91 / 30e6, rel=1e-14)
    assert w[0] * 30e6 / (2 * 0.91) == pytest.approx(1.1222, abs=5e-5)
    assert w[1] == pytest.approx(w[0] / 2, rel=1e-14)


@pytest.mark.parametrize(
    ("ratio", "centre", "mean"), [(1, 1.12, 0.95), (1.5, 1.36, 1.15), (2, 1.53, 1.30), (3, 1.78, 1.52), (5, 2.10, 1.83)]
)
def test_published_shape_factors(ratio: float, centre: float, mean: float) -> None:
    """Factors of the centre's and the mean settlement, two decimals as textbooks table them (from memory)."""
    assert surface_settlement(0, 0, (ratio, 1), 1, 0) == pytest.approx(centre, abs=0.01)
    assert surface_settlement(0, 0, (ratio, 1), 1, 0, mean=True) == pytest.approx(mean, abs=0.01)


def test_mean_settlement_by_quadrature() -> None:
    """The mean settlement of a rectangle under its own pressure and under its neighbour's, and their symmetry."""
    (u, du), (v, dv) = (gauss(np.array([-side / 2, 0, side / 2]), 60) for side in SIDES)
    for x in (0.0, 3.0):
        expected = du @ surface_settlement(x + u[:, None], v, SIDES, 1, 0) @ dv / 6
        assert surface_settlement(x, 0, SIDES, 1, 0, mean=True) == pytest.approx(expected, rel=1e-7)
    x, y = np.meshgrid([0.0, 3.0, 6.0, 33.0], [0.0, 2.0, 50.0])
    both = [surface_settlement(s * x, t * y, SIDES, 1, 0, mean=True) for s, t in [(1, 1), (-1, 1), (1, -1)]]
    np.testing.assert_allclose(both[1:], [both[0]] * 2, rtol=1e-12)


def test_strip() -> None:
    """Under a very long rectangle the stress is the strip's, (alpha + sin alpha) / pi under the centre."""
    z = np.array([0.1, 1.0, 3.0])
    alpha = 2 * np.arctan(1 / z)
    np.testing.assert_allclose(vertical_stress(0, 0, z, (2e4, 2)), (alpha + np.sin(alpha)) / np.pi, rtol=1e-9)
