"""Crack widths of slabs in bending by EN 1992-1-1:2023 9.2.3, and the least bars that control cracks, 9.2.2.

    w_k,cal = k_w k_1/r s_r,m,cal (eps_sm - eps_cm)                                                9.8
    k_1/r = (h - x) / (h - a_y - x)                                                                9.9
    eps_sm - eps_cm = (sigma_s - k_t f_ct,eff / rho_p,eff (1 + alpha_e rho_p,eff)) / E_s
                      >= (1 - k_t) sigma_s / E_s                                                   9.11
    s_r,m,cal = 1.5 c + k_fl k_b / 7.2 phi / rho_p,eff <= 1.3 (h - x) / k_w                        9.15
    k_fl = (h - h_c,eff) / h                                                                       9.16
    h_c,eff = min(a_y + 5 phi, 10 phi, 3.5 a_y, h - x, h / 2)                                      Figure 9.3
    A_s,min = 0.2 k_h f_ct,eff b h / f_yk,  k_h = 0.8 - 0.6 (min(b, h) - 0.3), 0.5 to 0.8          9.2, 9.5

The section is cracked and elastic, without bars in compression. a_y is the distance of the bars' axis from the face in
tension, k_b = 0.9 of good bond. Between bars farther apart than 10 phi, only 10 phi of each count: the reading of
Figure 9.3 b) by the source, which calls it unconfirmed; it makes cracks wider.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import FORMULAS as SECTION
from groundslab.design.codes.eurocode2.cracked_sections import Bars, neutral_axis, steel_stress

#: The formulas of the functions here, with moments per width in MN, stresses in MPa and lengths in m.
FORMULAS = {
    **SECTION,
    "h_c": "min(a_y + 5 * phi, 10 * phi, 3.5 * a_y, h - x, h / 2)",
    "rho": "A_s / (h_c * min(1, 10 * phi / s))",
    "k_fl": "(h - h_c) / h",
    "s_r": "min(1.5 * c + k_fl * k_b / 7.2 * phi / rho, 1.3 * (h - x) / k_w)",
    "k_r": "(h - x) / (h - a_y - x)",
    "eps": "max(sigma_s - k_t * f_ctm / rho * (1 + E_s / E_cm * rho), (1 - k_t) * sigma_s) / E_s",
    "k_h": "min(max(0.8 - 0.6 * (h - 0.3), 0.5), 0.8)",
    "A_min": "0.2 * k_h * f_ctm * h / f_yk * 10000",
    "w_k,cal": "k_w * k_r * s_r * eps * 1000",
}
#: Good bond (formula 9.18), as bars of slabs cast horizontally have at the bottom; else POOR_BOND.
GOOD_BOND, POOR_BOND = 0.9, 1.2
#: k_t of loads that last (9.2.3(3)).
LONG_TERM = 0.4
#: So many diameters on both sides of a bar count together at most.
APART = 10.0


def bar_stress(m: Array, h: Array, bars: Bars, concrete: Concrete, steel: Steel) -> Array:
    """Return sigma_s (n,) [Pa] of the bars of cracked sections, h (n,) [m] thick, under moments m (n,) [N m/m]."""
    d = np.asarray(h, dtype=float) - axis(bars)
    return steel_stress(np.asarray(m), d, np.asarray(bars.area), steel.E_s / concrete.E_cm)


def axis(bars: Bars) -> Array:
    """Return a_y (n,) [m]."""
    return np.asarray(bars.cover + bars.diameter / 2)


def effective_depth(h: Array, x: Array, bars: Bars) -> Array:
    """Return h_c,eff (n,) [m] of one layer of bars (Figure 9.3)."""
    a_y = axis(bars)
    of_bars = np.minimum(np.minimum(a_y + 5 * bars.diameter, 10 * bars.diameter), 3.5 * a_y)
    return np.asarray(np.minimum(np.minimum(of_bars, h - x), h / 2))


def effective_ratio(h_c: Array, bars: Bars) -> Array:
    """Return rho_p,eff (n,): bars over the concrete in tension around them."""
    return np.asarray(bars.area / (h_c * np.minimum(1.0, APART * bars.diameter / np.asarray(bars.spacing))))


def mean_strain(sigma_s: Array, rho: Array, concrete: Concrete, steel: Steel, k_t: float = LONG_TERM) -> Array:
    """Return eps_sm - eps_cm (n,) by 9.11, with f_ct,eff = f_ctm."""
    stiffened = sigma_s - k_t * concrete.f_ctm / rho * (1 + steel.E_s / concrete.E_cm * rho)
    return np.asarray(np.maximum(stiffened, (1 - k_t) * sigma_s) / steel.E_s)


def mean_spacing(bars: Bars, h: Array, x: Array, rho: Array, k_fl: Array, bond: tuple[float, float]) -> Array:
    """Return s_r,m,cal (n,) [m] by 9.15; bond has k_b and k_w."""
    k_b, k_w = bond
    return np.asarray(np.minimum(1.5 * bars.cover + k_fl * k_b / 7.2 * bars.diameter / rho, 1.3 * (h - x) / k_w))


def bond(layer: str) -> float:
    """Return k_b of the bars of a layer: those at the top of a slab are taken as poorly bonded (9.18, 11.4.2)."""
    return GOOD_BOND if layer.startswith("bottom") else POOR_BOND


def crack_width(m: Array, h: Array, bars: Bars, concrete: Concrete, steel: Steel, k_b: float = GOOD_BOND) -> Array:
    """Return w_k,cal (n,) [m] on the face in tension under moments m >= 0 (n,) [N m/m], h (n,) [m] thick.

    A section whose concrete is stressed below f_ctm is not taken as uncracked: the moment may have been larger before.
    The width holds for elastic bars, up to f_yk (`bar_stress`).
    """
    h = np.asarray(h, dtype=float)
    x = neutral_axis(h - axis(bars), np.asarray(bars.area), steel.E_s / concrete.E_cm)
    return width_of_stress(bar_stress(m, h, bars, concrete, steel), h, x, bars, (concrete, steel, k_b))


def width_of_stress(sigma_s: Array, h: Array, x: Array, bars: Bars, constants: tuple[Concrete, Steel, float]) -> Array:
    """Return w_k,cal (n,) [m] for stresses of bars (n,) [Pa] and neutral axes x (n,) [m]; constants have k_b, too."""
    concrete, steel, k_b = constants
    h_c = effective_depth(h, x, bars)
    rho, k_w = effective_ratio(h_c, bars), concrete.annex.k_w
    s_r = mean_spacing(bars, h, x, rho, (h - h_c) / h, (k_b, k_w))
    return np.asarray(k_w * curvature_factor(h, x, bars) * s_r * mean_strain(sigma_s, rho, concrete, steel))


def curvature_factor(h: Array, x: Array, bars: Bars) -> Array:
    """Return k_1/r (n,), by which a crack is wider at the face than at the bars (formula 9.9)."""
    return np.asarray((h - x) / (h - axis(bars) - x))


def minimum_area(h: Array, concrete: Concrete, sigma_s: float) -> Array:
    """Return the least area of bars (n,) [m2/m] that controls cracks from bending, 9.2 and 9.5, of a wide section.

    sigma_s [Pa] is the stress that is allowed right after a crack has formed, f_yk or less.
    """
    h = np.asarray(h, dtype=float)
    return np.asarray(0.2 * thickness_factor(h) * concrete.f_ctm * h / sigma_s)


def thickness_factor(h: Array) -> Array:
    """Return k_h (n,) of thicknesses h (n,) [m] of wide sections (formula 9.5)."""
    return np.asarray(np.clip(0.8 - 0.6 * (h - 0.3), 0.5, 0.8))
