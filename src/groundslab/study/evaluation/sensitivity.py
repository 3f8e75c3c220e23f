"""Which input matters: Sobol indices from Saltelli's sample, tornado charts from two variants an input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.errors import InputError, Issue
from groundslab.study.evaluation.statistics import LEVEL, Estimate

if TYPE_CHECKING:
    from typing import Any

    from groundslab.arrays import Array

#: How often the sample is drawn anew from itself for the intervals of the indices.
RESAMPLES = 1000


@dataclass(frozen=True, slots=True)
class Indices:
    """Sobol's indices of each input: the share of the variance due to it alone, and with all that it acts with."""

    first: tuple[Estimate, ...]
    total: tuple[Estimate, ...]
    blocks: int  # of the base sample that were used: those with no variant missing
    of: int


def indices(A: Array, B: Array, AB: Array, seed: int, level: float = LEVEL) -> Indices | None:
    """Return the indices of d inputs from the outputs of Saltelli's sample: A and B (n,), AB (d, n); nan is missing.

    A and B are two independent samples, AB[i] is A with input i taken from B. First order: the mean of B (AB_i - A)
    over the variance; total: half the mean of (A - AB_i)^2 over it (Saltelli 2010, Table 2 b and f, the latter
    by Jansen 1999). Intervals from resampling the blocks (Archer, Saltelli and Sobol 1997). A block with a missing
    output is left out whole. None if fewer than two blocks are left or the output does not vary.
    """
    d = len(AB)
    # SALib's order: A, AB_1 ... AB_d, B of the first block, then of the next
    blocks = np.vstack([A, AB, B]).T
    used = blocks[np.isfinite(blocks).all(axis=1)]
    if len(used) < 2 or np.ptp(used[:, [0, -1]]) <= 1e-12 * np.abs(used).max():
        return None
    problem = {"num_vars": d, "names": [f"x{i}" for i in range(d)], "bounds": [[0.0, 1.0]] * d}
    found = _salib().analyze(
        problem,
        used.ravel(),
        calc_second_order=False,
        num_resamples=RESAMPLES,
        conf_level=level,
        seed=seed + 1,  # to SALib a seed of 0 is none
    )
    first, total = (
        tuple(
            Estimate(float(s), float(s - half), float(s + half))
            for s, half in zip(found[name], found[f"{name}_conf"], strict=True)
        )
        for name in ("S1", "ST")
    )
    return Indices(first, total, len(used), len(blocks))


@dataclass(frozen=True, slots=True)
class Swing:
    """What an output becomes with one input low and high, all others at their medians."""

    input: str
    low: float
    high: float


def tornado(y: Array, names: tuple[str, ...]) -> tuple[float, tuple[Swing, ...]]:
    """Return the output with all inputs at their medians, and its swings in the order of their width, widest first.

    y (1 + 2 d,): the median variant, then input after input the variant with it low and the one with it high; nan
    where one is missing.
    """
    low, high = y[1::2], y[2::2]
    swings = [Swing(name, float(a), float(b)) for name, a, b in zip(names, low, high, strict=True)]
    return float(y[0]), tuple(sorted(swings, key=lambda each: -_width(each)))


def _width(swing: Swing) -> float:
    """Return how far an output swings; one that is missing counts as nothing."""
    width = abs(swing.high - swing.low)
    return width if np.isfinite(width) else 0.0


def _salib() -> Any:
    """Return SALib's analysis by Sobol's method."""
    try:
        from SALib.analyze import sobol
    except ImportError:
        expected = "SALib, which evaluates Sobol's indices"
        hint = "pip install groundslab[study]"
        raise InputError([Issue("SALib", "nothing that can be imported", expected, hint)]) from None
    return sobol
