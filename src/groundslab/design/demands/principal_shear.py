"""The largest shear force of any direction at a place, and the bars that count in that direction."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array


def principal_shear(q_x: Array, q_y: Array) -> tuple[Array, Array]:
    """Return the largest shear force of any direction (n,) [N/m], and the share cos^2 of its direction along x (n,).

    q_n = q_x cos + q_y sin is largest for the direction of the vector (q_x, q_y) itself.
    """
    size = np.hypot(q_x, q_y)
    return size, np.divide(q_x, size, out=np.full_like(size, np.sqrt(0.5)), where=size > 0) ** 2


def ratio_along(share: Array, rho_x: Array, rho_y: Array) -> Array:
    """Return the ratio of bars (n,) that counts in a direction with cos^2 = share between bars along x and y.

    rho_l = rho_x cos^4 + rho_y sin^4 (EN 1992-2 Annex LL (LL.123)), the stiffness of a net of bars in a direction.
    """
    return np.asarray(rho_x * share**2 + rho_y * (1 - share) ** 2)
