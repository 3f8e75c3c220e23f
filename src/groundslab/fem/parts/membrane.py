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
        some = slice(start, start + CHUNK)
        K[some] = symmetric_gradient_stiffness(xy[some], C[some])
    return K


def forces(points: Array, xy: Array, C: Array, u: Array) -> Array:
    """Return n_x, n_y and n_xy [N/m] at points (p, 2) of elements, (m, p, 3), for u and v as (m, 18) [m]."""
    _, dN = q9(points)
    inverse, _ = inverse_jacobian(dN, xy)
    u_x, v_x = (gradients(dN, inverse, u[:, 9 * k : 9 * (k + 1)]) for k in (0, 1))
    strain = np.stack([u_x[..., 0], v_x[..., 1], u_x[..., 1] + v_x[..., 0]], axis=-1)
    found: Array = strain @ C
    return found


def held(nodes: Array, own: Integers) -> Flags:
    """Return which u and v (n, 2) hold a plate with its own nodes in its plane: both at one end, v at the other."""
    found = np.zeros((len(nodes), 2), dtype=bool)
    x = nodes[own, 0]
    found[own[np.argmin(x)]] = True
    found[own[np.argmax(x)], 1] = True
    return found
