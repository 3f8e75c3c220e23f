"""Statistics of meshes: of grids whose elements are known, and of a crooked one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from groundslab.accuracy.mesh_statistics import mesh_statistics
from groundslab.results.results import CombinationResult
from groundslab.views.summary.sections import mesh_section
from helpers import synthetic


def moved(results: CombinationResult, nodes: np.ndarray) -> CombinationResult:
    """Return results whose nodes lie elsewhere."""
    return replace(results, plate=replace(results.plate, nodes=nodes))


def test_grid_of_equal_rectangles() -> None:
    """Nine of 3.2 by 2.4 m: one size, perfect quality, and no place that is worse than the others."""
    found = mesh_statistics(synthetic.results(3))
    assert (found.elements, found.unknowns) == (9, 1234)
    assert found.smallest == pytest.approx(np.sqrt(3.2 * 2.4))
    assert found.largest == pytest.approx(np.sqrt(3.2 * 2.4))
    assert (found.worst_quality, found.mean_quality) == (pytest.approx(1.0), pytest.approx(1.0))
    assert (found.smallest_place, found.largest_place, found.worst_place) == (None, None, None)


def test_grid_that_is_refined_to_one_side() -> None:
    """Columns of elements 1.2, 2.4 and 6 m wide: the sizes are theirs, and so are the places."""
    results = synthetic.results(3)
    x, y = results.plate.nodes.T
    bent = np.interp(x, [-4.8, -1.6, 1.6, 4.8], [-4.8, -3.6, -1.2, 4.8])
    found = mesh_statistics(moved(results, np.column_stack([bent, y])))
    assert found.smallest == pytest.approx(np.sqrt(1.2 * 2.4))
    assert found.largest == pytest.approx(np.sqrt(6.0 * 2.4))
    assert found.smallest_place == pytest.approx((-4.2, 0.0))
    assert found.largest_place == pytest.approx((1.8, 0.0))
    assert found.worst_place is None


@pytest.mark.parametrize("angle", [60.0, 8.0])
def test_sheared_grid(angle: float) -> None:
    """Parallelograms have the sine of their angle as scaled Jacobian; one below 0.2 is told in a note."""
    results = synthetic.results(2)
    x, y = results.plate.nodes.T
    leaning = mesh_statistics(moved(results, np.column_stack([x + y / np.tan(np.radians(angle)), y])))
    assert leaning.worst_quality == pytest.approx(np.sin(np.radians(angle)))
    assert leaning.mean_quality == pytest.approx(np.sin(np.radians(angle)))
    section = mesh_section(moved(results, np.column_stack([x + y / np.tan(np.radians(angle)), y])))
    assert any("scaled Jacobian below 0.2" in note for note in section.notes) == (angle < 10)


def test_mean_of_different_qualities() -> None:
    """One of four elements is sheared by its middle row of nodes: the mean lies between it and the others'."""
    results = synthetic.results(2)
    nodes = results.plate.nodes.copy()
    nodes[results.plate.elements[0, 8]] += [0.6, 0.0]
    found = mesh_statistics(moved(results, nodes))
    assert found.worst_quality < 1.0
    assert found.mean_quality == pytest.approx((3 + found.worst_quality) / 4)
    assert found.worst_place == pytest.approx(tuple(nodes[results.plate.elements[0, 8]]))
