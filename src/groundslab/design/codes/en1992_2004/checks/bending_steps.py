"""Bars of a layer by EN 1992-1-1 6.1, step by step, as it can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2004.bending import MINIMUM
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.rules import bending_steps
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement


def steps(steel: Reinforcement, need: BarsNeeded, limit_state: str) -> Iterator[Step]:
    """Yield the calculation of a layer's bars in tension."""
    concrete = materials(steel, limit_state)[0]
    yield from bending_steps.depth(need)
    yield from tension(steel, need, limit_state)
    of_strength, least = concrete.annex.minimum
    minimum = [Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")]
    formula = (
        MINIMUM["by cracking"] if concrete.annex.minimum_by_cracking
        else MINIMUM["by strength"].format(of_strength=of_strength, least=least)
    )  # fmt: skip
    minimum.append(Step("least area", "A_min", 0.0, "", formula, "9.2.1.1(1)"))
    yield from bending_steps.required(need, minimum)


def tension(steel: Reinforcement, need: BarsNeeded, limit_state: str) -> Iterator[Step]:
    """Yield the steps from the moment per width to the bars in tension, but for those of depth and moment."""
    concrete, bars = materials(steel, limit_state)
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")
    yield Step("factor of the concrete", "alpha_cc", concrete.alpha_cc, clause="3.1.6(1)")
    yield Step("factor of the block's stress", "eta", concrete.eta, clause="3.1.7(3)")
    f_c = concrete.eta * concrete.f_cd
    yield Step("stress of the block", "f_c", f_c / MEGA, "MPa", "eta * alpha_cc * f_ck / gamma_C", "3.1.7(3)")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="3.2.2(3)")
    yield Step("partial factor of steel", "gamma_S", bars.gamma_s, clause="2.4.2.4")
    yield Step("design yield strength", "f_y", bars.f_yd / MEGA, "MPa", "f_yk / gamma_S", "3.2.7(2)")
    yield from bending_steps.area(need, (f_c, bars.f_yd), "6.1(2), 3.1.7(3)")
