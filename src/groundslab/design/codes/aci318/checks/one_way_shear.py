"""One-way shear by ACI 318-19 22.5: what needs no links, the links, and the calculation."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318 import shear
from groundslab.design.codes.aci318.beams import FARTHEST, SHARP
from groundslab.design.codes.aci318.checks.two_way_demand import pile_two_way, zone_two_way
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.codes.aci318.shear import concrete_in_shear
from groundslab.design.demands.perimeter_loads import Reach, punching_piles, reach_without
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def reach(combined: Results) -> Reach:
    """Return how far from the face of piles and zones two-way shear is checked instead [m]: d without a section.

    Beside columns means over cuts at d are checked (7.4.3.2).
    """
    of_piles = punching_piles(combined.model), pile_two_way(combined).missing
    return reach_without(combined, of_piles, (zone_forces(combined), zone_two_way(combined).missing))


def resistance(steel: Reinforcement, _: str, d: Array, rho: Array) -> Array:
    """Return phi v_c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    return PHI_SHEAR * shear.without_links(materials(steel)[0], d, rho)


def links(steel: Reinforcement, demand: ShearDemand) -> float:
    """Return the links per area of the plan that a demand needs [m2/m2]; inf where none suffice."""
    return shear.links(demand.v, demand.d, *materials(steel))


def link_distance(steel: Reinforcement, demand: ShearDemand) -> Step:
    """Return how far legs of links may be from each other along the force [m], Table 9.7.6.2.2."""
    concrete, _ = materials(steel)
    of_links = demand.v / PHI_SHEAR - shear.WITH_LINKS * concrete.root * demand.d
    half, formula = 1.0, f"min(d / 2, {FARTHEST:g})"
    if of_links > SHARP * concrete.root * demand.d:
        half, formula = 0.5, f"0.5 * {formula}"
    clause = "Table 9.7.6.2.2"
    return Step("largest distance of legs", "s_max", half * min(demand.d / 2, FARTHEST), "m", formula, clause)


def steps(steel: Reinforcement, demand: ShearDemand) -> Iterator[Step]:
    """Yield the calculation at a place."""
    concrete, bars = materials(steel)
    yield from demand.force_steps("v_u", "7.4.3.2" if demand.across else "")
    yield from demand.depth_steps(steel)
    yield from concrete_in_shear(concrete, demand.d)
    v_c, clause = demand.without_links / PHI_SHEAR / MEGA, "Table 22.5.5.1 (c), 22.5.5.1.1"
    if demand.rho is None:
        yield Step("force that needs no links, mean over the cut", "v_c", v_c, "MN/m", clause=clause)
    else:
        yield from demand.ratio_steps("rho_w", "v_u", "22.5.5.1")
        yield Step("force that needs no links", "v_c", v_c, "MN/m", shear.FORMULAS["v_c"], clause)
    yield Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1")
    yield Step("share used", "eta", demand.used, "", "v_u / (phi * v_c)", "7.6.3.1")
    area = shear.links(demand.v, demand.d, concrete, bars)
    if demand.used > 1 and np.isfinite(area):
        yield Step("strength of links that counts", "f_yt", bars.f_yt / MEGA, "MPa", clause="20.2.2.4")
        formula = shear.FORMULAS["a_v"]
        yield Step("links per area of the plan", "a_v", area * 1e4, "cm2/m2", formula, "22.5.8.5.3, 9.6.3.4")
