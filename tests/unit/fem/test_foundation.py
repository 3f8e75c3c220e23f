"""Ground: the interface element, stacks of layers, and the tails of infinite ground, against integrals made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.fem.foundation import (
    EDGE_MASS,
    EDGE_SLOPE,
    Column,
    Layer,
    consistent_stack,
    edge_decay,
    interface_stack,
    mass_and_slope,
    single,
)
from groundslab.fem.shape_functions import COLUMN, ROW
from helpers.quads import integration, quadrilateral

#: Three nodes of a line in their order, length h = 1: int N N^T and int N' N'^T.
MASS = np.array([[4.0, 2.0, -1.0], [2.0, 16.0, 2.0], [-1.0, 2.0, 4.0]]) / 30
SLOPE = np.array([[7.0, -8.0, 1.0], [-8.0, 16.0, -8.0], [1.0, -8.0, 7.0]]) / 3
LAYERS = [Layer(2.0, (30e6, 20e6, 0.0), 0.3), Layer(1.0, (90e6, 0.0, 0.0), 0.2), Layer(4.0, (60e6, 10e6, 40e6), 0.4)]
#: A stack of interface layers and a consistent one, as (A0, A1).
COLUMNS = {
    "interface": interface_stack(np.array([30e6, 50e6, 80e6]), np.array([20e6, 9e6, 40e6])),
    "consistent": consistent_stack(LAYERS),
    "two": interface_stack(np.array([1.0, 4.0]), np.array([1.0, 0.3])),
}


def rectangle(a: float, b: float) -> np.ndarray:
    """Return the nodes (1, 9, 2) of a rectangle a x b somewhere in the plane."""
    return np.column_stack([3.0 + COLUMN * a / 2, -1.0 + ROW * b / 2])[None]


def tensor(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Return the 9 x 9 matrix of a matrix along x times one along y."""
    return first[np.ix_(COLUMN, COLUMN)] * second[np.ix_(ROW, ROW)]


def test_mass_and_slope_on_a_rectangle() -> None:
    """On a rectangle the integrals are products of line integrals."""
    a, b = 1.7, 0.6
    mass, slope = mass_and_slope(rectangle(a, b))
    np.testing.assert_allclose(mass[0], a * b * tensor(MASS, MASS), rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(
        slope[0], b / a * tensor(SLOPE, MASS) + a / b * tensor(MASS, SLOPE), rtol=1e-12, atol=1e-14
    )


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_mass_and_slope_on_a_quadrilateral(seed: int) -> None:
    """On distorted elements the integrals agree with a 20 x 20 rule: mass exactly, slope to the rule's accuracy."""
    xy = quadrilateral(seed, amount=0.25)
    mass, slope = mass_and_slope(xy)
    N, det, weight, _, _ = integration(xy, 20)
    np.testing.assert_allclose(mass[0], np.einsum("p,pa,pb->ab", det[0] * weight, N, N), atol=1e-14)
    # grad N from the corners' bilinear map
    r, _ = np.polynomial.legendre.leggauss(20)
    R, S = (x.ravel() for x in np.meshgrid(r, r))
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    dr = corners[:, 0] * (1 + np.outer(S, corners[:, 1])) / 4
    ds = corners[:, 1] * (1 + np.outer(R, corners[:, 0])) / 4
    J = np.stack([dr @ xy[0, :4], ds @ xy[0, :4]], axis=1)
    line = [lambda x: x * (x - 1) / 2, lambda x: 1 - x * x, lambda x: x * (x + 1) / 2]
    deriv = [lambda x: x - 0.5, lambda x: -2 * x, lambda x: x + 0.5]
    dN = np.stack(
        [
            np.column_stack([deriv[c](R) * line[w](S) for c, w in zip(COLUMN, ROW, strict=True)]),
            np.column_stack([line[c](R) * deriv[w](S) for c, w in zip(COLUMN, ROW, strict=True)]),
        ],
        axis=1,
    )
    grad = np.linalg.solve(J, dN)
    wanted = np.einsum("p,pia,pib->ab", det[0] * weight, grad, grad)
    np.testing.assert_allclose(slope[0], wanted, atol=1e-3 * np.abs(wanted).max())
    np.testing.assert_allclose(slope[0].sum(axis=0), 0, atol=1e-12)


def test_single_surface_takes_numbers_and_arrays() -> None:
    """One surface: k0 and k1 themselves; arrays over elements become (m, 1, 1), a lone number goes with an array."""
    column = single(3.0, 2.0)
    assert (column.A0.shape, column.A0[0, 0], column.A1[0, 0], column.surfaces) == ((1, 1), 3.0, 2.0, 1)
    column = single(np.array([1.0, 2.0, 3.0]), 5.0)
    assert column.A0.shape == column.A1.shape == (3, 1, 1)
    np.testing.assert_array_equal(column.A1[:, 0, 0], [5.0, 5.0, 5.0])


def test_interface_stack_energy() -> None:
    """w.A0 w is the sum of k0 (w_i - w_i+1)^2 with the base at rest, w.A1 w likewise with k1."""
    rng = np.random.default_rng(1)
    k0, k1, w = rng.random(4), rng.random(4), rng.standard_normal(4)
    column = interface_stack(k0, k1)
    d = w - np.r_[w[1:], 0.0]
    assert w @ column.A0 @ w == pytest.approx(k0 @ d**2)
    assert w @ column.A1 @ w == pytest.approx(k1 @ d**2)
    assert column.surfaces == 4


def test_interface_stack_moved_as_a_whole_strains_its_lowest_layer_alone() -> None:
    """Rigid motion of the stack: no force on any surface but that of the layer on the rigid base."""
    column = interface_stack(np.array([3.0, 5.0, 8.0]), np.array([1.0, 2.0, 4.0]))
    np.testing.assert_allclose(column.A0 @ np.ones(3), [0, 0, 8.0], atol=1e-14)
    np.testing.assert_allclose(column.A1 @ np.ones(3), [0, 0, 4.0], atol=1e-14)


def test_interface_stack_by_elements() -> None:
    """Arrays (m, L) give for each element what its own numbers give alone."""
    rng = np.random.default_rng(2)
    k0, k1 = rng.random((5, 3)), rng.random((5, 3))
    together = interface_stack(k0, k1)
    for e in range(5):
        alone = interface_stack(k0[e], k1[e])
        np.testing.assert_array_equal(together.A0[e], alone.A0)
        np.testing.assert_array_equal(together.A1[e], alone.A1)


def test_consistent_stack_against_quadrature_with_hats() -> None:
    """A0 = int Ec phi_i' phi_j' dz, A1 = int G phi_i phi_j dz with hat functions over the depth, E(z) inside."""
    column = consistent_stack(LAYERS)
    tops = np.concatenate([[0.0], np.cumsum([layer.thickness for layer in LAYERS])])
    x, weight = np.polynomial.legendre.leggauss(6)
    A0, A1 = np.zeros((3, 3)), np.zeros((3, 3))
    for number, layer in enumerate(LAYERS):
        h, nu = layer.thickness, layer.nu
        z = tops[number] + (x + 1) / 2 * h
        E = np.polynomial.polynomial.polyval((x + 1) / 2, layer.moduli)
        hats = np.array([np.interp(z, tops, np.eye(4)[i]) for i in range(3)])
        step = 1e-3 * h
        slopes = np.array(
            [
                (np.interp(z + step, tops, np.eye(4)[i]) - np.interp(z - step, tops, np.eye(4)[i])) / (2 * step)
                for i in range(3)
            ]
        )
        A0 += np.einsum("is,js,s->ij", slopes, slopes, E * weight * h / 2) * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
        A1 += np.einsum("is,js,s->ij", hats, hats, E * weight * h / 2) / (2 * (1 + nu))
    np.testing.assert_allclose(column.A0, A0, rtol=1e-9, atol=1e-3)
    np.testing.assert_allclose(column.A1, A1, rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_parts_of_a_layer_keep_its_moduli(n: int) -> None:
    """Each part has, at its own depths, the E of the whole layer; thicknesses add up."""
    layer = LAYERS[2]
    parts = layer.split(n)
    assert sum(part.thickness for part in parts) == pytest.approx(layer.thickness)
    s = np.linspace(0, 1, 7)
    for i, part in enumerate(parts):
        np.testing.assert_allclose(part.E(s), layer.E((i + s) / n), rtol=1e-13)
        assert part.nu == layer.nu
        assert part.mean == pytest.approx(
            np.polynomial.legendre.leggauss(5)[1] @ part.E((1 + np.polynomial.legendre.leggauss(5)[0]) / 2) / 2
        )


def test_parts_moved_by_the_layers_hat_have_the_layers_energy() -> None:
    """A settlement linear over the whole layer costs the same energy before and after splitting it."""
    layer = LAYERS[2]
    whole, parts = consistent_stack([layer]), consistent_stack(layer.split(4))
    w = np.linspace(1, 0, 5)[:4]
    assert w @ parts.A0 @ w == pytest.approx(whole.A0[0, 0], rel=1e-12)
    assert w @ parts.A1 @ w == pytest.approx(whole.A1[0, 0], rel=1e-12)


def test_edge_matrices_are_the_line_integrals() -> None:
    """Mass and slope of an edge (end, end, middle) are those of a three-node line in another order."""
    order = [0, 2, 1]
    np.testing.assert_allclose(EDGE_MASS, MASS[np.ix_(order, order)], atol=1e-16)
    np.testing.assert_allclose(EDGE_SLOPE, SLOPE[np.ix_(order, order)], atol=1e-15)


def test_tail_of_a_single_surface() -> None:
    """The decay is sqrt(k0/k1); spring sqrt(k0 k1), slope k1 / 2a, corner 3 k1 / 4; squares 1/2a, a/2, 1/4a^2, 1/2."""
    k0, k1 = 32.8e6, 20.7e6
    a = np.sqrt(k0 / k1)
    t = edge_decay(single(k0, k1))
    assert t.decay[0] == pytest.approx(a)
    assert t.spring[0, 0] == pytest.approx(np.sqrt(k0 * k1))
    assert t.slope[0, 0] == pytest.approx(k1 / (2 * a))
    assert t.corner[0, 0] == pytest.approx(0.75 * k1)
    share = t.projection[0, 0] ** 2  # from the square of an amplitude to that of w
    X, Y, Xc, Yc = (M[0, 0] * share for M in t.square_integrals())
    assert (X, Y, Xc, Yc) == pytest.approx((1 / (2 * a), a / 2, 1 / (4 * a**2), 0.5))


@pytest.mark.parametrize("column", COLUMNS.values(), ids=COLUMNS.keys())
def test_tail_modes(column: Column) -> None:
    """The modes solve A0 phi = a^2 A1 phi, are orthonormal in A1, and their shares add up to the edge's settlement."""
    t = edge_decay(column)
    scale = np.abs(column.A0 @ t.phi).max()
    np.testing.assert_allclose(column.A0 @ t.phi, column.A1 @ t.phi * t.decay**2, atol=1e-11 * scale)
    np.testing.assert_allclose(t.phi.T @ column.A1 @ t.phi, np.eye(len(t.decay)), atol=1e-12)
    np.testing.assert_allclose(t.phi @ t.projection, np.eye(len(t.decay)), atol=1e-11)
    assert (t.decay > 0).all()


@pytest.mark.slow
@pytest.mark.parametrize("column", COLUMNS.values(), ids=COLUMNS.keys())
def test_tail_spring_equals_a_long_strip(column: Column) -> None:
    """Held at one end, a strip of ground 25 decay lengths long, in 600 quadratic elements, is as stiff as the tail."""
    S = column.surfaces
    a = np.sqrt(np.linalg.eigvals(np.linalg.solve(column.A1, column.A0)).real)
    longest, shortest = 25 / a.min(), 0.1 / a.max()
    ends = np.concatenate([[0.0], np.geomspace(shortest, longest, 600)])
    n = 2 * len(ends) - 1
    K = np.zeros((n * S, n * S))
    for e, h in enumerate(np.diff(ends)):
        dof = (np.arange(3) + 2 * e)[:, None] * S + np.arange(S)
        K[np.ix_(dof.ravel(), dof.ravel())] += np.kron(MASS * h, column.A0) + np.kron(SLOPE / h, column.A1)
    spring = K[:S, :S] - K[:S, S:] @ np.linalg.solve(K[S:, S:], K[S:, :S])
    np.testing.assert_allclose(edge_decay(column).spring, spring, rtol=2e-5, atol=2e-5 * np.abs(spring).max())


@pytest.mark.parametrize("column", COLUMNS.values(), ids=COLUMNS.keys())
def test_tail_energies_by_quadrature(column: Column) -> None:
    """Energies and squares of the decaying field, integrated numerically over the ground beyond, are the matrices'.

    Along an edge w(d, s) = sum of phi exp(-a d) c(s); in the quarter plane w(x, y) = sum of phi exp(-a (x + y)) c.
    """
    t = edge_decay(column)
    rng = np.random.default_rng(3)
    w, ws = rng.standard_normal(column.surfaces), rng.standard_normal(column.surfaces)
    c, cs = t.projection @ w, t.projection @ ws
    x, weight = np.polynomial.legendre.leggauss(20)
    cuts = np.linspace(0, 30 / t.decay.min(), 400)
    d = (cuts[:-1, None] + (x + 1) / 2 * np.diff(cuts)[:, None]).ravel()
    dd = (weight / 2 * np.diff(cuts)[:, None]).ravel()
    shape = np.exp(-np.outer(d, t.decay))  # (points, modes)
    field, along, across = (shape * c) @ t.phi.T, (shape * cs) @ t.phi.T, (shape * c * -t.decay) @ t.phi.T

    def form(u: np.ndarray, A: np.ndarray) -> float:
        return float(dd @ np.einsum("pi,ij,pj->p", u, A, u))

    assert w @ t.spring @ w == pytest.approx(form(field, column.A0) + form(across, column.A1), rel=1e-8)
    assert ws @ t.slope @ ws == pytest.approx(form(along, column.A1), rel=1e-8)
    X, Y, Xc, Yc = t.square_integrals()
    assert c @ X @ c == pytest.approx(dd @ field[:, 0] ** 2, rel=1e-8)
    assert cs @ X @ cs == pytest.approx(dd @ along[:, 0] ** 2, rel=1e-8)
    assert c @ Y @ c == pytest.approx(dd @ across[:, 0] ** 2, rel=1e-8)

    # with r = x + y the quarter plane's area is r dr, and each of the two slopes is that along r
    assert c @ Xc @ c == pytest.approx((dd * d) @ field[:, 0] ** 2, rel=1e-8)
    assert c @ Yc @ c == pytest.approx(2 * (dd * d) @ across[:, 0] ** 2, rel=1e-8)
    energy = (dd * d) @ (
        np.einsum("pi,ij,pj->p", field, column.A0, field) + 2 * np.einsum("pi,ij,pj->p", across, column.A1, across)
    )
    assert w @ t.corner @ w == pytest.approx(energy, rel=1e-8)
