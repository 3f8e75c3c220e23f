"""Forces between bounds against an independent oracle: every set of forces at bounds is tried, one fulfills all."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.errors import NoEquilibrium, NotConverged
from groundslab.solvers import bounded_forces
from groundslab.solvers.bounded_forces import BoundedForces, BoundedSolution, balance, solve

N = 6


def _pose(A: Array, c: Array, G: Array, e: Array, lower: Array, upper: Array, M: Array | None = None) -> BoundedForces:
    """Return the problem of a dense matrix A, preconditioned by M, the inverse of its diagonal by default."""
    inverse = np.diag(1 / np.diag(A)) if M is None else M

    def gaps(x: Array) -> tuple[Array, Array]:
        return A @ x + c, np.full(len(c), np.abs(A @ x).max())

    return BoundedForces(
        gaps, lambda q: A @ q, lambda r: inverse @ r, G, e, lower, upper, np.ones(len(c)), np.diag(A).copy()
    )


def _solve(p: BoundedForces, start: Array, tolerance: float = 1e-10, limit: int = 2000) -> BoundedSolution:
    """Return the solution of a problem."""
    return solve(p, start, tolerance, limit, lambda *_: None)


def _try_all(A: Array, c: Array, G: Array, e: Array, lower: Array, upper: Array) -> Array:
    """Return the forces (n,) that fulfill all conditions, found by trying every set of forces at bounds."""
    n, r = len(c), len(e)
    found, least = None, np.inf
    for state in product((-1, 0, 1), repeat=n):
        at = np.array(state)
        x = np.where(at < 0, lower, np.where(at > 0, upper, 0.0))
        if not np.isfinite(x).all():
            continue
        free = at == 0
        k = int(free.sum())
        matrix = np.zeros((k + r, k + r))
        matrix[:k, :k], matrix[:k, k:], matrix[k:, :k] = A[np.ix_(free, free)], G[:, free].T, G[:, free]
        right = np.concatenate([-(c + A @ x)[free], e - G @ x])
        solved = np.linalg.lstsq(matrix, right, rcond=None)[0]
        x[free] = solved[:k]
        if (x < lower - 1e-9).any() or (x > upper + 1e-9).any() or np.abs(G @ x - e).max(initial=0.0) > 1e-9:
            continue
        energy = float(x @ A @ x / 2 + c @ x)
        if energy < least:
            found, least = x, energy
    assert found is not None
    return found


def _random(seed: int, r: int, n: int = N) -> dict[str, Array]:
    """Return a random problem with bounds of all kinds, and resultants of forces within them."""
    rng = np.random.default_rng(seed)
    root = rng.standard_normal((n, n)) * 10 ** rng.uniform(-1, 1, n)
    lower = np.where(rng.random(n) < 0.2, -np.inf, 0.0)
    upper = np.choose(rng.integers(0, 3, n), [np.full(n, np.inf), rng.uniform(0.1, 1.0, n), np.where(lower == 0, 0, 9)])
    G = np.vstack([np.ones(n), rng.standard_normal((2, n))])[:r]
    within = np.maximum(lower, 0) + rng.uniform(0.1, 0.9, n) * np.minimum(upper, 1)
    return {
        "A": root @ root.T + 0.01 * np.eye(n), "c": rng.standard_normal(n), "G": G, "e": G @ within,
        "lower": lower, "upper": upper,
    }  # fmt: skip


@pytest.mark.parametrize("r", [0, 1, 3])
@pytest.mark.parametrize("seed", range(8))
def test_random_problems_have_the_solution_found_by_trying_every_set(seed: int, r: int) -> None:
    """Whatever the bounds and the start: the same forces as by brute force."""
    data = _random(seed, r)
    expected = _try_all(**data)
    for start in (np.zeros(N), np.full(N, 100.0), np.random.default_rng(seed).standard_normal(N)):
        found = _solve(_pose(**data), start)
        np.testing.assert_allclose(found.x, expected, atol=1e-7 * max(1.0, float(np.abs(expected).max())))


@pytest.mark.parametrize("patience", [-1, 0, 1])
def test_forces_that_are_led_downhill_reach_the_same(patience: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """What guards against sets that go round in circles converges by itself."""
    monkeypatch.setattr(bounded_forces, "PATIENCE", patience)
    for seed in range(8):
        data = _random(seed, 3)
        expected = _try_all(**data)
        found = _solve(_pose(**data), np.zeros(N))
        np.testing.assert_allclose(found.x, expected, atol=1e-7 * max(1.0, float(np.abs(expected).max())))


@pytest.mark.parametrize("factor", [0.3, 1.0, 3.0, 1e3])
def test_an_approximate_matrix_changes_the_way_alone(factor: float) -> None:
    """Whether it is good, poor or useless: the same forces."""
    for seed in range(8):
        data = _random(seed, 3)
        rough = factor * data["A"] + 0.1 * np.diag(np.diag(data["A"]))
        p = replace(_pose(**data), approximate=lambda q, rough=rough: rough @ q)
        expected = _try_all(**data)
        np.testing.assert_allclose(
            _solve(p, np.zeros(N)).x, expected, atol=1e-7 * max(1.0, float(np.abs(expected).max()))
        )


def test_a_good_approximate_matrix_saves_products() -> None:
    """With a matrix that is right to a thousandth some products of the other are enough."""
    data = _beam(60, 1e-4)
    p = _pose(**data)
    near = data["A"] + 1e-3 * np.diag(np.diag(data["A"]))
    few = _solve(replace(p, approximate=lambda q: near @ q), np.ones(60), 1e-8)
    many = _solve(p, np.ones(60), 1e-8)
    assert few.products < 10 < many.products
    np.testing.assert_allclose(few.x, many.x, atol=1e-6)


def test_downhill_the_energy_falls() -> None:
    """Towards worse forces nothing is lost, and along the projected gradient the energy falls unless it is least."""
    for seed in range(8):
        data = _random(seed, 3)
        p = _pose(**data)
        x, other = balance(p, np.zeros(N), p.can_change), balance(p, np.full(N, 5.0), p.can_change)

        def energy(x: Array, data: dict[str, Array] = data) -> float:
            return float(x @ data["A"] @ x / 2 + data["c"] @ x)

        after, g, _ = bounded_forces.descend(p, x, p.gaps(x)[0], other, p.gaps(other)[0])
        np.testing.assert_allclose(g, p.gaps(after)[0], atol=1e-9 * np.abs(g).max())
        np.testing.assert_allclose(data["G"] @ after, data["e"], atol=1e-9)
        least = energy(_try_all(**data))
        assert energy(after) < min(energy(x), energy(other)) or energy(x) == pytest.approx(least, abs=1e-9)


def test_balanced_forces_are_the_nearest() -> None:
    """They are those of the quadratic problem whose matrix is the inverse of the weights, by brute force."""
    for seed in range(8):
        data = _random(seed, 2)
        weight = np.random.default_rng(seed).uniform(0.5, 2.0, N)
        p, x = _pose(**data), np.random.default_rng(seed).standard_normal(N)
        nearest = _try_all(np.diag(1 / weight), -x / weight, data["G"], data["e"], data["lower"], data["upper"])
        np.testing.assert_allclose(balance(p, x, p.can_change, weight), nearest, atol=1e-8)


def test_forces_that_cannot_balance_are_refused() -> None:
    """Bounds that leave no forces of a given sum are an error, not a result."""
    p = _pose(np.eye(3), np.zeros(3), np.ones((1, 3)), np.array([4.0]), np.zeros(3), np.ones(3))
    with pytest.raises(NoEquilibrium, match="cannot balance"):
        _solve(p, np.zeros(3))


def test_forces_at_all_upper_bounds() -> None:
    """Where the given sum is that of the upper bounds nothing is free."""
    p = _pose(np.eye(3), np.array([0.0, 1.0, 2.0]), np.ones((1, 3)), np.array([3.0]), np.zeros(3), np.ones(3))
    found = _solve(p, np.zeros(3))
    np.testing.assert_allclose(found.x, 1.0, rtol=1e-11)


def test_open_gaps_carry_nothing() -> None:
    """Where nothing touches no force arises, and one product tells it."""
    p = _pose(np.eye(4), np.ones(4), np.zeros((0, 4)), np.zeros(0), np.zeros(4), np.full(4, np.inf))
    found = _solve(p, np.zeros(4))
    assert not found.x.any()
    assert found.products == 1


def test_given_forces_stay() -> None:
    """A force whose bounds are equal keeps it, whatever its gap."""
    p = _pose(np.eye(3), np.array([-9.0, -1.0, 0.5]), np.zeros((0, 3)), np.zeros(0),
              np.zeros(3), np.array([0.0, 9.0, 9.0]))  # fmt: skip
    np.testing.assert_allclose(_solve(p, np.ones(3)).x, [0.0, 1.0, 0.0], atol=1e-9)


def test_forces_on_a_line_alone() -> None:
    """Free forces that leave a rotation undetermined: of 9 on a square plate only the middle column is pressed."""
    x, y = (each.ravel() for each in np.meshgrid([-1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], indexing="ij"))
    gap = np.where(x == 0, 0.0, 1.0)
    G = np.vstack([np.ones(9), x, y])
    p = _pose(np.eye(9), gap, G, np.array([0.6, 0.0, 0.0]), np.zeros(9), np.full(9, np.inf))
    np.testing.assert_allclose(_solve(p, np.ones(9)).x, np.where(x == 0, 0.2, 0.0), atol=1e-9)


def test_an_iteration_cut_short_is_an_error() -> None:
    """It tells its history and leaves forces between bounds."""
    data = _random(1, 1, 40)
    with pytest.raises(NotConverged) as error:
        _solve(_pose(**data), np.zeros(40), limit=4)
    assert error.value.history[-1]["products"] <= 5
    x = error.value.last["x"]
    assert ((x >= data["lower"]) & (x <= data["upper"])).all()


def _beam(n: int, stiffness: float) -> dict[str, Any]:
    """Return a beam that lies on a Winkler ground tensionless, under a force at a third: forces of n springs."""
    x = np.linspace(0, 1, n)
    distance = np.abs(x[:, None] - x)
    bent = distance**3 / 12 / stiffness
    G = np.vstack([np.ones(n), x])
    planes = np.linalg.qr(G.T)[0]
    onto = np.eye(n) - planes @ planes.T
    P = 1.0
    load = np.abs(x - 1 / 3) ** 3 / 12 / stiffness
    return {
        "A": np.eye(n) * n + onto @ bent @ onto, "c": -P * onto @ load, "G": G, "e": np.array([P, P / 3]),
        "lower": np.zeros(n), "upper": np.full(n, np.inf),
    }  # fmt: skip


@pytest.mark.parametrize("stiffness", [1e-2, 1e-4, 1e-6])
def test_beam_that_lifts_off(stiffness: float) -> None:
    """Slender beams, whose flexibilities differ by orders, under few conditions that are checked by themselves."""
    data = _beam(60, stiffness)
    found = _solve(_pose(**data), np.ones(60), 1e-9)
    y = data["A"] @ found.x + data["c"] + data["G"].T @ found.alpha
    size = np.abs(data["A"] @ found.x).max()
    np.testing.assert_allclose(data["G"] @ found.x, data["e"], rtol=1e-10)
    assert (found.x >= 0).all()
    assert (y >= -2e-9 * size).all()
    assert np.abs(y[found.x > 0]).max() <= 2e-9 * size
    assert (found.x == 0).any() == (stiffness < 1e-2)
