"""Crack widths of slabs in bending by EN 1992-1-1 7.3.4, and the least bars that control cracks, 7.3.2.

Where restrained shortening cracks the slab all through, the bars at each face bear half of the force at which it does:
k_c = 1, k_2 = 1, and x = 0.

    w_k = s_r,max (eps_sm - eps_cm)                                                                7.8
    eps_sm - eps_cm = (sigma_s - k_t f_ct,eff / rho_p,eff (1 + alpha_e rho_p,eff)) / E_s
                      >= 0.6 sigma_s / E_s                                                         7.9
    s_r,max = k_3 c + k_1 k_2 k_4 phi / rho_p,eff, bars no farther apart than 5 (c + phi / 2)      7.11
            = 1.3 (h - x) beyond                                                                   7.14

The section is cracked and elastic, without bars in compression: k_1 = 0.8 of ribbed bars, k_2 = 0.5 of bending. k_3 and
k_4, and whether s_r,max is at most sigma_s phi / (3.6 f_ct,eff), are those of the concrete's annex (7.3.4(3)).
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.annex import RECOMMENDED, Annex
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import FORMULAS as SECTION
from groundslab.design.codes.eurocode2.cracked_sections import Bars, neutral_axis, steel_stress

__all__ = [
    "Bars", "allowed_stress", "bar_stress", "crack_width", "largest_spacing", "mean_strain", "minimum_area",
    "neutral_axis", "steel_stress",
]  # fmt: skip

_MPA = 1e6
#: The formulas of the functions here, with moments per width in MN, stresses in MPa and lengths in m.
FORMULAS = {
    **SECTION,
    "rho": "A_s / min(2.5 * (h - d), (h - x) / 3, h / 2)",
    "h_c,ef": "max(2.5 * (h - d), min(k_h * h + 2 * (h - d), 5 * (h - d)))",
    "rho h_c,ef": "A_s / min(h_c,ef, (h - x) / 3, h / 2)",
    "rho_t h_c,ef": "A_s / min(h_c,ef, h / 2)",
    "eps": "max(sigma_s - k_t * f_ctm / rho * (1 + E_s / E_cm * rho), 0.6 * sigma_s) / E_s",
    "s_r near": "k_3 * c + k_1 * k_2 * k_4 * phi / rho",
    "s_r far": "1.3 * (h - x)",
    "s_r by stress": "min(s_r, sigma_s * phi / (3.6 * f_ctm))",
    "w_k": "s_r * eps * 1000",
    "k": "min(1, max(0.65, 1 - 0.7 * (h - 0.3)))",
    "A_min bending": "0.4 * k * f_ct * h / 2 / f_yk * 10000",
    "A_min tension": "k * f_ct * h / 2 / f_yk * 10000",
    "sigma_s tension": "k * f_ct * h / 2 / A_s",
    "rho tension": "A_s / min(2.5 * (h - d), h / 2)",
    "eps tension": "max(sigma_s - k_t * f_ct / rho * (1 + E_s / E_cm * rho), 0.6 * sigma_s) / E_s",
    "s_r by stress, tension": "min(s_r, sigma_s * phi / (3.6 * f_ct))",
}
#: Bond of ribbed bars, bending, and tension.
K_1, K_2, K_2_TENSION = 0.8, 0.5, 1.0
#: Table 7.2N: stresses of bars [Pa], and the largest diameters [m] by the crack width [m] that they have at these.
STRESSES = tuple(stress * _MPA for stress in (400, 360, 320, 280, 240, 200, 160))
DIAMETERS = {
    0.2e-3: (4e-3, 5e-3, 6e-3, 8e-3, 12e-3, 16e-3, 25e-3),
    0.3e-3: (6e-3, 8e-3, 10e-3, 12e-3, 16e-3, 25e-3, 32e-3),
    0.4e-3: (8e-3, 10e-3, 12e-3, 16e-3, 20e-3, 32e-3, 40e-3),
}
#: f_ct,eff that Table 7.2N is for [Pa].
OF_TABLE = 2.9 * _MPA
#: k_t of loads that last, and of others (7.3.4(2)).
LONG_TERM, SHORT_TERM = 0.4, 0.6


def bar_stress(m: Array, h: Array, bars: Bars, concrete: Concrete, steel: Steel, E_c: float | None = None) -> Array:
    """Return sigma_s (n,) [Pa] of the bars of cracked sections, h (n,) [m] thick, under moments m (n,) [N m/m].

    E_c [Pa] is the modulus of concrete under these loads, with creep; E_cm without it. Above f_yk the section is not
    elastic, and the value says no more than that.
    """
    d = np.asarray(h, dtype=float) - bars.cover - bars.diameter / 2
    return steel_stress(np.asarray(m), d, np.asarray(bars.area), steel.E_s / (E_c or concrete.E_cm))


def effective_depth(h: Array, axis: Array | float, k_h: float) -> Array:
    """Return h_c,ef (n,) [m] of bars whose axes lie so far [m] from the face, 7.3.2(3), before its other limits.

    It is 2.5 of that distance; by the German annex (Figure 7.1DE d) it grows in thick slabs to 5 of it, straight with
    h, k_h being 0.05 in bending and 0.1 in tension.
    """
    axis = np.asarray(axis)
    return np.asarray(np.maximum(2.5 * axis, np.minimum(k_h * np.asarray(h) + 2 * axis, 5 * axis)))


def effective_ratio(h: Array, d: Array, x: Array, area: Array, annex: Annex = RECOMMENDED) -> Array:
    """Return rho_p,eff (n,): bars over the effective area of concrete in tension, 7.3.2(3)."""
    depth = np.minimum(np.minimum(effective_depth(h, h - d, annex.tension_depth[0]), (h - x) / 3), h / 2)
    return np.asarray(area / depth)


def mean_strain(
    sigma_s: Array, rho: Array, concrete: Concrete, steel: Steel, k_t: float = LONG_TERM, f_ct: float | None = None
) -> Array:
    """Return eps_sm - eps_cm (n,) by 7.9, with f_ct,eff [Pa], f_ctm by default."""
    f_ct = f_ct or concrete.f_ctm
    stiffened = sigma_s - k_t * f_ct / rho * (1 + steel.E_s / concrete.E_cm * rho)
    return np.asarray(np.maximum(stiffened, 0.6 * sigma_s) / steel.E_s)


def largest_spacing(bars: Bars, h: Array, x: Array, rho: Array, annex: Annex = RECOMMENDED, k_2: float = K_2) -> Array:
    """Return s_r,max (n,) [m] by 7.11, or by 7.14 where bars lie too far apart for it."""
    apart = np.asarray(bars.spacing > 5 * (bars.cover + bars.diameter / 2))
    near = cover_factor(annex, bars.cover) * bars.cover + K_1 * k_2 * annex.k_4 * bars.diameter / rho
    return np.where(apart, 1.3 * (h - x), near)


def cover_factor(annex: Annex, cover: Array | float) -> Array:
    """Return k_3 of covers (n,) or one [m], which falls by (c_0 / c)^(2/3) in France (7.3.4(3))."""
    return np.asarray(annex.k_3 * np.minimum(1.0, annex.k_3_cover / np.asarray(cover)) ** (2 / 3))


def crack_width(
    m: Array,
    h: Array,
    bars: Bars,
    concrete: Concrete,
    steel: Steel,
    *,
    E_c: float | None = None,
    k_t: float = LONG_TERM,
) -> Array:
    """Return w_k (n,) [m] on the face in tension under moments m >= 0 (n,) [N m/m] of a slab of thickness h (n,) [m].

    E_c [Pa] is the modulus of concrete under these loads, with creep; E_cm without it. A section whose concrete is
    stressed below f_ctm is not taken as uncracked: the moment may have been larger before. The width holds for elastic
    bars, up to f_yk (`bar_stress`).
    """
    h = np.asarray(h, dtype=float)
    d = h - bars.cover - bars.diameter / 2
    modular_ratio = steel.E_s / (E_c or concrete.E_cm)
    x = neutral_axis(d, np.asarray(bars.area), modular_ratio)
    rho = effective_ratio(h, d, x, np.asarray(bars.area), concrete.annex)
    sigma_s = bar_stress(m, h, bars, concrete, steel, E_c)
    s_r = largest_spacing(bars, h, x, rho, concrete.annex)
    if concrete.annex.crack_spacing_by_stress:
        s_r = np.minimum(s_r, spacing_by_stress(sigma_s, bars, concrete))
    return s_r * mean_strain(sigma_s, rho, concrete, steel, k_t)


def spacing_by_stress(sigma_s: Array, bars: Bars, concrete: Concrete, f_ct: float | None = None) -> Array:
    """Return the largest s_r,max (n,) [m] by the stress of bars, where the annex has it, f_ct [Pa] by default f_ctm."""
    return np.asarray(sigma_s * bars.diameter / (3.6 * (f_ct or concrete.f_ctm)))


def minimum_area(h: Array, concrete: Concrete, sigma_s: float) -> Array:
    """Return the least area of bars (n,) [m2/m] that controls cracks from bending, 7.3.2(2): 7.1 with k_c = 0.4.

    sigma_s [Pa] is the stress that is allowed right after a crack has formed, f_yk or less. f_ct,eff is f_ctm, or what
    the annex asks for at least.
    """
    h = np.asarray(h, dtype=float)
    return np.asarray(0.4 * depth_factor(h) * concrete.f_ct_least * h / 2 / sigma_s)


def depth_factor(h: Array) -> Array:
    """Return k (n,) of thicknesses h (n,) [m], by which stresses that balance each other lower the force, 7.3.2(2)."""
    return np.interp(h, [0.3, 0.8], [1.0, 0.65])


def allowed_stress(w_max: float, diameter: Array, f_ct: float, steel: Steel, annex: Annex) -> Array:
    """Return the stress (n,) [Pa] that bars may have as a crack has just formed, if it is not to be wider than w_max.

    Diameters (n,) [m] are phi_s* of Table 7.2N, between whose widths, and between 0 and the least of them, all is
    straight; thicker bars than it has are stressed the less, as 1 / phi_s*. Where the annex has s_r,max by the stress
    of bars, they are those of the bars themselves, and w_max = 0.6 sigma_s^2 phi / (3.6 f_ct,eff E_s) by 7.8, 7.9.
    """
    diameter = np.asarray(diameter)
    if annex.crack_spacing_by_stress:
        return np.minimum(np.sqrt(6 * w_max * f_ct * steel.E_s / diameter), steel.f_yk)
    widths, table = zip(*DIAMETERS.items(), strict=True)
    largest = [np.interp(w_max, (0.0, *widths), (0.0, *column)) for column in zip(*table, strict=True)]
    stress = np.interp(diameter, largest, STRESSES) * np.minimum(1.0, largest[-1] / diameter)
    return np.asarray(np.minimum(stress, steel.f_yk))


def tension_force(h: Array, f_ct: float) -> Array:
    """Return the force (n,) [N/m] at one face as a slab h (n,) [m] thick cracks all through, 7.1 with k_c = 1.

    A_ct is half of the section, f_ct [Pa] the tensile strength at that time.
    """
    h = np.asarray(h, dtype=float)
    return np.asarray(depth_factor(h) * f_ct * h / 2)


def tension_ratio(h: Array, bars: Bars, annex: Annex = RECOMMENDED) -> Array:
    """Return rho_p,eff (n,) of one face of a section that is all in tension, 7.3.2(3) and Figure 7.1 c."""
    depth = effective_depth(h, bars.cover + bars.diameter / 2, annex.tension_depth[1])
    return np.asarray(bars.area / np.minimum(depth, np.asarray(h) / 2))


def tension_k_2(annex: Annex) -> float:
    """Return k_2 of a section in tension; phi / (3.6 rho) of an annex without k_3 is the same as in bending."""
    return K_2_TENSION if annex.k_3 else K_2


def tension_spacing(h: Array, bars: Bars, sigma_s: Array, concrete: Concrete, f_ct: float) -> Array:
    """Return s_r,max (n,) [m] of a slab that is cracked all through."""
    annex, rho = concrete.annex, tension_ratio(h, bars, concrete.annex)
    s_r = largest_spacing(bars, np.asarray(h), np.zeros(np.shape(h)), rho, annex, tension_k_2(annex))
    return np.minimum(s_r, spacing_by_stress(sigma_s, bars, concrete, f_ct)) if annex.crack_spacing_by_stress else s_r


def tension_crack_width(h: Array, bars: Bars, concrete: Concrete, steel: Steel, f_ct: float) -> Array:
    """Return w_k (n,) [m] of a slab h (n,) [m] thick as restraint cracks it all through, loads that last, 7.3.4."""
    sigma_s = tension_force(h, f_ct) / bars.area
    strain = mean_strain(sigma_s, tension_ratio(h, bars, concrete.annex), concrete, steel, LONG_TERM, f_ct)
    return tension_spacing(h, bars, sigma_s, concrete, f_ct) * strain
