"""Punching by EN 1992-1-1:2023 at columns, piles, zones and walls' ends, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.codes.en1992_2023.checks.critical_sections import CriticalSection
from groundslab.design.codes.en1992_2023.checks.punching import LaidLinks, laid_links, links_needed, outermost_depth
from groundslab.design.codes.en1992_2023.checks.punching_demand import Punching
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import in_shear
from groundslab.design.rules.calculation import MEGA, Step, punching_force
from groundslab.design.rules.punching_beta import beta_in_steps, other_betas_in_steps
from groundslab.design.rules.punching_links.demand import Support
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

F = en1992.FORMULAS


def steps(demand: Punching, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand."""
    concrete, bars = materials(steel, demand.limit_state)
    if support == "wall end":
        yield Step("shear force of the slab across the perimeter", "V_Ed", demand.V_Ed / MEGA, "MN", clause="8.4.2(6)")
    else:
        inside = demand.force, demand.others, demand.pressure, demand.edge
        yield from punching_force((support, demand.pulls), ("N_Ed", "V_Ed"), inside, demand.V_Ed, "8.4.2(6)")
    yield Step("effective depth", "d_v", demand.d, "m", clause="8.4.2(1), 8.91")
    yield Step("perimeter at d_v / 2 that counts", "b_05", demand.b_05, "m", clause="8.4.2(2) to (5)")
    if demand.section is None:
        yield Step("factor for an end or a corner", "beta_e", demand.beta_e or 0.0, clause="Figure 8.21")
    elif demand.way == "code":
        yield from _beta(demand, demand.section, support)
    else:
        yield beta_in_steps(demand.way, demand.beta_e or 0.0, "beta_e", "8.4.2(6), Table 8.3")
    if demand.section is not None and demand.beta_e is not None:
        others = demand.other_betas()
        yield from other_betas_in_steps(demand.way, demand.beta_e, others, "beta_e", "8.4.2(6)")
    yield from _stress(demand)
    yield from in_shear(concrete, bars, demand.d, "d_v")
    yield Step("perimeter at the face that counts", "b_0", demand.b_0, "m", clause="8.4.3(1), Figure 8.18")
    yield Step("factor of the shear gradient", "k_pb", demand.k_pb, "", F["k_pb"], "8.4.3(1), 8.96")
    yield Step("ratio of bars in tension that counts", "rho_l", demand.ratio, clause="8.4.3(1), 8.95")
    if isfinite(demand.a_p) and demand.a_pd < demand.d:
        yield Step("mean distance of contraflexure", "a_p", demand.a_p, "m", clause="8.4.3(2), 8.98")
        yield Step("depth that counts", "a_pd", demand.a_pd, "m", F["a_pd"], "8.4.3(2), 8.97")
    else:
        yield Step("depth that counts, contraflexure being far", "a_pd", demand.a_pd, "m", "d_v", "8.4.3(2)")
    yield Step("resistance", "tau_Rd,c", demand.tau_Rd_c / MEGA, "MPa", F["tau_Rd,c"], "8.4.3(1), 8.94")
    formula = "tau_Ed / max(tau_Rd,c, tau_min)"
    yield Step("share used", "eta", demand.used, "", formula, "8.4.1(2), 8.87, 8.88")
    links = laid_links(demand, steel)
    if demand.used > 1 and links is not None:
        yield from _as_laid(demand, steel, links)
    elif demand.used > 1:
        yield from _links(demand, steel)


def _as_laid(demand: Punching, steel: Reinforcement, links: LaidLinks) -> Iterator[Step]:
    """Yield what the links that are given carry."""
    given = steel.links_at(demand.name)
    assert given is not None
    concrete, bars = materials(steel, demand.limit_state)
    words = "stress with links, the pressure up to the perimeter relieving"
    yield Step(words, "tau_Ed", demand.tau_links / MEGA, "MPa", clause="8.4.2(6)")
    yield Step("share of the concrete", "eta_c", links.eta[0], "", "min(1, tau_Rd,c / tau_Ed)", "8.4.4(1), 8.105")
    yield Step("diameter of the links given", "phi_w", given.diameter * 1e3, "mm")
    yield Step("share of links", "eta_s", links.eta[1], "", F["eta_s"], "8.4.4(1), 8.106")
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
    yield Step("links given on each perimeter, the least", "A_sw", links.A_sw * 1e4, "cm2", clause="8.4.4(1)")
    yield Step("distance of perimeters, the largest", "s_r", links.s_r, "m", clause="8.4.4(1)")
    yield Step("links per area of the plan", "rho_w", links.rho_w, "", "A_sw / 10000 / (s_r * b_05)", "8.4.4(1)")
    yield Step("resistance with the links given", "tau_cs", links.tau_cs / MEGA, "MPa", F["tau_cs"], "8.4.4(1), 8.104")
    a, b = concrete.annex.eta_sys
    eta_sys = en1992.system_factor(concrete, demand.b_0, demand.d)
    formula = f"max(1, {a:g} + {b:g} * (b_0 / d_v)^(1/4))"
    yield Step("factor of links", "eta_sys", eta_sys, "", formula, "8.4.4(5), 8.111")
    yield Step("most with links", "tau_max", links.tau_max / MEGA, "MPa", F["tau_max"], "8.4.4(5), 8.109")
    used = demand.tau_links / min(links.tau_cs, links.tau_max)
    yield Step("share used with the links given", "eta_l", used, "", "tau_Ed / min(tau_cs, tau_max)", "8.4.4")


def _beta(demand: Punching, section: CriticalSection, one: Support) -> Iterator[Step]:
    """Yield how beta_e follows from the support's eccentricity, or what moments add where nothing pushes."""
    if demand.beta_e is None:
        for n, M, width in zip((1, 2), demand.eccentricities, section.widths, strict=True):
            yield Step(Message("moment of all forces by their places along axis {n}", n=n), f"M_{n}", M / MEGA, "MNm")
            yield Step(
                Message("overall width of the perimeter along axis {n}", n=n),
                f"b_{n}",
                width,
                "m",
                clause="Figure 8.21",
            )
        M_b = en1992.eccentricity(section.course.shape, *demand.eccentricities)
        formula = F[f"e_b {_kind(section)}"].replace("e_", "M_")
        yield Step("moment that counts", "M_b", M_b / MEGA, "MNm", formula, "Table 8.3")
        return
    for n, e, width in zip((1, 2), demand.eccentricities, section.widths, strict=True):
        yield Step(
            Message("eccentricity of the {name}'s force along axis {n}", name=one, n=n),
            f"e_{n}",
            e,
            "m",
            clause="Table 8.3",
        )
        yield Step(
            Message("overall width of the perimeter along axis {n}", n=n), f"b_{n}", width, "m", clause="Figure 8.21"
        )
    e_b = en1992.eccentricity(section.course.shape, *demand.eccentricities)
    yield Step("eccentricity that counts", "e_b", e_b, "m", F[f"e_b {_kind(section)}"], "Table 8.3")
    yield Step("factor of concentrated shear", "beta_e", demand.beta_e, "", F["beta_e"], "8.4.2(6), Table 8.3")


def _kind(section: CriticalSection) -> str:
    """Return which formula of the eccentricity a section has."""
    shape = section.course.shape
    return shape if shape in ("edge", "corner") else "closed"


def _stress(demand: Punching) -> Iterator[Step]:
    """Yield tau_Ed, by beta_e, or of the analysis where that counts and is larger."""
    raised = demand.V_Ed + demand.turned if demand.beta_e is None else demand.beta_e * demand.V_Ed
    by_force = raised / (demand.b_05 * demand.d)
    if demand.tau_Ed > by_force:
        words = "stress by the shear forces of the analysis, as a large force is near"
        yield Step(words, "tau_Ed", demand.tau_Ed / MEGA, "MPa", clause="8.4.2(7), 8.4.2(8), 8.93")
    else:
        formula = F["tau_Ed by M" if demand.beta_e is None else "tau_Ed"]
        yield Step("stress", "tau_Ed", by_force / MEGA, "MPa", formula, "8.4.2(6), 8.92")


def _links(demand: Punching, steel: Reinforcement) -> Iterator[Step]:
    """Yield the links that are needed, and the most that they can carry."""
    concrete, bars = materials(steel, demand.limit_state)
    out = outermost_depth(demand, steel)
    links = links_needed(demand, steel, out)
    words = "stress with links, the pressure up to the perimeter relieving"
    yield Step(words, "tau_Ed", links.tau_Ed / MEGA, "MPa", clause="8.4.2(6)")
    yield Step("share of the concrete", "eta_c", links.eta[0], "", F["eta_c"], "8.4.4(1), 8.105")
    yield Step("thickest links allowed", "phi_w", links.phi_w * 1e3, "mm", F["phi_w"], "12.5.1, 12.7")
    yield Step("share of links", "eta_s", links.eta[1], "", F["eta_s"], "8.4.4(1), 8.106")
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
    yield Step("links per area of the plan", "a_sw", links.rho_w * 1e4, "cm2/m2", F["a_sw"], "8.4.4(1), 8.104")
    a, b = concrete.annex.eta_sys
    eta_sys = en1992.system_factor(concrete, demand.b_0, demand.d)
    yield Step(
        "factor of links", "eta_sys", eta_sys, "", f"max(1, {a:g} + {b:g} * (b_0 / d_v)^(1/4))", "8.4.4(5), 8.111"
    )
    yield Step("most with links", "tau_max", links.tau_max / MEGA, "MPa", F["tau_max"], "8.4.4(5), 8.109")
    yield Step("share of it that is used", "eta_m", links.tau_Ed / links.tau_max, "", "tau_Ed / tau_max", "8.4.4(5)")
    yield Step("depth of the outermost links", "d_out", out, "m", clause="8.4.4(4), 8.108")
    yield Step("outer perimeter", "b_out", links.b_out, "m", F["b_out"], "8.4.4(7), 8.112")
