"""What a direct solver offers: an analysis of the pattern, factors of matrices with it, solutions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from groundslab.arrays import Array, Indices


class Factor(Protocol):
    """A factorised matrix."""

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k)."""
        ...


class Symbolic(Protocol):
    """A pattern that has been analysed; factorises any matrix with that pattern. The latest factor alone is valid."""

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries; raise SingularMatrix if not positive."""
        ...


#: From indptr and indices of the upper half to its analysis.
Solver = Callable[[Indices, Indices], Symbolic]
