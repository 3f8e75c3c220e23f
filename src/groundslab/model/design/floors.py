"""Industrial floors: what the codes of floors need to know."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.model.design.limits import PARTIAL
from groundslab.model.design.reinforcement import CONCRETE, STEEL, ConcreteChoice, ConcreteClass, check_concrete
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.load_cases import Combination, Combine, has_ultimate_combination
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate, list_plates
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import ByKind, Table

TRANSFER, FRICTION, SAFETY = Range(at_least=0, at_most=0.9), Range(above=0, at_most=5), Range(at_least=1, at_most=5)
RUPTURE, RESIDUAL = Range(at_least=5e5, at_most=2e7), Range(at_least=1e5, at_most=2e7)
#: Yield lines need this much residual strength (ACI 360R-10 11.3.3.3).
RATIO = Range(at_least=0.3, at_most=2)


def _check_restraint(
    friction: float | None, joint_spacing: float | None, unit_weight: float, given: set[str]
) -> Iterator[RelativeIssue]:
    if (friction is None) != (joint_spacing is None):
        missing = "friction" if friction is None else "joint_spacing"
        yield RelativeIssue((missing,), "nothing", "friction and joint_spacing, both of them")
    elif friction is None and "unit_weight" in given:
        yield RelativeIssue(("unit_weight",), f"{unit_weight!r} N/m^3", "no weight without friction and joint_spacing")


class _Floor(Section):
    """What floors have by any method."""

    kind: str
    joint_transfer: Annotated[
        float, Number("t_j", "share of a load at the plate's edge that joints transfer to the next bay", TRANSFER)
    ] = 0.0
    friction: Annotated[
        float | None, Number("mu", "coefficient of friction on the ground, for the restraint of shrinkage", FRICTION)
    ] = None
    joint_spacing: Annotated[
        float | None,
        Quantity("length", "L", "spacing of joints that open, for the restraint of shrinkage", POSITIVE, example="6 m"),
    ] = None
    unit_weight: Annotated[
        float,
        Quantity(
            "weight per volume",
            "gamma",
            "unit weight of the concrete, for friction on the ground",
            POSITIVE,
            example="25 kN/m^3",
        ),
    ] = 24e3


def _check_sagging(
    f_R1: float | None, f_R4: float | None, mesh_area: float | None, mesh_axis: float | None
) -> Iterator[RelativeIssue]:
    for name, pair in (("f_R1", (f_R1, f_R4)), ("mesh_area", (mesh_area, mesh_axis))):
        if (pair[0] is None) != (pair[1] is None):
            other = {"f_R1": "f_R4", "mesh_area": "mesh_axis"}[name]
            missing = name if pair[0] is None else other
            yield RelativeIssue((missing,), "nothing", f"{name} and {other}, both of them")
    if f_R1 is not None and mesh_area is not None:
        yield RelativeIssue(
            ("mesh_area",), "a mesh together with fibers", "one of them", "that of the larger moment counts"
        )


def _check_bars(mesh_area: float | None, f_yk: float, gamma_s: float, given: set[str]) -> Iterator[RelativeIssue]:
    for name, value in (("f_yk", f_yk), ("gamma_s", gamma_s)):
        if mesh_area is None and name in given:
            yield RelativeIssue((name,), repr(value), f"no {name} without a mesh")


def _check_transfer(joint_transfer: float, R_e3: float | None, given: set[str]) -> Iterator[RelativeIssue]:
    if R_e3 is None and "joint_transfer" in given:
        hint = "stresses are those of a free edge"
        yield RelativeIssue(("joint_transfer",), repr(joint_transfer), "none without R_e3 and its yield lines", hint)


class TR34Floor(_Floor):
    """A floor by TR34, fourth edition: yield lines in the ultimate combinations."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_restraint, check_concrete, _check_sagging, _check_bars)

    kind: Annotated[Literal["TR34"], Table("Concrete Society TR34, fourth edition: yield lines")] = "TR34"
    concrete: Annotated[ConcreteClass | None, ConcreteChoice] = None
    f_ck: Annotated[
        float | None,
        Quantity(
            "pressure", "f_ck", "characteristic strength of the concrete, if no class", CONCRETE, example="30 MPa"
        ),
    ] = None
    gamma_c: Annotated[float, Number("gamma_C", "partial factor of concrete, with fibers or without", PARTIAL)] = 1.5
    f_R1: Annotated[
        float | None,
        Quantity(
            "pressure", "f_R1", "residual strength of fiber concrete at 0.5 mm (EN 14651)", RESIDUAL, example="2.5 MPa"
        ),
    ] = None
    f_R4: Annotated[
        float | None,
        Quantity(
            "pressure", "f_R4", "residual strength of fiber concrete at 3.5 mm (EN 14651)", RESIDUAL, example="2 MPa"
        ),
    ] = None
    mesh_area: Annotated[
        float | None,
        Quantity(
            "area per length",
            "A_s",
            "bars at the bottom, the smaller amount of both directions",
            POSITIVE,
            example="5 cm^2/m",
        ),
    ] = None
    mesh_axis: Annotated[
        float | None, Quantity("length", "d_1", "bottom face to the axis of the inner bars", POSITIVE, example="50 mm")
    ] = None
    f_yk: Annotated[float, Quantity("pressure", "f_yk", "yield strength of the bars", STEEL, example="500 MPa")] = 500e6
    gamma_s: Annotated[float, Number("gamma_S", "partial factor of the bars", PARTIAL)] = 1.15


class ACI360Floor(_Floor):
    """A floor by ACI 360R-10 and PCA: flexural stresses in the combinations of serviceability."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_restraint, _check_transfer)

    kind: Annotated[Literal["ACI 360"], Table("ACI 360R-10 and PCA: flexural stresses")] = "ACI 360"
    f_r: Annotated[float, Quantity("pressure", "f_r", "modulus of rupture of the concrete", RUPTURE, example="4 MPa")]
    safety_factor: Annotated[float, Number("SF", "factor of safety, usually 1.4 to 2.0", SAFETY)] = 1.7
    repetitions: Annotated[
        float | None,
        Number("N", "load repetitions over the life of the floor, for fatigue", Range(at_least=1, at_most=1e9)),
    ] = None
    R_e3: Annotated[
        float | None, Number("R_e,3", "residual strength of fiber concrete over f_r, for yield lines", RATIO)
    ] = None


AnyFloor = TR34Floor | ACI360Floor
Floor = Annotated[AnyFloor, ByKind()]


def check_floor(
    floor: AnyFloor | None,
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    combinations: tuple[Combination, ...],
    combine: Combine | None,
) -> Iterator[RelativeIssue]:
    """Find a floor by TR34 without an ultimate combination, or with bars that do not fit into the plate."""
    if not isinstance(floor, TR34Floor):
        return
    if not has_ultimate_combination(combinations, combine):
        add = '[[combinations]] with limit_state = "ultimate", or "ultimate" in the sets of [combine]'
        yield RelativeIssue(("floor",), "no ultimate combination of loads", "at least one to check", f"add {add}")
    slabs = [*list_plates(plate, plates)]
    zones = [zone.thickness for slab in slabs for zone in slab.zones if zone.thickness is not None]
    thinnest = min([*(slab.thickness for slab in slabs), *zones])
    if floor.mesh_axis is not None and floor.mesh_axis >= thinnest / 2:
        expected = f"less than half of the thickness, {thinnest / 2!r} m"
        yield RelativeIssue(("floor", "mesh_axis"), f"{floor.mesh_axis!r} m", expected)
