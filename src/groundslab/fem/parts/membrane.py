"""The plate in its plane: displacements u along x and v along y of its middle plane, and the membrane forces.

Beams whose axes lie below or above the middle plane stretch it; nothing else does, so that only their plates have u
and v. Nothing holds a plate in its plane: three unknowns of each are held at zero, whose forces vanish by themselves.
Positive membrane forces are tension:

    n = C (u,x ; v,y ; u,y + v,x),    C = E t / (1 - nu^2) [[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]].
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.plate import symmetric_gradient_stiffness
from groundslab.fem.shape_functions import CHUNK, gradients, inverse_jacobian, q9


def membrane_rigidity(E: float, nu: float, t: float) -> Array:
    """Return the matrix C (3, 3) [N/m] between strains and membrane forces."""
    return E * t / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])


def stiffness(xy: Array, C: Array) -> Array:
    """Return the stiffness matrices (m, 18, 18) [N/m] between u and v of elements with nodes (m, 9, 2), C (m, 3, 3)."""
    K = np.empty((len(xy), 18, 18))
    for start in range(0, len(xy), CHUNK):
        chunk = slice(start, start + CHUNK)
        K[chunk] = symmetric_gradient_stiffness(xy[chunk], C[chunk])
    return K


def forces(points: Array, xy: Array, C: Array, u: Array) -> Array:
    """Return n_x, n_y and n_xy [N/m] at points (p, 2) of elements, (m, p, 3), for u and v as (m, 18) [m]."""
    _, dN = q9(points)
    inverse, _ = inverse_jacobian(dN, xy)
    u_x, v_x = (gradients(dN, inverse, u[:, 9 * k : 9 * (k + 1)]) for k in (0, 1))
    strain = np.stack([u_x[..., 0], v_x[..., 1], u_x[..., 1] + v_x[..., 0]], axis=-1)
    resultants: Array = strain @ C
    return resultants


def held(nodes: Array, plates: list[Integers], joined: Integers) -> Flags:
    """Return which u and v (n, 2) hold plates in their plane, each with its own nodes, as few as do.

    Of a plate by itself both at one end, and v at the other. joined (k, 2) are pairs of nodes of two plates that move
    alike.
    """
    from scipy.linalg import null_space, qr

    place, rows = list[tuple[int, int]](), list[Array]()
    plate = np.full(len(nodes), -1)
    for number, members in enumerate(plates):
        plate[members] = number
        x = nodes[members, 0]
        first, last = int(members[np.argmin(x)]), int(members[np.argmax(x)])
        place += [(first, 0), (first, 1), (last, 1)]
    middle, size = nodes.mean(axis=0), np.ptp(nodes, axis=0).max()

    def motion(node: int, field: int) -> Array:
        """Return what u or v of a node is for each plate's motions: along x, along y, turned, (3 plates,)."""
        row = np.zeros((len(plates), 3))
        x, y = (nodes[node] - middle) / size
        row[plate[node]] = (1.0, 0.0, -y) if field == 0 else (0.0, 1.0, x)
        return row.ravel()

    rows = [motion(*pair) for pair in place]
    steps = [motion(a, field) - motion(b, field) for a, b in joined.tolist() for field in (0, 1)]
    free = null_space(np.array(steps)) if steps else np.eye(3 * len(plates))
    order = qr((np.array(rows) @ free).T, pivoting=True, mode="r")[1]
    mask = np.zeros((len(nodes), 2), dtype=bool)
    for index in order[: free.shape[1]]:
        mask[place[index]] = True
    return mask
