"""Trials that every plate element must pass; an element joins them by being entered in plate.ELEMENTS."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.fem import plate
from groundslab.fem.shape_functions import gauss, q9
from helpers import quads

every_element = pytest.mark.parametrize("name", plate.ELEMENTS)
E, NU = 1.0, 0.3


def monomials(xy: np.ndarray) -> np.ndarray:
    """Return 1, x, y, x^2, xy, y^2 at points (..., 2) as (..., 6)."""
    x, y = xy[..., 0], xy[..., 1]
    return np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1)


@every_element
def test_name_is_its_key(name: str) -> None:
    """An element is found in the list under its own name."""
    assert plate.ELEMENTS[name].name == name


@every_element
def test_partition_of_unity(name: str) -> None:
    """The functions of w sum to one, and those of distorted elements give back every quadratic in x and y."""
    xy = np.concatenate([quads.quadrilateral(seed, amount) for seed, amount in [(1, 0.0), (2, 0.3), (3, 0.4)]])
    T = plate.ELEMENTS[name].w_functions(xy)
    np.testing.assert_allclose(T.sum(axis=2), 1.0, atol=1e-13)
    N = q9(gauss(4)[0])[0]
    functions = N @ T
    np.testing.assert_allclose(functions.sum(axis=2), 1.0, atol=1e-13)
    points = N @ xy
    np.testing.assert_allclose(functions @ monomials(xy), monomials(points), atol=1e-12)


@every_element
def test_centre_hangs_on_the_others_or_does_not(name: str) -> None:
    """Without a w of its own the centre's column of T is empty; the boundary's w never depends on anything else."""
    element = plate.ELEMENTS[name]
    T = element.w_functions(quads.quadrilateral())[0]
    np.testing.assert_array_equal(T[:8], np.eye(9)[:8])
    assert T[8, 8] == (1.0 if element.center_w else 0.0)


@every_element
@pytest.mark.parametrize("t", [1.0, 0.01])
@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_three_rigid_motions_and_no_more(name: str, t: float, seed: int) -> None:
    """W = a + b x + c y with rotations b, c costs nothing, and every other motion of one distorted element does."""
    xy = quads.quadrilateral(seed)
    K = quads.stiffness(name, xy, t)[0]
    x, y = xy[0].T
    zero, one = np.zeros(9), np.ones(9)
    rigid = np.column_stack([np.r_[one, zero, zero], np.r_[x, one, zero], np.r_[y, zero, one]])
    scale = np.abs(K).max()
    exist = ~quads.centres(name, np.arange(9)[None], 9)
    np.testing.assert_allclose(K @ rigid, 0, atol=1e-12 * scale)
    np.testing.assert_allclose(K[:, ~exist], 0, atol=1e-13 * scale)
    np.testing.assert_allclose(K, K.T, atol=1e-13 * scale)
    # in the measure of a stiffness that knows both bending and shear, so that thin elements are judged fairly
    K = K[np.ix_(exist, exist)]
    values = np.linalg.eigvalsh(K)
    assert np.abs(values[:3]).max() < 1e-12 * values[-1]
    assert values[3] > 1e-4 * t**2 * values[-1]


def patch_meshes() -> list[tuple[np.ndarray, np.ndarray]]:
    """Return distorted meshes of the rectangle 2 x 1.5."""
    return [quads.mesh(3, 2, 2.0, 1.5, 0.25, seed) for seed in (1, 2)] + [quads.mesh(4, 4, 2.0, 1.5, 0.3, 3)]


def on_boundary(nodes: np.ndarray) -> np.ndarray:
    """Return which nodes lie on the edge of the rectangle."""
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    return (np.isclose(nodes, low) | np.isclose(nodes, high)).any(axis=1)


@every_element
@pytest.mark.parametrize("t", [0.5, 0.02, 1e-3])
@pytest.mark.parametrize("state", range(3))
def test_constant_curvature(name: str, t: float, state: int) -> None:
    """Patch test: with w = x^2/2, xy or y^2/2 and its slopes held on the boundary the inside follows exactly.

    On distorted meshes, moderately thick and thin; without shear and with one and the same moment everywhere.
    """
    for nodes, elements in patch_meshes():
        n, xy = len(nodes), nodes[elements]
        x, y = nodes.T
        w, bx, by = [(x * x / 2, x, 0 * x), (x * y, y, x), (y * y / 2, 0 * x, y)][state]
        exact = np.concatenate([w + 1 - 2 * x, bx - 2, by])
        A = quads.assemble(quads.stiffness(name, xy, t), elements, n)
        none = quads.centres(name, elements, n)
        held = np.tile(on_boundary(nodes), 3)
        exact[none] = 0.0
        u = quads.solve(A, np.zeros(3 * n), held | none, exact)
        np.testing.assert_allclose(u, exact, atol=1e-7 if t < 0.01 else 1e-10)

        ue = np.concatenate([u[elements], u[elements + n], u[elements + 2 * n]], axis=1)
        D = np.broadcast_to(plate.bending_rigidity(E, NU, t), (len(xy), 3, 3))
        S = np.full(len(xy), plate.shear_rigidity(E, NU, t, 5 / 6))
        M = plate.section_forces(plate.ELEMENTS[name], gauss(2)[0], xy, D, S, ue)[..., :3]
        curvature = np.array([(1.0, 0, 0), (0, 0, 2.0), (0, 1.0, 0)])[state]
        wanted = -D[0] @ curvature
        np.testing.assert_allclose(M, np.broadcast_to(wanted, M.shape), atol=1e-5 * np.abs(wanted).max())


@every_element
@pytest.mark.parametrize("t", [0.5, 0.02])
def test_constant_shear(name: str, t: float) -> None:
    """Patch test: rotations held, w linear on the boundary; the inside follows, with one shear force."""
    for nodes, elements in patch_meshes():
        n, xy = len(nodes), nodes[elements]
        x, y = nodes.T
        exact = np.concatenate([0.3 + 2 * x - y, np.full(n, 0.5), np.full(n, -0.25)])
        none = quads.centres(name, elements, n)
        exact[none] = 0.0
        held = np.concatenate([on_boundary(nodes), np.ones(2 * n, dtype=bool)])
        A = quads.assemble(quads.stiffness(name, xy, t), elements, n)
        u = quads.solve(A, np.zeros(3 * n), held | none, exact)
        np.testing.assert_allclose(u, exact, atol=1e-10)

        ue = np.concatenate([u[elements], u[elements + n], u[elements + 2 * n]], axis=1)
        D = np.broadcast_to(plate.bending_rigidity(E, NU, t), (len(xy), 3, 3))
        S = plate.shear_rigidity(E, NU, t, 5 / 6)
        forces = plate.section_forces(plate.ELEMENTS[name], gauss(3)[0], xy, D, np.full(len(xy), S), ue)
        M, Q = forces[..., :3], forces[..., 3:]
        np.testing.assert_allclose(Q, np.broadcast_to(S * np.array([1.5, -0.75]), Q.shape), rtol=1e-9)
        np.testing.assert_allclose(M, 0, atol=1e-10)


@every_element
@pytest.mark.parametrize("angle", [0.3, np.pi / 2, 2.5])
def test_turned_element_has_the_turned_stiffness(name: str, angle: float) -> None:
    """Turning the element and its rotations by any angle leaves the energy as it was: no direction is preferred."""
    xy = quads.quadrilateral(seed=7)
    c, s = np.cos(angle), np.sin(angle)
    R = np.array([[c, -s], [s, c]])
    K, turned = quads.stiffness(name, xy, 0.1)[0], quads.stiffness(name, xy @ R.T, 0.1)[0]
    one = np.eye(9)
    Q = np.block([[one, 0 * one, 0 * one], [0 * one, c * one, -s * one], [0 * one, s * one, c * one]])
    np.testing.assert_allclose(turned, Q @ K @ Q.T, atol=1e-11 * np.abs(K).max())


@every_element
@pytest.mark.parametrize("start", [1, 2, 3])
def test_first_corner_does_not_matter(name: str, start: int) -> None:
    """Numbering the same element from another corner gives the same energy."""
    xy = quads.quadrilateral(seed=8)
    order = np.r_[np.roll(np.arange(4), -start), 4 + np.roll(np.arange(4), -start), 8]
    all_fields = np.concatenate([order, order + 9, order + 18])
    K, other = quads.stiffness(name, xy, 0.1)[0], quads.stiffness(name, xy[:, order], 0.1)[0]
    np.testing.assert_allclose(other, K[np.ix_(all_fields, all_fields)], atol=1e-11 * np.abs(K).max())


@every_element
def test_stiffness_scales_with_size(name: str) -> None:
    """With all lengths, thickness too, times s the energy of the scaled motion is s^3 times as large."""
    xy, s = quads.quadrilateral(seed=9), 7.0
    K, scaled = quads.stiffness(name, xy, 0.1)[0], quads.stiffness(name, s * xy, s * 0.1)[0]
    unit = np.r_[np.full(9, s), np.ones(18)]  # settlements are lengths, rotations are not
    np.testing.assert_allclose(unit[:, None] * scaled * unit, s**3 * K, atol=1e-10 * np.abs(K).max() * s**3)


def errors(name: str, n: int, t: float, amount: float, split: int = 1) -> tuple[float, float]:
    """Return the relative errors (L2) of w and of the curvatures on n x n elements, each split.

    Simply supported unit square (hard), pressure sin(pi x) sin(pi y): w and beta are sines, known in closed form.
    """
    nodes, elements = quads.mesh(n, n, 1.0, 1.0, amount, split=split)
    xy, N = nodes[elements], len(nodes)
    k2 = 2 * np.pi**2
    D, S = plate.bending_rigidity(E, NU, t)[0, 0], plate.shear_rigidity(E, NU, t, 5 / 6)
    slope = 1 / (D * k2**2)
    height = slope * (1 + D * k2 / S)
    x, y = nodes.T
    held = np.zeros((3, N), dtype=bool)
    held[0] = on_boundary(nodes)
    held[1] = np.isclose(y, 0) | np.isclose(y, 1)
    held[2] = np.isclose(x, 0) | np.isclose(x, 1)
    A = quads.assemble(quads.stiffness(name, xy, t), elements, N)
    f = quads.load(name, xy, elements, N, lambda a, b: np.sin(np.pi * a) * np.sin(np.pi * b))
    none = quads.centres(name, elements, N)
    u = quads.solve(A, f, held.ravel() | none, np.zeros(3 * N))

    shape, det, weight, px, py = quads.integration(xy)
    dA = det * weight
    T = plate.ELEMENTS[name].w_functions(xy)
    w = np.einsum("pa,eab,eb->ep", shape, T, u[elements])
    exact = height * np.sin(np.pi * px) * np.sin(np.pi * py)
    off = np.sqrt((dA * (w - exact) ** 2).sum() / (dA * exact**2).sum())
    r, _ = np.polynomial.legendre.leggauss(5)
    at = np.column_stack([a.ravel() for a in np.meshgrid(r, r)])
    ue = np.concatenate([u[elements], u[elements + N], u[elements + 2 * N]], axis=1)
    kappa = np.einsum("epcu,eu->epc", plate.bending_strain(at, xy), ue)
    sines, cosines = np.sin(np.pi * px) * np.sin(np.pi * py), np.cos(np.pi * px) * np.cos(np.pi * py)
    wanted = slope * np.pi**2 * np.stack([-sines, -sines, 2 * cosines], axis=-1)
    bending = np.sqrt((dA[..., None] * (kappa - wanted) ** 2).sum() / (dA[..., None] * wanted**2).sum())
    return float(off), float(bending)


@pytest.mark.slow
@every_element
@pytest.mark.parametrize("t", [0.2, 0.01])
@pytest.mark.parametrize("amount", [0.0, 0.25])
def test_order_of_convergence(name: str, t: float, amount: float) -> None:
    """A smooth solution is met with third order in w and second order in curvature, as biquadratics can.

    On a mesh of 4 x 4 distorted elements that are split regularly. Displacement shear reaches its order only when
    elements are no longer than a few thicknesses.
    """
    splits = (4, 8) if name == "q9" and t < 0.1 else (2, 4)
    coarse, fine = (errors(name, 4, t, amount, split) for split in splits)
    order_w, order_bending = np.log2(np.array(coarse) / np.array(fine))
    assert order_w > 2.7
    assert order_bending > 1.75
    assert fine[0] < 5e-4
    assert fine[1] < 2e-2


@pytest.mark.slow
@every_element
@pytest.mark.parametrize("t", [0.2, 0.01])
def test_convergence_on_meshes_that_stay_distorted(name: str, t: float) -> None:
    """Where finer meshes are as crooked as coarse ones, strains tied in covariant components lose an order, no more.

    (Arnold, Boffi and Falk 2002 and 2005 for serendipity functions and for edge elements.)
    """
    coarse, fine = (errors(name, n, t, 0.2) for n in (8, 16))
    order_w, order_bending = np.log2(np.array(coarse) / np.array(fine))
    assert order_w > 1.9
    assert order_bending > 0.9
