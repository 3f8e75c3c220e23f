"""Measures how plate elements lock: a clamped square plate, thin and thinner, on a regular and a distorted mesh.

Prints the error of the centre's settlement against the thin plate's series value (Taylor and Govindjee 2004), for the
package's elements and for the six-point MITC9, which the package does not have (docs/decisions/0002).
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array, diags_array
from scipy.sparse.linalg import splu

from groundslab.arrays import Array, Integers
from groundslab.fem import plate
from groundslab.fem.mesh import grid
from groundslab.fem.shape_functions import COLUMN, ROW, gauss, jacobian, lagrange, q9

#: Settlement of the centre over q L^4 / D; Poisson's ratio has no part in it.
THIN = 0.00126532
NU, COUNT, AMOUNT = 0.3, 8, 0.35
_G = 1 / np.sqrt(3.0)
_T = np.sqrt(0.6)
_SIX = np.array([(r, s) for s in (-_T, 0.0, _T) for r in (-_G, _G)])


def six_point_shear(points: Array, xy: Array, T: Array) -> Array:
    """Return the strains (m, 2, p, 27) of the MITC9 whose shear strain is tied at six points inside the element."""
    along_xi, along_eta = (
        _six_functions(points[:, ::turn]) @ plate.sums_of_covariant_shear(axis, _SIX[:, ::turn], np.eye(6), xy, T)
        for axis, turn in ((0, 1), (1, -1))
    )
    return np.stack([along_xi, along_eta], axis=1)


def _six_functions(points: Array) -> Array:
    """Return the functions (p, 6) that are linear along and quadratic across, one at its own point of the six."""
    across = lagrange(points[:, 1] / _T)[0]
    linear = np.stack([1 - points[:, 0] / _G, 1 + points[:, 0] / _G], axis=1) / 2
    functions: Array = (across[:, :, None] * linear[:, None, :]).reshape(len(points), 6)
    return functions


def quarter(amount: float) -> tuple[Array, Integers]:
    """Return nodes (n, 2) and elements (m, 9) of the quarter 0 .. 1/2, corners inside moved by a share of a side."""
    mesh = grid(np.linspace(0, 0.5, COUNT + 1), np.linspace(0, 0.5, COUNT + 1))
    table = mesh.nodes.reshape(2 * COUNT + 1, 2 * COUNT + 1, 2)
    move = np.random.default_rng(1).uniform(-amount, amount, (COUNT + 1, COUNT + 1, 2)) * 0.5 / COUNT
    move[[0, -1]] = move[:, [0, -1]] = 0.0
    corner = table[::2, ::2] + move
    rows, columns = ROW // 2, COLUMN // 2
    first = np.array([(j, i) for j in range(COUNT) for i in range(COUNT)])
    four = np.stack([corner[first[:, 0] + rows[k], first[:, 1] + columns[k]] for k in range(4)], axis=1)
    xy = np.concatenate([four, (four + np.roll(four, -1, axis=1)) / 2, four.mean(axis=1, keepdims=True)], axis=1)
    nodes = np.empty_like(mesh.nodes)
    nodes[mesh.elements] = xy
    return nodes, mesh.elements


def error(element: plate.PlateElement, t: float, amount: float) -> float:
    """Return the relative error of the centre's settlement of the clamped plate of side 1 and thickness t."""
    nodes, elements = quarter(amount)
    n, xy = len(nodes), nodes[elements]
    D = plate.bending_rigidity(1.0, NU, t)
    S = plate.shear_rigidity(1.0, NU, t, 5 / 6)
    K = plate.stiffness(element, xy, np.broadcast_to(D, (len(xy), 3, 3)), np.full(len(xy), S), element.w_functions(xy))
    dof = np.concatenate([elements, elements + n, elements + 2 * n], axis=1)
    places = np.repeat(dof, 27, axis=1).ravel(), np.tile(dof, (1, 27)).ravel()
    A = coo_array((K.ravel(), places), shape=(3 * n, 3 * n)).tocsc()
    points, weights = gauss(3)
    N, dN = q9(points)
    forces = np.einsum("ea,eab->eb", (jacobian(dN, xy)[2] * weights) @ N, element.w_functions(xy))
    f = np.zeros(3 * n)
    np.add.at(f, elements, forces)
    x, y = nodes.T
    on_edge = (x == 0.5) | (y == 0.5)
    held = np.concatenate([on_edge, on_edge | (x == 0.0), on_edge | (y == 0.0)])
    if not element.center_w:
        held[elements[:, 8]] = True
    free = np.flatnonzero(~held)
    A = A[free][:, free]
    scale = diags_array(1 / np.sqrt(A.diagonal()))
    u = np.zeros(3 * n)
    u[free] = scale @ splu((scale @ A @ scale).tocsc()).solve(scale @ f[free])
    w = u[np.flatnonzero((x == 0.0) & (y == 0.0))[0]]
    return float(w * D[0, 0] / THIN - 1)


def main() -> None:
    """Print the table."""
    six = plate.PlateElement("mitc9, six points", six_point_shear, 3, center_w=True)
    print(f"clamped square plate, {COUNT} x {COUNT} elements on a quarter, error of the centre's settlement")
    print(f"{'element':<20}{'t/L':>8}{'regular':>12}{'distorted':>12}")
    for element in (*plate.ELEMENTS.values(), six):
        for t in (1e-2, 1e-4, 1e-5, 1e-6):
            print(f"{element.name:<20}{t:>8.0e}{error(element, t, 0.0):>12.2%}{error(element, t, AMOUNT):>12.2%}")


if __name__ == "__main__":
    main()
