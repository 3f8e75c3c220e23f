"""Further plates beside the first one, on the same ground."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate, combinations
from typing import TYPE_CHECKING, Annotated, ClassVar, Protocol

from groundslab.geometry.places import same_place
from groundslab.geometry.plan import Ring, format_place, get_bounds
from groundslab.geometry.validity import TOO_CLOSE
from groundslab.model.ground import POISSON, POSITIVE
from groundslab.model.plate import SHEAR_FACTOR, THERMAL_EXPANSION, Plate, Zone, check_geometry
from groundslab.model.shapes import CHORD, AnyShape, Shape
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.repairs import use_free_name
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


def _check_geometry(
    outline: AnyShape, openings: tuple[AnyShape, ...], zones: tuple[Zone, ...]
) -> Iterator[RelativeIssue]:
    return check_geometry(outline, openings, zones)


class _Joined(Protocol):
    """A joint, by the names of its plates."""

    @property
    def between(self) -> tuple[str, str]:
        """The names."""
        ...


class FurtherPlate(Section):
    """A further plate on the same ground, apart from the first one: its elements are of the same type."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_geometry,)

    name: Annotated[str, Text("name of the plate, used by loads")]
    outline: Annotated[Shape, Table("its outline, of any shape")]
    openings: Annotated[tuple[Shape, ...], Table("what is cut out of it")] = ()
    zones: Annotated[tuple[Zone, ...], Table("parts with another thickness, material or level")] = ()
    thickness: Annotated[float, Quantity("length", "t", "thickness", POSITIVE, example="0.4 m")]
    E: Annotated[float, Quantity("pressure", "E", "Young's modulus", POSITIVE, example="30 GPa")]
    nu: Annotated[float, Number("nu", "Poisson's ratio", POISSON)]
    shear_factor: Annotated[float, SHEAR_FACTOR] = 5 / 6
    thermal_expansion: Annotated[float, THERMAL_EXPANSION] = 1e-5

    def ring(self) -> Ring:
        """Return the outline as a curve."""
        return self.outline.ring()

    def rings(self) -> tuple[Ring, ...]:
        """Return the outline and the openings as curves."""
        return self.ring(), *(opening.ring() for opening in self.openings)

    @property
    def sides(self) -> tuple[float, float]:
        """Return the sides of the rectangle around the plate [m]."""
        x0, x1, y0, y1 = self.ring().bounds
        return x1 - x0, y1 - y0


AnyPlate = Plate | FurtherPlate


def list_plates(plate: AnyPlate, plates: Sequence[FurtherPlate]) -> tuple[AnyPlate, ...]:
    """Return the first plate and the further ones."""
    return plate, *plates


def bounds_of(plate: AnyPlate, plates: Sequence[FurtherPlate]) -> tuple[float, float, float, float]:
    """Return the rectangle x0, x1, y0, y1 around plates [m]."""
    return (
        plate.bounds
        if isinstance(plate, Plate) and not plates
        else get_bounds(edge for slab in list_plates(plate, plates) for edge in slab.ring().segments())
    )


def first_sections(plates: Sequence[AnyPlate]) -> list[int]:
    """Return the number of each plate's own section, 0 of the first; those of its zones follow."""
    return list(accumulate((1 + len(plate.zones) for plate in plates[:-1]), initial=0))


def shared_line(plate: AnyPlate, other: AnyPlate) -> BaseGeometry:
    """Return the line that the outlines of two plates share, arcs as chords; points where they only touch."""
    x0, x1, y0, y1 = get_bounds(edge for slab in (plate, other) for edge in slab.ring().segments())
    chord = CHORD * max(x1 - x0, y1 - y0)
    edge, beside = (slab.ring().polygon(chord).exterior for slab in (plate, other))
    return edge.intersection(beside.buffer(same_place(x0, x1, y0, y1)))


def check_plates(plate: Plate, plates: tuple[FurtherPlate, ...], joints: Sequence[_Joined]) -> Iterator[RelativeIssue]:
    """Find plates without a name of their own, and plates that overlap, leave too narrow a strip, or touch unjoined."""
    seen = {plate.name} - {""}
    for position, further in enumerate(plates):
        if not further.name or further.name in seen:
            bad_name = f"{describe(further.name)} again" if further.name else "no name"
            place = ("plates", position, "name")
            taken = [plate.name, *(other.name for other in plates)]
            repairs = use_free_name(place, further.name or "plate", taken)
            yield RelativeIssue(place, bad_name, "a unique name", repairs=repairs)
        seen.add(further.name)
    if not plates:
        return
    x0, x1, y0, y1 = bounds_of(plate, plates)
    size = max(x1 - x0, y1 - y0)
    joined = {frozenset(joint.between) for joint in joints}
    for first, second in combinations(range(1 + len(plates)), 2):
        one_plate, other = list_plates(plate, plates)[first], plates[second - 1]
        meeting = _find_meeting(one_plate, other, size, frozenset((one_plate.name, other.name)) in joined)
        if meeting is not None:
            name = "the first plate" if first == 0 else f"plates[{first}]"
            expected = f"plates next to each other, at least {TOO_CLOSE * size:.3g} m apart or joined"
            hint = "[[joints]] joins plates that share a line; a part on top of a plate is a zone of greater thickness"
            yield RelativeIssue(("plates", second - 1, "outline"), meeting.format(name), expected, hint)


def _find_meeting(plate: AnyPlate, other: FurtherPlate, size: float, joined: bool) -> str | None:
    """Return how a plate meets another one, whose name is {}, though it may not; size is that of all plates [m].

    At a single point they may touch without a joint.
    """
    from shapely import union_all

    outline, beside = (slab.ring().polygon(CHORD * size) for slab in (plate, other))
    openings = union_all([opening.ring().polygon(CHORD * size) for opening in plate.openings])
    shared = outline.intersection(beside)
    if shared.area > (CHORD * size) ** 2:
        if openings.contains(beside):
            return "a plate in an opening of {}"
        at = shared.representative_point()
        return f"a plate that overlaps {{}} at {format_place((at.x, at.y))} m"
    if outline.distance(beside) > same_place(*get_bounds((*plate.ring().segments(), *other.ring().segments()))):
        return "a strip too narrow to mesh next to {}" if outline.distance(beside) < TOO_CLOSE * size else None
    touches = shared_line(plate, other).length > TOO_CLOSE * size
    return "a plate that touches {} without a joint" if touches and not joined else None
