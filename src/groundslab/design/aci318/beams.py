"""Beams by ACI 318-19 beyond what they share with slabs: least bars (9.6.1.2), links (22.5.8.5.3, 9.6.3.4), flanges.

    A_s >= max(0.25 (f'c)^(1/2), 1.4 MPa) / f_y b_w d,    f'c in MPa

f_y is at most 550 MPa there, and b_w the lesser of 2 b_w and the flange's width where the flange is in tension, which
is asked of statically determinate beams alone (9.6.1.2). Across the plane between a web and its flange bars act by
shear friction (22.9): A_vf = V_u / (phi mu f_y) with mu = 1.4 of concrete cast at once, f_y at most 420 MPa (Table
20.2.2.4(a)), and V_u <= phi min(0.2 f'c, 3.3 MPa + 0.08 f'c, 11 MPa) A_c (Table 22.9.4.4).
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.aci318 import shear
from groundslab.design.aci318.case_materials import materials
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.basis.design_code import TensionZone
from groundslab.model.design.reinforcement import Reinforcement

_MPA = 1e6
#: The largest f_y that counts in the least bars [Pa].
MOST_F_Y = 550 * _MPA
#: Friction of concrete cast at once (Table 22.9.4.2), and the largest f_y of bars across (Table 20.2.2.4(a)) [Pa].
MU, MOST_F_Y_FRICTION = 1.4, 420 * _MPA


def minimum(steel: Reinforcement, _: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2]."""
    concrete, bars = materials(steel)
    ratio = max(0.25 * concrete.root, 1.4 * _MPA) / min(bars.f_y, MOST_F_Y)
    return np.asarray(ratio * min(2 * zone.web, zone.face) * zone.d)


def flange_bars(steel: Reinforcement, limit_state: str, stress: Array, _compressed: Flags) -> Array:
    """Return bars across the web over the flange's thickness (n,) [m2/m per m], 22.9.4.2; inf where none help."""
    _, bars = materials(steel)
    needed = stress / (PHI_SHEAR * MU * min(bars.f_y, MOST_F_Y_FRICTION))
    return np.where(stress > flange_limit(steel, limit_state), np.inf, needed)


def flange_limit(steel: Reinforcement, _: str) -> float:
    """Return the largest shear stress between web and flange [Pa], Table 22.9.4.4."""
    f_c = materials(steel)[0].f_c
    return PHI_SHEAR * min(0.2 * f_c, 3.3 * _MPA + 0.08 * f_c, 11 * _MPA)


def links(steel: Reinforcement, _: str, v: Array, d: float) -> Array:
    """Return links per area in plan (n,) [m2/m2] for shear forces over the width (n,) [N/m]; inf where none help."""
    concrete, bars = materials(steel)
    return np.array([shear.links(float(force), d, concrete, bars) for force in v])
