"""How good elements are: their scaled Jacobians."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.shape_functions import gauss, q9
from groundslab.geometry.plan import Place


@dataclass(frozen=True, slots=True)
class Quality:
    """Scaled Jacobians of a mesh, 1 for rectangles: the least of all elements, where it is, and the median."""

    worst: float
    median: float
    worst_place: Place


def scaled_jacobians(xy: Array) -> Array:
    """Return det J over its columns' lengths for elements xy (m, 9, 2), the least of 3 x 3 Gauss points and corners."""
    corners = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    J = np.einsum("pia,eax->epix", q9(np.concatenate([gauss(3)[0], corners]))[1], xy)
    det = J[..., 0, 0] * J[..., 1, 1] - J[..., 0, 1] * J[..., 1, 0]
    least: Array = (det / np.maximum(np.prod(np.linalg.norm(J, axis=-1), axis=-1), 1e-300)).min(axis=1)
    return least


def quality(xy: Array) -> Quality:
    """Return the quality of elements with nodes xy (m, 9, 2)."""
    scaled = scaled_jacobians(xy)
    worst = int(np.argmin(scaled))
    x, y = xy[worst, 8]
    return Quality(float(scaled[worst]), float(np.median(scaled)), (float(x), float(y)))
