"""One-way shear of slabs by EN 1992-1-1:2023 8.2, per meter of width: what needs no links, and the links of the rest.

    tau_Ed = v_Ed / z,  z = 0.9 d                                                        8.2.1(3), 8.19
    tau_Rdc,min = 11 / gamma_V (f_ck / f_yd d_dg / d)^(1/2)                              8.2.1(4), 8.20
    tau_Rd,c = 0.66 / gamma_V (100 rho_l f_ck d_dg / d)^(1/3) >= tau_Rdc,min             8.2.2(2), 8.27
    tau_Rd,sy = rho_w f_ywd cot theta,  tau_Ed (cot theta + tan theta) <= nu f_cd        8.2.3, 8.42, 8.44

Stresses in MPa, d_dg and d in mm. d may be replaced by the mechanical shear span a_v where that is shorter, 8.2.2(3);
it is not here, which is on the safe side.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023.materials import FORMULAS as OF_CONCRETE
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2 import struts
from groundslab.design.codes.eurocode2.struts import LEVER, LINKS, Links
from groundslab.design.rules.calculation import MEGA, Step

_MPA = 1e6
#: The formulas of the functions here, with forces per width in MN/m, stresses in MPa, d and z in m, d_dg in mm.
FORMULAS = {
    "tau_min": "11 / gamma_V * sqrt(f_ck / f_yd * d_dg / (1000 * d))",
    "tau_Rd,c": "max(0.66 / gamma_V * (100 * rho_l * f_ck * d_dg / (1000 * d))^(1/3), tau_min)",
    "v_Rd,c": "tau_Rd,c * z",
    "a_sw": LINKS,
}
#: The largest ratio of bars that counts: the standard has none, and that of the first generation is on the safe side.
MOST_BARS = 0.02


def minimum_resistance(concrete: Concrete, steel: Steel, d: Array | float) -> Array:
    """Return tau_Rdc,min (n,) [Pa] for effective depths d (n,) [m] (formula 8.20)."""
    ratio = concrete.f_ck / steel.f_yd * concrete.d_dg / np.asarray(d, dtype=float)
    return np.asarray(11 / concrete.gamma_v * np.sqrt(ratio) * _MPA)


def stress_without_links(concrete: Concrete, steel: Steel, d: Array | float, rho: Array | float) -> Array:
    """Return tau_Rd,c (n,) [Pa] for depths d (n,) [m] and ratios of bars in tension rho (n,) (formula 8.27)."""
    d = np.asarray(d, dtype=float)
    counted = np.minimum(rho, MOST_BARS)
    of_bars = 0.66 / concrete.gamma_v * np.cbrt(100 * counted * concrete.f_ck / _MPA * concrete.d_dg / d) * _MPA
    return np.maximum(of_bars, minimum_resistance(concrete, steel, d))


def resistance_without_links(concrete: Concrete, steel: Steel, d: Array, rho: Array) -> Array:
    """Return v_Rd,c = tau_Rd,c z (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension (n,)."""
    return np.asarray(stress_without_links(concrete, steel, d, rho) * LEVER * np.asarray(d, dtype=float))


def required_links(v: Array, d: Array, concrete: Concrete, steel: Steel, flattest: float) -> Links:
    """Return vertical links for shear forces v (n,) [N/m], with the flattest struts that the concrete bears.

    Where no struts bear, cot theta is 1 and the area inf. flattest is the largest cot theta (8.2.3(4)).
    """
    return struts.links_by_struts(v, LEVER * np.asarray(d, dtype=float), concrete.strut, steel.f_yd, flattest)


def minimum_links(concrete: Concrete, steel: Steel) -> float:
    """Return the least links per area of the plan [m2/m2], 12.4, of class A of ductility, the most of all classes."""
    return 0.08 * math.sqrt(concrete.f_ck / _MPA) / (steel.f_yk / _MPA)


def design_strength(concrete: Concrete) -> Iterator[Step]:
    """Yield the steps to f_cd."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa", clause="Table 5.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="Table 4.3")
    yield Step("factor of the time of loading", "k_tc", concrete.k_tc, clause="5.1.6(1)")
    yield Step("factor of strong concrete", "eta_cc", concrete.eta_cc, "", OF_CONCRETE["eta_cc"], "5.1.6(1), 5.4")
    yield Step("design strength", "f_cd", concrete.f_cd / MEGA, "MPa", OF_CONCRETE["f_cd"], "5.1.6(1), 5.3")


def in_shear(concrete: Concrete, steel: Steel, d: float, depth: str = "d") -> Iterator[Step]:
    """Yield the steps to tau_Rdc,min for an effective depth [m] that is called d or d_v."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa", clause="Table 5.1")
    yield Step("partial factor of shear", "gamma_V", concrete.gamma_v, clause="Table 4.3")
    yield Step("least size of the coarsest aggregates", "D_lower", concrete.d_lower * 1e3, "mm", clause="8.2.1(4)")
    formula = OF_CONCRETE["d_dg" if concrete.through == 1 else "d_dg, high strength"]
    yield Step("roughness of cracks", "d_dg", concrete.d_dg * 1e3, "mm", formula, "8.2.1(4)")
    yield Step("design yield strength", "f_yd", steel.f_yd / MEGA, "MPa", clause="5.2.4, 5.11")
    least = float(minimum_resistance(concrete, steel, d)) / MEGA
    formula = FORMULAS["tau_min"].replace("1000 * d)", f"1000 * {depth})")
    yield Step("least resistance", "tau_min", least, "MPa", formula, "8.2.1(4), 8.20")
