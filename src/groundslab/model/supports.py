"""Supports at points and along lines: rigid or elastic, one-sided or not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.plan import Plan, Ring, Segment, format_place
from groundslab.model.axes.crossings import AtCrossing, AtCrossings
from groundslab.model.ground import POSITIVE, AnyGround, ContinuousGround
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, first_sections, list_plates
from groundslab.model.shapes import Place
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.places import coordinate
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove, set_value, use_free_name
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, quote

#: A pile is at least so many diameters long: formulas are those of slender ones.
LEAST_SLENDERNESS = 5.0

Acts = Literal["both ways", "in compression", "in tension"]
Turning = Literal["free", "fixed"]
LimitIs = Literal["ultimate resistance", "characteristic resistance", "design resistance"]
#: Partial factors of a characteristic resistance.
FACTOR = Range(at_least=1, at_most=10)

SupportName = Annotated[str, Text("name of the support, used by loads and results")]
ActsKey = Annotated[Acts, Choice(Acts, "in compression: it only pushes up; in tension: it only holds down")]
GapKey = Annotated[
    float,
    Quantity(
        "length",
        "g_s",
        "distance that the plate moves freely before the support acts",
        Range(at_least=0),
        example="5 mm",
    ),
]

LimitIsKey = Annotated[
    LimitIs,
    Choice(
        LimitIs,
        "kind of limit (EN 1997-1 7.6.2, 7.6.3): at its ultimate resistance R a support yields, which needs "
        "attention; one that reaches its design resistance R_d fails, as does one beyond its characteristic resistance "
        "R_k over the partial factor in ultimate combinations",
    ),
]
GivenFactorKey = Annotated[
    float | None,
    Number("gamma_R", "partial factor of a characteristic resistance; in uplift at least 1.4 in tension", FACTOR),
]


def _check_limit_is(limit: float | None, given: set[str]) -> Iterator[RelativeIssue]:
    if "limit_is" in given and limit is None:
        repairs = (remove(("limit_is",)),)
        yield RelativeIssue(("limit_is",), "limit_is without a limit", "limit, the resistance", repairs=repairs)


def _check_factor(limit_is: str, gamma_R: float | None) -> Iterator[RelativeIssue]:
    characteristic = limit_is == "characteristic resistance"
    if characteristic and gamma_R is None:
        hint = "1.1 for piles in compression, 1.15 in tension, by EN 1997-1 Tables A.6 to A.8, R2"
        yield RelativeIssue(("gamma_R",), "nothing", "the partial factor of the characteristic resistance", hint)
    elif not characteristic and gamma_R is not None:
        repairs = (remove(("gamma_R",)), set_value(("limit_is",), "characteristic resistance"))
        expected = 'none, unless limit_is = "characteristic resistance"'
        yield RelativeIssue(("gamma_R",), "a partial factor", expected, repairs=repairs)


def _check_pile_factors(limit_is: str, given: set[str]) -> Iterator[RelativeIssue]:
    for key in ("gamma_R", "gamma_R_tension"):
        if key in given and limit_is != "characteristic resistance":
            repairs = (remove((key,)), set_value(("limit_is",), "characteristic resistance"))
            expected = 'none, unless limit_is = "characteristic resistance"'
            yield RelativeIssue((key,), "a partial factor", expected, repairs=repairs)


def _check_pile_limit_is(limit: float | None, limit_tension: float | None, given: set[str]) -> Iterator[RelativeIssue]:
    return _check_limit_is(limit or limit_tension or None, given)


def _check_one_sided(acts: str, gap: float, limit: float | None) -> Iterator[RelativeIssue]:
    hint = 'acts = "in compression" or "in tension"'
    one_way = tuple(set_value(("acts",), word) for word in ("in compression", "in tension"))
    if acts == "both ways" and gap > 0:
        repairs = (remove(("gap",)), *one_way)
        yield RelativeIssue(("gap",), f"{gap!r} m", "no gap for a support that acts both ways", hint, repairs)
    if acts == "both ways" and limit is not None:
        repairs = (remove(("limit",)), *one_way)
        yield RelativeIssue(("limit",), "a limit", "no limit for a support that acts both ways", hint, repairs)


def _check_rotation(rotation: str, rotational_stiffness: float | None) -> Iterator[RelativeIssue]:
    if rotation == "fixed" and rotational_stiffness is not None:
        repairs = (remove(("rotational_stiffness",)), set_value(("rotation",), "free"))
        yield RelativeIssue(("rotational_stiffness",), "a stiffness", 'none, as rotation is "fixed"', repairs=repairs)


class _AtPoint(Section):
    """What supports at a point have."""

    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("x", "y")}

    kind: str
    name: SupportName = ""
    x: Annotated[float, coordinate(0, "position")]
    y: Annotated[float, coordinate(1, "position")]
    at: AtCrossing = ""

    @property
    def points(self) -> tuple[tuple[float, float]]:
        """Its only place."""
        return ((self.x, self.y),)

    @property
    def edges(self) -> tuple[Segment, ...]:
        """No lines."""
        return ()


class PointSupport(_AtPoint):
    """A support at a point, such as a column below or a pile."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_one_sided, _check_rotation, _check_limit_is, _check_factor)

    kind: Annotated[Literal["point"], Table("support at a point, such as a column below or a pile")] = "point"
    diameter: Annotated[
        float | None,
        Quantity(
            "length",
            "d",
            "diameter, for punching of the plate over it; not checked by default",
            POSITIVE,
            example="0.4 m",
        ),
    ] = None
    stiffness: Annotated[
        float | None, Quantity("stiffness", "K", "force per settlement; rigid by default", POSITIVE, example="200 MN/m")
    ] = None
    acts: ActsKey = "both ways"
    gap: GapKey = 0.0
    limit: Annotated[
        float | None,
        Quantity("force", "R_max", "largest force, at which the support yields", POSITIVE, example="1200 kN"),
    ] = None
    limit_is: LimitIsKey = "ultimate resistance"
    gamma_R: GivenFactorKey = None
    rotation: Annotated[Turning, Choice(Turning, "whether the plate may turn there")] = "free"
    rotational_stiffness: Annotated[
        float | None,
        Quantity(
            "moment per angle",
            "K_r",
            "moment per rotation, about both axes; none by default",
            POSITIVE,
            example="50 MNm/rad",
        ),
    ] = None

    @property
    def elastic(self) -> bool:
        """Whether it gives way."""
        return self.stiffness is not None


def _check_line_rotation(rotation: str, stiffness: float | None, acts: str) -> Iterator[RelativeIssue]:
    if rotation == "fixed" and (stiffness is not None or acts != "both ways"):
        expected = '"free", or a rigid support that acts both ways: along the line w = 0 then says how it turns'
        yield RelativeIssue(("rotation",), '"fixed"', expected)


class LineSupport(Section):
    """A support along straight lines, such as a wall or a beam below; rigid lines hinge or clamp the plate."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_one_sided, _check_line_rotation, _check_limit_is, _check_factor)

    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("points",)}

    kind: Annotated[Literal["line"], Table("support along straight lines, such as a wall")] = "line"
    name: SupportName = ""
    points: Annotated[tuple[tuple[float, float], ...], ListOf(Place, "x, y", "the line's points, in order")]
    at: AtCrossings = ()
    stiffness: Annotated[
        float | None,
        Quantity(
            "stiffness per length",
            "K_l",
            "force per length and settlement; rigid by default",
            POSITIVE,
            example="50 MN/m^2",
        ),
    ] = None
    acts: ActsKey = "both ways"
    gap: GapKey = 0.0
    limit: Annotated[
        float | None,
        Quantity(
            "force per length", "r_max", "largest force per length, at which it yields", POSITIVE, example="300 kN/m"
        ),
    ] = None
    limit_is: LimitIsKey = "ultimate resistance"
    gamma_R: GivenFactorKey = None
    rotation: Annotated[Turning, Choice(Turning, "whether the plate may turn across the line")] = "free"

    @property
    def edges(self) -> tuple[Segment, ...]:
        """The pieces of the line, one after the other."""
        return tuple(Segment(start, end) for start, end in pairwise(self.points))

    @property
    def elastic(self) -> bool:
        """Whether it gives way."""
        return self.stiffness is not None


def _check_slenderness(length: float, diameter: float) -> Iterator[RelativeIssue]:
    if length < LEAST_SLENDERNESS * diameter:
        expected = f"at least {LEAST_SLENDERNESS:g} diameters, {LEAST_SLENDERNESS * diameter:g} m"
        yield RelativeIssue(("length",), f"{length:g} m", expected, "anything shorter is a footing, not a pile")


class Pile(_AtPoint):
    """A pile below the plate, whose stiffness follows from the ground; ground and other piles settle it, too."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_slenderness, _check_pile_limit_is, _check_pile_factors)

    kind: Annotated[Literal["pile"], Table("a pile in ground of elastic layers, which give its stiffness")] = "pile"
    length: Annotated[float, Quantity("length", "l", "length below the plate", POSITIVE, example="12 m")]
    diameter: Annotated[float, Quantity("length", "d", "diameter", POSITIVE, example="0.6 m")]
    E: Annotated[
        float, Quantity("pressure", "E_p", "Young's modulus; of concrete by default", POSITIVE, example="30 GPa")
    ] = 30e9
    limit: Annotated[
        float | None,
        Quantity("force", "R_c", "largest force in compression; none by default", POSITIVE, example="1200 kN"),
    ] = None
    limit_tension: Annotated[
        float | None,
        Quantity("force", "R_t", "largest force in tension; none by default, 0 for one that only pushes",
                 Range(at_least=0), example="200 kN"),
    ] = None  # fmt: skip
    limit_is: LimitIsKey = "ultimate resistance"
    gamma_R: Annotated[
        float,
        Number(
            "gamma_t",
            "partial factor of the characteristic resistance in compression; by default that of design approach 2 (EN "
            "1997-1 Tables A.6 to A.8)",
            FACTOR,
        ),
    ] = 1.1
    gamma_R_tension: Annotated[
        float,
        Number(
            "gamma_s;t",
            "the same of the resistance in tension; in uplift it is at least 1.4 (EN 1997-1 Table A.16)",
            FACTOR,
        ),
    ] = 1.15

    @property
    def acts(self) -> Acts:
        """How the pile acts."""
        return "in compression" if self.limit_tension == 0 else "both ways"

    @property
    def elastic(self) -> bool:
        """Whether it gives way."""
        return True

    @property
    def rotation(self) -> Turning:
        """Whether the plate may turn there."""
        return "free"


AnySupport = PointSupport | LineSupport | Pile
Support = Annotated[AnySupport, ByKind()]


def check_line_supports(supports: tuple[AnySupport, ...]) -> Iterator[RelativeIssue]:
    """Find lines of fewer than two points."""
    for position, support in enumerate(supports):
        if isinstance(support, LineSupport) and len(support.points) < 2:
            yield RelativeIssue(("supports", position, "points"), f"{len(support.points)} point", "at least two")


def check_support_distances(
    bounds: tuple[float, float, float, float], supports: tuple[AnySupport, ...]
) -> Iterator[RelativeIssue]:
    """Find supports further off the rectangle x0, x1, y0, y1 around the plates [m] than it is long."""
    x0, x1, y0, y1 = bounds
    far = max(x1 - x0, y1 - y0)
    for position, support in enumerate(supports):
        for x, y in support.points:
            if not (x0 - far <= x <= x1 + far and y0 - far <= y <= y1 + far):
                yield RelativeIssue(
                    ("supports", position), f"a place far off the plate, {format_place((x, y))} m", "one on it"
                )
                break


def check_names(part: str, names: list[str], needed: bool) -> Iterator[RelativeIssue]:
    """Find names in a list that are missing though needed, or given twice."""
    seen = set[str]()
    for position, name in enumerate(names):
        if not name and needed:
            yield RelativeIssue((part, position, "name"), "no name", "a name")
        if name in seen:
            place, repairs = (part, position, "name"), use_free_name((part, position, "name"), name, names)
            yield RelativeIssue(place, f"{describe(name)} again", "a unique name", repairs=repairs)
        seen |= {name} - {""}


def plan_of_plate(
    plate: Plate,
    supports: tuple[AnySupport, ...],
    beyond: Ring | None = None,
    plates: tuple[FurtherPlate, ...] = (),
    lines: tuple[tuple[tuple[tuple[float, float], ...], tuple[float, ...]], ...] = (),
) -> Plan:
    """Return the plan of a plate, and of further ones, with supports and further lines that the mesh is to follow.

    A line is its points, and the bulges of its pieces. Sections are numbered as by `first_sections`.
    """
    every = list_plates(plate, plates)
    starts = first_sections(every)
    along = [support.points for support in supports if support.edges]
    return Plan(
        plate.ring(),
        tuple(shape.ring() for slab in every for shape in slab.openings),
        tuple(
            (zone.shape.ring(), number)
            for slab, start in zip(every, starts, strict=True)
            for number, zone in enumerate(slab.zones, start=start + 1)
        ),
        beyond,
        tuple(support.points[0] for support in supports if not support.edges),
        (*along, *(points for points, _ in lines)),
        (*((),) * len(along), *(bulges for _, bulges in lines)),
        others=tuple((slab.ring(), start) for slab, start in zip(plates, starts[1:], strict=True)),
    )


def check_piles(ground: AnyGround, supports: tuple[AnySupport, ...]) -> Iterator[RelativeIssue]:
    """Find piles in ground that does not give their stiffness, and those that end below its layers."""
    for position, pile in enumerate(supports):
        if not isinstance(pile, Pile):
            continue
        place = ("supports", position)
        if not isinstance(ground, ContinuousGround):
            expected = 'ground.kind = "continuum" or "constrained modulus"'
            hint = 'kind = "point" takes a stiffness'
            yield RelativeIssue((*place, "kind"), f'"pile" in {quote(ground.kind)} ground', expected, hint)
            continue
        depth = sum(layer.thickness for layer in ground.layers)
        if getattr(ground, "half_space", None) is None and pile.length >= depth:
            hint = 'a pile on the rigid base is a support of kind "point", with E A / l as its stiffness'
            long_pile = f"{pile.length:g} m, with layers of {depth:g} m"
            yield RelativeIssue((*place, "length"), long_pile, "a pile that ends in the layers", hint)
