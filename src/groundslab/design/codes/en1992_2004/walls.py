"""Walls with a height by EN 1992-1-1: least bars of walls (9.6.2, 9.6.3) and deep beams (section 9.7), struts (6.2.3).

    A_s,vmin = 0.002 A_c,  A_s,hmin = max(0.25 A_s,v, 0.001 A_c)               9.6.2(1), 9.6.3(1), recommended
    A_s,dbmin = max(0.001 A_c, 1.5 cm2/m) at each face in each direction       9.7(1), recommended
    V_Rd,max = t z nu f_cd / 2, struts of 45 degrees                           6.9

National annexes may have other least bars, which are not known here. z is 0.6 of the height, less than in any but very
high deep beams.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement

#: Bars of both faces over the thickness: upright ones of walls, those of deep beams, at least so many [m2/m].
UPRIGHT, DEEP, LEAST = 0.002, 2 * 0.001, 2 * 1.5e-4
#: Level bars over upright ones, and over the thickness.
OF_UPRIGHT, LEVEL = 0.25, 0.001
#: Lever arm over height.
LEVER = 0.6


def least(t: float) -> tuple[float, float]:
    """Return the least bars [m2/m] upright and level, both faces together, of a wall of a thickness [m]."""
    of_deep_beams = max(DEEP * t, LEAST)
    upright = max(UPRIGHT * t, of_deep_beams)
    return upright, max(OF_UPRIGHT * upright, LEVEL * t, of_deep_beams)


def most(steel: Reinforcement, limit_state: str, t: float, height: float) -> float:
    """Return the largest shear force [N] that struts bear in a wall of a thickness and a height [m]."""
    return t * LEVER * height * materials(steel, limit_state)[0].strut / 2


def steps(steel: Reinforcement, limit_state: str, t: float, height: float) -> Iterator[Step]:
    """Yield how the largest shear force that struts bear is found."""
    concrete, _ = materials(steel, limit_state)
    a, b, c = concrete.annex.nu
    yield Step("strength of the concrete", "f_ck", concrete.f_ck_shear / MEGA, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")
    yield Step("factor of the concrete in struts", "alpha_cc", concrete.alpha_cc_shear, clause="3.1.6(1)")
    formula = f"{a:g} * min(1, {b:g} - f_ck / {c:g}) * alpha_cc * f_ck / gamma_C"
    yield Step("strength of struts", "nu_f_cd", concrete.strut / MEGA, "MPa", formula, "6.2.3(3), 6.2.2(6)")
    yield Step("lever arm", "z", LEVER * height, "m", f"{LEVER:g} * h")
    most_of_struts = most(steel, limit_state, t, height) / MEGA
    formula = "t * z * nu_f_cd / 2"
    yield Step("largest shear force, struts of 45 degrees", "V_max", most_of_struts, "MN", formula, "6.2.3(3), 6.9")
