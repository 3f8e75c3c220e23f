"""What rows of cases on design codes may ask for: a value by name, from the numbers that the row gives, all SI."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from groundslab.design.design_moments import wood_armer
from groundslab.design.en1992 import bending, cracking, punching, shear
from groundslab.design.en1992.materials import Concrete, Steel
from groundslab.fem.concrete import cracked_section
from groundslab.model.loads.en1990 import make_combinations
from groundslab.model.loads.load_cases import Combine, LimitState, LoadCase

_D = 0.4  # m: of ratios that do not depend on it


def _lever_arm(K: float, f_ck: float, f_yk: float, alpha_cc: float) -> float:
    """Return z / d for m = K d^2 f_ck, from the area of bars that the moment needs."""
    steel, m = Steel(f_yk), K * f_ck * _D**2
    area = bending.required(np.array([m]), _D, Concrete(f_ck, alpha_cc=alpha_cc), steel, xi_lim=0.6).tension[0]
    return float(m / (area * steel.f_yd) / _D)


def _least_ratio(f_ck: float, f_yk: float) -> float:
    """Return the least ratio of bars in tension [%]."""
    return float(bending.minimum(np.array(_D), Concrete(f_ck), Steel(f_yk)) / _D * 100)


def _without_links(f_ck: float, d: float, rho: float) -> float:
    """Return v_Rd,c / d of one-way shear."""
    return float(shear.resistance_without_links(Concrete(f_ck), np.array([d]), np.array([rho]))[0] / d)


def _links(v: float, z: float, f_ck: float, f_yk: float) -> float:
    """Return links per area of the plan [%] for a shear force per width v with the lever arm z."""
    links = shear.required_links(np.array([v]), np.array([z / shear.LEVER]), Concrete(f_ck), Steel(f_yk))
    return float(links.area[0]) * 100


def _crack(what: str) -> Callable[..., float]:
    """Return what finds a figure of a crack, of bars with an effective depth of concrete in tension."""

    def find(
        diameter: float, spacing: float, cover: float, area: float, depth: float, sigma_s: float, f_ck: float
    ) -> float:
        rho, concrete, steel = np.array([area / depth]), Concrete(f_ck), Steel(500e6)
        bars = cracking.Bars(diameter, spacing, cover)
        s_r = float(cracking.largest_spacing(bars, np.array([1.0]), np.array([0.0]), rho)[0])
        strain = float(cracking.mean_strain(np.array([sigma_s]), rho, concrete, steel)[0])
        return {"spacing": s_r, "strain": strain, "width": s_r * strain}[what]

    return find


def _section(what: str) -> Callable[..., float]:
    """Return what finds a figure of a section of width b with bars at the bottom, I in 1e6 mm4, M_cr at 1 MPa."""

    def find(b: float, h: float, area: float, distance: float, n: float, M: float = 0.0) -> float:
        bars = cracked_section.Bars((area / b, 0.0), (distance, distance))
        thickness, ratio = np.array([h]), np.array([n])
        z, I_I, _ = (float(each[0]) for each in cracked_section.uncracked_section(thickness, bars, ratio))
        x, I_II, _ = (float(each[0]) for each in cracked_section.cracked_section(thickness, bars, ratio, top=False))
        found = {"z": z, "I_I": b * I_I * 1e6, "M_cr": b * I_I / (h - z) * 1e6, "x": x, "I_II": b * I_II * 1e6}
        return (found | {"sigma_s": n * M / b * (h - distance - x) / I_II})[what]

    return find


def _punching_used(v_Ed: float, f_ck: float, d: float, rho: float) -> float:
    """Return v_Ed over v_Rd,c [%]."""
    return 100 * v_Ed / punching.resistance_without_links(Concrete(f_ck), d, rho)


def _design_moment(name: str) -> Callable[..., float]:
    """Return what finds a design moment of Wood and Armer."""

    def find(m_x: float, m_y: float, m_xy: float) -> float:
        return float(getattr(wood_armer(*(np.array([moment]) for moment in (m_x, m_y, m_xy))), name)[0])

    return find


def _effect(
    permanent: Mapping[str, float],
    variable: Mapping[str, Sequence[float]],
    limit_state: LimitState,
    least: bool = False,
    rare: float = 0.0,
    **rules: Any,
) -> float:
    """Return the largest effect over combinations by EN 1990, or the least; of variable cases effect and psi 0 to 2.

    `rare` is the effect of the accidental or seismic action.
    """
    cases = [LoadCase(name=name) for name in permanent]
    if limit_state in ("accidental", "seismic"):
        cases.append(LoadCase(name="rare", action=limit_state))
    for name, (_, *psi) in variable.items():
        factors = dict(zip(("psi_0", "psi_1", "psi_2"), psi, strict=True))
        cases.append(LoadCase(name=name, action="variable", **factors))
    effects = {**permanent, "rare": rare, **{name: effect for name, (effect, *_) in variable.items()}}
    made = make_combinations(Combine(sets=(limit_state,), **rules), cases)
    sums = [sum(factor * effects[name] for name, factor in each.factors) for each in made]
    return min(sums) if least else max(sums)


#: By name: the dimension of the value's unit, and how it is found.
VALUES: dict[str, tuple[str | None, Callable[..., float]]] = {
    "effect": (None, _effect),
    "f_ctm": ("pressure", lambda f_ck: Concrete(f_ck).f_ctm),
    "E_cm": ("pressure", lambda f_ck: Concrete(f_ck).E_cm),
    "eps_cu3": (None, lambda f_ck: Concrete(f_ck).eps_cu3 * 1e3),
    "z / d": (None, _lever_arm),
    "least bars": (None, _least_ratio),
    "v_Rd,c / d": ("pressure", _without_links),
    "links": (None, _links),
    "s_r,max": ("length", _crack("spacing")),
    "eps_sm - eps_cm": (None, _crack("strain")),
    "w_k": ("length", _crack("width")),
    "z of a section": ("length", _section("z")),
    "I_I of a section": (None, _section("I_I")),
    "M_cr of a section": ("moment", _section("M_cr")),
    "x of a section": ("length", _section("x")),
    "I_II of a section": (None, _section("I_II")),
    "sigma_s of a section": ("pressure", _section("sigma_s")),
    "v_Ed / v_Rd,c": (None, _punching_used),
    "v_Ed / v_Rd,max": (None, lambda v_Ed, f_ck: 100 * v_Ed / punching.max_resistance(Concrete(f_ck))),
    "k of Table 6.1": (None, punching.transfer_share),
    "f_ywd,ef": ("pressure", lambda d: punching.effective_strength(d, math.inf)),
}
for _name in ("bottom_x", "bottom_y", "top_x", "top_y"):
    VALUES[f"Wood and Armer, {_name.replace('_', ' ')}"] = "force", _design_moment(_name)
