"""Walls with a height by EN 1992-1-1:2023: the struts that bear their shear forces (8.2.3); least bars were not read.

    V_Rd,max = t z nu f_cd / 2,  nu = 0.5, struts of 45 degrees                                    8.44

z is 0.6 of the height, as by the first generation. At 45 degrees struts between ties have nu = 0.75 (8.119), so that
these are met, too.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import design_strength
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement

#: Lever arm over height.
LEVER = 0.6


def most(steel: Reinforcement, limit_state: str, t: float, height: float) -> float:
    """Return the largest shear force [N] that struts bear in a wall of a thickness and a height [m]."""
    return t * LEVER * height * materials(steel, limit_state)[0].strut / 2


def steps(steel: Reinforcement, limit_state: str, t: float, height: float) -> Iterator[Step]:
    """Yield how the largest shear force that struts bear is found."""
    concrete, _ = materials(steel, limit_state)
    yield from design_strength(concrete)
    formula = f"{concrete.annex.nu:g} * f_cd"
    yield Step("strength of struts", "nu_f_cd", concrete.strut / MEGA, "MPa", formula, "8.2.3(6)")
    yield Step("lever arm", "z", LEVER * height, "m", f"{LEVER:g} * h")
    most_of_struts = most(steel, limit_state, t, height) / MEGA
    formula = "t * z * nu_f_cd / 2"
    yield Step("largest shear force, struts of 45 degrees", "V_max", most_of_struts, "MN", formula, "8.2.3, 8.44")
