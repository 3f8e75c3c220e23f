"""Punching by EN 1992-1-1:2023 8.4: resistances without and with links, beta_e, the outer perimeter.

    tau_Ed   = beta_e V_Ed / (b_0.5 d_v)                                       at d_v / 2, 8.4.2(6), 8.92
    beta_e   = 1 + 1.1 e_b / b_b >= 1.05                                       Table 8.3, refined
    tau_Rd,c = 0.6 / gamma_V k_pb (100 rho_l f_ck d_dg / d_v)^(1/3)
               <= 0.5 / gamma_V f_ck^(1/2)                                     8.4.3(1), 8.94
    k_pb     = 3.6 (1 - b_0 / b_0.5)^(1/2),  1 <= k_pb <= 2.5                  8.96
    a_pd     = (a_p d_v / 8)^(1/2) instead of d_v where a_p < 8 d_v            8.4.3(2), 8.97, 8.98
    tau_Rd,cs = eta_c tau_Rd,c + eta_s rho_w f_ywd >= rho_w f_ywd              8.4.4(1), 8.104
    eta_c    = tau_Rd,c / tau_Ed                                               8.105
    eta_s    = d_v / (150 phi_w) + (15 d_dg / d_v)^(1/2) (eta_c k_pb)^(-3/2) <= 0.8     8.106
    tau_Rd,max = eta_sys tau_Rd,c,  eta_sys = 0.5 + 0.63 (b_0 / d_v)^(1/4) >= 1         8.109, 8.111
    b_0.5,out = b_0.5 (d_v / (d_v,out eta_c))^2                                8.4.4(7), 8.112

Stresses in MPa, lengths in mm. Where tau_Ed <= tau_Rdc,min of 8.2.1(4), nothing else need be shown (8.4.1(2)).
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from groundslab.design.codes.en1992_2023.materials import Concrete
from groundslab.design.demands.line_properties import Shape

_MPA, _MM = 1e6, 1e3
#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m, d_dg and phi_w in mm.
FORMULAS = {
    "e_b closed": "sqrt(e_1^2 + e_2^2)",
    "e_b edge": "abs(e_1) + 0.5 * abs(e_2)",
    "e_b corner": "0.27 * (abs(e_1) + abs(e_2))",
    "beta_e": "max(1.05, 1 + 1.1 * e_b / sqrt(b_1 * b_2))",
    "tau_Ed": "beta_e * V_Ed / (b_05 * d_v)",
    "tau_Ed by M": "(V_Ed + 1.1 * M_b / sqrt(b_1 * b_2)) / (b_05 * d_v)",
    "k_pb": "min(2.5, max(1, 3.6 * sqrt(1 - b_0 / b_05)))",
    "a_pd": "sqrt(a_p * d_v / 8)",
    "tau_Rd,c": "min(0.6 / gamma_V * k_pb * (100 * rho_l * f_ck * d_dg / (1000 * a_pd))^(1/3), "
    "0.5 / gamma_V * sqrt(f_ck))",
    "eta_c": "tau_Rd,c / tau_Ed",
    "phi_w": "10 * sqrt(1000 * d_v / 200)",
    "eta_s": "min(0.8, 1000 * d_v / (150 * phi_w) + sqrt(15 * d_dg / (1000 * d_v)) / (eta_c * k_pb)^(3/2))",
    "a_sw": "min((tau_Ed - eta_c * tau_Rd,c) / eta_s, tau_Ed) / f_ywd * 10000",
    "tau_cs": "max(eta_c * tau_Rd,c + eta_s * rho_w * f_ywd, rho_w * f_ywd)",
    "tau_max": "eta_sys * tau_Rd,c",
    "b_out": "b_05 * (d_v / (d_out * eta_c))^2",
}
#: beta_e of ends and corners of walls (Table 8.3).
WALLS: Mapping[str, float] = {"end": 1.4, "corner": 1.2}
#: The least beta_e (Table 8.3).
LEAST_BETA = 1.05
#: k_pb is between these (formula 8.96).
LEAST_GRADIENT, MOST_GRADIENT = 1.0, 2.5
#: The largest ratio of bars that counts: the standard has none, and that of the first generation is on the safe side.
MOST_BARS = 0.02
#: Where the control perimeter runs, over d_v (8.4.2(2)).
DISTANCE = 0.5
#: Up to where the ground's pressure relieves without links, over d_v (8.4.2(6)); with links it is the perimeter itself.
RELIEVED = 0.67
#: So much of a straight part of a perimeter counts at most, over d_v (8.4.2(3)).
STRAIGHT = 3.0
#: Beyond so many d_v the point of contraflexure says nothing (8.4.3(2)).
FAR_CONTRAFLEXURE = 8.0


def eccentricity(shape: Shape, along: float, across: float) -> float:
    """Return e_b [m] of the support's force from the perimeter's center along and across the plate's edge (Table 8.3).

    Of a closed perimeter both are alike, and at a corner both are across an edge.
    """
    along, across = abs(along), abs(across)
    if shape == "edge":
        return along + 0.5 * across
    return 0.27 * (along + across) if shape == "corner" else float(math.hypot(along, across))


def beta(e_b: float, b_1: float, b_2: float) -> float:
    """Return beta_e by its refined value (Table 8.3): b_1 and b_2 are the perimeter's overall widths [m]."""
    return max(LEAST_BETA, 1 + 1.1 * e_b / math.sqrt(b_1 * b_2))


def turned(M_b: float, b_1: float, b_2: float) -> float:
    """Return what (beta_e - 1) V_Ed is of moments alone [N m], e_b V_Ed being their M_b (Table 8.3) [N]."""
    return 1.1 * M_b / math.sqrt(b_1 * b_2)


def gradient(b_0: float, b_05: float) -> float:
    """Return k_pb for the perimeters at the face and at d_v / 2 [m] (formula 8.96)."""
    return min(MOST_GRADIENT, max(LEAST_GRADIENT, 3.6 * math.sqrt(max(0.0, 1 - b_0 / b_05))))


def depth_by_contraflexure(a_p: float, d_v: float) -> float:
    """Return a_pd, or d_v where contraflexure is not nearer than 8 d_v, for a_p >= d_v and d_v [m] (formula 8.97)."""
    return math.sqrt(max(a_p, d_v) * d_v / 8) if a_p < FAR_CONTRAFLEXURE * d_v else d_v


def resistance_without_links(concrete: Concrete, k_pb: float, rho: float, d: float) -> float:
    """Return tau_Rd,c [Pa] for a ratio rho of bars and d_v, or a_pd in its place, [m] (formula 8.94)."""
    f_ck = concrete.f_ck / _MPA
    of_bars = 0.6 * k_pb * math.cbrt(100 * min(rho, MOST_BARS) * f_ck * concrete.d_dg / d)
    return min(of_bars, 0.5 * math.sqrt(f_ck)) / concrete.gamma_v * _MPA


def concrete_share(tau_Rd_c: float, tau_Ed: float) -> float:
    """Return eta_c (8.105)."""
    return tau_Rd_c / tau_Ed


def thickest_link(d_v: float) -> float:
    """Return the largest diameter [m] of single legs and open stirrups in a slab of depth d_v [m] (12.5.1, 12.7)."""
    return 0.010 * math.sqrt(d_v / 0.200)


def links_share(d_dg: float, d_v: float, phi_w: float, eta_c: float, k_pb: float) -> float:
    """Return eta_s of links of a diameter phi_w, all lengths in m (8.106)."""
    return min(0.8, d_v / (150 * phi_w) + math.sqrt(15 * d_dg / d_v) / math.pow(eta_c * k_pb, 1.5))


def resistance_with_links(tau_Rd_c: float, eta: tuple[float, float], rho_w: float, f_ywd: float) -> float:
    """Return tau_Rd,cs [Pa] for eta_c and eta_s, a ratio rho_w of links and their strength [Pa] (8.104)."""
    eta_c, eta_s = eta
    return max(eta_c * tau_Rd_c + eta_s * rho_w * f_ywd, rho_w * f_ywd)


def required_links(tau_Ed: float, tau_Rd_c: float, eta: tuple[float, float], f_ywd: float) -> float:
    """Return rho_w for which tau_Rd,cs = tau_Ed [Pa], with eta_c and eta_s (8.104)."""
    eta_c, eta_s = eta
    return min((tau_Ed - eta_c * tau_Rd_c) / eta_s, tau_Ed) / f_ywd


def system_factor(concrete: Concrete, b_0: float, d_v: float) -> float:
    """Return eta_sys of links and stirrups (8.111)."""
    a, b = concrete.annex.eta_sys
    return max(1.0, a + b * math.pow(b_0 / d_v, 0.25))


def outer_perimeter(b_05: float, d_v: float, d_out: float, eta_c: float) -> float:
    """Return b_0.5,out [m], where links are needed no more (8.112); d_out is d_v,out of the outermost links [m]."""
    return b_05 * (d_v / (d_out * eta_c)) ** 2
