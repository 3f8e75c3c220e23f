"""Beams and ribs cast with the plate: where they run, and their sections."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from groundslab.geometry.plan import Ring, Segment
from groundslab.geometry.validity import TOO_CLOSE, find_issues
from groundslab.model.ground import POISSON, POSITIVE
from groundslab.model.plate import Plate
from groundslab.model.plates.further import AnyPlate, FurtherPlate, bounds_of, list_plates, shared_line
from groundslab.model.plates.joints import AnyJoint
from groundslab.model.plates.region import PlateRegion
from groundslab.model.shapes import AnyShape
from groundslab.model.structure.lines import (
    LinePoints,
    LineShape,
    check_line,
    check_line_length,
    flat_line,
    line_area,
    line_segments,
)
from groundslab.model.supports import AnySupport, check_names, plan_of_plate
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import quote

if TYPE_CHECKING:
    from shapely import LineString, Polygon

#: The shear area of a rectangle over its area (Timoshenko 1921; Cowper 1966 for nu = 0).
SHEAR_SHARE = 5 / 6


def torsion_constant(width: float, height: float) -> float:
    """Return J of a rectangle [m4], within 0.2 % (Young and Budynas, Roark's Formulas for Stress and Strain, 10.7)."""
    a, b = max(width, height), min(width, height)
    return a * b**3 * (1 / 3 - 0.21 * b / a * (1 - (b / a) ** 4 / 12))


class _Rectangle(Section):
    """What a rectangle has."""

    kind: str
    width: Annotated[float, Quantity("length", "b_w", "width", POSITIVE)]
    height: Annotated[float, Quantity("length", "h_w", "height, of a rib that beside the plate", POSITIVE)]

    @property
    def second_moment(self) -> float:
        """Return I about its own axis [m4]."""
        return self.width * self.height**3 / 12

    @property
    def torsion_constant(self) -> float:
        """Return J [m4]."""
        return torsion_constant(self.width, self.height)

    @property
    def shear_area(self) -> float:
        """Return the area that carries shear [m2]."""
        return SHEAR_SHARE * self.width * self.height


class RectangularSection(_Rectangle):
    """A rectangle about the plate's middle plane, in addition to the plate."""

    kind: Annotated[Literal["rectangle"], Table("a rectangle about the plate's middle plane, added to the plate")] = (
        "rectangle"
    )


class RibSection(_Rectangle):
    """A rib below or above the plate, a strip of which is its flange."""

    kind: Annotated[Literal["rib"], Table("a rib below or above the plate, a strip of which is its flange")] = "rib"
    effective_width: Annotated[
        float, Quantity("length", "b_eff", "width of the plate that acts as the flange", POSITIVE)
    ]
    side: Annotated[
        Literal["below", "above"],
        Choice(Literal["below", "above"], "side of the plate on which it lies, for its bars", ""),
    ] = "below"


class GivenSection(Section):
    """A section of which the properties are given, such as of steel."""

    kind: Annotated[Literal["properties"], Table("a section of which the properties are given, such as of steel")] = (
        "properties"
    )
    second_moment: Annotated[
        float, Quantity("second moment of area", "I", "second moment of area about the plate's middle plane", POSITIVE)
    ]
    torsion_constant: Annotated[
        float, Quantity("second moment of area", "J", "torsion constant; 0 resists no torsion", Range(at_least=0))
    ] = 0.0
    shear_area: Annotated[float, Quantity("area", "A_v", "area that carries shear", POSITIVE)]


BeamSection = RectangularSection | RibSection | GivenSection


def _check_points_or_shape(
    points: tuple[tuple[float, float], ...] | None, shape: AnyShape | None
) -> Iterator[RelativeIssue]:
    yield from check_line(points, shape, {}, "a closed curve has no ends", "the axis")


def _check_length(points: tuple[tuple[float, float], ...] | None) -> Iterator[RelativeIssue]:
    yield from check_line_length(points, ())


class Beam(Section):
    """A beam or rib that bends, shears and twists with the plate, on whose middle plane its axis is taken to lie."""

    checks: ClassVar[tuple[Check, ...]] = (_check_points_or_shape, _check_length)

    name: Annotated[str, Text("name of the beam")]
    points: LinePoints = None
    shape: LineShape = None
    section: Annotated[BeamSection, ByKind(), Table("the section")]
    E: Annotated[float | None, Quantity("pressure", "E", "Young's modulus, by default that of the plate", POSITIVE)] = (
        None
    )
    nu: Annotated[float | None, Number("nu", "Poisson's ratio, by default that of the plate", POISSON)] = None
    bar_axis: Annotated[
        float | None,
        Quantity(
            "length",
            "d_1",
            "distance of its bars' axes from its faces, by default the larger one of the plate's bars there",
            POSITIVE,
        ),
    ] = None

    @property
    def edges(self) -> tuple[Segment, ...]:
        """Return the straight pieces and arcs of its axis, one after the other."""
        return line_segments(self.points, (), self.shape)

    @property
    def closed(self) -> bool:
        """Return whether the axis ends where it starts."""
        return self.shape is not None or (self.points is not None and self.points[0] == self.points[-1])

    @property
    def length(self) -> float:
        """Return the length of its axis [m]."""
        return sum(edge.length for edge in self.edges)

    @property
    def width(self) -> float:
        """Return the width of its section [m], 0 of one by its properties."""
        return 0.0 if isinstance(self.section, GivenSection) else self.section.width

    @property
    def ends(self) -> tuple[tuple[float, float], ...]:
        """Return the places where it ends, none of a closed one."""
        return () if self.closed else (self.edges[0].start, self.edges[-1].end)

    @property
    def line(self) -> tuple[tuple[float, float], ...]:
        """Return the places that its axis runs through if it is straight between them, none if it has arcs."""
        if self.points is not None:
            return self.points
        edges = self.edges
        return (*(edge.start for edge in edges), edges[-1].end) if all(edge.straight for edge in edges) else ()

    def rigidities(self, E: float, nu: float, thickness: float) -> tuple[float, float, float]:
        """Return E I, G J [N m2] and G A_v [N] on a plate with E [Pa], nu and a thickness [m].

        Those of a rib are what it adds to the plate: E I is that of the T or L about its centroid, less that of the
        flange alone.
        """
        own, section = E if self.E is None else self.E, self.section
        G = own / (2 * (1 + (nu if self.nu is None else self.nu)))
        bending = own * section.second_moment
        if isinstance(section, RibSection):
            rib, flange = own * section.width * section.height, E * section.effective_width * thickness
            bending += rib * flange / (rib + flange) * ((thickness + section.height) / 2) ** 2
        return bending, G * section.torsion_constant, G * section.shear_area

    def to_shapely(self, chord: float) -> LineString:
        """Return the axis, arcs as chords at most so far off [m]."""
        return flat_line(self.edges, chord)

    def area(self, chord: float) -> Polygon:
        """Return what the beam covers in plan, the thinnest strip where it has no width; arcs as for `to_shapely`."""
        return line_area(self.to_shapely(chord), max(self.width, 2 * chord), closed=self.closed)


def curved_beams(beams: tuple[Beam, ...], plates: tuple[AnyPlate, ...]) -> tuple[Ring, ...]:
    """Return the closed curves with arcs along which beams run, but for those that are edges of plates."""
    edges = [ring for plate in plates for ring in plate.rings()]
    rings = (beam.shape.ring() for beam in beams if beam.shape is not None and not beam.line)
    return tuple(ring for ring in rings if ring not in edges)


def check_beams(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    joints: tuple[AnyJoint, ...],
    supports: tuple[AnySupport, ...],
    beams: tuple[Beam, ...],
) -> Iterator[RelativeIssue]:
    """Find beams that leave the plate or cross a joint, lie on each other, or along which no mesh can run."""
    if not beams:
        return
    yield from check_names("beams", [beam.name for beam in beams], needed=True)
    off = [
        *_check_on_one_plate(PlateRegion(plate, plates), beams),
        *_check_joints(list_plates(plate, plates), joints, beams),
    ]
    yield from off
    if off:
        return
    x0, x1, y0, y1 = bounds_of(plate, plates)
    yield from _check_apart(beams, TOO_CLOSE * max(x1 - x0, y1 - y0))
    straight = {number: beam.line for number, beam in enumerate(beams) if beam.line}
    before = sum(bool(support.edges) for support in supports)
    for issue in find_issues(plan_of_plate(plate, supports, plates=plates, lines=(*straight.values(),))):
        for count, number in enumerate(straight, start=before + 1):
            name = f"plate.lines[{count}]"
            if name == issue.location or name in issue.found:
                found = issue.found.replace(name, f"beams[{number + 1}]")
                yield RelativeIssue(("beams", number, "points"), found, issue.expected, issue.hint)
                break


def _check_on_one_plate(region: PlateRegion, beams: tuple[Beam, ...]) -> Iterator[RelativeIssue]:
    """Find beams of which a part lies off the plate, over an opening, or on another plate."""
    chord = 1e-4 * region.size
    for number, beam in enumerate(beams):
        axis = beam.to_shapely(chord)
        areas = [area.buffer(max(region.near, 2 * chord * (beam.shape is not None)), join_style="mitre")
                 for area in region.areas]  # fmt: skip
        if any(area.covers(axis) for area in areas):
            continue
        place = ("beams", number, "points" if beam.points is not None else "shape")
        if region.plates and region.reach.covers(axis):
            hint = "two beams, one on either side of the joint, bend with their own plates"
            yield RelativeIssue(place, "a beam that goes from one plate to another", "a beam on one plate", hint)
            continue
        over = axis.length - max(area.intersection(axis).length for area in areas)
        found = f"{over:.3g} m of {axis.length:.3g} m that do not lie on the plate"
        yield RelativeIssue(place, found, "a beam that lies on the plate, clear of openings", "shorten or divide it")


def _check_joints(
    plates: tuple[AnyPlate, ...], joints: tuple[AnyJoint, ...], beams: tuple[Beam, ...]
) -> Iterator[RelativeIssue]:
    """Find beams along joints, of which nobody knows which plate they stiffen."""
    known = {plate.name: plate for plate in plates}
    for joint in joints:
        if not all(name in known for name in joint.between):
            continue
        line = shared_line(*(known[name] for name in joint.between))
        for number, beam in enumerate(beams):
            near = TOO_CLOSE * line.length
            if line.buffer(near).intersection(beam.to_shapely(near)).length > 4 * near:
                found = f"a beam along the joint {quote(joint.title)}"
                yield RelativeIssue(("beams", number), found, "a beam on one of the plates", "move it off the joint")


def _check_apart(beams: tuple[Beam, ...], near: float) -> Iterator[RelativeIssue]:
    """Find beams of which a part lies along another one."""
    axes = [beam.to_shapely(near) for beam in beams]
    for (one, a), (other, b) in itertools.combinations(enumerate(axes), 2):
        if a.distance(b) > near:
            continue
        shared = b.intersection(a.buffer(near, cap_style="flat")).length
        if shared > 4 * near and shared > near / math.sin(math.radians(5)):
            found = f"a beam along {shared:.3g} m of {quote(beams[one].name)}"
            hint = "one beam with a section that stands for both"
            yield RelativeIssue(("beams", other), found, "one beam at each place", hint)
