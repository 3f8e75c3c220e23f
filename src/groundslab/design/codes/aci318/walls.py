"""Walls with a height by ACI 318-19, as deep beams (section 9.9): distributed bars and the largest shear force.

A_v >= 0.0025 b s,  A_vh >= 0.0025 b s_2        9.9.3.1, as 11.6.2 asks of walls
V_u <= phi 0.83 (f'c)^(1/2) b d                 9.9.2.1, with d = 0.9 h
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.aci318.materials import MOST_ROOT, PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.model.design.reinforcement import Reinforcement

#: Bars of both faces over the thickness, the most of (f'c)^(1/2) b d, and d over the height.
LEAST, MOST, DEPTH = 0.0025, 0.83, 0.9


def least(t: float) -> tuple[float, float]:
    """Return the least bars [m2/m] upright and level, both faces together, of a wall of a thickness [m]."""
    return LEAST * t, LEAST * t


def most(steel: Reinforcement, _: str, t: float, height: float) -> float:
    """Return the largest shear force [N] that a wall of a thickness and a height [m] bears."""
    return PHI_SHEAR * MOST * materials(steel)[0].root * t * DEPTH * height


def steps(steel: Reinforcement, limit_state: str, t: float, height: float) -> Iterator[Step]:
    """Yield how the largest shear force that a wall bears is found."""
    concrete, _ = materials(steel)
    yield Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    formula = f"min({MOST_ROOT:g}, sqrt(f_c'))"
    yield Step("its root that counts", "r", concrete.root / MEGA, "MPa^0.5", formula, "22.5.3.1")
    yield Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1")
    yield Step("depth", "d", DEPTH * height, "m", f"{DEPTH:g} * h", "9.9.2.1")
    largest = most(steel, limit_state, t, height) / MEGA
    yield Step("largest shear force", "V_max", largest, "MN", f"phi * {MOST:g} * r * t * d", "9.9.2.1")
