"""Mindlin-Reissner plate elements with nine nodes: stiffness, and strains at points.

Unknowns of an element, field after field: w (9), beta_x (9), beta_y (9). Every element is a value of PlateElement;
ELEMENTS lists them, and the tests put each entry of the list through the same trials.

Sources: the paper (2.1); Hughes and Cohen 1978 (heterosis); Kikuchi, Okabe and Fujio 1999 (its center value on
quadrilaterals that are no parallelograms); Bathe, Brezzi and Cho 1989 (MITC9). See docs/bibliography.md.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import SIDES
from groundslab.fem.shape_functions import (
    CHUNK,
    SERENDIPITY_CENTER,
    along_axes,
    derivatives,
    determinants,
    gauss,
    gradients,
    inverse_jacobian,
    parallelograms,
    q9,
)

#: Where MITC9 takes the covariant shear strain along xi: at two points of each side, and all over for its mean.
_SIDES = np.array([(r, s) for s in (-1.0, 1.0) for r in (-1 / np.sqrt(3.0), 1 / np.sqrt(3.0))])
_TIED = np.vstack([_SIDES, gauss(3)[0]])
#: What it takes there: the four values, and the mean.
_TAKEN = np.zeros((5, 13))
_TAKEN[:4, :4], _TAKEN[4, 4:] = np.eye(4), gauss(3)[1] / 4


@dataclass(frozen=True, slots=True)
class Sampling:
    """How the covariant shear strain along one axis at p points follows from w,xi - beta . x,xi at q others."""

    points: Array  # (q, 2)
    factors: Array  # (r, q): sums of the strains there
    functions: Array  # (p, r): of these sums


@dataclass(frozen=True, slots=True)
class PlateElement:
    """One way to make a plate element: where its shear strain is taken from, shear rule and interpolation of w."""

    name: str
    sample: Callable[[Array], tuple[Sampling, Sampling]]  # along xi and along eta, for points (p, 2)
    shear_points: int
    center_w: bool  # whether the center node has a w of its own
    tied: bool = False  # whether the strains of neighbors agree on their common side, if that is half of one's, too

    def w_functions(self, xy: Array) -> Array:
        """Return T (m, 9, 9) with w = N T w: the identity, or the center's w from the eight others."""
        if self.center_w:
            return np.broadcast_to(np.eye(9), (len(xy), 9, 9))
        T = np.tile(np.eye(9), (len(xy), 1, 1))
        T[:, 8, :8], T[:, 8, 8] = _centre_from_boundary(xy), 0.0
        return T

    def covariant_shear(self, points: Array, xy: Array, T: Array, halves: Integers | None = None) -> Array:
        """Return B (m, 2, p, 27) with (w,xi - beta . x,xi ; w,eta - beta . x,eta) = B u at points (p, 2).

        halves (m, 4) tell which sides are half of a neighbor's, see `hanging.find_halves`; by default none is.
        """
        B = np.stack([
            sampling.functions @ sums_of_covariant_shear(axis, sampling.points, sampling.factors, xy, T)
            for axis, sampling in enumerate(self.sample(points))
        ], axis=1)  # fmt: skip
        if self.tied and halves is not None:
            for elements, middle, unknown, share in _whole_sides(xy, halves):
                B[elements, :, :, unknown] += share[:, None, None] * B[elements, :, :, middle]
        return B

    def covariant_strain(self, points: Array, xy: Array, u: Array, halves: Integers | None = None) -> Array:
        """Return B u (m, p, 2) for unknowns u (m, 27), see `covariant_shear`."""
        w, beta = u[:, :9].copy(), u[:, 9:].reshape(-1, 2, 9)
        if self.tied and halves is not None:
            for elements, middle, unknown, share in _whole_sides(xy, halves):
                w[elements, middle] += share * u[elements, unknown]
        if not self.center_w:
            w[:, 8] = (_centre_from_boundary(xy) * w[:, :8]).sum(axis=1)
        shear = np.empty((len(u), len(points), 2))
        for axis, sampling in enumerate(self.sample(points)):
            N, dN = q9(sampling.points)
            d = dN[:, axis].T
            strain = w @ d - ((xy.swapaxes(1, 2) @ d) * (beta @ N.T)).sum(axis=1)
            shear[..., axis] = strain @ (sampling.functions @ sampling.factors).T
        return shear


def bending_strain(points: Array, xy: Array) -> Array:
    """Return B_b (m, p, 3, 27) with (beta_x,x ; beta_y,y ; beta_x,y + beta_y,x) = B_b u at points (p, 2)."""
    x, y, _ = derivatives(points, xy)
    B = np.zeros((*x.shape[:2], 3, 27))
    B[..., 0, 9:18] = B[..., 2, 18:27] = x
    B[..., 1, 18:27] = B[..., 2, 9:18] = y
    return B


def sums_of_covariant_shear(axis: int, points: Array, factors: Array, xy: Array, T: Array) -> Array:
    """Return B (m, r, 27): sums of w,xi - beta . x,xi at points (p, 2) with factors (r, p); along eta for axis 1."""
    N, dN = q9(points)
    d = dN[:, axis]
    of_places = np.einsum("rp,pa,pb->arb", factors, d, N).reshape(9, -1)
    B = np.empty((len(xy), len(factors), 27))
    B[..., :9] = (factors @ d) @ T
    for k in (0, 1):
        B[..., 9 * (k + 1) : 9 * (k + 2)] = (xy[..., k] @ -of_places).reshape(-1, len(factors), 9)
    return B


def displacement_shear(points: Array) -> tuple[Sampling, Sampling]:
    """Return where strains straight from displacements are taken: at the points (p, 2) themselves."""
    sampling = Sampling(points, np.eye(len(points)), np.eye(len(points)))
    return sampling, sampling


def tied_shear(points: Array) -> tuple[Sampling, Sampling]:
    """Return where the strains of MITC9 are taken: tied on the element's sides and in their mean.

    The strain along xi lies in span(1, xi, eta, xi eta, eta^2); it takes the values of w,xi - beta . x,xi at the Gauss
    points of the sides eta = -1 and 1, and its mean over the reference square; along eta likewise (Bathe, Brezzi and
    Cho 1989). Two elements share what is tied on their common side, which is why the element does not lock on
    distorted meshes either. A bubble of w has no part in this strain: the center's w hangs on the eight others.
    """
    along_xi = Sampling(_TIED, _TAKEN, _tying_functions(points))
    return along_xi, Sampling(_TIED[:, ::-1], _TAKEN, _tying_functions(points[:, ::-1]))


def _whole_sides(xy: Array, halves: Integers) -> Iterator[tuple[Integers, int, int, Array]]:
    """Yield what gives the middles of half sides the w of the neighbor's whole side.

    Elements (k,), the node in the middle, and an unknown of which its w takes a share (k,).

    What is tied on a side is the slope of a cubic w less beta, of which w at its three nodes says nothing else: its
    slope differs from beta by a line. In the middle of a half the cubic is off the parabola through these nodes by
    1/4 of the half's length times the second difference of beta along it. With the parabola's w, elements would lock.
    """
    for side, (start, end, middle) in enumerate(SIDES):
        elements = np.flatnonzero(halves[:, side])
        way = halves[elements, side, None] * (xy[elements, end] - xy[elements, start]) / 4
        for k in (0, 1):
            for node, share in ((start, 1), (middle, -2), (end, 1)):
                yield elements, middle, 9 * (k + 1) + node, share * way[:, k]


def _tying_functions(points: Array) -> Array:
    """Return the functions (p, 4 + 1) of the values at the side points and of the mean."""
    r, s = points[:, :1], points[:, 1:]
    on_sides = (1 + r * _SIDES[:, 0] * 3) * (1 + s * _SIDES[:, 1]) / 4
    bulge = 1.5 * (1 - s * s)
    return np.hstack([on_sides - bulge / 4, bulge])


def _centre_from_boundary(xy: Array) -> Array:
    """Return the shares (m, 8) of the other nodes' w in the center's, such that every quadratic in x, y is met.

    On a parallelogram this is the serendipity rule. On other quadrilaterals the smallest correction of it is taken
    that keeps 1, x, y, x^2, xy, y^2 exact (in the manner of Kikuchi, Okabe and Fujio 1999), without which no element
    with a serendipity w passes the constant-curvature patch test.
    """
    shares = np.tile(SERENDIPITY_CENTER, (len(xy), 1))
    odd = np.flatnonzero(~parallelograms(xy))
    centred = xy[odd] - xy[odd, 8:]
    x, y = np.moveaxis(centred / np.abs(centred).max(axis=(1, 2), keepdims=True), -1, 0)
    A = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)  # (m, 6, 9)
    wanted = A[:, :, 8] - A[:, :, :8] @ SERENDIPITY_CENTER
    A = A[:, :, :8]
    # the smallest correction is A^T (A A^T)^-1 wanted; what the shift does to it is put right by a second step
    inverse = np.linalg.inv(A @ A.swapaxes(1, 2) + 1e-12 * np.eye(6))
    for _ in range(2):
        left = wanted - np.einsum("eab,eb->ea", A, shares[odd] - SERENDIPITY_CENTER)
        shares[odd] += np.einsum("eab,ea->eb", A, np.einsum("eab,eb->ea", inverse, left))
    return shares


#: The paper's element comes first; the default is "mitc9".
ELEMENTS: dict[str, PlateElement] = {
    "q9": PlateElement("q9", displacement_shear, 3, center_w=True),
    "heterosis": PlateElement("heterosis", displacement_shear, 2, center_w=False),
    "mitc9": PlateElement("mitc9", tied_shear, 3, center_w=False, tied=True),
}


def bending_rigidity(E: float, nu: float, t: float) -> Array:
    """Return the matrix (3, 3) [N m] between curvatures and moments, D = E t^3 / 12(1 - nu^2)."""
    D = E * t**3 / (12 * (1 - nu**2))
    return D * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])


def shear_rigidity(E: float, nu: float, t: float, factor: float) -> float:
    """Return factor * G * t [N/m]."""
    return factor * E / (2 * (1 + nu)) * t


def stiffness(element: PlateElement, xy: Array, D: Array, S: Array, T: Array, halves: Integers | None = None) -> Array:
    """Return the stiffness matrices (m, 27, 27) of m plate elements [N/m, N, N m].

    xy (m, 9, 2) are the nodes [m], D (m, 3, 3) the bending rigidities [N m], S (m,) the shear rigidities [N/m],
    T (m, 9, 9) the element's `w_functions`, halves (m, 4) its sides that are half of a neighbor's, by default none.
    """
    K = np.empty((len(xy), 27, 27))
    for start in range(0, len(xy), CHUNK):
        chunk = slice(start, start + CHUNK)
        K[chunk] = _shear_stiffness(element, xy[chunk], S[chunk], T[chunk], None if halves is None else halves[chunk])
        K[chunk, 9:, 9:] += symmetric_gradient_stiffness(xy[chunk], D[chunk])
    return K


def symmetric_gradient_stiffness(xy: Array, D: Array) -> Array:
    """Return int B_b^T D B_b dA (m, 18, 18) between two fields, by products of their derivatives by x and y.

    These are the rotations and rigidities D (m, 3, 3) against bending, or displacements in the plate's plane and those
    against stretching.
    """
    points, weights = gauss(3)
    x, y, det = derivatives(points, xy)
    dA = (det * weights)[..., None]
    xx, xy_, yy = x.swapaxes(1, 2) @ (dA * x), x.swapaxes(1, 2) @ (dA * y), y.swapaxes(1, 2) @ (dA * y)
    d = D[:, :, :, None, None]
    both = xy_ + xy_.swapaxes(1, 2)
    K = np.empty((len(xy), 18, 18))
    K[:, :9, :9] = d[:, 0, 0] * xx + d[:, 0, 2] * both + d[:, 2, 2] * yy
    K[:, 9:, 9:] = d[:, 1, 1] * yy + d[:, 1, 2] * both + d[:, 2, 2] * xx
    K[:, :9, 9:] = d[:, 0, 1] * xy_ + d[:, 0, 2] * xx + d[:, 1, 2] * yy + d[:, 2, 2] * xy_.swapaxes(1, 2)
    K[:, 9:, :9] = K[:, :9, 9:].swapaxes(1, 2)
    return K


def _shear_stiffness(element: PlateElement, xy: Array, S: Array, T: Array, halves: Integers | None) -> Array:
    """Return int S B_s^T B_s dA (m, 27, 27), from covariant strains by the metric of the element."""
    points, weights = gauss(element.shear_points)
    inverse, det = inverse_jacobian(q9(points)[1], xy)
    metric = np.einsum("epxi,epxj,ep->ijep", inverse, inverse, det * weights * S[:, None])[..., None]
    B = element.covariant_shear(points, xy, T, halves)
    of_xi, of_eta = B[:, 0], B[:, 1]
    stresses = [metric[i, 0] * of_xi + metric[i, 1] * of_eta for i in (0, 1)]
    K: Array = B.reshape(len(xy), -1, 27).swapaxes(1, 2) @ np.concatenate(stresses, axis=1)
    return K


def free_couples(xy: Array, D: Array, curvature: Array) -> Array:
    """Return the couples (2, m, 9) [N m] on beta_x and beta_y that bend free elements to a curvature.

    int B_b^T D (curvature, 0) dA with the curvature beta_x,x and beta_y,y (m, 2) [1/m] of free bending, as by
    temperature.
    """
    points, weights = gauss(3)
    dA = determinants(q9(points)[1], xy) * weights
    moment = np.einsum("eij,ej->ei", D[:, :, :2], curvature)
    f = np.einsum("ep,epcu,ec->eu", dA, bending_strain(points, xy), moment)
    couples: Array = f[:, 9:].reshape(-1, 2, 9).swapaxes(0, 1)
    return couples


def section_forces(
    element: PlateElement, points: Array, xy: Array, D: Array, S: Array, u: Array, halves: Integers | None = None
) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at points (p, 2) of elements, (m, p, 5), for unknowns u (m, 27).

    M = -D kappa: sagging positive; Q = S (grad w - beta), so that Q is the divergence of M.
    """
    _, dN = q9(points)
    inverse, _ = inverse_jacobian(dN, xy)
    beta_x, beta_y = (gradients(dN, inverse, u[:, 9 * k : 9 * (k + 1)]) for k in (1, 2))
    kappa = np.stack([beta_x[..., 0], beta_y[..., 1], beta_x[..., 1] + beta_y[..., 0]], axis=-1)
    strain = along_axes(inverse, element.covariant_strain(points, xy, u, halves))
    return np.concatenate([-kappa @ D, S[:, None, None] * strain], axis=2)
