"""Pits: sunken parts of a plate, each joined to the slab around it by walls along its border.

A pit's shape is that of the axes of its walls. Its floor, t_f thick, and the slab around it, t thick, end there. With
the floor's top side at z (negative) from the slab's, half of a wall stands on the floor, -z high, and half hangs under
the slab, -z + t_f - t high: from middle plane to middle plane along straight axes, t_w (-z + (t_f - t) / 2) of concrete
for each length.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Ring, format_place
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, list_plates
from groundslab.model.shapes import CHORD
from groundslab.schema.issues import RelativeIssue
from groundslab.units import show

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

#: A pit's floor between its walls is at least so wide, over the thickness of a wall.
LEAST_WIDTH = 0.5
#: Its underside lies at least so much deeper than that of the slab around it [m].
LEAST_STEP = 1e-3


@dataclass(frozen=True, slots=True)
class Pit:
    """A sunken part of a plate."""

    number: int  # of its zone, from 1
    ring: Ring  # along the axes of its walls
    level: float  # of its top side above that of the slab around it, below 0 [m]
    wall: float  # thickness of its walls [m]
    thickness: float  # of its floor [m]
    around: float  # thickness of the slab around it [m]

    @property
    def deeper(self) -> float:
        """Return how much deeper its underside lies than that of the slab around it [m]."""
        return self.thickness - self.around - self.level

    def area(self, chord: float) -> Polygon:
        """Return what lies inside the axes of its walls, arcs as chords at most so far off [m]."""
        return self.ring.polygon(chord)

    def outer(self, chord: float) -> Polygon:
        """Return what lies inside the outer faces of its walls, see `area`."""
        return self.area(chord).buffer(self.wall / 2, join_style="mitre")

    def inner(self, chord: float) -> Polygon | MultiPolygon:
        """Return what lies inside the inner faces of its walls, see `area`."""
        return self.area(chord).buffer(-self.wall / 2, join_style="mitre")

    def volume(self, chord: float) -> float:
        """Return the volume of its walls beside floor and slab [m3], see `area`."""
        outer, axes, inner = (float(part.area) for part in (self.outer(chord), self.area(chord), self.inner(chord)))
        return (outer - axes) * self.deeper - (axes - inner) * self.level

    def faces(self, chord: float) -> tuple[Array, ...]:
        """Return the corners (p, 2) of the faces of its walls [m], the outer one first, see `area`."""
        from shapely import get_parts

        parts = self.outer(chord), *get_parts(self.inner(chord))
        return tuple(np.asarray(part.exterior.coords)[:-1] for part in parts)


def pits_of(plate: AnyPlate) -> tuple[Pit, ...]:
    """Return the pits of a plate."""
    return _find_pits(plate) if any(zone.level is not None for zone in plate.zones) else ()


@lru_cache(maxsize=32)
def _find_pits(plate: AnyPlate) -> tuple[Pit, ...]:
    return tuple(
        Pit(number, zone.shape.ring(), zone.level, zone.wall, zone.thickness or around, around)
        for number, zone in enumerate(plate.zones, start=1)
        if zone.level is not None and zone.wall is not None
        for around in [_thickness_around(plate, number)]
    )


def chord_of(plate: AnyPlate) -> float:
    """Return how far chords may lie off arcs of a plate [m]."""
    return CHORD * max(plate.sides)


def _thickness_around(plate: AnyPlate, number: int) -> float:
    """Return the thickness of the slab around a zone with a number from 1 [m]: of the last zone before it, around it.

    A zone without a thickness has the plate's, whatever lies under it.
    """
    chord = chord_of(plate)
    inner = plate.zones[number - 1].shape.ring().polygon(chord).buffer(-chord)
    for zone in reversed(plate.zones[: number - 1]):
        if zone.shape.ring().polygon(chord).covers(inner):
            return zone.thickness or plate.thickness
    return plate.thickness


def check_pits(plate: Plate, plates: tuple[FurtherPlate, ...]) -> Iterator[RelativeIssue]:
    """Find pits that lie no deeper than the slab, leave it with their walls, or meet other zones."""
    for position, slab in enumerate(list_plates(plate, plates), start=-1):
        path = ("plate",) if position < 0 else ("plates", position)
        for pit in pits_of(slab):
            place = (*path, "zones", pit.number - 1)
            yield from (issue.below(place) for issue in (*_check_depth(pit), *_check_place(pit, slab)))


def _check_depth(pit: Pit) -> Iterator[RelativeIssue]:
    """Find a pit whose underside lies no deeper than that of the slab around it."""
    if pit.deeper < LEAST_STEP:
        shallow_pit = f"{show(pit.level, 'length')}, with a floor {show(pit.thickness, 'length')} thick"
        expected = f"an underside deeper than that of the slab, below {show(pit.thickness - pit.around, 'length')}"
        hint = "a recess in the top side alone is a zone of less thickness"
        yield RelativeIssue(("level",), shallow_pit, expected, hint)


def _check_place(pit: Pit, slab: AnyPlate) -> Iterator[RelativeIssue]:
    """Find a pit that leaves its plate with its walls, is too narrow for them, or meets another zone."""
    from shapely import union_all

    chord = chord_of(slab)
    outline, *openings = (ring.polygon(chord) for ring in slab.rings())
    outer = pit.outer(chord)
    hint = "its walls reach half their thickness beyond its shape; only a pit within one plate is known"
    if not outline.buffer(2 * chord).covers(outer):
        off = outer.difference(outline).representative_point()
        leaving = f"a pit whose walls leave the plate at {format_place((off.x, off.y))}"
        yield RelativeIssue(("shape",), leaving, "a pit inside the plate, clear of its edges and joints", hint)
    met = outer.intersection(union_all(openings))
    if met.area > chord * outer.length:
        at = met.representative_point()
        meeting = f"a pit whose walls meet an opening at {format_place((at.x, at.y))}"
        yield RelativeIssue(("shape",), meeting, "a pit clear of openings", hint)
    if pit.area(chord).buffer(-(1 + LEAST_WIDTH) * pit.wall / 2).is_empty:
        thick_walls = f"walls of {show(pit.wall, 'length')} in a pit that is hardly wider"
        yield RelativeIssue(("wall",), thick_walls, "walls with a floor between them")
    for number, zone in enumerate(slab.zones, start=1):
        other = zone.shape.ring().polygon(chord)
        around = zone.level is None and number < pit.number and other.buffer(2 * chord).covers(outer)
        if number != pit.number and not around and other.buffer(-chord).intersects(outer):
            zone_met, expected = f"a pit that meets zones[{number}]", "a pit apart from other zones"
            hint = "its walls count with it; a zone before it may lie all around it"
            yield RelativeIssue(("shape",), zone_met, expected, hint)
