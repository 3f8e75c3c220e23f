"""Kinds of loads: pressures, point loads, self-weight, temperature, imposed settlements."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, TypeGuard

from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.plan import rectangle
from groundslab.model.axes.crossings import AtCrossing
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.acting import (
    AreaPressure,
    PlateAction,
    PointForce,
    Pressure,
    SupportSettlement,
    Surface,
    loaded_parts,
)
from groundslab.model.loads.base import Magnitude, Source, _Load
from groundslab.model.loads.core_loads import CoreLoad
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.shapes import AcrossX, AcrossY, AnyShape, Shape
from groundslab.model.structure.columns import TURN, Column, check_angle, check_footprint, footprint
from groundslab.schema.base import Check
from groundslab.schema.fields import Boolean, Choice, Number, Quantity, Text, list_quantities
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate, place_in_plan
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


STRAIN = Range(at_least=-0.01, at_most=0.01)

PlateKey = Annotated[str, Text("name of the plate on which it acts, if there are several; by default all of them")]


class _Pressure(_Load):
    """A pressure, constant or up to quadratic in x and y."""

    q: Annotated[float, Quantity("pressure", "q", "pressure, downwards positive", example="10 kN/m^2")]
    slope: Annotated[
        tuple[float, float],
        list_quantities(
            "pressure per length",
            "q_x, q_y",
            "growth of the pressure along x and along y",
            ("q_x", "q_y"),
            example="1 kPa/m",
        ),
    ] = (0.0, 0.0)
    bend: Annotated[
        tuple[float, float, float],
        list_quantities(
            "pressure per area",
            "q_xx, q_xy, q_yy",
            "second derivatives of the pressure",
            ("q_xx", "q_xy", "q_yy"),
            example="2 kPa/m^2",
        ),
    ] = (0.0, 0.0, 0.0)
    about: Annotated[
        tuple[float, float],
        place_in_plan("place where the pressure is q; matters if it varies", "x_0, y_0"),
    ] = (0.0, 0.0)

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is."""
        return (("q", self.q, "pressure"),)

    @property
    def pressure(self) -> Pressure:
        """The pressure, a function of places."""
        return Pressure(self.q, self.slope, self.bend, self.about)


class UniformLoad(_Pressure):
    """A pressure on the whole plate."""

    kind: Annotated[Literal["uniform"], Table("pressure on the whole plate")] = "uniform"
    plate: PlateKey = ""

    @property
    def acts(self) -> tuple[PlateAction]:
        """The pressure all over the plate."""
        return (PlateAction(self.plate, pressure=self.pressure),)


class _PressureOnPart(_Pressure):
    """A pressure on a part of the plan: on the plate, or on the ground beside it."""

    on: Annotated[
        Surface,
        Choice(Surface, "what it acts on: the plate, or the ground's surface around the plate and in its openings"),
    ] = "plate"


class PatchLoad(_PressureOnPart):
    """A pressure on a rectangle."""

    kind: Annotated[Literal["patch"], Table("pressure on a rectangle")] = "patch"
    x: AcrossX
    y: AcrossY

    @property
    def acts(self) -> tuple[AreaPressure]:
        """The pressure on the rectangle."""
        return (AreaPressure((rectangle(*self.x, *self.y),), self.pressure, self.on),)


def _check_holes(shape: AnyShape, holes: tuple[AnyShape, ...]) -> Iterator[RelativeIssue]:
    if not holes:
        return
    around = equal_area_polygon(shape.ring())
    for position, hole in enumerate(holes):
        if not around.intersects(equal_area_polygon(hole.ring())):
            yield RelativeIssue(("holes", position), "a hole outside the shape", "a part of the shape", "leave it out")
    if not loaded_parts(shape.ring(), *(hole.ring() for hole in holes)):
        yield RelativeIssue(("holes",), "holes that leave nothing of the shape", "a part of the shape that is loaded")


class AreaLoad(_PressureOnPart):
    """A pressure on a part of any shape."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_holes,)

    kind: Annotated[Literal["area"], Table("pressure on a part of any shape")] = "area"
    shape: Annotated[Shape, Table("where; what lies off the surface that it presses on does not act, and is reported")]
    holes: Annotated[tuple[Shape, ...], Table("parts of the shape that are not loaded, as in a ring")] = ()

    @property
    def acts(self) -> tuple[AreaPressure]:
        """The pressure on the area."""
        rings = (self.shape.ring(), *(hole.ring() for hole in self.holes))
        return (AreaPressure(rings, self.pressure, self.on),)


class SelfWeight(_Load):
    """The self-weight of the plate, of the walls of its pits, and of beams cast with it."""

    kind: Annotated[
        Literal["self weight"], Table("self-weight of the plate, by its thickness in each zone, and of walls of pits")
    ] = "self weight"
    unit_weight: Annotated[
        float, Quantity("weight per volume", "gamma_c", "weight of the material", POSITIVE, example="25 kN/m^3")
    ]
    beams: Annotated[bool, Boolean("whether ribs weigh, too, and of rectangles what is higher than the plate")] = False
    plate: PlateKey = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is."""
        return (("gamma_c", self.unit_weight, "weight per volume"),)

    @property
    def acts(self) -> tuple[PlateAction]:
        """The weight of the plate."""
        return (PlateAction(self.plate, unit_weight=self.unit_weight),)


def _check_position(
    x: float | None,
    y: float | None,
    width_x: float | None,
    width_y: float | None,
    diameter: float | None,
    angle: float,
    column: str,
) -> Iterator[RelativeIssue]:
    size = {"width_x": width_x, "width_y": width_y, "diameter": diameter, "angle": angle or None}
    keys = {"x": x, "y": y, **size}
    if column:
        for name in (name for name, value in keys.items() if value is not None):
            hint = "the column says where its load acts"
            yield RelativeIssue((name,), f"{name} together with a column", "one of them", hint)
    else:
        for name in (name for name in ("x", "y") if keys[name] is None):
            yield RelativeIssue((name,), "nothing", 'a position such as "1.5 m", or the name of a column')


def _check_angle(width_x: float | None, diameter: float | None, angle: float, column: str) -> Iterator[RelativeIssue]:
    if not column:
        yield from check_angle(width_x, diameter, angle)


class PointLoad(_Load):
    """A force and moments at a point, on a footprint or on a column."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_position, check_footprint, _check_angle)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("x", "y")}

    kind: Annotated[Literal["point"], Table("force and moments at a point, on a footprint or on a column")] = "point"
    P: Annotated[float, Quantity("force", "P", "force, downwards positive; 0 for moments alone", example="500 kN")]
    M_x: Annotated[
        float,
        Quantity(
            "moment",
            "M_x",
            "moment about the y axis, positive if it presses the side of larger x down: the sum of F (x - x_P) of "
            "downward forces F; other programs call it M_y, some with the other sign",
            example="80 kNm",
        ),
    ] = 0.0
    M_y: Annotated[
        float,
        Quantity(
            "moment",
            "M_y",
            "moment about the x axis, positive if it presses the side of larger y down: the sum of F (y - y_P) of "
            "downward forces F; other programs call it M_x, some with the other sign",
            example="80 kNm",
        ),
    ] = 0.0
    x: Annotated[float | None, coordinate(0, "position")] = None
    y: Annotated[float | None, coordinate(1, "position")] = None
    width_x: Annotated[
        float | None,
        Quantity(
            "length",
            "c_x",
            "width along x of the area over which it is spread; a point by default",
            POSITIVE,
            example="0.4 m",
        ),
    ] = None
    width_y: Annotated[
        float | None,
        Quantity(
            "length",
            "c_y",
            "width along y of the area over which it is spread; a point by default",
            POSITIVE,
            example="0.4 m",
        ),
    ] = None
    diameter: Annotated[
        float | None,
        Quantity(
            "length",
            "d",
            "diameter of the area over which it is spread, instead of both widths",
            POSITIVE,
            example="0.4 m",
        ),
    ] = None
    angle: Annotated[float, Number("alpha", "angle of its widths from x and y in degrees, counterclockwise", TURN)] = (
        0.0
    )
    column: Annotated[str, Text("column on which it acts and over which it is spread, one of [[columns]]")] = ""
    at: AtCrossing = ""
    source: Source = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large its force and its moments are."""
        return (("P", self.P, "force"), ("M_x", self.M_x, "moment"), ("M_y", self.M_y, "moment"))

    @property
    def acts(self) -> tuple[PointForce]:
        """The force with its couples."""
        assert self.x is not None
        assert self.y is not None
        ring = footprint((self.x, self.y), (self.width_x, self.width_y), self.diameter, self.angle)
        return (PointForce((self.x, self.y), self.P, (self.M_x, self.M_y), ring),)

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the footprint, or the point; arcs as chords at most so far off [m]."""
        return self.acts[0].to_shapely(chord)

    def on(self, columns: tuple[Column, ...]) -> PointLoad:
        """Return the load with place and footprint of its column, itself if it stands on none."""
        if not self.column:
            return self
        column = next(column for column in columns if column.name == self.column)
        place = {name: getattr(column, name) for name in ("x", "y", "width_x", "width_y", "diameter", "angle")}
        # nothing is checked again: a column's place and widths are valid for a load, too
        return self.model_copy(update={"column": "", **place})


class TemperatureLoad(_Load):
    """A difference of temperature between the faces of the plate."""

    kind: Annotated[Literal["temperature"], Table("difference of temperature over the thickness")] = "temperature"
    difference: Annotated[
        float,
        Quantity("temperature difference", "dT", "bottom less top: positive if the bottom is warmer", example="15 K"),
    ]
    plate: PlateKey = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is."""
        return (("dT", self.difference, "temperature difference"),)

    @property
    def acts(self) -> tuple[PlateAction]:
        """The difference of temperature all over the plate."""
        return (PlateAction(self.plate, temperature=self.difference),)


class ShrinkageLoad(_Load):
    """Shrinkage that differs between the faces of the plate; of a uniform one friction makes tension, no bending."""

    kind: Annotated[Literal["shrinkage"], Table("shrinkage that differs over the thickness")] = "shrinkage"
    top: Annotated[float, Number("eps_top", "strain by which the top face shortens, such as 5e-4", STRAIN)]
    bottom: Annotated[float, Number("eps_bottom", "strain by which the bottom face shortens", STRAIN)] = 0.0
    plate: PlateKey = ""

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is at both faces."""
        return (("eps_top", self.top, "strain"), ("eps_bottom", self.bottom, "strain"))

    @property
    def acts(self) -> tuple[PlateAction]:
        """The difference of shrinkage all over the plate."""
        return (PlateAction(self.plate, shrinkage=self.top - self.bottom),)


class SettlementLoad(_Load):
    """A settlement that is forced on a support."""

    kind: Annotated[Literal["settlement"], Table("settlement forced on a support")] = "settlement"
    support: Annotated[str, Text("name of the support, one of [[supports]]")]
    w: Annotated[float, Quantity("length", "w_s", "its settlement, downwards positive", example="20 mm")]

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large it is."""
        return (("w_s", self.w, "length"),)

    @property
    def acts(self) -> tuple[SupportSettlement]:
        """The settlement of the support."""
        return (SupportSettlement(self.support, self.w),)


AnyLoad = (
    UniformLoad
    | PatchLoad
    | AreaLoad
    | LineLoad
    | LineMoment
    | PointLoad
    | SelfWeight
    | TemperatureLoad
    | ShrinkageLoad
    | SettlementLoad
    | CoreLoad
)
#: Loads of a size given by area or length, which may reach over the plate's edge, where they are cut off; others with a
#: place must lie on the plate.
Spread = PatchLoad | AreaLoad | LineLoad | LineMoment
#: Loads that may press on the ground beside the plate.
OnGround = PatchLoad | AreaLoad
Load = Annotated[AnyLoad, ByKind()]


def is_zero(load: AnyLoad) -> bool:
    """Return whether nothing of a load acts anywhere."""
    varies = isinstance(load, _Pressure) and not load.pressure.constant
    return not varies and not any(value for _, value, _ in load.magnitudes)


def presses_ground(load: AnyLoad) -> TypeGuard[OnGround]:
    """Return whether a load presses on the ground beside the plate, not on the plate."""
    return isinstance(load, OnGround) and load.on == "ground"
