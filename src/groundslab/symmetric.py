"""A symmetric sparse matrix as a value: its upper half, row by row, the diagonal first in each row."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.shape import Array, Flags, Indices, Integers


@dataclass(frozen=True, slots=True, eq=False)
class Symmetric:
    """The upper half of a symmetric matrix as CSR; every row has its diagonal."""

    indptr: Indices  # (size + 1,)
    indices: Indices  # (entries,), ascending in each row
    data: Array  # (entries,)

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

    def part(self, numbers: Integers) -> Symmetric:
        """Return the matrix of some unknowns (k,) alone, given in ascending order."""
        part = self._upper()[numbers][:, numbers]
        part.sort_indices()
        return Symmetric(part.indptr, part.indices, part.data)
