"""Validity of a plan for meshing: curves that cross, parts too close, angles too sharp."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.errors import Issue
from groundslab.geometry.places import same_place_in
from groundslab.geometry.plan import FLAT, Place, Plan, Ring, Segment, flatten, format_place

if TYPE_CHECKING:
    from shapely import Polygon

#: Edges shorter than this, relative to the extent, have no length.
NO_LENGTH = 1e-6
#: What is closer than this, relative to the extent, without touching leaves a strip too narrow to mesh.
TOO_CLOSE = 1e-3
#: Edges of different curves that come together more often than this leave nothing of a plate to be meshed.
MOST_MEETINGS = 50_000
#: Two edges that meet at less than this angle [rad] leave a corner too sharp to mesh.
TOO_SHARP = math.radians(5)


def find_issues(plan: Plan) -> list[Issue]:
    """Return all issues that keep a plan from being meshed, each with its place."""
    issues = list(_find_number_issues(plan))
    if issues:
        return issues
    rings = plan.rings()
    for name, ring in rings.items():
        issues += _find_ring_issues(name, ring, plan.extent)
    issues += _find_line_issues(plan)
    if issues:
        return issues
    flat = {name: ring.polygon(FLAT * plan.extent) for name, ring in rings.items()}
    issues += _find_opening_issues(plan, flat)
    issues += _find_zone_issues(plan, flat)
    if not issues:
        issues += _find_place_issues(plan, flat)
        issues += _find_near_misses(plan)
        issues += _find_narrow_wedges(plan)
    return issues


def _find_number_issues(plan: Plan) -> Iterator[Issue]:
    """Yield values that are not finite, and curves of too few points."""
    for name, ring in plan.rings().items():
        least = 3 if ring.straight else 2
        if len(ring.points) < least:
            wanted = "at least 3, or 2 where an edge is an arc"
            yield Issue(name, f"{len(ring.points)} points", wanted, "a closed curve needs them")
        if len(ring.bulges) > len(ring.points):
            yield Issue(name, f"{len(ring.bulges)} bulges", "at most one for each point", "leave the rest out")
        if not np.isfinite([value for point in ring.points for value in point] + list(ring.bulges)).all():
            yield Issue(name, "a coordinate or bulge that is not finite", "numbers")
    for i, (_, number) in enumerate(plan.zones, start=1):
        if number < 1:
            yield Issue(f"plate.zones[{i}]", f"section {number}", "a number from 1", "0 is the plate's own section")
    for i, point in enumerate(plan.points, start=1):
        if not np.isfinite(point).all():
            yield Issue(f"plate.points[{i}]", "a coordinate that is not finite", "numbers")
    for i, line in enumerate(plan.lines, start=1):
        if len(line) < 2 or not np.isfinite(line).all():
            yield Issue(f"plate.lines[{i}]", "no line", "at least 2 points with finite coordinates")


def _find_ring_issues(name: str, ring: Ring, extent: float) -> Iterator[Issue]:
    """Yield issues of a single ring."""
    import shapely

    edges = ring.segments()
    short = [edge for edge in edges if edge.length <= NO_LENGTH * extent]
    for edge in short:
        zero_edge = f"an edge without length at {format_place(edge.start)}"
        yield Issue(name, zero_edge, "points apart from each other", "leave one out")
    if short:
        return
    polygon = ring.polygon(FLAT * extent)
    if not polygon.is_valid:
        said = re.search(r"\[(\S+) (\S+)\]", shapely.is_valid_reason(polygon))
        place = f" at {format_place((float(said[1]), float(said[2])))}" if said else ""
        yield Issue(name, f"a curve that crosses or touches itself{place}", "one that does not", "move a point")
        return
    for before, after in zip(edges, edges[1:] + edges[:1], strict=True):
        turn = (after.direction(0.0) - before.direction(1.0)) % (2 * math.pi)
        angle = abs(math.pi - turn)
        if angle < TOO_SHARP:
            sharp_corner = f"an angle of {math.degrees(angle):.2g} degrees at {format_place(after.start)}"
            yield Issue(name, sharp_corner, f"at least {math.degrees(TOO_SHARP):.0f} degrees", "cut the corner off")


def _find_line_issues(plan: Plan) -> Iterator[Issue]:
    for i, line in enumerate(plan.lines, start=1):
        for a, b in pairwise(line):
            if math.dist(a, b) <= NO_LENGTH * plan.extent:
                zero_piece = f"a piece without length at {format_place(a)}"
                yield Issue(f"plate.lines[{i}]", zero_piece, "points apart from each other")


def _meeting(a: Polygon, b: Polygon) -> str:
    """Return where the edges of two polygons meet."""
    place = a.boundary.intersection(b.boundary)
    point = place if place.geom_type == "Point" else place.representative_point()
    return format_place((point.x, point.y))


def _find_opening_issues(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Issue]:
    import shapely

    outline = _outlines(flat)
    near = TOO_CLOSE * plan.extent
    names = [name for name in flat if name.startswith("plate.openings")]
    hint = "to cut into the plate's edge, draw the outline so"
    polygons = _openings(flat)
    beside: dict[int, list[int]] = {}
    for i, k in shapely.STRtree(polygons).query(polygons, predicate="dwithin", distance=near).T.tolist():
        if k < i:
            beside.setdefault(i, []).append(k)
    for i, name in enumerate(names):
        opening = flat[name]
        if not outline.intersects(opening) or outline.touches(opening):
            yield Issue(name, "an opening outside the plate", "one inside", "move it or leave it out")
        elif outline.boundary.intersects(opening.boundary):
            crossing = f"an opening that touches or crosses the plate's edge at {_meeting(opening, outline)}"
            yield Issue(name, crossing, "one inside the plate", hint)
        elif opening.contains(outline):
            yield Issue(name, "an opening around the plate", "one inside the plate")
        elif (gap := outline.boundary.distance(opening)) < near:
            where = shapely.shortest_line(opening, outline.boundary).coords[0]
            yield _narrow_strip(name, "plate.outline", where, gap, near)
        for other in (names[k] for k in sorted(beside.get(i, []))):
            if opening.intersects(flat[other]):
                inside = opening.contains(flat[other]) or flat[other].contains(opening)
                place = "inside the other" if inside else f"at {_meeting(opening, flat[other])}"
                meeting = f"an opening that meets {other}, {place}"
                yield Issue(name, meeting, "openings apart from each other", "draw them as one")
            elif (gap := opening.distance(flat[other])) < near:
                yield _narrow_strip(name, other, shapely.shortest_line(opening, flat[other]).coords[0], gap, near)


def _narrow_strip(name: str, other: str, place: Place, gap: float, near: float) -> Issue:
    narrow_gap = f"{gap:.3g} m between it and {other} at {format_place(place)}"
    return Issue(name, narrow_gap, f"nothing, or at least {near:.3g} m", "so narrow a strip cannot be meshed")


def _outlines(flat: dict[str, Polygon]) -> Any:
    """Return the area enclosed by the outlines of all plates."""
    import shapely

    return shapely.union_all([polygon for name, polygon in flat.items() if name.endswith(".outline")])


def _openings(flat: dict[str, Polygon]) -> Any:
    """Return the openings as shapely takes several, none too."""
    return np.array([polygon for name, polygon in flat.items() if name.startswith("plate.openings")], dtype=object)


def _find_zone_issues(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Issue]:
    """Yield zones off the plate, and ground that does not surround it."""
    import shapely

    outline = _outlines(flat)
    plate = outline.difference(shapely.union_all(_openings(flat)))
    for name, polygon in flat.items():
        if name.startswith("plate.zones") and plate.intersection(polygon).area <= same_place_in(plan) ** 2:
            yield Issue(name, "a zone that covers nothing of the plate", "one on the plate", "move it or leave it out")
    if "beyond" in flat:
        left = outline.difference(flat["beyond"].buffer(2 * FLAT * plan.extent))
        if not left.is_empty:
            place = left.representative_point()
            uncovered = f"an edge that leaves out the plate at {format_place((place.x, place.y))}"
            yield Issue("beyond", uncovered, "one around the plate", "the ground must lie under all of the plate")


def _find_place_issues(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Issue]:
    """Yield points and lines that are not on the plate."""
    import shapely

    if not (plan.points or plan.lines):
        return
    inner = shapely.union_all(shapely.buffer(_openings(flat), -2 * FLAT * plan.extent))
    plate = _outlines(flat).buffer(2 * FLAT * plan.extent).difference(inner)
    shapely.prepare(plate)
    for i, point in enumerate(plan.points, start=1):
        if not plate.covers(shapely.Point(point)):
            yield Issue(f"plate.points[{i}]", f"a point off the plate at {format_place(point)}", "one on the plate")
    for i, line in enumerate(plan.segments_by_line(), start=1):
        left = shapely.union_all(flatten(line, FLAT * plan.extent)).difference(plate)
        if not left.is_empty:
            place = left.representative_point()
            leaving = f"a line that leaves the plate at {format_place((place.x, place.y))}"
            yield Issue(f"plate.lines[{i}]", leaving, "one on the plate", "end it at the edge")


def _name_edges(plan: Plan) -> list[tuple[str, Segment]]:
    """Return the edges of all rings and lines with the names that issues give these."""
    lines = [f"plate.lines[{i}]" for i, line in enumerate(plan.lines, start=1) for _ in line[1:]]
    edges = [(name, edge) for name, ring in plan.rings().items() for edge in ring.segments()]
    return edges + list(zip(lines, plan.line_segments(), strict=True))


def _find_near_misses(plan: Plan) -> Iterator[Issue]:
    """Yield points, and corners of zones and lines, that lie beside an edge or point, neither on it nor clear of it."""
    import shapely

    edges = _name_edges(plan)
    edges += [(f"plate.points[{i}]", Segment(p, p)) for i, p in enumerate(plan.points, start=1)]
    corners = [(name, p) for name, ring in plan.rings().items() for p in ring.points]
    corners += [(f"plate.lines[{i}]", p) for i, line in enumerate(plan.lines, start=1) for p in line]
    corners += [(f"plate.points[{i}]", p) for i, p in enumerate(plan.points, start=1)]
    names = np.array([name for name, _ in corners])
    places = np.array([place for _, place in corners])
    # what of a zone lies outside the plate is cut off, and meets nothing; nor does a border where nothing is meshed
    counts = np.ones(len(places), dtype=bool)
    chord = FLAT * plan.extent
    for kind, within in (("plate.zones", plan.plate_polygon(chord)), ("borders", plan.domain_polygon(chord))):
        of_kind = np.char.startswith(names, kind)
        reach = within.buffer(2 * chord)
        counts[of_kind] = shapely.intersects_xy(reach, *places[of_kind].T)
    near = TOO_CLOSE * plan.extent
    seen: set[tuple[str, str]] = set()
    for i, k_near in _find_near_places(plan, [edge for _, edge in edges], places, near):
        name, edge = edges[i]
        k_near = k_near[counts[k_near] & (names[k_near] != name)]
        distance = np.zeros(len(places))
        distance[k_near] = edge.distance(places[k_near])
        for k in k_near[(distance[k_near] > same_place_in(plan)) & (distance[k_near] < near)]:
            pair = min(name, str(names[k])), max(name, str(names[k]))
            if pair not in seen:
                seen.add(pair)
                yield _narrow_strip(str(names[k]), name, (places[k, 0], places[k, 1]), float(distance[k]), near)


def _find_near_places(plan: Plan, edges: list[Segment], places: Array, near: float) -> Iterator[tuple[int, Integers]]:
    """Yield of each edge that has places (p, 2) nearer than so far [m] its number and theirs, ascending."""
    import shapely

    off = FLAT * plan.extent
    pairs = shapely.STRtree(shapely.points(places)).query(flatten(edges, off), predicate="dwithin", distance=near + off)
    pairs = pairs[:, np.lexsort(pairs[::-1])]
    begins = np.flatnonzero(np.diff(pairs[0], prepend=-1))
    for number, many in zip(pairs[0, begins], np.split(pairs[1], begins[1:]), strict=False):
        yield int(number), many


def _find_narrow_wedges(plan: Plan) -> Iterator[Issue]:
    """Yield edges of different curves that meet at too small an angle."""
    import shapely

    edges = _name_edges(plan)
    same, step = 2 * FLAT * plan.extent, 10 * TOO_CLOSE * plan.extent
    flat = flatten([edge for _, edge in edges], same / 2)
    seen: set[tuple[str, str]] = set()
    curve = np.unique([name for name, _ in edges], return_inverse=True)[1]
    # boxes first, as there may be very many of them
    boxes = shapely.box(*(shapely.bounds(flat) + same * np.array([-1, -1, 1, 1])).T)
    meetings = shapely.STRtree(boxes).query(boxes)
    meetings = meetings[:, (curve[meetings[0]] != curve[meetings[1]]) & (meetings[0] < meetings[1])]
    if meetings.shape[1] > MOST_MEETINGS:
        excess = f"{meetings.shape[1]:,} places where edges of openings, zones and supports come together"
        yield Issue("plate.outline", excess, f"at most {MOST_MEETINGS:,}", "draw what overlaps as one")
        return
    meetings = meetings[:, shapely.dwithin(np.array(flat)[meetings[0]], np.array(flat)[meetings[1]], same)]
    meetings = np.hstack([meetings, meetings[::-1]])
    for i, j in meetings.T.tolist():
        (name, first), (other, second) = edges[i], edges[j]
        pair = min(name, other), max(name, other)
        if pair in seen:
            continue
        place = shapely.shortest_line(flat[i], flat[j]).coords[0]
        # a border that only touches another edge parts from it slowly at first; it can be left out, a drawn edge not
        steps = step * np.array([0.25, 1.0] if "borders" in name + other else [1.0])
        parts, steps = first.part(place) + np.array([[-1], [1]]) * steps / first.length, np.stack([steps, steps])
        inside = (parts >= 0) & (parts <= 1)
        away = second.distance(first.at(parts[inside]))
        if ((away > same) & (away < steps[inside] * math.sin(TOO_SHARP))).any():
            seen.add(pair)
            sharp = f"at less than {math.degrees(TOO_SHARP):.0f} degrees"
            parting = f"an edge that parts from {other} at {format_place(place)} {sharp}"
            yield Issue(name, parting, "a larger angle, or the same edge", "so narrow a wedge cannot be meshed")
