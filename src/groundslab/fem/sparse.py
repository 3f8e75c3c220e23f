"""A symmetric sparse matrix as a value: its upper half, row by row, the diagonal first in each row."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.arrays import Array, Flags, Indices, Integers


@dataclass(frozen=True, slots=True, eq=False)
class Symmetric:
    """The upper half of a symmetric matrix as CSR; every row has its diagonal."""

    indptr: Indices  # (size + 1,)
    indices: Indices  # (entries,), ascending in each row
    data: Array  # (entries,)
    #: Orthonormal vectors (size, m) and what the matrix makes of them (size, m), known better than the entries tell:
    #: sums of large entries that nearly cancel.
    known: tuple[Array, Array] | None = None

    @property
    def size(self) -> int:
        """Return the number of rows."""
        return len(self.indptr) - 1

    @property
    def diagonal(self) -> Array:
        """Return the diagonal (size,)."""
        d: Array = self.data[self.indptr[:-1]]
        return d

    def __matmul__(self, u: Array) -> Array:
        """Return the product with u (size,)."""
        if self.known is not None:
            Q, AQ = self.known
            share = Q.T @ u
            return self._times(u - Q @ share) + AQ @ share
        return self._times(u)

    def _times(self, u: Array) -> Array:
        upper = self._upper()
        product: Array = upper @ u + upper.T @ u - self.diagonal * u
        return product

    def _upper(self) -> Any:
        from scipy.sparse import csr_array

        return csr_array((self.data, self.indices, self.indptr), shape=(self.size, self.size))

    def held(self, at: Flags, added: Array) -> Array:
        """Return the entries (entries,) with `added` (size,) on the diagonal, and unknowns (size,) held.

        Rows and columns of held unknowns are zero beside the diagonal, which stays as it was.
        """
        data = self.data.copy()
        if at.any():
            gone = at[self.indices]
            gone |= np.repeat(at, np.diff(self.indptr))
            data[gone] = 0.0
        data[self.indptr[:-1]] = self.diagonal + np.where(at, 0.0, added)
        return data

    def rows(self, numbers: Integers) -> Any:
        """Return whole rows (k, size) of some unknowns (k,), as a sparse array."""
        from scipy.sparse import csr_array

        k = len(numbers)
        number = np.full(self.size, -1)
        number[numbers] = np.arange(k)
        right = self._upper()[numbers].tocoo()
        # what lies left of the diagonal stands in the columns of the upper half
        at = np.flatnonzero(number[self.indices] >= 0)
        row = np.searchsorted(self.indptr, at, side="right") - 1
        own = number[self.indices[at]]
        left = numbers[own] != row
        at, row, own = at[left], row[left], own[left]
        entries = np.concatenate([right.data, self.data[at]])
        places = np.concatenate([right.coords[0], own]), np.concatenate([right.coords[1], row])
        return csr_array((entries, places), shape=(k, self.size))

    def part(self, numbers: Integers) -> Symmetric:
        """Return the matrix of some unknowns (k,) alone, given in ascending order."""
        part = self._upper()[numbers][:, numbers]
        part.sort_indices()
        return Symmetric(part.indptr, part.indices, part.data)
