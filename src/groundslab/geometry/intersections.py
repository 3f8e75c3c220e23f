"""Intersections of edges, and of curves with themselves or each other."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from groundslab.geometry.plan import Place, Segment
from groundslab.geometry.regions import Region, Spend

#: Of so few edges all are compared with each other.
FEW = 8


def find_crossings(e: Segment, f: Segment) -> list[Place]:
    """Return the places at which the unbounded lines or full circles of two edges cross."""
    if e.straight and f.straight:
        return _cross_lines(e, f)
    if f.straight:
        return find_crossings(f, e)
    (cx, cy), r = f.centre, f.radius
    if e.straight:
        (x, y), ux, uy = e.start, *_direction(e)
        along = (cx - x) * ux + (cy - y) * uy
        foot, across = (x + along * ux, y + along * uy), (ux, uy)
        square = r**2 - math.dist(f.centre, foot) ** 2
    else:
        apart = math.dist(e.centre, f.centre)
        if apart <= 1e-12 * (e.radius + r):
            return []
        (x, y), along = e.centre, (apart**2 + e.radius**2 - r**2) / (2 * apart)
        ux, uy = (cx - x) / apart, (cy - y) / apart
        foot, across = (x + along * ux, y + along * uy), (-uy, ux)
        square = e.radius**2 - along**2
    if square < 0:
        return []
    half = math.sqrt(square)
    return [(foot[0] + way * across[0], foot[1] + way * across[1]) for way in (-half, half)]


def _direction(edge: Segment) -> tuple[float, float]:
    """Return the unit vector along a straight edge."""
    return (edge.end[0] - edge.start[0]) / edge.length, (edge.end[1] - edge.start[1]) / edge.length


def _cross_lines(e: Segment, f: Segment) -> list[Place]:
    """Return the place at which two lines cross, none of parallel ones."""
    (x, y), ux, uy = e.start, *_direction(e)
    fx, fy = f.end[0] - f.start[0], f.end[1] - f.start[1]
    turn = ux * fy - uy * fx
    if abs(turn) <= 1e-12 * math.hypot(fx, fy):
        return []
    along = ((f.start[0] - x) * fy - (f.start[1] - y) * fx) / turn
    return [(x + along * ux, y + along * uy)]


def _meeting(e: Segment, f: Segment, tolerance: float) -> Place | None:
    """Return a place that two edges share, besides an end that they have in common."""
    ends = e.start, e.end, f.start, f.end
    shared = {e.start, e.end} & {f.start, f.end}
    # An arc that leaves a line as its tangent crosses it again nearby, by rounding.
    blur = max(tolerance, 0.01 * min(math.dist(e.start, e.end), math.dist(f.start, f.end)))
    candidates = [(place, tolerance) for place in (*ends, e.middle, f.middle)]
    candidates += [(place, blur) for place in find_crossings(e, f)]
    for place, radius in candidates:
        if any(math.dist(place, end) <= radius for end in shared):
            continue
        if e.holds(place, tolerance) and f.holds(place, tolerance):
            return place
    return None


def find_self_meeting(curve: Sequence[Segment], tolerance: float, spend: Spend) -> Place | None:
    """Return a place at which a curve meets itself."""
    twice = [place for place, count in Counter(edge.start for edge in curve).items() if count > 1]
    if twice:
        return twice[0]
    edges = sorted(curve, key=lambda edge: edge.bounds)
    region = Region(edges) if len(edges) > FEW else None
    for number, edge in enumerate(edges):
        near = range(number) if region is None else [k for k in region.find_near(edge, tolerance) if k < number]
        place = _first_meeting(edge, [edges[k] for k in near], tolerance, spend)
        if place is not None:
            return place
    return None


def find_meeting(region: Region, other: Sequence[Segment], tolerance: float, spend: Spend) -> Place | None:
    """Return a place at which two curves meet."""
    for edge in other:
        near = [region.edges[k] for k in region.find_near(edge, tolerance)]
        place = _first_meeting(edge, near, tolerance, spend)
        if place is not None:
            return place
    return None


def _first_meeting(edge: Segment, others: Sequence[Segment], tolerance: float, spend: Spend) -> Place | None:
    """Return a place at which an edge meets one of others."""
    spend(len(others))
    meetings = (_meeting(other, edge, tolerance) for other in others)
    return next((place for place in meetings if place is not None), None)
