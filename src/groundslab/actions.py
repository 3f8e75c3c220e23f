"""What acts on the plate as the input file says it: loads, and voids under it; and whether it lies on the plate."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Discriminator, Tag

from groundslab.findings import Finding
from groundslab.keys import Quantity, Several, Text
from groundslab.outline import CHORD, AcrossX, AcrossY, Place, Shape
from groundslab.schema import Check, Part, Table, kind_of
from groundslab.slab import Plate
from groundslab.soil import POSITIVE

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

ON_PLATE = 1e-9  # tolerance of positions on the plate, relative to its longer side

LoadName = Annotated[str, Text("name of the load, for people")]


def _box(x: tuple[float, float], y: tuple[float, float]) -> BaseGeometry:
    from shapely import box

    return box(x[0], y[0], x[1], y[1])


class UniformLoad(Part):
    """A pressure on the whole plate."""

    kind: Annotated[Literal["uniform"], Table("pressure on the whole plate")] = "uniform"
    name: LoadName = ""
    q: Annotated[float, Quantity("pressure", "q", "pressure, downwards positive")]


class PatchLoad(Part):
    """A pressure on a rectangle."""

    kind: Annotated[Literal["patch"], Table("pressure on a rectangle")] = "patch"
    name: LoadName = ""
    q: Annotated[float, Quantity("pressure", "q", "pressure, downwards positive")]
    x: AcrossX
    y: AcrossY

    def drawn(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the rectangle."""
        return _box(self.x, self.y)


class AreaLoad(Part):
    """A pressure on a part of the plate of any shape."""

    kind: Annotated[Literal["area"], Table("pressure on a part of any shape")] = "area"
    name: LoadName = ""
    q: Annotated[float, Quantity("pressure", "q", "pressure, downwards positive")]
    shape: Annotated[Shape, Table("where; what reaches over the plate's edge is an error")]

    def drawn(self, chord: float) -> BaseGeometry:
        """Return the area, arcs as chords at most so far off [m]."""
        return self.shape.ring().polygon(chord)


def _no_standstill(points: tuple[tuple[float, float], ...]) -> Iterator[Finding]:
    if len(points) < 2:
        yield Finding(("points",), f"{len(points)} point", "at least two")
    for position, (a, b) in enumerate(itertools.pairwise(points), start=1):
        if a == b:
            yield Finding(("points", position), f"({b[0]!r}, {b[1]!r}) m twice", "another place than the one before")


class LineLoad(Part):
    """A force per length along straight lines."""

    checks: ClassVar[tuple[Check, ...]] = (_no_standstill,)

    kind: Annotated[Literal["line"], Table("force per length along straight lines")] = "line"
    name: LoadName = ""
    q: Annotated[float, Quantity("force per length", "q", "force per length, downwards positive")]
    points: Annotated[
        tuple[tuple[float, float], ...], Several(Place, "x, y", "the line's points, joined one after the other")
    ]

    def drawn(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the line."""
        from shapely import LineString

        return LineString(self.points)


class SelfWeight(Part):
    """The plate's own weight."""

    kind: Annotated[Literal["self weight"], Table("the plate's own weight, by its thickness in each zone")] = (
        "self weight"
    )
    name: LoadName = ""
    unit_weight: Annotated[float, Quantity("weight per volume", "gamma_c", "weight of the material", POSITIVE)]


class PointLoad(Part):
    """A force at a point."""

    kind: Annotated[Literal["point"], Table("force at a point")] = "point"
    name: LoadName = ""
    P: Annotated[float, Quantity("force", "P", "force, downwards positive")]
    x: Annotated[float, Quantity("length", "x", "position")]
    y: Annotated[float, Quantity("length", "y", "position")]

    def drawn(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the point."""
        from shapely import Point

        return Point(self.x, self.y)


AnyLoad = UniformLoad | PatchLoad | AreaLoad | LineLoad | PointLoad | SelfWeight
Load = Annotated[
    Annotated[UniformLoad, Tag("uniform")]
    | Annotated[PatchLoad, Tag("patch")]
    | Annotated[AreaLoad, Tag("area")]
    | Annotated[LineLoad, Tag("line")]
    | Annotated[PointLoad, Tag("point")]
    | Annotated[SelfWeight, Tag("self weight")],
    Discriminator(kind_of),
]


class Void(Part):
    """A rectangle under the plate where the ground lies deeper."""

    depth: Annotated[float, Quantity("length", "d", "initial gap inside the rectangle", POSITIVE)]
    x: AcrossX
    y: AcrossY

    def drawn(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the rectangle."""
        return _box(self.x, self.y)


Placed = PatchLoad | AreaLoad | LineLoad | PointLoad | Void


def _on_plate(plate: Plate, part: Placed, place: tuple[str | int, ...]) -> Iterator[Finding]:
    x0, x1, y0, y1 = plate.bounds
    near = ON_PLATE * max(plate.sides)
    mend = "the centre of the plate is the origin" if plate.outline is None else "places are those of the outline"
    outside = False
    for axis, low, high in (("x", x0, x1), ("y", y0, y1)):
        value = getattr(part, axis, ())
        values = value if isinstance(value, tuple) else (value,)
        if any(not low - near <= value <= high + near for value in values):
            got = f"{values[0]!r} m" if len(values) == 1 else f"[{', '.join(f'{value!r} m' for value in values)}]"
            yield Finding((*place, axis), got, f"a position on the plate, from {low!r} m to {high!r} m", mend)
            outside = True
    # for what runs along the sides of a rectangle that is all
    if not outside and not (plate.outline is None and not plate.openings and hasattr(part, "x")):
        yield from _on_shape(plate, part, place, near)


def _on_shape(plate: Plate, part: Placed, place: tuple[str | int, ...], near: float) -> Iterator[Finding]:
    """Find a part that does not lie on the plate, be it within the rectangle around it."""
    chord = CHORD * max(plate.sides)
    outline, openings, loaded = plate.ring(), [opening.ring() for opening in plate.openings], part.drawn(chord)
    on_plate = outline.polygon(chord)
    for opening in openings:
        on_plate = on_plate.difference(opening.polygon(chord))
    curved = not all(ring.straight for ring in (outline, *openings))
    if not on_plate.buffer(2 * chord if curved else near).covers(loaded):
        off = loaded.difference(on_plate).representative_point()
        expected = "a place on the plate, not in an opening nor beside the outline"
        yield Finding(place, f"a part off the plate, at ({off.x:.6g}, {off.y:.6g}) m", expected)


def loads_on_plate(plate: Plate, loads: tuple[AnyLoad, ...]) -> Iterator[Finding]:
    """Find loads that do not lie on the plate."""
    for position, load in enumerate(loads):
        if not isinstance(load, UniformLoad | SelfWeight):
            yield from _on_plate(plate, load, ("loads", position))


def voids_on_plate(plate: Plate, voids: tuple[Void, ...]) -> Iterator[Finding]:
    """Find voids that do not lie under the plate."""
    for position, void in enumerate(voids):
        yield from _on_plate(plate, void, ("contact", "voids", position))
