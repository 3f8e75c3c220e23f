"""Walls with a height by ACI 318-19, as deep beams (section 9.9): distributed bars and the largest shear force.

A_v >= 0.0025 b s,  A_vh >= 0.0025 b s_2        9.9.3.1, as 11.6.2 asks of walls
V_u <= phi 0.83 (f'c)^(1/2) b d                 9.9.2.1, with d = 0.9 h
"""

from __future__ import annotations

from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.model.design.reinforcement import Reinforcement

#: Bars of both faces over the thickness, the most of (f'c)^(1/2) b d, and d over the height.
LEAST, MOST, DEPTH = 0.0025, 0.83, 0.9


def least(t: float) -> tuple[float, float]:
    """Return the least bars [m2/m] upright and level, both faces together, of a wall of a thickness [m]."""
    return LEAST * t, LEAST * t


def most(steel: Reinforcement, _: str, t: float, height: float) -> float:
    """Return the largest shear force [N] that a wall of a thickness and a height [m] bears."""
    return PHI_SHEAR * MOST * materials(steel)[0].root * t * DEPTH * height
