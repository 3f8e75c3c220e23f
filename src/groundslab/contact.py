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
    before = np.ones_like(closed)
    u = np.zeros(p.size)
    for iteration in range(1, limit + 1):
        closed, u = _closed_solution(p, data, row, f, symbolic, gaps, closed, before)
        force = (multiply(p, data, u) - f)[gaps]
        wrong = np.where(closed, force < -SLACK * np.abs(force).max(initial=0), u[gaps] < -SLACK * np.abs(u).max())
        wrongs = int(wrong.sum())
        history.append({"iteration": iteration, "closed": int(closed.sum()), "changed": wrongs})
        report(iteration, int(closed.sum()), wrongs)
        if wrongs == 0:
            return Contact(u, closed, np.where(closed, force, 0.0))
        key = np.packbits(closed).tobytes()
        if key in seen and not single:
            single, fewest = True, wrongs
        elif wrongs < fewest:
            single, fewest = False, wrongs
        seen.add(key)
        before = closed
        closed = closed ^ (_last_only(wrong) if single else wrong)
    raise NotConverged("the contact zone", history, {"u": u, "closed": closed})


def _closed_solution(
    p: Pattern, data: Array, row: Indices, f: Array, symbolic: Symbolic, gaps: Integers, closed: Flags, before: Flags
) -> tuple[Flags, Array]:
    """Return the gaps held closed and the solution with them.

    If they are too few to hold the plate, half of those just opened are closed again, until they are enough.
    """
    while True:
        keep = np.ones(p.size)
        keep[gaps[closed]] = 0.0
        held = data * keep[row] * keep[p.indices] if closed.any() else data.copy()
        diagonal = p.indptr[gaps[closed]]
        held[diagonal] = data[diagonal]
        try:
            return closed, symbolic.factor(held).solve(f * keep)
        except SingularMatrix:
            opened = np.flatnonzero(before & ~closed)
            if len(opened) == 0:
                raise
            closed = closed.copy()
            closed[opened[: (len(opened) + 1) // 2]] = True


def _last_only(wrong: Flags) -> Flags:
    """Return wrong with only its last entry left."""
    one = np.zeros_like(wrong)
    one[np.flatnonzero(wrong)[-1]] = True
    return one
