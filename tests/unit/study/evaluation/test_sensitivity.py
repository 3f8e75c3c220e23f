"""Sobol indices and tornado charts against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.study.evaluation import sensitivity


def ishigami(x: np.ndarray, a: float = 7.0, b: float = 0.1) -> np.ndarray:
    """Return the function of Ishigami and Homma (1990) at points (n, 3) of [-pi, pi]^3."""
    return np.sin(x[:, 0]) + a * np.sin(x[:, 1]) ** 2 + b * x[:, 2] ** 4 * np.sin(x[:, 0])


def exact_indices(a: float = 7.0, b: float = 0.1) -> tuple[np.ndarray, np.ndarray]:
    """Return first-order and total indices of the function: its variances are integrals that can be done by hand.

    With V1 = (1 + b pi^4 / 5)^2 / 2, V2 = a^2 / 8, V13 = 8 b^2 pi^8 / 225, and no others.
    """
    V1, V2, V13 = (1 + b * np.pi**4 / 5) ** 2 / 2, a**2 / 8, 8 * b**2 * np.pi**8 / 225
    V = V1 + V2 + V13
    return np.array([V1, V2, 0.0]) / V, np.array([V1 + V13, V2, V13]) / V


def test_exact_indices_are_those_of_the_function() -> None:
    """The variances by hand are those of the function, integrated by Gauss points in three directions."""
    at, weight = np.polynomial.legendre.leggauss(40)
    grid = np.stack(np.meshgrid(*[np.pi * at] * 3, indexing="ij"), axis=-1)
    y = ishigami(grid.reshape(-1, 3)).reshape(40, 40, 40)
    weight = weight / 2
    mean = np.einsum("ijk,i,j,k", y, weight, weight, weight)
    V = np.einsum("ijk,i,j,k", y**2, weight, weight, weight) - mean**2
    first, total = exact_indices()
    for axis in range(3):
        other = [each for each in range(3) if each != axis]
        along = np.einsum(y, [0, 1, 2], weight, [other[0]], weight, [other[1]], [axis])
        assert (weight @ along**2 - mean**2) / V == pytest.approx(first[axis], abs=1e-10)
        rest = np.einsum(y, [0, 1, 2], weight, [axis], other)
        assert 1 - (np.einsum("ij,i,j", rest**2, weight, weight) - mean**2) / V == pytest.approx(total[axis], abs=1e-10)


def sampled(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return A, B (n,) and AB (3, n) of Ishigami's function over scrambled Sobol points."""
    from scipy.stats import qmc

    points = np.pi * (2 * qmc.Sobol(6, scramble=True, rng=np.random.default_rng(seed)).random(count) - 1)
    A, B = points[:, :3], points[:, 3:]
    AB = [np.where(np.arange(3) == i, B, A) for i in range(3)]
    return ishigami(A), ishigami(B), np.array([ishigami(each) for each in AB])


@pytest.mark.slow
def test_indices_of_ishigamis_function() -> None:
    """Both indices of all inputs come out, and each interval holds the exact one."""
    found = sensitivity.sobol_indices(*sampled(2048, 3), seed=3)
    assert found is not None
    assert (found.blocks, found.of) == (2048, 2048)
    first, total = exact_indices()
    assert [each.value for each in found.first] == pytest.approx(first, abs=0.02)
    assert [each.value for each in found.total] == pytest.approx(total, abs=0.02)
    for estimates, exact in ((found.first, first), (found.total, total)):
        for each, value in zip(estimates, exact, strict=True):
            assert each.low <= value <= each.high
            assert each.high - each.low < 0.2


def test_intervals_repeat_with_the_seed() -> None:
    """The intervals depend on the seed alone, also on a seed of zero."""
    y = sampled(64, 0)
    assert sensitivity.sobol_indices(*y, seed=0) == sensitivity.sobol_indices(*y, seed=0)
    assert sensitivity.sobol_indices(*y, seed=0) != sensitivity.sobol_indices(*y, seed=1)


def test_blocks_with_a_missing_variant_are_left_out() -> None:
    """One missing output takes its block away and leaves the others' indices what they are."""
    A, B, AB = sampled(64, 2)
    hurt = AB.copy()
    hurt[1, 17] = np.nan
    found = sensitivity.sobol_indices(A, B, hurt, seed=1)
    wanted = sensitivity.sobol_indices(np.delete(A, 17), np.delete(B, 17), np.delete(AB, 17, axis=1), seed=1)
    assert found is not None
    assert wanted is not None
    assert (found.blocks, found.of) == (63, 64)
    assert (found.first, found.total) == (wanted.first, wanted.total)


def test_no_indices_where_nothing_varies() -> None:
    """An output that is the same everywhere, and one that is missing everywhere, have no indices."""
    for value in (3.0, np.nan):
        assert sensitivity.sobol_indices(np.full(8, value), np.full(8, value), np.full((3, 8), value), seed=1) is None


def test_tornado_orders_by_width() -> None:
    """Swings come widest first with their signs; one that is missing stands last."""
    y = np.array([10.0, 9.0, 12.0, 30.0, 5.0, np.nan, 4.0])
    base, swings = sensitivity.tornado(y, ("a", "b", "c"))
    assert base == 10.0
    assert [(each.input, each.low, each.high) for each in swings[:2]] == [("b", 30.0, 5.0), ("a", 9.0, 12.0)]
    assert swings[2].input == "c"
