"""Concrete by EN 1992-1-1:2023 5.1, and the roughness of cracks, 8.2.1(4). Steel is as in the first generation.

    f_cd = eta_cc k_tc f_ck / gamma_C,  eta_cc = (40 / f_ck)^(1/3) <= 1                            5.3, 5.4
    f_cm = f_ck + 8,  f_ctm = 0.3 f_ck^(2/3), above 50 MPa 1.1 f_ck^(1/3)                          Table 5.1
    E_cm = k_E f_cm^(1/3)                                                                          5.1
    d_dg = 16 + D_lower <= 40, above 60 MPa 16 + D_lower (60 / f_ck)^2 <= 40                       8.2.1(4)

f_ck in MPa, d_dg and D_lower in mm: D_lower is the smallest upper sieve size of the coarsest aggregates that the
concrete's specification allows. Concrete with less than 8 mm is beyond the standard (1.1(3)).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from groundslab.design.codes.en1992_2023.annex import RECOMMENDED, Annex
from groundslab.design.codes.eurocode2.materials import Steel, not_positive, outside
from groundslab.errors import InputError, Issue

__all__ = ["EPS_C2", "EPS_CU", "Concrete", "Steel"]

_MPA, _MM = 1e6, 1e3
#: Strains of the parabola-rectangle diagram: where its stress is full, and where the face fails (8.1.2(1), 8.4).
EPS_C2, EPS_CU = 2.0e-3, 3.5e-3
#: The formulas of the properties here, with stresses in MPa and lengths in mm.
FORMULAS = {
    "eta_cc": "min(1, (40 / f_ck)^(1/3))",
    "f_cd": "eta_cc * k_tc * f_ck / gamma_C",
    "d_dg": "min(40, 16 + D_lower)",
    "d_dg, high strength": "min(40, 16 + D_lower * (60 / f_ck)^2)",
}
#: Strength [MPa] above which cracks run through aggregates, and D_lower [m] that the standard has at least.
SMOOTH, LEAST_AGGREGATE = 60.0, 0.008


@dataclass(frozen=True, slots=True)
class Concrete:
    """Concrete: f_ck [Pa] from 12 to 90 MPa, gamma_C, gamma_V, k_tc and D_lower [m]; the annex's other parameters."""

    f_ck: float
    gamma_c: float = RECOMMENDED.gamma_c
    gamma_v: float = RECOMMENDED.gamma_v
    k_tc: float = RECOMMENDED.k_tc
    d_lower: float = 0.016
    annex: Annex = RECOMMENDED

    def __post_init__(self) -> None:
        """Refuse what the rules are not made for."""
        issues = outside("concrete.f_ck", self.f_ck, 12 * _MPA, 90 * _MPA)
        issues += not_positive(
            **{"concrete.gamma_c": self.gamma_c, "concrete.gamma_v": self.gamma_v, "concrete.k_tc": self.k_tc}
        )
        if not self.d_lower >= LEAST_AGGREGATE:
            issues.append(Issue("concrete.d_lower", f"{self.d_lower:g} m", "aggregates of 8 mm or more, in m"))
        if issues:
            raise InputError(issues)

    @property
    def eta_cc(self) -> float:
        """Return how much of the strength of cylinders members have, 5.1.6(1), 5.4."""
        return min(1.0, math.cbrt(40 / (self.f_ck / _MPA)))

    @property
    def f_cd(self) -> float:
        """Return the design strength [Pa], 5.1.6(1), 5.3."""
        return self.eta_cc * self.k_tc * self.f_ck / self.gamma_c

    @property
    def strut(self) -> float:
        """Return nu f_cd [Pa], the strength of concrete with shear cracks, 8.2.3(6), 8.44."""
        return self.annex.nu * self.f_cd

    @property
    def f_ctm(self) -> float:
        """Return the mean tensile strength [Pa], Table 5.1."""
        f_ck = self.f_ck / _MPA
        return (0.3 * f_ck ** (2 / 3) if f_ck <= 50 else 1.1 * math.cbrt(f_ck)) * _MPA

    @property
    def E_cm(self) -> float:
        """Return the secant modulus [Pa], 5.1."""
        return self.annex.k_e * math.cbrt(self.f_ck / _MPA + 8) * _MPA

    @property
    def d_dg(self) -> float:
        """Return the roughness of cracks in shear [m], 8.2.1(4)."""
        return min(40.0, 16 + self.d_lower * _MM * self.through) / _MM

    @property
    def through(self) -> float:
        """Return the share of D_lower that counts: in strong concrete cracks run through aggregates, 8.2.1(4)."""
        f_ck = self.f_ck / _MPA
        return 1.0 if f_ck <= SMOOTH else (SMOOTH / f_ck) ** 2
