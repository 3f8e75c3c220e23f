"""Direct solution of symmetric positive definite systems: a solver is a value, (pattern) -> (A) -> factor.

Patterns are upper CSR, numbered in an order of elimination that is already good (mesh.elimination_order).
"""

from __future__ import annotations

import ctypes
import functools
import os
import platform
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from groundslab.arrays import Array, Flags, Indices
from groundslab.errors import Fault, InputError, SingularMatrix
from groundslab.fem.sparse import Symmetric

#: A factor helps with a task of the same matrix that differs from its own in at most so many unknowns.
FEW = 16
#: Or in fewer, so that what is kept for these unknowns has no more numbers than this.
MOST = 2**23
#: And with one of another matrix, by conjugate gradients alone, if they differ in at most so many.
FEWER = 4
#: Such a matrix with fewer rows is factorised anew in less time than the steps take.
SMALL = 30_000
#: Conjugate gradients end when the error's energy is below this share of the solution's: 1e-10 of its displacements.
TOLERANCE = 1e-20


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


class _Pardiso:
    """MKL PARDISO through pypardiso: analysis once, then numeric factorisations of the same pattern."""

    def __init__(self, indptr: Indices, indices: Indices) -> None:
        self.handle = _pardiso_wrapper().PyPardisoSolver(mtype=2)
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

    def __del__(self) -> None:
        # PARDISO keeps its factor outside Python's memory
        if getattr(self, "used", False) and not sys.is_finalizing():
            self.handle.free_memory(everything=True)


def _pardiso_wrapper() -> Any:
    """Import pypardiso and tell it where MKL lies: its own search, done for every solver, takes longer than solving."""
    if "PYPARDISO_MKL_RT" not in os.environ:
        places = ("lib/libmkl_rt.so*", "Library/bin/mkl_rt*.dll")
        found = [path for place in places for path in sorted(Path(sys.prefix).glob(place))]
        if found:
            os.environ["PYPARDISO_MKL_RT"] = str(found[0])
    from pypardiso import pardiso_wrapper

    return pardiso_wrapper


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


def repeatable() -> None:
    """Let MKL give the same result to the last bit wherever in memory its numbers lie, unless it was used before.

    Else a sum's order depends on that, and so its last bit on what else a process did. Costs about a tenth of a
    factorisation (conditional numerical reproducibility in MKL's guide).
    """
    os.environ.setdefault("MKL_CBWR", "AUTO")


def threads(solver: Solver) -> int:
    """Return the number of threads that a solver's factorisations run on."""
    if solver is not pardiso:
        return 1
    library = _pardiso_wrapper().PyPardisoSolver().libmkl
    return int(library.MKL_Get_Max_Threads())


def use_threads(solver: Solver, count: int) -> None:
    """Let a solver's factorisations run on so many threads (0: all) where the thread that calls this asks for them."""
    if solver is pardiso:
        _pardiso_wrapper().PyPardisoSolver().libmkl.MKL_Set_Num_Threads_Local(count)


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
    return _Pardiso(indptr, indices)


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
            mend = 'solver = "auto" takes it where it is there'
            got = f'"pardiso", which cannot be loaded ({without_pardiso()})'
            raise InputError([Fault("analysis.solver", got, '"superlu" or "auto"', mend)])
        if name == "mumps" and find_spec("petsc4py") is None:
            got = '"mumps", which needs petsc4py, and that is not there'
            mend = "docs/large.md tells how to install it"
            raise InputError([Fault("analysis.solver", got, '"auto"', mend)])
        return name, solvers[name]
    if platform.machine().lower() in ("x86_64", "amd64") and not without_pardiso():
        return "pardiso", pardiso
    return "superlu", superlu


@functools.cache
def without_pardiso() -> str:
    """Return why PARDISO cannot be loaded, nothing if it can; asked once, as a search in vain takes long."""
    try:
        _pardiso_wrapper()
    except ImportError as error:
        return str(error)
    return ""


@dataclass(frozen=True, slots=True, eq=False)
class Task:
    """A matrix with unknowns held and something added to its diagonal: what is to be solved with."""

    A: Symmetric
    held: Flags  # (size,)
    added: Array  # (size,), without meaning where held
    level: Array  # (size,): the values of held unknowns, zero elsewhere

    def differs(self, other: Task) -> int:
        """Return the number of unknowns that are held, or whose diagonal is added to, in one of two tasks alone."""
        loose = ~(self.held & other.held)
        return int((((self.held != other.held) | (self.added != other.added)) & loose).sum())


class _Bordered:
    """Solves a task with the factor of another one that has the same matrix and differs in few unknowns.

    Unknowns that are newly free add rows and columns to the factorised matrix, newly held ones a multiplier each, other
    diagonals a spring each. Block elimination leaves a system as small as their number (Woodbury 1950). It needs the
    factor's solution for each of them, which stays in `known` (by the unknown).
    """

    def __init__(self, factor: Factor, own: Task, task: Task, known: dict[int, Array]) -> None:
        both = ~own.held & ~task.held
        self.freed = np.flatnonzero(own.held & ~task.held)
        self.kept = np.flatnonzero((task.held & ~own.held) | (both & (own.added != task.added)))
        self.factor, self.free, self.rows = factor, np.where(own.held, 0.0, 1.0), task.A.rows(self.freed)
        new = [i for i in range(len(self)) if self._unknown(i) not in known]
        if new:
            border = np.column_stack([self._column(i) for i in new])
            known |= zip(map(self._unknown, new), factor.solve(border).T, strict=True)
        self.inner = [known[self._unknown(i)] for i in range(len(self))]
        self.small = np.column_stack([self._along(column) for column in self.inner])
        j = len(self.freed)
        self.small[:j, :j] -= self.rows[:, self.freed].toarray() + np.diag(task.added[self.freed])
        for i, unknown in enumerate(self.kept, start=j):
            if not task.held[unknown]:
                self.small[i, i] += 1.0 / (task.added[unknown] - own.added[unknown])

    def __len__(self) -> int:
        """Return in how many unknowns the tasks differ."""
        return len(self.freed) + len(self.kept)

    def _unknown(self, i: int) -> int:
        """Return the unknown of a row of the border."""
        return int(self.freed[i] if i < len(self.freed) else self.kept[i - len(self.freed)])

    def _column(self, i: int) -> Array:
        """Return a row of the border (size,)."""
        if i < len(self.freed):
            row: Array = self.rows[[i]].toarray()[0] * self.free
            return row
        unit = np.zeros(len(self.free))
        unit[self._unknown(i)] = 1.0
        return unit

    def _along(self, x: Array) -> Array:
        """Return the border's rows times x (size,)."""
        return np.concatenate([self.rows @ (x * self.free), x[self.kept]])

    def solve(self, b: Array) -> Array:
        """Return x (size,) with the task's matrix times x = b where it is free; x has no meaning where it is held."""
        x = self.factor.solve(b * self.free)
        sought = self._along(x)
        sought[: len(self.freed)] -= b[self.freed]
        try:
            found = np.linalg.solve(self.small, sought)
        except np.linalg.LinAlgError as error:
            raise SingularMatrix("the stiffness matrix of a task near the factorised one is singular") from error
        for share, column in zip(found, self.inner, strict=True):
            x -= share * column
        x[self.freed] = found[: len(self.freed)]
        return x


class Latest:
    """A pattern that has been analysed, with its latest factor, which also helps to solve tasks that are near its own.

    It preconditions conjugate gradients: bordered if the matrix is the same, else as it is. These then need one or two
    steps, or few if the entries of the matrix have changed little.
    """

    def __init__(self, symbolic: Symbolic) -> None:
        self.symbolic = symbolic
        self.task: Task | None = None
        self._factor: Factor
        self._known: dict[int, Array] = {}  # see _Bordered

    def solves(self, task: Task) -> bool:
        """Return whether the latest factor is the one of this task."""
        return self.task is not None and self.task.A is task.A and self.task.differs(task) == 0

    def near(self, task: Task) -> bool:
        """Return whether the latest factor can be expected to help with this task."""
        if self.task is None:
            return False
        differing = self.task.differs(task)
        if self.task.A is task.A:
            return differing <= min(FEW, MOST // len(task.held))
        return differing <= FEWER and len(task.held) >= SMALL

    def _preconditioner(self, task: Task) -> Factor:
        """Return what solves a task, or one near it."""
        assert self.task is not None
        differing = self.task.A is task.A and self.near(task) and self.task.differs(task) > 0
        return _Bordered(self._factor, self.task, task, self._known) if differing else self._factor

    def factor(self, task: Task) -> None:
        """Take the factor of another task; raise SingularMatrix if it is not positive definite."""
        self.task = None  # the factor that there is is no longer valid
        self._known = {}
        self._factor = self.symbolic.factor(task.A.held(task.held, task.added))
        self.task = task

    def improve(self, task: Task, load: Array, u: Array, rest: Array, steps: int) -> bool:
        """Bring u (size,) towards the solution under a load (size,) by steps of conjugate gradients.

        u, which has its values where it is held, and rest = load - A u (size,) change in place. Returns whether the
        energy of the error fell below TOLERANCE of that of the solution, which is not looked at after a single step.
        """
        preconditioner = self._preconditioner(task)
        free = np.where(task.held, 0.0, 1.0)
        added = task.added * free
        r = (rest - added * u) * free
        q, rz, first = np.zeros_like(u), np.inf, 0.0
        for step in range(steps + 1):
            z = preconditioner.solve(r) * free
            last, rz = rz, float(r @ z)
            first = rz if step == 0 else first
            if step > 0 and rz <= TOLERANCE * max(first, abs(float(u @ load))):
                return True
            if step == steps:
                break
            q = z + rz / last * q
            Aq = task.A @ q
            along = float(q @ Aq + added @ (q * q))
            if not along > 0:
                return rz == 0.0
            u += rz / along * q
            rest -= rz / along * Aq
            if steps == 1:
                return True
            r -= rz / along * (Aq + added * q) * free
        return False
