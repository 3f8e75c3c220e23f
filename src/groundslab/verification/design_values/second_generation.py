"""What rows of cases on EN 1992-1-1:2023 may ask for: a value by name, from the numbers that the row gives, all SI."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from groundslab.design.codes.en1992_2023 import bending, cracking, punching, shear
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.design.codes.eurocode2.struts import LEVER, Links
from groundslab.design.demands.design_moments import principal_shear, ratio_along
from groundslab.design.demands.line_properties import Shape


def _without_links(f_ck: float, d: float, rho: float, f_yk: float = 500e6, d_lower: float = 0.016) -> float:
    """Return v_Rd,c [N/m]."""
    concrete = Concrete(f_ck, d_lower=d_lower)
    return float(shear.resistance_without_links(concrete, Steel(f_yk), np.array(d), np.array(rho)))


def _struts(v: float, z: float, f_ck: float, f_yk: float) -> Links:
    """Return links and struts for a shear force per width v with the lever arm z."""
    concrete = Concrete(f_ck)
    return shear.required_links(np.array([v]), np.array([z / LEVER]), concrete, Steel(f_yk), concrete.annex.flattest)


def _ratio_along(v_x: float, v_y: float, rho_x: float, rho_y: float) -> float:
    """Return rho_l in the direction of the largest shear force [%]."""
    _, along = principal_shear(np.array([v_x]), np.array([v_y]))
    return float(ratio_along(along, np.array([rho_x]), np.array([rho_y]))[0]) * 100


def _resistance(k_pb: float, rho: float, f_ck: float, d: float, d_lower: float = 0.016) -> float:
    """Return tau_Rd,c of punching [Pa]."""
    return punching.resistance_without_links(Concrete(f_ck, d_lower=d_lower), k_pb, rho, d)


def _beta_e(shape: Shape, e_1: float, e_2: float, b_1: float, b_2: float) -> float:
    """Return beta_e, refined."""
    return punching.beta(punching.eccentricity(shape, e_1, e_2), b_1, b_2)


def _with_links(tau_Rd_c: float, tau_Ed: float, rho_w: float, f_ywd: float, **of: float) -> float:
    """Return tau_Rd,cs [Pa]."""
    eta_c = punching.concrete_share(tau_Rd_c, tau_Ed)
    return punching.resistance_with_links(tau_Rd_c, (eta_c, punching.links_share(eta_c=eta_c, **of)), rho_w, f_ywd)


def _most_with_links(tau_Rd_c: float, b_0: float, d: float) -> float:
    """Return tau_Rd,max of links [Pa]."""
    return punching.system_factor(Concrete(30e6), b_0, d) * tau_Rd_c


def _area(m: float, d: float, f_ck: float, f_yk: float) -> float:
    """Return the area of bars [m2/m] for a moment per width."""
    required = bending.required(np.array([m]), d, Concrete(f_ck), Steel(f_yk), thickness=d + 0.05)
    return float(required.tension[0])


def _crack(what: str) -> Callable[..., float]:
    """Return the function for a figure of a crack, with a stress of bars and a neutral axis."""

    def find(h: float, x: float, diameter: float, spacing: float, cover: float, sigma_s: float, f_ck: float) -> float:
        bars, concrete, steel = Bars(diameter, spacing, cover), Concrete(f_ck), Steel(500e6)
        thickness, axis = np.array([h]), np.array([x])
        h_c = cracking.effective_depth(thickness, axis, bars)
        rho, k_fl = cracking.effective_ratio(h_c, bars), (thickness - h_c) / h
        bond = cracking.GOOD_BOND, concrete.annex.k_w
        materials = concrete, steel, cracking.GOOD_BOND
        figures = {
            "rho": 100 * rho,
            "s_r": cracking.mean_spacing(bars, thickness, axis, rho, k_fl, bond),
            "k_1/r": cracking.curvature_factor(thickness, axis, bars),
            "w": cracking.width_of_stress(np.array([sigma_s]), thickness, axis, bars, materials),
        }
        return float(figures[what][0])

    return find


def _stress(m: float, d: float, area: float, f_ck: float) -> float:
    """Return the stress of the bars of a cracked section [Pa]."""
    bars = Bars(0.025, 0.1, 0.0375, np.array(area))
    return float(cracking.bar_stress(np.array(m), np.array(d + 0.05), bars, Concrete(f_ck), Steel(500e6)))


#: By name: the dimension of the value's unit, and how it is found.
VALUES_2023: dict[str, tuple[str | None, Callable[..., Any]]] = {
    "f_cd by EN 1992-1-1:2023": ("pressure", lambda **of: Concrete(**of).f_cd),
    "E_cm by EN 1992-1-1:2023": ("pressure", lambda f_ck: Concrete(f_ck).E_cm),
    "f_ctm by EN 1992-1-1:2023": ("pressure", lambda f_ck: Concrete(f_ck).f_ctm),
    "A_s by EN 1992-1-1:2023": (None, _area),
    "least bars by EN 1992-1-1:2023": (
        None,
        lambda h, d, f_ck, f_yk: float(
            bending.minimum(np.array(d), h, concrete=Concrete(f_ck), steel=Steel(f_yk)) * 1e6
        ),
    ),
    "tau_Rdc,min": (
        "pressure",
        lambda f_ck, d, d_lower=0.016: float(
            shear.minimum_resistance(Concrete(f_ck, d_lower=d_lower), Steel(500e6), d)
        ),
    ),
    "tau_Rd,c of one-way shear": (
        "pressure",
        lambda f_ck, d, rho: float(shear.stress_without_links(Concrete(f_ck), Steel(500e6), d, rho)),
    ),
    "v_Rd,c by EN 1992-1-1:2023": (None, _without_links),
    "rho_l along the shear force": (None, _ratio_along),
    "cot theta by EN 1992-1-1:2023": (None, lambda **of: float(_struts(**of).cot_theta[0])),
    "links by EN 1992-1-1:2023": (None, lambda **of: float(_struts(**of).area[0]) * 100),
    "k_pb": (None, punching.gradient),
    "a_pd": ("length", punching.depth_by_contraflexure),
    "tau_Rd,c of punching": ("pressure", _resistance),
    "V_Rd,c of punching": (
        "force",
        lambda c, d, rho, f_ck: (
            _resistance(punching.gradient(4 * c, 4 * c + math.pi * d), rho, f_ck, d) * (4 * c + math.pi * d) * d
        ),
    ),
    "beta_e": (None, _beta_e),
    "eta_s": (None, punching.links_share),
    "tau_Rd,cs": ("pressure", _with_links),
    "tau_Rd,max": ("pressure", _most_with_links),
    "b_0.5,out": ("length", punching.outer_perimeter),
    "s_r,m,cal": ("length", _crack("s_r")),
    "k_1/r": (None, _crack("k_1/r")),
    "rho_p,eff by EN 1992-1-1:2023": (None, _crack("rho")),
    "w_k,cal": ("length", _crack("w")),
    "sigma_s by EN 1992-1-1:2023": ("pressure", _stress),
    "least bars for cracks by EN 1992-1-1:2023": (
        None,
        lambda h, f_ck, f_yk: float(cracking.minimum_area(np.array(h), Concrete(f_ck), f_yk)) * 1e6,
    ),
}
