"""The width of a crack and least bars by EN 1992-1-1:2023 9.2, step by step, as they can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.codes.en1992_2023 import cracking
from groundslab.design.codes.en1992_2023.cracking import FORMULAS, LONG_TERM
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import Bars, neutral_axis
from groundslab.design.rules.calculation import MEGA, Step


def stress(m: float, h: float, bars: Bars, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the stress of bars under a moment m [N m/m] at a place of thickness h [m], of a section that is cracked."""
    area, phi, spacing, c = (
        float(np.asarray(figure)) for figure in (bars.area, bars.diameter, bars.spacing, bars.cover)
    )
    d, at = h - c - phi / 2, np.array([h])
    alpha_e = steel.E_s / concrete.E_cm
    x = neutral_axis(np.array([d]), np.array([area]), alpha_e)
    sigma_s = cracking.bar_stress(np.array([m]), at, bars, concrete, steel)
    yield Step("design moment per width, by Wood", "m", m / MEGA, "MNm/m")
    yield Step("thickness", "h", h, "m")
    yield Step("diameter of the bars", "phi", phi, "m")
    yield Step("spacing of the bars", "s", spacing, "m")
    yield Step("cover of the bars", "c", c, "m")
    yield Step("their area per width", "A_s", area, "m2/m")
    yield Step("distance of their axis from the face", "a_y", c + phi / 2, "m", "c + phi / 2", "9.2.3(2)")
    yield Step("effective depth", "d", d, "m", "h - a_y")
    yield Step("modulus of the steel", "E_s", steel.E_s / MEGA, "MPa", clause="5.2.4(3)")
    yield Step("modulus of the concrete", "E_cm", concrete.E_cm / MEGA, "MPa", clause="5.1.4(2), 5.1")
    yield Step("ratio of moduli", "alpha_e", alpha_e, "", "E_s / E_cm")
    yield Step("depth of the neutral axis, cracked", "x", float(x[0]), "m", FORMULAS["x"])
    yield Step("stress of the bars, cracked", "sigma_s", float(sigma_s[0]) / MEGA, "MPa", FORMULAS["sigma_s"])


def steps(m: float, h: float, bars: Bars, constants: tuple[Concrete, Steel, float]) -> Iterator[Step]:
    """Yield the calculation for a moment m [N m/m] at a place of thickness h [m], with the bars there and k_b."""
    concrete, steel, k_b = constants
    yield from stress(m, h, bars, concrete, steel)
    at = np.array([h])
    x = neutral_axis(at - cracking.axis(bars), np.asarray(bars.area), steel.E_s / concrete.E_cm)
    sigma_s = cracking.bar_stress(np.array([m]), at, bars, concrete, steel)
    h_c = cracking.effective_depth(at, x, bars)
    rho = cracking.effective_ratio(h_c, bars)
    yield Step("depth of the concrete in tension", "h_c", float(h_c[0]), "m", FORMULAS["h_c"], "Figure 9.3")
    yield Step("ratio of bars to it", "rho", float(rho[0]), "", FORMULAS["rho"], "Figure 9.3")
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 5.1")
    yield Step("factor of loads that last", "k_t", LONG_TERM, clause="9.2.3(3)")
    eps = float(cracking.mean_strain(sigma_s, rho, concrete, steel)[0])
    yield Step("mean strain of bars less that of the concrete", "eps", eps, "", FORMULAS["eps"], "9.2.3(3), 9.11")
    k_fl, k_w = (at - h_c) / h, concrete.annex.k_w
    yield Step("factor of the stresses before cracking", "k_fl", float(k_fl[0]), "", FORMULAS["k_fl"], "9.16")
    yield Step("factor of bond", "k_b", k_b, clause="9.18")
    yield Step("from the mean to the calculated width", "k_w", k_w, clause="9.2.3(2)")
    s_r = float(cracking.mean_spacing(bars, at, x, rho, k_fl, (k_b, k_w))[0])
    yield Step("mean distance of cracks", "s_r", s_r, "m", FORMULAS["s_r"], "9.2.3(4), 9.15")
    k_r = float(cracking.curvature_factor(at, x, bars)[0])
    yield Step("factor of curvature", "k_r", k_r, "", FORMULAS["k_r"], "9.2.3(2), 9.9")
    width = float(cracking.crack_width(np.array([m]), at, bars, concrete, steel, k_b)[0])
    yield Step("width of cracks", "w_k,cal", width * 1e3, "mm", FORMULAS["w_k,cal"], "9.2.3(2), 9.8")


def least_bars(h: float, area: float, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the least bars as a slab h [m] thick first cracks in bending, against an area [m2/m]."""
    least = float(cracking.minimum_area(np.array(h), concrete, steel.f_yk)) * 1e4
    yield Step("thickness", "h", h, "m")
    yield Step("factor of the thickness", "k_h", float(cracking.thickness_factor(np.array(h))), "",
               FORMULAS["k_h"], "9.5")  # fmt: skip
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 5.1")
    yield Step("yield strength", "f_yk", steel.f_yk / MEGA, "MPa", clause="5.2.4")
    yield Step("least area at one face", "A_min", least, "cm2/m", FORMULAS["A_min"], "9.2.2, 9.2")
    yield Step("area of the bars that are laid", "A_s", area * 1e4, "cm2/m")
    yield Step("share used", "eta", least / (area * 1e4), "", "A_min / A_s", "9.2.2")
