"""One-way shear by ACI 318-19 22.5: what needs no links, and the check of the governing place."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.aci318 import shear
from groundslab.design.aci318.case_materials import materials
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.basis.check import DesignCheck, Status
from groundslab.design.basis.shear_demand import ShearDemand
from groundslab.model.design.reinforcement import Reinforcement


def resistance(steel: Reinforcement, _: str, d: Array, rho: Array) -> Array:
    """Return phi v_c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    return PHI_SHEAR * shear.without_links(materials(steel)[0], d, rho)


def check(steel: Reinforcement, demand: ShearDemand) -> DesignCheck:
    """Return the check at the place that governs."""
    which = "provided" if steel.laid else "needed for bending"
    words = (
        f"v_u {demand.v / 1e3:.4g} kN/m at {demand.where} is {demand.used:.3g} times phi v_c "
        f"{demand.without_links / 1e3:.4g} kN/m with the bars {which} (22.5.5.1)"
    )
    status: Status = "no failure found"
    if demand.used > 1:
        area = shear.links(demand.v, demand.d, *materials(steel))
        status = "fails" if np.isinf(area) else "attention"
        words += (
            "; links do not suffice (22.5.1.2)" if np.isinf(area)
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (22.5.8.5.3)"
        )  # fmt: skip
    return demand.check(status, words, "ACI 318-19 22.5.5.1")
