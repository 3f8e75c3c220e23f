"""An interior point method for the states of one-sided bearings; it takes about thirty steps for plates of any kind.

For 1/2 u.A u - f.u with bearings (module `bearings`): the force p of a bearing, its reserve q = F - p to the limit
force, the opening g and the plastic slip y fulfill

    A u - f = s p,    s (l - u) = p / k + y - g,    p g = mu,    q y = mu,    all of p, q, g, y above 0

and mu is driven to zero by Newton's method with Mehrotra's predictor and corrector (Mehrotra 1992). Eliminating all but
u leaves A with a spring at every bearing, so that no plate floats in between.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import SingularMatrix
from groundslab.fem.assembly import scatter
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.solvers.factor_reuse import CachedFactorization, ConstrainedSystem

#: mu starts so many times larger than force times penetration of the glued plate: a smaller one costs many short steps.
INITIAL_MU = 1e3
#: The iteration ends when mu has fallen to this share of its start.
FINAL_MU = 1e-14
#: Share of the distance to the nearest bound that a step takes.
STEP_SHARE = 0.995
MAX_STEPS = 100
#: Steps of conjugate gradients that remove the rounding of each Newton step.
REFINEMENTS = 2


@dataclass(frozen=True, slots=True)
class _Point:
    """A point of the interior: unknowns u (size,), and p, q, g, y of each one-sided bearing (c,)."""

    u: Array
    p: Array
    q: Array
    g: Array
    y: Array

    @property
    def mu(self) -> float:
        """Return the mean of the products that vanish at the solution [N m]."""
        return float(self.p @ self.g + self.q @ self.y) / max(len(self.p), 1)

    def longest_step(self, step: _Point) -> float:
        """Return the longest share of a step, at most 1, until one of p, q, g, y vanishes."""
        t = 1.0
        for name in ("p", "q", "g", "y"):
            value, change = getattr(self, name), getattr(step, name)
            falls = change < 0
            t = min(t, float((-value[falls] / change[falls]).min(initial=1.0)))
        return t

    def move(self, step: _Point, t: float) -> _Point:
        """Return the point after a share t of a step."""
        return _Point(*(getattr(self, name) + t * getattr(step, name) for name in ("u", "p", "q", "g", "y")))


@dataclass(frozen=True, slots=True)
class _BarrierProblem:
    """The problem with one-sided bearings only: bilateral ones are fixed unknowns, or springs in `diagonal_shift`."""

    A: Symmetric
    fixed: Flags  # (size,)
    diagonal_shift: Array  # (size,)
    load: Array  # (size,)
    unknown: Integers  # (c,): of the one-sided bearings that can bear
    sign: Array
    offset: Array
    flexibility: Array
    limited: Flags

    def constrain(self, spring: Array) -> ConstrainedSystem:
        """Return the linear system with a spring (c,) at each bearing."""
        shift = self.diagonal_shift + scatter(self.unknown, spring, self.A.size)
        return ConstrainedSystem(self.A, self.fixed, shift, np.zeros(self.A.size))

    def residuals(self, x: _Point) -> tuple[Array, Array]:
        """Return the residuals of equilibrium (size,) and of the bearings' penetrations (c,)."""
        bearing_load = scatter(self.unknown, self.sign * x.p, self.A.size)
        forces = self.load + bearing_load - self.A @ x.u - self.diagonal_shift * x.u
        penetrations = x.p * self.flexibility + x.y - x.g - self.sign * (self.offset - x.u[self.unknown])
        return np.where(self.fixed, 0.0, forces), penetrations


def solve(
    A: Symmetric, f: Array, factorization: CachedFactorization, b: Bearings, report: Callable[[Integers, int], None]
) -> Contact:
    """Return the solution; report takes the states (c,) of every step, and how many have changed.

    Raises SingularMatrix if A is not positive definite even with a spring at every bearing.
    """
    one_sided = np.flatnonzero(~b.bilateral & (b.limit_force > 0))
    barrier, u = _barrier_problem(A, f, b, one_sided)
    x = _starting_point(barrier, u, b.limit_force[one_sided], factorization)
    end, states = FINAL_MU * x.mu, _read_states(b, one_sided, barrier, x)
    for _ in range(MAX_STEPS):
        if x.mu <= end:
            break
        try:
            x = _newton_step(barrier, x, factorization)
        except SingularMatrix:
            break  # springs of vanishing penetrations overflow: nothing is left to gain
        before, states = states, _read_states(b, one_sided, barrier, x)
        report(states, int((states != before).sum()))
    force = np.zeros(len(b))
    force[one_sided] = x.p
    return Contact(x.u, states, force)


def _barrier_problem(A: Symmetric, f: Array, b: Bearings, one_sided: Integers) -> tuple[_BarrierProblem, Array]:
    """Return the problem for the interior point method, and unknowns (size,) with the fixed values."""
    rigid = np.flatnonzero(b.bilateral & np.isinf(b.stiffness))
    spring = np.flatnonzero(b.bilateral & np.isfinite(b.stiffness))
    fixed, u = np.zeros(A.size, dtype=bool), np.zeros(A.size)
    fixed[b.unknown[rigid]], u[b.unknown[rigid]] = True, b.offset[rigid]
    barrier = _BarrierProblem(
        A,
        fixed,
        scatter(b.unknown[spring], b.stiffness[spring], A.size),
        f + scatter(b.unknown[spring], b.stiffness[spring] * b.offset[spring], A.size),
        b.unknown[one_sided],
        b.sign[one_sided],
        b.offset[one_sided],
        1 / b.stiffness[one_sided],
        np.isfinite(b.limit_force[one_sided]),
    )
    return barrier, u


def _starting_point(s: _BarrierProblem, u: Array, limit_force: Array, factorization: CachedFactorization) -> _Point:
    """Return the starting point: the solution with springs for bearings, as stiff as the plate itself there.

    With the penetration d of a bearing, p and g follow from p g = mu and p / spring - g = d, within the limit force.
    """
    spring = s.A.diagonal[s.unknown]
    system = s.constrain(spring)
    factorization.factorize(system)
    u = u + _correction(system, s.load - s.A @ u - s.diagonal_shift * u, factorization)
    value = u[s.unknown]
    mu = INITIAL_MU * max(float(np.mean(spring * value**2)) if len(value) else 0.0, np.finfo(float).tiny / FINAL_MU**2)
    d = s.sign * (s.offset - value)
    root = np.sqrt(d**2 + 4 * mu / spring)
    p = np.where(d > 0, spring * (d + root) / 2, 2 * mu / (root - np.minimum(d, 0.0)))
    g = mu / p
    p = np.minimum(p, 0.9 * limit_force)
    q = np.where(s.limited, np.where(s.limited, limit_force, 0.0) - p, 1.0)
    return _Point(u, p, q, g, np.where(s.limited, mu / q, 0.0))


def _newton_step(s: _BarrierProblem, x: _Point, factorization: CachedFactorization) -> _Point:
    """Return the next point by Mehrotra's predictor and corrector."""
    forces, penetrations = s.residuals(x)
    spring = 1.0 / (s.flexibility + x.y / x.q + x.g / x.p)
    system = s.constrain(spring)
    factorization.factorize(system)

    def step(pg: Array, qy: Array) -> _Point:
        """Return the Newton step that changes the products p g and q y by so much (c,)."""
        c = pg / x.p - qy / x.q - penetrations
        bearing_load = np.where(s.fixed, 0.0, scatter(s.unknown, s.sign * spring * c, s.A.size))
        du = _correction(system, forces + bearing_load, factorization)
        dp = spring * (c - s.sign * du[s.unknown])
        dq = np.where(s.limited, -dp, 0.0)
        return _Point(du, dp, dq, (pg - x.g * dp) / x.p, np.where(s.limited, (qy - x.y * dq) / x.q, 0.0))

    predictor = step(-x.p * x.g, -x.q * x.y)
    centering = x.mu * (x.move(predictor, x.longest_step(predictor)).mu / x.mu) ** 3
    corrector = step(
        centering - x.p * x.g - predictor.p * predictor.g,
        np.where(s.limited, centering - x.q * x.y - predictor.q * predictor.y, 0.0),
    )
    return x.move(corrector, min(1.0, STEP_SHARE * x.longest_step(corrector)))


def _correction(system: ConstrainedSystem, load: Array, factorization: CachedFactorization) -> Array:
    """Return the solution (size,) of a linear system under a load, zero where it is fixed."""
    u = np.zeros_like(load)
    factorization.iterate(system, load, u, load.copy(), REFINEMENTS)
    return u


def _read_states(b: Bearings, one_sided: Integers, s: _BarrierProblem, x: _Point) -> Integers:
    """Return the state (c,) that each bearing tends to: the larger of force and opening times stiffness decides."""
    stiffness = s.A.diagonal[s.unknown]
    states = b.admissible(np.full(len(b), CLOSED))
    states[one_sided] = np.where(x.p > stiffness * x.g, CLOSED, OPEN)
    states[one_sided[s.limited & (x.q < stiffness * x.y)]] = YIELDING
    return states
