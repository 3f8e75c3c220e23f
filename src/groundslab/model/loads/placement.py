"""Checks that loads, columns, walls, outputs and voids lie on the plate and name what there is; weights of members."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Protocol

from groundslab.geometry.plan import format_place
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import AnyLoad, PointLoad, SelfWeight, Spread
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, list_plates
from groundslab.model.plates.pits import chord_of, pits_of
from groundslab.model.plates.region import NO_PART, PlateRegion, get_plate_region
from groundslab.model.shapes import CHORD
from groundslab.model.structure.beams import Beam, RectangularSection
from groundslab.model.structure.columns import Column
from groundslab.model.structure.cores import Core
from groundslab.model.structure.lines import line_segments, part_of_line
from groundslab.model.structure.spans import spans_of, ways_on_plates
from groundslab.model.structure.walls import Wall
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.repairs import use_nearest
from groundslab.schema.wording import describe, one_of, suggestion
from groundslab.units import coordinate

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


class Placed(Protocol):
    """Anything with a position in plan."""

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return it, arcs as chords at most so far off [m]."""
        ...


def on_plate(covered: PlateRegion, part: Placed, place: tuple[str | int, ...]) -> Iterator[RelativeIssue]:
    """Find a part that does not lie on the plate."""
    (x0, x1, y0, y1), near, plate = covered.bounds, covered.rounding, covered.plate
    about_origin = plate.outline is None and not covered.plates
    hint = "the center of the plate is the origin" if about_origin else "places are those of the outline"
    outside = False
    for axis, low, high in (("x", x0, x1), ("y", y0, y1)):
        value = getattr(part, axis, None)
        values = () if value is None else value if isinstance(value, tuple) else (value,)
        if any(not low - near <= value <= high + near for value in values):
            said = [f"{coordinate(value)!r} m" for value in (*values, low, high)]
            where = said[0] if len(values) == 1 else f"[{', '.join(said[:-2])}]"
            yield RelativeIssue((*place, axis), where, f"a position on the plate, from {said[-2]} to {said[-1]}", hint)
            outside = True
    # for points and what runs along the sides of a rectangle that is all
    plain = plate.outline is None and not plate.openings and not covered.plates
    if not outside and not (plain and getattr(part, "x", None) is not None and not _has_footprint(part)):
        yield from _on_shape(covered, part, place)


def _has_footprint(part: Placed) -> bool:
    return getattr(part, "width_x", None) is not None or getattr(part, "diameter", None) is not None


def _on_shape(covered: PlateRegion, part: Placed, place: tuple[str | int, ...]) -> Iterator[RelativeIssue]:
    """Find a part off the plate, also within the rectangle around it."""
    expected = "a place on the plate, not in an opening or outside the outline"
    (x0, x1, y0, y1), far = covered.bounds, covered.size
    # arcs drawn roughly: chords so short would be too many for what is so large
    left, low, right, high = part.to_shapely(math.inf).bounds
    if not (x0 - far <= left and right <= x1 + far and y0 - far <= low and high <= y1 + far):
        yield RelativeIssue(place, "a part that reaches far off the plate", expected)
        return
    loaded = part.to_shapely(CHORD * covered.size)
    if not covered.reach.covers(loaded):
        left = loaded.difference(covered.area)
        off = left.representative_point()
        outside, hint = f"a part off the plate, at {format_place((off.x, off.y))} m", ""
        if _has_footprint(part) and left.area < loaded.area:
            outside = f"a footprint of which {100 * left.area / loaded.area:.3g} % lies off the plate"
            hint = "move it or make it smaller; a force is not cut off at the edge as a pressure is"
        yield RelativeIssue(place, outside, expected, hint)


def check_point_loads(
    plate: Plate, plates: tuple[FurtherPlate, ...], loads: tuple[AnyLoad, ...]
) -> Iterator[RelativeIssue]:
    """Find point loads that do not lie on the plate; those on columns lie where these do.

    A footprint must lie on the plate entirely. What is spread over an area or along a line is cut off at the plate's
    edge instead, see `clipping`: there the pressure is given, here the force, of which nothing may be lost.
    """
    covered = PlateRegion(plate, plates)
    for position, load in enumerate(loads):
        on_column = isinstance(load, PointLoad) and load.column
        if hasattr(load, "to_shapely") and not isinstance(load, Spread) and not on_column:
            yield from on_plate(covered, load, ("loads", position))


def check_load_columns(loads: tuple[AnyLoad, ...], columns: tuple[Column, ...]) -> Iterator[RelativeIssue]:
    """Find loads on unknown columns."""
    yield from _check_names_of(loads, "column", [column.name for column in columns])


def check_load_cores(loads: tuple[AnyLoad, ...], cores: tuple[Core, ...]) -> Iterator[RelativeIssue]:
    """Find loads of unknown cores."""
    yield from _check_names_of(loads, "core", [core.name for core in cores])


def check_load_walls(loads: tuple[AnyLoad, ...], walls: tuple[Wall, ...]) -> Iterator[RelativeIssue]:
    """Find loads on unknown walls, and those that vary along a wall without ends."""
    yield from _check_names_of(loads, "wall", [wall.name for wall in walls])
    closed = {wall.name for wall in walls if wall.shape is not None or wall.edge == "all"}
    for position, load in enumerate(loads):
        if isinstance(load, LineLoad | LineMoment) and load.wall in closed:
            key = "q_end" if isinstance(load, LineLoad) else "m_end"
            if getattr(load, key) is not None:
                varying = f"{key} on wall {describe(load.wall)}, a closed curve"
                hint = "all of a closed wall bears the same"
                yield RelativeIssue(("loads", position, key), varying, "a wall with two ends", hint)


def _check_names_of(loads: tuple[AnyLoad, ...], key: str, names: list[str]) -> Iterator[RelativeIssue]:
    """Find loads on unknown columns, walls or cores."""
    known_names = {"", *names}
    for position, load in enumerate(loads):
        name = getattr(load, key, "")
        if name not in known_names:
            expected = one_of(names) if names else f"a {key}, and [[{key}s]] that says where it is"
            place = ("loads", position, key)
            hint, repairs = suggestion(name, names), use_nearest(place, name, names)
            yield RelativeIssue(place, describe(name), expected, hint, repairs)


def _parts_by_thickness(
    beam: Beam, plate: AnyPlate, way: tuple[float, float]
) -> Iterator[tuple[float, tuple[float, float]]]:
    """Yield the thickness of a plate [m] along a part of a beam, and from way to way [m] where it is that."""
    if not plate.zones or not isinstance(beam.section, RectangularSection):
        yield plate.thickness, way
        return
    from shapely import Point

    axis = beam.to_shapely(CHORD * max(plate.sides))
    zones = [(zone.shape.ring().polygon(CHORD * max(plate.sides)), zone.thickness) for zone in plate.zones]
    share = beam.length / axis.length
    met = (axis.intersection(zone.boundary) for zone, _ in zones)
    places = (part for shape in met for part in getattr(shape, "geoms", [shape]) if not part.is_empty)
    cuts = {float(axis.project(Point(place))) * share for part in places for place in (part.coords[0], part.coords[-1])}
    near = NO_PART * beam.length
    ways = [way[0], *(cut for cut in sorted(cuts) if way[0] + near < cut < way[1] - near), way[1]]
    for start, end in pairwise(ways):
        middle = axis.interpolate((start + end) / 2 / share)
        thicknesses = [thickness for zone, thickness in zones if zone.covers(middle)]
        yield (thicknesses[-1] if thicknesses else None) or plate.thickness, (start, end)


def weights_of(
    beams: tuple[Beam, ...], plate: Plate, plates: tuple[FurtherPlate, ...], load: SelfWeight
) -> Iterator[LineForce]:
    """Yield the weight of each beam of concrete along its axis, on the plates that a load names.

    Over an opening there is nothing of the plate in it.
    """
    every, region = list_plates(plate, plates), get_plate_region(plate, plates)
    for beam in beams:
        parts = [(slab, beam.beside_plate(thickness), part) for slab in every for way in ways_on_plates(beam, slab)
                 for thickness, part in _parts_by_thickness(beam, slab, way)]  # fmt: skip
        for start, end in spans_of(beam, plate, plates):
            points, _ = part_of_line(beam.edges, start, end)
            parts.append((every[region.plate_at(points[0])], beam.beside_plate(0.0), (start, end)))
        for slab, area, way in parts:
            if area > 0 and load.plate in ("", slab.name):
                whole = way[1] - way[0] >= (1 - NO_PART) * beam.length
                edges = beam.edges if whole else line_segments(*part_of_line(beam.edges, *way), None)
                yield LineForce(edges, q=(load.unit_weight * area,) * 2)


def weights_of_pits(plate: Plate, plates: tuple[FurtherPlate, ...], load: SelfWeight) -> Iterator[LineForce]:
    """Yield the weight of the walls of each pit along their axes, on the plates that a load names."""
    for slab in list_plates(plate, plates):
        for pit in pits_of(slab) if load.plate in ("", slab.name) else ():
            edges = pit.ring.segments()
            q = load.unit_weight * pit.volume(chord_of(slab)) / sum(edge.length for edge in edges)
            yield LineForce(edges, q=(q, q))
