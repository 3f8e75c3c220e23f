"""Unilateral contact: minimise 1/2 u.A u - f.u subject to u >= 0 for some unknowns, the gaps.

Primal-dual active set iteration (Hintermueller, Ito and Kunisch 2002), with the single pivots of Murty 1974 as the way
out of a cycle (Judice and Pires 1994), so that it ends for every positive definite A. See docs/theory.md, contact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.assembly import Pattern, multiply
from groundslab.errors import NotConverged, SingularMatrix
from groundslab.linear import Symbolic
from groundslab.shape import Array, Flags, Indices, Integers

#: A gap or force that is negative by less than this share of the largest one does not make a node change sides.
SLACK = 1e-10
#: Share of a gap's own stiffness that a spring across it gets while the closed gaps alone do not hold the plate.
WEAK = 1e-5


@dataclass(frozen=True, slots=True)
class Contact:
    """A solution: unknowns u (size,), which gaps are closed (c,), and the contact forces on them (c,) [N]."""

    u: Array
    closed: Flags
    force: Array


def solve(
    p: Pattern,
    data: Array,
    f: Array,
    symbolic: Symbolic,
    gaps: Integers,
    start: Flags,
    limit: int,
    report: Callable[[int, int, int], None],
) -> Contact:
    """Return the solution of A u - f = contact forces >= 0 on the gaps (c,), u >= 0 there, force times gap = 0.

    start (c,) says which gaps are closed at first; report is told iteration, closed gaps and changes. With no gaps this
    is one linear solution. Raises NotConverged after `limit` iterations, SingularMatrix if A itself is not positive.
    """
    row: Indices = np.repeat(np.arange(p.size, dtype=np.int32), np.diff(p.indptr))
    history: list[dict[str, int]] = []
    closed, pivots = start.copy(), _Pivots(len(gaps))
    u = np.zeros(p.size)
    spring = rest = no_spring = np.zeros(len(gaps))
    for iteration in range(1, limit + 1):
        try:
            u = _closed_solution(p, data, row, f, symbolic, gaps, closed, spring, rest)
        except SingularMatrix:
            if spring.any():
                raise
            # the plate floats: a proximal step, with springs that draw the gaps to where they are
            spring, rest, pivots = WEAK * data[p.indptr[gaps]], np.maximum(u[gaps], 0.0), _Pivots(len(gaps))
            u = _closed_solution(p, data, row, f, symbolic, gaps, closed, spring, rest)
        force = (multiply(p, data, u) - f)[gaps] + spring * (u[gaps] - rest)
        slack = SLACK * np.abs(u).max()
        wrong = np.where(closed, force < -SLACK * np.abs(force).max(initial=0), u[gaps] < -slack)
        history.append({"iteration": iteration, "closed": int(closed.sum()), "changed": int(wrong.sum())})
        report(iteration, int(closed.sum()), int(wrong.sum()))
        if wrong.any():
            closed = pivots.change(closed, wrong)
        elif (spring * (np.abs(u[gaps] - rest) > slack)).any():
            # enough gaps are closed now, or the next proximal step starts from here
            spring, pivots = no_spring, _Pivots(len(gaps))
        else:
            # no springs, or springs that move nothing and so carry nothing: a plate balanced without being held
            return Contact(u, closed, np.where(closed, force, 0.0))
    raise NotConverged("the contact zone", history, {"u": u, "closed": closed})


class _Pivots:
    """Which wrong gaps change sides: all of them, or, once a set of closed gaps has come back, the last one alone.

    Back to all of them when fewer are wrong than ever before (Judice and Pires 1994).
    """

    def __init__(self, gaps: int) -> None:
        self.seen: set[bytes] = set()
        self.fewest = gaps + 1
        self.single = False

    def change(self, closed: Flags, wrong: Flags) -> Flags:
        """Return the gaps to close next."""
        wrongs, key = int(wrong.sum()), np.packbits(closed).tobytes()
        if key in self.seen and not self.single:
            self.single, self.fewest = True, min(self.fewest, wrongs)
        elif wrongs < self.fewest:
            self.single, self.fewest = False, wrongs
        self.seen.add(key)
        if self.single:
            wrong = np.arange(len(wrong)) == np.flatnonzero(wrong)[-1]
        return closed ^ wrong


def _closed_solution(
    p: Pattern,
    data: Array,
    row: Indices,
    f: Array,
    symbolic: Symbolic,
    gaps: Integers,
    closed: Flags,
    spring: Array,
    rest: Array,
) -> Array:
    """Return the solution with some gaps held closed, and springs (c,) that draw the others to their rest (c,)."""
    keep = np.ones(p.size)
    keep[gaps[closed]] = 0.0
    held = data * keep[row] * keep[p.indices] if closed.any() else data.copy()
    diagonal = p.indptr[gaps]
    held[diagonal] = data[diagonal] + spring
    load = f.copy()
    load[gaps] += spring * rest
    return symbolic.factor(held).solve(load * keep)
