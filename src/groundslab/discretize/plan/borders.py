"""Borders of soil zones and voids: which of them a mesh can follow."""

from __future__ import annotations

import functools
import re
from bisect import bisect
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import FLAT, SAME_PLACE, Plan, Ring
from groundslab.geometry.validity import TOO_CLOSE, find_issues

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

#: So many borders are followed at most: a line of a grid for each side of more would be no mesh for a plate.
MOST_BORDERS = 200


@functools.lru_cache(maxsize=64)
def add_borders(plan: Plan, rings: tuple[Ring, ...]) -> Plan:
    """Return a plan with those borders that a mesh can follow.

    Borders are cut off where nothing is meshed. Those along x and y are moved onto lines of the plan, or of earlier
    borders, that are too close to leave a strip to mesh. A border is left out if it is finer than what can be meshed,
    grazes another curve, or is oblique or curved where nothing but grids can be made, see `area_shares`; so are those
    after the first two hundred.
    """
    from groundslab import meshing

    kept: list[Ring] = []
    lines = _coordinates(plan)
    curved = not plan.rectilinear or meshing.available()
    domain = plan.domain_polygon(FLAT * plan.extent)
    for ring in (part for border in rings[:MOST_BORDERS] for part in _clip(border, plan, domain)):
        moved = _move(ring, lines, TOO_CLOSE * plan.extent) if ring.rectilinear else ring
        if _coarse_enough(moved, plan) and (curved or moved.rectilinear):
            kept.append(moved)
    while kept:
        trial = replace(plan, borders=tuple(kept))
        refused = {max(map(int, named)) for issue in find_issues(trial)
                   if (named := re.findall(r"borders\[(\d+)\]", f"{issue.location} {issue.found}"))}  # fmt: skip
        if not refused:
            return trial
        kept = [ring for number, ring in enumerate(kept, start=1) if number not in refused]
    return plan


def _coordinates(plan: Plan) -> tuple[list[float], list[float]]:
    """Return x and y of all corners and points of a plan."""
    places = [point for ring in plan.rings().values() for point in ring.points]
    places += [*plan.points, *(point for line in plan.lines for point in line)]
    return sorted(x for x, _ in places), sorted(y for _, y in places)


def _clip(ring: Ring, plan: Plan, domain: Polygon | MultiPolygon) -> list[Ring]:
    """Return the curves around what of a ring is meshed; one with arcs, or on a curved domain, as it is."""
    import shapely

    chord = FLAT * plan.extent
    polygon = ring.polygon(chord)
    if not polygon.is_valid or not polygon.boundary.intersects(domain.buffer(-2 * chord)):
        return []
    edge = plan.outlines if plan.beyond is None else (plan.beyond,)
    if not (ring.straight and all(outline.straight for outline in edge)) or domain.contains(polygon):
        return [ring]
    parts = shapely.get_parts(polygon.intersection(domain))
    return [_ring_around(part) for part in parts if part.geom_type == "Polygon" and part.area > 0]


def _ring_around(part: object) -> Ring:
    """Return the curve around a polygon, without points on a straight line between two others."""
    import shapely

    places = shapely.get_coordinates(shapely.get_exterior_ring(part))[:-1]
    before, after = places - np.roll(places, 1, axis=0), np.roll(places, -1, axis=0) - places
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    corner = np.abs(turn) > SAME_PLACE * np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    return Ring(tuple((float(x), float(y)) for x, y in places[corner]))


def _move(ring: Ring, lines: tuple[list[float], list[float]], near: float) -> Ring:
    """Return a ring along x and y, moved onto lines (ascending) nearer than `near` [m]; what is not becomes a line."""
    moved = []
    for place in ring.points:
        coordinates = []
        for ascending, value in zip(lines, place, strict=True):
            after = bisect(ascending, value)
            nearest = min(ascending[max(after - 1, 0) : after + 1], key=lambda line: abs(line - value))
            if abs(nearest - value) >= near:
                nearest = value
                ascending.insert(after, value)
            coordinates.append(nearest)
        moved.append((coordinates[0], coordinates[1]))
    return Ring(tuple(moved))


def _coarse_enough(ring: Ring, plan: Plan) -> bool:
    """Return whether a border is nowhere finer than what can be meshed."""
    least = TOO_CLOSE * plan.extent
    if len(ring.points) < (3 if ring.straight else 2) or any(edge.length < least for edge in ring.segments()):
        return False
    polygon = ring.polygon(FLAT * plan.extent)
    return bool(polygon.is_valid and not polygon.buffer(-least / 2).is_empty)


def on_lines(ring: Ring, lines: tuple[Array, Array], domain: tuple[tuple[float, float], tuple[float, float]]) -> bool:
    """Return whether a ring runs along lines of a grid (x and y) wherever it lies inside a domain (x and y)."""
    if not ring.rectilinear:
        return False
    for edge in ring.segments():
        axis = 0 if edge.start[0] == edge.end[0] else 1
        value = edge.start[axis]
        near = SAME_PLACE * max(high - low for low, high in domain)
        low, high = domain[axis]
        if low + near < value < high - near and np.abs(lines[axis] - value).min() > near:
            return False
    return True
