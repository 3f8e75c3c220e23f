"""MKL PARDISO."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from pathlib import Path
from typing import Any

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import SingularMatrix
from groundslab.solvers.protocols import Factor


class Pardiso:
    """MKL PARDISO through pypardiso: analysis once, then numeric factorisations of the same pattern."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        self.handle = pardiso_wrapper().PyPardisoSolver(mtype=2)
        self.handle.set_iparm(1, 1)  # no defaults: the entries below count
        self.handle.set_iparm(5, 1)  # the order of elimination is given: that of the numbers
        self.handle.set_iparm(8, 0)  # no iterative refinement: whoever knows what is left over can do it once
        self.handle.set_iparm(24, 1)  # two-level parallel factorisation
        self.handle.set_iparm(35, 1)  # numbers begin with 0
        self.handle.perm = np.arange(len(indptr) - 1, dtype=np.int32)
        self.indptr, self.indices = indptr.astype(np.int32), indices.astype(np.int32, copy=False)
        self.data = np.zeros(0)
        self.analysed = 0  # for how many threads; 0 if not yet
        self.used = False  # whether PARDISO was ever called and may hold memory

    def factor(self, data: Array) -> Factor:
        """Return the factor of the matrix whose upper half has these entries."""
        if not np.isfinite(data).all():
            raise SingularMatrix("the matrix holds entries that are not finite numbers")
        self.data = data
        now = int(self.handle.libmkl.MKL_Get_Max_Threads())
        if self.analysed not in (0, now):
            # under another number of threads PARDISO breaks down with it
            self.handle.free_memory(everything=True)
            self.analysed = 0
        phase, self.used = 22 if self.analysed else 12, True
        self._call(phase, np.zeros(len(self.handle.perm)))
        self.analysed, self.data = now, np.zeros(0)  # solutions need the factor alone
        return self

    def solve(self, b: Array) -> Array:
        """Return x with A x = b, for b (n,) or (n, k)."""
        return np.ascontiguousarray(self._call(33, np.asfortranarray(b, dtype=np.float64)))

    def _call(self, phase: int, b: Array) -> Array:
        """Return what a phase of PARDISO makes of b: pypardiso's own call copies the whole pattern every time."""
        x, error = np.zeros_like(b), ctypes.c_int32(0)
        handle = self.handle

        def number(value: int) -> Any:
            return ctypes.byref(ctypes.c_int32(value))

        def of(array: Array | Indices) -> Any:
            return array.ctypes.data_as(ctypes.POINTER(np.ctypeslib.as_ctypes_type(array.dtype)))

        handle._mkl_pardiso(
            of(handle.pt),
            number(1),  # matrices held
            number(1),  # which of them
            number(handle.mtype),
            number(phase),
            number(len(b)),
            of(self.data),
            of(self.indptr),
            of(self.indices),
            of(handle.perm),
            number(1 if b.ndim == 1 else b.shape[1]),
            of(handle.iparm),
            number(0),  # no messages
            of(b),
            of(x),
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


def pardiso_wrapper() -> Any:
    """Import pypardiso and tell it where MKL lies: its own search, done for every solver, takes longer than solving."""
    if "PYPARDISO_MKL_RT" not in os.environ:
        places = ("lib/libmkl_rt.so*", "Library/bin/mkl_rt*.dll")
        found = [path for place in places for path in sorted(Path(sys.prefix).glob(place))]
        if found:
            os.environ["PYPARDISO_MKL_RT"] = str(found[0])
    from pypardiso import pardiso_wrapper

    return pardiso_wrapper


def repeatable() -> None:
    """Let MKL give the same result to the last bit wherever in memory its numbers lie, unless it was used before.

    Else a sum's order depends on that, and so its last bit on what else a process did. Costs about a tenth of a
    factorisation (conditional numerical reproducibility in MKL's guide).
    """
    os.environ.setdefault("MKL_CBWR", "AUTO")


@functools.cache
def without_pardiso() -> str:
    """Return why PARDISO cannot be loaded, nothing if it can; asked once, as a search in vain takes long."""
    try:
        pardiso_wrapper()
    except ImportError as error:
        return str(error)
    return ""
