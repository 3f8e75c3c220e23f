"""Interface of direct solvers: analysis of a pattern, factors of matrices with that pattern, solutions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from groundslab.arrays import Array, Indices


class Factor(Protocol):
    """A factorized matrix."""

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k)."""
        ...


class Symbolic(Protocol):
    """An analyzed pattern, which factorizes any matrix with that pattern. Only the latest factor is valid."""

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries; raise SingularMatrix if there is none."""
        ...


#: Takes indptr and indices of the upper half and returns the analyzed pattern.
Solver = Callable[[Indices, Indices], Symbolic]
