"""Values between the places where they are known."""

from __future__ import annotations

import numpy as np

from groundslab.between import interpolated


def test_two_places_are_joined_by_a_line() -> None:
    """On the line through two places values are linear between them and constant beyond."""
    places, values = np.array([[1.0, 2.0], [5.0, 5.0]]), np.array([[10.0, -1.0], [20.0, 3.0]])
    part = np.array([-3.0, 0.0, 0.25, 0.5, 1.0, 7.0])
    found = interpolated(places, values, places[0] + part[:, None] * (places[1] - places[0]))
    np.testing.assert_allclose(found, values[0] + part.clip(0, 1)[:, None] * (values[1] - values[0]), atol=1e-12)


def test_one_place_holds_everywhere() -> None:
    """What is known at one place only, or is the same at all, is that value everywhere, to the last digit."""
    wanted = np.array([[0.0, 0.0], [3.3, -8.1], [1e3, 1e3]])
    np.testing.assert_array_equal(interpolated(np.array([[2.0, 1.0]]), np.array([[0.1, 0.7]]), wanted)[:, 1], 0.7)
    places = np.array([[0.0, 0.0], [4.0, 1.0], [1.0, 5.0]])
    np.testing.assert_array_equal(interpolated(places, np.full((3, 1), 0.1), wanted), 0.1)


def test_known_places_keep_their_values_in_any_unit_of_length() -> None:
    """Interpolation goes through what is known, and neither the unit of length nor the origin matters."""
    rng = np.random.default_rng(7)
    places, values, wanted = rng.uniform(-20, 20, (9, 2)), rng.uniform(1, 5, (9, 2)), rng.uniform(-30, 30, (40, 2))
    np.testing.assert_allclose(interpolated(places, values, places), values, rtol=1e-12)
    other = interpolated(1e3 * places + 5e3, values, 1e3 * wanted + 5e3)
    np.testing.assert_allclose(other, interpolated(places, values, wanted), rtol=1e-9)


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
    np.testing.assert_allclose(interpolated(places, values, wanted), weights.T @ values, rtol=1e-10)
