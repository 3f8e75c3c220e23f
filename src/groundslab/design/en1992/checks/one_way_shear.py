"""One-way shear by EN 1992-1-1 6.2: what needs no links, where struts fail, and the check of the governing place."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from groundslab.arrays import Array
from groundslab.design.basis.check import DesignCheck, Status
from groundslab.design.basis.shear_demand import ShearDemand
from groundslab.design.en1992 import shear
from groundslab.design.en1992.case_materials import materials
from groundslab.design.en1992.checks.governing_perimeters import demands
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_WITH_LINKS = 0.2


def reach(combined: Results) -> Mapping[str, float]:
    """Return how far from the face of columns punching is checked instead [m], by name."""
    return demands(combined).reach


def resistance(steel: Reinforcement, limit_state: str, d: Array, rho: Array) -> Array:
    """Return v_Rd,c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    return shear.resistance_without_links(materials(steel, limit_state)[0], d, rho)


def struts_fail(steel: Reinforcement, limit_state: str, v: float, d: float) -> bool:
    """Return whether no links help under a shear force v [N/m] at an effective depth d [m]."""
    concrete, bars = materials(steel, limit_state)
    return bool(shear.required_links(np.array([v]), np.array([d]), concrete, bars).fails[0])


def check(steel: Reinforcement, demand: ShearDemand) -> DesignCheck:
    """Return the check at the place that governs."""
    which = "provided" if steel.laid else "needed for bending"
    words = (
        f"v_Ed {demand.v / 1e3:.4g} kN/m at {demand.where} is {demand.used:.3g} times v_Rd,c "
        f"{demand.without_links / 1e3:.4g} kN/m with the bars {which} (6.2.2)"
    )
    status: Status = "no failure found"
    if demand.used > 1:
        concrete, bars = materials(steel, demand.results.limit_state)
        links = shear.required_links(np.array([demand.v]), np.array([demand.d]), concrete, bars)
        area = max(float(links.area[0]), shear.minimum_links(concrete, bars))
        thin = demand.thickness < LEAST_WITH_LINKS
        status = "fails" if np.isinf(area) or thin else "attention"
        words += (
            "; links do not suffice at the load there (6.2.1(8))" if demand.at_support
            else "; links do not suffice (6.2.3(3))" if np.isinf(area)
            else "; too thin for links (9.3.2(1))" if thin
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (6.2.3)"
        )  # fmt: skip
    return demand.check(status, words, "EN 1992-1-1 6.2.2, 6.2.3")
