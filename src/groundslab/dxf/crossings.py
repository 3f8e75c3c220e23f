"""Whether and where curves meet themselves or each other."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from groundslab.dxf.curves import Edge, Point


def crossings(e: Edge, f: Edge) -> list[Point]:
    """Return the points at which the whole lines or circles of two edges cross."""
    if e.bulge and f.bulge:
        (c, r), (d, s) = e.circle(), f.circle()
        apart = math.dist(c, d)
        if apart <= 1e-12 * (r + s):
            return []
        along = (apart**2 + r**2 - s**2) / (2 * apart)
        ux, uy = (d[0] - c[0]) / apart, (d[1] - c[1]) / apart
        foot, square = (c[0] + along * ux, c[1] + along * uy), r**2 - along**2
        across = (-uy, ux)
    elif e.bulge:
        return crossings(f, e)
    else:
        dx, dy = e.b[0] - e.a[0], e.b[1] - e.a[1]
        length = math.hypot(dx, dy)
        across = dx / length, dy / length
        if not f.bulge:
            fx, fy = f.b[0] - f.a[0], f.b[1] - f.a[1]
            turn = across[0] * fy - across[1] * fx
            if abs(turn) <= 1e-12 * math.hypot(fx, fy):
                return []
            along = ((f.a[0] - e.a[0]) * fy - (f.a[1] - e.a[1]) * fx) / turn
            return [(e.a[0] + along * across[0], e.a[1] + along * across[1])]
        c, r = f.circle()
        along = (c[0] - e.a[0]) * across[0] + (c[1] - e.a[1]) * across[1]
        foot = e.a[0] + along * across[0], e.a[1] + along * across[1]
        square = r**2 - math.dist(c, foot) ** 2
    if square < 0:
        return []
    half = math.sqrt(square)
    return [(foot[0] + sign * half * across[0], foot[1] + sign * half * across[1]) for sign in (-1, 1)]


def _meeting(e: Edge, f: Edge, tolerance: float) -> Point | None:
    """Return a point that two edges share, besides an end that they have in common."""
    shared = {e.a, e.b} & {f.a, f.b}
    # An arc that leaves a line as its tangent crosses it again nearby, by rounding.
    blur = max(tolerance, 0.01 * min(math.dist(e.a, e.b), math.dist(f.a, f.b)))
    ends = [point for point in (*e[:2], *f[:2], e.middle(), f.middle()) if point not in shared]
    candidates = [(point, tolerance) for point in ends] + [(point, blur) for point in crossings(e, f)]
    for point, radius in candidates:
        if any(math.dist(point, end) <= radius for end in shared):
            continue
        if e.holds(point, tolerance) and f.holds(point, tolerance):
            return point
    return None


def first_meeting(one: Sequence[Edge], other: Sequence[Edge] | None, tolerance: float) -> Point | None:
    """Return a point at which two curves meet, or, without another, at which a curve meets itself."""
    if other is None:
        twice = [point for point, count in Counter(edge.a for edge in one).items() if count > 1]
        if twice:
            return twice[0]
    both = [(edge.box(), edge, 0) for edge in one] + [(edge.box(), edge, 1) for edge in other or ()]
    both.sort(key=lambda each: each[0])
    active: list[tuple[tuple[float, float, float, float], Edge, int]] = []
    for box, edge, group in both:
        active = [each for each in active if each[0][2] >= box[0] - tolerance]
        for far, neighbour, its_group in active:
            apart = far[1] > box[3] + tolerance or far[3] < box[1] - tolerance
            if not apart and (other is None or group != its_group):
                point = _meeting(neighbour, edge, tolerance)
                if point is not None:
                    return point
        active.append((box, edge, group))
    return None
