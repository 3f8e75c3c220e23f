"""Shape functions, Gauss rules and Jacobians of the nine-node quadrilateral."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.fem.shape_functions import (
    COLUMN,
    ROW,
    SERENDIPITY_CENTER,
    determinants,
    gauss,
    gauss_line,
    inverse_jacobian,
    lagrange,
    q9,
)
from helpers.quads import quadrilateral

POINTS = np.random.default_rng(0).uniform(-1, 1, (20, 2))
NODES = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0), (0, 0)], float)


def biquadratics(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the nine monomials x^i y^j, i, j <= 2, and their derivatives, each (points, 9)."""
    powers = [(i, j) for i in range(3) for j in range(3)]
    value = np.column_stack([x**i * y**j for i, j in powers])
    along_x = np.column_stack([i * x ** max(i - 1, 0) * y**j for i, j in powers])
    along_y = np.column_stack([j * x**i * y ** max(j - 1, 0) for i, j in powers])
    return value, along_x, along_y


def test_nodes_stand_where_the_module_says() -> None:
    """COLUMN and ROW put the nodes at corners, midsides and centre in the order that the module documents."""
    np.testing.assert_array_equal(np.column_stack([COLUMN, ROW]) - 1, NODES)


def test_each_function_is_one_at_its_own_node_alone() -> None:
    """N_a(node b) is the unit matrix, so that nodal values are values."""
    np.testing.assert_allclose(q9(NODES)[0], np.eye(9), atol=1e-15)


def test_functions_span_the_biquadratics() -> None:
    """Interpolating any x^i y^j with i, j <= 2 gives back its values and both derivatives everywhere."""
    N, dN = q9(POINTS)
    nodal = biquadratics(*NODES.T)[0]
    value, along_x, along_y = biquadratics(*POINTS.T)
    np.testing.assert_allclose(N @ nodal, value, atol=1e-14)
    np.testing.assert_allclose(dN[:, 0] @ nodal, along_x, atol=1e-14)
    np.testing.assert_allclose(dN[:, 1] @ nodal, along_y, atol=1e-14)


def test_lagrange_keeps_the_shape_of_its_argument() -> None:
    """Functions and derivatives append one axis of three to an array of any shape and sum to one and to zero."""
    N, dN = lagrange(np.linspace(-2, 2, 12).reshape(3, 4))
    assert N.shape == dN.shape == (3, 4, 3)
    np.testing.assert_allclose(N.sum(axis=-1), 1.0, atol=1e-14)
    np.testing.assert_allclose(dN.sum(axis=-1), 0.0, atol=1e-14)


def test_serendipity_centre() -> None:
    """The centre rule is met by all functions of the eight-node family and, as it must, not by x^2 y^2."""
    x, y = NODES.T
    for i, j in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (2, 1), (1, 2)]:
        values = x**i * y**j
        assert values[:8] @ SERENDIPITY_CENTER == pytest.approx(values[8], abs=1e-15)
    assert (x**2 * y**2)[:8] @ SERENDIPITY_CENTER == pytest.approx(-1.0)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
def test_gauss_rules_are_exact_to_their_degree_and_no_further(n: int) -> None:
    """The n x n rule integrates x^i y^j exactly up to degree 2n - 1 each way and misses x^2n."""
    points, weights = gauss(n)
    x, y = points.T
    for i in range(2 * n):
        for j in range(2 * n):
            exact = (2 / (i + 1) if i % 2 == 0 else 0.0) * (2 / (j + 1) if j % 2 == 0 else 0.0)
            assert weights @ (x**i * y**j) == pytest.approx(exact, abs=1e-14)
    assert abs(weights @ x ** (2 * n) - 4 / (2 * n + 1)) > 1e-3
    line, line_weights = gauss_line(n)
    assert line_weights @ line ** (2 * n - 2) == pytest.approx(2 / (2 * n - 1))


def test_jacobian_of_an_affine_map() -> None:
    """For x = A xi + b the rows of J are x,xi and x,eta, so that J is A transposed everywhere."""
    A = np.array([[2.0, 0.5], [-0.3, 1.5]])
    xy = (NODES @ A.T + [3.0, -7.0])[None]
    dN = q9(POINTS)[1]
    inverse, det = inverse_jacobian(dN, xy)
    np.testing.assert_allclose(inverse[0] @ A.T, np.broadcast_to(np.eye(2), inverse[0].shape), atol=1e-13)
    np.testing.assert_allclose(det, np.linalg.det(A), rtol=1e-13)
    np.testing.assert_array_equal(determinants(dN, xy), det)


def test_jacobian_integrates_area_and_gradient_of_a_quadrilateral() -> None:
    """On a distorted quadrilateral det J integrates to the shoelace area, and its inverse gives gradients."""
    xy = quadrilateral(seed=5)
    points, weights = gauss(3)
    dN = q9(points)[1]
    inverse, det = inverse_jacobian(dN, xy)
    x, y = xy[0, :4].T
    area = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
    assert (det * weights).sum() == pytest.approx(area, rel=1e-13)
    J = np.einsum("pia,eax->epix", dN, xy)
    np.testing.assert_allclose(inverse @ J, np.broadcast_to(np.eye(2), J.shape), atol=1e-13)
    gradient = np.einsum("epxi,pia,ea->epx", inverse, dN, xy[..., 0] * 2 - 5 * xy[..., 1])
    np.testing.assert_allclose(gradient, np.broadcast_to([2.0, -5.0], gradient.shape), atol=1e-12)
