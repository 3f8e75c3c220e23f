"""Statistics of a sample, against closed forms and against how often the intervals hold the true value."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import optimize, special, stats

from groundslab.study.evaluation import field_maps, statistics


def coverage(make: object, truth: float, estimate: object, runs: int = 2000) -> float:
    """Return how often the interval of `estimate` holds the truth over many samples."""
    assert callable(make)
    assert callable(estimate)
    held = 0
    for seed in range(runs):
        found = estimate(make(np.random.default_rng(seed)))
        held += found.low <= truth <= found.high
    return held / runs


def test_mean_is_students_interval() -> None:
    """Mean and interval are those of SciPy's test of one sample; one sample alone has no finite interval."""
    x = np.array([3.0, 4.5, 4.0, 7.0, 1.5])
    found = statistics.mean(x, 0.9)
    wanted = stats.ttest_1samp(x, 0.0).confidence_interval(0.9)
    assert (found.value, found.low, found.high) == pytest.approx((4.0, wanted.low, wanted.high), rel=1e-12)
    assert statistics.mean(x[:1]) == statistics.Estimate(3.0, -np.inf, np.inf)


@pytest.mark.slow
def test_deviation_holds_the_true_one() -> None:
    """The interval holds the standard deviation of normal and of uniform samples about as often as it says."""
    normal = coverage(lambda rng: rng.normal(2.0, 3.0, 400), 3.0, statistics.deviation)
    uniform = coverage(lambda rng: rng.random(400), 1 / np.sqrt(12), statistics.deviation)
    # three standard errors of 2000 trials are 0.015
    assert normal == pytest.approx(0.95, abs=0.02)
    assert uniform == pytest.approx(0.95, abs=0.02)


def test_deviation_of_equal_and_of_few_samples() -> None:
    """Equal samples do not scatter; three samples have no finite interval."""
    assert statistics.deviation(np.full(9, 4.0)) == statistics.Estimate(0.0, 0.0, 0.0)
    few = statistics.deviation(np.array([1.0, 2.0, 3.0]))
    assert (few.value, few.low, few.high) == (1.0, 0.0, np.inf)


@pytest.mark.slow
@pytest.mark.parametrize("p", [0.05, 0.5, 0.95])
def test_percentile_holds_the_true_one(p: float) -> None:
    """The interval between order statistics holds the quantile at least as often as it says, whatever the density."""
    held = coverage(
        lambda rng: rng.lognormal(0.0, 1.0, 200), np.exp(stats.norm.ppf(p)), lambda x: statistics.percentile(x, p), 1000
    )
    assert 0.94 < held < 0.99


def test_percentile_is_the_tightest_of_its_kind() -> None:
    """The ends are the innermost order statistics whose binomial tails are small enough; too few samples have none."""
    x = np.arange(1.0, 101.0)
    found = statistics.percentile(x, 0.5)
    tail = lambda k: stats.binom.cdf(k, 100, 0.5)  # noqa: E731
    first = max(r for r in range(1, 101) if tail(r - 1) <= 0.025)
    assert (found.low, found.high) == (first, 101 - first)
    open_ended = statistics.percentile(x[:20], 0.95)
    assert open_ended.high == np.inf
    assert np.isfinite(open_ended.low)


@pytest.mark.parametrize(("count", "n"), [(0, 10), (1, 10), (5, 10), (10, 10), (3, 2000), (1990, 2000)])
def test_wilson_solves_its_equation(count: int, n: int) -> None:
    """Each end is a probability p at which count / n is just z standard deviations of p off (Wilson's equation)."""
    found, z = statistics.probability(count, n, 0.95), special.ndtri(0.975)

    def off(p: float) -> float:
        return abs(count / n - p) - z * np.sqrt(p * (1 - p) / n)

    low = 0.0 if count == 0 else optimize.brentq(off, 1e-15, count / n - 1e-12, xtol=1e-15)
    high = 1.0 if count == n else optimize.brentq(off, count / n + 1e-12, 1 - 1e-15, xtol=1e-15)
    assert (found.value, found.low, found.high) == pytest.approx((count / n, low, high), rel=1e-9, abs=1e-12)


def test_wilson_holds_the_true_one_about_as_often_as_it_says() -> None:
    """Over all outcomes of 50 trials the interval holds p with about its confidence, by the binomial sum itself."""
    counts = np.arange(51)
    _, low, high = statistics.wilson(counts, 50)
    for p in (0.1, 0.3, 0.5):
        held = stats.binom.pmf(counts, 50, p)[(low <= p) & (p <= high)].sum()
        assert 0.92 < held < 0.98
    assert statistics.probability(0, 0).low == 0.0
    assert np.isnan(statistics.probability(0, 0).value)


def test_exceedance_counts_what_lies_above() -> None:
    """At each sample stands the share of samples above it, equal samples counted once for all."""
    value, share, low, high = statistics.exceedance(np.array([3.0, 1.0, 2.0, 2.0]))
    assert value.tolist() == [1.0, 2.0, 2.0, 3.0]
    assert share.tolist() == [0.75, 0.25, 0.25, 0.0]
    assert np.all((low <= share) & (share <= high))
    assert statistics.exceedance(np.array([3.0, 1.0, 2.0, 2.0]), below=True)[1].tolist() == [0.0, 0.25, 0.25, 0.75]


def test_rank_correlation_is_spearmans() -> None:
    """Equal samples share ranks as SciPy's Spearman has it; a monotone function is perfectly correlated."""
    rng = np.random.default_rng(5)
    x = rng.integers(0, 12, 60).astype(float)
    y = x + rng.normal(0, 4, 60)
    assert statistics.rank_correlation(x, y).value == pytest.approx(stats.spearmanr(x, y).statistic, rel=1e-12)
    perfect = statistics.rank_correlation(x, np.exp(x))
    assert perfect.value == pytest.approx(1.0, rel=1e-12)
    assert perfect.low <= perfect.value <= perfect.high
    assert np.isnan(statistics.rank_correlation(x, np.ones(60)).value)
    assert statistics.correlation(x, y) == pytest.approx(stats.pearsonr(x, y).statistic, rel=1e-12)


@pytest.mark.slow
def test_interval_of_the_rank_correlation_holds_the_true_one() -> None:
    """For normal samples of correlation r the true rank correlation is 6/pi asin(r/2); the interval holds it."""
    r = 0.6
    truth = 6 / np.pi * np.arcsin(r / 2)

    def pairs(rng: np.random.Generator) -> np.ndarray:
        x = rng.normal(size=(100, 2))
        return np.column_stack([x[:, 0], r * x[:, 0] + np.sqrt(1 - r * r) * x[:, 1]])

    held = coverage(pairs, truth, lambda x: statistics.rank_correlation(x[:, 0], x[:, 1]))
    assert held == pytest.approx(0.95, abs=0.02)


def test_maps_are_numpys() -> None:
    """Mean, standard deviation and shares at the nodes, read field by field, are those of the whole array."""
    fields = np.random.default_rng(3).normal(0.2, 1.0, (57, 11)) + 1e3 * np.arange(11) * (np.arange(11) > 8)
    found = field_maps.moments(iter(fields))
    assert found is not None
    assert found.n == 57
    assert found.mean == pytest.approx(fields.mean(axis=0), rel=1e-13)
    assert found.deviation == pytest.approx(fields.std(axis=0, ddof=1), rel=1e-10)
    below = np.where(fields < -1e-9 * np.abs(fields).max(axis=1, keepdims=True), 1.0, 0.0)
    assert found.below_zero == pytest.approx(below.mean(axis=0), rel=1e-13)
    assert field_maps.moments(iter(())) is None


def test_rounding_is_no_uplift() -> None:
    """A settlement that is negative by rounding only does not count as lifted."""
    assert field_maps.find_uplift(np.array([1.0, -1e-12, -1e-6])).tolist() == [False, False, True]
