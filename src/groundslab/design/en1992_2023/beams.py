"""Beams by EN 1992-1-1:2023 beyond what they share with slabs: least bars (12.2(2)), links (8.2.3, 12.4), flanges.

Between a web and its flange (8.2.5) struts have 45 degrees, which any flange allows: bars tau_Ed h_f / f_yd, and
tau_Ed <= nu f_cd / 2. That small stresses need no bars is not made use of, which is on the safe side.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.basis.design_code import TensionZone
from groundslab.design.en1992_2023 import shear
from groundslab.design.en1992_2023.case_materials import flattest, materials
from groundslab.design.eurocode2.struts import LEVER, links_by_struts
from groundslab.model.design.reinforcement import Reinforcement


def minimum(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2], which yield with f_yk and 0.9 d under the moment at which the section cracks."""
    concrete, bars = materials(steel, limit_state)
    return np.asarray(concrete.f_ctm * zone.modulus / (LEVER * zone.d * bars.f_yk))


def flange_bars(steel: Reinforcement, limit_state: str, stress: Array, _compressed: Flags) -> Array:
    """Return bars across the web over the flange's thickness (n,) [m2/m per m], 8.2.5; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    needed = links_by_struts(stress, np.ones(len(stress)), concrete.strut, bars.f_yd, 1.0).area
    return np.asarray(np.maximum(needed, np.where(stress > 0, shear.minimum_links(concrete, bars), 0.0)))


def flange_limit(steel: Reinforcement, limit_state: str) -> float:
    """Return the largest shear stress between web and flange [Pa], with struts at 45 degrees (8.2.5)."""
    return materials(steel, limit_state)[0].strut / 2


def links(steel: Reinforcement, limit_state: str, v: Array, d: float) -> Array:
    """Return links per area in plan (n,) [m2/m2] for shear forces over the width (n,) [N/m]; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    needed = shear.required_links(v, np.full(len(v), d), concrete, bars, flattest(steel, concrete)).area
    return np.maximum(needed, shear.minimum_links(concrete, bars))
