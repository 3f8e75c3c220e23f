"""Unilateral contact: minimise 1/2 u.A u - f.u with bearings that push on some unknowns one way only.

Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2002), which takes few steps from a good start. Where
it does not come nearer, runs in a circle, or leaves the plate without hold, an interior point method finds the states
that it goes on from (module `interior_point`). See docs/theory.md, contact.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NotConverged, SingularMatrix
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact, total
from groundslab.fem.sparse import Symmetric
from groundslab.solvers import interior_point
from groundslab.solvers.factor_reuse import Latest, Task

#: A way that is on the wrong side by less than this share of the largest one does not change a bearing, nor does a
#: force that would make such a way on the unknown's own stiffness, or is so small beside the largest force.
SLACK = 1e-10
#: The bearings that touch hold the plate if they resist each of its rigid motions by more than this share of what all
#: bearings together would.
HOLD = 1e-6
#: So many steps in which no fewer bearings are wrong than before, and the interior point method takes over: it needs
#: about as many again as a slow but steady iteration from here.
PATIENCE = 12
#: The interior point method has ended if no more than this share of the largest force is left over.
BALANCED = 1e-4
#: The latest factor may serve for so many steps of conjugate gradients: about what another factor costs.
STEPS = 8
#: If they lead to something so many times larger than where they began, the plate may float.
FAR = 10.0
#: Rounding is taken off in so many steps at most, until what is left over is this share of the largest force.
REFINEMENTS = 4
ROUNDED = 1e-11


def solve(
    A: Symmetric,
    f: Array,
    latest: Latest,
    bearings: Bearings,
    start: Integers,
    limit: int,
    report: Callable[[int, int, int], None],
    near: Array | None = None,
    motions: Array | None = None,
) -> Contact:
    """Return the solution of A u - f = forces of the bearings.

    start (c,) holds the states at first; near (size,) is what the solution is expected to be near; motions (size, m)
    are those of the plate as a rigid body, against which only the bearings hold it; report is told iteration, bearings
    that touch and changes. With no bearings this is one linear solution. Raises NotConverged after `limit` iterations,
    SingularMatrix if A itself, held by all bearings, is not positive.

    Where what touches in the end does not hold the plate, it returns one of many solutions, to some digits: that of the
    interior point method (see statics.require_hold).
    """
    b, hold = bearings, _Hold(bearings, motions)
    history: list[dict[str, int]] = []

    def count(states: Integers, changed: int) -> None:
        touching = int((states != OPEN).sum())
        history.append({"iteration": len(history) + 1, "closed": touching, "changed": changed})
        report(len(history), touching, changed)

    state, last = b.lasting(start), near
    progress, inside = _Progress(len(b)), None
    while len(history) < limit:
        found = _solved(A, f, b, state, latest, near) if hold.by(state) else None
        if found is not None:
            after = _next(A, b, found)
            wrong = after != state
            count(state, int(wrong.sum()))
            if not wrong.any():
                return _refined(found, b, latest)
            # close to a cycle decisions must not rest on what conjugate gradients leave over
            last, near = found.contact.u, found.contact.u if progress.made(state, wrong) else None
            state = after
            if inside is not None or not progress.lost:
                continue
        elif inside is not None:
            if _balanced(A, f, b, inside):
                return inside
            break
        inside = interior_point.solve(A, f, latest, b, count)
        state, last, near, progress = inside.state, inside.u, None, _Progress(len(b))
    raise NotConverged("the contact zone", history, {"u": last, "closed": state != OPEN})


def _balanced(A: Symmetric, f: Array, b: Bearings, found: Contact) -> bool:
    """Return whether the interior point method has come to an end: nothing is left over at unknowns free to move."""
    left = f - A @ found.u + total(b.at, b.sign * found.force, A.size)
    left[b.at[b.both_ways]] = 0.0
    return bool(np.abs(left).max(initial=0.0) <= BALANCED * max(np.abs(f).max(initial=0.0), np.abs(found.force).max()))


@dataclass(frozen=True, slots=True)
class _Solved:
    """The solution for given states of the bearings."""

    task: Task
    load: Array  # (size,): the given one, and what bearings give that are not rigid
    borne: Array  # (size,): the latter
    contact: Contact


def _solved(A: Symmetric, f: Array, b: Bearings, state: Integers, latest: Latest, near: Array | None) -> _Solved | None:
    """Return the solution for given states (c,), none if these do not hold the plate.

    near (size,) is what the solution is expected to be near: the latest factor may then serve, if its task is near too.
    """
    task, load = _arranged(A, f, b, state)

    def found(u: Array, left: Array) -> _Solved:
        return _Solved(task, load, load - f, Contact(u, state, _forces(b, state, u, load - f - left)))

    exact = latest.solves(task)
    if near is not None and not exact and latest.near(task):
        u = np.where(task.held, task.level, near)
        left = load - A @ u
        with suppress(SingularMatrix):  # then the factorisation tells
            if latest.improve(task, load, u, left, STEPS) and np.abs(u).max() <= FAR * np.abs(near).max():
                return found(u, left)
    if not exact:
        try:
            latest.factor(task)
        except SingularMatrix:
            return None
    u = task.level.copy()
    left = load - A @ u if u.any() else load.copy()
    latest.improve(task, load, u, left, 1)
    return found(u, left)


def _refined(s: _Solved, b: Bearings, latest: Latest) -> Contact:
    """Return a solution without the rounding of the factorisation."""
    A, u, before = s.task.A, s.contact.u.copy(), np.inf
    for _ in range(REFINEMENTS):
        left = s.load - A @ u
        rest = np.abs((left - s.task.added * u)[~s.task.held]).max(initial=0.0)
        if rest <= ROUNDED * np.abs(left).max(initial=0.0) or rest > before / 2:
            break
        before = rest
        latest.improve(s.task, s.load, u, left, 1)
    left = s.load - A @ u
    state = s.contact.state
    return Contact(u, state, _forces(b, state, u, s.borne - left))


def _forces(b: Bearings, state: Integers, u: Array, left_over: Array) -> Array:
    """Return the force of each bearing (c,); that of a rigid one is what the others leave over at its unknown."""
    rigid = np.isinf(b.stiffness)
    force = np.where(state == YIELDING, b.capacity, 0.0)
    elastic = np.flatnonzero((state == CLOSED) & ~rigid)
    force[elastic] = b.stiffness[elastic] * b.driven(u)[elastic]
    borne = total(b.at, b.sign * force, len(u))
    closed = np.flatnonzero((state == CLOSED) & rigid)
    force[closed] = b.sign[closed] * (left_over - borne)[b.at[closed]]
    return force


def _next(A: Symmetric, b: Bearings, found: _Solved) -> Integers:
    """Return the state (c,) in which each bearing should be, seen from the one that it is in."""
    u, state, force = found.contact.u, found.contact.state, found.contact.force
    driven, slack = b.driven(u), SLACK * np.abs(u).max()
    small = np.minimum(slack * A.diagonal[b.at], SLACK * np.abs(force).max(initial=0))
    full = np.zeros(len(b))  # way at which it yields
    elastic = np.isfinite(b.stiffness)
    full[elastic] = b.capacity[elastic] / b.stiffness[elastic]
    after = state.copy()
    after[(state == OPEN) & (driven > slack)] = CLOSED
    after[(state == CLOSED) & (force < -small)] = OPEN
    after[(state == CLOSED) & (force > b.capacity + small)] = YIELDING
    after[(state == YIELDING) & (driven < full - slack)] = CLOSED
    return b.lasting(after)


class _Hold:
    """Which bearings must touch so that the plate cannot move as a rigid body."""

    def __init__(self, b: Bearings, motions: Array | None) -> None:
        rows = np.zeros((len(b), 0)) if motions is None else motions[b.at]
        # coordinates in which all bearings together resist every motion alike
        self.rows = np.linalg.qr(rows)[0] if rows.any() else rows[:, :0]

    def by(self, state: Integers) -> bool:
        """Return whether the bearings (c,) that are closed hold the plate."""
        closed = self.rows[state == CLOSED]
        return closed.shape[1] == 0 or bool(np.linalg.eigvalsh(closed.T @ closed)[0] > HOLD**2)


class _Progress:
    """Whether the active set iteration comes nearer to its end."""

    def __init__(self, bearings: int) -> None:
        self.seen: set[bytes] = set()
        self.fewest = bearings + 1
        self.since = 0
        self.lost = False  # runs in a circle, or does not come nearer

    def made(self, state: Integers, wrong: Flags) -> bool:
        """Take note of states (c,) of which some are wrong; return whether these are fewer than ever before."""
        wrongs, key = int(wrong.sum()), state.astype(np.uint8).tobytes()
        nearer = wrongs < self.fewest
        self.since = 0 if nearer else self.since + 1
        self.lost = key in self.seen or self.since >= PATIENCE
        self.seen.add(key)
        self.fewest = min(self.fewest, wrongs)
        return nearer


def _arranged(A: Symmetric, f: Array, b: Bearings, state: Integers) -> tuple[Task, Array]:
    """Return what given states make of the problem: matrix, held unknowns with their values, and load (size,)."""
    rigid = (state == CLOSED) & np.isinf(b.stiffness)
    elastic = (state == CLOSED) & np.isfinite(b.stiffness)
    yielding = state == YIELDING
    added = total(b.at[elastic], b.stiffness[elastic], A.size)
    load = f + total(b.at[elastic], b.stiffness[elastic] * b.level[elastic], A.size)
    load += total(b.at[yielding], b.sign[yielding] * b.capacity[yielding], A.size)
    held, level = np.zeros(A.size, dtype=bool), np.zeros(A.size)
    held[b.at[rigid]] = True
    level[b.at[rigid]] = b.level[rigid]
    return Task(A, held, added, level), load
