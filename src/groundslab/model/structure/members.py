"""What stiffens the plate: its beams, and the walls that have a height."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from groundslab.geometry.plan import FLAT, Ring
from groundslab.geometry.validity import TOO_CLOSE, find_issues
from groundslab.model.plate import Plate
from groundslab.model.plates.joints import AnyJoint
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, bounds_of, list_plates, shared_line
from groundslab.model.plates.region import PlateRegion, get_plate_region
from groundslab.model.structure.beams import Beam, RectangularSection
from groundslab.model.structure.doors import check_within
from groundslab.model.structure.lines import SAME, part_of_line
from groundslab.model.structure.spans import check_spans, paths_on_plates, spans_of
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.model.supports import AnySupport, check_names, plan_of_plate
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.wording import quote

#: The sine of the angle below which lines run along each other.
FLATTEST = math.sin(math.radians(5))


@lru_cache(maxsize=64)
def members_of(beams: tuple[Beam, ...], walls: tuple[Wall, ...], plates: tuple[AnyPlate, ...]) -> tuple[Beam, ...]:
    """Return beams, and after them walls that have a height, as deep beams."""
    return *beams, *(part for wall in place_walls(walls, plates) for part in wall_beams(wall))


@lru_cache(maxsize=64)
def wall_of_members(beams: tuple[Beam, ...], walls: tuple[Wall, ...], plates: tuple[AnyPlate, ...]) -> tuple[int, ...]:
    """Return of which wall each member is a part, -1 of beams."""
    parts = [number for number, wall in enumerate(place_walls(walls, plates)) for _ in wall_beams(wall)]
    return (-1,) * len(beams) + tuple(parts)


def wall_beams(wall: Wall) -> tuple[Beam, ...]:
    """Return a wall that has a height and stands on its axis as deep beams: parts of it as high as they are.

    Over an opening what is left of the height counts.
    """
    assert wall.height is not None
    cuts = _cuts(wall)
    parts = []
    for start, end in pairwise(cuts):
        middle = (start + end) / 2
        open_there = max(
            (opening.height for opening in wall.openings if opening.start < middle < opening.end), default=0.0
        )
        alone = len(cuts) == 2
        points, bulges = part_of_line(wall.edges, start, end)
        parts.append(
            Beam(
                name=wall.name if alone else f"{wall.name}, {start:g} m to {end:g} m",
                **({"shape": wall.shape} if alone and wall.shape is not None else {"points": points, "bulges": bulges}),
                section=RectangularSection(width=wall.thickness, height=wall.height - open_there),
                E=wall.E,
                nu=wall.nu,
                stiffness=wall.stiffness,
            )
        )
    return tuple(parts)


def as_beam(wall: Wall) -> Beam:
    """Return a wall that has a height, without its openings, as one deep beam."""
    return wall_beams(wall.model_copy(update={"openings": ()}))[0]


def _cuts(wall: Wall) -> list[float]:
    """Return the ways along a wall [m] at which it or an opening in it begins or ends, each once."""
    length = wall.length
    ways = {min(way, length) for opening in wall.openings for way in (opening.start, opening.end)} - {length}
    cuts = [0.0, *(way for way in sorted(ways) if SAME * length < way < (1 - SAME) * length), length]
    return [cut for cut, before in zip(cuts, [-math.inf, *cuts], strict=False) if cut - before > SAME * length]


def curved_beams(beams: tuple[Beam, ...], plates: tuple[AnyPlate, ...]) -> tuple[Ring, ...]:
    """Return the closed curves with arcs along which beams run, but for those that are edges of plates."""
    edges = [ring for plate in plates for ring in plate.rings()]
    rings = (beam.shape.ring() for beam in beams if beam.shape is not None and beam.path is None)
    return tuple(ring for ring in rings if ring not in edges)


def check_members(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    joints: tuple[AnyJoint, ...],
    supports: tuple[AnySupport, ...],
    beams: tuple[Beam, ...],
    walls: tuple[Wall, ...],
) -> Iterator[RelativeIssue]:
    """Find beams and walls with a height that leave the plate or cross a joint, lie on each other, or cannot be met.

    Of a wall its axis counts, along which the mesh runs.
    """
    yield from check_names("beams", [beam.name for beam in beams], needed=True)
    every = list_plates(plate, plates)
    where = [("beams", number) for number in range(len(beams))]
    x0, x1, y0, y1 = bounds_of(plate, plates)
    near = TOO_CLOSE * max(x1 - x0, y1 - y0)
    for number, wall in enumerate(walls):
        if wall.height is None:
            continue
        for placed in place_walls([wall], every):
            unfit = [*_check_stiff_wall(number, placed, near)]
            unfit += [] if unfit else _check_openings_on_plate(number, placed, near, (plate, plates))
            yield from unfit
            parts = () if unfit else wall_beams(placed)
            beams, where = (*beams, *parts), [*where, *[("walls", number)] * len(parts)]
    if not beams:
        return
    region = get_plate_region(plate, plates)
    off = [*_check_on_plates(region, beams), *_check_joints(every, joints, beams)]
    off += [] if off else [*check_spans(region, beams), *_check_hinges(region, beams)]
    yield from (_at_place(issue, where) for issue in off)
    if off:
        return
    yield from (_at_place(issue, where) for issue in _check_apart(beams, near))
    paths = [(number, path) for number, beam in enumerate(beams) for path in paths_on_plates(beam, plate, plates)]
    before = sum(bool(support.edges) for support in supports)
    beams_by_line = dict(enumerate((number for number, _ in paths), start=before + 1))
    lines = tuple(path for _, path in paths)
    for issue in find_issues(plan_of_plate(plate, supports, plates=plates, lines=lines)):
        # the beam at which the issue is, or else the first one that it names
        for text in (issue.location, issue.found):
            if numbers := [number for count, number in beams_by_line.items() if f"plate.lines[{count}]" in text]:
                worded = _with_names(issue.found, {count: where[number] for count, number in beams_by_line.items()})
                yield _at_place(
                    RelativeIssue(("beams", numbers[0], "points"), worded, issue.expected, issue.hint), where
                )
                break
    yield from (_at_place(issue, where) for issue in _check_curves(every, beams))


def _check_stiff_wall(number: int, wall: Wall, near: float) -> Iterator[RelativeIssue]:
    """Find openings of walls with a height that are none, or leave parts shorter than elements may be near [m]."""
    place = ("walls", number)
    assert wall.height is not None
    yield from (issue.below(place) for issue in check_within(wall))
    for position, opening in enumerate(wall.openings):
        if opening.height >= wall.height:
            expected = f"less than the wall's, {wall.height!r} m"
            yield RelativeIssue((*place, "openings", position, "height"), f"{opening.height!r} m", expected)
    shortest = min((end - start for start, end in pairwise(_cuts(wall))), default=near)
    if shortest < near:
        hint = "let openings begin or end together, or leave a short one out"
        short_part = f"openings that leave a part of {shortest:.3g} m"
        yield RelativeIssue((*place, "openings"), short_part, f"parts of at least {near:.3g} m", hint)


def _check_openings_on_plate(
    number: int, wall: Wall, near: float, plates: tuple[Plate, tuple[FurtherPlate, ...]]
) -> Iterator[RelativeIssue]:
    """Find openings of walls that begin or end, within near [m], over an opening of the plate."""
    spans = spans_of(as_beam(wall), *plates)
    for position, opening in enumerate(wall.openings):
        if any(start - near < way < end + near for start, end in spans for way in (opening.start, opening.end)):
            over_opening = "an opening that begins or ends over an opening of the plate"
            expected = "one that does where the wall stands on the plate, or a wall without it"
            yield RelativeIssue(("walls", number, "openings", position), over_opening, expected)


def _with_names(text: str, names: dict[int, tuple[str, int]]) -> str:
    """Return what was found with the names of the case for lines of the plan, by their numbers from 1."""

    def name(match: re.Match[str]) -> str:
        kind, number = names.get(int(match[1]), ("supports", int(match[1]) - 1))
        return f"{kind}[{number + 1}]"

    return re.sub(r"plate\.lines\[(\d+)\]", name, text)


def _check_curves(plates: tuple[AnyPlate, ...], beams: tuple[Beam, ...]) -> Iterator[RelativeIssue]:
    """Find closed curves with arcs along which beams run that touch an edge of a plate, but for those that are one."""
    edges = [ring for plate in plates for ring in plate.rings()]
    for number, beam in enumerate(beams):
        if beam.shape is None or beam.path is not None or (ring := beam.shape.ring()) in edges:
            continue
        chord = FLAT * max(max(edge.sides) for edge in edges)
        hull = ring.polygon(chord).exterior
        near = TOO_CLOSE * max(max(edge.sides) for edge in edges)
        if any(hull.distance(edge.polygon(chord).exterior) < near for edge in edges):
            expected = f"a curve at least {near:.3g} m from the plate's edges, or all along one"
            touching, hint = (
                "a curve with arcs that touches an edge of the plate",
                "give arcs by points and bulges instead",
            )
            yield RelativeIssue(("beams", number, "shape"), touching, expected, hint)


def _at_place(issue: RelativeIssue, where: list[tuple[str, int]]) -> RelativeIssue:
    """Return an issue of a member at the beam or the wall that it is."""
    _, number, *rest = issue.place
    kind, position = where[int(number)]
    return replace(issue, place=(kind, position, *(rest if kind == "beams" else ())))


def _check_on_plates(region: PlateRegion, beams: tuple[Beam, ...]) -> Iterator[RelativeIssue]:
    """Find members of which a part lies off the plates, but for what spans an opening."""
    from shapely import unary_union

    chord = 1e-4 * region.size
    for number, beam in enumerate(beams):
        axis = beam.to_shapely(chord)
        areas = [area.buffer(max(region.near, 2 * chord * (beam.shape is not None)), join_style="mitre")
                 for area in region.areas]  # fmt: skip
        if unary_union(areas).covers(axis):
            continue
        spans = sum((end - start for start, end in spans_of(beam, region.plate, region.plates)), 0.0)
        place = ("beams", number, "points" if beam.points is not None else "shape")
        over = axis.length - unary_union(areas).intersection(axis).length - spans
        if over <= max(region.near, 2 * chord):
            continue
        off_plate = f"{over:.3g} m of {axis.length:.3g} m that do not lie on the plate"
        hint = "over an opening it is straight from edge to edge, and in one part" if spans else "shorten or divide it"
        yield RelativeIssue(place, off_plate, "a beam that begins and ends on the plate", hint)


def _check_hinges(region: PlateRegion, beams: tuple[Beam, ...]) -> Iterator[RelativeIssue]:
    """Find hinged ends inside a plate, which goes on there beside the beam and takes its moment.

    How much of it would depend on the size of the elements, over one of which the beam were released.
    """
    from shapely import Point, unary_union

    edge = unary_union([area.boundary for area in region.areas])
    for number, beam in enumerate(beams):
        for end, joined in zip(beam.ends, beam.joined, strict=False):
            if joined == "hinged" and edge.distance(Point(end)) > max(region.near, region.rounding):
                hinge = "a hinged end inside the plate, which goes on beside the beam and takes its moment"
                hint = "end the beam at an edge, or leave joined out"
                yield RelativeIssue(("beams", number, "joined"), hinge, "hinged ends on edges of the plate alone", hint)


def _check_joints(
    plates: tuple[AnyPlate, ...], joints: tuple[AnyJoint, ...], beams: tuple[Beam, ...]
) -> Iterator[RelativeIssue]:
    """Find beams along joints, of which nobody knows which plate they stiffen."""
    from shapely import Point, get_parts

    by_name = {plate.name: plate for plate in plates}
    for joint in joints:
        if not all(name in by_name for name in joint.between):
            continue
        line = shared_line(*(by_name[name] for name in joint.between))
        for number, beam in enumerate(beams):
            near = TOO_CLOSE * line.length
            shared = line.buffer(near, cap_style="flat").intersection(beam.to_shapely(near))
            if max(part.length for part in get_parts([shared, Point()])) > 2 * near / FLATTEST:
                along = f"a beam along the joint {quote(joint.title)}"
                yield RelativeIssue(("beams", number), along, "a beam on one of the plates", "move it off the joint")


def _check_apart(beams: tuple[Beam, ...], near: float) -> Iterator[RelativeIssue]:
    """Find beams of which a part lies along another one."""
    axes = [beam.to_shapely(near) for beam in beams]
    for number, axis in enumerate(axes):
        twice = axis.length - axis.union(axis).length
        if twice > 4 * near:
            along_itself = f"a beam that runs back along {twice:.3g} m of itself"
            yield RelativeIssue(("beams", number), along_itself, "one beam at each place", "leave that part out")
    for (first, a), (other, b) in itertools.combinations(enumerate(axes), 2):
        if a.distance(b) > near:
            continue
        shared = b.intersection(a.buffer(near, cap_style="flat")).length
        if shared > 4 * near and shared > near / FLATTEST:
            along_other = f"a beam along {shared:.3g} m of {quote(beams[first].name)}"
            hint = "one beam with a section that stands for both"
            yield RelativeIssue(("beams", other), along_other, "one beam at each place", hint)
