"""Thicker zones of a plate with columns on them, whose forces punch the thinner slab around.

A zone is a connected part of the plate of at least some thickness. Of zones in each other every step down to thinner
slab has one. Perimeters run around it as around a column, what it covers and its hull being loaded: so EN 1992-1-1
6.4.2(8) to (11) has the sections outside of enlarged column heads, and ACI 318-19 22.6.4.1(b) those at changes of
thickness. What pushes is the sum of the columns on the zone less the piles below it, with the moments of all of them.
A pit is no zone of the slab around it: its floor lies at another level.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.design.demands.by_plate import split_by_level, split_by_plate
from groundslab.design.demands.perimeter_loads import PunchingForce, punching_columns, punching_piles, reach_of
from groundslab.design.demands.perimeters import Perimeter, ZoneFootprint, area_of, outline
from groundslab.fem.mesh import SIDES
from groundslab.geometry.places import same_place
from groundslab.geometry.rectangles import direction_at
from groundslab.messages import Message, Name, series
from groundslab.model.plates.other_plates import first_sections
from groundslab.model.structure.columns import Column
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely import Polygon

#: Thicknesses that differ by a smaller share are the same.
SAME = 1e-9
#: What covers more of its plate than this is the slab itself: one-way shear is checked in what is left.
MOST = 0.5
#: A zone without recesses covers all of its hull but for a smaller share.
RECESS = 1e-6
#: Edges are near a zone up to this over the effective depth: the perimeters of EN 1992-1-1 reach so far.
NEAR = 2.0
#: Centers of zones are rounded to so many digits [m].
PLACES = 9
#: So many columns of a zone are named.
MOST_NAMED = 3


@dataclass(frozen=True)
class ZoneForce(PunchingForce):
    """A thicker zone with the columns on it, which push it down on the slab around."""

    region: Polygon | None = None
    around: float = 0.0  # the largest thickness of the slab at its border [m]
    forces: tuple[PunchingForce, ...] = ()  # of the columns on it and the piles below

    @property
    def key(self) -> tuple[bool, str]:
        """Return what no other has."""
        return False, f"\0{self.name}"

    @property
    def columns(self) -> tuple[str, ...]:
        """Return the names of the columns on it."""
        return tuple(name for force in self.forces for name in force.columns)

    @property
    def supports(self) -> tuple[int, ...]:
        """Return the numbers of the piles below it."""
        return tuple(number for force in self.forces for number in force.supports)

    @property
    def at_zone(self) -> bool:
        """Return that it is a zone."""
        return True

    def edges_within(self, d: float) -> float:
        """Return how far away edges are that perimeters may run out to [m], by the depth [m].

        A zone may be so wide that a perimeter around a corner of the plate is shorter than one around the zone.
        """
        return NEAR * d

    def area_inside(self, line: Perimeter, distance: float) -> Polygon:
        """Return where what acts counts as inside of a perimeter at a distance [m].

        No crack runs from the zone to ground in a recess of its outline, which therefore takes nothing off.
        """
        region = self.region
        assert region is not None
        if region.area > (1 - RECESS) * region.convex_hull.area:
            return line.inside
        return line.inside.intersection(region.buffer(reach_of(line, distance), join_style="mitre"))

    @cached_property
    def footprint(self) -> ZoneFootprint:
        """Return the zone as what is loaded."""
        assert self.region is not None
        c, s = direction_at(self.column.angle)
        return ZoneFootprint(self.region, np.array([[c, s], [-s, c]]))

    def thickness(self, results: CombinationResult) -> float:  # noqa: ARG002
        """Return the thickness of the slab around [m], where it is largest."""
        return self.around

    def acting(self, results: CombinationResult) -> Array:
        """Return the sum of the forces [N], downwards, and their moments about the zone's center [N m] (3,)."""
        sums = np.zeros(3)
        for force in self.forces:
            P, *moments = force.pushing(results)
            about = np.array(moments) + P * np.subtract(force.place, self.place)
            sums += (-1.0 if force.from_below else 1.0) * np.array([P, *about])
        return sums


@made_once
def zone_forces(combined: Results) -> tuple[ZoneForce, ...]:
    """Return the thicker zones with columns on them, by the plates and in the order of their thickness."""
    first = next(iter(combined.results.values()), None)
    if first is None or not combined.model.columns or np.ptp(first.elements.thickness) == 0:
        return ()
    forces = (*punching_columns(combined.solved_model), *punching_piles(combined.model))
    sections = first_sections(combined.model.every_plate)
    zones = [
        _called(zone, Message("{zone} of {plate}", zone=zone.name, plate=Name(plate)))
        if combined.model.plates
        else zone
        for (plate, results), section in zip(split_by_plate(first).items(), sections, strict=True)
        for at_level in split_by_level(results)
        for zone in _zones(at_level, forces, section)
    ]
    count = Counter(zone.name for zone in zones)
    return tuple(_told_apart(zone) if count[zone.name] > 1 else zone for zone in zones)


def _told_apart(zone: ZoneForce) -> ZoneForce:
    """Return a zone whose name says which columns are on it."""
    names = zone.columns[:MOST_NAMED]
    more = " ..." if len(zone.columns) > MOST_NAMED else ""
    return _called(zone, Message("{zone} at {columns}", zone=zone.name, columns=series(map(Name, names)) + more))


def _called(zone: ZoneForce, name: str) -> ZoneForce:
    """Return a zone by another name."""
    return replace(zone, column=zone.column.replace(name=name))


def _zones(results: CombinationResult, forces: Sequence[PunchingForce], section: int) -> Iterator[ZoneForce]:
    """Yield the thicker zones of one plate, whose own section has a number."""
    from shapely import Polygon, contains_xy, get_parts, intersection

    plan, thickness = outline(results.plate), results.elements.thickness
    x0, y0, x1, y1 = plan.bounds
    rounding = same_place(x0, x1, y0, y1)
    zones: list[ZoneForce] = []
    on_plate = [force for force in forces if plan.buffer(rounding).covers(force.footprint.footprint())]
    for level in np.unique(thickness)[1:]:
        those = thickness >= (1 - SAME) * level
        for part in get_parts(area_of(results.plate.nodes, results.plate.elements[those])):
            wide = part.buffer(rounding)
            on = tuple(force for force in on_plate if wide.covers(force.footprint.footprint()))
            around = _thickest_at(results, ~those, part, rounding)
            if not around or not any(force.columns for force in on) or part.area > MOST * plan.area:
                continue
            # a thinner place in the zone is none of its border
            loaded = intersection(Polygon(part.exterior), plan) if part.interiors else part
            loaded = max(get_parts(loaded), key=lambda piece: piece.area).simplify(rounding)
            if any(zone.region == loaded for zone in zones):
                continue
            middles = results.plate.nodes[results.plate.elements[:, -1]]
            sections = np.unique(results.elements.section[those & contains_xy(part, *middles.T)]) - section
            column = _around(loaded, _name([int(number) for number in sections if number > 0]))
            zones.append(ZoneForce(column, {}, region=loaded, around=around, forces=on))
    yield from zones


def _thickest_at(results: CombinationResult, others: Array, part: Polygon, rounding: float) -> float:
    """Return the largest thickness of other elements at the border of a part [m]; 0 if there are none."""
    from shapely import dwithin, points

    middles = results.plate.nodes[results.plate.elements[others][:, SIDES[:, 2]]]
    at_border = dwithin(part.exterior, points(middles), rounding).any(axis=1)
    return float(results.elements.thickness[others][at_border].max(initial=0.0))


def _name(numbers: Sequence[int]) -> str:
    """Return what checks call a part of the plate that consists of zones with numbers from 1."""
    if not numbers:
        return "thicker slab"
    if len(numbers) == 1:
        return Message("zone {number}", number=numbers[0])
    return Message("zones {numbers}", numbers=series(map(str, numbers)))


def _around(region: Polygon, name: str) -> Column:
    """Return a column as wide as the smallest rectangle around a region, at an angle of 45 degrees at most."""
    from shapely import get_coordinates

    corners = get_coordinates(region.minimum_rotated_rectangle)[:4]
    sides = np.diff(corners, axis=0)[:2]
    angles = np.degrees(np.arctan2(sides[:, 1], sides[:, 0]))
    turned = (angles + 45) % 180 - 45
    along = int(np.argmin(np.abs(turned)))
    angle = float(np.round(turned[along], 9)) % 180
    widths = np.linalg.norm(sides, axis=1)
    x, y = np.round(corners.mean(axis=0), PLACES)
    return Column(
        name=name,
        x=float(x),
        y=float(y),
        width_x=float(widths[along]),
        width_y=float(widths[1 - along]),
        angle=angle - 180 if angle > 90 else angle,
    )
