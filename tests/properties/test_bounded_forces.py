"""Forces between bounds fulfill the conditions of Karush, Kuhn and Tucker, whatever the problem and the start."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from groundslab.arrays import Array
from groundslab.errors import NoEquilibrium
from groundslab.solvers.bounded_forces import BoundedForces, BoundedSolution, balance, solve
from helpers.examples import examples

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

    def gaps(x: Array) -> tuple[Array, Array]:
        return A @ x + c, np.full(len(c), np.abs(A @ x).max())

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


@settings(deadline=None, derandomize=True, database=None, max_examples=examples(300))
@given(problem=problems(), start=st.sampled_from([0.0, 1.0, -30.0, 1e4]))
def test_forces_and_gaps_fit(problem: tuple[Any, ...], start: float) -> None:
    """Forces lie between their bounds, have their resultants, and gaps have the sign that goes with each bound."""
    A, c, p = problem
    found = solve(p, np.full(len(c), start), TOLERANCE, 20_000, lambda *_: None)
    assert ((found.x >= p.lower) & (found.x <= p.upper)).all()
    np.testing.assert_allclose(p.G @ found.x, p.e, atol=1e-9 * (1 + np.abs(found.x).sum()))
    scale = float(np.abs(A @ found.x).max()) or float(np.abs(c).max())
    assert _violation(A, c, p, found) <= 1.01 * TOLERANCE * scale + 1e-12


def _slab(seed: int) -> tuple[BoundedForces, Array]:
    """Return forces under a rectangle with a limit pressure and two supports, and a start.

    Loads are those of forces nearly all of which are at a bound, moved a little inwards or outwards: beside a few that
    lie between, most problems of the kind have a solution just so, or just not.
    """
    rng = np.random.default_rng(seed)
    nx, ny = rng.integers(4, 30, 2)
    side, limit = rng.uniform(0.1, 0.5), 1e5
    own, cells = side**2, int(nx * ny)
    x, y = (each.ravel() for each in np.meshgrid(np.arange(nx), np.arange(ny), indexing="ij"))
    places = side * np.vstack([np.column_stack([x, y]) + 0.5, rng.uniform(0, 1, (2, 2)) * (nx, ny)])
    G = -np.vstack([np.ones(cells + 2), places.T])
    # the first support holds both ways, the other one only presses
    lower, upper = np.zeros(cells + 2), np.full(cells + 2, np.inf)
    lower[cells], upper[:cells] = -np.inf, limit * own
    direction = rng.standard_normal(3) / (1, side * nx, side * ny)
    corner = np.where(G.T @ direction > 0, limit * own, 0.0)
    corner[cells:] = rng.uniform(0, 0.3, 2) * cells * limit * own
    middle = np.append(np.full(cells, limit * own / 2), [0.0, 0.0])
    e = G @ (middle + rng.choice([0.5, 0.9, 0.99, 0.999, 1.05, 1.2]) * (corner - middle))
    weight, start = np.full(cells + 2, own), rng.choice([0.0, own, 30 * own]) * (np.arange(cells + 2) < cells)
    nothing: Any = None
    return BoundedForces(nothing, nothing, nothing, G, e, lower, upper, weight, weight), start


def _can_balance(p: BoundedForces) -> bool:
    """Return whether a linear program finds forces between their bounds that have the resultants."""
    unit, rows = float(p.upper.min()), np.abs(p.G).max(axis=1)
    bounds = np.column_stack([p.lower, p.upper]) / unit
    A = p.G / rows[:, None]
    return bool(linprog(np.zeros(len(p.lower)), A_eq=A, b_eq=p.e / rows / unit, bounds=bounds).status == 0)


@pytest.mark.parametrize("first", range(0, examples(300), 50))
def test_slabs_are_refused_if_and_only_if_a_linear_program_says_so(first: int) -> None:
    """With a limit pressure, a support that holds and one that presses; what is found is balanced to 1e-11."""
    refused = 0
    for seed in range(first, first + 50):
        p, start = _slab(seed)
        if not _can_balance(p):
            refused += 1
            with pytest.raises(NoEquilibrium):
                balance(p, start, p.can_change)
            continue
        z = balance(p, start, p.can_change)
        assert ((z >= p.lower) & (z <= p.upper)).all()
        assert np.abs(p.G @ z - p.e).max() <= 1e-11 * (np.abs(p.G) @ np.abs(z)).max()
    assert 0 < refused < 40
