"""Statistics of a sample: means, percentiles, probabilities and correlations, each with a confidence interval.

All intervals are for independent samples. A Latin hypercube or a Sobol sequence spreads its samples more evenly: there
the intervals are, as a rule, too wide (docs/study-results.md).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers

#: Default confidence of intervals.
LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class Estimate:
    """A value and its confidence interval; an end may be infinite."""

    value: float
    low: float
    high: float


def half_width(level: float) -> float:
    """Return the half-width of a standard normal's central interval: 1.96 for a level of 0.95."""
    from scipy.special import ndtri

    return float(ndtri(0.5 + level / 2))


def mean(x: Array, level: float = LEVEL) -> Estimate:
    """Return the mean of samples (n,) and Student's interval, which is exact for normal samples (Student 1908)."""
    from scipy.special import stdtrit

    n, value = len(x), float(np.mean(x))
    if n < 2:
        return Estimate(value, -np.inf, np.inf)
    half = float(stdtrit(n - 1, 0.5 + level / 2)) * float(np.std(x, ddof=1)) / np.sqrt(n)
    return Estimate(value, value - half, value + half)


def deviation(x: Array, level: float = LEVEL) -> Estimate:
    """Return the standard deviation of samples (n,) and its interval for many samples of any distribution.

    The variance of s^2 is (m4 - s^4 (n - 3) / (n - 1)) / n with the fourth central moment m4 (Cramer 1946, 27.4); that
    of s is a (2 s)^2-th of it.
    """
    n = len(x)
    if n < 4:
        return Estimate(float(np.std(x, ddof=1)) if n > 1 else np.nan, 0.0, np.inf)
    s = float(np.std(x, ddof=1))
    if s == 0.0:
        return Estimate(0.0, 0.0, 0.0)
    m4 = float(np.mean((x - np.mean(x)) ** 4))
    half = half_width(level) * float(np.sqrt(max(m4 - s**4 * (n - 3) / (n - 1), 0.0) / n)) / (2 * s)
    return Estimate(s, max(s - half, 0.0), s + half)


def percentile(x: Array, p: float, level: float = LEVEL) -> Estimate:
    """Return the p-quantile of samples (n,), 0 < p < 1, and the interval between two of the ordered samples.

    The number of samples below the true quantile is binomial, whatever the distribution, so that two order statistics
    enclose it with the given confidence (David and Nagaraja 2003, 7.1). Where the samples are too few for an end, it is
    infinite.
    """
    from scipy.special import bdtr, bdtrc

    tail, counts = (1 - level) / 2, np.arange(len(x))
    ordered = np.concatenate([[-np.inf], np.sort(x), [np.inf]])
    first = np.count_nonzero(bdtr(counts, len(x), p) < tail)
    last = np.count_nonzero(bdtrc(counts, len(x), p) > tail) + 1
    return Estimate(float(np.quantile(x, p)), float(ordered[first]), float(ordered[last]))


def probability(count: int, n: int, level: float = LEVEL) -> Estimate:
    """Return the probability of what happened count times in n samples, with the interval of Wilson 1927."""
    value, low, high = wilson(np.array([count]), n, level)
    return Estimate(float(value[0]), float(low[0]), float(high[0]))


def wilson(count: Integers, n: int, level: float = LEVEL) -> tuple[Array, Array, Array]:
    """Return count / n and the score intervals' ends, each (k,), of counts (k,) out of n (Wilson 1927).

    The ends are the probabilities p with |count / n - p| = z sqrt(p (1 - p) / n). SciPy has it for one count only.
    """
    if n == 0:
        unknown = np.full(len(count), np.nan)
        return unknown, np.zeros(len(count)), np.ones(len(count))
    z2 = half_width(level) ** 2
    value = count / n
    center = (value + z2 / (2 * n)) / (1 + z2 / n)
    half = np.sqrt(z2 * (value * (1 - value) / n + z2 / (4 * n**2))) / (1 + z2 / n)
    # both ends are exact where the count is 0 or n, without rounding
    return value, np.where(count == 0, 0.0, center - half), np.where(count == n, 1.0, center + half)


def exceedance(x: Array, level: float = LEVEL, *, below: bool = False) -> tuple[Array, Array, Array, Array]:
    """Return the samples (n,) in rising order, the share of samples above each, and the ends of its interval.

    The share below each instead if low values are the bad ones. The interval is that of Wilson 1927 at each value by
    itself, not for the curve as a whole.
    """
    from scipy.stats import rankdata

    n, ordered = len(x), np.sort(x)
    beyond = rankdata(ordered, "min") - 1 if below else n - rankdata(ordered, "max")
    return ordered, *wilson(beyond, n, level)


def correlation(x: Array, y: Array) -> float:
    """Return Pearson's correlation coefficient of samples (n,); nan where one of them does not vary."""
    if len(x) < 2 or np.ptp(x) == 0.0 or np.ptp(y) == 0.0:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def rank_correlation(x: Array, y: Array, level: float = LEVEL) -> Estimate:
    """Return Spearman's correlation coefficient of samples (n,) and its interval.

    Fisher's transformation atanh(r) is taken as normal with variance (1 + r^2 / 2) / (n - 3) (Bonett and Wright 2000).
    """
    from scipy.stats import rankdata

    r, n = correlation(rankdata(x), rankdata(y)), len(x)
    if not np.isfinite(r) or n < 4:
        return Estimate(r, -1.0, 1.0)
    half = half_width(level) * np.sqrt((1 + r * r / 2) / (n - 3))
    z = np.arctanh(np.clip(r, -1 + 1e-15, 1 - 1e-15))
    # a perfect correlation is not rounded out of its own interval
    return Estimate(r, min(r, float(np.tanh(z - half))), max(r, float(np.tanh(z + half))))
