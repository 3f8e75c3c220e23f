"""Joints between plates whose outlines share a line: hinges, and links that carry shear."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.geometry.validity import TOO_CLOSE
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, bounds_of, list_plates, shared_line
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import ListOf, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove, use_nearest
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, one_of, quote, suggestion

STEEL_SIZE, SPACING = Range(at_least=1e-3, at_most=1.0), Range(at_least=1e-2, at_most=10.0)
OPENING, DOWEL_STEEL = Range(at_least=0.0, at_most=0.2), Range(at_least=200e6, at_most=1e9)


def _check_two(between: tuple[str, str]) -> Iterator[RelativeIssue]:
    if between[0] == between[1]:
        yield RelativeIssue(("between", 1), f"{describe(between[1])} again", "another plate", "a joint has two sides")


def _check_dowel(diameter: float | None, width: float | None, height: float | None) -> Iterator[RelativeIssue]:
    plate = (width, height)
    if diameter is None and None in plate:
        yield RelativeIssue(("diameter",), "nothing", "the diameter, or width and height of plates")
    elif diameter is not None and plate != (None, None):
        yield RelativeIssue(("diameter",), f"{diameter!r} m", "either the diameter, or width and height of plates")


class Dowels(Section):
    """Dowels of steel across a joint, round bars or plates, which carry what the joint does."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_dowel,)

    diameter: Annotated[
        float | None, Quantity("length", "d", "diameter of round dowels", STEEL_SIZE, example="20 mm")
    ] = None
    width: Annotated[
        float | None, Quantity("length", "W", "width of plates along the joint", STEEL_SIZE, example="150 mm")
    ] = None
    height: Annotated[float | None, Quantity("length", "T", "thickness of plates", STEEL_SIZE, example="8 mm")] = None
    spacing: Annotated[float, Quantity("length", "s", "from dowel to dowel along the joint", SPACING, example="300 mm")]
    opening: Annotated[
        float, Quantity("length", "x", "opening of the joint, which dowels bridge", OPENING, example="10 mm")
    ]
    f_yk: Annotated[
        float,
        Quantity("pressure", "f_yk", "characteristic strength of the dowels' steel", DOWEL_STEEL, example="500 MPa"),
    ]


class _Joint(Section):
    """What all joints have."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_two,)

    kind: str
    name: Annotated[str, Text("name of the joint, for reference")] = ""
    between: Annotated[
        tuple[str, str],
        ListOf(
            Text(""),
            "",
            "names of the two plates, which share a line of their outlines",
            2,
            members=("first plate", "second plate"),
        ),
    ]
    dowels: Annotated[Dowels | None, Table("dowels, whose resistance is compared with what the joint carries")] = None

    @property
    def title(self) -> str:
        """Return the name of the joint, or that of its plates."""
        return self.name or " - ".join(self.between)


class HingeJoint(_Joint):
    """A hinge: both sides settle alike and turn by themselves."""

    kind: Annotated[Literal["hinge"], Table("both sides settle alike, without moments")] = "hinge"


class ElasticJoint(_Joint):
    """A link that carries shear by the difference of settlement: dowels, keys, aggregate interlock."""

    kind: Annotated[Literal["elastic"], Table("shear by the difference in settlement, without moments")] = "elastic"
    stiffness: Annotated[
        float,
        Quantity(
            "pressure",
            "k_j",
            "shear per length of the joint over the difference in settlement; 0 transfers nothing",
            Range(at_least=0),
            example="100 MPa",
        ),
    ]
    gap: Annotated[
        float,
        Quantity(
            "length",
            "g_j",
            "play: difference in settlement before the joint carries load",
            Range(at_least=0),
            example="1 mm",
        ),
    ] = 0.0


AnyJoint = HingeJoint | ElasticJoint
Joint = Annotated[AnyJoint, ByKind()]


def stiffness_of(joint: AnyJoint) -> float:
    """Return the stiffness of a joint against shear [N/m2]; that of a hinge is infinite."""
    return joint.stiffness if isinstance(joint, ElasticJoint) else math.inf


def play_of(joint: AnyJoint) -> float:
    """Return the difference of settlement before a joint carries [m]."""
    return joint.gap if isinstance(joint, ElasticJoint) else 0.0


def check_joints(
    plate: Plate, plates: tuple[FurtherPlate, ...], joints: tuple[AnyJoint, ...]
) -> Iterator[RelativeIssue]:
    """Find joints of unknown plates, or of plates that share no line, and second joints of two plates."""
    by_name = {slab.name: slab for slab in list_plates(plate, plates) if slab.name}
    x0, x1, y0, y1 = bounds_of(plate, plates)
    size = max(x1 - x0, y1 - y0)
    seen = set[frozenset[str]]()
    for position, joint in enumerate(joints):
        unknown = [(side, name) for side, name in enumerate(joint.between) if name not in by_name]
        for side, name in unknown:
            expected = one_of(list(by_name)) if by_name else "a plate, and names of [plate] and [[plates]]"
            plate_place = ("joints", position, "between", side)
            hint = suggestion(name, list(by_name))
            others = [name for name in by_name if name not in joint.between]
            repairs = (*use_nearest(plate_place, name, others), remove(("joints", position), label="remove the joint"))
            yield RelativeIssue(plate_place, describe(name), expected, hint, repairs)
        pair = frozenset(joint.between)
        if unknown or len(pair) < 2:
            continue
        place = ("joints", position, "between")
        words = " and ".join(map(quote, joint.between))
        if pair in seen:
            repairs = (remove(("joints", position), label="remove the joint"),)
            yield RelativeIssue(place, f"{words} again", "one joint between two plates", repairs=repairs)
        elif not shared_line(*(by_name[name] for name in joint.between)).length > TOO_CLOSE * size:
            yield RelativeIssue(place, f"{words}, which share no line", "plates whose outlines share a line")
        seen.add(pair)
