"""Beams by EN 1992-1-1:2023 beyond what they share with slabs: least bars (12.2(2)), links, torsion, flanges.

Links carry shear (8.2.3) and, with struts of 45 degrees, the torsion of a tube (clause 8.3):

    A_sw / s = V_Ed / (z f_ywd cot theta) + T_Ed / (A_k f_ywd)                 8.42, 8.82, all legs of closed links
    A_sl = T_Ed u_k / (2 A_k f_yd)                                             8.83
    tau_t / (nu f_cd / 2) + tau_Ed (cot theta + tan theta) / (nu f_cd) <= 1    8.84, 8.86

with nu = 0.5 for both; 0.6 may be used for torsion at 45 degrees.

Between a web and its flange (8.2.5) struts have 45 degrees, which any flange allows: bars tau_Ed h_f / f_yd, and
tau_Ed <= nu f_cd / 2. That small stresses need no bars is not made use of, which is on the safe side.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.codes.en1992_2023 import shear
from groundslab.design.codes.en1992_2023.materials_of_case import flattest, materials
from groundslab.design.codes.eurocode2 import torsion
from groundslab.design.codes.eurocode2.struts import LEVER, Links, flattest_step, links_by_struts
from groundslab.design.codes.eurocode2.torsion import Tube
from groundslab.design.rules.bending_steps import CM2
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import ALL_LEGS, Flange, Web, WebNeed, force_steps
from groundslab.model.design.reinforcement import Reinforcement

#: A share of the concrete that is as good as none.
NOTHING = 1e-12


def minimum(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2], which yield with f_yk and 0.9 d under the moment at which the section cracks."""
    concrete, bars = materials(steel, limit_state)
    return np.asarray(concrete.f_ctm * zone.modulus / (LEVER * zone.d * bars.f_yk))


def minimum_steps(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Iterator[Step]:
    """Yield the calculation of the least bars at one place."""
    concrete = materials(steel, limit_state)[0]
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 5.1")
    yield Step("section modulus of the face in tension", "W", float(zone.modulus[0]), "m3")
    least = float(minimum(steel, limit_state, zone)[0]) * CM2
    formula = f"f_ctm * W / ({LEVER:g} * d * f_yk) * 10000"
    yield Step("least bars", "A_min", least, "cm2", formula, "12.2(2), 12.1")


def cracks(steel: Reinforcement) -> str:
    """Return what of the cracks of beams is not designed: 9.2.2 was read for wide sections alone."""
    if steel.w_max is None and steel.exposure is None:
        return ""
    return "cracks of beams, least bars of flanges and webs for these (9.2.2) among them, are not checked"


def flange_steps(steel: Reinforcement, limit_state: str, flange: Flange) -> Iterator[Step]:
    """Yield the calculation from the stress between web and flange to the bars across at one place."""
    concrete, bars = materials(steel, limit_state)
    used = float(flange.stress[0]) / flange_limit(steel, limit_state)
    yield from shear.design_strength(concrete)
    yield Step(
        "strength of struts", "f_nu", concrete.strut / MEGA, "MPa", f"{concrete.annex.nu:g} * f_cd", "8.2.5, 8.71"
    )
    yield Step("share used, of struts at 45 degrees", "eta", used, "", "2 * tau / f_nu", "8.2.5, 8.70")
    area = float(flange_bars(steel, limit_state, flange.stress, flange.compressed)[0] * flange.h[0]) * CM2
    if used > 1:
        return
    yield Step("strength of bars", "f_yd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="5.2.4")
    least = shear.minimum_links(concrete, bars)
    yield Step("least ratio of bars", "rho_min", least, "", "0.08 * sqrt(f_ck) / f_yk", "12.4")
    formula = "max(tau / f_yd, rho_min) * h_f * 10000" if area else ""
    yield Step("bars across the rib, both faces together", "a_sf", area, "cm2/m", formula, "8.2.5, 8.69")


def flange_bars(steel: Reinforcement, limit_state: str, stress: Array, _compressed: Flags) -> Array:
    """Return bars across the web over the flange's thickness (n,) [m2/m per m], 8.2.5; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    needed = links_by_struts(stress, np.ones(len(stress)), concrete.strut, bars.f_yd, 1.0).area
    return np.asarray(np.maximum(needed, np.where(stress > 0, shear.minimum_links(concrete, bars), 0.0)))


def flange_limit(steel: Reinforcement, limit_state: str) -> float:
    """Return the largest shear stress between web and flange [Pa], with struts at 45 degrees (8.2.5)."""
    return materials(steel, limit_state)[0].strut / 2


def web(steel: Reinforcement, limit_state: str, webs: Web) -> WebNeed:
    """Return the links and the bars along the beam that webs (k,) need."""
    concrete, bars = materials(steel, limit_state)
    tube = Tube.of(webs)
    tau, z, struts = tube.stress(webs.T), LEVER * webs.d, _struts(steel, limit_state, webs)
    used = 2 * (webs.V / (webs.b * z) + tau) / concrete.strut
    closed = 2 * tube.wall * tau / bars.f_yd
    links = webs.V / (z * bars.f_yd * struts.cot_theta) + closed
    along = tau * tube.wall * tube.length / bars.f_yd
    links, along = (np.where(struts.fails, np.inf, values) for values in (links, along))
    least = np.full(len(used), shear.minimum_links(concrete, bars) * webs.b)
    return WebNeed(np.maximum(links, least), least, along, np.zeros(len(used)), used, webs.T,
                   np.where(struts.fails, 0.0, closed))  # fmt: skip


def _struts(steel: Reinforcement, limit_state: str, webs: Web) -> Links:
    """Return the struts of shear in webs (k,), as flat as what torsion leaves of the concrete bears (8.3.6)."""
    concrete, bars = materials(steel, limit_state)
    left = 1 - 2 * Tube.of(webs).stress(webs.T) / concrete.strut
    v = np.where(left > 0, webs.V / webs.b / np.maximum(left, NOTHING), np.inf)
    return shear.required_links(v, webs.d, concrete, bars, flattest(steel, concrete))


def web_steps(steel: Reinforcement, limit_state: str, webs: Web) -> Iterator[Step]:
    """Yield the calculation of links and bars along the beam at one web."""
    concrete, bars = materials(steel, limit_state)
    need = web(steel, limit_state, webs)
    yield from force_steps(webs, ("V_Ed", "T_Ed"))
    z = LEVER * float(webs.d[0])
    yield Step("lever arm", "z", z, "m", f"{LEVER:g} * d", "8.2.1(3)")
    yield from shear.design_strength(concrete)
    yield Step("strength of struts", "f_nu", concrete.strut / MEGA, "MPa", f"{concrete.annex.nu:g} * f_cd", "8.2.3(6)")
    tau_V = float(webs.V[0]) / (webs.b * z) / MEGA
    yield Step("shear stress", "tau_Ed", tau_V, "MPa", "V_Ed / (b_w * z)", "8.2.1(3), 8.18")
    both, twisted = "tau_Ed", bool(webs.T[0] > 0)
    if twisted:
        yield from torsion.steps(webs, ("8.3.3", "8.3.3, 8.79"))
        both = "(tau_Ed + tau_t)"
    clause = "8.3.6, 8.86" if twisted else "8.2.3(6), 8.44"
    yield Step("share used, of struts at 45 degrees", "eta", float(need.used[0]), "", f"2 * {both} / f_nu", clause)
    if np.isinf(need.links[0]):
        return
    cot = float(_struts(steel, limit_state, webs).cot_theta[0])
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
    left = concrete.strut - 2 * float(Tube.of(webs).stress(webs.T)[0])
    share, of_shear = 2 * tau_V * MEGA / left, f"2 * tau_Ed / {'(f_nu - 2 * tau_t)' if twisted else 'f_nu'}"
    words = "shear stress over what torsion leaves of struts at 45 degrees"
    yield Step(words, "w", share, "", of_shear, "8.3.6, 8.86" if twisted else "8.2.3(6), 8.44")
    yield Step("largest cot theta", "cot_max", float(flattest(steel, concrete)), clause="8.2.3(4)")
    yield flattest_step(cot, ("w", share), "8.2.3(4)")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="5.2.4")
    least = float(need.least_links[0]) * CM2
    yield Step("least links", "a_sw,min", least, "cm2/m", "0.08 * sqrt(f_ck) / f_yk * b_w * 10000", "12.2(4), 12.4")
    both = "V_Ed / (z * cot) + T_Ed / A_k" if twisted else "V_Ed / (z * cot)"
    formula = f"max(({both}) / f_ywd * 10000, a_sw,min)"
    clause = "8.2.3, 8.42" + ("; 8.3.4, 8.82" if twisted else "")
    yield Step(ALL_LEGS, "a_sw", float(need.links[0]) * CM2, "cm2/m", formula, clause)
    if twisted:
        formula = "T_Ed * u_k / (2 * A_k * f_ywd) * 10000"
        along = float(need.along[0]) * CM2
        yield Step("bars along the beam for torsion", "A_sl", along, "cm2", formula, "8.3.4, 8.83")
