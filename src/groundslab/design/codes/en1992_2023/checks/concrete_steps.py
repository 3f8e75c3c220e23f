"""What calculations of shear by EN 1992-1-1:2023 have in common: strength, partial factor, roughness, least stress."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2023 import shear
from groundslab.design.codes.en1992_2023.materials import FORMULAS, Concrete, Steel
from groundslab.design.rules.calculation import MEGA, Step


def design_strength(concrete: Concrete) -> Iterator[Step]:
    """Yield the steps to f_cd."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa", clause="Table 5.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="Table 4.3")
    yield Step("factor of the time of loading", "k_tc", concrete.k_tc, clause="5.1.6(1)")
    yield Step("factor of strong concrete", "eta_cc", concrete.eta_cc, "", FORMULAS["eta_cc"], "5.1.6(1), 5.4")
    yield Step("design strength", "f_cd", concrete.f_cd / MEGA, "MPa", FORMULAS["f_cd"], "5.1.6(1), 5.3")


def in_shear(concrete: Concrete, steel: Steel, d: float, depth: str = "d") -> Iterator[Step]:
    """Yield the steps to tau_Rdc,min for an effective depth [m] that is called d or d_v."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa", clause="Table 5.1")
    yield Step("partial factor of shear", "gamma_V", concrete.gamma_v, clause="Table 4.3")
    yield Step("least size of the coarsest aggregates", "D_lower", concrete.d_lower * 1e3, "mm", clause="8.2.1(4)")
    formula = FORMULAS["d_dg" if concrete.through == 1 else "d_dg, high strength"]
    yield Step("roughness of cracks", "d_dg", concrete.d_dg * 1e3, "mm", formula, "8.2.1(4)")
    yield Step("design yield strength", "f_yd", steel.f_yd / MEGA, "MPa", clause="5.2.4, 5.11")
    least = float(shear.minimum_resistance(concrete, steel, d)) / MEGA
    formula = shear.FORMULAS["tau_min"].replace("1000 * d)", f"1000 * {depth})")
    yield Step("least resistance", "tau_min", least, "MPa", formula, "8.2.1(4), 8.20")
