"""Walls with a height by EN 1992-1-1:2023: the struts that bear their shear forces (8.2.3); least bars were not read.

    V_Rd,max = t z nu f_cd / 2,  nu = 0.5, struts of 45 degrees                                    8.44

z is 0.6 of the height, as by the first generation. At 45 degrees struts between ties have nu = 0.75 (8.119), so that
these are met, too.
"""

from __future__ import annotations

from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.model.design.reinforcement import Reinforcement

#: Lever arm over height.
LEVER = 0.6


def most(steel: Reinforcement, limit_state: str, t: float, height: float) -> float:
    """Return the largest shear force [N] that struts bear in a wall of a thickness and a height [m]."""
    return t * LEVER * height * materials(steel, limit_state)[0].strut / 2
