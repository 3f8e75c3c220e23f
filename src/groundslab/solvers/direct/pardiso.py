"""MKL PARDISO."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
import threading
from typing import Any

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import SingularMatrix
from groundslab.optional import import_pardiso
from groundslab.solvers.direct.protocols import Factor


class Pardiso:
    """PARDISO through pypardiso: one analysis, then numeric factorizations of the same pattern."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        self.handle = import_pardiso().PyPardisoSolver(mtype=2)
        self.handle.set_iparm(1, 1)  # no defaults: use the entries below
        self.handle.set_iparm(5, 1)  # the order of elimination is given by perm
        self.handle.set_iparm(8, 0)  # no iterative refinement: the caller knows the residual and refines
        self.handle.set_iparm(24, 1)  # two-level parallel factorization
        self.handle.set_iparm(35, 1)  # zero-based indices
        self.handle.perm = np.arange(len(indptr) - 1, dtype=np.int32)
        self.indptr, self.indices = indptr.astype(np.int32), indices.astype(np.int32, copy=False)
        self.data = np.zeros(0)
        self.analyzed_threads = 0  # number of threads of the analysis; 0 before it
        self.used = False  # whether PARDISO was ever called and may hold memory

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries."""
        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        self.data = data
        now = int(self.handle.libmkl.MKL_Get_Max_Threads())
        if self.analyzed_threads not in (0, now):
            # PARDISO fails with an analysis made for another number of threads
            self.handle.free_memory(everything=True)
            self.analyzed_threads = 0
        phase, self.used = 22 if self.analyzed_threads else 12, True
        self._call(phase, np.zeros(len(self.handle.perm)))
        self.analyzed_threads, self.data = now, np.zeros(0)  # solutions need the factor alone
        return self

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k)."""
        return np.ascontiguousarray(self._call(33, np.asfortranarray(b, dtype=np.float64)))

    def _call(self, phase: int, b: Array) -> Array:
        """Run a phase of PARDISO on b; pypardiso's own call would copy the pattern every time."""
        x, error = np.zeros_like(b), ctypes.c_int32(0)
        handle = self.handle

        def number(value: int) -> Any:
            return ctypes.byref(ctypes.c_int32(value))

        def pointer(array: Array | Indices) -> Any:
            return array.ctypes.data_as(ctypes.POINTER(np.ctypeslib.as_ctypes_type(array.dtype)))

        handle._mkl_pardiso(
            pointer(handle.pt),
            number(1),  # number of matrices
            number(1),  # the matrix to use
            number(handle.mtype),
            number(phase),
            number(len(b)),
            pointer(self.data),
            pointer(self.indptr),
            pointer(self.indices),
            pointer(handle.perm),
            number(1 if b.ndim == 1 else b.shape[1]),
            pointer(handle.iparm),
            number(0),  # no messages
            pointer(b),
            pointer(x),
            ctypes.byref(error),
        )
        if error.value == -4:
            raise SingularMatrix("the stiffness matrix is not positive definite")
        if error.value:
            raise MemoryError(f"PARDISO stopped with error {error.value} on {len(b)} unknowns")
        return x

    def __del__(self) -> None:  # noqa: D105
        # PARDISO keeps its factor outside Python's memory
        if getattr(self, "used", False) and not sys.is_finalizing():
            self.handle.free_memory(everything=True)


@functools.cache
def load_in_background() -> None:
    """Have another thread load what MKL computes with, for which the first factorization would wait."""

    def factor_one() -> None:
        Pardiso(np.arange(2, dtype=np.int32), np.zeros(1, dtype=np.int32)).factor(np.ones(1))

    threading.Thread(target=factor_one, name="MKL").start()


def make_reproducible() -> None:
    """Make MKL's results reproducible to the last bit, whatever the alignment of arrays, unless it was used before.

    Otherwise the order of a sum, and so its last bit, depends on what else the process did. Costs about a tenth of a
    factorization (see "conditional numerical reproducibility" in MKL's guide).
    """
    os.environ.setdefault("MKL_CBWR", "AUTO")


@functools.cache
def pardiso_import_error() -> str:
    """Return why PARDISO cannot be loaded, "" if it can; cached, as a failing search takes long."""
    try:
        import_pardiso()
    except ImportError as error:
        return str(error)
    return ""
