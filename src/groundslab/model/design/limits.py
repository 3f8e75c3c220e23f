"""What a slab may do at most, and what it may press on the ground with: limits, and the strength of the soil."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from groundslab.model.ground import POSITIVE
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

SLOPE, SHARE = Range(above=0, at_most=1), Range(above=0, at_most=1)
PARTIAL, ANGLE, NOT_NEGATIVE = Range(at_least=0.1, at_most=10), Range(above=0, at_most=50), Range(at_least=0)


def _check_any(given: set[str]) -> Iterator[RelativeIssue]:
    if not given:
        yield RelativeIssue((), "no limit", "at least one", "leave the section out where nothing is limited")


class Limits(Section):
    """Limits in the combinations of serviceability, characteristic, frequent, quasi-permanent; none unless given."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_any,)

    settlement: Annotated[float | None, Quantity("length", "w", "largest settlement", POSITIVE, example="25 mm")] = None
    uplift: Annotated[float | None, Quantity("length", "-w", "largest uplift", POSITIVE, example="5 mm")] = None
    differential_settlement: Annotated[
        float | None,
        Quantity("length", "delta w", "largest less smallest settlement of the plate", POSITIVE, example="15 mm"),
    ] = None
    tilt: Annotated[
        float | None, Number("omega", "slope of the plane that fits the settlements best, such as 0.002", SLOPE)
    ] = None
    angular_distortion: Annotated[
        float | None,
        Number("beta", "difference in settlement between two columns over their distance, without the tilt", SLOPE),
    ] = None
    deflection: Annotated[
        float | None,
        Number("", "sag between two neighboring columns over their distance, such as 0.004", SLOPE),
    ] = None
    pressure: Annotated[
        float | None, Quantity("pressure", "p", "largest pressure on the ground", POSITIVE, example="250 kPa")
    ] = None
    mean_pressure: Annotated[
        float | None,
        Quantity("pressure", "p_m", "force on the ground over the area in contact", POSITIVE, example="150 kPa"),
    ] = None
    contact_share: Annotated[
        float | None, Number("A'/A", "least share of the plate's area that is in contact", SHARE)
    ] = None


def _check_strength(phi: float | None, c_u: float | None, c: float, delta: float | None) -> Iterator[RelativeIssue]:
    if (phi is None) == (c_u is None):
        stated = "neither phi nor c_u" if phi is None else "both phi and c_u"
        yield RelativeIssue(("phi",), stated, "one of them", "phi with c of a drained soil, c_u of an undrained one")
    elif phi is None and c:
        yield RelativeIssue(("c",), repr(c), "no cohesion together with c_u", "leave it out")
    elif phi is not None and delta is not None and delta > phi:
        yield RelativeIssue(("delta",), repr(delta), f"at most phi, {phi!r}")


class SoilStrength(Section):
    """Characteristic strength of the soil, and the partial factors of EN 1997-1, by default of design approach 2."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_strength,)

    phi: Annotated[float | None, Number("phi'", "angle of shearing resistance in degrees, drained", ANGLE)] = None
    c: Annotated[float, Quantity("pressure", "c'", "effective cohesion", NOT_NEGATIVE, example="10 kPa")] = 0.0
    c_u: Annotated[
        float | None, Quantity("pressure", "c_u", "undrained shear strength", POSITIVE, example="60 kPa")
    ] = None
    unit_weight: Annotated[
        float,
        Quantity(
            "weight per volume",
            "gamma'",
            "effective unit weight of the soil below the base",
            POSITIVE,
            example="18 kN/m^3",
        ),
    ]
    overburden: Annotated[
        float,
        Quantity(
            "pressure",
            "q'",
            "pressure of the soil next to the slab at the level of its base",
            NOT_NEGATIVE,
            example="15 kPa",
        ),
    ] = 0.0
    delta: Annotated[
        float | None, Number("delta", "angle of friction under the base in degrees; phi by default", ANGLE)
    ] = None
    gamma_phi: Annotated[float, Number("gamma_phi", "partial factor of tan phi'", PARTIAL)] = 1.0
    gamma_c: Annotated[float, Number("gamma_c'", "partial factor of c'", PARTIAL)] = 1.0
    gamma_cu: Annotated[float, Number("gamma_cu", "partial factor of c_u", PARTIAL)] = 1.0
    gamma_Rv: Annotated[float, Number("gamma_R;v", "partial factor of the bearing resistance", PARTIAL)] = 1.4
    gamma_Rh: Annotated[float, Number("gamma_R;h", "partial factor of the resistance against sliding", PARTIAL)] = 1.1

    @property
    def sliding_angle(self) -> float:
        """Return the characteristic angle of friction under the base [degrees]."""
        return self.delta if self.delta is not None else self.phi or 0.0
