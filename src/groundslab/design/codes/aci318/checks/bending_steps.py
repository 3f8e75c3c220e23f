"""Bars of a layer by ACI 318-19 22.3, step by step, as it can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.aci318.bending import LEAST
from groundslab.design.codes.aci318.materials import PHI_BENDING
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules import bending_steps
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement


def steps(steel: Reinforcement, need: BarsNeeded, limit_state: str) -> Iterator[Step]:
    """Yield the calculation of a layer's bars in tension."""
    yield from bending_steps.depth(need)
    yield from tension(steel, need, limit_state)
    minimum = [Step("least area", "A_min", 0.0, "", f"{LEAST:g} * h * 10000", "8.6.1.1, 24.4.3.2")]
    yield from bending_steps.required(need, minimum)


def tension(steel: Reinforcement, need: BarsNeeded, _: str) -> Iterator[Step]:
    """Yield the steps from the moment per width to the bars in tension, but for those of depth and moment."""
    concrete, bars = materials(steel)
    yield Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    yield Step("strength reduction factor", "phi", PHI_BENDING, clause="Table 21.2.2")
    f_c, f_y = PHI_BENDING * 0.85 * concrete.f_c, PHI_BENDING * bars.f_y
    yield Step("stress of the block with phi", "f_c", f_c / MEGA, "MPa", "phi * 0.85 * f_c'", "22.2.2.4.1")
    yield Step("specified yield strength", "f_y'", bars.f_y / MEGA, "MPa", clause="20.2.2")
    yield Step("yield strength with phi", "f_y", f_y / MEGA, "MPa", "phi * f_y'", "22.2.3.1")
    yield from bending_steps.area(need, (f_c, f_y), "22.2, 22.3")
