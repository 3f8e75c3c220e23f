"""Concrete and reinforcing steel by EN 1992-1-1 3.1 and 3.2: by class or by strength.

Strength classes are those of Table 3.1, C12/15 to C90/105, the second number being that of cubes, and C28/35 and
C32/40 of BS 8500-1; steel is called by its yield strength and, as in Annex C, by its class of ductility: B500B.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from groundslab.design.codes.en1992_2004.annex import RECOMMENDED, Annex
from groundslab.design.codes.eurocode2.materials import CONCRETE_CLASSES, STEEL_CLASSES, Steel, not_positive, outside
from groundslab.errors import InputError
from groundslab.fem.cracked_section import mean_tensile_strength

__all__ = ["CONCRETE_CLASSES", "STEEL_CLASSES", "Concrete", "Steel"]

_MPA = 1e6


@dataclass(frozen=True, slots=True)
class Concrete:
    """Concrete: f_ck [Pa] from 12 to 90 MPa, gamma_c and alpha_cc (EN 1992-1-1 Table 3.1, 2.4.2.4, 3.1.6(1)).

    The annex has the national parameters of the rules for members of this concrete.
    """

    f_ck: float
    gamma_c: float = 1.5
    alpha_cc: float = 1.0
    annex: Annex = RECOMMENDED

    def __post_init__(self) -> None:
        """Refuse what the rules are not made for."""
        issues = outside("concrete.f_ck", self.f_ck, 12 * _MPA, 90 * _MPA)
        issues += not_positive(**{"concrete.gamma_c": self.gamma_c, "concrete.alpha_cc": self.alpha_cc})
        if issues:
            raise InputError(issues)

    @property
    def f_cd(self) -> float:
        """Return the design strength [Pa], 3.1.6(1)."""
        return self.alpha_cc * self.f_ck / self.gamma_c

    @property
    def strut(self) -> float:
        """Return nu f_cd [Pa], the strength of concrete with shear cracks: 6.2.2(6), 6.2.3(3)."""
        a, b, c = self.annex.nu
        f_ck = self.f_ck_shear
        return a * min(1.0, b - f_ck / (c * _MPA)) * self.alpha_cc_shear * f_ck / self.gamma_c

    @property
    def f_ck_shear(self) -> float:
        """Return f_ck [Pa] in shear and punching, which annexes bound."""
        return min(self.f_ck, self.annex.most_f_ck_shear * _MPA)

    @property
    def alpha_cc_shear(self) -> float:
        """Return alpha_cc of struts: that of the annex, unless another alpha_cc than the annex's is given."""
        return self.annex.alpha_cc_shear if self.alpha_cc == self.annex.alpha_cc else self.alpha_cc

    @property
    def v_min_factor(self) -> tuple[float, float]:
        """Return the factors of k^(3/2) f_ck^(1/2) [MPa] of thin and of thick members in the least v_Rd,c, 6.3N."""
        thin, thick = self.annex.v_min
        by = self.gamma_c if self.annex.v_min_factored else 1.0
        return thin / by, thick / by

    @property
    def eta(self) -> float:
        """Return the stress of the block over f_cd, 3.1.7(3)."""
        return 1.0 - max(self.f_ck / _MPA - 50, 0.0) / 200

    @property
    def lam(self) -> float:
        """Return the depth lambda of the block over x, 3.1.7(3)."""
        return 0.8 - max(self.f_ck / _MPA - 50, 0.0) / 400

    @property
    def eps_cu3(self) -> float:
        """Return the strain at which the compressed face fails, Table 3.1."""
        f = self.f_ck / _MPA
        return 3.5e-3 if f <= 50 else (2.6 + 35 * ((90 - f) / 100) ** 4) * 1e-3

    @property
    def f_cm(self) -> float:
        """Return the mean compressive strength [Pa], Table 3.1."""
        return self.f_ck + 8 * _MPA

    @property
    def E_cm(self) -> float:
        """Return the secant modulus [Pa] of concrete with quartzite aggregates, Table 3.1."""
        return 22e9 * math.pow(self.f_cm / (10 * _MPA), 0.3)

    @property
    def f_ct_least(self) -> float:
        """Return f_ct,eff [Pa] of the least bars that control cracks: f_ctm, or what the annex asks for, 7.3.2(2)."""
        return max(self.f_ctm, self.annex.least_f_ct * _MPA)

    @property
    def f_ctm(self) -> float:
        """Return the mean tensile strength [Pa], Table 3.1."""
        return mean_tensile_strength(self.f_ck)
