"""The width of a crack by EN 1992-1-1 7.3.4, step by step, as it can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.basis.calculation import MEGA, Step
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.cracking import FORMULAS, K_1, K_2, LONG_TERM, Bars
from groundslab.design.en1992.materials import Concrete, Steel


def steps(m: float, h: float, bars: Bars, concrete: Concrete, steel: Steel) -> Iterator[Step]:
    """Yield the calculation for a moment m [N m/m] at a place of thickness h [m], with the bars there."""
    area, phi, spacing, c = (float(np.asarray(each)) for each in (bars.area, bars.diameter, bars.spacing, bars.cover))
    d, at = h - c - phi / 2, np.array([h])
    alpha_e = steel.E_s / concrete.E_cm
    x = cracking.neutral_axis(np.array([d]), np.array([area]), alpha_e)
    sigma_s = cracking.steel_stress(np.array([m]), np.array([d]), np.array([area]), alpha_e)
    rho = cracking.effective_ratio(at, np.array([d]), x, np.array([area]))
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
    yield Step("depth of the neutral axis, cracked", "x", float(x[0]), "m", FORMULAS["x"])
    yield Step(
        "stress of the bars, cracked", "sigma_s", float(sigma_s[0]) / MEGA, "MPa", FORMULAS["sigma_s"], "7.3.4(2)"
    )
    yield Step("ratio of bars to the area in tension", "rho", float(rho[0]), "", FORMULAS["rho"], "7.3.2(3), 7.3.4(2)")
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")
    yield Step("factor of loads that last", "k_t", LONG_TERM, clause="7.3.4(2)")
    eps = float(cracking.mean_strain(sigma_s, rho, concrete, steel)[0])
    yield Step("mean strain of bars less that of the concrete", "eps", eps, "", FORMULAS["eps"], "7.3.4(2), 7.9")
    s_r = float(cracking.largest_spacing(bars, at, x, rho, concrete.annex)[0])
    if spacing > 5 * (c + phi / 2):
        yield Step("largest distance of cracks", "s_r", s_r, "m", FORMULAS["s_r far"], "7.3.4(3), 7.14")
    else:
        yield Step("factor of bond", "k_1", K_1, clause="7.3.4(3)")
        yield Step("factor of bending", "k_2", K_2, clause="7.3.4(3)")
        yield Step("factor of the cover, by the annex", "k_3", concrete.annex.k_3, clause="7.3.4(3)")
        yield Step("factor of the bars, by the annex", "k_4", concrete.annex.k_4, clause="7.3.4(3)")
        yield Step("largest distance of cracks", "s_r", s_r, "m", FORMULAS["s_r near"], "7.3.4(3), 7.11")
    if concrete.annex.crack_spacing_by_stress:
        s_r = min(s_r, float(cracking.spacing_by_stress(sigma_s, bars, concrete)[0]))
        yield Step("at most by the stress", "s_r", s_r, "m", FORMULAS["s_r by stress"], "7.3.4(3) of the annex")
    width = float(cracking.crack_width(np.array([m]), at, bars, concrete, steel)[0])
    yield Step("width of cracks", "w_k", width * 1e3, "mm", FORMULAS["w_k"], "7.3.4(1), 7.8")
