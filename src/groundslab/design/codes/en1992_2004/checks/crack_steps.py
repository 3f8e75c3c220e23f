"""The width of a crack, and least bars, by EN 1992-1-1 7.3, step by step, as they can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.cracking import FORMULAS, K_1, K_2, LONG_TERM
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.design.rules.calculation import MEGA, Step


def stress(m: float, h: float, bars: Bars, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the stress of bars under a moment m [N m/m] at a place of thickness h [m], of a section that is cracked."""
    area, phi, spacing, c = (
        float(np.asarray(figure)) for figure in (bars.area, bars.diameter, bars.spacing, bars.cover)
    )
    d, alpha_e = h - c - phi / 2, steel.E_s / concrete.E_cm
    x = float(cracking.neutral_axis(np.array([d]), np.array([area]), alpha_e)[0])
    sigma_s = float(cracking.bar_stress(np.array([m]), np.array([h]), bars, concrete, steel)[0])
    yield Step("design moment per width, by Wood", "m", m / MEGA, "MNm/m")
    yield Step("thickness", "h", h, "m")
    yield Step("diameter of the bars", "phi", phi, "m", clause="7.3.4(3)")
    yield Step("spacing of the bars", "s", spacing, "m")
    yield Step("cover of the bars", "c", c, "m")
    yield Step("their area per width", "A_s", area, "m2/m")
    yield Step("effective depth", "d", d, "m", "h - c - phi / 2")
    yield Step("modulus of the steel", "E_s", steel.E_s / MEGA, "MPa", clause="3.2.7(4)")
    yield Step("modulus of the concrete", "E_cm", concrete.E_cm / MEGA, "MPa", clause="Table 3.1")
    yield Step("ratio of moduli", "alpha_e", alpha_e, "", "E_s / E_cm", "7.3.4(2)")
    yield Step("depth of the neutral axis, cracked", "x", x, "m", FORMULAS["x"])
    yield Step("stress of the bars, cracked", "sigma_s", sigma_s / MEGA, "MPa", FORMULAS["sigma_s"], "7.3.4(2)")


def steps(m: float, h: float, bars: Bars, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the calculation of a crack for a moment m [N m/m] at a place of thickness h [m], with the bars there."""
    yield from stress(m, h, bars, concrete, steel)
    area, phi, c = (float(np.asarray(figure)) for figure in (bars.area, bars.diameter, bars.cover))
    d, at = h - c - phi / 2, np.array([h])
    x = cracking.neutral_axis(np.array([d]), np.array([area]), steel.E_s / concrete.E_cm)
    sigma_s = cracking.bar_stress(np.array([m]), at, bars, concrete, steel)
    rho = cracking.effective_ratio(at, np.array([d]), x, np.array([area]), concrete.annex)
    k_h, formula = concrete.annex.tension_depth[0], FORMULAS["rho"]
    if k_h:
        yield from _effective_depth(h, h - d, k_h)
        formula = FORMULAS["rho h_c,ef"]
    yield Step("ratio of bars to the area in tension", "rho", float(rho[0]), "", formula, "7.3.2(3), 7.3.4(2)")
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")
    yield Step("factor of loads that last", "k_t", LONG_TERM, clause="7.3.4(2)")
    eps = float(cracking.mean_strain(sigma_s, rho, concrete, steel)[0])
    yield Step("mean strain of bars less that of the concrete", "eps", eps, "", FORMULAS["eps"], "7.3.4(2), 7.9")
    s_r = float(cracking.largest_spacing(bars, at, x, rho, concrete.annex)[0])
    yield from _distance(bars, s_r, concrete, K_2)
    if concrete.annex.crack_spacing_by_stress:
        s_r = min(s_r, float(cracking.spacing_by_stress(sigma_s, bars, concrete)[0]))
        yield Step("at most by the stress", "s_r", s_r, "m", FORMULAS["s_r by stress"], "7.3.4(3) of the annex")
    width = float(cracking.crack_width(np.array([m]), at, bars, concrete, steel)[0])
    yield Step("width of cracks", "w_k", width * 1e3, "mm", FORMULAS["w_k"], "7.3.4(1), 7.8")


def _effective_depth(h: float, axis: float, k_h: float) -> Iterator[Step]:
    """Yield the depth of concrete in tension around bars whose axes lie so far [m] from the face, by the annex."""
    yield Step("factor of the thickness, by the annex", "k_h", k_h, clause="7.3.2(3) of the annex")
    depth = float(cracking.effective_depth(np.array(h), axis, k_h))
    yield Step("effective depth in tension", "h_c,ef", depth, "m", FORMULAS["h_c,ef"], "7.3.2(3) of the annex")


def _distance(bars: Bars, s_r: float, concrete: Concrete, k_2: float) -> Iterator[Step]:
    """Yield the largest distance of cracks s_r [m], k_2 being that of bending or of tension."""
    if np.asarray(bars.spacing) > 5 * (bars.cover + bars.diameter / 2):
        yield Step("largest distance of cracks", "s_r", s_r, "m", FORMULAS["s_r far"], "7.3.4(3), 7.14")
        return
    yield Step("factor of bond", "k_1", K_1, clause="7.3.4(3)")
    yield Step("factor of bending" if k_2 == K_2 else "factor of tension", "k_2", k_2, clause="7.3.4(3)")
    k_3 = float(cracking.cover_factor(concrete.annex, bars.cover))
    yield Step("factor of the cover, by the annex", "k_3", k_3, clause="7.3.4(3)")
    yield Step("factor of the bars, by the annex", "k_4", concrete.annex.k_4, clause="7.3.4(3)")
    yield Step("largest distance of cracks", "s_r", s_r, "m", FORMULAS["s_r near"], "7.3.4(3), 7.11")


def least_in_bending(h: float, area: float, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the least bars as a slab h [m] thick first cracks in bending, against an area [m2/m]."""
    yield from _depth_factor(h)
    yield Step("tensile strength as it cracks", "f_ct", concrete.f_ct_least / MEGA, "MPa", clause="7.3.2(2), Table 3.1")
    yield Step("yield strength", "f_yk", steel.f_yk / MEGA, "MPa", clause="3.2.2(3)")
    least = float(cracking.minimum_area(np.array(h), concrete, steel.f_yk)) * 1e4
    yield from _least(least, area, FORMULAS["A_min bending"])


def least_in_tension(h: float, bars: Bars, steel: Steel, f_ct: float) -> Iterator[Step]:
    """Yield the least bars at one face as a slab h [m] thick cracks all through, f_ct [Pa] being its strength."""
    yield from _depth_factor(h)
    yield Step("tensile strength as it cracks", "f_ct", f_ct / MEGA, "MPa", clause="7.3.2(2)")
    yield Step("yield strength", "f_yk", steel.f_yk / MEGA, "MPa", clause="3.2.2(3)")
    least = float(cracking.tension_force(np.array(h), f_ct)) / steel.f_yk * 1e4
    yield from _least(least, float(bars.area), FORMULAS["A_min tension"])


def in_tension(h: float, bars: Bars, concrete: Concrete, steel: Steel, f_ct: float) -> Iterator[Step]:
    """Yield the width of cracks of a slab h [m] thick that is cracked all through, f_ct [Pa] being its strength."""
    at, area = np.array(h), float(bars.area)
    sigma_s, rho = cracking.tension_force(at, f_ct) / area, cracking.tension_ratio(at, bars, concrete.annex)
    yield from _depth_factor(h)
    yield Step("tensile strength as it cracks", "f_ct", f_ct / MEGA, "MPa", clause="7.3.2(2)")
    yield Step("diameter of the bars", "phi", float(bars.diameter), "m", clause="7.3.4(3)")
    yield Step("cover of the bars", "c", float(bars.cover), "m")
    yield Step("their area per width at one face", "A_s", area, "m2/m")
    yield Step("distance of their axis from the other face", "d", h - float(bars.cover + bars.diameter / 2), "m",
               "h - c - phi / 2")  # fmt: skip
    yield Step("depth that is compressed", "x", 0.0, "m")
    yield Step("stress of the bars", "sigma_s", float(sigma_s) / MEGA, "MPa", FORMULAS["sigma_s tension"], "7.3.2(2)")
    k_h, formula = concrete.annex.tension_depth[1], FORMULAS["rho tension"]
    if k_h:
        yield from _effective_depth(h, float(bars.cover + bars.diameter / 2), k_h)
        formula = FORMULAS["rho_t h_c,ef"]
    yield Step("ratio of bars to the area in tension", "rho", float(rho), "", formula, "7.3.2(3)")
    yield Step("modulus of the steel", "E_s", steel.E_s / MEGA, "MPa", clause="3.2.7(4)")
    yield Step("modulus of the concrete", "E_cm", concrete.E_cm / MEGA, "MPa", clause="Table 3.1")
    yield Step("factor of loads that last", "k_t", LONG_TERM, clause="7.3.4(2)")
    eps = float(cracking.mean_strain(sigma_s, rho, concrete, steel, LONG_TERM, f_ct))
    formula = FORMULAS["eps tension"]
    yield Step("mean strain of bars less that of the concrete", "eps", eps, "", formula, "7.3.4(2), 7.9")
    k_2 = cracking.tension_k_2(concrete.annex)
    s_r = float(cracking.largest_spacing(bars, at, np.array(0.0), rho, concrete.annex, k_2))
    yield from _distance(bars, s_r, concrete, k_2)
    if concrete.annex.crack_spacing_by_stress:
        s_r = float(cracking.tension_spacing(at, bars, sigma_s, concrete, f_ct))
        formula = FORMULAS["s_r by stress, tension"]
        yield Step("at most by the stress", "s_r", s_r, "m", formula, "7.3.4(3) of the annex")
    width = float(cracking.tension_crack_width(at, bars, concrete, steel, f_ct))
    yield Step("width of cracks", "w_k", width * 1e3, "mm", FORMULAS["w_k"], "7.3.4(1), 7.8")


def _depth_factor(h: float) -> Iterator[Step]:
    """Yield the thickness [m] and k."""
    yield Step("thickness", "h", h, "m")
    yield Step("factor of stresses that balance each other", "k", float(cracking.depth_factor(np.array(h))), "",
               FORMULAS["k"], "7.3.2(2)")  # fmt: skip


def _least(least: float, area: float, formula: str) -> Iterator[Step]:
    """Yield least bars [cm2/m] and the bars that are laid, an area [m2/m]."""
    yield Step("least area at one face", "A_min", least, "cm2/m", formula, "7.3.2(2), 7.1")
    yield Step("area of the bars that are laid", "A_s", area * 1e4, "cm2/m")
    yield Step("share used", "eta", least / (area * 1e4), "", "A_min / A_s", "7.3.2(2)")
