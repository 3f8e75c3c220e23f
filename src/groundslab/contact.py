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
    closed = start.copy()
    seen: set[bytes] = set()
    fewest = len(gaps) + 1
    single = False
    history: list[dict[str, int]] = []
    u = np.zeros(p.size)
    spring = rest = np.zeros(len(gaps))
    for iteration in range(1, limit + 1):
        try:
            u = _closed_solution(p, data, row, f, symbolic, gaps, closed, spring, rest)
        except SingularMatrix:
            if spring.any():
                raise
            # the plate floats: a proximal step, with springs that draw the gaps to where they are
            spring, rest = WEAK * data[p.indptr[gaps]], np.maximum(u[gaps], 0.0)
            seen, single, fewest = set(), False, len(gaps) + 1
            u = _closed_solution(p, data, row, f, symbolic, gaps, closed, spring, rest)
        force = (multiply(p, data, u) - f)[gaps] + spring * (u[gaps] - rest)
        wrong = np.where(closed, force < -SLACK * np.abs(force).max(initial=0), u[gaps] < -SLACK * np.abs(u).max())
        wrongs = int(wrong.sum())
        history.append({"iteration": iteration, "closed": int(closed.sum()), "changed": wrongs})
        report(iteration, int(closed.sum()), wrongs)
        # springs that no longer move anything carry nothing: the plate is balanced without being held
        if wrongs == 0 and not (spring * (np.abs(u[gaps] - rest) > SLACK * np.abs(u).max())).any():
            return Contact(u, closed, np.where(closed, force, 0.0))
        if wrongs == 0:
            # enough gaps are closed now, or the next proximal step starts from here
            spring, seen, single, fewest = np.zeros(len(gaps)), set(), False, len(gaps) + 1
            continue
        key = np.packbits(closed).tobytes()
        if key in seen and not single:
            single, fewest = True, min(fewest, wrongs)
        elif wrongs < fewest:
            single, fewest = False, wrongs
        seen.add(key)
        closed = closed ^ (_last_only(wrong) if single else wrong)
    raise NotConverged("the contact zone", history, {"u": u, "closed": closed})


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


def _last_only(wrong: Flags) -> Flags:
    """Return wrong with only its last entry left."""
    one = np.zeros_like(wrong)
    one[np.flatnonzero(wrong)[-1]] = True
    return one
