"""Bearing resistance and sliding by EN 1997-1, annex D and 6.5.3, step by step, as they can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1997 import bearing
from groundslab.design.codes.en1997.bearing import FORMULAS, EffectiveArea, Soil
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.messages import Message
from groundslab.model.design.limits import SoilStrength

_D3, _D4 = "annex D.3", "annex D.4"
#: The factors of a drained soil in words, in the order of the calculation.
_FACTORS = {
    "N_q": "factor of the overburden", "N_c": "factor of the cohesion", "N_gamma": "factor of the weight",
    "s_q": "shape, of the overburden", "s_c": "shape, of the cohesion", "s_gamma": "shape, of the weight",
    "m": "exponent of the inclination", "i_q": "inclination, of the overburden", "i_c": "inclination, of the cohesion",
    "i_gamma": "inclination, of the weight",
}  # fmt: skip


def bearing_steps(strength: SoilStrength, base: EffectiveArea, soil: Soil, V: float, H: float) -> Iterator[Step]:
    """Yield the bearing resistance under V and H [N], of a base that does not slide before."""
    yield Step("vertical force on the ground", "V", V / MEGA, "MN")
    yield Step("horizontal force", "H", H / MEGA, "MN")
    yield from _base(base)
    yield Step("pressure of the soil next to the base", "q", soil.overburden / MEGA, "MPa")
    if soil.c_u is None:
        yield from _drained(strength, base, soil, V, H)
        formula, clause = FORMULAS["R"], _D4
    else:
        yield from _undrained_strength(strength, soil.c_u)
        s_c, i_c = bearing.undrained_factors(base, soil.c_u, H)
        yield Step("shape", "s_c", s_c, "", FORMULAS["s_c undrained"], _D3)
        yield Step("inclination", "i_c", i_c, "", FORMULAS["i_c undrained"], _D3)
        formula, clause = FORMULAS["R undrained"], _D3
    R = bearing.bearing_resistance(base, soil, V, H)
    yield Step("resistance", "R", R / MEGA, "MN", formula, clause)
    yield Step("partial factor of resistance", "gamma_Rv", strength.gamma_Rv, clause="2.4.7.3.4")
    R_d = R / strength.gamma_Rv
    yield Step("design resistance", "R_d", R_d / MEGA, "MN", "R / gamma_Rv", "2.4.7.3.3")
    yield Step("share used", "eta", V / R_d, "", "V / R_d", "6.5.2.1, 6.1")


def sliding_steps(
    strength: SoilStrength, base: EffectiveArea, c_u: float | None, delta: float, V: float, H: float
) -> Iterator[Step]:
    """Yield the resistance against sliding under V and H [N], delta [rad] being the design angle of friction."""
    yield Step("vertical force on the ground", "V", V / MEGA, "MN")
    yield Step("horizontal force", "H", H / MEGA, "MN")
    if c_u is None:
        yield from _angle("friction under the base", "delta", strength.sliding_angle, strength.gamma_phi, delta)
        formula, clause = FORMULAS["sliding"], "6.5.3(8), 6.3a"
    else:
        yield from _area(base)
        yield from _undrained_strength(strength, c_u)
        formula, clause = FORMULAS["sliding undrained"], "6.5.3(11), 6.4a, 6.5"
    yield Step("partial factor of resistance", "gamma_Rh", strength.gamma_Rh, clause="2.4.7.3.4")
    R_d = bearing.sliding_resistance(base, c_u, delta, V, strength.gamma_Rh)
    yield Step("design resistance", "R_d", R_d / MEGA, "MN", formula, clause)
    yield Step("share used", "eta", H / R_d, "", "H / R_d", "6.5.3(2), 6.2")


def _base(base: EffectiveArea) -> Iterator[Step]:
    """Yield the effective area and its sides."""
    yield from _area(base)
    yield Step("its shorter side", "B'", base.width, "m", clause="annex D.2")
    yield Step("its longer side", "L'", base.length, "m", "A' / B'", "annex D.2")


def _area(base: EffectiveArea) -> Iterator[Step]:
    """Yield the effective area, and what openings take off it, if there are any."""
    if not base.openings:
        yield Step("effective area about the resultant", "A'", base.area, "m2", clause="annex D.2")
        return
    whole = base.area + base.openings
    yield Step("effective area about the resultant, openings filled", "A_f", whole, "m2", clause="annex D.2")
    words = "openings inside it, and their images about the resultant"
    yield Step(words, "A_o", base.openings, "m2", clause="annex D.2")
    yield Step("effective area", "A'", base.area, "m2", "A_f - A_o", "annex D.2")


def _angle(words: str, symbol: str, degrees: float, factor: float, design: float) -> Iterator[Step]:
    """Yield an angle of friction [degrees], its partial factor, and the design angle [rad]."""
    yield Step(Message("angle of {text}", text=words), f"{symbol}_k", degrees, "degrees")
    yield Step("partial factor of its tangent", "gamma_phi", factor, clause="2.4.6.2")
    formula = f"atan(tan({symbol}_k * pi / 180) / gamma_phi)"
    yield Step("design angle", symbol, design, "rad", formula, "2.4.6.2")


def _undrained_strength(strength: SoilStrength, c_u: float) -> Iterator[Step]:
    """Yield the design value of the undrained shear strength [Pa]."""
    yield Step("undrained shear strength", "c_uk", (strength.c_u or 0.0) / MEGA, "MPa")
    yield Step("its partial factor", "gamma_cu", strength.gamma_cu, clause="2.4.6.2")
    yield Step("its design value", "c_u", c_u / MEGA, "MPa", "c_uk / gamma_cu", "2.4.6.2")


def _drained(strength: SoilStrength, base: EffectiveArea, soil: Soil, V: float, H: float) -> Iterator[Step]:
    """Yield strength and factors of a drained soil."""
    yield from _angle("shearing resistance", "phi", strength.phi or 0.0, strength.gamma_phi, soil.phi)
    yield Step("effective cohesion", "c_k", strength.c / MEGA, "MPa")
    yield Step("its partial factor", "gamma_c", strength.gamma_c, clause="2.4.6.2")
    yield Step("its design value", "c", soil.c / MEGA, "MPa", "c_k / gamma_c", "2.4.6.2")
    yield Step("effective unit weight below the base", "gamma", soil.unit_weight / MEGA, "MN/m3")
    factors = bearing.drained_factors(base, soil, V, H)
    for symbol, words in _FACTORS.items():
        yield Step(words, symbol, getattr(factors, symbol), "", FORMULAS[symbol], _D4)
