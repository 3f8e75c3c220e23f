"""Forces between bounds that act against gaps: minimize 1/2 x.A x + c.x with lower <= x <= upper and G x = e.

Where a force lies between its bounds its gap y = A x + c + G^T alpha is zero, at the lower bound it is open, y >= 0, at
the upper one it is driven in, y <= 0. Conjugate gradients on the forces between their bounds, projected on G q = 0 and
preconditioned (Gould, Hribar and Nocedal 2001), alternate with an active set that follows the signs of forces and gaps
(Polonsky and Keer 1999; Hintermueller, Ito and Kunisch 2002). The energy falls with every step: if forces that are cut
off at their bounds make it rise, the step is shorter. Products with A are what costs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.errors import NotConverged

#: Conjugate gradients on one set of free forces end when the residual's energy has fallen to the square of this share.
REDUCTION = 0.1
#: They need not leave less than this share of the gaps that are allowed in the end.
ENOUGH = 0.1
#: A step of which the energy allows less than this share is tried again, so much shorter, but at least by
SHORT, SHORTEST = 0.5, 0.1
#: and no more often than this.
MAX_SHORTER = 4
#: Given combinations of forces are exact to this share of their parts.
BALANCED = 1e-13
MAX_BALANCING = 100


@dataclass(frozen=True, slots=True)
class BoundedForces:
    """The problem of n forces, of which r combinations are given."""

    gaps: Callable[[Array], tuple[Array, float]]  # A x + c for x with G x = e, and the size of displacements
    multiply: Callable[[Array], Array]  # A q for q with G q = 0
    precondition: Callable[[Array], Array]  # about the inverse of A, symmetric positive definite
    G: Array  # (r, n)
    e: Array  # (r,)
    lower: Array  # (n,)
    upper: Array  # (n,)
    weight: Array  # (n,): how forces share a resultant as long as nothing is known

    @property
    def can_change(self) -> Flags:
        """Return which forces are not given by equal bounds, (n,)."""
        return self.lower < self.upper

    def clip(self, x: Array) -> Array:
        """Return forces (n,) cut off at their bounds."""
        return np.clip(x, self.lower, self.upper)


@dataclass(frozen=True, slots=True)
class BoundedSolution:
    """Forces x (n,) with their gaps y (n,), the multipliers alpha (r,), and how many products with A that took."""

    x: Array
    y: Array
    alpha: Array
    products: int


def solve(
    p: BoundedForces, start: Array, tolerance: float, limit: int, report: Callable[[int, int, int], None]
) -> BoundedSolution:
    """Return the solution from a start (n,), to gaps that are wrong by a share of the displacements at most.

    report takes iteration, forces that are not zero and changes. Raises NotConverged after `limit` products with A.
    """
    x, history = balance(p, start), list[dict[str, int]]()
    g, size = p.gaps(x)
    products = 1
    while True:
        free = (x > p.lower) & (x < p.upper)
        alpha = multipliers(p, g, free)
        y, small = g + p.G.T @ alpha, tolerance * size
        wrong = ((x <= p.lower) & (y < -small) | (x >= p.upper) & (y > small)) & p.can_change
        changed, bearing = int(wrong.sum()), int((x != 0).sum())
        history.append({"iteration": len(history) + 1, "closed": bearing, "changed": changed, "products": products})
        report(len(history), bearing, changed)
        if not changed and np.abs(y[free]).max(initial=0.0) <= small:
            return BoundedSolution(x, y, alpha, products)
        if products >= limit:
            raise NotConverged("the contact pressure", history, {"x": x})
        d, used = descend(p, -y, free | wrong, ENOUGH * small, limit - products)
        x, g, size, tried = advance(p, x, g, d)
        products += used + tried


def multipliers(p: BoundedForces, g: Array, free: Flags) -> Array:
    """Return alpha (r,) that leaves the least of the gaps g (n,) where forces are free."""
    if not len(p.G):
        return np.zeros(0)
    alpha: Array = -np.linalg.lstsq(p.G[:, free].T, g[free], rcond=None)[0]
    return alpha


def descend(p: BoundedForces, r: Array, free: Flags, small: float, limit: int) -> tuple[Array, int]:
    """Return the change (n,) of free forces that takes away their residual r (n,), and the products that it took.

    It ends when the residual has fallen by REDUCTION or is small.
    """
    Q = np.linalg.qr(np.where(free, p.G, 0.0).T)[0]

    def project(v: Array) -> Array:
        v = np.where(free, v, 0.0)
        # what is fixed stays so, whatever the rounding of Q
        return np.where(free, v - Q @ (Q.T @ v), 0.0)

    r = project(r)
    d, q, rz, first = np.zeros_like(r), np.zeros_like(r), np.inf, 0.0
    for step in range(limit):
        z = project(p.precondition(r))
        last, rz = rz, float(r @ z)
        first = first or rz
        if step and (rz <= REDUCTION**2 * first or np.abs(r).max() <= small):
            return d, step
        q = z + rz / last * q
        Aq = p.multiply(q)
        curvature = float(q @ Aq)
        if not curvature > 0:
            return d, step + 1
        d += rz / curvature * q
        r = project(r - rz / curvature * Aq)
    return d, limit


def advance(p: BoundedForces, x: Array, g: Array, d: Array) -> tuple[Array, Array, float, int]:
    """Return forces (n,) after a step d (n,) from x with gaps g, their gaps, the size of displacements, and products.

    Between two forces within bounds all are; the energy between them is a parabola, known by the gaps at both ends.
    """
    for tried in range(1, MAX_SHORTER + 1):
        after = balance(p, p.clip(x + d))
        g_after, size = p.gaps(after)
        s, change = after - x, g_after - g
        curvature = float(s @ change)
        share = -float(g @ s) / curvature if curvature > 0 else 1.0
        if share >= SHORT:
            break
        d = max(share, SHORTEST) * d
    if 0 < share < 1:
        return x + share * s, g + share * change, size, tried
    return after, g_after, size, tried


def balance(p: BoundedForces, x: Array) -> Array:
    """Return forces between their bounds near x (n,) that have the given combinations."""
    x = p.clip(x)
    for _ in range(MAX_BALANCING if len(p.G) else 0):
        missing = p.e - p.G @ x
        if np.abs(missing).max() <= BALANCED * np.abs(p.G * x).sum(axis=1).max():
            break
        W = np.where((x > p.lower) & (x < p.upper), p.weight, 0.0)
        if np.linalg.matrix_rank(p.G * np.sqrt(W)) < len(p.G):
            W = p.weight
        x = p.clip(x + W * (p.G.T @ np.linalg.solve((p.G * W) @ p.G.T, missing)))
    return x
