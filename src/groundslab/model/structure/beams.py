"""Beams and ribs cast with the plate: where they run, and their sections."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from groundslab.geometry.plan import Segment
from groundslab.model.axes.crossings import AtCrossings
from groundslab.model.ground import POISSON, POSITIVE
from groundslab.model.shapes import AnyShape
from groundslab.model.structure.lines import (
    LineBulges,
    LinePoints,
    LineShape,
    Path,
    check_line,
    check_line_length,
    flat_line,
    line_area,
    line_segments,
)
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table

if TYPE_CHECKING:
    from shapely import LineString, Polygon

#: Cracks make a member less stiff, which the plate's own law of cracking knows nothing of.
STIFFNESS = Number("", "share of the uncracked stiffness that counts, less where it cracks", Range(above=0, at_most=1))
#: Key of the torsion constant of a given section.
TORSION_CONSTANT = Quantity(
    "second moment of area", "J", "torsion constant; 0 resists no torsion", Range(at_least=0), example="0.003 m^4"
)
#: Diameter of bars of beams [m] where a case does not say.
LARGEST_BAR = 0.025
#: The shear area of a rectangle over its area (Timoshenko 1921; Cowper 1966 for nu = 0).
SHEAR_SHARE = 5 / 6


def torsion_constant(width: float, height: float) -> float:
    """Return J of a rectangle [m4], within 0.2 % (Young and Budynas, Roark's Formulas for Stress and Strain, 10.7)."""
    a, b = max(width, height), min(width, height)
    return a * b**3 * (1 / 3 - 0.21 * b / a * (1 - (b / a) ** 4 / 12))


class _Rectangle(Section):
    """What a rectangle has."""

    kind: str
    width: Annotated[float, Quantity("length", "b_w", "width", POSITIVE, example="0.3 m")]
    height: Annotated[
        float, Quantity("length", "h_w", "height, of a rib that beside the plate", POSITIVE, example="0.5 m")
    ]

    @property
    def second_moment(self) -> float:
        """Return I about its own axis [m4]."""
        return self.width * self.height**3 / 12

    @property
    def area(self) -> float:
        """Return A [m2]."""
        return self.width * self.height

    @property
    def torsion_constant(self) -> float:
        """Return J [m4]."""
        return torsion_constant(self.width, self.height)

    @property
    def shear_area(self) -> float:
        """Return the area that carries shear [m2]."""
        return SHEAR_SHARE * self.area


class RectangularSection(_Rectangle):
    """A rectangle about the plate's middle plane, in addition to the plate."""

    kind: Annotated[Literal["rectangle"], Table("a rectangle about the plate's middle plane, added to the plate")] = (
        "rectangle"
    )


def _check_flange(effective_width: float | None, eccentric: bool) -> Iterator[RelativeIssue]:
    if effective_width is None and not eccentric:
        hint = "or eccentric = true, which needs none"
        yield RelativeIssue(("effective_width",), "nothing", "the width of the rib's flange [m]", hint)


def _check_eccentricity(area: float | None, eccentricity: float | None) -> Iterator[RelativeIssue]:
    if (area is None) != (eccentricity is None):
        lacking, present = ("area", "an eccentricity") if area is None else ("eccentricity", "an area")
        yield RelativeIssue((lacking,), f"nothing, with {present}", "both or neither", "")


class RibSection(_Rectangle):
    """A rib below or above the plate, a strip of which is its flange."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_flange,)

    kind: Annotated[Literal["rib"], Table("a rib below or above the plate, a strip of which is its flange")] = "rib"
    effective_width: Annotated[
        float | None,
        Quantity(
            "length",
            "b_eff",
            "width of the plate that acts as the flange; of an eccentric rib for its bars alone, by default its own",
            POSITIVE,
            example="1.2 m",
        ),
    ] = None
    eccentric: Annotated[
        bool, Boolean("whether it stretches the plate in its plane, which replaces the effective width")
    ] = False
    side: Annotated[
        Literal["below", "above"],
        Choice(Literal["below", "above"], "side of the plate on which it lies", ""),
    ] = "below"

    @property
    def flange_width(self) -> float:
        """Return the width of the plate that acts as the flange [m]."""
        return self.width if self.effective_width is None else self.effective_width


class GivenSection(Section):
    """A section of which the properties are given, such as of steel."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_eccentricity,)

    kind: Annotated[Literal["properties"], Table("a section of which the properties are given, such as of steel")] = (
        "properties"
    )
    second_moment: Annotated[
        float,
        Quantity(
            "second moment of area",
            "I",
            "second moment of area about the plate's middle plane, of an eccentric one about its own axis",
            POSITIVE,
            example="0.003 m^4",
        ),
    ]
    torsion_constant: Annotated[float, TORSION_CONSTANT] = 0.0
    shear_area: Annotated[float, Quantity("area", "A_v", "area that carries shear", POSITIVE, example="0.15 m^2")]
    area: Annotated[
        float | None, Quantity("area", "A", "area, which an eccentric section needs", POSITIVE, example="0.15 m^2")
    ] = None
    eccentricity: Annotated[
        float | None,
        Quantity(
            "length",
            "e",
            "how far its centroid lies below the plate's middle plane, above it negative; with it, it stretches the "
            "plate in its plane",
            example="0.3 m",
        ),
    ] = None


End = Literal["fixed", "hinged"]
BeamSection = RectangularSection | RibSection | GivenSection


def _check_points_or_shape(
    points: tuple[tuple[float, float], ...] | None, bulges: tuple[float, ...], shape: AnyShape | None
) -> Iterator[RelativeIssue]:
    yield from check_line(points, shape, {"bulges": bulges or None}, "a closed curve has no ends", "the axis")


def _check_ends(
    points: tuple[tuple[float, float], ...] | None, shape: AnyShape | None, joined: tuple[str, str]
) -> Iterator[RelativeIssue]:
    closed = shape is not None or (points is not None and points[:1] == points[-1:])
    if closed and "hinged" in joined:
        yield RelativeIssue(("joined",), "hinged ends of a closed beam", "a beam that has ends", "divide it")


class Beam(Section):
    """A beam or rib that bends, shears and twists with the plate, and stretches it where it is eccentric.

    Else its axis is taken to lie in the plate's middle plane.
    """

    constraints: ClassVar[tuple[Check, ...]] = (_check_points_or_shape, check_line_length, _check_ends)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("points",)}

    name: Annotated[str, Text("name of the beam")]
    points: LinePoints = None
    at: AtCrossings = ()
    bulges: LineBulges = ()
    shape: LineShape = None
    section: Annotated[BeamSection, ByKind(), Table("the section")]
    E: Annotated[
        float | None,
        Quantity("pressure", "E", "Young's modulus, by default that of the plate", POSITIVE, example="30 GPa"),
    ] = None
    nu: Annotated[float | None, Number("nu", "Poisson's ratio, by default that of the plate", POISSON)] = None
    joined: Annotated[
        tuple[End, End],
        ListOf(
            Choice(End, ""),
            "",
            "how its start and its end are joined to the plate; hinged ones bend freely",
            2,
            members=("start", "end"),
        ),
    ] = ("fixed", "fixed")
    stiffness: Annotated[float, STIFFNESS] = 1.0
    torsion: Annotated[
        Literal["resisted", "released"],
        Choice(
            Literal["resisted", "released"],
            "whether it resists torsion and is designed for it; released where only compatibility would twist it",
            "",
        ),
    ] = "resisted"
    bar_axis: Annotated[
        float | None,
        Quantity(
            "length",
            "d_1",
            "distance of its bars' axes from its faces, by default the larger one of the plate's bars there",
            POSITIVE,
            example="60 mm",
        ),
    ] = None
    bar_diameter: Annotated[
        float,
        Quantity(
            "length",
            "phi",
            "diameter of its bars, by which least bars control cracks (EN 1992-1-1 7.3.3)",
            POSITIVE,
            example="20 mm",
        ),
    ] = LARGEST_BAR

    @property
    def edges(self) -> tuple[Segment, ...]:
        """Return the straight pieces and arcs of its axis, one after the other."""
        return line_segments(self.points, self.bulges, self.shape)

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
    def path(self) -> Path | None:
        """Return the places that its axis runs through, and the bulges between; None of a closed curve with arcs."""
        if self.points is not None:
            return self.points, self.bulges
        edges = self.edges
        return ((*(edge.start for edge in edges), edges[-1].end), ()) if all(edge.straight for edge in edges) else None

    @property
    def eccentric(self) -> bool:
        """Return whether it stretches the plate in its plane."""
        section = self.section
        return section.eccentric if isinstance(section, RibSection) else self._given_eccentricity is not None

    @property
    def _given_eccentricity(self) -> float | None:
        return self.section.eccentricity if isinstance(self.section, GivenSection) else None

    def eccentricity(self, thickness: float) -> float:
        """Return how far its centroid lies below the middle plane of a plate [m], 0 of one that does not stretch it."""
        if isinstance(self.section, RibSection) and self.section.eccentric:
            away = (thickness + self.section.height) / 2
            return away if self.section.side == "below" else -away
        return self._given_eccentricity or 0.0

    def rigidities(self, E: float, nu: float, thickness: float) -> tuple[float, float, float, float]:
        """Return E I, G J [N m2], G A_v and E A [N] on a plate with E [Pa], nu and a thickness [m].

        Those of a rib that is not eccentric are what it adds to the plate: E I is that of the T or L about its
        centroid, less that of the flange alone. E A counts of eccentric ones alone.
        """
        modulus, section = E if self.E is None else self.E, self.section
        G = modulus / (2 * (1 + (nu if self.nu is None else self.nu)))
        bending = modulus * section.second_moment if self.eccentric else self.added_bending(E, thickness)
        area = (section.area or 0.0) if self.eccentric else 0.0
        share = self.stiffness
        J = section.torsion_constant if self.torsion == "resisted" else 0.0
        return (
            share * bending,
            share * G * J,
            share * G * section.shear_area,
            share * modulus * area,
        )

    def added_bending(self, E: float, thickness: float) -> float:
        """Return E I [N m2] that it adds to a plate with E [Pa] and a thickness [m], a rib with its effective width."""
        modulus, section = E if self.E is None else self.E, self.section
        bending = modulus * section.second_moment
        if isinstance(section, RibSection):
            rib, flange = modulus * section.area, E * section.flange_width * thickness
            bending += rib * flange / (rib + flange) * ((thickness + section.height) / 2) ** 2
        return bending

    def beside_plate(self, thickness: float) -> float:
        """Return the area of concrete that a plate of a thickness [m] lacks [m2], 0 of a section by its properties."""
        section = self.section
        if isinstance(section, RibSection):
            return section.area
        if isinstance(section, RectangularSection):
            return section.width * max(section.height - thickness, 0.0)
        return 0.0

    def to_shapely(self, chord: float) -> LineString:
        """Return the axis, arcs as chords at most so far off [m]."""
        return flat_line(self.edges, chord)

    def area(self, chord: float) -> Polygon:
        """Return what the beam covers in plan, the thinnest strip where it has no width; arcs as for `to_shapely`."""
        return line_area(self.to_shapely(chord), max(self.width, 2 * chord), closed=self.closed)
