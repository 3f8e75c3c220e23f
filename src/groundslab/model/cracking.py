"""How the slab cracks under the loads of serviceability, for settlements and moments with cracked stiffness."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.ground import POSITIVE
from groundslab.model.settings import Analysis
from groundslab.schema.base import Section
from groundslab.schema.fields import Choice, ListOf, Number, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range

Duration = Literal["long", "short"]
Serviceability = Literal["characteristic", "frequent", "quasi-permanent"]

CREEP, SHRINKAGE = Range(at_least=0, at_most=10), Range(at_least=0, at_most=2e-3)


class Cracking(Section):
    """Cracked stiffness by EN 1992-1-1 7.4.3, of the slab with the bars provided; ultimate states stay elastic."""

    creep: Annotated[
        float, Number("phi", "creep coefficient phi(inf, t_0) of the concrete, whose modulus is the plate's E", CREEP)
    ] = 0.0
    duration: Annotated[
        Duration,
        Choice(Duration, "of the loads: beta is 0.5 for long-term or repeated loads, 1 for a single short one"),
    ] = "long"
    shrinkage: Annotated[float, Number("eps_cs", "free shrinkage strain, such as 0.0003", SHRINKAGE)] = 0.0
    f_ct: Annotated[
        float | None,
        Quantity(
            "pressure",
            "f_ct",
            "stress at which the concrete cracks; f_ctm by default, less where restrained",
            POSITIVE,
            example="2.9 MPa",
        ),
    ] = None
    limit_states: Annotated[
        tuple[Serviceability, ...],
        ListOf(
            Choice(Serviceability, "", ""), "", "limit states whose combinations have cracked stiffness", unique=True
        ),
    ] = ("characteristic", "frequent", "quasi-permanent")


def check_cracking(
    cracking: Cracking | None, reinforcement: Reinforcement | None, analysis: Analysis
) -> Iterator[RelativeIssue]:
    """Find cracking without bars to hold the cracks, or together with increments of the load."""
    if cracking is None:
        return
    if reinforcement is None or reinforcement.base_bars("bottom_x") is None:
        missing = "no [reinforcement]" if reinforcement is None else "reinforcement without bars"
        hint = "reinforcement.bottom_x = { diameter = ..., spacing = ... }, and so on"
        yield RelativeIssue(("cracking",), missing, "bars provided in all four layers", hint)
    if analysis.increments > 1:
        hint = "a secant stiffness belongs to the full load"
        yield RelativeIssue(("analysis", "increments"), f"{analysis.increments}", "1, as there is [cracking]", hint)
