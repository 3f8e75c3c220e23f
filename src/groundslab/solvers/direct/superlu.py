"""SciPy's SuperLU."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import SingularMatrix
from groundslab.solvers.direct.protocols import Factor


class SuperLU:
    """SuperLU in symmetric mode, which keeps the given order of elimination."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        n = len(indptr) - 1
        row = np.repeat(np.arange(n, dtype=np.int32), np.diff(indptr))
        off = row != indices
        entry = np.arange(len(indices))
        rows = np.concatenate([row, indices[off]])
        columns = np.concatenate([indices, row[off]])
        source = np.concatenate([entry, entry[off]])
        order = np.lexsort((rows, columns))
        self.source = source[order]
        self.rows = rows[order].astype(np.int32)
        self.starts = np.searchsorted(columns[order], np.arange(n + 1)).astype(np.int32)

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries."""
        from scipy.sparse import csc_array
        from scipy.sparse.linalg import splu

        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        n = len(self.starts) - 1
        A = csc_array((data[self.source], self.rows, self.starts), shape=(n, n))
        try:
            lu = splu(A, permc_spec="NATURAL", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        except RuntimeError as error:
            raise SingularMatrix(f"the stiffness matrix is not positive definite ({error})") from error
        # SuperLU accepts any pivot but zero; rows that changed places had a zero on the diagonal
        if (lu.U.diagonal() <= 0).any() or (lu.perm_r != lu.perm_c).any():
            raise SingularMatrix("the stiffness matrix is not positive definite")
        factor: Factor = lu
        return factor
