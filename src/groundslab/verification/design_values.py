"""What rows of cases on design codes may ask for: a value by name, from the numbers that the row gives, all SI."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from groundslab.design.design_moments import wood_armer
from groundslab.design.en1992 import bending, cracking, punching, shear
from groundslab.design.en1992.materials import Concrete, Steel
from groundslab.design.floors import resistance, strips, yield_lines
from groundslab.design.floors.yield_lines import Location
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


def _punching_used(v_Ed: float, f_ck: float, d: float, rho: float) -> float:
    """Return v_Ed over v_Rd,c [%]."""
    return 100 * v_Ed / punching.resistance_without_links(Concrete(f_ck), d, rho)


def _meyerhof(P: float, area: float, l: float, location: Location, factor: float = 1.0) -> float:  # noqa: E741
    """Return M_p + M_n that a force needs on an area, times a factor of safety; its unit is that of the force."""
    return factor * P / yield_lines.meyerhof(1.0, math.sqrt(area / math.pi), l, location)


def _beside_aisle(stress: float, E: float, h: float, k: float) -> float:
    """Return the pressure beside the worst aisle that makes a stress."""
    return strips.aisle_load(stress * h**2 / 6, strips.characteristic(E, h, k))


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
    "v_Ed / v_Rd,c": (None, _punching_used),
    "v_Ed / v_Rd,max": (None, lambda v_Ed, f_ck: 100 * v_Ed / punching.max_resistance(Concrete(f_ck))),
    "k of Table 6.1": (None, punching.transfer_share),
    "l": ("length", yield_lines.relative_stiffness_radius),
    "lambda": (None, strips.characteristic),
    "M_un": ("force", lambda f_ck, h: resistance.plain_moment(Concrete(f_ck), h)),
    "M_p of a mesh": ("force", lambda area, d, f_yk: resistance.mesh_moment(area, d, Steel(f_yk))),
    "M_p + M_n by Meyerhof": (None, _meyerhof),
    "pressure beside an aisle": ("pressure", _beside_aisle),
    "repetitions": (None, resistance.allowed_repetitions),
    "f_ywd,ef": ("pressure", lambda d: punching.effective_strength(d, math.inf)),
}
for _name in ("bottom_x", "bottom_y", "top_x", "top_y"):
    VALUES[f"Wood and Armer, {_name.replace('_', ' ')}"] = "force", _design_moment(_name)
