"""Forces between bounds fulfill the conditions of Karush, Kuhn and Tucker, whatever the problem and the start."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.arrays import Array
from groundslab.solvers.bounded_forces import BoundedForces, BoundedSolution, solve

TOLERANCE = 1e-7


@st.composite
def problems(draw: st.DrawFn) -> tuple[Array, Array, BoundedForces]:
    """Return A, c and a problem with forces between all of its bounds that have the resultants."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    n, r = draw(st.integers(1, 30)), draw(st.integers(0, 3))
    stiff = draw(st.floats(0, 3))
    root = np.linalg.qr(rng.standard_normal((n, n)))[0] * 10 ** rng.uniform(-stiff / 2, 0, n)
    A = root @ root.T + 1e-4 * np.eye(n)
    lower = np.where(rng.random(n) < draw(st.sampled_from([0.0, 0.2, 1.0])), -np.inf, 0.0)
    kinds = [np.full(n, np.inf), rng.uniform(0.1, 1.0, n), np.where(lower == 0, 0.0, 1.0)]
    upper = np.choose(rng.integers(0, draw(st.integers(1, 3)), n), kinds)
    G = np.vstack([np.ones(n), rng.uniform(-1, 1, (2, n))])[:r]
    within = np.maximum(lower, 0) + rng.uniform(0.2, 0.8, n) * np.minimum(upper, 1)
    c = rng.standard_normal(n) * draw(st.sampled_from([0.0, 1e-3, 1.0]))

    def gaps(x: Array) -> tuple[Array, float]:
        return A @ x + c, float(np.abs(A @ x).max())

    def precondition(y: Array) -> Array:
        found: Array = y / np.diag(A)
        return found

    own = np.diag(A).copy()
    return A, c, BoundedForces(gaps, A.__matmul__, precondition, G, G @ within, lower, upper, np.ones(n), own)


def _violation(A: Array, c: Array, p: BoundedForces, found: BoundedSolution) -> float:
    """Return by how much gaps contradict forces, from the forces and multipliers alone."""
    y = A @ found.x + c + p.G.T @ found.alpha
    at_lower, at_upper = found.x <= p.lower, found.x >= p.upper
    wrong = np.where(at_lower & at_upper, 0.0, np.where(at_lower, -y, np.where(at_upper, y, np.abs(y))))
    return float(np.maximum(wrong, 0.0).max())


@settings(deadline=None, derandomize=True, database=None, max_examples=300)
@given(problem=problems(), start=st.sampled_from([0.0, 1.0, -30.0, 1e4]))
def test_forces_and_gaps_fit(problem: tuple[Any, ...], start: float) -> None:
    """Forces lie between their bounds, have their resultants, and gaps have the sign that goes with each bound."""
    A, c, p = problem
    found = solve(p, np.full(len(c), start), TOLERANCE, 20_000, lambda *_: None)
    assert ((found.x >= p.lower) & (found.x <= p.upper)).all()
    np.testing.assert_allclose(p.G @ found.x, p.e, atol=1e-9 * (1 + np.abs(found.x).sum()))
    scale = float(np.abs(A @ found.x).max()) or float(np.abs(c).max())
    assert _violation(A, c, p, found) <= 1.01 * TOLERANCE * scale + 1e-12
