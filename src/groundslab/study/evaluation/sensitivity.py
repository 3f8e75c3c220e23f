"""Sensitivity of outputs to inputs: Sobol indices of a Saltelli sample, tornado charts of one input at a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.study.evaluation.statistics import LEVEL, Estimate, half_width

if TYPE_CHECKING:
    from groundslab.arrays import Array

#: Bootstrap resamples for the intervals of the indices.
RESAMPLES = 1000


@dataclass(frozen=True, slots=True)
class SobolIndices:
    """Sobol indices of each input: share of the variance due to it alone, and including its interactions."""

    first: tuple[Estimate, ...]
    total: tuple[Estimate, ...]
    blocks: int  # rows of the base sample that were used: those with no variant missing
    of: int


def sobol_indices(A: Array, B: Array, AB: Array, seed: int, level: float = LEVEL) -> SobolIndices | None:
    """Return the indices of d inputs from outputs of a Saltelli sample: A and B (n,), AB (d, n); nan is missing.

    AB[i] is A with input i taken from B. First order: the mean of B (AB_i - A) over the variance; total: half the mean
    of (A - AB_i)^2 over it (Saltelli 2010, Table 2 b and f, the latter by Jansen 1999), of centered outputs. Intervals
    by bootstrapping the blocks (Archer, Saltelli and Sobol 1997). A block with a missing output is left out. None if
    fewer than two blocks are left or the output does not vary. (SciPy's function only takes numbers
    of blocks that are powers of 2, which missing variants do not leave.)
    """
    blocks = np.vstack([A, B, AB])
    used = blocks[:, np.isfinite(blocks).all(axis=0)]
    n = used.shape[1]
    if n < 2 or np.ptp(used[:2]) <= 1e-12 * np.abs(used).max():
        return None
    used = (used - used.mean()) / used.std()
    resample = np.random.default_rng(seed + 1).integers(n, size=(n, RESAMPLES))

    def estimate(y: Array) -> Array:
        """Return both indices (2, ...) of one input from its A, B and AB (3, n, ...)."""
        A, B, AB = y
        variances = np.stack([np.mean(B * (AB - A), axis=0), np.mean((A - AB) ** 2, axis=0) / 2])
        shares: Array = variances / np.var(np.concatenate([A, B]), axis=0)
        return shares

    indices: list[list[Estimate]] = [[], []]
    for mixed in used[2:]:
        y = np.stack([*used[:2], mixed])
        errors = estimate(y[:, resample]).std(axis=1, ddof=1)
        for estimates, value, error in zip(indices, estimate(y), errors, strict=True):
            half = half_width(level) * error
            estimates.append(Estimate(float(value), float(value - half), float(value + half)))
    return SobolIndices(tuple(indices[0]), tuple(indices[1]), n, blocks.shape[1])


@dataclass(frozen=True, slots=True)
class Swing:
    """An output with one input low and high, all others at their medians."""

    input: str
    low: float
    high: float


def tornado(y: Array, names: tuple[str, ...]) -> tuple[float, tuple[Swing, ...]]:
    """Return the output with all inputs at their medians, and its swings, the widest first.

    y (1 + 2 d,): the median variant, then for each input the variants with it low and high; nan is missing.
    """
    swings = [Swing(name, float(a), float(b)) for name, a, b in zip(names, y[1::2], y[2::2], strict=True)]
    # without one of its variants an input has no width
    width = {swing.input: np.nan_to_num(abs(swing.high - swing.low), posinf=0.0) for swing in swings}
    return float(y[0]), tuple(sorted(swings, key=lambda swing: -width[swing.input]))
