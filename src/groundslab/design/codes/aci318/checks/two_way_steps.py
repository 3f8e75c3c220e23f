"""Two-way shear by ACI 318-19 at columns, piles, zones and ends of walls, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.laid_links import LaidLinks, laid_links
from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, strength, used
from groundslab.design.codes.aci318.checks.wall_ends import WALL_STRESS
from groundslab.design.codes.aci318.materials import PHI_SHEAR, Concrete, Steel
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.codes.aci318.shear import concrete_in_shear
from groundslab.design.rules.calculation import MEGA, SAME, Step, punching_force
from groundslab.design.rules.punching_links.demand import Support
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement


def steps(demand: TwoWay, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand."""
    concrete, bars = materials(steel)
    if support == "wall end":
        words = "shear force of the slab across the critical section"
        yield Step(words, "V_u", demand.V_u / MEGA, "MN", clause="22.6.4.1")
    else:
        inside = demand.force, demand.others, demand.pressure, demand.edge
        yield from punching_force((support, demand.pulls), ("N_u", "V_u"), inside, demand.V_u, "22.6.4.1")
    yield Step("effective depth", "d", demand.d, "m", clause="22.6.2.1")
    thinned = demand.line is not None and demand.b_o < (1 - SAME) * demand.line.u
    words = (
        "length of the critical section, less edges and openings, less in thinner slab"
        if thinned
        else "length of the critical section, less edges and openings"
    )
    yield Step(words, "b_o", demand.b_o, "m", clause="22.6.4")
    if demand.transfer is not None:
        yield from _transfer(demand.transfer)
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


def _as_laid(demand: TwoWay, links: LaidLinks, bars: Steel) -> Iterator[Step]:
    """Yield what the links or studs that are given carry."""
    F, studs = aci318.FORMULAS, links.given.kind == "studs"
    formula = F["v_cs (s)" if studs else "v_cs"]
    yield Step("stress of the concrete beside them", "v_cs", links.v_c / MEGA, "MPa", formula, "22.6.6.1")
    yield Step("links given on each perimeter, the least", "A_v", links.A_v * 1e4, "cm2", clause="22.6.7.2, 22.6.8.2")
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


def _transfer(transfer: aci318.Transfer) -> Iterator[Step]:
    """Yield the moments that shear transfers, at the place where v_u is largest."""
    for n, extent in zip((1, 2), transfer.extents, strict=True):
        yield Step(
            Message("extent of the whole section along axis {n}", n=n), f"b_{n}", float(extent), "m", clause="8.4.2.2.2"
        )
    parts = zip((1, 2), transfer.moments, transfer.shares, transfer.places, transfer.J, strict=True)
    for n, moment, share, place, J in parts:
        words = Message("moment of all forces by their places along axis {n}", n=n)
        yield Step(words, f"M_{n}", float(moment) / MEGA, "MNm", clause="8.4.4.2.3")
        formula = aci318.FORMULAS[f"gamma_v{n}"]
        yield Step("share of it that shear transfers", f"gamma_v{n}", float(share), "", formula, "8.4.4.2.2")
        yield Step(
            Message("place of the largest stress along axis {n}", n=n), f"c_{n}", float(place), "m", clause="8.4.4.2.3"
        )
        yield Step(Message("J_c along axis {n}", n=n), f"J_{n}", float(J), "m4", clause="R8.4.4.2.3")
