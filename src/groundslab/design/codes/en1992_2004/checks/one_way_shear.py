"""One-way shear by EN 1992-1-1 6.2: what needs no links, the links, and the calculation."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import shear
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands, pile_demands, zone_demands
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.materials_of_case import largest_cover, materials
from groundslab.design.codes.eurocode2.struts import Links, struts_in_steps
from groundslab.design.demands.perimeter_loads import Reach
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_WITH_LINKS = 0.2


def reach(combined: Results) -> Reach:
    """Return how far from the face of columns, piles and thicker zones punching is checked instead [m]."""
    return {**column_demands(combined).reach, **pile_demands(combined).reach, **zone_demands(combined).reach}


def resistance(steel: Reinforcement, limit_state: str, d: Array, rho: Array) -> Array:
    """Return v_Rd,c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    return shear.resistance_without_links(materials(steel, limit_state)[0], d, rho)


def links(steel: Reinforcement, demand: ShearDemand) -> float:
    """Return the links per area of the plan that a demand needs, the least ones at least [m2/m2]; inf: struts fail."""
    concrete, bars = materials(steel, demand.results.limit_state)
    needed = shear.required_links(np.array([demand.v]), np.array([demand.d]), concrete, bars, largest_cover(steel))
    return max(float(needed.area[0]), shear.minimum_links(concrete, bars))


def link_distance(steel: Reinforcement, demand: ShearDemand) -> Step:
    """Return how far legs of vertical links may be from each other along the force [m], 9.3.2(4)."""
    concrete, _ = materials(steel, demand.results.limit_state)
    z = float(shear.lever(concrete, np.array([demand.d]), largest_cover(steel))[0])
    annex, used = concrete.annex, 2 * demand.v / (z * concrete.strut)
    symbol, depth = ("h", demand.thickness) if annex.link_distances_by_height else ("d", demand.d)
    rows = annex.slab_link_distances
    times = next((times for up_to, times in rows if used <= up_to), rows[-1][1])
    words = "largest distance of legs" if len(rows) == 1 else "largest distance of legs, by the share used"
    return Step(words, "s_max", times * depth, "m", f"{times:g} * {symbol}", "9.3.2(4)")


def steps(steel: Reinforcement, demand: ShearDemand) -> Iterator[Step]:
    """Yield the calculation at a place."""
    concrete, bars = materials(steel, demand.results.limit_state)
    d = np.array([demand.d])
    yield from demand.force_steps("v_Ed", "6.2.1(1)")
    yield from demand.depth_steps(steel)
    if demand.rho is None:
        yield from demand.mean_steps("v_Rd,c", "v_Ed", "6.2.2(1), 6.2")
        return
    yield from shear.concrete_steps(concrete)
    yield from demand.ratio_steps("rho_l", "v_Ed", "6.2.2(1); EN 1992-2 LL.123", shear.MOST_BARS)
    yield Step("factor of size", "k", float(shear.size_factor(d)[0]), "", shear.FORMULAS["k"], "6.2.2(1)")
    yield Step("C_Rd,c gamma_C of the annex", "C", concrete.annex.c_rd_c, clause="6.2.2(1)")
    least = float(shear.least_factor(concrete, d)[0])
    yield Step("least factor of the annex", "v_min", least, clause="6.2.2(1), 6.3N")
    v_Rd_c = demand.without_links / MEGA
    yield Step("resistance without links", "v_Rd,c", v_Rd_c, "MN/m", shear.FORMULAS["v_Rd,c"], "6.2.2(1), 6.2")
    yield Step("share used", "eta", demand.used, "", "v_Ed / v_Rd,c", "6.2.1(3)")
    cover = largest_cover(steel)
    links = shear.required_links(np.array([demand.v]), d, concrete, bars, cover)
    if demand.used > 1 and not links.fails[0]:
        yield from _links(demand, links, concrete, bars, cover)


def _links(demand: ShearDemand, links: Links, concrete: Concrete, bars: Steel, cover: float) -> Iterator[Step]:
    """Yield the links that are needed, with the cover of the longitudinal bars [m]."""
    d = np.array([demand.d])
    z, formula = float(shear.lever(concrete, d, cover)[0]), f"{shear.LEVER:g} * d"
    if concrete.annex.lever_by_cover:
        yield Step("largest cover of longitudinal bars", "c", cover, "m", clause="6.2.3(1) of the annex")
        formula = f"min({formula}, max(d - 2 * c, d - c - {shear.COVER_LESS:g}))"
    yield Step("lever arm", "z", z, "m", formula, "6.2.3(1)")
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
    yield from shear.strut_steps(concrete, "nu_f_cd", "6.2.3(3), 6.2.2(6)")
    yield from shear.flattest_steps(concrete, demand.v, z, "v_Ed")
    yield from struts_in_steps(demand.v, z, concrete.strut, float(links.cot_theta[0]), "6.2.3(3), 6.9")
    area = float(links.area[0]) * 1e4
    yield Step("links per area of the plan", "a_sw", area, "cm2/m2", shear.FORMULAS["a_sw"], "6.2.3(3), 6.8")
    least = shear.minimum_links(concrete, bars) * 1e4
    yield from shear.strength_steps(concrete, bars)
    ratio = shear.least_links_formula(concrete)
    formula = f"{concrete.annex.slab_links:g} * {ratio} * 10000" if ratio else ""
    yield Step("least links per area of the plan", "a_sw,min", least, "cm2/m2", formula, "9.2.2(5), 9.3.2(2)")
