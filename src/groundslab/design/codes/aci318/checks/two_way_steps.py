"""Two-way shear by ACI 318-19 at columns, piles, zones and ends of walls, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.laid_links import LaidLinks, laid_links
from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, strength, used
from groundslab.design.codes.aci318.checks.wall_ends import DISTANCE, WALL_STRESS
from groundslab.design.codes.aci318.materials import PHI_SHEAR, Concrete, Steel
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.codes.aci318.shear import concrete_in_shear
from groundslab.design.demands.line_properties import total_length
from groundslab.design.rules.calculation import (
    BY_CHORDS,
    MEGA,
    Step,
    Support,
    axis_step,
    counted_length,
    depth_steps,
    from_below,
    length_by_figures,
    moment_steps,
    punching_force,
    some,
    thinner_steps,
    width_steps,
)
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement


def steps(demand: TwoWay, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand."""
    concrete, bars = materials(steel)
    what = support, demand.pulls
    yield from depth_steps(demand.d, steel.top_axes if from_below(what) else steel.bottom_axes, clause="22.6.2.1")
    if demand.wall is not None:
        a = float(DISTANCE[0]) * demand.d
        whole = "b_o" if math.isclose(demand.b_o, demand.wall.whole(a), rel_tol=BY_CHORDS) else "b_w"
        yield Step("distance of the critical section from the face", "a", a, "m", f"{DISTANCE[0]:g} * d", "22.6.4.1")
        yield from demand.wall.course_steps(a, ("d", "a", whole, "b_o"), "22.6.4")
        yield from demand.wall.force_steps(a, demand.V_u, (whole, "V_u"), "22.6.4.1")
    else:
        inside = demand.force, demand.others, demand.pressure, demand.edge
        symbols, relieves = ("N_u", "V_u"), steel.line_force_relieves
        loads_inside = demand.inside, demand.cases
        yield from punching_force(what, symbols, inside, loads_inside, demand.V_u, "22.6.4.1", relieves=relieves)
        yield from _length(demand)
    if demand.transfer is not None:
        yield from _transfer(demand, demand.transfer, what)
        yield Step("stress", "v_u", demand.v_u / MEGA, "MPa", aci318.FORMULAS["v_u"], "8.4.4.2.3")
    else:
        clause = "DIN EN 1992-1-1/NA Figure NA.6.21.1"
        yield Step("factor for an end or a corner", "beta_e", demand.beta_e or 0.0, clause=clause)
        yield Step("stress", "v_u", demand.v_u / MEGA, "MPa", WALL_STRESS, clause)
    yield from concrete_in_shear(concrete, demand.d)
    yield Step("long side of the column over the short one", "beta", demand.beta, clause="22.6.5.2")
    yield Step("factor of the column's place", "alpha_s", demand.alpha_s, clause="22.6.5.3")
    v_c = strength(demand, steel) / PHI_SHEAR / MEGA
    yield Step("stress that needs no stirrups", "v_c", v_c, "MPa", aci318.FORMULAS["v_c"], "Table 22.6.5.2")
    yield Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1")
    share = used(demand, steel)
    yield Step("share used", "eta", share, "", "v_u / (phi * v_c)", "8.5.1.1")
    links = laid_links(demand, steel)
    if links is not None:
        yield from _as_laid(demand, links, bars)
    elif share > 1:
        yield from _stirrups(demand, concrete, bars)


def _length(demand: TwoWay) -> Iterator[Step]:
    """Yield the length of the critical section."""
    line, widths = demand.line, demand.widths
    assert line is not None
    assert widths is not None
    a = float(DISTANCE[0]) * demand.d
    yield Step("distance of the critical section from the face", "a", a, "m", f"{DISTANCE[0]:g} * d", "22.6.4.1")
    yield from width_steps(widths, demand.setbacks, "w")
    whole = total_length(line.whole)
    formula = length_by_figures(widths, demand.setbacks, ("a", a), whole, square=True, symbols=("w_1", "w_2"))
    yield from thinner_steps(demand.counted, lambda n: f"1 - t_{n} / d", "22.6.4")
    yield from counted_length(whole, formula, ("b_o", demand.b_o), "22.6.4")


def _as_laid(demand: TwoWay, links: LaidLinks, bars: Steel) -> Iterator[Step]:
    """Yield what the links or studs that are given carry."""
    F, studs = aci318.FORMULAS, links.given.kind == "studs"
    formula = F["v_cs (s)" if studs else "v_cs"]
    yield Step("stress of the concrete beside them", "v_cs", links.v_c / MEGA, "MPa", formula, "22.6.6.1")
    yield Step("diameter of the links given", "d_w", links.given.diameter, "m")
    yield Step("legs on each perimeter, the fewest", "n_w", links.A_v / links.given.leg_area)
    formula = "n_w * pi / 4 * d_w^2 * 10000"
    yield Step("links given on each perimeter", "A_v", links.A_v * 1e4, "cm2", formula, "22.6.7.2, 22.6.8.2")
    yield Step("distance of perimeters, the largest", "s", links.s, "m", clause="22.6.7.2, 22.6.8.2")
    yield Step("strength of links that counts", "f_yt", bars.f_yt / MEGA, "MPa", clause="20.2.2.4")
    yield Step("stress that links carry", "v_s", links.v_s / MEGA, "MPa", F["v_s"], "22.6.7.2, 22.6.8.2")
    formula = F["v_max (s)" if studs else "v_max"]
    yield Step("largest stress with links", "v_max", links.most / MEGA, "MPa", formula, "22.6.6.3")
    yield Step("nominal strength with links", "v_n", links.v_n / MEGA, "MPa", F["v_n"], "22.6.1.3")
    used = demand.v_u / PHI_SHEAR / links.v_n
    yield Step("share used with the links given", "eta_s", used, "", "v_u / (phi * v_n)", "8.5.1.1")


def _stirrups(demand: TwoWay, concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield the most that stirrups can bear, and the stirrups that are needed."""
    most = aci318.most_with_links(concrete)
    yield Step("largest stress with stirrups", "v_max", most / MEGA, "MPa", aci318.FORMULAS["v_max"], "22.6.6.3")
    share = demand.v_u / (PHI_SHEAR * most)
    yield Step("share of it that is used", "eta_m", share, "", "v_u / (phi * v_max)", "22.6.6.3")
    beside = aci318.with_links(concrete, demand.d) / MEGA
    yield Step("stress of the concrete beside stirrups", "v_cs", beside, "MPa", aci318.FORMULAS["v_cs"], "22.6.6.1")
    yield Step("strength of stirrups that counts", "f_yt", bars.f_yt / MEGA, "MPa", clause="20.2.2.4")
    A_v = aci318.links(demand.v_u, demand.d, demand.b_o, concrete, bars)
    yield Step("stirrups around it, A_v / s", "A_vs", A_v * 1e4, "cm2/m", aci318.FORMULAS["A_v / s"], "22.6.7.2")
    s = aci318.STIRRUP_SPACING * demand.d
    formula = f"{aci318.STIRRUP_SPACING:g} * d"
    yield Step("largest distance of stirrups, and from the face", "s", s, "m", formula, "8.7.6.3")
    yield Step("stirrups around it in each of their rows", "A_v", A_v * s * 1e4, "cm2", "A_vs * s", "22.6.7.2")


def _principal(transfer: aci318.Transfer, d: float) -> Iterator[Step]:
    """Yield that J_c has no mixed term on its axes, which are those about which both moments count at once."""
    I_12, l_12 = transfer.mixed
    words = "integral over the sides of the product of the distances from the center along both axes"
    yield Step(words, "I_12", some(I_12), "m3", clause="R8.4.4.2.3")
    words = "integral over the sides of the product of the cosines of their angles from both axes"
    yield Step(words, "l_12", some(l_12), "m", clause="R8.4.4.2.3")
    words = "mixed term of J_c, none as the axes are its principal ones"
    yield Step(words, "J_12", some(d * I_12 + d**3 / 12 * l_12), "m4", "d * I_12 + d^3 / 12 * l_12", "R8.4.4.2.3")


def _transfer(demand: TwoWay, transfer: aci318.Transfer, what: tuple[Support, bool]) -> Iterator[Step]:
    """Yield the moments that shear transfers, at the place where v_u is largest."""
    assert demand.parts is not None
    yield axis_step(transfer.axes)
    if transfer.turned:
        yield from _principal(transfer, demand.d)
    for n, extent in zip((1, 2), transfer.extents, strict=True):
        yield Step(
            Message("extent of the whole section along axis {n}", n=n), f"b_{n}", float(extent), "m", clause="8.4.2.2.2"
        )
    for n in (1, 2):
        sums = demand.others, demand.pressure, demand.edge
        moment = float(transfer.moments[n - 1])
        yield from moment_steps(n, demand.parts, ("N_u", demand.force), moment, what, sums=sums)
        formula = aci318.FORMULAS[f"gamma_v{n}"]
        share = float(transfer.shares[n - 1])
        yield Step("share of it that shear transfers", f"gamma_v{n}", share, "", formula, "8.4.4.2.2")
        words = Message("place of the largest stress along axis {n}, a corner of the section, from its center", n=n)
        yield Step(words, f"c_{n}", float(transfer.places[n - 1]), "m", clause="8.4.4.2.3")
        words = Message("integral over the sides of the square of the distance from the center along axis {n}", n=n)
        yield Step(words, f"I_{n}", float(transfer.second[n - 1]), "m3", clause="R8.4.4.2.3")
        words = Message("integral over the sides of the square of the cosine of their angle from axis {n}", n=n)
        yield Step(words, f"l_{n}", float(transfer.lengths[n - 1]), "m", clause="R8.4.4.2.3")
        formula = aci318.FORMULAS["J_n"].replace("_n", f"_{n}")
        yield Step(Message("J_c along axis {n}", n=n), f"J_{n}", float(transfer.J[n - 1]), "m4", formula, "R8.4.4.2.3")
