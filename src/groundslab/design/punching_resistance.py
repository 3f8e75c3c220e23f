"""Punching resistances by EN 1992-1-1 that no reinforcement can exceed, with the recommended national parameters.

    v_Rd,max = 0.4 nu f_cd, nu = 0.6 (1 - f_ck / 250)                       at the column's face, 6.4.5(3), 6.2.2(6)
    v_Rd,c   = C_Rd,c k (100 rho_l f_ck)^(1/3) >= 0.035 k^(3/2) f_ck^(1/2)  at 2 d, 6.4.4(1)

C_Rd,c = 0.18 / gamma_C and k = 1 + (200 / d)^(1/2) <= 2, f_ck in MPa and d in mm. With rho_l = 0.02, the most that
counts, v_Rd,c is an upper bound whatever the bars. With punching reinforcement a slab carries at most k_max = 1.5 times
as much (6.4.5(1) as amended in 2014, as is the factor 0.4).
"""

from __future__ import annotations

import math

from groundslab.design.reinforcement import Concrete

_MPA = 1e6
#: The largest ratio of bars that counts for v_Rd,c (6.4.4(1)).
MOST_BARS = 0.02
#: Times v_Rd,c that punching reinforcement makes of it at most (6.4.5(1)).
K_MAX = 1.5


def max_resistance(concrete: Concrete) -> float:
    """Return v_Rd,max [Pa]."""
    nu = 0.6 * (1 - concrete.f_ck / (250 * _MPA))
    return 0.4 * nu * concrete.f_cd


def resistance_without_links(concrete: Concrete, d: float, rho: float = MOST_BARS) -> float:
    """Return v_Rd,c [Pa] at 2 d for an effective depth d [m] and a ratio rho of bars."""
    f_ck, k = concrete.f_ck / _MPA, min(2.0, 1 + math.sqrt(200 / (1e3 * d)))
    of_bars = 0.18 / concrete.gamma_c * k * math.cbrt(100 * min(rho, MOST_BARS) * f_ck)
    return max(of_bars, 0.035 * k * math.sqrt(k * f_ck)) * _MPA
