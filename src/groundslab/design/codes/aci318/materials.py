"""Concrete and reinforcing steel by ACI 318-19, chapters 19 to 22, in SI units.

Normal-weight concrete, lambda = 1 (19.2.4), and deformed bars. The edition in inches and pounds and that in SI units,
ACI 318M-19, round the same rules differently: 2 (f'c)^(1/2) in psi is 0.166 (f'c)^(1/2) in MPa, for which 318M has
0.17. Coefficients and limits of strength are those of either edition that are on the safe side, with the digits that
keep them there (docs/howto/us_units.md lists both), so that a design holds by both, whatever units are shown.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from groundslab.errors import InputError, Issue

_MPA = 1e6
#: Strain of the compressed face at failure (22.2.2.1), modulus of steel [Pa] (20.2.2.2).
EPS_CU, E_S = 0.003, 200e9
#: Strength reduction factors of sections controlled by tension and of shear (21.2.1, 21.2.2).
PHI_BENDING, PHI_SHEAR = 0.9, 0.75
#: The largest (f'c)^(1/2) [MPa] that counts in shear (22.5.3.1, 22.6.3.1), and f_yt [Pa] of links (20.2.2.4).
MOST_ROOT, MOST_F_YT = 8.3, 413.6 * _MPA
#: The formulas of what counts in shear, with stresses in MPa and lengths in m.
FORMULAS = {"root": "min(8.3, sqrt(f_c'))", "lambda_s": "min(1, sqrt(2 / (1 + 0.004 * 1000 * d)))"}


@dataclass(frozen=True, slots=True)
class Concrete:
    """Concrete of a specified strength f'c [Pa] of at least 17 MPa (19.2.1.1).

    `size_effect` is whether lambda_s is counted in shear; 13.2.6.2 permits to neglect it in shallow foundations.
    """

    f_c: float
    size_effect: bool = True

    def __post_init__(self) -> None:
        """Refuse what the rules are not made for."""
        if not self.f_c >= 17 * _MPA:
            raise InputError([Issue("concrete.f_c", f"{self.f_c:g} Pa", "at least 17 MPa (ACI 318-19 19.2.1.1)")])

    @property
    def beta_1(self) -> float:
        """Return the depth of the stress block over that of the neutral axis, Table 22.2.2.4.3."""
        return min(0.85, max(0.65, 0.85 - 0.05 * (self.f_c / _MPA - 27.57) / 6.89))

    @property
    def root(self) -> float:
        """Return (f'c)^(1/2) [Pa] as it counts in shear."""
        return min(math.sqrt(self.f_c / _MPA), MOST_ROOT) * _MPA

    def lambda_s(self, d: float) -> float:
        """Return the size effect factor for a depth d [m], (2 / (1 + 0.004 d))^(1/2) <= 1, 22.5.5.1.3."""
        return min(1.0, math.sqrt(2 / (1 + 0.004 * d * 1e3))) if self.size_effect else 1.0


@dataclass(frozen=True, slots=True)
class Steel:
    """Deformed bars of a yield strength f_y [Pa]."""

    f_y: float

    @property
    def f_yt(self) -> float:
        """Return the strength of links [Pa]."""
        return min(self.f_y, MOST_F_YT)
