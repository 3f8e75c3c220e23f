"""Punching by EN 1992-1-1 6.4 with the parameters of the concrete's annex: resistances, beta, links.

    v_Rd,max = 0.4 nu f_cd, nu = 0.6 (1 - f_ck / 250)                       at the column's face, 6.4.5(3), 6.2.2(6)
    v_Rd,c   = C_Rd,c k (100 rho_l f_ck)^(1/3) >= v_min k^(3/2) f_ck^(1/2)  at 2 d, 6.4.4(1)
    v_Rd     = v_Rd,c 2 d / a                                               at a <= 2 d, 6.4.4(2), 6.50
    beta     = 1 + k M_Ed u / (V_Ed,red W)                                  6.4.4(2), 6.51, k by Table 6.1
    v_Rd,cs  = 0.75 v_Rd,c + 1.5 (d / s_r) A_sw f_ywd,ef / (u_1 d)          6.4.5(1), 6.52, f_ywd,ef = 250 + 0.25 d

k = 1 + (200 / d)^(1/2) <= 2, f_ck in MPa and d in mm. With the largest ratio of bars that counts, 0.02 or less, v_Rd,c
is an upper bound whatever the bars. With punching reinforcement a slab carries at most k_max times as much. Recommended
are C_Rd,c = 0.18 / gamma_C, v_min = 0.035, and k_max = 1.5 (6.4.5(1) as amended in 2014, as is the factor 0.4).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.shear import THICK, THIN

_MPA = 1e6
#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "k": "min(2, 1 + sqrt(200 / (1000 * d)))",
    "v_Rd,c": "max(C / gamma_C * k * (100 * rho_l * f_ck)^(1/3), v_min * k^(3/2) * f_ck^(1/2))",
    "k_n": "max(0.45, min(0.3 + 0.3 * c_n / c_m, 0.5 + 0.1 * c_n / c_m, 0.8))",
    "c_r": "max(c_1 / c_2, c_2 / c_1) / 2",
    "k_e": "max(0.45, min(0.3 + 0.3 * c_r, 0.5 + 0.1 * c_r, 0.8))",
    "beta": "1 + sqrt((k_1 * M_1 * u / (V_Ed * W_1))^2 + (k_2 * M_2 * u / (V_Ed * W_2))^2)",
    "beta at an edge": "1 / s + k_e * abs(M_1) * u / (V_Ed * W_1)",
    "v_Ed": "beta * V_Ed / (u * d)",
    "v_Ed by M": "(V_Ed + sqrt((k_1 * M_1 * u / W_1)^2 + (k_2 * M_2 * u / W_2)^2)) / (u * d)",
    "v_Rd": "v_Rd,c * 2 * d / a",
    "A_sw": "(v_Ed - 0.75 * v_Rd) * u * d / (n_s * f_ywd,ef) * 10000",
    "n_s": "min(1.5 * d / s_r, max(1, 1 + floor((a - a_F) / s_r + 0.000001)))",
    "v_Rd,cs": "0.75 * v_Rd + n_s * A_sw / 10000 * f_ywd,ef / (u * d)",
    "v_Rd,cs alone": "A_sw / 10000 * f_ywd,ef / (u * d)",
    "A_sw alone": "v_Ed * u * d / f_ywd,ef * 10000",
    "u_out": "v_l * u_l / v_Rd,c",
    "f_ywd,ef": "min(250 + 0.25 * 1000 * d, f_ywd)",
}
#: The largest ratio of bars that counts for v_Rd,c (6.4.4(1)).
MOST_BARS = 0.02
#: Links per area over f_ck^(1/2) / f_yk, at least (formula 9.11).
LEAST_LEG = 0.08


def max_resistance(concrete: Concrete) -> float | None:
    """Return v_Rd,max [Pa] at the column's face, None where the annex has no such check."""
    return concrete.annex.face * concrete.strut if concrete.annex.face else None


def most_bars(concrete: Concrete, steel: Steel) -> float:
    """Return the largest ratio of bars that counts (6.4.4(1))."""
    return min(MOST_BARS, concrete.annex.rho_strength * concrete.f_cd / steel.f_yd)


def resistance_without_links(concrete: Concrete, d: float, rho: float = MOST_BARS) -> float:
    """Return v_Rd,c [Pa] at 2 d for an effective depth d [m] and a ratio rho of bars."""
    f_ck, k = concrete.f_ck_shear / _MPA, size_factor(d)
    of_bars = concrete.annex.c_rd_c_punching / concrete.gamma_c * k * math.cbrt(100 * min(rho, MOST_BARS) * f_ck)
    return max(of_bars, least_factor(concrete, d) * k * math.sqrt(k * f_ck)) * _MPA


def required_ratio(concrete: Concrete, d: float, v: float) -> float:
    """Return the ratio rho of bars for which v_Rd,c is v [Pa], for an effective depth d [m]; 0 if none are needed."""
    if v <= resistance_without_links(concrete, d, 0.0):
        return 0.0
    of_one = concrete.annex.c_rd_c_punching / concrete.gamma_c * size_factor(d) * math.cbrt(concrete.f_ck_shear / _MPA)
    return (v / _MPA / of_one) ** 3 / 100


def size_factor(d: float) -> float:
    """Return k of an effective depth d [m] (6.4.4(1))."""
    return min(2.0, 1 + math.sqrt(200 / (1e3 * d)))


def least_factor(concrete: Concrete, d: float) -> float:
    """Return v_min over k^(3/2) f_ck^(1/2) [MPa] for an effective depth d [m] (6.3N)."""
    return float(np.interp(d, [THIN, THICK], concrete.v_min_factor))


def transfer_share(ratio: float) -> float:
    """Return k of Table 6.1: the share of a moment that shear transfers, by c_1 / c_2 of the column."""
    return float(np.interp(ratio, [0.5, 1.0, 2.0, 3.0], [0.45, 0.6, 0.7, 0.8]))


def edge_ratio(c_1: float, c_2: float) -> float:
    """Return what takes the place of c_1 / c_2 in Table 6.1 at an edge (6.4.3(4)): c_1 / (2 c_2) of its sides [m].

    c_1 is the side across the edge as in Figure 6.20a, or the one along the moment as in Table 6.1: the larger counts.
    """
    return max(c_1 / c_2, c_2 / c_1) / 2


#: beta of a column at a corner (Figure 6.21N), the same in all annexes here.
CORNER = 1.5


def raised(moments: Sequence[float], shares: Sequence[float], force: float, u: float, W: Sequence[float]) -> float:
    """Return beta times a force [N] by 6.39 or 6.51, with moments about two axes [N m], u [m] and W [m2] about them.

    The two add up by the root of their squares, as in 6.43.
    """
    return force + math.hypot(*(k * M * u / modulus for M, k, modulus in zip(moments, shares, W, strict=True)))


def raised_at_an_edge(reduced: float, moment: float, share: float, force: float, u: float, W: float) -> float:
    """Return beta times the force [N] of a column at an edge by 6.44: `reduced` is u_1* / u_1.

    The moment [N m] is that along the edge; the force's distance from the perimeter across it is in u_1* (6.4.3(4)).
    """
    return force / reduced + share * abs(moment) * u / W


def links_that_count(a: float, first: float, s_r: float, d: float) -> float:
    """Return how many perimeters of links a section a [m] from the face counts on, the first one nearer to it.

    6.52 counts on 1.5 d / s_r; of a section closer than 2 d, as footings have, not more than lie within it.
    """
    within = 1 + math.floor((a - first) / s_r + 1e-6)
    return min(1.5 * d / s_r, float(max(1, within)))


def resistance_with_links(v_Rd_c: float, A_sw: float, count: float, u: float, d: float, f_ywd: float) -> float:
    """Return v_Rd,cs [Pa] with a count of perimeters of vertical links, A_sw [m2] each, by 6.52; f_ywd [Pa] at most."""
    return 0.75 * v_Rd_c + count * A_sw * effective_strength(d, f_ywd) / (u * d)


def links_per_perimeter(v_Ed: float, v_Rd_c: float, u: float, d: float, count: float, f_ywd: float) -> float:
    """Return A_sw [m2] of each of the perimeters of vertical links that count, by 6.52; f_ywd [Pa] at most."""
    return max(0.0, (v_Ed - 0.75 * v_Rd_c) * u * d / (count * effective_strength(d, f_ywd)))


def links_alone(force: float, d: float, f_ywd: float) -> float:
    """Return A_sw [m2] of the two inner rows of vertical links together that carry a force beta V_Ed,red [N] alone.

    By DIN EN 1992-1-1/NA, 6.4.5(1), for foundations: A_sw,1+2 f_ywd,ef >= beta V_Ed,red.
    """
    return force / effective_strength(d, f_ywd)


def effective_strength(d: float, f_ywd: float) -> float:
    """Return f_ywd,ef [Pa] of links in a slab of effective depth d [m], f_ywd [Pa] at most (6.4.5(1))."""
    return min((250 + 0.25 * d * 1e3) * _MPA, f_ywd)


def widest_legs(leg: float, s_r: float, concrete: Concrete, steel: Steel) -> float:
    """Return the largest distance s_t [m] of vertical legs of an area [m2] along perimeters s_r [m] apart, by 9.11.

    1.5 A_sw,min / (s_r s_t) >= 0.08 f_ck^(1/2) / f_yk
    """
    return 1.5 * leg * steel.f_yk / (LEAST_LEG * math.sqrt(concrete.f_ck / _MPA) * _MPA * s_r)


def outer_perimeter(v_Ed: float, v_Rd_c: float, u: float) -> float:
    """Return u_out [m], where links are needed no more, by 6.54: beta V_Ed / (v_Rd,c d)."""
    return v_Ed * u / v_Rd_c
