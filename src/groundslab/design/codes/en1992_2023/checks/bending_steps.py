"""Bars of a layer by EN 1992-1-1:2023 8.1, step by step, as it can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2023.bending import FORMULAS, STRESS
from groundslab.design.codes.en1992_2023.materials import EPS_C2, EPS_CU
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import design_strength
from groundslab.design.rules import bending_steps
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement


def steps(steel: Reinforcement, need: BarsNeeded, limit_state: str) -> Iterator[Step]:
    """Yield the calculation of a layer's bars in tension."""
    concrete = materials(steel, limit_state)[0]
    yield from bending_steps.depth(need)
    yield from tension(steel, need, limit_state)
    minimum = [
        Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 5.1"),
        Step("least area, which carries what cracks the section", "A_min", 0.0, "", FORMULAS["A_min"], "12.2(2), 12.1"),
    ]
    yield from bending_steps.required(need, minimum)


def tension(steel: Reinforcement, need: BarsNeeded, limit_state: str) -> Iterator[Step]:
    """Yield the steps from the moment per width to the bars in tension, but for those of depth and moment."""
    concrete, bars = materials(steel, limit_state)
    yield from design_strength(concrete)
    yield Step("strain of full stress over that of failure", "r", EPS_C2 / EPS_CU, clause="8.1.2(1)")
    f_c = STRESS * concrete.f_cd
    words = "stress of a block that is as a parabola-rectangle"
    yield Step(words, "f_c", f_c / MEGA, "MPa", FORMULAS["f_c"], "8.1.2(1), 8.4")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="5.2.2")
    yield Step("partial factor of steel", "gamma_S", bars.gamma_s, clause="Table 4.3")
    yield Step("design yield strength", "f_y", bars.f_yd / MEGA, "MPa", "f_yk / gamma_S", "5.2.4, 5.11")
    yield from bending_steps.area(need, (f_c, bars.f_yd), "8.1.1, 8.1.2(1)")
