"""What the plates of a model cover in plan."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.places import same_place
from groundslab.geometry.plan import Place
from groundslab.geometry.regions import Region
from groundslab.model.plate import Plate
from groundslab.model.plates.further import AnyPlate, FurtherPlate, bounds_of, list_plates
from groundslab.model.shapes import CHORD

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: What reaches over the edge by less than this, relative to the longer side of all plates, lies on them where arcs are
#: chords.
CURVED = 5e-5


class PlateRegion:
    """What plates cover in plan, computed once for all checks."""

    def __init__(self, plate: Plate, plates: tuple[FurtherPlate, ...] = ()) -> None:
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


def _area(plate: AnyPlate) -> BaseGeometry:
    """Return the area of a plate without its openings."""
    from shapely import union_all

    outline, *openings = map(equal_area_polygon, plate.rings())
    return outline.difference(union_all(openings))
