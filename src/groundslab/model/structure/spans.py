"""Spans of beams and walls over openings of the plate, from edge to edge, where nothing but they themselves goes on."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from itertools import accumulate, pairwise

from groundslab.geometry.plan import Segment
from groundslab.geometry.validity import TOO_CLOSE
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate
from groundslab.model.plates.region import NO_PART, PlateRegion, get_plate_region, parts_on_plates
from groundslab.model.structure.beams import Beam, RibSection
from groundslab.model.structure.lines import Path, part_of_line
from groundslab.schema.issues import RelativeIssue

#: A line that is longer than its chord by less than this share of it is straight.
STRAIGHT = 1e-9
Ways = tuple[tuple[float, float], ...]


@lru_cache(maxsize=1024)
def ways_on_plates(beam: Beam, plate: AnyPlate, plates: tuple[FurtherPlate, ...] = ()) -> Ways:
    """Return the parts of a beam on the plates, from way to way along it [m], one after the other."""
    region = get_plate_region(plate, plates)
    ways = list[tuple[float, float]]()
    starts = accumulate((edge.length for edge in beam.edges), initial=0.0)
    for edge, low in zip(beam.edges, starts, strict=False):
        for start, end in parts_on_plates(region, edge):
            part = low + start * edge.length, low + end * edge.length
            if ways and part[0] - ways[-1][1] <= NO_PART * beam.length:
                ways[-1] = ways[-1][0], part[1]
            else:
                ways.append(part)
    return tuple(ways)


def spans_of(beam: Beam, plate: AnyPlate, plates: tuple[FurtherPlate, ...] = ()) -> Ways:
    """Return where a beam spans openings of the plate, from way to way along it [m]."""
    return tuple((before, after) for (_, before), (after, _) in pairwise(ways_on_plates(beam, plate, plates)))


def spans_as_segments(beam: Beam, plate: AnyPlate, plates: tuple[FurtherPlate, ...] = ()) -> tuple[Segment, ...]:
    """Return where a beam spans openings of the plate, as straight lines along it."""
    lines = (part_of_line(beam.edges, *span)[0] for span in spans_of(beam, plate, plates))
    return tuple(Segment(line[0], line[-1]) for line in lines)


def paths_on_plates(beam: Beam, plate: AnyPlate, plates: tuple[FurtherPlate, ...] = ()) -> tuple[Path, ...]:
    """Return the parts of a beam that a mesh is to follow, as `Beam.path`."""
    if beam.path is None:
        return ()
    on_plates = ways_on_plates(beam, plate, plates)
    return (beam.path,) if len(on_plates) < 2 else tuple(part_of_line(beam.edges, *part) for part in on_plates)


def check_spans(region: PlateRegion, beams: tuple[Beam, ...]) -> Iterator[RelativeIssue]:
    """Find beams that span an opening otherwise than straight from edge to edge of one plate, and by themselves."""
    from shapely import LineString, Point
    from shapely.ops import substring

    near = TOO_CLOSE * region.size
    for number, beam in enumerate(beams):
        place = ("beams", number, "points" if beam.points is not None else "shape")
        for start, end in spans_of(beam, region.plate, region.plates):
            said = f"{end - start:.3g} m over an opening"
            points, bulges = part_of_line(beam.edges, start, end)
            chord = math.dist(points[0], points[-1])
            if bulges or end - start - chord > STRAIGHT * chord:
                yield RelativeIssue(place, f"{said} with a corner or an arc", "a straight line over an opening")
                continue
            ends = [Point(points[0]), Point(points[-1])]
            if isinstance(beam.section, RibSection):
                hint = "divide the rib, with a rectangle over the opening that reaches onto the plate"
                expected = "a rectangle, a section by its properties or a wall there"
                yield RelativeIssue(place, f"a rib of which {said} have no flange", expected, hint)
            elif not any(all(area.distance(tip) <= region.near for tip in ends) for area in region.areas):
                off_plates = f"{end - start:.3g} m off the plates, from one to another"
                yield RelativeIssue(place, off_plates, "plates that touch where a beam goes on from one to the next")
            elif end - start < near:
                yield RelativeIssue(place, said, f"at least {near:.3g} m", "leave so narrow an opening out")
            else:
                line = LineString(ends)
                inside = substring(line, near, line.length - near)
                yield from _check_alone(place, said, number, inside, beams, near)


def _check_alone(
    place: tuple[str | int, ...], said: str, number: int, line: object, beams: tuple[Beam, ...], near: float
) -> Iterator[RelativeIssue]:
    """Find other beams that a span meets over the opening, where no node joins them."""
    for other, beam in enumerate(beams):
        if other != number and beam.to_shapely(near).distance(line) < near / 2:
            yield RelativeIssue(place, f"{said} where it meets another beam", "one beam over an opening by itself")
            return
