"""Symmetric sparse matrices, stored as their upper half."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.arrays import Array, Flags, Indices, Integers


@dataclass(frozen=True, slots=True, eq=False)
class Symmetric:
    """The upper half of a symmetric matrix in CSR format; every row stores its diagonal."""

    indptr: Indices  # (size + 1,)
    indices: Indices  # (entries,), ascending in each row
    data: Array  # (entries,)
    #: Orthonormal vectors (size, m) and their products with the matrix (size, m), more exact than the entries give,
    #: where sums of large entries nearly cancel.
    exact_products: tuple[Array, Array] | None = None

    @property
    def size(self) -> int:
        """Return the number of rows."""
        return len(self.indptr) - 1

    @property
    def diagonal(self) -> Array:
        """Return the diagonal (size,)."""
        return self.data[self.indptr[:-1]]

    def __matmul__(self, u: Array) -> Array:
        """Return the product with u (size,)."""
        if self.exact_products is not None:
            Q, AQ = self.exact_products
            coefficients = Q.T @ u
            return self._multiply(u - Q @ coefficients) + AQ @ coefficients
        return self._multiply(u)

    def _multiply(self, u: Array) -> Array:
        upper = self._upper()
        product: Array = upper @ u + upper.T @ u - self.diagonal * u
        return product

    def _upper(self) -> Any:
        from scipy.sparse import csr_array

        return csr_array((self.data, self.indices, self.indptr), shape=(self.size, self.size))

    def constrain(self, fixed: Flags, diagonal_shift: Array) -> Array:
        """Return the entries (entries,) with some unknowns fixed (size,) and a shift (size,) of the diagonal.

        Rows and columns of fixed unknowns are zero off the diagonal, which keeps its value.
        """
        data = self.data.copy()
        if fixed.any():
            dropped = fixed[self.indices]
            dropped |= np.repeat(fixed, np.diff(self.indptr))
            data[dropped] = 0.0
        data[self.indptr[:-1]] = self.diagonal + np.where(fixed, 0.0, diagonal_shift)
        return data

    def rows(self, numbers: Integers) -> Any:
        """Return the full rows (k, size) of some unknowns (k,), as a sparse array."""
        from scipy.sparse import csr_array

        k = len(numbers)
        if k == 0:
            return csr_array((0, self.size))
        wanted = np.zeros(self.size, dtype=bool)
        wanted[numbers] = True
        number = np.empty(self.size, dtype=np.int64)
        number[numbers] = np.arange(k)
        right = self._upper()[numbers].tocoo()
        # what lies left of the diagonal stands in the columns of the upper half
        at = np.flatnonzero(wanted[self.indices])
        row = np.searchsorted(self.indptr, at, side="right") - 1
        column = number[self.indices[at]]
        left = numbers[column] != row
        at, row, column = at[left], row[left], column[left]
        entries = np.concatenate([right.data, self.data[at]])
        places = np.concatenate([right.coords[0], column]), np.concatenate([right.coords[1], row])
        return csr_array((entries, places), shape=(k, self.size))

    def submatrix(self, numbers: Integers) -> Symmetric:
        """Return the principal submatrix of some unknowns (k,), given in ascending order."""
        part = self._upper()[numbers][:, numbers]
        part.sort_indices()
        return Symmetric(part.indptr, part.indices, part.data)
