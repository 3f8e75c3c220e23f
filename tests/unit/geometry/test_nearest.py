"""Nearest places: as SciPy's trees find them, with few places and with many."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import KDTree

from groundslab.geometry import nearest
from groundslab.geometry.nearest import nearest_distance, nearest_of_same


@pytest.mark.parametrize("most", [nearest.MOST_PAIRS, 0])
@pytest.mark.parametrize("chunk", [nearest.CHUNK, 7])
def test_distances_are_those_of_a_tree(monkeypatch: pytest.MonkeyPatch, most: int, chunk: int) -> None:
    """Below the reach; infinite beyond it, and where there is no other place."""
    monkeypatch.setattr(nearest, "MOST_PAIRS", most)
    monkeypatch.setattr(nearest, "CHUNK", chunk)
    random = np.random.default_rng(1)
    places, among = random.uniform(-3.0, 5.0, (40, 2)), random.uniform(-3.0, 5.0, (25, 2))
    true = KDTree(among).query(places)[0]
    reach = float(np.median(true))
    found = nearest_distance(places, among, reach)
    np.testing.assert_allclose(found[true < reach], true[true < reach], rtol=1e-13)
    assert np.isinf(found[true >= reach]).all()
    np.testing.assert_allclose(nearest_distance(places, among, np.inf), true, rtol=1e-13)


def test_same_places_are_found_in_any_order() -> None:
    """Each where it stands among the others, rounding aside."""
    random = np.random.default_rng(2)
    among = np.round(random.uniform(-1e3, 1e3, (500, 2)), 3)
    which = random.permutation(500)[:200]
    some = among[which] * (1 + 1e-15)
    at, distance = nearest_of_same(some, among)
    np.testing.assert_array_equal(at, which)
    assert distance.max() < 1e-9


def test_places_that_are_no_others_have_the_nearest_one() -> None:
    """With its distance, though one coordinate is that of a place far away."""
    among = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]])
    at, distance = nearest_of_same(np.array([[0.0, 0.0], [1.0, 0.75]]), among)
    np.testing.assert_array_equal(at, [0, 3])
    np.testing.assert_allclose(distance, [0.0, 0.25])
