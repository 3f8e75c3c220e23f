"""The first-order reliability index against limit states whose index is known exactly."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

pytest.importorskip("openturns")

from groundslab.errors import GroundslabError, NotConverged
from groundslab.study.evaluation.form import design_point


def test_linear_limit_state_of_independent_normals() -> None:
    """For g = c - a.x with normal x the index is (c - a.mu) / |a sigma|, importance (a sigma)^2 over their sum."""
    a, mu, sigma, c = np.array([2.0, -1.0, 0.5]), np.array([3.0, 4.0, 10.0]), np.array([0.5, 1.5, 2.0]), 14.0
    found = design_point(lambda z: c - a @ (mu + sigma * z), np.eye(3))
    beta = (c - a @ mu) / np.linalg.norm(a * sigma)
    assert found.beta == pytest.approx(beta, rel=1e-6)
    assert found.probability == pytest.approx(stats.norm.sf(beta), rel=1e-5)
    assert found.importance == pytest.approx((a * sigma) ** 2 / np.sum((a * sigma) ** 2), rel=1e-6)
    assert found.scores == pytest.approx(beta * a * sigma / np.linalg.norm(a * sigma), rel=1e-6)


def test_linear_limit_state_of_correlated_normals() -> None:
    """With correlated inputs the standard deviation of a.x is the root of a' S a."""
    a, sigma, c = np.array([1.0, 1.0, -2.0]), np.array([1.0, 2.0, 0.7]), 6.0
    correlation = np.array([[1.0, 0.5, 0.2], [0.5, 1.0, -0.3], [0.2, -0.3, 1.0]])
    found = design_point(lambda z: c - a @ (sigma * z), correlation)
    beta = c / np.sqrt((a * sigma) @ correlation @ (a * sigma))
    assert found.beta == pytest.approx(beta, rel=1e-6)
    assert found.scores == pytest.approx(beta * correlation @ (a * sigma) * beta / c, rel=1e-6)
    assert found.importance.sum() == pytest.approx(1.0, rel=1e-12)


def test_ratio_of_lognormals() -> None:
    """The ratio of two lognormal quantities against a bound is linear in their logarithms: the index is exact."""
    s = np.array([0.3, 0.2])
    found = design_point(lambda z: 3.0 - np.exp(s[0] * z[0] - s[1] * z[1]), np.eye(2))
    assert found.beta == pytest.approx(np.log(3.0) / np.linalg.norm(s), rel=1e-6)


def test_medians_that_fail_have_a_negative_index() -> None:
    """If the medians fail already, the index is negative and the probability above one half."""
    found = design_point(lambda z: -1.0 - z[0], np.eye(1))
    assert found.beta == pytest.approx(-1.0, rel=1e-6)
    assert found.probability == pytest.approx(stats.norm.cdf(1.0), rel=1e-6)


def test_the_unit_of_the_limit_state_does_not_matter() -> None:
    """The same limit state in another unit has the same design point after as many solutions."""
    found = [
        design_point(lambda z, unit=unit: unit * (3.0 - z[0] - 0.2 * z[1] ** 2 - z[1]), np.eye(2))
        for unit in (1e-6, 1e6)
    ]
    assert found[0].beta == pytest.approx(found[1].beta, rel=1e-9)
    assert found[0].solves == found[1].solves < 60


def test_each_point_is_asked_for_once() -> None:
    """No point of the limit state is computed twice, and the count of solutions is true."""
    points = []

    def g(z: np.ndarray) -> float:
        points.append(tuple(z))
        return float(4.0 - z @ z / 2 - z.sum())

    found = design_point(g, np.eye(3))
    assert len(points) == len(set(points)) == found.solves


def test_no_design_point_is_said_to_be_found_where_there_is_none() -> None:
    """A limit state that no score reaches, and one that does not depend on the inputs, are refused."""
    with pytest.raises(NotConverged, match="design point"):
        design_point(lambda z: 1.0 + np.exp(-z[0]), np.eye(1))
    with pytest.raises(GroundslabError, match="does not depend"):
        design_point(lambda z: 1.0, np.eye(2))  # noqa: ARG005


def test_errors_of_the_limit_state_are_raised_unchanged() -> None:
    """What the solution raises on the way is not hidden by the search."""

    def g(z: np.ndarray) -> float:
        if np.abs(z).max() > 0.5:
            raise GroundslabError("no equilibrium")
        return float(3.0 - z[0])

    with pytest.raises(GroundslabError, match="no equilibrium"):
        design_point(g, np.eye(1))
