"""Direct solution of symmetric positive definite systems: a solver is a value, (pattern) -> (A) -> factor.

Patterns are upper CSR, numbered in an order of elimination that is already good (mesh.elimination_order).
"""

from __future__ import annotations

import platform
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

import numpy as np

from groundslab.arrays import Array, Indices
from groundslab.errors import InputError, Issue, SingularMatrix
from groundslab.solvers.pardiso import Pardiso, pardiso_wrapper, without_pardiso
from groundslab.solvers.protocols import Factor, Solver, Symbolic


class _SuperLU:
    """SciPy's SuperLU in symmetric mode; takes the order of elimination as it is numbered."""

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


def threads(solver: Solver) -> int:
    """Return the number of threads that a solver's factorisations run on."""
    if solver is not pardiso:
        return 1
    library = pardiso_wrapper().PyPardisoSolver().libmkl
    return int(library.MKL_Get_Max_Threads())


def use_threads(solver: Solver, count: int) -> None:
    """Let a solver's factorisations run on so many threads (0: all) where the thread that calls this asks for them."""
    if solver is pardiso:
        pardiso_wrapper().PyPardisoSolver().libmkl.MKL_Set_Num_Threads_Local(count)


@contextmanager
def one_thread() -> Iterator[None]:
    """Let factorisations run on one thread only where they are asked for within."""
    solver = choose("auto")[1]
    use_threads(solver, 1)
    try:
        yield
    finally:
        use_threads(solver, 0)


def pardiso(indptr: Indices, indices: Indices) -> Symbolic:
    """Return the pattern analysed by MKL PARDISO; raise ImportError where it is not installed."""
    return Pardiso(indptr, indices)


def superlu(indptr: Indices, indices: Indices) -> Symbolic:
    """Return the pattern prepared for SciPy's SuperLU."""
    return _SuperLU(indptr, indices)


def mumps(indptr: Indices, indices: Indices) -> Symbolic:
    """Return the pattern shared out among the processes of an MPI run; raise ImportError without petsc4py."""
    from groundslab.solvers.mumps import Mumps

    return Mumps(indptr, indices)


def choose(name: str) -> tuple[str, Solver]:
    """Return the solver "pardiso", "superlu" or "mumps"; for "auto" PARDISO where it can be imported."""
    solvers: dict[str, Solver] = {"pardiso": pardiso, "superlu": superlu, "mumps": mumps}
    if name != "auto":
        if name == "pardiso" and without_pardiso():
            hint = 'solver = "auto" takes it where it is there'
            found = f'"pardiso", which cannot be loaded ({without_pardiso()})'
            raise InputError([Issue("analysis.solver", found, '"superlu" or "auto"', hint)])
        if name == "mumps" and find_spec("petsc4py") is None:
            found = '"mumps", which needs petsc4py, and that is not there'
            hint = "docs/large.md tells how to install it"
            raise InputError([Issue("analysis.solver", found, '"auto"', hint)])
        return name, solvers[name]
    if platform.machine().lower() in ("x86_64", "amd64") and not without_pardiso():
        return "pardiso", pardiso
    return "superlu", superlu
