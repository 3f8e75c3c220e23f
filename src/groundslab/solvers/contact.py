"""Unilateral contact: minimize 1/2 u.A u - f.u with one-sided bearings on some unknowns.

Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2002), which takes few steps from a good start. Where
it stagnates, cycles, or leaves the plate floating, an interior point method finds the states that it continues from
(module `interior_point`). See docs/theory.md, contact.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NotConverged, SingularMatrix
from groundslab.fem.assembly import scatter
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact, Measures, largest_of_parts
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.solvers import interior_point
from groundslab.solvers.factor_reuse import CachedFactorization, ConstrainedSystem

#: A penetration of the wrong sign below this share of the largest displacement does not change a bearing's state, nor
#: does a force that would make such a penetration on the unknown's own stiffness, or is so small beside the largest of
#: its kind: the ground may press with little beside supports that hold a slab as it curls.
STATE_TOLERANCE = 1e-10
#: Forces are told from rounding down to this share of the largest of all bearings, and of the unknown's own stiffness
#: times the largest displacement.
OF_ALL, OF_STIFFNESS = 1e-12, 1e-15
#: The plate floats if the closed bearings resist one of its rigid motions by less than this share of what all bearings
#: together would.
FLOATING_RATIO = 1e-6
#: After so many steps without fewer wrong states than before the interior point method takes over: it needs about as
#: many again as a slow but steady iteration from here.
MAX_STAGNANT_STEPS = 12
#: The interior point method has converged if the residual is at most this share of the largest force.
INTERIOR_POINT_TOLERANCE = 1e-4
#: The latest factor may serve for so many steps of conjugate gradients: about the cost of another factorization.
CG_STEPS = 8
#: If they lead to displacements so many times larger than at their start, the plate may float.
DIVERGENCE_RATIO = 10.0
#: Iterative refinement takes so many steps at most, until the residual is this share of the largest force.
MAX_REFINEMENTS = 4
REFINEMENT_TOLERANCE = 1e-11


@dataclass(frozen=True, slots=True)
class ContactProblem:
    """Minimize 1/2 u.A u - f.u with bearings on some unknowns."""

    A: Symmetric
    f: Array  # (size,)
    bearings: Bearings  # (c,)
    motions: Array | None = None  # (size, m): of the plate as a rigid body, against which only the bearings hold it
    measures: Measures | None = None  # what small displacements and forces are measured by; None if all are alike
    of_supports: Flags | None = None  # (c,): bearings of supports, not of the ground; None if all are of one kind

    @property
    def measured_by(self) -> Measures:
        """Return what small displacements and forces are measured by."""
        return self.measures or Measures(np.ones(self.A.size))


def solve(
    problem: ContactProblem,
    factorization: CachedFactorization,
    start: Integers,
    limit: int,
    report: Callable[[int, int, int], None],
    near: Array | None = None,
) -> Contact:
    """Return the solution of A u - f = forces of the bearings, to the digits of one substitution (see `refine`).

    start (c,) holds the initial states; near (size,) approximates the solution; report takes iteration, touching
    bearings and changes. Without bearings this is one linear solution. Raises NotConverged after `limit` iterations,
    SingularMatrix if A itself, held by all bearings, is not positive definite.

    Where the bearings that touch in the end do not hold the plate, it returns one of many solutions, to some digits:
    that of the interior point method (see equilibrium.require_hold).
    """
    b, measures = problem.bearings, problem.measured_by
    floating = _FloatingCheck(b, problem.motions)
    history: list[dict[str, int]] = []

    def record(states: Integers, changed: int) -> None:
        touching = int((states != OPEN).sum())
        history.append({"iteration": len(history) + 1, "closed": touching, "changed": changed})
        report(len(history), touching, changed)

    state, last = b.admissible(start), near
    progress = _Progress(len(b))
    inside: Contact | None = None
    while len(history) < limit:
        solution = None if floating.in_states(state) else _solve_states(problem, state, factorization, near)
        if solution is not None:
            after = _next_states(problem, solution, measures)
            wrong = after != state
            record(state, int(wrong.sum()))
            if not wrong.any():
                return solution
            # close to a cycle decisions must not rest on the residual of conjugate gradients
            last, near = solution.u, solution.u if progress.update(state, wrong) else None
            state = after
            if inside is not None or not progress.stalled:
                continue
        elif inside is not None:
            if _is_balanced(problem, inside, measures):
                return inside
            break
        inside = interior_point.solve(problem.A, problem.f, factorization, b, record)
        state, last, near, progress = inside.state, inside.u, None, _Progress(len(b))
    forces = {} if inside is None else {"force": inside.force}
    raise NotConverged("the contact zone", history, {"u": last, "closed": state != OPEN} | forces)


def _is_balanced(problem: ContactProblem, solution: Contact, measures: Measures) -> bool:
    """Return whether the interior point method has converged: no residual at unknowns that are free to move."""
    A, f, b = problem.A, problem.f, problem.bearings
    residual = f - A @ solution.u + scatter(b.unknown, b.sign * solution.force, A.size)
    residual[b.unknown[b.bilateral]] = 0.0
    lever = measures.lever
    largest = max(np.abs(f / lever).max(initial=0.0), np.abs(solution.force / lever[b.unknown]).max())
    return bool(np.abs(residual / lever).max(initial=0.0) <= INTERIOR_POINT_TOLERANCE * largest)


def _solve_states(
    problem: ContactProblem, state: Integers, factorization: CachedFactorization, near: Array | None
) -> Contact | None:
    """Return the solution for given states (c,), none if these do not hold the plate.

    near (size,) approximates the solution: the latest factor may then serve, if it preconditions the system well.
    """
    A, f, b = problem.A, problem.f, problem.bearings
    system, load = constrain(problem, state)

    def contact(u: Array, residual: Array) -> Contact:
        return Contact(u, state, _bearing_forces(b, state, u, load - f - residual))

    exact = factorization.holds(system)
    if near is not None and not exact and factorization.preconditions(system):
        u = np.where(system.fixed, system.fixed_values, near)
        residual = load - A @ u
        with suppress(SingularMatrix):  # then the factorization decides
            converged = factorization.iterate(system, load, u, residual, CG_STEPS)
            if converged and np.abs(u).max() <= DIVERGENCE_RATIO * np.abs(near).max():
                return contact(u, residual)
    if not exact:
        try:
            factorization.factorize(system, beside=True)
        except SingularMatrix:
            return None
    u = system.fixed_values.copy()
    residual = load - A @ u if u.any() else load.copy()
    factorization.iterate(system, load, u, residual, 1)
    return contact(u, residual)


def refine(problem: ContactProblem, factorization: CachedFactorization, contact: Contact) -> Contact:
    """Return a solution that `solve` has just found without the rounding of the factorization."""
    A, f, b = problem.A, problem.f, problem.bearings
    system, load = constrain(problem, contact.state)
    if not factorization.holds(system) and not factorization.preconditions(system):
        return contact  # one of many solutions, whose states no factor belongs to
    u = contact.u.copy()
    before = np.inf
    measures = problem.measured_by
    for _ in range(MAX_REFINEMENTS):
        residual = load - A @ u
        free = np.where(system.fixed, 0.0, np.abs(residual - system.diagonal_shift * u)) / measures.lever
        scale = measures.forces(residual)
        largest = np.divide(free, scale, out=np.zeros_like(free), where=scale > 0).max(initial=0.0)
        if largest <= REFINEMENT_TOLERANCE or largest > before / 2:
            break
        before = largest
        factorization.iterate(system, load, u, residual, 1)
    return Contact(u, contact.state, _bearing_forces(b, contact.state, u, load - f - (load - A @ u)))


def _bearing_forces(b: Bearings, state: Integers, u: Array, reaction: Array) -> Array:
    """Return the force of each bearing (c,); a rigid one takes the reaction (size,) that the others leave."""
    rigid = np.isinf(b.stiffness)
    force = np.where(state == YIELDING, b.limit_force, 0.0)
    elastic = np.flatnonzero((state == CLOSED) & ~rigid)
    force[elastic] = b.stiffness[elastic] * b.penetration(u)[elastic]
    carried = scatter(b.unknown, b.sign * force, len(u))
    closed = np.flatnonzero((state == CLOSED) & rigid)
    force[closed] = b.sign[closed] * (reaction - carried)[b.unknown[closed]]
    return force


def _next_states(problem: ContactProblem, solution: Contact, measures: Measures) -> Integers:
    """Return the state (c,) in which each bearing should be, judged by the solution for the present states."""
    b, state = problem.bearings, solution.state
    lever = measures.lever[b.unknown]
    plate = None if measures.plate is None else measures.plate[b.unknown]
    force, limit_force = solution.force / lever, b.limit_force / lever
    penetration = b.penetration(solution.u) * lever
    tolerance = STATE_TOLERANCE * measures.displacements(solution.u)[b.unknown]
    stiffness = problem.A.diagonal[b.unknown] / lever**2
    kind = plate
    if problem.of_supports is not None:
        kind = 2 * (np.zeros(len(b), dtype=np.int64) if plate is None else plate + 1) + problem.of_supports
    noise = np.maximum(OF_ALL * largest_of_parts(force, plate), OF_STIFFNESS / STATE_TOLERANCE * tolerance * stiffness)
    small = np.minimum(tolerance * stiffness, np.maximum(STATE_TOLERANCE * largest_of_parts(force, kind), noise))
    at_yield = np.zeros(len(b))  # penetration
    elastic = np.isfinite(b.stiffness)
    at_yield[elastic] = b.limit_force[elastic] / b.stiffness[elastic] * lever[elastic]
    after = state.copy()
    after[(state == OPEN) & (penetration > tolerance)] = CLOSED
    after[(state == CLOSED) & (force < -small)] = OPEN
    after[(state == CLOSED) & (force > limit_force + small)] = YIELDING
    after[(state == YIELDING) & (penetration < at_yield - tolerance)] = CLOSED
    return b.admissible(after)


class _FloatingCheck:
    """Checks whether the closed bearings keep the plate from moving as a rigid body."""

    def __init__(self, b: Bearings, motions: Array | None) -> None:
        rows = np.zeros((len(b), 0)) if motions is None else motions[b.unknown]
        # coordinates in which all bearings together resist every motion alike
        self.rows = np.linalg.qr(rows)[0] if rows.any() else rows[:, :0]

    def in_states(self, state: Integers) -> bool:
        """Return whether the plate floats with the bearings in states (c,)."""
        closed = self.rows[state == CLOSED]
        return closed.shape[1] > 0 and not np.linalg.eigvalsh(closed.T @ closed)[0] > FLOATING_RATIO**2


class _Progress:
    """Watches whether the active set iteration approaches the solution."""

    def __init__(self, bearings: int) -> None:
        self.seen: set[bytes] = set()
        self.fewest = bearings + 1
        self.stagnant_steps = 0
        self.stalled = False  # cycles, or stagnates

    def update(self, state: Integers, wrong: Flags) -> bool:
        """Record states (c,) of which some are wrong; return whether these are fewer than ever before."""
        wrongs, key = int(wrong.sum()), state.astype(np.uint8).tobytes()
        nearer = wrongs < self.fewest
        self.stagnant_steps = 0 if nearer else self.stagnant_steps + 1
        self.stalled = key in self.seen or self.stagnant_steps >= MAX_STAGNANT_STEPS
        self.seen.add(key)
        self.fewest = min(self.fewest, wrongs)
        return nearer


def constrain(problem: ContactProblem, state: Integers) -> tuple[ConstrainedSystem, Array]:
    """Return the linear system for given states of the bearings, and its load (size,)."""
    A, f, b = problem.A, problem.f, problem.bearings
    rigid = (state == CLOSED) & np.isinf(b.stiffness)
    elastic = (state == CLOSED) & np.isfinite(b.stiffness)
    yielding = state == YIELDING
    springs = scatter(b.unknown[elastic], b.stiffness[elastic], A.size)
    load = f + scatter(b.unknown[elastic], b.stiffness[elastic] * b.offset[elastic], A.size)
    load += scatter(b.unknown[yielding], b.sign[yielding] * b.limit_force[yielding], A.size)
    fixed, fixed_values = np.zeros(A.size, dtype=bool), np.zeros(A.size)
    fixed[b.unknown[rigid]] = True
    fixed_values[b.unknown[rigid]] = b.offset[rigid]
    return ConstrainedSystem(A, fixed, springs, fixed_values), load
