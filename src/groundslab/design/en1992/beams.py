"""Beams by EN 1992-1-1 beyond what they share with slabs: least bars (9.2.1.1(1)), links (6.2.3, 9.2.2(5)), flanges.

Between a web and its flange of thickness h_f (6.2.4), for one of both sides:

    v_Ed = Delta F_d / (h_f Delta x)                                        6.20
    A_sf / s_f = v_Ed h_f / (f_yd cot theta_f)                              6.21
    v_Ed <= nu f_cd sin theta_f cos theta_f                                 6.22

No bars are needed for it up to 0.4 f_ctd (6.2.4(6)), f_ctd with the least alpha_ct of annexes, 0.85. cot theta_f is at
most 1.2 in compressed flanges and 1.0 in those in tension, which is within what 6.2.4(4) and its annexes allow.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.basis.design_code import TensionZone
from groundslab.design.en1992 import bending, shear
from groundslab.design.en1992.case_materials import largest_cover, materials
from groundslab.design.eurocode2.struts import LEVER, links_by_struts
from groundslab.model.design.reinforcement import Reinforcement

#: The largest cot theta_f of compressed flanges, and of those in tension (6.2.4(4)).
FLATTEST_IN_FLANGES = (1.2, 1.0)
#: Up to this share of f_ctd the shear in flanges needs no bars (6.2.4(6)), f_ctd = ALPHA_CT 0.7 f_ctm / gamma_C.
BORNE_BY_CONCRETE, ALPHA_CT = 0.4, 0.85


def minimum(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2]: of the mean width of the zone in tension, or, where the annex says so, those
    that yield, with the lever arm 0.9 d, under the moment at which the section cracks.
    """
    concrete, bars = materials(steel, limit_state)
    if concrete.annex.minimum_by_cracking:
        return np.asarray(concrete.f_ctm * zone.modulus / (LEVER * zone.d * bars.f_yk))
    return np.asarray(bending.minimum(zone.d, concrete=concrete, steel=bars) * zone.mean_width)


def flange_bars(steel: Reinforcement, limit_state: str, stress: Array, compressed: Flags) -> Array:
    """Return bars across the web over the flange's thickness (n,) [m2/m per m], 6.2.4; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    cot = np.where(compressed, *FLATTEST_IN_FLANGES)
    needed = links_by_struts(stress, np.ones(len(stress)), concrete.strut, bars.f_yd, cot).area
    f_ctd = ALPHA_CT * 0.7 * concrete.f_ctm / concrete.gamma_c
    least = shear.minimum_beam_links(concrete, bars)
    return np.where(stress <= BORNE_BY_CONCRETE * f_ctd, 0.0, np.maximum(needed, least))


def flange_limit(steel: Reinforcement, limit_state: str) -> float:
    """Return the largest shear stress between web and flange [Pa], with struts at 45 degrees (expression 6.22)."""
    return materials(steel, limit_state)[0].strut / 2


def links(steel: Reinforcement, limit_state: str, v: Array, d: float) -> Array:
    """Return links per area in plan (n,) [m2/m2] for shear forces over the width (n,) [N/m]; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    found = shear.required_links(v, np.full(len(v), d), concrete, bars, largest_cover(steel)).area
    return np.asarray(np.maximum(found, shear.minimum_beam_links(concrete, bars)))
