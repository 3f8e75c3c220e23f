"""Unilateral contact: minimise 1/2 u.A u - f.u with bearings that push on some unknowns one way only.

A bearing on the unknown u_i, with sign s, level l, stiffness k (infinite if rigid) and capacity F, is driven in by
d = s (l - u_i) and pushes u_i in the direction s with the force clip(k d, 0, F). The ground's gap is a rigid bearing
with s = 1 and l = 0: u >= 0, force >= 0, force times u = 0, and with a capacity the force that yields.

Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2002), with the single pivots of Murty 1974 as the way
out of a cycle (Judice and Pires 1994), so that it ends for every positive definite A. See docs/theory.md, contact.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from groundslab.errors import NotConverged, SingularMatrix
from groundslab.linear import Latest, Task
from groundslab.shape import Array, Flags, Integers
from groundslab.symmetric import Symmetric

#: A way or force that is on the wrong side by less than this share of the largest one does not change a bearing.
SLACK = 1e-10
#: Share of an unknown's own stiffness that a spring on it gets while the closed bearings do not hold the plate.
WEAK = 1e-5
#: A way that is more than so many times what a force as large as the largest load gives on an unknown's own stiffness
#: is that of a plate that floats.
ADRIFT = 1e9

#: The latest factor may serve for so many steps of conjugate gradients: about what another factor costs.
STEPS = 8
#: If they lead to something so many times larger than where they began, the plate may float.
FAR = 10.0

#: States of a bearing: it touches nothing, it bears, it has reached its capacity.
OPEN, CLOSED, YIELDING = range(3)


@dataclass(frozen=True, slots=True)
class Bearings:
    """What bears on one unknown each, (c,); the unknown's unit is m or rad, the force's N or N m."""

    at: Integers  # number of the unknown
    sign: Array  # 1.0 or -1.0: the direction of the force
    level: Array  # value of the unknown at which it begins to bear
    stiffness: Array  # force per way; infinite if rigid
    capacity: Array  # largest force; infinite if there is none
    both_ways: Flags  # closed for ever, whatever the sign of the force

    def __len__(self) -> int:
        """Return the number of bearings."""
        return len(self.at)

    def driven(self, u: Array) -> Array:
        """Return how far each is driven in, d (c,)."""
        d: Array = self.sign * (self.level - u[self.at])
        return d


#: All that is known of a bearing but the unknown on which it bears.
LAWS = ("sign", "level", "stiffness", "capacity", "both_ways")


def gaps(at: Integers) -> Bearings:
    """Return the bearings of gaps: unknowns that are at least 0 and are pushed, never pulled."""
    one, without_end = np.ones(len(at)), np.full(len(at), np.inf)
    return Bearings(at, one, 0 * one, without_end, without_end, np.zeros(len(at), dtype=bool))


def joined(*parts: Bearings) -> Bearings:
    """Return the bearings of several parts as one list."""
    return Bearings(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("at", *LAWS)))


@dataclass(frozen=True, slots=True)
class Contact:
    """A solution: unknowns u (size,), states of the bearings (c,), and their forces (c,), >= 0 unless both ways."""

    u: Array
    state: Integers
    force: Array

    @property
    def closed(self) -> Flags:
        """Return which bearings touch (c,), be it that they yield."""
        touching: Flags = self.state != OPEN
        return touching


def slipped(b: Bearings, c: Contact) -> Array:
    """Return how far each bearing (c,) has slipped at its capacity."""
    elastic = np.isfinite(b.stiffness)
    way = b.driven(c.u)
    way[elastic] -= c.force[elastic] / b.stiffness[elastic]
    return np.where(c.state == YIELDING, np.maximum(way, 0.0), 0.0)


def solve(
    A: Symmetric,
    f: Array,
    latest: Latest,
    bearings: Bearings,
    start: Integers,
    limit: int,
    report: Callable[[int, int, int], None],
    near: Array | None = None,
) -> Contact:
    """Return the solution of A u - f = forces of the bearings.

    start (c,) holds the states at first; near (size,) is what the solution is expected to be near; report is told
    iteration, bearings that touch and changes. With no bearings this is one linear solution. Raises NotConverged after
    `limit` iterations, SingularMatrix if A itself, held by all bearings, is not positive.
    """
    b = bearings
    history: list[dict[str, int]] = []
    state, pivots = np.where(b.both_ways, CLOSED, start), _Pivots(len(b))
    spring = rest = no_spring = np.zeros(len(b))
    u, fewest = near, len(b) + 1
    for iteration in range(1, limit + 1):
        held = _arranged(A, f, b, state, spring, rest)
        try:
            u, left, settled = _solution(held, b, latest, near, floats=bool(spring.any()))
        except SingularMatrix:
            if spring.any():
                raise
            # the plate floats: a proximal step, with springs that draw the bearings to where they are
            u = np.zeros(A.size) if u is None else u
            spring, rest = WEAK * A.diagonal[b.at], b.level + b.sign * np.maximum(-b.driven(u), 0.0)
            pivots = _Pivots(len(b))
            held = _arranged(A, f, b, state, spring, rest)
            u, left, settled = _solution(held, b, latest, None, floats=True)
        force = _forces(b, state, u, held.load - f - left, spring * (u[b.at] - rest))
        slack = SLACK * np.abs(u).max()
        after = np.where(b.both_ways, CLOSED, _next(b, state, b.driven(u), force, slack))
        wrong: Flags = after != state
        touching = int(((state != OPEN) & (b.capacity > 0)).sum())
        history.append({"iteration": iteration, "closed": touching, "changed": int(wrong.sum())})
        report(iteration, touching, int(wrong.sum()))
        # close to a cycle, or to floating, decisions must not rest on what conjugate gradients leave over
        near = u if wrong.sum() < fewest and not spring.any() else None
        fewest = min(fewest, int(wrong.sum()))
        if wrong.any():
            state = pivots.change(state, after)
        elif (spring * (np.abs(u[b.at] - rest) > slack)).any():
            # enough bearings touch now, or the next proximal step starts from here
            spring, pivots, near = no_spring, _Pivots(len(b)), None
        else:
            # no springs, or springs that move nothing and so carry nothing: a plate balanced without being held
            if not settled:
                # one step more takes off the rounding of the factorisation
                left = held.load - A @ u
                latest.improve(held.task, held.load, u, left, 1)
            return Contact(u, state, _forces(b, state, u, held.load - f - left, 0.0 * spring))
    raise NotConverged("the contact zone", history, {"u": u, "closed": state != OPEN})


def _forces(b: Bearings, state: Integers, u: Array, left_over: Array, spring: Array) -> Array:
    """Return the force of each bearing (c,); that of a rigid one is what the others leave over at its unknown."""
    rigid = np.isinf(b.stiffness)
    force = np.where(state == YIELDING, b.capacity, 0.0)
    elastic = np.flatnonzero((state == CLOSED) & ~rigid)
    force[elastic] = b.stiffness[elastic] * b.driven(u)[elastic]
    borne = np.zeros(len(u))
    np.add.at(borne, b.at, b.sign * force)
    closed = np.flatnonzero((state == CLOSED) & rigid)
    at = b.at[closed]
    force[closed] = b.sign[closed] * (left_over[at] - borne[at] + spring[closed])
    return force


def _next(b: Bearings, state: Integers, driven: Array, force: Array, slack: float) -> Integers:
    """Return the state (c,) in which each bearing should be, seen from the one that it is in."""
    small = SLACK * np.abs(force).max(initial=0)
    full = np.zeros(len(b))  # way at which it yields
    elastic = np.isfinite(b.stiffness)
    full[elastic] = b.capacity[elastic] / b.stiffness[elastic]
    after = state.copy()
    after[(state == OPEN) & (driven > slack)] = CLOSED
    after[(state == CLOSED) & (force < -small)] = OPEN
    after[(state == CLOSED) & (force > b.capacity + small)] = YIELDING
    after[(state == YIELDING) & (driven < full - slack)] = CLOSED
    return after


class _Pivots:
    """Which wrong bearings change: all of them, or, once a set of states has come back, the last one alone.

    Back to all of them when fewer are wrong than ever before (Judice and Pires 1994).
    """

    def __init__(self, bearings: int) -> None:
        self.seen: set[bytes] = set()
        self.fewest = bearings + 1
        self.single = False

    def change(self, state: Integers, wanted: Integers) -> Integers:
        """Return the states to take next."""
        wrong = state != wanted
        wrongs, key = int(wrong.sum()), state.astype(np.uint8).tobytes()
        if key in self.seen and not self.single:
            self.single, self.fewest = True, min(self.fewest, wrongs)
        elif wrongs < self.fewest:
            self.single, self.fewest = False, wrongs
        self.seen.add(key)
        if self.single:
            wrong = np.arange(len(wrong)) == np.flatnonzero(wrong)[-1]
        after: Integers = np.where(wrong, wanted, state)
        return after


@dataclass(frozen=True, slots=True)
class _Held:
    """What is to be solved for given states of the bearings."""

    task: Task
    level: Array  # (size,): the values of held unknowns, zero elsewhere
    load: Array  # (size,): f, and what the bearings give that are not rigid


def _arranged(A: Symmetric, f: Array, b: Bearings, state: Integers, spring: Array, rest: Array) -> _Held:
    """Return what given states make of the problem, and springs (c,) that draw unknowns to their rest (c,)."""
    rigid = (state == CLOSED) & np.isinf(b.stiffness)
    elastic = (state == CLOSED) & np.isfinite(b.stiffness)
    added, load = np.zeros(A.size), f.copy()
    np.add.at(added, b.at, spring)
    np.add.at(load, b.at, spring * rest)
    np.add.at(added, b.at[elastic], b.stiffness[elastic])
    np.add.at(load, b.at[elastic], b.stiffness[elastic] * b.level[elastic])
    yielding = state == YIELDING
    np.add.at(load, b.at[yielding], b.sign[yielding] * b.capacity[yielding])
    held, level = np.zeros(A.size, dtype=bool), np.zeros(A.size)
    held[b.at[rigid]] = True
    level[b.at[rigid]] = b.level[rigid]
    return _Held(Task(A, held, added), level, load)


def _solution(h: _Held, b: Bearings, latest: Latest, near: Array | None, floats: bool) -> tuple[Array, Array, bool]:
    """Return the solution u (size,) for given states, and load - A u (size,), what that leaves to rigid bearings.

    And whether rounding has been taken off already.

    near (size,) is what the solution is expected to be near: the latest factor may then serve, if its task is near too.
    Raises SingularMatrix if the plate floats, unless it may.
    """
    A, exact = h.task.A, latest.solves(h.task)
    if near is not None and not exact and latest.near(h.task):
        u = np.where(h.task.held, h.level, near)
        left = h.load - A @ u
        with suppress(SingularMatrix):  # then the factorisation tells
            if latest.improve(h.task, h.load, u, left, STEPS) and np.abs(u).max() <= FAR * np.abs(near).max():
                return u, left, True
    if not exact:
        latest.factor(h.task)
    u = h.level.copy()
    left = h.load - A @ u if u.any() else h.load.copy()
    driving = np.abs(left[~h.task.held]).max(initial=0.0)
    latest.improve(h.task, h.load, u, left, 1)
    # rounding can make a matrix that is singular look positive: the plate then floats away all the same
    if len(b) and not floats:
        free = ~h.task.held[b.at]
        if (np.abs(u[b.at]) * (A.diagonal + h.task.added)[b.at])[free].max(initial=0.0) > ADRIFT * driving:
            raise SingularMatrix("the bearings that touch do not hold the plate")
    return u, left, False
