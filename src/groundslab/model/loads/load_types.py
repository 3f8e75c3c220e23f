"""Types of loads: pressures, line and point loads, self-weight, temperature, imposed settlements."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, TypeGuard

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Segment, equal_area_polygon, make_segments
from groundslab.model.columns import Column, check_footprint, footprint
from groundslab.model.ground import POSITIVE
from groundslab.model.shapes import BULGE, AcrossX, AcrossY, AnyShape, Place, Shape
from groundslab.schema.base import ByKind, Check, Section, Table
from groundslab.schema.fields import Choice, ListOf, Number, Quantity, Text, list_quantities
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate, place_in_plan
from groundslab.schema.ranges import Range

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


NO_LENGTH = 1e-9  # m: lines shorter than this go nowhere

STRAIN = Range(at_least=-0.01, at_most=0.01)

Surface = Literal["plate", "ground"]
PlateKey = Annotated[str, Text("the one of several plates that it acts on, by its name; by default on all of them")]

NO_SLOPE, NO_BEND, ORIGIN = (0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0)


class _Load(Section):
    """What all loads have."""

    kind: str
    name: Annotated[str, Text("name of the load, for people")] = ""
    case: Annotated[str, Text("load case that it belongs to, one of [[cases]]; none where there are no cases")] = ""


class _Pressure(_Load):
    """A pressure, constant or up to quadratic in x and y."""

    q: Annotated[float, Quantity("pressure", "q", "pressure, downwards positive")]
    slope: Annotated[
        tuple[float, float],
        list_quantities("pressure per length", "q_x, q_y", "growth of the pressure along x and along y", 2),
    ] = NO_SLOPE
    bend: Annotated[
        tuple[float, float, float],
        list_quantities("pressure per area", "q_xx, q_xy, q_yy", "second derivatives of the pressure", 3),
    ] = NO_BEND
    about: Annotated[
        tuple[float, float],
        place_in_plan("place where the pressure is q; matters if it varies", "x_0, y_0"),
    ] = ORIGIN


class UniformLoad(_Pressure):
    """A pressure on the whole plate."""

    kind: Annotated[Literal["uniform"], Table("pressure on the whole plate")] = "uniform"
    plate: PlateKey = ""


class _PressureOnPart(_Pressure):
    """A pressure on a part of the plan: on the plate, or on the ground beside it."""

    on: Annotated[
        Surface,
        Choice(Surface, "what it presses on: the plate, or the ground's surface beside the plate and in its openings"),
    ] = "plate"


class PatchLoad(_PressureOnPart):
    """A pressure on a rectangle."""

    kind: Annotated[Literal["patch"], Table("pressure on a rectangle")] = "patch"
    x: AcrossX
    y: AcrossY

    def to_shapely(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the rectangle."""
        from shapely import box

        return box(self.x[0], self.y[0], self.x[1], self.y[1])


def _check_holes(shape: AnyShape, holes: tuple[AnyShape, ...]) -> Iterator[RelativeIssue]:
    if not holes:
        return
    around = equal_area_polygon(shape.ring())
    for position, hole in enumerate(holes):
        if not around.intersects(equal_area_polygon(hole.ring())):
            yield RelativeIssue(("holes", position), "a hole beside the shape", "a part of the shape", "leave it out")
    if not _loaded_parts(shape, holes):
        yield RelativeIssue(("holes",), "holes that leave nothing of the shape", "a part of the shape that is loaded")


def _loaded_parts(shape: AnyShape, holes: tuple[AnyShape, ...]) -> list[BaseGeometry]:
    """Return the polygons of a shape without its holes."""
    from shapely import get_parts, union_all

    cut = union_all([equal_area_polygon(hole.ring()) for hole in holes])
    left = equal_area_polygon(shape.ring()).difference(cut)
    return [part for part in get_parts(left) if part.geom_type == "Polygon" and part.area > 0]


class AreaLoad(_PressureOnPart):
    """A pressure on a part of any shape."""

    checks: ClassVar[tuple[Check, ...]] = (_check_holes,)

    kind: Annotated[Literal["area"], Table("pressure on a part of any shape")] = "area"
    shape: Annotated[Shape, Table("where; what lies off the surface that it presses on does not act, and is reported")]
    holes: Annotated[tuple[Shape, ...], Table("parts of the shape that are not loaded, as in a ring")] = ()

    def to_shapely(self, chord: float) -> BaseGeometry:  # noqa: ARG002
        """Return the loaded area, its arcs as chords that enclose the same area."""
        from shapely import union_all

        return union_all(_loaded_parts(self.shape, self.holes))


def _check_points_or_shape(
    points: tuple[tuple[float, float], ...] | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    q_end: float | None,
) -> Iterator[RelativeIssue]:
    if points is None and shape is None:
        yield RelativeIssue(("points",), "nothing", "the line's points, or a shape whose edge is loaded")
    if shape is None:
        return
    for name, given in (("points", points), ("bulges", bulges or None), ("q_end", q_end)):
        if given is not None:
            yield RelativeIssue(
                (name,), f"{name} beside a shape", "one of them", "all of a shape's edge bears the same q"
            )


def _check_line_length(
    points: tuple[tuple[float, float], ...] | None, bulges: tuple[float, ...]
) -> Iterator[RelativeIssue]:
    if points is None:
        return
    if len(points) < 2:
        yield RelativeIssue(("points",), f"{len(points)} point", "at least two")
    elif len(bulges) >= len(points):
        expected = f"at most {len(points) - 1}, one for each of the line's pieces"
        yield RelativeIssue(("bulges",), f"{len(bulges)} bulges", expected)
    for position, (a, b) in enumerate(itertools.pairwise(points), start=1):
        if math.dist(a, b) < NO_LENGTH:
            found = f"({b[0]!r}, {b[1]!r}) m twice"
            yield RelativeIssue(("points", position), found, "another place than the one before")


class LineLoad(_Load):
    """A force per length along a line of straight pieces and arcs, or along the edge of a shape."""

    checks: ClassVar[tuple[Check, ...]] = (_check_points_or_shape, _check_line_length)

    kind: Annotated[Literal["line"], Table("force per length along a line of straight pieces and arcs")] = "line"
    q: Annotated[float, Quantity("force per length", "q", "force per length, downwards positive")]
    q_end: Annotated[
        float | None, Quantity("force per length", "q_e", "at the end, linear from q at the start; q by default")
    ] = None
    points: Annotated[
        tuple[tuple[float, float], ...] | None,
        ListOf(Place, "x, y", "the line's points, joined one after the other"),
    ] = None
    bulges: Annotated[
        tuple[float, ...],
        ListOf(
            BULGE,
            "b",
            "for the piece after each point, tan of a quarter of its arc's angle, positive if it runs "
            "counter-clockwise; 0 for a straight piece",
            least=0,
        ),
    ] = ()
    shape: Annotated[Shape | None, Table("closed curve that the load stands on, such as a circle; not with points")] = (
        None
    )

    def segments(self) -> tuple[Segment, ...]:
        """Return the straight pieces and arcs that the load stands on, one after the other."""
        if self.shape is not None:
            return self.shape.ring().segments()
        assert self.points is not None
        return make_segments(self.points, self.bulges)

    @property
    def straight(self) -> bool:
        """Return whether no piece is an arc."""
        return all(edge.straight for edge in self.segments())

    def flat(self, chord: float) -> Array:
        """Return places (p, 2) along the line from its start to its end, arcs as chords at most so far off [m]."""
        edges = self.segments()
        parts = [edge.at(np.arange(n) / n) for edge in edges for n in (edge.chords(chord),)]
        return np.concatenate([*parts, [edges[-1].end]])

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the line, arcs as chords at most so far off [m]."""
        from shapely import LineString

        return LineString(self.flat(chord))


class SelfWeight(_Load):
    """The self-weight of the plate."""

    kind: Annotated[Literal["self weight"], Table("self-weight of the plate, by its thickness in each zone")] = (
        "self weight"
    )
    unit_weight: Annotated[float, Quantity("weight per volume", "gamma_c", "weight of the material", POSITIVE)]
    plate: PlateKey = ""


def _check_position(
    x: float | None,
    y: float | None,
    width_x: float | None,
    width_y: float | None,
    diameter: float | None,
    column: str,
) -> Iterator[RelativeIssue]:
    own = {"x": x, "y": y, "width_x": width_x, "width_y": width_y, "diameter": diameter}
    if column:
        for name in (name for name, value in own.items() if value is not None):
            hint = "the column says where its load acts"
            yield RelativeIssue((name,), f"{name} beside a column", "one of them", hint)
    else:
        for name in (name for name in ("x", "y") if own[name] is None):
            yield RelativeIssue((name,), "nothing", 'a position such as "1.5 m", or the name of a column')


class PointLoad(_Load):
    """A force and moments at a point, on a footprint or on a column."""

    checks: ClassVar[tuple[Check, ...]] = (_check_position, check_footprint)

    kind: Annotated[Literal["point"], Table("force and moments at a point, on a footprint or on a column")] = "point"
    P: Annotated[float, Quantity("force", "P", "force, downwards positive; 0 for moments alone")]
    M_x: Annotated[
        float,
        Quantity(
            "moment",
            "M_x",
            "moment about the y axis, positive if it presses the side of larger x down: the sum of F (x - x_P) of "
            "downward forces F; other programs call it M_y, some with the other sign",
        ),
    ] = 0.0
    M_y: Annotated[
        float,
        Quantity(
            "moment",
            "M_y",
            "moment about the x axis, positive if it presses the side of larger y down: the sum of F (y - y_P) of "
            "downward forces F; other programs call it M_x, some with the other sign",
        ),
    ] = 0.0
    x: Annotated[float | None, coordinate(0, "position")] = None
    y: Annotated[float | None, coordinate(1, "position")] = None
    width_x: Annotated[
        float | None, Quantity("length", "c_x", "width along x of what it is spread over; a point by default", POSITIVE)
    ] = None
    width_y: Annotated[
        float | None, Quantity("length", "c_y", "width along y of what it is spread over; a point by default", POSITIVE)
    ] = None
    diameter: Annotated[
        float | None, Quantity("length", "d", "diameter of what it is spread over, instead of both widths", POSITIVE)
    ] = None
    column: Annotated[str, Text("column that it acts on and is spread over, one of [[columns]]")] = ""

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the footprint, or the point; arcs as chords at most so far off [m]."""
        from shapely import Point

        assert self.x is not None
        assert self.y is not None
        ring = footprint(self.x, self.y, self.width_x, self.width_y, self.diameter)
        return Point(self.x, self.y) if ring is None else ring.polygon(chord)

    def on(self, columns: tuple[Column, ...]) -> PointLoad:
        """Return the load with place and footprint of its column, itself if it stands on none."""
        if not self.column:
            return self
        own = next(each for each in columns if each.name == self.column)
        place = {name: getattr(own, name) for name in ("x", "y", "width_x", "width_y", "diameter")}
        # nothing is checked again: a column's place and widths are valid for a load, too
        return self.model_copy(update={"column": "", **place})


class TemperatureLoad(_Load):
    """A difference of temperature between the faces of the plate."""

    kind: Annotated[Literal["temperature"], Table("difference of temperature over the thickness")] = "temperature"
    difference: Annotated[
        float, Quantity("temperature difference", "dT", "bottom less top: positive if the bottom is warmer")
    ]
    plate: PlateKey = ""


class ShrinkageLoad(_Load):
    """Shrinkage that differs between the faces of the plate; of a uniform one friction makes tension, no bending."""

    kind: Annotated[Literal["shrinkage"], Table("shrinkage that differs over the thickness")] = "shrinkage"
    top: Annotated[float, Number("eps_top", "strain by which the top face shortens, such as 5e-4", STRAIN)]
    bottom: Annotated[float, Number("eps_bottom", "strain by which the bottom face shortens", STRAIN)] = 0.0
    plate: PlateKey = ""


class SettlementLoad(_Load):
    """A settlement that is forced on a support."""

    kind: Annotated[Literal["settlement"], Table("settlement forced on a support")] = "settlement"
    support: Annotated[str, Text("name of the support, one of [[supports]]")]
    w: Annotated[float, Quantity("length", "w_s", "its settlement, downwards positive")]


def pressure_function(load: UniformLoad | PatchLoad | AreaLoad) -> Callable[[Array], Array]:
    """Return the pressure [Pa] of a load as a function of places (..., 2) [m]."""
    if load.slope == NO_SLOPE and load.bend == NO_BEND:
        return lambda places: np.full(places.shape[:-1], load.q)
    slope, about = np.array(load.slope), np.array(load.about)
    xx, xy, yy = load.bend

    def pressure(places: Array) -> Array:
        r = places - about
        x, y = r[..., 0], r[..., 1]
        q: Array = load.q + r @ slope + (xx * x * x + 2 * xy * x * y + yy * y * y) / 2
        return q

    return pressure


AnyLoad = (
    UniformLoad
    | PatchLoad
    | AreaLoad
    | LineLoad
    | PointLoad
    | SelfWeight
    | TemperatureLoad
    | ShrinkageLoad
    | SettlementLoad
)
#: Loads that act on all of a plate.
OnEveryPlate = UniformLoad | SelfWeight | TemperatureLoad | ShrinkageLoad
#: Loads that may press on the ground beside the plate.
OnGround = PatchLoad | AreaLoad
#: Loads that may reach over the plate's edge, where they are cut off; others with a place must lie on the plate.
Spread = PatchLoad | AreaLoad | LineLoad
Load = Annotated[AnyLoad, ByKind()]


def presses_ground(load: AnyLoad) -> TypeGuard[OnGround]:
    """Return whether a load presses on the ground beside the plate, not on the plate."""
    return isinstance(load, OnGround) and load.on == "ground"
