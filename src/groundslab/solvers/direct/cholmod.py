"""CHOLMOD through cvxopt, whose wheels have it for all processors; GPL-3.0, hence an extra of its own."""

from __future__ import annotations

from typing import Any

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import SingularMatrix
from groundslab.solvers.direct.protocols import Factor


class Cholmod:
    """CHOLMOD's supernodal factorization: one analysis, then numeric factorizations of the same pattern."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        from cvxopt import matrix, spmatrix

        n = len(indptr) - 1
        rows = np.repeat(np.arange(n, dtype=np.intc), np.diff(indptr))
        # columns of the lower half are rows of the upper one
        self.matrix = spmatrix(1.0, matrix(indices.astype(np.intc)), matrix(rows), (n, n))
        self.analyzed: Any = None

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries."""
        from cvxopt import cholmod, matrix

        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        self.matrix.V = matrix(data)
        if self.analyzed is None:
            order = matrix(np.arange(self.matrix.size[0], dtype=np.intc))  # of elimination, as it is
            self.analyzed = cholmod.symbolic(self.matrix, p=order, uplo="L")
        try:
            cholmod.numeric(self.matrix, self.analyzed)
        except ArithmeticError as error:
            raise SingularMatrix("the stiffness matrix is not positive definite") from error
        return self

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k)."""
        from cvxopt import cholmod, matrix

        x = matrix(np.asarray(b, dtype=np.float64))
        cholmod.solve(self.analyzed, x)
        return np.array(x).reshape(b.shape)
