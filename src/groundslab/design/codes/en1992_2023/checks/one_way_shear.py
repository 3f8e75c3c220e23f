"""One-way shear by EN 1992-1-1:2023 8.2: what needs no links, the links, and the calculation."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023 import shear
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands, pile_demands, zone_demands
from groundslab.design.codes.en1992_2023.materials_of_case import flattest, materials
from groundslab.design.codes.en1992_2023.shear import in_shear
from groundslab.design.codes.eurocode2.struts import LEVER, struts_in_steps
from groundslab.design.demands.perimeter_loads import Reach, punching_columns, punching_piles, reach_without
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def reach(combined: Results) -> Reach:
    """Return how far from the face of columns, piles and zones punching is checked instead [m]: d without a perimeter.

    Those whose perimeters cut the slab from edge to edge are checked in shear from there on (8.2.2(1)).
    """
    of_columns = punching_columns(combined.solved_model), column_demands(combined).missing
    of_piles = punching_piles(combined.model), pile_demands(combined).missing
    return reach_without(combined, of_columns, of_piles, (zone_forces(combined), zone_demands(combined).missing))


def resistance(steel: Reinforcement, limit_state: str, d: Array, rho: Array) -> Array:
    """Return v_Rd,c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    return shear.resistance_without_links(*materials(steel, limit_state), d, rho)


def links(steel: Reinforcement, demand: ShearDemand) -> float:
    """Return the links per area of the plan that a demand needs, the least ones at least [m2/m2]; inf: struts fail."""
    concrete, bars = materials(steel, demand.results.limit_state)
    args = np.array([demand.v]), np.array([demand.d]), concrete, bars
    return max(
        float(shear.required_links(*args, flattest(steel, concrete)).area[0]), shear.minimum_links(concrete, bars)
    )


def steps(steel: Reinforcement, demand: ShearDemand) -> Iterator[Step]:
    """Yield the calculation at a place."""
    concrete, bars = materials(steel, demand.results.limit_state)
    yield from demand.force_steps("v_Ed", "8.2.1(5), 8.21")
    yield from demand.depth_steps(steel, "8.2.1(5)")
    if demand.rho is None:
        yield from demand.mean_steps("v_Rd,c", "v_Ed", "8.2.2(2), 8.27")
        return
    rho = min(demand.rho, shear.MOST_BARS)
    yield from in_shear(concrete, bars, demand.d)
    yield from demand.ratio_steps("rho_l", "v_Ed", "8.2.2(2), 8.28, 8.39", shear.MOST_BARS)
    stress = float(shear.stress_without_links(concrete, bars, demand.d, rho)) / MEGA
    yield Step("resistance without links", "tau_Rd,c", stress, "MPa", shear.FORMULAS["tau_Rd,c"], "8.2.2(2), 8.27")
    yield Step("lever arm", "z", LEVER * demand.d, "m", f"{LEVER:g} * d", "8.2.1(3)")
    v_Rd_c = demand.without_links / MEGA
    yield Step("the same as a force", "v_Rd,c", v_Rd_c, "MN/m", shear.FORMULAS["v_Rd,c"], "8.2.1(3), 8.19")
    yield Step("share used", "eta", demand.used, "", "v_Ed / v_Rd,c", "8.2.1(4)")
    args = np.array([demand.v]), np.array([demand.d]), concrete, bars
    links = shear.required_links(*args, flattest(steel, concrete))
    if demand.used > 1 and not links.fails[0]:
        yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
        z, cot = LEVER * demand.d, float(links.cot_theta[0])
        yield from shear.design_strength(concrete)
        formula = f"{concrete.annex.nu:g} * f_cd"
        yield Step("strength of struts", "nu_f_cd", concrete.strut / MEGA, "MPa", formula, "8.2.3(6)")
        yield Step("largest cot theta", "cot_max", float(flattest(steel, concrete)), clause="8.2.3(4)")
        yield from struts_in_steps(demand.v, z, concrete.strut, cot, "8.2.3(5), 8.44")
        area = float(links.area[0]) * 1e4
        yield Step("links per area of the plan", "a_sw", area, "cm2/m2", shear.FORMULAS["a_sw"], "8.2.3(5), 8.42")
        least = shear.minimum_links(concrete, bars) * 1e4
        yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa", clause="5.2.4")
        formula = "0.08 * sqrt(f_ck) / f_yk * 10000"
        yield Step("least links per area of the plan", "a_sw,min", least, "cm2/m2", formula, "12.2(4), 12.4")
