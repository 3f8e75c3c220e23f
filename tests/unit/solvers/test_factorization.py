"""Direct solvers: right answers, honest refusals, one analysis for many matrices."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
from scipy.sparse import csr_array, triu

from groundslab.errors import InputError, SingularMatrix
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.solvers import factor_reuse, factorization
from groundslab.solvers.direct import pardiso, protocols

SOLVERS = ["pardiso", "cholmod", "superlu"]
PACKAGES = {"pardiso": "pypardiso", "cholmod": "cvxopt"}


def upper_half(A: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return indptr, indices, data of the upper half of A, with every entry of the band stored."""
    half = csr_array(triu(csr_array(A)))
    half.sort_indices()
    return half.indptr.astype(np.int32), half.indices.astype(np.int32), half.data.copy()


def random_positive(n: int, seed: int) -> np.ndarray:
    """Return a banded positive definite matrix (n, n) of random entries."""
    rng = np.random.default_rng(seed)
    A = np.tril(np.triu(rng.standard_normal((n, n)), -5), 5)
    A = A + A.T
    return A + np.diag(np.abs(A).sum(axis=1) * rng.uniform(1.01, 2.0, n))


def solver(name: str) -> protocols.Solver:
    """Return a solver, or skip the test where it is not installed."""
    if name in PACKAGES:
        pytest.importorskip(PACKAGES[name])
    return factorization.choose(name)[1]


@pytest.mark.parametrize("name", SOLVERS)
@pytest.mark.parametrize("n", [1, 2, 40, 300])
def test_solution_of_one_and_of_several_right_sides(name: str, n: int) -> None:
    """A x = b holds for the full symmetric matrix although only its upper half is given."""
    A = random_positive(n, seed=n)
    indptr, indices, data = upper_half(A)
    factor = solver(name)(indptr, indices).factor(data)
    b = np.random.default_rng(1).standard_normal((n, 3))
    np.testing.assert_allclose(A @ factor.solve(b[:, 0].copy()), b[:, 0], atol=1e-11)
    np.testing.assert_allclose(A @ factor.solve(b), b, atol=1e-11)


def test_all_agree() -> None:
    """Programs that share no line give the same solution."""
    A = random_positive(200, seed=9)
    indptr, indices, data = upper_half(A)
    b = np.random.default_rng(2).standard_normal(200)
    x = [solver(name)(indptr, indices).factor(data).solve(b.copy()) for name in SOLVERS]
    for other in x[1:]:
        np.testing.assert_allclose(x[0], other, rtol=1e-10, atol=1e-14)


@pytest.mark.parametrize("name", SOLVERS)
def test_same_pattern_other_numbers(name: str) -> None:
    """A pattern once analysed serves matrices with quite different entries, each solved by its own factor."""
    A = random_positive(60, seed=5)
    indptr, indices, data = upper_half(A)
    symbolic = solver(name)(indptr, indices)
    b = np.ones(60)
    for factor in (1.0, 1e-6, 1e12):
        np.testing.assert_allclose(factor * A @ symbolic.factor(factor * data).solve(b.copy()), b, atol=1e-11)
    harder = data.copy()
    harder[indptr[:-1]] *= 3
    B = A + 2 * np.diag(np.diag(A))
    np.testing.assert_allclose(B @ symbolic.factor(harder).solve(b.copy()), b, atol=1e-11)


@pytest.mark.parametrize("name", SOLVERS)
def test_indefinite_matrix_is_refused(name: str) -> None:
    """A negative eigenvalue is an error, not a solution: energy could be won without end."""
    A = random_positive(30, seed=6)
    w, V = np.linalg.eigh(A)
    w[0] = -w[0]
    B = (V * w) @ V.T
    indptr, indices, data = upper_half(B)
    symbolic = solver(name)(indptr, indices)
    with pytest.raises(SingularMatrix, match="not positive definite"):
        symbolic.factor(data)


@pytest.mark.parametrize("name", SOLVERS)
@pytest.mark.parametrize("n", [3, 50])
def test_singular_matrix_is_refused(name: str, n: int) -> None:
    """A chain of springs without a support has a rigid motion; that is an error (a hair's breadth below zero, so that
    rounding does not decide).
    """
    A = (2 - 1e-9) * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    A[0, 0] = A[-1, -1] = 1.0 - 1e-9
    indptr, indices, data = upper_half(A)
    with pytest.raises(SingularMatrix):
        solver(name)(indptr, indices).factor(data)


@pytest.mark.parametrize("name", SOLVERS)
def test_refusal_does_not_spoil_the_pattern(name: str) -> None:
    """After a matrix was refused the same analysis factorises the next one."""
    A = random_positive(30, seed=7)
    indptr, indices, data = upper_half(A)
    symbolic = solver(name)(indptr, indices)
    zero = data.copy()
    zero[indptr[3]] = -1.0
    with pytest.raises(SingularMatrix):
        symbolic.factor(zero)
    b = np.arange(30.0)
    np.testing.assert_allclose(A @ symbolic.factor(data).solve(b), b, atol=1e-10)


@pytest.mark.parametrize("name", SOLVERS)
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_entries_that_are_no_numbers_are_refused(name: str, bad: float) -> None:
    """NaN and infinity stop the program instead of running through it."""
    indptr, indices, data = upper_half(random_positive(10, seed=8))
    data[4] = bad
    with pytest.raises(SingularMatrix):
        solver(name)(indptr, indices).factor(data)


@pytest.mark.parametrize("name", SOLVERS)
def test_a_zero_on_the_diagonal_is_refused(name: str) -> None:
    """No exchange of rows makes up for an unknown without any stiffness of its own."""
    indptr, indices, data = upper_half(np.array([[1.0, 0.0, 0.0], [0.0, 1e-300, 1.0], [0.0, 1.0, 1e-300]]))
    data[data < 1e-200] = 0.0
    with pytest.raises(SingularMatrix):
        solver(name)(indptr, indices).factor(data)


def test_analysis_is_made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """PARDISO is called with analysis for the first matrix (phase 12) and without for the next ones (phase 22)."""
    phases: list[int] = []
    original = pardiso.Pardiso._call

    def spy(self: Any, phase: int, b: np.ndarray) -> np.ndarray:
        phases.append(phase)
        return original(self, phase, b)

    monkeypatch.setattr(pardiso.Pardiso, "_call", spy)
    indptr, indices, data = upper_half(random_positive(20, seed=3))
    symbolic = solver("pardiso")(indptr, indices)
    for factor in (1.0, 2.0, 3.0):
        symbolic.factor(factor * data).solve(np.ones(20))
    assert phases == [12, 33, 22, 33, 22, 33]


@pytest.fixture
def asked_anew(request: pytest.FixtureRequest) -> Iterator[None]:
    """Forget whether PARDISO can be loaded, in this test and after it."""
    if request.config.getoption("--solver"):
        pytest.skip("the solver is given")
    pardiso.pardiso_import_error.cache_clear()
    yield
    pardiso.pardiso_import_error.cache_clear()


@pytest.mark.usefixtures("asked_anew")
def test_without_pypardiso_another_takes_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where pypardiso cannot be imported "auto" is another, and asking for it by name is an input error."""
    monkeypatch.setitem(sys.modules, "pypardiso", None)
    assert factorization.choose("auto")[0] in ("cholmod", "superlu")
    with pytest.raises(InputError, match=r"pardiso.*cannot be loaded"):
        factorization.choose("pardiso")


@pytest.mark.usefixtures("asked_anew")
@pytest.mark.parametrize(("there", "taken"), [(True, "cholmod"), (False, "superlu")])
def test_on_other_processors(monkeypatch: pytest.MonkeyPatch, there: bool, taken: str) -> None:
    """MKL exists for x86-64 alone, so elsewhere its import is not even tried: CHOLMOD is taken, or SuperLU."""
    monkeypatch.setattr(factorization.platform, "machine", lambda: "arm64")
    monkeypatch.setattr(factorization, "import_pardiso", lambda: pytest.fail("tried to import pypardiso"))
    monkeypatch.setattr(factorization, "find_spec", lambda _: there or None)
    assert factorization.choose("auto") == (taken, factorization.SOLVERS[taken])
    if not there:
        with pytest.raises(InputError, match=r"(?s)cvxopt.*groundslab\[cholmod\]"):
            factorization.choose("cholmod")


@pytest.mark.parametrize("name", SOLVERS)
def test_solver_by_name(name: str) -> None:
    """A solver asked for by name is the one that comes back."""
    solver(name)
    assert factorization.choose(name)[0] == name


def _constrained(
    A: np.ndarray, fixed: np.ndarray, shift: np.ndarray, like: factor_reuse.ConstrainedSystem | None = None
) -> factor_reuse.ConstrainedSystem:
    """Return a constrained system; its matrix is that of another system if one is given."""
    if like is not None:
        return factor_reuse.ConstrainedSystem(like.A, fixed, shift, 0 * shift)
    indptr, indices, data = upper_half(A)
    return factor_reuse.ConstrainedSystem(Symmetric(indptr, indices, data), fixed, shift, 0 * shift)


@pytest.mark.parametrize("name", SOLVERS)
@pytest.mark.parametrize("changes", [0, 1, 2, 4, 16])
def test_a_factor_solves_systems_close_to_its_own(name: str, changes: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Unknowns newly fixed, newly free or with another diagonal: the old factor leads to the new solution at once."""
    monkeypatch.setattr(factor_reuse, "MIN_PRECONDITIONED_SIZE", 0)
    n, rng = 60, np.random.default_rng(changes)
    A = random_positive(n, 7)
    fixed, shift = rng.random(n) < 0.4, np.where(rng.random(n) < 0.3, 5.0, 0.0)
    own = _constrained(A, fixed, shift)
    cache = factor_reuse.CachedFactorization(solver(name)(own.A.indptr, own.A.indices))
    assert not cache.preconditions(own)
    cache.factorize(own)
    which = rng.choice(n, changes, replace=False)
    other_fixed, other_shift = fixed.copy(), shift.copy()
    other_fixed[which[::2]] ^= True
    other_shift[which[1::2]] += 3.0
    system = _constrained(A, other_fixed, other_shift, own)
    assert cache.preconditions(system)
    assert cache.holds(system) == (system.count_differences(own) == 0)

    load, u = rng.standard_normal(n), np.where(other_fixed, rng.standard_normal(n), 0.0)
    residual = load - A @ u
    assert cache.iterate(system, load, u, residual, 2)
    free = ~other_fixed
    wanted = u.copy()
    K = A + np.diag(other_shift)
    wanted[free] = np.linalg.solve(K[np.ix_(free, free)], (load - K @ np.where(other_fixed, u, 0.0))[free])
    np.testing.assert_allclose(u, wanted, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(residual, load - A @ u, atol=1e-11)


def test_too_few_steps_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """A system far from the factorized one is not reported as solved when the steps run out."""
    monkeypatch.setattr(factor_reuse, "MIN_PRECONDITIONED_SIZE", 0)
    A = random_positive(60, 3)
    own = _constrained(A, np.ones(60, dtype=bool), np.zeros(60))
    cache = factor_reuse.CachedFactorization(factorization.SuperLU(own.A.indptr, own.A.indices))
    cache.factorize(own)
    system = _constrained(A, np.zeros(60, dtype=bool), np.zeros(60), own)
    assert not cache.preconditions(system)
    load, u = np.ones(60), np.zeros(60)
    residual = load.copy()
    assert not cache.iterate(system, load, u, residual, 2)
    assert np.abs(A @ u - load).max() > 1e-3


def test_several_factors_of_a_matrix_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """Systems that alternate are factorized once each, the least recently used goes; another matrix drops them all."""
    n, none = 60, np.zeros(60)
    A = random_positive(n, 3)
    own = _constrained(A, none > 0, none)
    others = [_constrained(A, np.arange(n) % k == 0, none, own) for k in (2, 3)]
    analyze = partial(factorization.SuperLU, own.A.indptr, own.A.indices)
    cache = factor_reuse.CachedFactorization(analyze(), analyze)
    monkeypatch.setattr(factor_reuse, "MOST_KEPT_ROWS", 2 * n)

    def solve(system: factor_reuse.ConstrainedSystem) -> bool:
        known = cache.holds(system)
        if not known:
            cache.factorize(system, beside=True)
        load, u = np.ones(n), np.zeros(n)
        cache.iterate(system, load, u, load.copy(), 1)
        free = ~system.fixed
        np.testing.assert_allclose(u[free], np.linalg.solve(A[np.ix_(free, free)], np.ones(free.sum())), rtol=1e-9)
        return known

    assert [solve(each) for each in (own, others[0], own, others[0])] == [False, False, True, True]
    assert [solve(each) for each in (own, others[1], own, others[0])] == [True, False, True, False]
    cache.factorize(_constrained(2 * A, none > 0, none), beside=True)
    assert not any(cache.holds(each) for each in (own, *others))


def test_a_refused_matrix_leaves_no_factor(monkeypatch: pytest.MonkeyPatch) -> None:
    """After a matrix that is not positive definite the cache preconditions nothing."""
    monkeypatch.setattr(factor_reuse, "MIN_PRECONDITIONED_SIZE", 0)
    A = random_positive(20, 3)
    none = np.zeros(20, dtype=bool)
    own = _constrained(A, none, np.zeros(20))
    cache = factor_reuse.CachedFactorization(factorization.SuperLU(own.A.indptr, own.A.indices))
    cache.factorize(own)
    with pytest.raises(SingularMatrix):
        cache.factorize(_constrained(-A, none, np.zeros(20)))
    assert not cache.preconditions(own)
    assert not cache.holds(own)


@pytest.mark.slow
def test_another_number_of_threads_than_at_the_analysis() -> None:
    """PARDISO takes a matrix that it analysed on one number of threads on another one as well."""
    pardiso = solver("pardiso")
    n = 800
    A = csr_array(random_positive(n, seed=5))
    half = csr_array(triu(A))
    half.sort_indices()
    symbolic, b = pardiso(half.indptr.astype(np.int32), half.indices.astype(np.int32)), np.ones(n)
    try:
        for threads in (2, 1, 2):
            factorization.use_threads(pardiso, threads)
            assert factorization.threads(pardiso) == threads
            np.testing.assert_allclose(A @ symbolic.factor(half.data).solve(b), b, atol=1e-10)
    finally:
        factorization.use_threads(pardiso, 0)
