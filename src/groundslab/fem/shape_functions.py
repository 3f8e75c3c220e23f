"""Shape functions and Gauss rules of the nine-node quadrilateral.

Node order everywhere: the corners (-1,-1), (1,-1), (1,1), (-1,1), the midsides (0,-1), (1,0), (0,1), (-1,0),
the center (0,0).
"""

from __future__ import annotations

from functools import cache

import numpy as np

from groundslab.arrays import Array, Flags, Integers

#: Place of each node on the 3 x 3 grid of one-dimensional nodes (-1, 0, 1).
COLUMN = np.array([0, 2, 2, 0, 1, 2, 1, 0, 1])
ROW = np.array([0, 0, 2, 2, 0, 1, 2, 1, 1])
#: The center's value in the serendipity family: minus a quarter of the corners, half of the midsides.
SERENDIPITY_CENTER = np.array([-0.25, -0.25, -0.25, -0.25, 0.5, 0.5, 0.5, 0.5])
#: What is made of so many elements at a time stays near the processor.
CHUNK = 256


def lagrange(xi: Array) -> tuple[Array, Array]:
    """Return the three quadratic Lagrange polynomials on (-1, 0, 1) and their derivatives at xi: (..., 3) each."""
    N, dN = np.empty((*xi.shape, 3)), np.empty((*xi.shape, 3))
    N[..., 0], N[..., 1], N[..., 2] = xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2
    dN[..., 0], dN[..., 1], dN[..., 2] = xi - 0.5, -2 * xi, xi + 0.5
    return N, dN


def q9(points: Array) -> tuple[Array, Array]:
    """Return N (p, 9) and its derivatives dN (p, 2, 9) with respect to (xi, eta) at points (p, 2)."""
    (Nx, dNx), (Ny, dNy) = lagrange(points[:, 0]), lagrange(points[:, 1])
    Nx, Ny = Nx[:, COLUMN], Ny[:, ROW]
    dN = np.empty((len(points), 2, 9))
    np.multiply(dNx[:, COLUMN], Ny, out=dN[:, 0])
    np.multiply(Nx, dNy[:, ROW], out=dN[:, 1])
    return Nx * Ny, dN


def q9_values(points: Array) -> Array:
    """Return N (p, 9) at points (p, 2), without derivatives."""
    Nx, Ny = (np.stack([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2], axis=-1) for x in points.T)
    N: Array = Nx[:, COLUMN] * Ny[:, ROW]
    return N


@cache
def gauss_line(n: int) -> tuple[Array, Array]:
    """Return the n-point Gauss rule on (-1, 1): points (n,), weights (n,)."""
    x, w = np.polynomial.legendre.leggauss(n)
    return x, w


@cache
def gauss(n: int) -> tuple[Array, Array]:
    """Return the n x n Gauss rule on the reference square: points (n*n, 2), weights (n*n,)."""
    x, w = gauss_line(n)
    X, Y = np.meshgrid(x, x, indexing="ij")
    return np.column_stack([X.ravel(), Y.ravel()]), np.outer(w, w).ravel()


def determinants(dN: Array, xy: Array) -> Array:
    """Return det J (m, p) [m2] of the Jacobian with rows x,xi and x,eta (paper (2.11)).

    dN (p, 2, 9) are derivatives at p points, xy (m, 9, 2) the nodes of m elements [m].
    """
    (x_xi, x_eta), (y_xi, y_eta) = _slopes(dN, xy)
    return x_xi * y_eta - x_eta * y_xi


def inverse_jacobian(dN: Array, xy: Array) -> tuple[Array, Array]:
    """Return the inverse of J (m, p, 2, 2) and det J (m, p), see `determinants`."""
    (x_xi, x_eta), (y_xi, y_eta) = _slopes(dN, xy)
    det = x_xi * y_eta - x_eta * y_xi
    inverse = np.empty((*det.shape, 2, 2))
    inverse[..., 0, 0], inverse[..., 0, 1] = y_eta / det, -y_xi / det
    inverse[..., 1, 0], inverse[..., 1, 1] = -x_eta / det, x_xi / det
    return inverse, det


def _slopes(dN: Array, xy: Array) -> list[list[Array]]:
    """Return x,xi and x,eta, y,xi and y,eta (m, p) each."""
    return [[xy[..., axis] @ dN[:, along].T for along in (0, 1)] for axis in (0, 1)]


def derivatives(points: Array, xy: Array) -> tuple[Array, Array, Array]:
    """Return N,x and N,y (m, p, 9) [1/m] and det J (m, p) [m2] at points (p, 2) of elements xy (m, 9, 2) [m]."""
    _, dN = q9(points)
    inverse, det = inverse_jacobian(dN, xy)
    along_xi, along_eta = dN[:, 0], dN[:, 1]
    x, y = (inverse[:, :, k, :1] * along_xi + inverse[:, :, k, 1:] * along_eta for k in (0, 1))
    return x, y, det


def along_axes(inverse: Array, covariant: Array) -> Array:
    """Return derivatives by x and y (m, p, 2) from those by xi and eta (m, p, 2), by the inverse Jacobian."""
    along: Array = inverse[..., 0] * covariant[..., :1] + inverse[..., 1] * covariant[..., 1:]
    return along


def gradients(dN: Array, inverse: Array, values: Array) -> Array:
    """Return the derivatives by x and y (m, p, 2) of nodal values (m, 9); inverse as in `inverse_jacobian`."""
    return along_axes(inverse, (values @ dN.reshape(-1, 9).T).reshape(len(values), len(dN), 2))


def areas(xy: Array) -> Array:
    """Return the areas (m,) [m2] of elements with nodes xy (m, 9, 2)."""
    points, weights = gauss(3)
    return determinants(q9(points)[1], xy) @ weights


def parallelograms(xy: Array) -> Flags:
    """Return which elements (m, 9, 2) are parallelograms with their nodes halfway, (m,)."""
    corners = xy[:, :4]
    off = np.abs(corners[:, 0] - corners[:, 1] + corners[:, 2] - corners[:, 3]).max(axis=1)
    middle = (corners + np.roll(corners, -1, axis=1)) / 2
    off = np.maximum(off, np.abs(xy[:, 4:8] - middle).max(axis=(1, 2)))
    off = np.maximum(off, np.abs(xy[:, 8] - corners.mean(axis=1)).max(axis=1))
    flat: Flags = off <= 1e-13 * np.abs(xy).max(axis=(1, 2))
    return flat


def unique_integers(keys: Integers) -> tuple[Integers, Integers]:
    """Return the different numbers, >= 0, among keys, ascending, and which of them each key is, in the keys' shape.

    As np.unique does by sorting; by marking where they are not too far apart.
    """
    span = int(keys.max(initial=-1)) + 1
    if span > 8 * keys.size:
        numbers, which = np.unique(keys, return_inverse=True)
        return numbers, which.reshape(keys.shape)
    marks = np.zeros(span, dtype=bool)
    marks[keys] = True
    return np.flatnonzero(marks), (np.cumsum(marks) - 1)[keys]
