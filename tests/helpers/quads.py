"""Plate meshes and solutions for tests of single elements, with none of the package's own mesh or assembly."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from groundslab.fem import plate

#: Places of an element's nodes on its 3 x 3 table, row after row from below: corners, midsides, centre.
PLACES = [(0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0), (1, 1)]


def mesh(
    nx: int, ny: int, length_x: float, length_y: float, amount: float = 0.0, seed: int = 1, split: int = 1
) -> tuple[np.ndarray, np.ndarray]:
    """Return nodes (n, 2) and elements (m, 9) of the rectangle 0 .. length_x, 0 .. length_y.

    Corners inside move at random by up to `amount` of an element's side; those on the boundary slide along it. Sides
    stay straight, midside nodes halve them, centres are the mean of the corners. Then each element is split into
    `split` x `split`, which come closer and closer to parallelograms.
    """
    corner = np.stack(np.meshgrid(np.linspace(0, length_x, nx + 1), np.linspace(0, length_y, ny + 1)), axis=-1)
    move = np.random.default_rng(seed).uniform(-amount, amount, corner.shape) * [length_x / nx, length_y / ny]
    move[:, [0, -1], 0] = 0.0
    move[[0, -1], :, 1] = 0.0
    corner = _split(_split(corner + move, split).swapaxes(0, 1), split).swapaxes(0, 1)
    nx, ny = split * nx, split * ny
    table = np.empty((2 * ny + 1, 2 * nx + 1, 2))
    table[::2, ::2] = corner
    table[1::2, ::2] = (corner[1:] + corner[:-1]) / 2
    table[::2, 1::2] = (corner[:, 1:] + corner[:, :-1]) / 2
    table[1::2, 1::2] = (corner[1:, 1:] + corner[1:, :-1] + corner[:-1, 1:] + corner[:-1, :-1]) / 4
    number = np.arange(table.shape[0] * table.shape[1]).reshape(table.shape[:2])
    elements = [[number[2 * j + row, 2 * i + column] for row, column in PLACES] for j in range(ny) for i in range(nx)]
    return table.reshape(-1, 2), np.array(elements)


def _split(rows: np.ndarray, n: int) -> np.ndarray:
    """Return the rows with n - 1 equally spaced ones between each two."""
    s = np.arange((len(rows) - 1) * n + 1)
    i = np.minimum(s // n, len(rows) - 2)
    part = ((s - i * n) / n)[:, None, None]
    return rows[i] * (1 - part) + rows[i + 1] * part


def quadrilateral(seed: int = 3, amount: float = 0.3, scale: float = 1.0) -> np.ndarray:
    """Return the nodes (1, 9, 2) of one distorted quadrilateral about the size of `scale`, no two sides parallel."""
    corner = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    corner = scale / 2 * (corner + np.random.default_rng(seed).uniform(-amount, amount, (4, 2)))
    return np.vstack([corner, (corner + np.roll(corner, -1, axis=0)) / 2, corner.mean(axis=0)])[None]


def stiffness(name: str, xy: np.ndarray, t: float, E: float = 1.0, nu: float = 0.3) -> np.ndarray:
    """Return the element matrices (m, 27, 27) of one kind of element with the usual shear factor."""
    D = np.broadcast_to(plate.bending_rigidity(E, nu, t), (len(xy), 3, 3))
    S = np.full(len(xy), plate.shear_rigidity(E, nu, t, 5 / 6))
    return plate.stiffness(plate.ELEMENTS[name], xy, D, S, plate.ELEMENTS[name].w_functions(xy))


def assemble(K: np.ndarray, elements: np.ndarray, n: int) -> Any:
    """Return the sparse matrix (3 n, 3 n), field after field."""
    dof = np.concatenate([elements, elements + n, elements + 2 * n], axis=1)
    rows, columns = np.repeat(dof, 27, axis=1).ravel(), np.tile(dof, (1, 27)).ravel()
    return sp.coo_array((K.ravel(), (rows, columns)), shape=(3 * n, 3 * n)).tocsc()


def solve(A: Any, f: np.ndarray, held: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return u with A u = f where u is not held, and the given values where it is; scaled, with one refinement."""
    free = np.flatnonzero(~held)
    u = np.where(held, values, 0.0)
    f = (f - A @ u)[free]
    A = A[free][:, free]
    scale = 1 / np.sqrt(A.diagonal())
    lu = splu((sp.diags_array(scale) @ A @ sp.diags_array(scale)).tocsc())
    x = scale * lu.solve(scale * f)
    x += scale * lu.solve(scale * (f - A @ x))
    u[free] = x
    return u


def centres(name: str, elements: np.ndarray, n: int) -> np.ndarray:
    """Return which of the unknowns (3 n,) do not exist: the centres' w of elements that have none of their own."""
    none = np.zeros(3 * n, dtype=bool)
    if not plate.ELEMENTS[name].center_w:
        none[elements[:, 8]] = True
    return none


def load(name: str, xy: np.ndarray, elements: np.ndarray, n: int, q: Any) -> np.ndarray:
    """Return the nodal forces (3 n,) of a pressure q(x, y), by a 5 x 5 rule."""
    N, det, weight, x, y = integration(xy)
    f = np.einsum("ep,pa->ea", det * weight * q(x, y), N)
    f = np.einsum("ea,eab->eb", f, plate.ELEMENTS[name].w_functions(xy))
    result = np.zeros(3 * n)
    np.add.at(result, elements, f)
    return result


def integration(xy: np.ndarray, order: int = 5) -> tuple[np.ndarray, ...]:
    """Return N (p, 9), det J (m, p), weights (p,) and the points x, y (m, p) of a Gauss rule on elements."""
    r, weight = np.polynomial.legendre.leggauss(order)
    R, S = (a.ravel() for a in np.meshgrid(r, r))
    L = [np.poly1d([0.5, -0.5, 0.0]), np.poly1d([-1.0, 0.0, 1.0]), np.poly1d([0.5, 0.5, 0.0])]
    N = np.column_stack([L[c](R) * L[w](S) for w, c in PLACES])
    dr = np.column_stack([L[c].deriv()(R) * L[w](S) for w, c in PLACES])
    ds = np.column_stack([L[c](R) * L[w].deriv()(S) for w, c in PLACES])
    xr, xs, yr, ys = dr @ xy[:, :, 0].T, ds @ xy[:, :, 0].T, dr @ xy[:, :, 1].T, ds @ xy[:, :, 1].T
    det = (xr * ys - xs * yr).T
    return N, det, np.outer(weight, weight).ravel(), (N @ xy[:, :, 0].T).T, (N @ xy[:, :, 1].T).T
