"""Statistics of nodal fields over all variants: mean, standard deviation, probabilities."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags

#: A settlement this small relative to the variant's largest is rounding, not uplift.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Moments:
    """Mean and standard deviation at each node, (k,), over n variants; how many lifted off there."""

    n: int
    mean: Array
    deviation: Array
    below_zero: Array  # share of the variants with a value below zero


def moments(fields: Iterable[Array]) -> Moments | None:
    """Return mean, standard deviation and share below zero of fields (k,), read once; None if there are none.

    The sums are updated field by field (Welford 1962), so that no more than one field is in memory.
    """
    n = 0
    mean = squares = below = np.zeros(0)
    for field in fields:
        if n == 0:
            mean, squares, below = (np.zeros(len(field)) for _ in range(3))
        n += 1
        change = field - mean
        mean += change / n
        squares += change * (field - mean)
        below += find_uplift(field)
    if n == 0:
        return None
    return Moments(n, mean, np.sqrt(squares / max(n - 1, 1)), below / n)


def find_uplift(field: Array) -> Flags:
    """Return where a field (k,) is negative by more than rounding: for a settlement, where the plate lifts."""
    lifts: Flags = field < -ROUNDING * np.abs(field).max(initial=0.0)
    return lifts
