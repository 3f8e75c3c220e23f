"""Moments and stresses that floor slabs resist: plain, with fibers, with a mesh (TR34), by modulus of rupture (ACI)."""

from __future__ import annotations

import math

from groundslab.design.codes.en1992_2004.materials import Concrete, Steel

#: Stresses over f_R1 and f_R4, of fiber concrete at the crack's tip and at the face (TR34).
SIGMA_1, SIGMA_4 = 0.45, 0.37
#: A stress over the modulus of rupture that may be repeated for ever, and from which the line of PCA 1984 holds.
ENDLESS, STRAIGHT = 0.45, 0.55
#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "f_ctd,fl": "max(1.6 - h, 1) * f_ctm / gamma_C",
    "M_n": "f_ctd,fl * h^2 / 6",
    "M_p of fibers": f"h^2 / gamma_C * (0.29 * {SIGMA_4:g} * f_R4 + 0.16 * {SIGMA_1:g} * f_R1)",
    "M_p of a mesh": "0.95 * A_s / 10000 * f_yd * d",
    "f_ctd": "0.7 * f_ctm / gamma_C",
    "sigma_f": "mu * gamma * L / 2 / 1000",
    "r_N often": f"max(0.43248 + 4.2577 / N^(1 / 3.268), {ENDLESS:g})",
    "r_N": "0.97187 - 0.0828 * log10(N)",
}


def flexural_strength(concrete: Concrete, h: float) -> float:
    """Return f_ctd,fl [Pa] of plain concrete h [m] thick, f_ctm (1.6 - h / m) / gamma_C (EN 1992-1-1 3.1.8(1))."""
    return max(1.6 - h, 1.0) * concrete.f_ctm / concrete.gamma_c


def plain_moment(concrete: Concrete, h: float) -> float:
    """Return the moment M_un [N m/m] at which plain concrete cracks (TR34 equation 2)."""
    return flexural_strength(concrete, h) * h**2 / 6


def fiber_moment(f_R1: float, f_R4: float, h: float, gamma: float) -> float:
    """Return the moment [N m/m] of cracked fiber concrete of residual strengths f_R1, f_R4 [Pa] (TR34)."""
    return h**2 / gamma * (0.29 * SIGMA_4 * f_R4 + 0.16 * SIGMA_1 * f_R1)


def mesh_moment(area: float, d: float, steel: Steel) -> float:
    """Return the moment [N m/m] of bars area [m2/m] at the effective depth d [m] (TR34 equation 3)."""
    return 0.95 * area * steel.f_yd * d


def tensile_strength(concrete: Concrete) -> float:
    """Return f_ctd [Pa] of plain concrete, 0.7 f_ctm / gamma_C (EN 1992-1-1 3.1.6(2)P, Table 3.1)."""
    return 0.7 * concrete.f_ctm / concrete.gamma_c


def restraint_stress(friction: float, unit_weight: float, length: float) -> float:
    """Return the tension [Pa] midway between joints, where friction of half the bay adds up: mu gamma L / 2."""
    return friction * unit_weight * length / 2


def allowed_repetitions(ratio: float) -> float:
    """Return how often a stress over the modulus of rupture may be repeated (PCA 1984, ACI 360R-10 table 5.3)."""
    if ratio >= STRAIGHT:
        return float(10 ** ((0.97187 - ratio) / 0.0828))
    return float((4.2577 / (ratio - 0.43248)) ** 3.268) if ratio >= ENDLESS else math.inf


def allowed_ratio(repetitions: float) -> float:
    """Return the stress over the modulus of rupture that may be repeated so often, at least ENDLESS."""
    if repetitions <= allowed_repetitions(STRAIGHT):
        return 0.97187 - 0.0828 * math.log10(repetitions)
    return max(0.43248 + 4.2577 * math.pow(repetitions, -1 / 3.268), ENDLESS)
