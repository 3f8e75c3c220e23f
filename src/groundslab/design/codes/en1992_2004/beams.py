"""Beams by EN 1992-1-1 beyond what they share with slabs: least bars (9.2.1.1(1)), links, torsion, flanges.

Links carry shear (6.2.3) and the walls of a tube torsion (6.3.2), with struts of one inclination, of which both use up

    T_Ed / T_Rd,max + V_Ed / V_Rd,max <= 1,  T_Rd,max = 2 nu f_cd A_k t_ef / (cot theta + tan theta)      6.29, 6.30
    A_sw / s = (V_Ed / z + T_Ed / A_k) / (f_ywd cot theta)                     6.8, 6.3.2(2), all legs of closed links
    A_sl = T_Ed u_k cot theta / (2 A_k f_yd)                                                               6.28

That small forces need the least links alone (formula 6.31) is not made use of. With cracks that friction bears (in
Germany) the flattest struts are those under the stresses of both.

Between a web and its flange of thickness h_f (6.2.4), for one of both sides:

    v_Ed = Delta F_d / (h_f Delta x)                                        6.20
    A_sf / s_f = v_Ed h_f / (f_yd cot theta_f)                              6.21
    v_Ed <= nu f_cd sin theta_f cos theta_f                                 6.22

No bars are needed for it up to 0.4 f_ctd (6.2.4(6)), f_ctd with the least alpha_ct of annexes, 0.85. cot theta_f is at
most 1.2 in compressed flanges and 1.0 in those in tension, which is within what 6.2.4(4) and its annexes allow.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.codes.en1992_2004 import bending, cracking, shear
from groundslab.design.codes.en1992_2004.materials import Concrete
from groundslab.design.codes.en1992_2004.materials_of_case import largest_cover, materials, widest_crack
from groundslab.design.codes.eurocode2 import torsion
from groundslab.design.codes.eurocode2.struts import LEVER, Links, flattest_step, links_by_struts
from groundslab.design.codes.eurocode2.torsion import Tube
from groundslab.design.rules.bending_steps import CM2
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import ALL_LEGS, Flange, Web, WebNeed, force_steps
from groundslab.model.design.reinforcement import Reinforcement

#: The largest cot theta_f of compressed flanges, and of those in tension (6.2.4(4)).
FLATTEST_IN_FLANGES = (1.2, 1.0)
#: Up to this share of f_ctd the shear in flanges needs no bars (6.2.4(6)), f_ctd = ALPHA_CT 0.7 f_ctm / gamma_C.
BORNE_BY_CONCRETE, ALPHA_CT = 0.4, 0.85


def minimum(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2]: of the mean width of the zone in tension, or, where the annex says so, those
    that yield, with the lever arm 0.9 d, under the moment at which the section cracks. Where a crack width is asked
    for, also those that keep first cracks in its web or flange to it (7.3.2(2)).
    """
    return np.asarray(np.maximum(_of_strength(steel, limit_state, zone), _FirstCrack.of(steel, zone).area))


def _of_strength(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2] without those for cracks."""
    concrete, bars = materials(steel, limit_state)
    if concrete.annex.minimum_by_cracking:
        return np.asarray(concrete.f_ctm * zone.modulus / (LEVER * zone.d * bars.f_yk))
    return np.asarray(bending.minimum(zone.d, concrete=concrete, steel=bars) * zone.mean_width)


class _FirstCrack(NamedTuple):
    """The part of a section, web or flange, at the face in tension as it first cracks (k,), 7.3.2(2)."""

    k_c: Array
    k: Array
    A_ct: Array  # [m2]
    phi: Array  # phi_s* of the bars by 7.6N, or where the annex has no table that of themselves [m]
    sigma_s: Array  # [Pa]; infinite where no crack width is asked for
    area: Array  # [m2]

    @classmethod
    def of(cls, steel: Reinforcement, zone: TensionZone) -> _FirstCrack:
        """Return it of zones in tension."""
        (concrete, bars), w_max, y = materials(steel), widest_crack(steel), zone.depth
        if zone.face > zone.web:
            high = np.minimum(zone.flange, y)
            # F_cr = f_ct A_ct (1 - high / 2 y), as stresses are linear
            k_c, A_ct = np.maximum(0.9 * (1 - high / (2 * y)), 0.5), zone.face * high  # 7.3
            k = np.full(len(y), float(cracking.depth_factor(np.array(zone.face))))
        else:
            k_c, k, A_ct = np.full(len(y), 0.4), cracking.depth_factor(zone.h), zone.web * y  # 7.2
        f_ct, phi = concrete.f_ct_least, np.full(len(y), zone.diameter)
        if not concrete.annex.crack_spacing_by_stress:
            phi = phi * cracking.OF_TABLE / f_ct * 2 * (zone.h - zone.d) / (k_c * y)  # 7.6N
        sigma_s = np.full(len(y), np.inf)
        if w_max is not None:
            sigma_s = cracking.allowed_stress(w_max, phi, f_ct, bars, concrete.annex)
        return cls(k_c, k, A_ct, phi, sigma_s, k_c * k * f_ct * A_ct / sigma_s)  # 7.1


def cracks(steel: Reinforcement) -> str:
    """Return what of the cracks of beams is not designed."""
    if widest_crack(steel) is None:
        return ""
    return (
        "least bars of beams keep their first cracks to the limit; crack widths under loads, and bars at the sides of "
        "webs (7.3.3(3)), are not checked"
    )


def minimum_steps(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Iterator[Step]:
    """Yield the calculation of the least bars at one place."""
    concrete = materials(steel, limit_state)[0]
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")
    if concrete.annex.minimum_by_cracking:
        yield Step("section modulus of the face in tension", "W", float(zone.modulus[0]), "m3")
        formula = f"f_ctm * W / ({LEVER:g} * d * f_yk) * 10000"
    else:
        yield Step("mean width of the zone in tension", "b_t", float(zone.mean_width[0]), "m", clause="9.2.1.1(1)")
        formula = "max({:g} * f_ctm / f_yk, {:g}) * b_t * d * 10000".format(*concrete.annex.minimum)
    strength = float(_of_strength(steel, limit_state, zone)[0]) * CM2
    if widest_crack(steel) is None:
        yield Step("least bars", "A_min", strength, "cm2", formula, "9.2.1.1(1)")
        return
    yield Step("least bars that bear what cracks", "A_0", strength, "cm2", formula, "9.2.1.1(1)")
    yield from _crack_steps(steel, zone)
    least = float(minimum(steel, limit_state, zone)[0]) * CM2
    yield Step("least bars", "A_min", least, "cm2", "max(A_0, A_cr)", "7.3.2(2), 9.2.1.1(1)")


def _crack_steps(steel: Reinforcement, zone: TensionZone) -> Iterator[Step]:
    """Yield the calculation of the least bars for a limit of cracks at one place."""
    (concrete, bars), w_max, first = materials(steel), widest_crack(steel), _FirstCrack.of(steel, zone)
    assert w_max is not None
    k_c, k, A_ct, phi, sigma_s, area = (float(values[0]) for values in first)
    f_ct, flange = concrete.f_ct_least / MEGA, zone.face > zone.web
    yield Step("width of cracks that is allowed", "w_max", w_max * 1e3, "mm", clause="7.3.1(5)")
    yield Step("largest diameter of the bars", "phi", zone.diameter, "m")
    yield Step("tensile strength as it cracks", "f_ct", f_ct, "MPa", clause="7.3.2(2), Table 3.1")
    yield Step("depth in tension before it cracks", "h_cr", float(zone.depth[0]), "m")
    if flange:
        yield Step("thickness of the flange in tension", "h_f", A_ct / zone.face, "m")
        yield Step("factor of flanges", "k_c", k_c, "", "max(0.9 * (1 - h_f / (2 * h_cr)), 0.5)", "7.3.2(2), 7.3")
    else:
        yield Step("factor of webs in bending", "k_c", k_c, "", clause="7.3.2(2), 7.2")
    yield Step("factor of stresses that balance each other", "k", k, "", clause="7.3.2(2)")
    yield Step("area of flange or web in tension", "A_ct", A_ct, "m2", clause="7.3.2(2)")
    if concrete.annex.crack_spacing_by_stress:
        yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="3.2.2(3)")
        yield Step("modulus of the bars", "E_s", bars.E_s / MEGA, "MPa", clause="3.2.7(4)")
        formula = "min(sqrt(6 * w_max / 1000 * f_ct * E_s / phi), f_yk)"
        yield Step("stress of bars that is allowed", "sigma_s", sigma_s / MEGA, "MPa", formula, "7.3.4, 7.8, 7.9")
    else:
        axis = float((zone.h - zone.d)[0])
        yield Step("distance of the bars' axis from the face", "a_1", axis, "m")
        formula = f"phi * {cracking.OF_TABLE / MEGA:g} / f_ct * 2 * a_1 / (k_c * h_cr)"
        yield Step("diameter for the table", "phi_s", phi, "m", formula, "7.3.3(2), 7.6N")
        yield Step("stress of bars that is allowed", "sigma_s", sigma_s / MEGA, "MPa", clause="Table 7.2N")
    formula = "k_c * k * f_ct * A_ct / sigma_s * 10000"
    yield Step("least bars that control cracks", "A_cr", area * CM2, "cm2", formula, "7.3.2(2), 7.1")


def flange_steps(steel: Reinforcement, limit_state: str, flange: Flange) -> Iterator[Step]:
    """Yield the calculation from the stress between web and flange to the bars across at one place."""
    concrete, bars = materials(steel, limit_state)
    limit, stress = flange_limit(steel, limit_state), float(flange.stress[0])
    yield from shear.concrete_steps(concrete)
    yield from shear.strut_steps(concrete, "f_nu", "6.2.2(6)")
    yield Step("share used, of struts at 45 degrees", "eta", stress / limit, "", "2 * tau / f_nu", "6.2.4(4), 6.22")
    borne = BORNE_BY_CONCRETE * ALPHA_CT * 0.7 * concrete.f_ctm / concrete.gamma_c
    yield from shear.strength_steps(concrete, bars)
    if not concrete.annex.beam_links[1]:
        yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")
    formula = f"{BORNE_BY_CONCRETE:g} * {ALPHA_CT:g} * 0.7 * f_ctm / gamma_C"
    yield Step("stress that needs no bars", "tau_0", borne / MEGA, "MPa", formula, "6.2.4(6)")
    area = float(flange_bars(steel, limit_state, flange.stress, flange.compressed)[0] * flange.h[0]) * CM2
    if np.isinf(area) or stress <= borne:
        return
    cot = FLATTEST_IN_FLANGES[0] if flange.compressed[0] else FLATTEST_IN_FLANGES[1]
    by_struts = links_by_struts(flange.stress, np.ones(1), concrete.strut, bars.f_yd, cot)
    compressed, pulled = "largest cot theta of compressed flanges", "largest cot theta of flanges in tension"
    yield Step(compressed if flange.compressed[0] else pulled, "cot_max", cot, clause="6.2.4(4)")
    yield flattest_step(float(by_struts.cot_theta[0]), ("eta", stress / limit), "6.2.4(4), 6.22")
    yield Step("strength of bars", "f_yd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
    least = shear.minimum_beam_links(concrete, bars)
    yield Step("least ratio of bars", "rho_min", least, "", shear.least_links_formula(concrete), "9.2.2(5)")
    formula = "max(tau / (f_yd * cot), rho_min) * h_f * 10000"
    yield Step("bars across the rib, both faces together", "a_sf", area, "cm2/m", formula, "6.2.4(4), 6.21")


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


def web(steel: Reinforcement, limit_state: str, webs: Web) -> WebNeed:
    """Return the links and the bars along the beam that webs (k,) need."""
    concrete, bars = materials(steel, limit_state)
    tube, z = Tube.of(webs), shear.lever(concrete, webs.d, largest_cover(steel))
    tau, v, struts = tube.stress(webs.T), _shear_of_both(steel, concrete, webs), _struts(steel, limit_state, webs)
    closed = np.where(struts.fails, 0.0, 2 * tube.wall * tau / (bars.f_yd * struts.cot_theta))
    links = np.where(struts.fails, np.inf, webs.V / z / (bars.f_yd * struts.cot_theta) + closed)
    along = np.where(struts.fails, np.inf, tau * tube.wall * tube.length * struts.cot_theta / bars.f_yd)
    least = np.full(len(v), shear.minimum_beam_links(concrete, bars) * webs.b)
    used = 2 * v / (z * concrete.strut)
    return WebNeed(np.maximum(links, least), least, along, np.zeros(len(v)), used, webs.T, closed)


def link_distances(steel: Reinforcement, limit_state: str, webs: Web, used: Array) -> tuple[Array, Array]:
    """Return how far links, and legs across, may be from each other (k,) [m]: 9.2.2(6), 9.2.2(8), 9.2.3(3).

    By the share (k,) that is used of what struts bear.
    """
    annex = materials(steel, limit_state)[0].annex
    depth = webs.h if annex.link_distances_by_height else webs.d
    up_to = np.array([row[0] for row in annex.link_distances])
    row = np.searchsorted(up_to, np.minimum(used, up_to[-1]))
    along, across = (
        np.minimum(rows[row, 1] * depth, rows[row, 2])
        for rows in (np.array(annex.link_distances), np.array(annex.leg_distances))
    )
    of_torsion = np.minimum((webs.b + webs.h) / 4, np.minimum(webs.b, webs.h))
    return np.where(webs.T > 0, np.minimum(along, of_torsion), along), across


def distance_steps(steel: Reinforcement, limit_state: str, webs: Web, strained: Web) -> tuple[list[Step], list[Step]]:
    """Return the calculations of how far links, and legs across, may be from each other in one web."""
    annex, need = materials(steel, limit_state)[0].annex, web(steel, limit_state, strained)
    along, across = link_distances(steel, limit_state, webs, need.used)
    used, up_to = [], [row[0] for row in annex.link_distances]
    if len(up_to) > 1:
        steps = [*web_steps(steel, limit_state, strained)]
        used = steps[: 1 + next(n for n, step in enumerate(steps) if step.symbol == "eta")]
    symbol, depth = ("h", webs.h) if annex.link_distances_by_height else ("d", webs.d)
    given = [Step("height with the flange" if symbol == "h" else "effective depth", symbol, float(depth[0]), "m")]
    given = [] if any(step.symbol == symbol for step in used) else given
    row = min(int(np.searchsorted(up_to, float(need.used[0]))), len(up_to) - 1)

    def least(rows: Sequence[tuple[float, float, float]], *others: str) -> str:
        _, share, most = rows[row]
        terms = [f"{share:g} * {symbol}", *([f"{most:g}"] if np.isfinite(most) else []), *others]
        return terms[0] if len(terms) == 1 else f"min({', '.join(terms)})"

    twisted = bool(webs.T[0] > 0)
    sizes = [
        Step("width of the web", "b_w", webs.b, "m"),
        Step("height with the flange", "h", float(webs.h[0]), "m"),
    ] if twisted else []  # fmt: skip
    sizes = [step for step in sizes if all(step.symbol != other.symbol for other in (*used, *given))]
    of_torsion = ("(b_w + h) / 4", "b_w", "h") if twisted else ()
    words = "largest distance of links" if len(up_to) == 1 else "largest distance of links, by the share used"
    of_legs = "largest distance of legs" if len(up_to) == 1 else "largest distance of legs, by the share used"
    clause = "9.2.2(6), 9.2.3(3)" if twisted else "9.2.2(6)"
    most = Step(words, "s_max", float(along[0]), "m", least(annex.link_distances, *of_torsion), clause)
    of_leg = Step(of_legs, "s_t,max", float(across[0]), "m", least(annex.leg_distances), "9.2.2(8)")
    return [*used, *given, *sizes, most], [*used, *given, of_leg]


def _shear_of_both(steel: Reinforcement, concrete: Concrete, webs: Web) -> Array:
    """Return the shear forces per width (k,) [N/m] that ask of struts what shear and torsion do, formula 6.29."""
    z = shear.lever(concrete, webs.d, largest_cover(steel))
    return np.asarray(webs.V / webs.b + Tube.of(webs).stress(webs.T) * z / concrete.annex.torsion_struts)


def _struts(steel: Reinforcement, limit_state: str, webs: Web) -> Links:
    """Return the struts of webs (k,), of one inclination for shear and torsion."""
    concrete, bars = materials(steel, limit_state)
    v = _shear_of_both(steel, concrete, webs)
    return shear.required_links(v, webs.d, concrete, bars, largest_cover(steel))


def web_steps(steel: Reinforcement, limit_state: str, webs: Web) -> Iterator[Step]:
    """Yield the calculation of links and bars along the beam at one web."""
    concrete, bars = materials(steel, limit_state)
    cover, need = largest_cover(steel), web(steel, limit_state, webs)
    yield from force_steps(webs, ("V_Ed", "T_Ed"))
    z, formula = float(shear.lever(concrete, webs.d, cover)[0]), f"{LEVER:g} * d"
    if concrete.annex.lever_by_cover:
        yield Step("largest cover of longitudinal bars", "c", cover, "m", clause="6.2.3(1) of the annex")
        formula = f"min({formula}, max(d - 2 * c, d - c - {shear.COVER_LESS:g}))"
    yield Step("lever arm", "z", z, "m", formula, "6.2.3(1)")
    yield from shear.concrete_steps(concrete)
    yield from shear.strut_steps(concrete, "f_nu", "6.2.2(6), 6.2.3(3)")
    most = "most that struts bear, at 45 degrees"
    V_max = webs.b * z * concrete.strut / 2 / MEGA
    yield Step(most, "V_Rd,max", V_max, "MN", "b_w * z * f_nu / 2", "6.2.3(3), 6.9")
    used, twisted = "V_Ed / V_Rd,max", bool(webs.T[0] > 0)
    if twisted:
        share, tube = concrete.annex.torsion_struts, Tube.of(webs)
        yield from torsion.steps(webs, ("6.3.2(1)", "6.3.2(1), 6.26"))
        T_max = share * concrete.strut * float(tube.area[0] * tube.wall[0]) / MEGA
        of_nu = "" if share == 1 else f"{share:g} * "
        yield Step(most, "T_Rd,max", T_max, "MNm", f"{of_nu}f_nu * A_k * t_ef", "6.3.2(4), 6.30")
        used = f"T_Ed / T_Rd,max + {used}"
    yield Step("share used", "eta", float(need.used[0]), "", used, "6.3.2(4), 6.29" if twisted else "6.2.3(3)")
    if np.isinf(need.links[0]):
        return
    cot = float(_struts(steel, limit_state, webs).cot_theta[0])
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
    of_both = float(_shear_of_both(steel, concrete, webs)[0])
    yield from shear.flattest_steps(concrete, of_both, z, "(eta * z * f_nu / 2)")
    yield flattest_step(cot, ("eta", float(need.used[0])), "6.2.3(2), 6.3.2(2)")
    least, ratio = float(need.least_links[0]) * CM2, shear.least_links_formula(concrete)
    yield from shear.strength_steps(concrete, bars)
    yield Step("least links", "a_sw,min", least, "cm2/m", f"{ratio} * b_w * 10000" if ratio else "", "9.2.2(5)")
    both = "(V_Ed / z + T_Ed / A_k)" if twisted else "V_Ed / z"
    formula = f"max({both} / (f_ywd * cot) * 10000, a_sw,min)"
    clause = "6.2.3(3), 6.8" + ("; 6.3.2(2)" if twisted else "")
    yield Step(ALL_LEGS, "a_sw", float(need.links[0]) * CM2, "cm2/m", formula, clause)
    if twisted:
        along, formula = float(need.along[0]) * CM2, "T_Ed * u_k * cot / (2 * A_k * f_ywd) * 10000"
        yield Step("bars along the beam for torsion", "A_sl", along, "cm2", formula, "6.3.2(3), 6.28")
