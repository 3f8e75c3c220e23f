"""Figures, samples and differences of plates with known fields."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from groundslab.analysis.ground_comparison.figures import (
    FIGURES,
    axis_places,
    curve,
    figures_of,
    gauss_points,
    rms_differences,
    sample,
)
from groundslab.results.plate_result import PlateResult
from helpers import synthetic


def plate(n: int = 4) -> PlateResult:
    """Return a plate of 9.6 x 7.2 m that settles by 10 mm + 1 mm/m x."""
    made = synthetic.results(n).plate
    return replace(made, settlement=0.01 + 0.001 * made.nodes[:, 0])


def test_gauss_points_integrate_quadratics() -> None:
    """The mean of x^2 over a side L is L^2 / 12, whatever the mesh."""
    points = gauss_points(plate(3))
    assert (points.weights**2).sum() == pytest.approx(1, rel=1e-12)
    mean = points.weights**2 @ points.places**2
    np.testing.assert_allclose(mean, [9.6**2 / 12, 7.2**2 / 12], rtol=1e-12)


def test_samples_on_another_mesh() -> None:
    """A linear field has the same values at all points on both meshes; beside the plate there is none."""
    places = gauss_points(plate(4)).places
    np.testing.assert_allclose(sample(plate(3), "settlement", places), 0.01 + 0.001 * places[:, 0], rtol=1e-12)
    assert np.isnan(sample(plate(), "settlement", np.array([[5.0, 0.0]]))).all()


def test_rms_of_a_known_difference() -> None:
    """Plates that differ by 1 mm/m x differ by 1 mm/m L / sqrt(12), over the larger settlement of 14.8 mm."""
    reference = plate(4)
    other = replace(plate(3), settlement=np.full(len(plate(3).nodes), 0.01))
    found = rms_differences(other, reference, gauss_points(reference))
    assert found["settlement"] == pytest.approx(0.001 * 9.6 / 12**0.5 / 0.0148, rel=1e-10)


def test_figures() -> None:
    """Of a plate that tilts by 1 mm/m over 9.6 m: 14.8, 5.2, mean 10, difference 9.6 mm."""
    found = figures_of(plate())
    names = ("largest", "smallest", "mean", "differential")
    np.testing.assert_allclose([found[f"{name}_settlement"] for name in names], [14.8e-3, 5.2e-3, 10e-3, 9.6e-3])
    assert found.keys() == FIGURES.keys()


def test_pressure_exceeded_on_a_part_of_the_area() -> None:
    """A peak on less than 5 % of the area does not count, one on more does."""
    made = plate(8)
    peak = np.where(made.nodes[:, 0] > 4.75, 9e5, 1e5)  # the last half of an element of 1.2 m counts a fourth of it
    assert figures_of(replace(made, pressure=peak))["exceeded_pressure"] == 1e5
    wide = np.where(made.nodes[:, 0] > 4.0, 9e5, 1e5)
    assert figures_of(replace(made, pressure=wide))["exceeded_pressure"] == 9e5
    assert figures_of(replace(made, pressure=peak))["largest_pressure"] == 9e5


def test_curves_run_from_edge_to_edge() -> None:
    """Along x through a place the linear field is linear; what lies beside the plate is None."""
    lines = axis_places(plate(), (1.0, 2.0))
    np.testing.assert_allclose(lines["x"][:, 1], 2.0)
    np.testing.assert_allclose(lines["y"][:, 0], 1.0)
    np.testing.assert_allclose(lines["x"][[0, -1], 0], [-4.8, 4.8], rtol=1e-5)
    np.testing.assert_allclose(curve(plate(), "settlement", lines["x"]), 0.01 + 0.001 * lines["x"][:, 0], rtol=1e-12)
    assert curve(plate(), "settlement", np.array([[9.0, 0.0]])) == (None,)
