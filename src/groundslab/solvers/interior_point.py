"""States of one-sided bearings by an interior point method, which takes some thirty steps for plates of any kind.

For 1/2 u.A u - f.u with bearings (module `bearings`): the force p of a bearing, what that lacks to its capacity,
q = F - p, the way g by which it is open and the way y by which it has slipped at its capacity fulfil

    A u - f = s p,    s (l - u) = p / k + y - g,    p g = mu,    q y = mu,    all of p, q, g, y above 0

and mu is driven to zero by Newton's method with Mehrotra's predictor and corrector (Mehrotra 1992). Eliminating all but
u leaves A with a spring at every bearing, so that no plate floats on the way.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import SingularMatrix
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact, total
from groundslab.fem.sparse import Symmetric
from groundslab.solvers.factor_reuse import Latest, Task

#: mu begins so many times larger than force times way of the glued plate: too small a start costs many short steps.
START = 1e3
#: It ends when mu has fallen to this share.
END = 1e-14
#: Share of the way to the nearest bound that a step takes.
SHORT_OF_THE_BOUND = 0.995
LIMIT = 100
#: Steps of conjugate gradients that take rounding off each of Newton's steps.
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

    def longest(self, step: _Point) -> float:
        """Return how far a step can go, 1 at most, until one of p, q, g, y vanishes."""
        t = 1.0
        for name in ("p", "q", "g", "y"):
            at, way = getattr(self, name), getattr(step, name)
            falls = way < 0
            t = min(t, float((-at[falls] / way[falls]).min(initial=1.0)))
        return t

    def moved(self, step: _Point, t: float) -> _Point:
        """Return the point a share of a step further."""
        return _Point(*(getattr(self, name) + t * getattr(step, name) for name in ("u", "p", "q", "g", "y")))


@dataclass(frozen=True, slots=True)
class _Barrier:
    """The problem without its bearings that are closed for ever: those are held, or springs in `added` and `load`."""

    A: Symmetric
    held: Flags  # (size,)
    added: Array  # (size,)
    load: Array  # (size,)
    at: Integers  # (c,): of the one-sided bearings that can bear
    sign: Array
    level: Array
    flexibility: Array
    limited: Flags

    def task(self, spring: Array) -> Task:
        """Return what is to be solved with a spring (c,) at each bearing."""
        return Task(self.A, self.held, self.added + total(self.at, spring, self.A.size), np.zeros(self.A.size))

    def residuals(self, x: _Point) -> tuple[Array, Array]:
        """Return what is left over of equilibrium (size,) and of the bearings' ways (c,)."""
        forces = self.load + total(self.at, self.sign * x.p, self.A.size) - self.A @ x.u - self.added * x.u
        ways = x.p * self.flexibility + x.y - x.g - self.sign * (self.level - x.u[self.at])
        return np.where(self.held, 0.0, forces), ways


def solve(A: Symmetric, f: Array, latest: Latest, b: Bearings, report: Callable[[Integers, int], None]) -> Contact:
    """Return what the bearings come to; report is told the states (c,) of every step, and how many have changed.

    Raises SingularMatrix if A is not positive even with a spring at every bearing.
    """
    one_sided = np.flatnonzero(~b.both_ways & (b.capacity > 0))
    barrier, u = _barrier(A, f, b, one_sided)
    capacity = b.capacity[one_sided]
    x = _start(barrier, u, capacity, latest)
    end, states = END * x.mu, _states(b, one_sided, barrier, x)
    for _ in range(LIMIT):
        if x.mu <= end:
            break
        try:
            x = _newton(barrier, x, latest)
        except SingularMatrix:
            break  # springs of vanishing ways are beyond all numbers: nothing is left to gain
        before, states = states, _states(b, one_sided, barrier, x)
        report(states, int((states != before).sum()))
    force = np.zeros(len(b))
    force[one_sided] = x.p
    return Contact(x.u, states, force)


def _barrier(A: Symmetric, f: Array, b: Bearings, one_sided: Integers) -> tuple[_Barrier, Array]:
    """Return the problem for the interior point method, and unknowns (size,) with the values of held ones."""
    rigid = np.flatnonzero(b.both_ways & np.isinf(b.stiffness))
    spring = np.flatnonzero(b.both_ways & np.isfinite(b.stiffness))
    held, u = np.zeros(A.size, dtype=bool), np.zeros(A.size)
    held[b.at[rigid]], u[b.at[rigid]] = True, b.level[rigid]
    barrier = _Barrier(
        A,
        held,
        total(b.at[spring], b.stiffness[spring], A.size),
        f + total(b.at[spring], b.stiffness[spring] * b.level[spring], A.size),
        b.at[one_sided],
        b.sign[one_sided],
        b.level[one_sided],
        1 / b.stiffness[one_sided],
        np.isfinite(b.capacity[one_sided]),
    )
    return barrier, u


def _start(s: _Barrier, u: Array, capacity: Array, latest: Latest) -> _Point:
    """Return the point to begin with: what the loads do to a plate with springs for bearings, as stiff as itself there.

    A bearing is then driven in by d; p and g are those for which p g = mu and p / spring - g = d, where capacities
    allow.
    """
    spring = s.A.diagonal[s.at]
    u = u + _solved(s.task(spring), s.load - s.A @ u - s.added * u, latest, new=True)
    way = u[s.at]
    mu = START * max(float(np.mean(spring * way**2)) if len(way) else 0.0, np.finfo(float).tiny / END**2)
    d = s.sign * (s.level - way)
    root = np.sqrt(d**2 + 4 * mu / spring)
    p = np.where(d > 0, spring * (d + root) / 2, 2 * mu / (root - np.minimum(d, 0.0)))
    g = mu / p
    p = np.minimum(p, 0.9 * capacity)
    q = np.where(s.limited, np.where(s.limited, capacity, 0.0) - p, 1.0)
    return _Point(u, p, q, g, np.where(s.limited, mu / q, 0.0))


def _newton(s: _Barrier, x: _Point, latest: Latest) -> _Point:
    """Return the next point by Mehrotra's predictor and corrector."""
    left = s.residuals(x)
    spring = 1.0 / (s.flexibility + x.y / x.q + x.g / x.p)
    task = s.task(spring)
    latest.factor(task)

    def step(pg: Array, qy: Array) -> _Point:
        """Return Newton's step that changes the products p g and q y by so much (c,)."""
        c = pg / x.p - qy / x.q - left[1]
        du = _solved(task, left[0] + np.where(s.held, 0.0, total(s.at, s.sign * spring * c, s.A.size)), latest)
        dp = spring * (c - s.sign * du[s.at])
        dq = np.where(s.limited, -dp, 0.0)
        return _Point(du, dp, dq, (pg - x.g * dp) / x.p, np.where(s.limited, (qy - x.y * dq) / x.q, 0.0))

    predictor = step(-x.p * x.g, -x.q * x.y)
    centring = x.mu * (x.moved(predictor, x.longest(predictor)).mu / x.mu) ** 3
    corrector = step(
        centring - x.p * x.g - predictor.p * predictor.g,
        np.where(s.limited, centring - x.q * x.y - predictor.q * predictor.y, 0.0),
    )
    return x.moved(corrector, min(1.0, SHORT_OF_THE_BOUND * x.longest(corrector)))


def _solved(task: Task, load: Array, latest: Latest, new: bool = False) -> Array:
    """Return the solution (size,) of a task under a load, zero where it is held."""
    if new:
        latest.factor(task)
    u, left = np.zeros_like(load), load.copy()
    latest.improve(task, load, u, left, REFINEMENTS)
    return u


def _states(b: Bearings, one_sided: Integers, s: _Barrier, x: _Point) -> Integers:
    """Return the state (c,) that each bearing tends to: which of force and way, made a force, is the larger."""
    stiffness = s.A.diagonal[s.at]
    states = b.lasting(np.full(len(b), CLOSED))
    states[one_sided] = np.where(x.p > stiffness * x.g, CLOSED, OPEN)
    states[one_sided[s.limited & (x.q < stiffness * x.y)]] = YIELDING
    return states
