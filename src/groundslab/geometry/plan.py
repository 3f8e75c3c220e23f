"""Plan geometry: segments, closed curves, plans. Places are (x, y) in meters, a plan's extent is its longer side."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, pairwise, repeat, zip_longest
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.units import format_coordinate

if TYPE_CHECKING:
    from shapely import LineString, MultiPolygon, Polygon

Place = tuple[float, float]

#: Places closer than this, relative to the extent, are one.
SAME_PLACE = 1e-9
#: Arcs are replaced by chords that are at most this far off, relative to the extent, to see what lies inside what.
FLAT = 1e-6
#: Drawings replace arcs by chords at most this far off, relative to the extent.
DRAWN_CHORD = 2e-4
#: However small an arc is, its chords turn by no more than this, so that it looks round [rad].
ROUND = math.radians(4.0)
#: Arcs are cut into this many chords at most, which are off by 3e-9 of the radius of a quarter circle.
MOST_CHORDS = 10_000
#: Largest bulge of an arc, which is then nearly a whole circle.
LARGEST_BULGE = 100.0
#: Most elements of a mesh.
MOST_ELEMENTS = 4_000_000


@dataclass(frozen=True)
class Segment:
    """One edge of a curve: straight (radius 0), or an arc about a center, from an angle over a signed sweep [rad]."""

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
    def along_axis(self) -> bool:
        """Return whether the edge's ends lie beside each other along x or y."""
        return self.start[0] == self.end[0] or self.start[1] == self.end[1]

    @property
    def length(self) -> float:
        """Return the length along the edge [m]."""
        return math.dist(self.start, self.end) if self.straight else self.radius * abs(self.sweep)

    @property
    def middle(self) -> Place:
        """Return the place half way along the edge."""
        if self.straight:
            return (self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2
        angle = self.angle + self.sweep / 2
        return self.centre[0] + self.radius * math.cos(angle), self.centre[1] + self.radius * math.sin(angle)

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

    def left(self, part: Array) -> Array:
        """Return unit vectors (p, 2) to the left of the direction of travel after parts (p,) of the edge."""
        if self.straight:
            dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
            return np.tile(np.array([-dy, dx]) / math.hypot(dx, dy), (len(part), 1))
        angle = self.angle + part * self.sweep + math.copysign(math.pi / 2, self.sweep)
        return np.column_stack([-np.sin(angle), np.cos(angle)])

    def part(self, place: Place) -> float:
        """Return after which part of the edge a place on it comes."""
        if self.straight:
            return math.dist(self.start, place) / self.length
        angle = math.atan2(place[1] - self.centre[1], place[0] - self.centre[0])
        turn = (angle - self.angle) * math.copysign(1.0, self.sweep)
        return (turn % (2 * math.pi)) / abs(self.sweep)

    def side(self, place: Place) -> float:
        """Return twice the area of the triangle start, end, place: positive if the place lies to the chord's left."""
        (ax, ay), (bx, by) = self.start, self.end
        return (bx - ax) * (place[1] - ay) - (by - ay) * (place[0] - ax)

    def holds(self, place: Place, tolerance: float) -> bool:
        """Return whether a place lies on the edge, but for a tolerance [m]."""
        if math.dist(place, self.start) <= tolerance or math.dist(place, self.end) <= tolerance:
            return True
        if not self.straight:
            return abs(math.dist(place, self.centre) - self.radius) <= tolerance and self.part(place) <= 1
        (ax, ay), (bx, by) = self.start, self.end
        along = (place[0] - ax) * (bx - ax) + (place[1] - ay) * (by - ay)
        return abs(self.side(place)) <= tolerance * self.length and 0 <= along <= self.length**2

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

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, x1, y0, y1 around the edge [m]."""
        places = [self.start, self.end]
        for quarter in () if self.straight else range(-8, 9):
            turned = (quarter * math.pi / 2 - self.angle) * math.copysign(1.0, self.sweep)
            if 0 < turned < abs(self.sweep):
                x, y = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter % 4]
                places.append((self.centre[0] + self.radius * x, self.centre[1] + self.radius * y))
        x_values, y_values = zip(*places, strict=True)
        return min(x_values), max(x_values), min(y_values), max(y_values)

    def chords(self, tolerance: float) -> int:
        """Return into how many chords the edge must be cut for them to be at most a tolerance [m] off it.

        No more than MOST_CHORDS, however large the arc is beside the tolerance.
        """
        if self.straight or tolerance >= self.radius:
            return 1 if self.straight else max(2, math.ceil(abs(self.sweep) / 2))
        # half the angle of a chord is acos(1 - tolerance / radius), here so that small ones keep their digits
        half = 2 * math.asin(math.sqrt(tolerance / self.radius / 2))
        return max(1, math.ceil(min(abs(self.sweep) / (2 * half), MOST_CHORDS)))


def segment(start: Place, end: Place, bulge: float = 0.0) -> Segment:
    """Return the edge between two places; the bulge is the tangent of a quarter of the arc's angle.

    An arc that rises by less than half of FLAT over its chord is straight: rounding of its far center would show.
    """
    if abs(bulge) < FLAT:
        return Segment(start, end)
    dx, dy = end[0] - start[0], end[1] - start[1]
    offset = (1 - bulge * bulge) / (4 * bulge)
    centre = (start[0] + end[0]) / 2 - dy * offset, (start[1] + end[1]) / 2 + dx * offset
    angle = math.atan2(start[1] - centre[1], start[0] - centre[0])
    return Segment(start, end, centre, math.dist(start, centre), angle, 4 * math.atan(bulge))


def make_segments(points: Sequence[Place], bulges: Sequence[float]) -> tuple[Segment, ...]:
    """Return the edges from each point to the next with their bulges, 0 where these are missing."""
    ends_with_bulges = zip(pairwise(points), chain(bulges, repeat(0.0)), strict=False)
    return tuple(segment(start, end, bulge) for (start, end), bulge in ends_with_bulges)


def flatten(edges: Iterable[Segment], off: float) -> list[LineString]:
    """Return edges as lines, arcs as chords at most so far off [m]."""
    from shapely import LineString

    return [LineString(edge.at(np.linspace(0, 1, edge.chords(off) + 1))) for edge in edges]


def get_bounds(edges: Iterable[Segment]) -> tuple[float, float, float, float]:
    """Return the rectangle x0, x1, y0, y1 around edges [m]."""
    left, right, low, high = zip(*(edge.bounds for edge in edges), strict=True)
    return min(left), max(right), min(low), max(high)


def numbers_within(places: Array, bounds: tuple[float, float, float, float]) -> Integers:
    """Return the numbers (k,) of those places (p, 2) that lie in a rectangle x0, x1, y0, y1 [m]."""
    x, y = places.T
    x0, x1, y0, y1 = bounds
    return np.flatnonzero((x >= x0) & (x <= x1) & (y >= y0) & (y <= y1))


def bounding_box(edges: Iterable[Segment]) -> Polygon:
    """Return the rectangle around edges as a polygon."""
    import shapely

    x0, x1, y0, y1 = get_bounds(edges)
    return shapely.box(x0, y0, x1, y1)


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
        return make_segments(self.points + self.points[:1], self.bulges)

    def flat(self, tolerance: float) -> Array:
        """Return places (p, 2) along the curve, not closed; chords between them are at most a tolerance [m] off it."""
        parts = []
        for edge in self.segments():
            n = edge.chords(tolerance)
            if tolerance < math.inf:
                n = max(n, math.ceil(abs(edge.sweep) / ROUND))
            parts.append(edge.at(np.arange(n) / n))
        return np.concatenate(parts)

    def polygon(self, tolerance: float) -> Polygon:
        """Return the polygon inside, its arcs replaced by chords that are at most a tolerance [m] off."""
        import shapely

        return shapely.Polygon(self.flat(tolerance))

    @property
    def area(self) -> float:
        """Return the area inside [m2]."""
        return abs(self.signed_area)

    @property
    def signed_area(self) -> float:
        """Return the area inside [m2], negative if the curve runs clockwise; exact with arcs too."""
        x0, y0 = self.points[0]
        double = 0.0
        for edge in self.segments():
            (x, y), (u, v) = edge.start, edge.end
            double += (x - x0) * (v - y0) - (u - x0) * (y - y0)
            double += edge.radius**2 * (edge.sweep - math.sin(edge.sweep))
        return double / 2

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, x1, y0, y1 around the curve [m]."""
        return get_bounds(self.segments())

    @property
    def sides(self) -> tuple[float, float]:
        """Return the sides along x and y of the rectangle around the curve [m]."""
        x0, x1, y0, y1 = self.bounds
        return x1 - x0, y1 - y0

    @property
    def straight(self) -> bool:
        """Return whether no edge is an arc."""
        return all(abs(bulge) < FLAT for bulge in self.bulges)

    @property
    def rectilinear(self) -> bool:
        """Return whether all edges run along x or y."""
        return self.straight and all(edge.along_axis for edge in self.segments())

    @property
    def is_rectangle(self) -> bool:
        """Return whether it is a rectangle along x and y."""
        return len(self.points) == 4 and self.rectilinear


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
    """The plan of a plate, or of several: outline, openings, zones, and points and lines where nodes must lie.

    A zone is a ring and its section, a number from 1; section 0 is the rest of the plate. Where zones overlap, the last
    one counts; what reaches over the plate's edge is cut off. `beyond` is the outer edge of the meshed ground, which
    then lies under the openings too; without it nothing but the plate is meshed. Points and lines are places of
    supports, columns and walls. Borders are further curves that the mesh follows wherever something is meshed: those of
    soil zones and voids. Each further plate has an outline and a section, from which those of its zones count on.
    """

    outline: Ring
    openings: tuple[Ring, ...] = ()
    zones: tuple[tuple[Ring, int], ...] = ()
    beyond: Ring | None = None
    points: tuple[Place, ...] = ()
    lines: tuple[tuple[Place, ...], ...] = ()
    line_bulges: tuple[tuple[float, ...], ...] = ()  # of the pieces of lines, straight where they lack one
    borders: tuple[Ring, ...] = ()
    others: tuple[tuple[Ring, int], ...] = ()
    origin: Place = (0.0, 0.0)  # where x = y = 0 lies in the plan that was given, for messages

    @property
    def outlines(self) -> tuple[Ring, ...]:
        """Return the outlines of all plates."""
        return (self.outline, *(ring for ring, _ in self.others))

    def plate_polygon(self, tolerance: float) -> Polygon | MultiPolygon:
        """Return the area enclosed by the outlines, with openings, arcs as chords at most a tolerance [m] off."""
        import shapely

        return shapely.union_all([ring.polygon(tolerance) for ring in self.outlines])

    def domain_polygon(self, tolerance: float) -> Polygon | MultiPolygon:
        """Return the meshed area, regardless of openings in the plate, arcs as chords at most a tolerance [m] off."""
        return self.plate_polygon(tolerance) if self.beyond is None else self.beyond.polygon(tolerance)

    def rings(self) -> dict[str, Ring]:
        """Return all rings by the names that issues give them."""
        named = {"plate.outline": self.outline}
        named |= {f"plates[{i}].outline": ring for i, (ring, _) in enumerate(self.others, start=1)}
        named |= {f"plate.openings[{i}]": ring for i, ring in enumerate(self.openings, start=1)}
        named |= {f"plate.zones[{i}]": ring for i, (ring, _) in enumerate(self.zones, start=1)}
        named |= {} if self.beyond is None else {"beyond": self.beyond}
        return named | {f"borders[{i}]": ring for i, ring in enumerate(self.borders, start=1)}

    def edges_on_ground(self) -> tuple[Ring, ...]:
        """Return the plates' outlines and openings if ground is meshed beyond them, else nothing."""
        return () if self.beyond is None else (*self.outlines, *self.openings)

    def segments_by_line(self) -> list[tuple[Segment, ...]]:
        """Return the straight pieces and arcs of each line."""
        return [make_segments(*pair) for pair in zip_longest(self.lines, self.line_bulges, fillvalue=())]

    def line_segments(self) -> list[Segment]:
        """Return the straight pieces and arcs of all lines."""
        return [edge for line in self.segments_by_line() for edge in line]

    def arcs(self) -> list[Segment]:
        """Return the arcs of all rings and lines."""
        edges = [edge for ring in self.rings().values() for edge in ring.segments()] + self.line_segments()
        return [edge for edge in edges if not edge.straight]

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, y0, x1, y1 around all rings but the borders, which may reach far beyond."""
        rings = (*self.outlines, *self.openings, *(ring for ring, _ in self.zones), *filter(None, [self.beyond]))
        places = np.concatenate([ring.flat(math.inf) for ring in rings])
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
        return all(edge.straight and edge.along_axis for edge in self.line_segments()) and all(
            ring.rectilinear for ring in self.rings().values()
        )

    @property
    def area(self) -> float:
        """Return the area of the plates without openings [m2]."""
        return sum(ring.area for ring in self.outlines) - sum(ring.area for ring in self.openings)


def format_place(place: Place | Array, origin: Place = (0.0, 0.0)) -> str:
    """Return a place as issues name it; of a plan that was moved, with where its x = y = 0 lies in the one given."""
    return f"({format_coordinate(place[0] + origin[0])}, {format_coordinate(place[1] + origin[1])})"
