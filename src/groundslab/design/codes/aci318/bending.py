"""Bending reinforcement that a slab needs by ACI 318-19, per meter of width.

The rectangular block of 22.2.2.4, 0.85 f'c over beta_1 c, the compressed face strained by 0.003, phi = 0.9. Slabs must
be controlled by tension (7.3.3.1, 8.3.3.1): eps_t >= f_y / E_s + 0.003 (Table 21.2.2), which bounds c / d. Beyond, bars
in compression take the rest, held as 9.7.6.4 asks. Least bars are 0.0018 of the gross area (8.6.1.1, 24.4.3.2).
"""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318.materials import E_S, EPS_CU, PHI_BENDING, Concrete, Steel
from groundslab.design.rules import bending
from groundslab.design.rules.bending import BendingRule, Block, Reinforcement
from groundslab.errors import InputError, Issue

#: Least bars over the gross area of a section.
LEAST = 0.0018


def deepest_axis(steel: Steel) -> float:
    """Return the largest c / d of a section that is controlled by tension."""
    return EPS_CU / (EPS_CU + steel.f_y / E_S + 0.003)


def required(
    m: Array,
    d: Array | float,
    concrete: Concrete,
    steel: Steel,
    *,
    d_2: Array | float | None = None,
    thickness: Array | float | None = None,
) -> Reinforcement:
    """Return the required reinforcement for factored moments m >= 0 (n,) [N m/m] with depths d (n,) or one [m].

    d_2, thickness: see ``bending.required``; the least bars need the thickness, and are 0 without it.
    """
    phi = PHI_BENDING
    block = Block(
        stress=phi * 0.85 * concrete.f_c, depth=concrete.beta_1, eps_cu=EPS_CU, f_y=phi * steel.f_y, E_s=phi * E_S,
        xi=deepest_axis(steel), most=math.inf,
    )  # fmt: skip
    least = minimum if thickness is not None else lambda d, _: np.zeros(d.shape)
    return bending.required(block, m, d, d_2=d_2, thickness=thickness, minimum=least)


def minimum(d: Array, thickness: Array | float | None = None) -> Array:
    """Return the least area of bars (n,) [m2/m] of sections of thickness (n,) or one [m], 7.6.1.1 and 8.6.1.1."""
    if thickness is None:
        raise InputError([Issue("thickness", "None", "the section's thickness, in m")])
    return LEAST * np.asarray(thickness, dtype=float) + np.zeros(np.shape(d))


def rule(concrete: Concrete, steel: Steel) -> BendingRule:
    """Return how bars are found for some concrete and steel."""
    return BendingRule(partial(required, concrete=concrete, steel=steel), minimum)
