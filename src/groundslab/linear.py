"""Direct solution of symmetric positive definite systems: a solver is a value, (pattern) -> (A) -> factor.

Patterns are upper CSR, numbered in an order of elimination that is already good (mesh.elimination_order).
"""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from groundslab.errors import Fault, InputError, SingularMatrix
from groundslab.shape import Array, Indices, Integers


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
Solver = Callable[[Integers, Indices], Symbolic]


class _Pardiso:
    """MKL PARDISO through pypardiso: analysis once, then numeric factorisations of the same pattern."""

    def __init__(self, indptr: Integers, indices: Indices) -> None:
        from scipy.sparse import csr_array

        self.handle = _pardiso_wrapper().PyPardisoSolver(mtype=2)
        self.handle.set_iparm(1, 1)  # no defaults: the entries below count
        self.handle.set_iparm(5, 1)  # the order of elimination is given: that of the numbers
        self.handle.perm = np.arange(1, len(indptr), dtype=np.int32)
        self.handle.set_iparm(8, 0)  # no iterative refinement: whoever knows what is left over can do it once
        self.handle.set_iparm(24, 1)  # two-level parallel factorisation
        n = len(indptr) - 1
        self.A = csr_array((np.zeros(len(indices)), indices, indptr), shape=(n, n))
        self.analysed = False
        self.used = False  # whether PARDISO was ever called and may hold memory

    def factor(self, data: Array) -> Factor:
        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        self.A.data = data
        phase, self.used = 22 if self.analysed else 12, True
        self._call(phase, np.zeros(self.A.shape[0]))
        self.analysed = True
        return self

    def solve(self, b: Array) -> Array:
        return self._call(33, np.asfortranarray(b))

    def _call(self, phase: int, b: Array) -> Array:
        self.handle.set_phase(phase)
        try:
            x: Array = self.handle._call_pardiso(self.A, b)
        except _pardiso_wrapper().PyPardisoError as error:
            if error.value == -4:
                raise SingularMatrix("the stiffness matrix is not positive definite") from error
            raise MemoryError(f"PARDISO stopped with error {error.value} on {self.A.shape[0]} unknowns") from error
        return x

    def __del__(self) -> None:
        # PARDISO keeps its factor outside Python's memory
        if getattr(self, "used", False) and not sys.is_finalizing():
            self.handle.free_memory(everything=True)


def _pardiso_wrapper() -> Any:
    """Import pypardiso, telling it where MKL lies: its own search starts compilers and takes longer than the import."""
    if "PYPARDISO_MKL_RT" not in os.environ and "pypardiso" not in sys.modules:
        places = ("lib/libmkl_rt.so*", "Library/bin/mkl_rt*.dll")
        found = [path for place in places for path in sorted(Path(sys.prefix).glob(place))]
        if found:
            os.environ["PYPARDISO_MKL_RT"] = str(found[0])
    from pypardiso import pardiso_wrapper

    return pardiso_wrapper


class _SuperLU:
    """SciPy's SuperLU in symmetric mode; takes the order of elimination as it is numbered."""

    def __init__(self, indptr: Integers, indices: Indices) -> None:
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
        # SuperLU is content with any pivot but zero; rows that changed places had a zero on the diagonal
        if (lu.U.diagonal() <= 0).any() or (lu.perm_r != lu.perm_c).any():
            raise SingularMatrix("the stiffness matrix is not positive definite")
        factor: Factor = lu
        return factor


def pardiso(indptr: Integers, indices: Indices) -> Symbolic:
    """Return the pattern analysed by MKL PARDISO; raise ImportError where it is not installed."""
    return _Pardiso(indptr, indices)


def superlu(indptr: Integers, indices: Indices) -> Symbolic:
    """Return the pattern prepared for SciPy's SuperLU."""
    return _SuperLU(indptr, indices)


def choose(name: str) -> tuple[str, Solver]:
    """Return the solver "pardiso" or "superlu"; for "auto" PARDISO where it can be imported."""
    solvers: dict[str, Solver] = {"pardiso": pardiso, "superlu": superlu}
    if name != "auto":
        if name == "pardiso":
            try:
                _pardiso_wrapper()
            except ImportError as error:
                mend = 'solver = "auto" takes it where it is there'
                fault = Fault(
                    "analysis.solver", f'"pardiso", which cannot be loaded ({error})', '"superlu" or "auto"', mend
                )
                raise InputError([fault]) from error
        return name, solvers[name]
    if platform.machine().lower() in ("x86_64", "amd64"):
        try:
            _pardiso_wrapper()
        except ImportError:
            return "superlu", superlu
        return "pardiso", pardiso
    return "superlu", superlu


class Remembering:
    """A pattern that has been analysed, which gives back its latest factor when asked for the same matrix again."""

    def __init__(self, symbolic: Symbolic) -> None:
        self.symbolic = symbolic
        self.latest: tuple[Array, Factor] | None = None

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries, the latest one if they are the same."""
        if self.latest is not None and np.array_equal(self.latest[0], data):
            return self.latest[1]
        self.latest = None  # what it holds is no longer valid once another matrix is factorised
        self.latest = data, self.symbolic.factor(data)
        return self.latest[1]
