"""What rows of cases on design codes may ask for: a value by name, from the numbers that the row gives, all SI."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318 import bending as aci_bending
from groundslab.design.codes.aci318 import development
from groundslab.design.codes.aci318 import punching as aci_punching
from groundslab.design.codes.aci318 import shear as aci_shear
from groundslab.design.codes.aci318.materials import PHI_BENDING, PHI_SHEAR
from groundslab.design.codes.aci318.materials import Concrete as AciConcrete
from groundslab.design.codes.aci318.materials import Steel as AciSteel
from groundslab.design.codes.en1992_2004 import anchorage, bending, cracking, punching, shear
from groundslab.design.codes.en1992_2004.annex import annex_of
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.floors import resistance, strips, yield_lines
from groundslab.design.codes.floors.yield_lines import Location
from groundslab.design.demands.design_moments import wood_armer
from groundslab.fem import cracked_section
from groundslab.model.loads.en1990 import make_combinations
from groundslab.model.loads.load_cases import Combine, LimitState, LoadCase
from groundslab.verification.design_values.second_generation import VALUES_2023

_D = 0.4  # m: of ratios that do not depend on it


def _lever_arm(K: float, f_ck: float, f_yk: float, alpha_cc: float) -> float:
    """Return z / d for m = K d^2 f_ck, from the area of bars that the moment needs."""
    steel, m = Steel(f_yk), K * f_ck * _D**2
    area = bending.required(np.array([m]), _D, Concrete(f_ck, alpha_cc=alpha_cc), steel, xi_lim=0.6).tension[0]
    return float(m / (area * steel.f_yd) / _D)


def _least_ratio(f_ck: float, f_yk: float) -> float:
    """Return the least ratio of bars in tension [%]."""
    return float(bending.minimum(np.array(_D), concrete=Concrete(f_ck), steel=Steel(f_yk)) / _D * 100)


def _concrete(f_ck: float, annex: str) -> Concrete:
    """Return concrete with the factors and rules of an annex."""
    parameters = annex_of(annex)
    return Concrete(f_ck, parameters.gamma_c, parameters.alpha_cc, parameters)


def _without_links(f_ck: float, d: float, rho: float, annex: str = "recommended") -> float:
    """Return v_Rd,c / d of one-way shear."""
    return float(shear.resistance_without_links(_concrete(f_ck, annex), np.array([d]), np.array([rho]))[0] / d)


def _struts(v: float, z: float, f_ck: float, f_yk: float, annex: str = "recommended") -> shear.Links:
    """Return links and struts for a shear force per width v with the lever arm z."""
    d = np.array([z / shear.LEVER])
    return shear.required_links(np.array([v]), d, _concrete(f_ck, annex), Steel(f_yk), cover=0.0)


def _links(**arguments: Any) -> float:
    """Return links per area of the plan [%], see _struts."""
    return float(_struts(**arguments).area[0]) * 100


def _crack(what: str) -> Callable[..., float]:
    """Return the function for a figure of a crack, of bars with an effective depth of concrete in tension."""

    def find(
        diameter: float, spacing: float, cover: float, area: float, depth: float, sigma_s: float, f_ck: float
    ) -> float:
        rho, concrete, steel = np.array([area / depth]), Concrete(f_ck), Steel(500e6)
        bars = cracking.Bars(diameter, spacing, cover)
        s_r = float(cracking.largest_spacing(bars, np.array([1.0]), np.array([0.0]), rho)[0])
        strain = float(cracking.mean_strain(np.array([sigma_s]), rho, concrete, steel)[0])
        return {"spacing": s_r, "strain": strain, "width": s_r * strain}[what]

    return find


def _anchorage(diameter: float, f_ck: float, c_d: float, *, good: bool = True, lap: bool = False) -> float:
    """Return l_bd or l_0 [mm] of bars of 500 MPa."""
    find = anchorage.lap_length if lap else anchorage.anchorage_length
    return find(Concrete(f_ck), Steel(500e6), diameter, c_d, good) * 1e3


def _tens_up(**arguments: Any) -> float:
    """Return l_bd or l_0 [mm] rounded up to 10 mm, see _anchorage."""
    return math.ceil(_anchorage(**arguments) / 10 - 1e-9) * 10.0


def _development(diameter: float, f_c: float, f_y: float, below: float, *, splice: bool = False) -> float:
    """Return l_d or a class B splice [mm] by ACI 318 of bars far apart with enough cover."""
    find = development.splice_length if splice else development.development_length
    return find(AciConcrete(f_c), AciSteel(f_y), diameter, cover=0.1, clear=0.2, below=below) * 1e3


def _aci_ratio(R: float, f_c: float, f_y: float) -> float:
    """Return the ratio of bars [%] for R = M_u / (phi b d^2) by ACI 318."""
    m = np.array(PHI_BENDING * R * _D**2)
    return float(aci_bending.required(m, _D, AciConcrete(f_c), AciSteel(f_y)).tension / _D * 100)


def _aci_area(m: float, d: float, f_c: float, f_y: float) -> float:
    """Return the area of bars [m2/m] for a factored moment by ACI 318."""
    return float(aci_bending.required(np.array(m), d, AciConcrete(f_c), AciSteel(f_y)).tension)


def _aci_two_way(f_c: float, d: float, b_o: float, beta: float, alpha_s: float) -> float:
    """Return v_c [Pa] of two-way shear without size effect by ACI 318."""
    return aci_punching.without_links(AciConcrete(f_c, size_effect=False), d, b_o, beta, alpha_s)


def _edge_section(b_1: float, b_2: float) -> Array:
    """Return the three sides (3, 2, 2) of a critical section at an edge, b_1 along x, about their centroid."""
    x = b_1**2 / (2 * b_1 + b_2)  # from the inner side to the centroid
    corners = np.array([[x - b_1, -b_2 / 2], [x, -b_2 / 2], [x, b_2 / 2], [x - b_1, b_2 / 2]])
    return np.stack([corners[:-1], corners[1:]], axis=1)


def _aci_stress(b_1: float, b_2: float, d: float, V_u: float, M: float) -> float:
    """Return the largest v_u [Pa] of a critical section at an edge by ACI 318."""
    return aci_punching.stress(V_u, np.array([M, 0.0]), _edge_section(b_1, b_2), d)


def _section(what: str) -> Callable[..., float]:
    """Return the function for a figure of a section of width b with bottom bars, I in 1e6 mm4, M_cr at 1 MPa."""

    def find(b: float, h: float, area: float, distance: float, n: float, M: float = 0.0) -> float:
        bars = cracked_section.Bars((area / b, 0.0), (distance, distance))
        thickness, ratio = np.array([h]), np.array([n])
        z, I_I, _ = (float(value[0]) for value in cracked_section.uncracked_section(thickness, bars, ratio))
        x, I_II, _ = (float(value[0]) for value in cracked_section.cracked_section(thickness, bars, ratio, top=False))
        figures = {"z": z, "I_I": b * I_I * 1e6, "M_cr": b * I_I / (h - z) * 1e6, "x": x, "I_II": b * I_II * 1e6}
        return (figures | {"sigma_s": n * M / b * (h - distance - x) / I_II})[what]

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
    """Return the function for a design moment of Wood and Armer."""

    def find(m_x: float, m_y: float, m_xy: float) -> float:
        return float(getattr(wood_armer(*(np.array([moment]) for moment in (m_x, m_y, m_xy))), name)[0])

    return find


def _effect(
    permanent: Mapping[str, float],
    variable: Mapping[str, Sequence[float]],
    limit_state: LimitState,
    least: bool = False,
    rare: float = 0.0,
    category: Mapping[str, str] | None = None,
    **rules: Any,
) -> float:
    """Return the largest effect over combinations, or the least; of variable cases effect and psi 0 to 2 if any.

    `rare` is the effect of the accidental or seismic action, `category` that of variable cases; winds exclude each
    other.
    """
    cases = [LoadCase(name=name) for name in permanent]
    if limit_state in ("accidental", "seismic"):
        cases.append(LoadCase(name="rare", action=limit_state))
    for name, (_, *psi) in variable.items():
        factors = dict(zip(("psi_0", "psi_1", "psi_2"), psi, strict=True)) if psi else {}
        kind = (category or {}).get(name)
        group = "wind" if kind == "wind" else ""
        cases.append(LoadCase(name=name, action="variable", category=kind, group=group, **factors))
    effects = {**permanent, "rare": rare, **{name: effect for name, (effect, *_) in variable.items()}}
    combinations = make_combinations(Combine(sets=(limit_state,), **rules), cases)
    sums = [sum(factor * effects[name] for name, factor in combination.factors) for combination in combinations]
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
    "least bars for cracks": (
        None,
        lambda h, f_ck, f_yk: float(cracking.minimum_area(np.array(h), Concrete(f_ck), f_yk)) * 1e4,
    ),
    "z of a section": ("length", _section("z")),
    "I_I of a section": (None, _section("I_I")),
    "M_cr of a section": ("moment", _section("M_cr")),
    "x of a section": ("length", _section("x")),
    "I_II of a section": (None, _section("I_II")),
    "sigma_s of a section": ("pressure", _section("sigma_s")),
    "v_Ed / v_Rd,c": (None, _punching_used),
    "v_Rd,max": ("pressure", lambda f_ck, annex: punching.max_resistance(_concrete(f_ck, annex)) or 0.0),
    "strut": ("pressure", lambda f_ck, annex: _concrete(f_ck, annex).strut),
    "cot theta": (None, lambda **arguments: float(_struts(**arguments).cot_theta[0])),
    "rho by ACI 318": (None, _aci_ratio),
    "A_s by ACI 318": (None, _aci_area),
    "beta_1": (None, lambda f_c: AciConcrete(f_c).beta_1),
    "least bars by ACI 318": (None, lambda h: float(aci_bending.minimum(np.array(h), h))),
    "v_c by ACI 318": (None, _aci_two_way),
    "phi V_c by ACI 318": (None, lambda **of: PHI_SHEAR * _aci_two_way(**of) * of["b_o"] * of["d"]),
    "gamma_v": (None, aci_punching.gamma_v),
    "J_c": (None, lambda b_1, b_2, d: float(aci_punching.polar_moments(_edge_section(b_1, b_2), np.zeros(2), d)[0, 0])),
    "v_u by ACI 318": (None, _aci_stress),
    "lambda_s": (None, lambda d: AciConcrete(30e6).lambda_s(d)),
    "one-way v_c by ACI 318": (
        None,
        lambda f_c, d, rho: float(aci_shear.without_links(AciConcrete(f_c), np.array(d), np.array(rho))),
    ),
    "links by ACI 318": (None, lambda v_u, d, f_c, f_y: aci_shear.links(v_u, d, AciConcrete(f_c), AciSteel(f_y))),
    "v_Ed / v_Rd,max": (None, lambda v_Ed, f_ck: 100 * v_Ed / (punching.max_resistance(Concrete(f_ck)) or 0.0)),
    "k of Table 6.1": (None, punching.transfer_share),
    "l": ("length", yield_lines.relative_stiffness_radius),
    "lambda": (None, strips.characteristic),
    "M_un": ("force", lambda f_ck, h: resistance.plain_moment(Concrete(f_ck), h)),
    "M_p of a mesh": ("force", lambda area, d, f_yk: resistance.mesh_moment(area, d, Steel(f_yk))),
    "M_p + M_n by Meyerhof": (None, _meyerhof),
    "pressure beside an aisle": ("pressure", _beside_aisle),
    "repetitions": (None, resistance.allowed_repetitions),
    "l_bd or l_0": (None, _anchorage),
    "l_bd or l_0, rounded up": (None, _tens_up),
    "l_d by ACI 318": (None, _development),
    "f_ywd,ef": ("pressure", lambda d: punching.effective_strength(d, math.inf)),
}
VALUES |= VALUES_2023
for _name in ("bottom_x", "bottom_y", "top_x", "top_y"):
    VALUES[f"Wood and Armer, {_name.replace('_', ' ')}"] = "force", _design_moment(_name)
