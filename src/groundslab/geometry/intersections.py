"""Intersections of edges, and of curves with themselves or each other."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from groundslab.geometry.bulges import Edge, Point, Region, Spend

#: Of so few edges all are compared with each other.
FEW = 8


def find_crossings(e: Edge, f: Edge) -> list[Point]:
    """Return the points at which the unbounded lines or full circles of two edges cross."""
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
        return find_crossings(f, e)
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
    candidates = [(point, tolerance) for point in ends] + [(point, blur) for point in find_crossings(e, f)]
    for point, radius in candidates:
        if any(math.dist(point, end) <= radius for end in shared):
            continue
        if e.holds(point, tolerance) and f.holds(point, tolerance):
            return point
    return None


def find_self_meeting(one: Sequence[Edge], tolerance: float, spend: Spend) -> Point | None:
    """Return a point at which a curve meets itself."""
    twice = [point for point, count in Counter(edge.a for edge in one).items() if count > 1]
    if twice:
        return twice[0]
    edges = sorted(one, key=lambda edge: edge.box())
    region = Region(edges) if len(edges) > FEW else None
    for number, edge in enumerate(edges):
        others = range(number) if region is None else [k for k in _near(region, edge, tolerance) if k < number]
        spend(len(others))
        for k in others:
            point = _meeting(edges[k], edge, tolerance)
            if point is not None:
                return point
    return None


def find_meeting(one: Region, other: Sequence[Edge], tolerance: float, spend: Spend) -> Point | None:
    """Return a point at which two curves meet."""
    for edge in other:
        near = _near(one, edge, tolerance)
        spend(len(near))
        for k in near:
            point = _meeting(one.edges[k], edge, tolerance)
            if point is not None:
                return point
    return None


def _near(region: Region, edge: Edge, tolerance: float) -> list[int]:
    """Return the numbers of edges whose boxes come near that of an edge."""
    from shapely import box

    x0, y0, x1, y1 = edge.box()
    found = region.tree.query(box(x0 - tolerance, y0 - tolerance, x1 + tolerance, y1 + tolerance))
    return sorted(found.tolist())
