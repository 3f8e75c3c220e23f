"""Reuse of the latest factorization: low-rank updates and iterative refinement instead of a new one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.errors import SingularMatrix
from groundslab.fem.sparse import Symmetric
from groundslab.solvers.protocols import Factor, Symbolic

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
