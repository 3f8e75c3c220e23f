"""What a sample tells: means, percentiles, probabilities and correlations, each with an interval of confidence.

All intervals are for independent samples. A Latin hypercube or a Sobol sequence spreads its samples more evenly: there
the intervals are, as a rule, too wide (docs/study-results.md).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers

#: The confidence of intervals, unless another one is asked for.
LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class Estimate:
    """A figure and the interval that holds the true one with a given confidence; an end may be infinite."""

    value: float
    low: float
    high: float

    def times(self, scale: float) -> Estimate:
        """Return the estimate in another unit; scale is positive."""
        return Estimate(self.value * scale, self.low * scale, self.high * scale)


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
    from scipy.special import ndtri

    n = len(x)
    if n < 4:
        return Estimate(float(np.std(x, ddof=1)) if n > 1 else np.nan, 0.0, np.inf)
    s = float(np.std(x, ddof=1))
    if s == 0.0:
        return Estimate(0.0, 0.0, 0.0)
    m4 = float(np.mean((x - np.mean(x)) ** 4))
    error = np.sqrt(max(m4 - s**4 * (n - 3) / (n - 1), 0.0) / n) / (2 * s)
    half = float(ndtri(0.5 + level / 2)) * float(error)
    return Estimate(s, max(s - half, 0.0), s + half)


def percentile(x: Array, p: float, level: float = LEVEL) -> Estimate:
    """Return the p-quantile of samples (n,), 0 < p < 1, and the interval between two of the ordered samples.

    Whatever the distribution, the number of samples below the true quantile is binomial, so that two order statistics
    hold it with the confidence asked for (David and Nagaraja 2003, 7.1). The samples may be too few for an end.
    """
    from scipy.special import bdtr

    n, ordered = len(x), np.sort(x)
    below = bdtr(np.arange(n + 1.0), n, p)  # of k = 0 ... n
    outside = (1 - level) / 2
    # P(B < first) <= outside and P(B > last) <= outside
    first = int(np.searchsorted(below, outside, side="right"))
    last = int(np.searchsorted(below, 1 - outside, side="left"))
    low = float(ordered[first - 1]) if first >= 1 else -np.inf
    high = float(ordered[last]) if last < n else np.inf
    return Estimate(float(np.quantile(x, p)), low, high)


def probability(count: int, n: int, level: float = LEVEL) -> Estimate:
    """Return the probability of what happened count times in n samples, with the interval of Wilson 1927."""
    value, low, high = wilson(np.array([count]), n, level)
    return Estimate(float(value[0]), float(low[0]), float(high[0]))


def wilson(count: Integers, n: int, level: float = LEVEL) -> tuple[Array, Array, Array]:
    """Return count / n and the score intervals' ends, each (k,), of counts (k,) out of n (Wilson 1927).

    The ends are the probabilities p with |count / n - p| = z sqrt(p (1 - p) / n).
    """
    from scipy.special import ndtri

    if n == 0:
        unknown = np.full(len(count), np.nan)
        return unknown, np.zeros(len(count)), np.ones(len(count))
    z2 = float(ndtri(0.5 + level / 2)) ** 2
    value = count / n
    middle = (value + z2 / (2 * n)) / (1 + z2 / n)
    half = np.sqrt(z2 * (value * (1 - value) / n + z2 / (4 * n**2))) / (1 + z2 / n)
    # both ends are exact where the count is 0 or n, without rounding
    low = np.where(count == 0, 0.0, middle - half)
    high = np.where(count == n, 1.0, middle + half)
    return value, low, high


def exceedance(x: Array, level: float = LEVEL, *, below: bool = False) -> tuple[Array, Array, Array, Array]:
    """Return the samples (n,) in rising order, the share of samples above each, and the ends of its interval.

    The share below each instead if low values are the bad ones. The interval is that of Wilson 1927 at each value by
    itself, not for the curve as a whole.
    """
    n, ordered = len(x), np.sort(x)
    if below:
        beyond = np.searchsorted(ordered, ordered, side="left")
    else:
        beyond = n - np.searchsorted(ordered, ordered, side="right")
    return ordered, *wilson(beyond, n, level)


def ranks(x: Array) -> Array:
    """Return the ranks (n,) of samples (n,) from 1; equal samples share the mean of theirs."""
    from scipy.stats import rankdata

    found: Array = rankdata(x)
    return found


def correlation(x: Array, y: Array) -> float:
    """Return Pearson's coefficient of correlation of samples (n,); nan where one of them does not vary."""
    if len(x) < 2 or np.ptp(x) == 0.0 or np.ptp(y) == 0.0:
        return float("nan")
    return float(np.corrcoef(x, y)[0, 1])


def rank_correlation(x: Array, y: Array, level: float = LEVEL) -> Estimate:
    """Return Spearman's coefficient of correlation of samples (n,) and its interval.

    Fisher's transformation atanh(r) is taken as normal with variance (1 + r^2 / 2) / (n - 3) (Bonett and Wright 2000).
    """
    from scipy.special import ndtri

    r, n = correlation(ranks(x), ranks(y)), len(x)
    if not np.isfinite(r) or n < 4:
        return Estimate(r, -1.0, 1.0)
    half = float(ndtri(0.5 + level / 2)) * np.sqrt((1 + r * r / 2) / (n - 3))
    z = np.arctanh(np.clip(r, -1 + 1e-15, 1 - 1e-15))
    # a perfect correlation is not rounded out of its own interval
    return Estimate(r, min(r, float(np.tanh(z - half))), max(r, float(np.tanh(z + half))))
