"""What a slab may do at most, and what it may press on the ground with: limits that its results are checked against."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from groundslab.model.ground import POSITIVE
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

SLOPE, SHARE = Range(above=0, at_most=1), Range(above=0, at_most=1)


def _check_any(given: set[str]) -> Iterator[RelativeIssue]:
    if not given:
        yield RelativeIssue((), "no limit", "at least one", "leave the section out where nothing is limited")


class Limits(Section):
    """Limits in the combinations of serviceability, which are all that are not ultimate; none unless given."""

    checks: ClassVar[tuple[Check, ...]] = (_check_any,)

    settlement: Annotated[float | None, Quantity("length", "w", "largest settlement", POSITIVE)] = None
    uplift: Annotated[float | None, Quantity("length", "-w", "largest uplift", POSITIVE)] = None
    differential_settlement: Annotated[
        float | None, Quantity("length", "delta w", "largest less smallest settlement of the plate", POSITIVE)
    ] = None
    tilt: Annotated[
        float | None, Number("omega", "slope of the plane that fits the settlements best, such as 0.002", SLOPE)
    ] = None
    angular_distortion: Annotated[
        float | None,
        Number("beta", "difference of settlement between two columns over their distance, without the tilt", SLOPE),
    ] = None
    pressure: Annotated[float | None, Quantity("pressure", "p", "largest pressure on the ground", POSITIVE)] = None
    mean_pressure: Annotated[
        float | None, Quantity("pressure", "p_m", "force on the ground over the area in contact", POSITIVE)
    ] = None
    contact_share: Annotated[
        float | None, Number("A'/A", "least share of the plate's area that is in contact", SHARE)
    ] = None
