"""Anchorage and laps of straight ribbed bars in tension by EN 1992-1-1 8.4 and 8.7.

    l_b,rqd = phi / 4 sigma_sd / f_bd                                             8.3
    f_bd    = 2.25 eta_1 eta_2 f_ctd,     f_ctd = f_ctk,0.05 / gamma_C            8.2, 3.16
    l_bd    = alpha_2 l_b,rqd >= max(0.3 l_b,rqd, 10 phi, 100 mm)                 8.4, 8.6
    l_0     = alpha_2 alpha_6 l_b,rqd >= max(0.3 alpha_6 l_b,rqd, 15 phi, 200 mm) 8.10, 8.11
    alpha_2 = 1 - 0.15 (c_d - phi) / phi, from 0.7 to 1                           Table 8.2

eta_1 = 0.7 in poor bond conditions (Figure 8.2), eta_2 = (132 - phi) / 100 of bars thicker than 32 mm, c_d the lesser
of the cover and half the clear distance of bars (Figure 8.3). alpha_1 = alpha_3 = alpha_5 = 1: straight bars, no
account of bars across and of pressure. f_ctk,0.05 = 0.7 f_ctm (Table 3.1) counts up to C60/75 (8.4.2(2)), alpha_ct = 1.
alpha_6 is that of laps of all bars in one section.
"""

from __future__ import annotations

from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.fem.cracked_section import mean_tensile_strength

_MPA = 1e6
#: The strength that counts for bond (8.4.2(2)), the share of f_ctm that f_ctk,0.05 has (Table 3.1).
MOST_BOND, CHARACTERISTIC = 60 * _MPA, 0.7
#: eta_1 of poor bond (8.4.2(2)).
POOR = 0.7
#: Bond is good in the lowest 250 mm, and 300 mm and more below the top of what is thicker than 600 mm (Figure 8.2).
LOW, FROM_TOP, DEEP = 0.250, 0.300, 0.600
#: What counts as rounding of a length [m].
ROUNDING = 1e-9


def good_bond(below: float, above: float) -> bool:
    """Return whether a bar with so much concrete [m] below and above its axis has good bond (Figure 8.2)."""
    return below <= LOW + ROUNDING or (below + above > DEEP + ROUNDING and above >= FROM_TOP - ROUNDING)


def bond_stress(concrete: Concrete, diameter: float, good: bool) -> float:
    """Return f_bd [Pa] of a bar [m] (formula 8.2)."""
    f_ctk = CHARACTERISTIC * mean_tensile_strength(min(concrete.f_ck, MOST_BOND))
    eta_2 = min(1.0, (132 - diameter * 1e3) / 100)
    return 2.25 * (1.0 if good else POOR) * eta_2 * f_ctk / concrete.gamma_c


def basic_length(concrete: Concrete, steel: Steel, diameter: float, good: bool) -> float:
    """Return l_b,rqd [m] of a bar [m] that is stressed by f_yd (formula 8.3)."""
    return diameter / 4 * steel.f_yd / bond_stress(concrete, diameter, good)


def cover_factor(concrete: Concrete, diameter: float, c_d: float) -> float:
    """Return alpha_2 of a straight bar in tension with a cover or half a distance c_d [m] (Table 8.2)."""
    if not concrete.annex.cover_relieves:
        return 1.0
    return min(1.0, max(0.7, 1 - 0.15 * (c_d - diameter) / diameter))


def anchorage_length(concrete: Concrete, steel: Steel, diameter: float, c_d: float, good: bool) -> float:
    """Return l_bd [m] of a straight bar [m] (formula 8.4), c_d [m] as in Figure 8.3."""
    basic = basic_length(concrete, steel, diameter, good)
    return max(cover_factor(concrete, diameter, c_d) * basic, 0.3 * basic, 10 * diameter, 0.100)


def lap_length(concrete: Concrete, steel: Steel, diameter: float, c_d: float, good: bool) -> float:
    """Return l_0 [m] of straight bars [m] that all lap in one section (formula 8.10)."""
    thin, thick = concrete.annex.lap
    alpha_6 = thin if diameter < THICK_LAP - ROUNDING else thick
    basic = basic_length(concrete, steel, diameter, good)
    lapped = cover_factor(concrete, diameter, c_d) * alpha_6 * basic
    return max(lapped, 0.3 * alpha_6 * basic, 15 * diameter, 0.200)


#: From this diameter [m] on annexes may ask for longer laps (DIN EN 1992-1-1/NA, Table 8.3DE).
THICK_LAP = 0.016
