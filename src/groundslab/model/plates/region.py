"""What the plates of a model cover in plan."""

from __future__ import annotations

import itertools
import math
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.intersections import find_crossings
from groundslab.geometry.places import same_place
from groundslab.geometry.plan import Place, Segment
from groundslab.geometry.regions import Region
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, bounds_of, list_plates
from groundslab.model.plates.pits import chord_of, pits_of
from groundslab.model.shapes import CHORD

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: What reaches over the edge by less than this, relative to the longer side of all plates, lies on them where arcs are
#: chords.
CURVED = 5e-5
#: A part of a line shorter than this, relative to the line, is nothing but rounding.
NO_PART = 1e-9
#: The tangents around an arc span this angle [rad] at most.
TANGENT = 2 * math.pi / 256


class PlateRegion:
    """What plates cover in plan, computed once for all checks."""

    def __init__(self, plate: AnyPlate, plates: tuple[FurtherPlate, ...] = ()) -> None:
        self.plate, self.plates, self.every = plate, plates, list_plates(plate, plates)
        self.bounds = bounds_of(plate, plates)
        x0, x1, y0, y1 = self.bounds
        self.size = max(x1 - x0, y1 - y0)
        self.straight = all(ring.straight for slab in self.every for ring in slab.rings())
        self.rounding = same_place(*self.bounds)
        self.near = self.rounding if self.straight else CURVED * self.size

    @cached_property
    def edges(self) -> Region:
        """The edges of the plates and their openings."""
        rings = (ring for slab in self.every for ring in slab.rings())
        return Region(edge for ring in rings for edge in ring.segments())

    @cached_property
    def areas(self) -> tuple[BaseGeometry, ...]:
        """What each plate covers, without its openings."""
        return tuple(map(_area, self.every))

    @cached_property
    def area(self) -> BaseGeometry:
        """The plates without their openings."""
        from shapely import union_all

        return self.areas[0] if len(self.areas) == 1 else union_all(self.areas)

    @cached_property
    def levels(self) -> tuple[BaseGeometry, ...]:
        """What lies at one level: all around pits, then each pit."""
        from shapely import union_all

        pits = [pit.area(chord_of(slab)) for slab in self.every for pit in pits_of(slab)]
        return (self.area.difference(union_all(pits)), *pits) if pits else (self.area,)

    @cached_property
    def steps(self) -> BaseGeometry | None:
        """The lines at which the plates step from one level to another, None if there are none."""
        from shapely import union_all

        return union_all([pit.boundary for pit in self.levels[1:]]) if self.levels[1:] else None

    def level_at(self, place: Place) -> BaseGeometry:
        """Return what lies at the level of a place on the plates, the nearest by rounding."""
        from shapely import Point

        point = Point(place)
        return min(self.levels, key=lambda part: part.distance(point))

    @cached_property
    def grown(self) -> BaseGeometry:
        """The area grown by what counts as rounding."""
        return self._grow(self.near)

    @cached_property
    def reach(self) -> BaseGeometry:
        """What a part must not leave, wider than the area by what rounding and chords may take."""
        return self.grown if self.straight else self._grow(2 * CHORD * self.size)

    def plate_at(self, place: Place) -> int:
        """Return the number of the plate that a place on one of them lies on, the nearest by rounding."""
        from shapely import Point

        distances = [area.distance(Point(place)) for area in self.areas] if self.plates else [0.0]
        return distances.index(min(distances))

    def _grow(self, distance: float) -> BaseGeometry:
        from shapely import prepare

        grown = self.area.buffer(distance, join_style="mitre")
        prepare(grown)
        return grown


#: The region of plates, computed once.
get_plate_region = lru_cache(maxsize=32)(PlateRegion)


def _area(plate: AnyPlate) -> BaseGeometry:
    """Return the area of a plate without its openings."""
    from shapely import union_all

    outline, *openings = map(equal_area_polygon, plate.rings())
    return outline.difference(union_all(openings))


def parts_on_plates(region: PlateRegion, edge: Segment) -> list[tuple[float, float]]:
    """Return the parts of an edge, from 0 to 1, that lie on the plates."""
    from shapely import LineString, Point

    if region.grown.covers(LineString(enclosing_line(edge))):
        return [(0.0, 1.0)]
    cuts = {0.0, 1.0}
    for side in (region.edges.edges[k] for k in region.edges.find_near(edge, 0.0)):
        for place in find_crossings(edge, side):
            if edge.holds(place, region.near) and side.holds(place, region.near):
                cuts.add(min(max(_parameter_at(edge, place), 0.0), 1.0))
    parts: list[tuple[float, float]] = []
    for low, high in itertools.pairwise(sorted(cuts)):
        if high - low > NO_PART and region.grown.covers(Point(edge.at(np.array([(low + high) / 2]))[0])):
            joined = bool(parts) and parts[-1][1] == low
            parts[-1:] = [(parts[-1][0], high)] if joined else [*parts[-1:], (low, high)]
    return parts


def enclosing_line(edge: Segment) -> Array:
    """Return the corners (p, 2) of lines that an edge does not leave to the outside: tangents of an arc."""
    if edge.straight:
        return np.array([edge.start, edge.end])
    n = max(2, math.ceil(abs(edge.sweep) / TANGENT))
    places, centre = edge.at((np.arange(n) + 0.5) / n), np.array(edge.centre)
    corners: Array = centre + (places - centre) / math.cos(edge.sweep / n / 2)
    return np.vstack([edge.start, corners, edge.end])


def _parameter_at(edge: Segment, place: tuple[float, float]) -> float:
    """Return after which part of an edge a place on it comes; about 0 or 1, not round the circle, near its ends."""
    near = 1e-9 * edge.length
    if math.dist(place, edge.start) <= near or math.dist(place, edge.end) <= near:
        return float(math.dist(place, edge.start) > math.dist(place, edge.end))
    return edge.part(place)
