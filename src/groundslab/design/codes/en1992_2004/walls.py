"""Walls with a height by EN 1992-1-1: least bars of walls (9.6.2, 9.6.3) and deep beams (section 9.7), struts (6.2.3).

    A_s,vmin = 0.002 A_c,  A_s,hmin = max(0.25 A_s,v, 0.001 A_c)               9.6.2(1), 9.6.3(1), recommended
    A_s,dbmin = max(0.001 A_c, 1.5 cm2/m) at each face in each direction       9.7(1), recommended
    V_Rd,max = t z nu f_cd / 2, struts of 45 degrees                           6.9

National annexes may have other least bars, which are not known here. z is 0.6 of the height, less than in any but very
high deep beams.
"""

from __future__ import annotations

from groundslab.design.codes.en1992_2004.materials_of_case import materials
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
