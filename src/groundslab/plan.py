"""A plate of any shape in plan: closed curves of straight edges and arcs, and what is wrong with them.

Places are (x, y) in metres. A plan's extent is the longer side of the rectangle around all that is drawn.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.errors import Fault
from groundslab.shape import Array, Flags, Integers

if TYPE_CHECKING:
    from shapely import Polygon

Place = tuple[float, float]

#: Places closer than this, relative to the extent, are one.
SAME_PLACE = 1e-9
#: Edges shorter than this, relative to the extent, have no length.
NO_LENGTH = 1e-6
#: What is closer than this, relative to the extent, without touching leaves a strip too narrow to mesh.
TOO_CLOSE = 1e-3
#: Two edges that meet at less than this angle [rad] leave a corner too sharp to mesh.
TOO_SHARP = math.radians(5)
#: Arcs are replaced by chords that are at most this far off, relative to the extent, to see what lies inside what.
FLAT = 1e-6
#: Section of a place that is not meshed at all; see `sections`.
NOTHING = -2
#: Section of a place where ground lies and no plate.
GROUND = -1


@dataclass(frozen=True)
class Segment:
    """One edge of a curve: straight (radius 0), or an arc about a centre, from an angle over a signed sweep [rad]."""

    start: Place
    end: Place
    centre: Place = (0.0, 0.0)
    radius: float = 0.0
    angle: float = 0.0
    sweep: float = 0.0

    @property
    def straight(self) -> bool:
        """Return whether the edge is straight."""
        return self.radius == 0.0

    @property
    def length(self) -> float:
        """Return the length along the edge [m]."""
        return math.dist(self.start, self.end) if self.straight else self.radius * abs(self.sweep)

    def at(self, part: Array) -> Array:
        """Return the places (p, 2) after parts (p,) of the edge, from 0 to 1."""
        places: Array
        if self.straight:
            start, end = np.array(self.start), np.array(self.end)
            places = start + part[:, None] * (end - start)
        else:
            angle = self.angle + part * self.sweep
            places = np.array(self.centre) + self.radius * np.column_stack([np.cos(angle), np.sin(angle)])
        places[part == 0], places[part == 1] = self.start, self.end
        return places

    def direction(self, part: float) -> float:
        """Return the angle [rad] of the direction of travel after a part of the edge."""
        if self.straight:
            return math.atan2(self.end[1] - self.start[1], self.end[0] - self.start[0])
        return self.angle + part * self.sweep + math.copysign(math.pi / 2, self.sweep)

    def part(self, place: Place) -> float:
        """Return after which part of the edge a place on it comes."""
        if self.straight:
            return math.dist(self.start, place) / self.length
        angle = math.atan2(place[1] - self.centre[1], place[0] - self.centre[0])
        turn = (angle - self.angle) * math.copysign(1.0, self.sweep)
        return (turn % (2 * math.pi)) / abs(self.sweep)

    def distance(self, places: Array) -> Array:
        """Return the distances (p,) [m] of places (p, 2) from the edge."""
        result: Array
        start, end = np.array(self.start), np.array(self.end)
        if self.straight:
            along = end - start
            part = np.clip((places - start) @ along / (along @ along or 1.0), 0.0, 1.0)
            result = np.linalg.norm(places - start - part[:, None] * along, axis=1)
            return result
        offset = places - np.array(self.centre)
        turn = (np.arctan2(offset[:, 1], offset[:, 0]) - self.angle) * math.copysign(1.0, self.sweep)
        beside = np.abs(np.linalg.norm(offset, axis=1) - self.radius)
        ends = np.minimum(np.linalg.norm(places - start, axis=1), np.linalg.norm(places - end, axis=1))
        result = np.where(np.mod(turn, 2 * math.pi) <= abs(self.sweep), beside, ends)
        return result

    def chords(self, tolerance: float) -> int:
        """Return into how many chords the edge must be cut for them to be at most a tolerance [m] off it."""
        if self.straight or tolerance >= self.radius:
            return 1 if self.straight else max(2, math.ceil(abs(self.sweep) / 2))
        return max(1, math.ceil(abs(self.sweep) / (2 * math.acos(1 - tolerance / self.radius))))


def segment(start: Place, end: Place, bulge: float = 0.0) -> Segment:
    """Return the edge between two places; the bulge is the tangent of a quarter of the arc's angle."""
    if bulge == 0.0:
        return Segment(start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    offset = (1 - bulge * bulge) / (4 * bulge)
    centre = (start[0] + end[0]) / 2 - dy * offset, (start[1] + end[1]) / 2 + dx * offset
    angle = math.atan2(start[1] - centre[1], start[0] - centre[0])
    return Segment(start, end, centre, math.dist(start, centre), angle, 4 * math.atan(bulge))


@dataclass(frozen=True)
class Ring:
    """A closed curve through points; bulge i belongs to the edge from point i to the next, as in DXF.

    A bulge is the tangent of a quarter of the arc's angle: positive if the arc runs counter-clockwise, 0 or missing for
    a straight edge. The last point is joined to the first, which is not repeated.
    """

    points: tuple[Place, ...]
    bulges: tuple[float, ...] = ()

    def segments(self) -> tuple[Segment, ...]:
        """Return the edges, the first one starting at the first point."""
        bulges = self.bulges + (0.0,) * (len(self.points) - len(self.bulges))
        after = self.points[1:] + self.points[:1]
        return tuple(map(segment, self.points, after, bulges))

    def flat(self, tolerance: float) -> Array:
        """Return places (p, 2) along the curve, not closed; chords between them are at most a tolerance [m] off it."""
        parts = []
        for edge in self.segments():
            n = edge.chords(tolerance)
            parts.append(edge.at(np.arange(n) / n))
        return np.concatenate(parts)

    def polygon(self, tolerance: float) -> Polygon:
        """Return the polygon inside, its arcs replaced by chords that are at most a tolerance [m] off."""
        import shapely

        return shapely.Polygon(self.flat(tolerance))

    @property
    def area(self) -> float:
        """Return the area inside [m2], exact with arcs too."""
        x0, y0 = self.points[0]
        double = 0.0
        for edge in self.segments():
            (x, y), (u, v) = edge.start, edge.end
            double += (x - x0) * (v - y0) - (u - x0) * (y - y0)
            double += edge.radius**2 * (edge.sweep - math.sin(edge.sweep))
        return abs(double) / 2

    @property
    def straight(self) -> bool:
        """Return whether no edge is an arc."""
        return not any(self.bulges)

    @property
    def rectilinear(self) -> bool:
        """Return whether all edges run along x or y."""
        return self.straight and all(_along_an_axis(edge.start, edge.end) for edge in self.segments())


def circle(centre: Place, radius: float) -> Ring:
    """Return a circle as four quarter arcs."""
    x, y = centre
    points = ((x + radius, y), (x, y + radius), (x - radius, y), (x, y - radius))
    return Ring(points, (math.tan(math.pi / 8),) * 4)


def rectangle(x0: float, x1: float, y0: float, y1: float) -> Ring:
    """Return the rectangle x0 .. x1, y0 .. y1."""
    return Ring(((x0, y0), (x1, y0), (x1, y1), (x0, y1)))


@dataclass(frozen=True)
class Plan:
    """A plate in plan, what is cut out of it, what differs in it, and where nodes must lie.

    A zone is a ring and its section, a number from 1; section 0 is the rest of the plate. Where zones overlap, the last
    one counts; what reaches over the plate's edge is cut off. `beyond` is the outer edge of the meshed ground, which
    then lies under the openings too; without it nothing but the plate is meshed. Points and lines are places of
    supports, columns and walls.
    """

    outline: Ring
    openings: tuple[Ring, ...] = ()
    zones: tuple[tuple[Ring, int], ...] = ()
    beyond: Ring | None = None
    points: tuple[Place, ...] = ()
    lines: tuple[tuple[Place, ...], ...] = ()

    def rings(self) -> dict[str, Ring]:
        """Return all rings by the names that faults give them."""
        named = {"plan.outline": self.outline}
        named |= {f"plan.openings[{i}]": ring for i, ring in enumerate(self.openings, start=1)}
        named |= {f"plan.zones[{i}]": ring for i, (ring, _) in enumerate(self.zones, start=1)}
        return named | ({} if self.beyond is None else {"plan.beyond": self.beyond})

    def line_segments(self) -> list[Segment]:
        """Return the straight pieces of all lines."""
        return [Segment(a, b) for line in self.lines for a, b in pairwise(line)]

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, y0, x1, y1 around all rings."""
        places = np.concatenate([ring.flat(math.inf) for ring in self.rings().values()])
        low, high = places.min(axis=0), places.max(axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])

    @property
    def extent(self) -> float:
        """Return the longer side of that rectangle [m]."""
        x0, y0, x1, y1 = self.bounds
        return max(x1 - x0, y1 - y0)

    @property
    def rectilinear(self) -> bool:
        """Return whether everything runs along x or y, so that a grid can be fitted to it."""
        lines = all(_along_an_axis(edge.start, edge.end) for edge in self.line_segments())
        return lines and all(ring.rectilinear for ring in self.rings().values())

    @property
    def area(self) -> float:
        """Return the plate's area [m2], openings taken off."""
        return self.outline.area - sum(ring.area for ring in self.openings)


def sections(plan: Plan, places: Array) -> Integers:
    """Return the section at each place (p, 2): GROUND where there is ground only, NOTHING where nothing is meshed."""
    import shapely

    def inside(ring: Ring) -> Flags:
        return np.asarray(shapely.contains_xy(ring.polygon(FLAT * plan.extent), places[:, 0], places[:, 1]), dtype=bool)

    section = np.full(len(places), NOTHING, dtype=np.int64)
    if plan.beyond is not None:
        section[inside(plan.beyond)] = GROUND
    empty = section.copy()
    section[inside(plan.outline)] = 0
    for ring, number in plan.zones:
        section[inside(ring) & (section >= 0)] = number
    for ring in plan.openings:
        cut = inside(ring)
        section[cut] = empty[cut]
    return section


def faults(plan: Plan) -> list[Fault]:
    """Return everything that keeps a plan from being meshed, each with its place."""
    found = list(_number_faults(plan))
    if found:
        return found
    rings = plan.rings()
    for name, ring in rings.items():
        found += _ring_faults(name, ring, plan.extent)
    found += _line_faults(plan)
    if found:
        return found
    flat = {name: ring.polygon(FLAT * plan.extent) for name, ring in rings.items()}
    found += _opening_faults(plan, flat)
    found += _zone_faults(plan, flat)
    if not found:
        found += _place_faults(plan, flat)
        found += _near_misses(plan, flat)
        found += _grazes(plan)
    return found


def at(place: Place) -> str:
    """Return a place as faults name it."""
    return f"({place[0]:.6g}, {place[1]:.6g})"


def _along_an_axis(start: Place, end: Place) -> bool:
    return start[0] == end[0] or start[1] == end[1]


def _number_faults(plan: Plan) -> Iterator[Fault]:
    """Yield what is not a number or too few of them: nothing else can be looked at then."""
    for name, ring in plan.rings().items():
        least = 3 if ring.straight else 2
        if len(ring.points) < least:
            wanted = "at least 3, or 2 where an edge is an arc"
            yield Fault(name, f"{len(ring.points)} points", wanted, "a closed curve needs them")
        if len(ring.bulges) > len(ring.points):
            yield Fault(name, f"{len(ring.bulges)} bulges", "at most one for each point", "leave the rest out")
        if not np.isfinite([value for point in ring.points for value in point] + list(ring.bulges)).all():
            yield Fault(name, "a coordinate or bulge that is not finite", "numbers")
    for i, (_, number) in enumerate(plan.zones, start=1):
        if number < 1:
            yield Fault(f"plan.zones[{i}]", f"section {number}", "a number from 1", "0 is the plate's own section")
    for i, point in enumerate(plan.points, start=1):
        if not np.isfinite(point).all():
            yield Fault(f"plan.points[{i}]", "a coordinate that is not finite", "numbers")
    for i, line in enumerate(plan.lines, start=1):
        if len(line) < 2 or not np.isfinite(line).all():
            yield Fault(f"plan.lines[{i}]", "no line", "at least 2 points with finite coordinates")


def _ring_faults(name: str, ring: Ring, extent: float) -> Iterator[Fault]:
    """Yield what is wrong with one ring by itself."""
    import shapely

    edges = ring.segments()
    short = [edge for edge in edges if edge.length <= NO_LENGTH * extent]
    for edge in short:
        yield Fault(
            name, f"an edge without length at {at(edge.start)}", "points apart from each other", "leave one out"
        )
    if short:
        return
    polygon = ring.polygon(FLAT * extent)
    if not polygon.is_valid:
        said = re.search(r"\[(\S+) (\S+)\]", shapely.is_valid_reason(polygon))
        place = f" at {at((float(said[1]), float(said[2])))}" if said else ""
        yield Fault(name, f"a curve that crosses or touches itself{place}", "one that does not", "move a point")
        return
    for before, after in zip(edges, edges[1:] + edges[:1], strict=True):
        turn = (after.direction(0.0) - before.direction(1.0)) % (2 * math.pi)
        angle = abs(math.pi - turn)
        if angle < TOO_SHARP:
            yield Fault(
                name,
                f"an angle of {math.degrees(angle):.2g} degrees at {at(after.start)}",
                f"at least {math.degrees(TOO_SHARP):.0f} degrees",
                "cut the corner off",
            )


def _line_faults(plan: Plan) -> Iterator[Fault]:
    for i, line in enumerate(plan.lines, start=1):
        for a, b in pairwise(line):
            if math.dist(a, b) <= NO_LENGTH * plan.extent:
                yield Fault(f"plan.lines[{i}]", f"a piece without length at {at(a)}", "points apart from each other")


def _meeting(a: Polygon, b: Polygon) -> str:
    """Return where the edges of two polygons meet."""
    place = a.boundary.intersection(b.boundary)
    point = place if place.geom_type == "Point" else place.representative_point()
    return at((point.x, point.y))


def _opening_faults(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Fault]:
    import shapely

    outline = flat["plan.outline"]
    near = TOO_CLOSE * plan.extent
    names = [name for name in flat if name.startswith("plan.openings")]
    mend = "to cut into the plate's edge, draw the outline so"
    for i, name in enumerate(names):
        own = flat[name]
        if not outline.intersects(own) or outline.touches(own):
            yield Fault(name, "an opening outside the plate", "one inside", "move it or leave it out")
        elif outline.boundary.intersects(own.boundary):
            got = f"an opening that touches or crosses the plate's edge at {_meeting(own, outline)}"
            yield Fault(name, got, "one inside the plate", mend)
        elif own.contains(outline):
            yield Fault(name, "an opening around the plate", "one inside the plate")
        elif (gap := outline.boundary.distance(own)) < near:
            where = shapely.shortest_line(own, outline.boundary).coords[0]
            yield _strip(name, "plan.outline", where, gap, near)
        for other in names[:i]:
            if own.intersects(flat[other]):
                inside = own.contains(flat[other]) or flat[other].contains(own)
                place = "inside the other" if inside else f"at {_meeting(own, flat[other])}"
                got = f"an opening that meets {other}, {place}"
                yield Fault(name, got, "openings apart from each other", "draw them as one")
            elif (gap := own.distance(flat[other])) < near:
                yield _strip(name, other, shapely.shortest_line(own, flat[other]).coords[0], gap, near)


def _strip(name: str, other: str, place: Place, gap: float, near: float) -> Fault:
    got = f"{gap:.3g} m between it and {other} at {at(place)}"
    return Fault(name, got, f"nothing, or at least {near:.3g} m", "so narrow a strip cannot be meshed")


def _zone_faults(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Fault]:
    """Yield zones off the plate, and ground that does not reach all round it."""
    outline = flat["plan.outline"]
    plate = outline
    for name, polygon in flat.items():
        if name.startswith("plan.openings"):
            plate = plate.difference(polygon)
    for name, polygon in flat.items():
        if name.startswith("plan.zones") and plate.intersection(polygon).area <= (SAME_PLACE * plan.extent) ** 2:
            yield Fault(name, "a zone that covers nothing of the plate", "one on the plate", "move it or leave it out")
    if "plan.beyond" in flat:
        left = outline.difference(flat["plan.beyond"].buffer(2 * FLAT * plan.extent))
        if not left.is_empty:
            place = left.representative_point()
            got = f"an edge that leaves out the plate at {at((place.x, place.y))}"
            yield Fault("plan.beyond", got, "one around the plate", "the ground must lie under all of the plate")


def _place_faults(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Fault]:
    """Yield points and lines that are not on the plate."""
    import shapely

    plate = flat["plan.outline"].buffer(2 * FLAT * plan.extent)
    for name, polygon in flat.items():
        if name.startswith("plan.openings"):
            plate = plate.difference(polygon.buffer(-2 * FLAT * plan.extent))
    for i, point in enumerate(plan.points, start=1):
        if not plate.covers(shapely.Point(point)):
            yield Fault(f"plan.points[{i}]", f"a point off the plate at {at(point)}", "one on the plate")
    for i, line in enumerate(plan.lines, start=1):
        left = shapely.LineString(line).difference(plate)
        if not left.is_empty:
            place = left.representative_point()
            got = f"a line that leaves the plate at {at((place.x, place.y))}"
            yield Fault(f"plan.lines[{i}]", got, "one on the plate", "end it at the edge")


def _near_misses(plan: Plan, flat: dict[str, Polygon]) -> Iterator[Fault]:
    """Yield points, and corners of zones and lines, that lie beside an edge or point, neither on it nor clear of it."""
    import shapely

    edges = [(name, edge) for name, ring in plan.rings().items() for edge in ring.segments()]
    edges += [
        (f"plan.lines[{i}]", Segment(a, b)) for i, line in enumerate(plan.lines, start=1) for a, b in pairwise(line)
    ]
    edges += [(f"plan.points[{i}]", Segment(p, p)) for i, p in enumerate(plan.points, start=1)]
    corners = [(name, p) for name, ring in plan.rings().items() for p in ring.points]
    corners += [(f"plan.lines[{i}]", p) for i, line in enumerate(plan.lines, start=1) for p in line]
    corners += [(f"plan.points[{i}]", p) for i, p in enumerate(plan.points, start=1)]
    names = np.array([name for name, _ in corners])
    places = np.array([place for _, place in corners])
    # what of a zone lies outside the plate is cut off, and meets nothing
    inside = shapely.intersects_xy(flat["plan.outline"].buffer(2 * FLAT * plan.extent), places[:, 0], places[:, 1])
    counts = inside | ~np.char.startswith(names, "plan.zones")
    near = TOO_CLOSE * plan.extent
    seen: set[tuple[str, str]] = set()
    for name, edge in edges:
        distance = edge.distance(places)
        close = (distance > SAME_PLACE * plan.extent) & (distance < near) & counts & (names != name)
        for k in np.flatnonzero(close):
            pair = min(name, str(names[k])), max(name, str(names[k]))
            if pair not in seen:
                seen.add(pair)
                yield _strip(str(names[k]), name, (places[k, 0], places[k, 1]), float(distance[k]), near)


def _grazes(plan: Plan) -> Iterator[Fault]:
    """Yield edges of different curves that part so slowly from where they meet that nothing fits between them."""
    import shapely

    edges = [(name, edge) for name, ring in plan.rings().items() for edge in ring.segments()]
    lines = [f"plan.lines[{i}]" for i, line in enumerate(plan.lines, start=1) for _ in line[1:]]
    edges += list(zip(lines, plan.line_segments(), strict=True))
    same, step = 2 * FLAT * plan.extent, 10 * TOO_CLOSE * plan.extent
    flat = [shapely.LineString(edge.at(np.linspace(0, 1, edge.chords(same / 2) + 1))) for _, edge in edges]
    seen: set[tuple[str, str]] = set()
    for i, j in shapely.STRtree(flat).query(flat, predicate="dwithin", distance=same).T.tolist():
        (name, one), (other, two) = edges[i], edges[j]
        pair = min(name, other), max(name, other)
        if name == other or pair in seen:
            continue
        place = shapely.shortest_line(flat[i], flat[j]).coords[0]
        parts = one.part(place) + np.array([-1, 1]) * step / one.length
        away = two.distance(one.at(parts[(parts >= 0) & (parts <= 1)]))
        if ((away > same) & (away < step * math.sin(TOO_SHARP))).any():
            seen.add(pair)
            got = f"an edge that parts from {other} at {at(place)} at less than {math.degrees(TOO_SHARP):.0f} degrees"
            yield Fault(name, got, "a larger angle, or the same edge", "so narrow a wedge cannot be meshed")
