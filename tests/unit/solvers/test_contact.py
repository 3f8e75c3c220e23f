"""Unilateral contact against brute force over all sets of closed gaps, and against non-negative least squares."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls

from groundslab.errors import NotConverged, SingularMatrix
from groundslab.fem.assembly import Pattern
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact, make_bearings
from groundslab.solvers import contact, factor_reuse, factorization
from groundslab.solvers.direct.protocols import Factor
from groundslab.solvers.factor_reuse import CachedFactorization
from helpers.bearings import NODES, any_bearings, entries, one_element, positive
from helpers.examples import examples


@pytest.fixture(autouse=True, params=[0, factor_reuse.MAX_UPDATE_RANK], ids=["factors", "updates"])
def few(request: pytest.FixtureRequest) -> Iterator[int]:
    """Let every test pass with a factor for each set of states, and with one factor for near ones."""
    with patch.object(factor_reuse, "MAX_UPDATE_RANK", request.param):
        yield request.param


class Dense:
    """A solver for tests: Cholesky of the full matrix, refusing pivots that are nearly zero; counts what it does."""

    def __init__(self, p: Pattern) -> None:
        self.p = p
        self.factored = 0
        self.refused = 0

    def factor(self, data: np.ndarray) -> Factor:
        self.factored += 1
        A = full(self.p, data)
        if np.linalg.eigvalsh(A).min() < 1e-9 * np.abs(A).max():
            self.refused += 1
            raise SingularMatrix("too few gaps are closed")
        self.inverse = np.linalg.inv(A)
        return self

    def solve(self, b: np.ndarray) -> np.ndarray:
        return self.inverse @ b


def full(p: Pattern, data: np.ndarray) -> np.ndarray:
    """Return the matrix (size, size) of the data."""
    A = np.zeros((p.size, p.size))
    A[np.repeat(np.arange(p.size), np.diff(p.indptr)), p.indices] = data
    return np.triu(A) + np.triu(A, 1).T


def closed_gaps(at: np.ndarray) -> Bearings:
    """Return bearings on gaps that are closed at first."""
    return make_bearings(at, 1.0, 0.0)


def solve(
    A: np.ndarray, f: np.ndarray, gaps: np.ndarray, start: np.ndarray, limit: int = 200, name: str = "superlu"
) -> tuple[Contact, list[tuple[int, int, int]]]:
    """Return the module's solution of a dense problem of at most nine unknowns a field, and its report."""
    p = one_element(len(A) // 9)
    steps: list[tuple[int, int, int]] = []
    symbolic = factorization.choose(name)[1](p.indptr, p.indices)
    result = contact.solve(
        contact.ContactProblem(entries(p, A), f, closed_gaps(gaps)),
        CachedFactorization(symbolic),
        start,
        limit,
        lambda *step: steps.append(step),
    )
    return result, steps


def by_brute_force(A: np.ndarray, f: np.ndarray, gaps: np.ndarray) -> np.ndarray:
    """Return the one u that fulfils all conditions, found by trying every set of closed gaps."""
    found = []
    for closed in product([False, True], repeat=len(gaps)):
        free = np.setdiff1d(np.arange(len(f)), gaps[np.array(closed, dtype=bool)])
        u = np.zeros(len(f))
        u[free] = np.linalg.solve(A[np.ix_(free, free)], f[free])
        if (u[gaps] >= -1e-11).all() and ((A @ u - f)[gaps] >= -1e-11).all():
            found.append(u)
    np.testing.assert_allclose(found, np.broadcast_to(found[0], (len(found), len(f))), atol=1e-7)
    return found[0]


@settings(max_examples=examples(25), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000), condition=st.sampled_from([2.0, 100.0, 1e4]), all_closed=st.booleans())
def test_all_unknowns_are_gaps(seed: int, condition: float, all_closed: bool) -> None:
    """Minimising 1/2 u.A u - f.u over u >= 0 is non-negative least squares of the Cholesky factor: nnls agrees."""
    rng = np.random.default_rng(seed)
    A, f = positive(rng, 9, condition), rng.standard_normal(9)
    result, _ = solve(A, f, NODES, np.full(9, all_closed))
    L = np.linalg.cholesky(A)
    wanted, _ = nnls(L.T, np.linalg.solve(L, f))
    np.testing.assert_allclose(result.u, wanted, atol=1e-8)
    np.testing.assert_array_equal(result.closed, wanted == 0)
    np.testing.assert_allclose(result.force, A @ wanted - f, atol=1e-7)


@settings(max_examples=examples(15), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000), condition=st.sampled_from([2.0, 1e3]), gaps=st.integers(1, 6))
def test_some_unknowns_are_gaps(seed: int, condition: float, gaps: int) -> None:
    """With unknowns free to go either way the solution is the only set of closed gaps that breaks no condition."""
    rng = np.random.default_rng(seed)
    A, f = positive(rng, 9, condition), rng.standard_normal(9)
    chosen = np.sort(rng.permutation(9)[:gaps])
    result, _ = solve(A, f, chosen, rng.random(gaps) < 0.5)
    np.testing.assert_allclose(result.u, by_brute_force(A, f, chosen), atol=1e-8)


@settings(max_examples=examples(10), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_result_is_complementary(seed: int) -> None:
    """Gaps and forces are never negative, never both positive, and free unknowns are in equilibrium."""
    rng = np.random.default_rng(seed)
    A, f = positive(rng, 18, 100.0), rng.standard_normal(18)
    gaps = np.arange(1, 18, 2)
    result, _ = solve(A, f, gaps, np.ones(9, dtype=bool))
    assert result.u[gaps].min() >= -1e-9
    assert result.force.min() >= 0
    assert (result.u[gaps][result.closed] == 0).all()
    assert (result.force[~result.closed] == 0).all()
    left_over = A @ result.u - f
    left_over[gaps] -= result.force
    np.testing.assert_allclose(left_over, 0, atol=1e-10)


@pytest.mark.parametrize("name", ["superlu", "cholmod", "pardiso"])
def test_without_gaps_it_is_one_linear_solution(name: str) -> None:
    """No gaps: one iteration, u = A^-1 f."""
    if name != "superlu":
        pytest.importorskip({"pardiso": "pypardiso", "cholmod": "cvxopt"}[name])
    rng = np.random.default_rng(3)
    A, f = positive(rng, 9, 10.0), rng.standard_normal(9)
    none = np.zeros(0, dtype=np.int64)
    result, steps = solve(A, f, none, np.zeros(0, dtype=bool), name=name)
    np.testing.assert_allclose(A @ result.u, f, atol=1e-12)
    assert steps == [(1, 0, 0)]


#: Found by random search: the plain active set iteration runs in a circle from full contact. On the second one it
#: does so again and again if single pivots end as soon as they have made up for what they cost.
CYCLE_A = np.array([
    [18.05, 3.00, 12.00, -3.00],
    [3.00, 11.05, -3.00, -11.00],
    [12.00, -3.00, 12.05, 7.00],
    [-3.00, -11.00, 7.00, 21.05],
])  # fmt: skip
CYCLE_F = np.array([3.0, 3.0, 1.0, -1.0])
WIDER_A = np.array([
    [23.05, -2.00, 22.00, -15.00, 1.00],
    [-2.00, 12.05, 8.00, -6.00, 7.00],
    [22.00, 8.00, 31.05, -23.00, 4.00],
    [-15.00, -6.00, -23.00, 21.05, -5.00],
    [1.00, 7.00, 4.00, -5.00, 21.05],
])  # fmt: skip
WIDER_F = np.array([-1.0, 2.0, -1.0, 1.0, 3.0])


def plain_iteration(A: np.ndarray, f: np.ndarray, closed: np.ndarray, limit: int) -> list[tuple[bool, ...]]:
    """Return the sets of closed gaps that the unprotected iteration runs through until it ends or at most `limit`."""
    sets = []
    for _ in range(limit):
        sets.append(tuple(closed))
        u = np.zeros(len(f))
        u[~closed] = np.linalg.solve(A[np.ix_(~closed, ~closed)], f[~closed])
        wrong = np.where(closed, A @ u - f < -1e-12, u < -1e-12)
        if not wrong.any():
            break
        closed = closed ^ wrong
    return sets


@pytest.mark.parametrize(("matrix", "load"), [(CYCLE_A, CYCLE_F), (WIDER_A, WIDER_F)])
def test_a_cycle_is_broken(matrix: np.ndarray, load: np.ndarray) -> None:
    """On a problem where the plain iteration provably runs in a circle the safeguarded one finds the solution."""
    n = len(load)
    sets = plain_iteration(matrix, load, np.ones(n, dtype=bool), 50)
    assert len(sets) == 50
    assert len(set(sets)) < 10
    A, f = np.eye(9), np.ones(9)
    A[:n, :n], f[:n] = matrix, load
    gaps = np.arange(n)
    result, steps = solve(A, f, gaps, np.ones(n, dtype=bool))
    np.testing.assert_allclose(result.u, by_brute_force(A, f, gaps), atol=1e-9)
    assert len(steps) < 20


@pytest.mark.slow
@settings(max_examples=examples(10), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_every_start_leads_to_the_same_solution(seed: int) -> None:
    """The minimum is unique, so it cannot matter which gaps are closed at first."""
    rng = np.random.default_rng(seed)
    A, f = positive(rng, 9, 1e3), rng.standard_normal(9)
    results = [solve(A, f, NODES, rng.random(9) < share)[0].u for share in (0.0, 0.3, 0.7, 1.1)]
    np.testing.assert_allclose(results, np.broadcast_to(results[0], (4, 9)), atol=1e-9)


def plate_on_springs(k: float, F: list[float]) -> tuple[Pattern, np.ndarray, np.ndarray, np.ndarray]:
    """Return pattern, A, f and gaps of a small plate of 3 x 3 nodes on nine springs k (w + g)^2 / 2 under forces F.

    Its bending is that of finite differences: it resists curvature and twist, and moves freely as a rigid plane.
    """
    curve, slope, one = np.diff(np.eye(3), n=2, axis=0), np.diff(np.eye(3), axis=0), np.eye(3)
    B = np.vstack([np.kron(one, curve), np.kron(curve, one), np.kron(slope, slope)])
    w, g = np.arange(0, 18, 2), np.arange(1, 18, 2)
    A = np.zeros((18, 18))
    A[np.ix_(w, w)] = B.T @ B + k * np.eye(9)
    A[np.ix_(w, g)] = A[np.ix_(g, w)] = A[np.ix_(g, g)] = k * np.eye(9)
    f = np.zeros(18)
    f[w] = F
    return one_element(2), A, f, g


#: Found by random search: on the way to the solution too few gaps are closed to hold the plate as a rigid body.
FLOATING = {
    "four springs at the end": (89.4, [0, 1, -2, 5, 0, 0, -2, 0, 4]),
    "three springs at the end": (109.0, [0, -1, 6, -1, -1, 0, 5, 0, -3]),
    "balanced on two springs": (358.0, [0, 0, 6, 0, -1, 0, 5, 0, 0]),
    "balanced on two springs, skew": (21.8, [3, 0, -1, 2, 0, 1, -1, -1, 6]),
}


@pytest.mark.parametrize(("k", "F"), FLOATING.values(), ids=FLOATING.keys())
def test_a_plate_that_floats_on_the_way_comes_to_rest(k: float, F: list[float], few: int) -> None:
    """Where the closed gaps do not hold the plate the iteration goes on to the solution, be it a balancing act.

    On two springs right under the resultant the plate is in equilibrium although nothing keeps it from tilting; then
    some digits are all that is promised.
    """
    p, A, f, gaps = plate_on_springs(k, F)
    symbolic = Dense(p)
    result = contact.solve(
        contact.ContactProblem(entries(p, A), f, closed_gaps(gaps)),
        CachedFactorization(symbolic),
        np.ones(9, dtype=bool),
        100,
        lambda *_: None,
    )
    assert symbolic.refused > 0 or few
    tiny = 1e-8 if result.closed.sum() > 2 else 1e-2
    left_over = A @ result.u - f
    left_over[gaps] -= result.force
    np.testing.assert_allclose(left_over, 0, atol=tiny)
    assert result.u[gaps].min() >= -tiny
    assert result.force.min() >= -1e-12
    assert np.abs(result.force * result.u[gaps]).max() < tiny
    place = np.stack(np.meshgrid([-1, 0, 1], [-1, 0, 1]), axis=-1).reshape(9, 2)
    np.testing.assert_allclose(result.force @ place, f[::2] @ place, atol=tiny)


def test_a_matrix_that_is_not_positive_is_an_error() -> None:
    """With every gap closed and still no hold there is nothing to take back: SingularMatrix."""
    p = one_element(2)
    A = np.diag(np.tile([0.0, 1.0], 9))
    symbolic = Dense(p)
    with pytest.raises(SingularMatrix):
        contact.solve(
            contact.ContactProblem(entries(p, A), np.ones(18), closed_gaps(np.arange(1, 18, 2))),
            CachedFactorization(symbolic),
            np.ones(9, bool),
            50,
            lambda *_: None,
        )


def test_the_limit_raises_with_history_and_last_iterate() -> None:
    """Out of steps is an error that says what happened in each and hands over the last iterate, not a result."""
    rng = np.random.default_rng(1)
    while True:
        A, f = positive(rng, 9, 1e3), rng.standard_normal(9)
        _, steps = solve(A, f, NODES, np.ones(9, dtype=bool))
        if len(steps) >= 3:
            break
    with pytest.raises(NotConverged) as caught:
        solve(A, f, NODES, np.ones(9, dtype=bool), limit=2)
    error = caught.value
    assert [step["iteration"] for step in error.history] == [1, 2]
    assert [(s["closed"], s["changed"]) for s in error.history] == [step[1:] for step in steps[:2]]
    assert all(s["changed"] > 0 for s in error.history)
    assert error.last["u"].shape == (9,)
    assert error.last["closed"].shape == (9,)
    assert "contact zone" in str(error)


def test_steps_are_reported_as_they_happen() -> None:
    """The report counts from 1, starts with the start's closed gaps and ends with no change."""
    rng = np.random.default_rng(5)
    A, f = positive(rng, 9, 1e3), rng.standard_normal(9)
    start = np.array([True] * 4 + [False] * 5)
    result, steps = solve(A, f, NODES, start)
    assert [step[0] for step in steps] == list(range(1, len(steps) + 1))
    assert steps[0][1] == 4
    assert steps[-1][1:] == (int(result.closed.sum()), 0)
    assert all(step[2] > 0 for step in steps[:-1])


@pytest.mark.slow
@settings(max_examples=examples(60), derandomize=True, deadline=None)
@given(seed=st.integers(0, 10_000), condition=st.sampled_from([2.0, 1e3]), count=st.integers(1, 9))
def test_bearings_of_every_kind_follow_their_law(seed: int, condition: float, count: int) -> None:
    """What is left over at an unknown is the force that its bearing's law gives for the way it is driven in."""
    rng = np.random.default_rng(seed)
    A, f = positive(rng, 9, condition), 3 * rng.standard_normal(9)
    b, p = any_bearings(rng, 9, count), one_element()
    symbolic = factorization.choose("superlu")[1](p.indptr, p.indices)
    start = rng.integers(0, 3, count)
    start[(start == YIELDING) & np.isinf(b.limit_force)] = OPEN
    result = contact.solve(
        contact.ContactProblem(entries(p, A), f, b), CachedFactorization(symbolic), start, 200, lambda *_: None
    )
    force, driven, tiny = np.zeros(9), b.penetration(result.u), 1e-8 * max(1.0, np.abs(result.u).max() * condition)
    force[b.unknown] = b.sign * result.force
    np.testing.assert_allclose(A @ result.u - f, force, atol=tiny)
    rigid = np.isinf(b.stiffness)
    law = np.where(rigid, 0.0, np.where(rigid, 0.0, b.stiffness) * driven)
    law = np.where(b.bilateral, law, np.clip(law, 0.0, b.limit_force))
    np.testing.assert_allclose(result.force[~rigid], law[~rigid], atol=tiny)
    held = rigid & b.bilateral
    np.testing.assert_allclose(driven[held], 0.0, atol=tiny)
    one_sided = rigid & ~b.bilateral
    assert (result.force[one_sided] >= -tiny).all()
    assert (result.force[one_sided] <= b.limit_force[one_sided] + tiny).all()
    assert (driven[one_sided & (result.force < b.limit_force - tiny)] <= tiny).all()
    assert (driven[one_sided & (result.force > tiny)] >= -tiny).all()


def test_two_bearings_may_share_an_unknown() -> None:
    """A rigid stop beyond an elastic support takes what this one leaves: 10 N on k = 2 N/m and a stop at 3 m."""
    p = one_element()
    f = np.zeros(9)
    f[4] = 10.0
    b = Bearings(
        np.array([4, 4]), -np.ones(2), np.array([0.0, 3.0]), np.array([2.0, np.inf]), np.full(2, np.inf),
        np.zeros(2, dtype=bool),
    )  # fmt: skip
    symbolic = factorization.choose("superlu")[1](p.indptr, p.indices)
    result = contact.solve(
        contact.ContactProblem(entries(p, 0.5 * np.eye(9)), f, b),
        CachedFactorization(symbolic),
        np.zeros(2, dtype=int),
        50,
        lambda *_: None,
    )
    assert result.u[4] == pytest.approx(3.0)
    np.testing.assert_allclose(result.force, [6.0, 10.0 - 6.0 - 0.5 * 3.0])


@pytest.mark.parametrize("known", [True, False])
def test_small_tension_is_held_against_what_presses_alike(known: bool) -> None:
    """Ground that would have to pull with 1e-6 N beside ground that presses with 5 N lets go of the plate.

    A support that carries 2e5 N, of another kind, must not hide it: 1e-10 of its force is more.
    """
    p = one_element()
    f = np.zeros(9)
    f[[0, 1, 2, 3]] = -2e5, -5.0, 1e-6, 1e5
    b = make_bearings(np.array([0, 1, 2]), 1.0, 0.0)
    symbolic = factorization.choose("superlu")[1](p.indptr, p.indices)
    found = contact.solve(
        contact.ContactProblem(
            entries(p, 1e6 * np.eye(9)), f, b, of_supports=np.array([True, False, False]) if known else None
        ),
        CachedFactorization(symbolic),
        np.ones(3, dtype=int),
        50,
        lambda *_: None,
    )
    assert found.state.tolist() == [CLOSED, CLOSED, OPEN if known else CLOSED]
