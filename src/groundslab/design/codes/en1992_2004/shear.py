"""One-way shear of slabs by EN 1992-1-1 6.2, per meter of width: what needs no links, and the links of the rest.

    v_Rd,c = max(C_Rd,c k (100 rho_l f_ck)^(1/3), v_min k^(3/2) f_ck^(1/2)) d            6.2.2(1), 6.2, 6.3N
    v_Rd,max = z nu f_cd / (cot theta + tan theta)                                       6.2.3(3), 6.9
    a_sw = v_Ed / (z f_ywd cot theta)                                                    6.2.3(3), 6.8

k = 1 + (200 / d)^(1/2) <= 2, f_ck in MPa and d in mm; z = 0.9 d (6.2.3(1)), in Germany at most the larger of d - 2 c
and d - c - 30 mm, c being the cover of the bars in compression. C_Rd,c, v_min, nu and the flattest strut are those of
the annex, by default 0.18 / gamma_C, 0.035, 0.6 (1 - f_ck / 250) and cot theta = 2.5.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.struts import LEVER, LINKS, Links, links_by_struts
from groundslab.design.rules.calculation import MEGA, Step

__all__ = [
    "LEVER", "Links", "lever", "minimum_beam_links", "minimum_links", "required_links", "resistance_without_links",
]  # fmt: skip

_MPA = 1e6
#: The formulas of the functions here, with forces per width in MN/m, stresses in MPa and lengths in m.
FORMULAS = {
    "k": "min(2, 1 + sqrt(0.2 / d))",
    "v_Rd,c": "max(C / gamma_C * k * (100 * rho_l * f_ck)^(1/3), v_min * k^(3/2) * f_ck^(1/2)) * d",
    "a_sw": LINKS,
}
#: The largest ratio of bars that counts (6.2.2(1)).
MOST_BARS = 0.02
#: Depths [m] up to which and from which v_min is that of thin and of thick members.
THIN, THICK = 0.6, 0.8
#: z is at most d less the cover and this [m], or less twice the cover (DIN EN 1992-1-1/NA, NCI to 6.2.3(1)).
COVER_LESS = 0.030


def resistance_without_links(concrete: Concrete, d: Array, rho: Array) -> Array:
    """Return v_Rd,c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    f_ck, d = concrete.f_ck_shear / _MPA, np.asarray(d, dtype=float)
    k = size_factor(d)
    of_bars = concrete.annex.c_rd_c / concrete.gamma_c * k * np.cbrt(100 * np.minimum(rho, MOST_BARS) * f_ck)
    least = least_factor(concrete, d) * k**1.5 * np.sqrt(f_ck)
    return np.asarray(np.maximum(of_bars, least) * _MPA * d)


def size_factor(d: Array) -> Array:
    """Return k of effective depths d (n,) [m] (6.2.2(1))."""
    return np.asarray(np.minimum(2.0, 1 + np.sqrt(0.2 / d)))


def least_factor(concrete: Concrete, d: Array) -> Array:
    """Return v_min over k^(3/2) f_ck^(1/2) [MPa] for effective depths d (n,) [m] (6.3N)."""
    return np.asarray(np.interp(d, [THIN, THICK], concrete.v_min_factor))


def lever(concrete: Concrete, d: Array, cover: float) -> Array:
    """Return z (n,) [m] for depths d (n,) [m] and the cover [m] of the longitudinal bars in compression, 6.2.3(1)."""
    d = np.asarray(d, dtype=float)
    if not concrete.annex.lever_by_cover:
        return LEVER * d
    return np.minimum(LEVER * d, np.maximum(d - 2 * cover, d - cover - COVER_LESS))


def required_links(v: Array, d: Array, concrete: Concrete, steel: Steel, cover: float) -> Links:
    """Return vertical links for shear forces v (n,) [N/m], with the flattest struts that the concrete bears.

    The cover [m] is that of the longitudinal bars in compression. Where no struts bear, cot theta is 1, the area inf.
    """
    z = lever(concrete, d, cover)
    return links_by_struts(v, z, concrete.strut, steel.f_yd, flattest(np.asarray(v), z, concrete))


def flattest(v: Array, z: Array, concrete: Concrete) -> Array:
    """Return the largest cot theta (n,) by 6.2.3(2), with the concrete's share by friction in cracks, if any."""
    annex = concrete.annex
    if not annex.crack_friction:
        return np.full(np.broadcast(v, z).shape, annex.flattest)
    left = 1 - annex.crack_friction * np.cbrt(concrete.f_ck_shear / _MPA) * _MPA * z / np.maximum(v, 1e-12)
    return np.asarray(np.clip(1.2 / np.maximum(left, 1e-12), 1.0, annex.flattest))


def minimum_links(concrete: Concrete, steel: Steel) -> float:
    """Return the least links of slabs per area of the plan [m2/m2], 9.2.2(5) by 9.3.2(2)."""
    return concrete.annex.slab_links * minimum_beam_links(concrete, steel)


def minimum_beam_links(concrete: Concrete, steel: Steel) -> float:
    """Return the least links of beams per area of the plan [m2/m2], 9.2.2(5)."""
    of_root, of_tension = concrete.annex.beam_links
    return (of_root * math.sqrt(concrete.f_ck / _MPA) * _MPA + of_tension * concrete.f_ctm) / steel.f_yk


def concrete_steps(concrete: Concrete) -> Iterator[Step]:
    """Yield the strength of the concrete in shear, and its partial factor."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck_shear / MEGA, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")


def strut_steps(concrete: Concrete, symbol: str, clause: str) -> Iterator[Step]:
    """Yield the strength of struts, nu f_cd, by its symbol."""
    a, b, c = concrete.annex.nu
    yield Step("factor of the concrete in struts", "alpha_cc", concrete.alpha_cc_shear, clause="3.1.6(1)")
    formula = f"{a:g} * min(1, {b:g} - f_ck / {c:g}) * alpha_cc * f_ck / gamma_C"
    yield Step("strength of struts", symbol, concrete.strut / MEGA, "MPa", formula, clause)


def flattest_steps(concrete: Concrete, v: float, z: float, of_force: str) -> Iterator[Step]:
    """Yield the largest cot theta for a shear force [N/m], written as a formula [MN/m], and a lever arm z [m]."""
    most, friction, clause = concrete.annex.flattest, concrete.annex.crack_friction, "6.2.3(2) of the annex"
    formula = f"{most:g}"
    if friction:
        v_cc = friction * np.cbrt(concrete.f_ck_shear / MEGA) * z
        of_friction = f"{friction:g} * f_ck^(1/3) * z"
        yield Step("force that the concrete carries by friction in cracks", "v_cc", v_cc, "MN/m", of_friction, clause)
        if v_cc < v / MEGA:
            formula = f"max(1, min({most:g}, 1.2 / (1 - v_cc / {of_force})))"
    largest = float(flattest(np.array([v]), np.array([z]), concrete)[0])
    yield Step("largest cot theta", "cot_max", largest, "", formula, clause)


def least_links_formula(concrete: Concrete) -> str:
    """Return the formula of the least ratio of links of beams; none where f_ck in shear is bounded."""
    of_root, of_tension = concrete.annex.beam_links
    if of_root and concrete.f_ck > concrete.f_ck_shear:  # the f_ck of the calculation is another one
        return ""
    strength = f"{of_root:g} * sqrt(f_ck)" if of_root else f"{of_tension:g} * f_ctm"
    return f"{strength} / f_yk"


def strength_steps(concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield the strengths that least links follow from."""
    if concrete.annex.beam_links[1]:
        yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", clause="Table 3.1")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="3.2.2(3)")
