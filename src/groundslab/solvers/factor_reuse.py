"""Reuse of the latest factorizations: low-rank updates and preconditioned conjugate gradients instead of a new one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.errors import SingularMatrix
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.solvers.direct.protocols import Factor, Symbolic

#: A factor serves another system of the same matrix whose constraints differ in at most so many unknowns,
MAX_UPDATE_RANK = 32
#: or in fewer, so that the stored columns of these unknowns have no more entries than this.
MAX_UPDATE_ENTRIES = 2**23
#: It serves a system of another matrix, as a preconditioner, if the constraints differ in at most so many unknowns
MAX_PRECONDITIONER_RANK = 4
#: and the matrix has at least so many rows: a smaller one is factorized in less time than the iterations take.
MIN_PRECONDITIONED_SIZE = 30_000
#: So many factors of a matrix are kept at most, and no more than have so many rows together: that memory is there for
#: the factor of a large system, too.
MOST_FACTORS = 4
MOST_KEPT_ROWS = 400_000
#: Conjugate gradients end when the error's energy is below this share of the solution's: 1e-10 of its displacements.
TOLERANCE = 1e-20


@dataclass(frozen=True, slots=True, eq=False)
class ConstrainedSystem:
    """A matrix with some unknowns fixed and a shift of its diagonal."""

    A: Symmetric
    fixed: Flags  # (size,)
    diagonal_shift: Array  # (size,), without meaning where fixed
    fixed_values: Array  # (size,), zero where not fixed

    def count_differences(self, other: ConstrainedSystem) -> int:
        """Return the number of unknowns that only one of two systems fixes, or whose diagonals differ."""
        loose = ~(self.fixed & other.fixed)
        return int((((self.fixed != other.fixed) | (self.diagonal_shift != other.diagonal_shift)) & loose).sum())


class WoodburySolver:
    """Solves a system with the factor of another one of the same matrix whose constraints differ in few unknowns.

    Freed unknowns add rows and columns to the factorized matrix, newly fixed ones a multiplier each, other diagonals a
    spring each. Block elimination leaves a system as small as their number (Woodbury 1950). It needs the factor's
    solution for each of them, which is kept in `columns`, by the unknown.
    """

    def __init__(
        self, factor: Factor, factorized: ConstrainedSystem, system: ConstrainedSystem, columns: dict[int, Array]
    ) -> None:
        both_free = ~factorized.fixed & ~system.fixed
        shifted = both_free & (factorized.diagonal_shift != system.diagonal_shift)
        self.freed = np.flatnonzero(factorized.fixed & ~system.fixed)
        self.added = np.flatnonzero((system.fixed & ~factorized.fixed) | shifted)
        self.factor, self.free = factor, np.where(factorized.fixed, 0.0, 1.0)
        self.rows = system.A.rows(self.freed)
        new = [i for i in range(len(self)) if self._unknown(i) not in columns]
        if new:
            border = np.column_stack([self._border_column(i) for i in new])
            columns |= zip(map(self._unknown, new), factor.solve(border).T, strict=True)
        self.columns = [columns[self._unknown(i)] for i in range(len(self))]
        self.schur = np.column_stack([self._multiply_border(column) for column in self.columns])
        j = len(self.freed)
        self.schur[:j, :j] -= self.rows[:, self.freed].toarray() + np.diag(system.diagonal_shift[self.freed])
        for i, unknown in enumerate(self.added, start=j):
            if not system.fixed[unknown]:
                self.schur[i, i] += 1.0 / (system.diagonal_shift[unknown] - factorized.diagonal_shift[unknown])

    def __len__(self) -> int:
        """Return the rank of the update."""
        return len(self.freed) + len(self.added)

    def _unknown(self, i: int) -> int:
        """Return the unknown of a row of the border."""
        return int(self.freed[i] if i < len(self.freed) else self.added[i - len(self.freed)])

    def _border_column(self, i: int) -> Array:
        """Return a column of the border (size,)."""
        if i < len(self.freed):
            row: Array = self.rows[[i]].toarray()[0] * self.free
            return row
        unit = np.zeros(len(self.free))
        unit[self._unknown(i)] = 1.0
        return unit

    def _multiply_border(self, x: Array) -> Array:
        """Return the border's rows times x (size,)."""
        return np.concatenate([self.rows @ (x * self.free), x[self.added]])

    def solve(self, b: Array) -> Array:
        """Return x (size,) that solves the system for b where it is free; x has no meaning where it is fixed."""
        x = self.factor.solve(b * self.free)
        right = self._multiply_border(x)
        right[: len(self.freed)] -= b[self.freed]
        try:
            multipliers = np.linalg.solve(self.schur, right)
        except np.linalg.LinAlgError as error:
            raise SingularMatrix("the stiffness matrix under changed constraints is singular") from error
        for multiplier, column in zip(multipliers, self.columns, strict=True):
            x -= multiplier * column
        x[self.freed] = multipliers[: len(self.freed)]
        return x


@dataclass(slots=True)
class _Factorized:
    """A factor with the system that it is of."""

    symbolic: Symbolic
    system: ConstrainedSystem | None = None  # None before a factorization, and after one that failed
    factor: Factor | None = None
    columns: dict[int, Array] = field(default_factory=dict)  # see WoodburySolver

    def rank_to(self, system: ConstrainedSystem) -> float:
        """Return in how many unknowns another system of the same matrix is constrained otherwise, inf of another."""
        if self.system is None or self.system.A is not system.A:
            return np.inf
        return self.system.count_differences(system)


class CachedFactorization:
    """An analyzed pattern with its latest factors, which also serve to solve systems close to the factorized ones.

    A factor preconditions conjugate gradients: with a low-rank update if the matrix is the same, else as it is. These
    then need one or two steps, or few if the entries of the matrix have changed little.
    """

    def __init__(self, symbolic: Symbolic, analyze: Callable[[], Symbolic] | None = None) -> None:
        """Keep one factor, or several of the same matrix if `analyze` analyzes the pattern again."""
        self._kept = [_Factorized(symbolic)]  # the latest one first
        self._analyze = analyze

    def holds(self, system: ConstrainedSystem) -> bool:
        """Return whether one of the factors is that of this system; the closest one becomes the latest."""
        ranks = [kept.rank_to(system) for kept in self._kept]
        closest = ranks.index(min(ranks))
        self._kept.insert(0, self._kept.pop(closest))
        return ranks[closest] == 0

    def preconditions(self, system: ConstrainedSystem) -> bool:
        """Return whether the latest factor can be expected to precondition this system well."""
        latest = self._kept[0].system
        if latest is None:
            return False
        rank = latest.count_differences(system)
        if latest.A is system.A:
            return rank <= min(MAX_UPDATE_RANK, MAX_UPDATE_ENTRIES // len(system.fixed))
        return rank <= MAX_PRECONDITIONER_RANK and len(system.fixed) >= MIN_PRECONDITIONED_SIZE

    def _preconditioner(self, system: ConstrainedSystem) -> Factor:
        """Return what solves a system, or one close to it."""
        latest = self._kept[0]
        assert latest.system is not None
        assert latest.factor is not None
        if self.preconditions(system) and 0 < latest.rank_to(system) < np.inf:
            if len(latest.columns) * len(system.fixed) > MAX_UPDATE_ENTRIES:
                latest.columns.clear()
            return WoodburySolver(latest.factor, latest.system, system, latest.columns)
        return latest.factor

    def factorize(self, system: ConstrainedSystem, beside: bool = False) -> None:
        """Factorize another system; raise SingularMatrix if it is not positive definite.

        `beside` keeps the latest factor, too, if it is of the same matrix; that which served least recently goes.
        """
        latest = self._kept[0]
        if not beside or latest.rank_to(system) == np.inf:
            del self._kept[1:]
        elif self._analyze is not None and len(self._kept) < min(MOST_FACTORS, MOST_KEPT_ROWS // len(system.fixed)):
            self._kept.insert(0, _Factorized(self._analyze()))
        else:
            self._kept.insert(0, self._kept.pop())
        latest = self._kept[0]
        latest.system = None  # the previous factor is no longer valid
        latest.columns = {}
        latest.factor = latest.symbolic.factor(system.A.constrain(system.fixed, system.diagonal_shift))
        latest.system = system

    def solve(self, b: Array) -> Array:
        """Return x (size,) that solves the system factorized last for b (size,)."""
        factor = self._kept[0].factor
        assert factor is not None
        return factor.solve(b)

    def iterate(self, system: ConstrainedSystem, load: Array, u: Array, residual: Array, steps: int) -> bool:
        """Improve u (size,) towards the solution under a load (size,) by steps of conjugate gradients.

        u, which has the fixed values, and residual = load - A u (size,) change in place. Returns whether the energy of
        the error fell below TOLERANCE of that of the solution, which a single step does not check.
        """
        preconditioner = self._preconditioner(system)
        free = np.where(system.fixed, 0.0, 1.0)
        shift = system.diagonal_shift * free
        r = (residual - shift * u) * free
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
            Aq = system.A @ q
            curvature = float(q @ Aq + shift @ (q * q))
            if not curvature > 0:
                return rz == 0.0
            u += rz / curvature * q
            residual -= rz / curvature * Aq
            if steps == 1:
                return True
            r -= rz / curvature * (Aq + shift * q) * free
        return False
