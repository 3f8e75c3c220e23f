"""Punching by EN 1992-1-1 at columns, piles, zones and ends of walls, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.annex import Annex
from groundslab.design.codes.en1992_2004.checks.punching import (
    LEAST_ROWS,
    LaidLinks,
    governing,
    laid_links,
    limited_with_links,
)
from groundslab.design.codes.en1992_2004.checks.punching_demand import (
    LAST_LINKS,
    LEAST_GROWTH,
    REACH,
    ControlPerimeter,
    Demand,
    Outer,
    Stress,
    outer,
)
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.rules.calculation import MEGA, SAME, Step, punching_force
from groundslab.design.rules.punching_beta import beta_in_steps, other_betas_in_steps
from groundslab.design.rules.punching_links.demand import Support
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement

#: Where DIN EN 1992-1-1/NA, the one annex with a bound, has the least beta: for slabs and for foundations.
LEAST_BETA = "6.4.3(3), NA.6.39.1, 6.4.4(2), NA.6.51.1"


def steps(demand: Demand, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand on the perimeter that uses most."""
    worst = governing(demand, steel)
    assert worst is not None
    stress = worst.stress
    concrete, bars = materials(steel, demand.limit_state)
    if support == "wall end":
        yield Step("shear force of the slab across the perimeter", "V_Ed", stress.V_Ed / MEGA, "MN", clause="6.4.4(2)")
    else:
        inside = demand.force, stress.others, stress.pressure, stress.edge
        yield from punching_force((support, demand.pulls), ("N_Ed", "V_Ed"), inside, stress.V_Ed, "6.4.4(2), 6.48")
    yield Step("distance of the perimeter from the face", "a", stress.distance, "m", clause="6.4.4(2)")
    thinned = stress.control is not None and stress.control.thinned
    words = (
        "its length, less edges and openings, less in thinner slab"
        if thinned
        else "its length, less edges and openings"
    )
    yield Step(words, "u", stress.u, "m", clause="6.4.2")
    yield Step("effective depth", "d", demand.d, "m", clause="6.4.2(1)")
    if stress.control is not None:
        yield from _beta(stress, stress.control, concrete.annex.least_beta)
    else:
        yield Step(
            "factor for an end or a corner", "beta", stress.beta or 0.0, clause="DIN EN 1992-1-1/NA Figure NA.6.21.1"
        )
    formula = en1992.FORMULAS["v_Ed by M" if stress.beta is None else "v_Ed"]
    yield Step("stress", "v_Ed", stress.v_Ed / MEGA, "MPa", formula, "6.4.3(3), 6.38")
    yield from _resistance(demand, stress, concrete)
    yield Step("share used", "eta", demand.used(stress), "", "v_Ed / v_Rd", "6.4.4(2)")
    links = laid_links(demand, stress, steel)
    if stress.v_Ed > demand.resistance(stress) or links is not None:
        yield from _most(demand, stress, concrete)
    if links is not None:
        yield from _as_laid(demand, stress, steel, links)
    elif stress.v_Ed > demand.resistance(stress):
        yield from _with_links(demand, stress, concrete, bars)
    if demand.face is not None and concrete.annex.face:
        yield from _face(demand.face, concrete, demand.d)


def _beta(stress: Stress, control: ControlPerimeter, least: float) -> Iterator[Step]:
    """Yield how beta follows from the moments of all forces inside about the perimeter's center, or else."""
    if stress.way == "code":
        yield from _beta_by_moments(stress, control, least)
    else:
        yield beta_in_steps(stress.way, stress.beta or 0.0, "beta", "6.4.3(6), Figure 6.21N")
    if stress.beta is not None:
        yield from other_betas_in_steps(stress.way, stress.beta, stress.other_betas(), "beta", "6.4.3")


def _beta_by_moments(stress: Stress, control: ControlPerimeter, least: float) -> Iterator[Step]:
    """Yield how beta follows from the moments of all forces inside about the perimeter's center."""
    shares, moduli = [*map(float, control.shares)], [*map(float, control.moduli)]
    bounded = "max(beta_min, {})" if least > 1 else "{}"
    bound = [Step("least factor of the annex", "beta_min", least, clause=LEAST_BETA)] if least > 1 else []
    of_both = [
        (Step(Message("moment of all forces by their places along axis {n}", n=n), f"M_{n}", moment / MEGA, "MNm"),
         Step("share of it that shear transfers", f"k_{n}", share, clause="Table 6.1"),
         Step(Message("modulus of the perimeter along axis {n}", n=n), f"W_{n}", W, "m2", clause="6.40"))
        for n, moment, share, W in zip((1, 2), stress.moments, shares, moduli, strict=True)
    ]  # fmt: skip
    if stress.beta is None:
        yield from (step for axis in of_both for step in axis)
        return
    general = en1992.raised(stress.moments, shares, stress.V_Ed, stress.u, moduli) / stress.V_Ed
    if math.isclose(stress.beta, max(least, general), rel_tol=SAME):
        yield from (step for axis in of_both for step in axis)
        yield from bound
        formula = bounded.format(en1992.FORMULAS["beta"])
        yield Step("factor for moments", "beta", stress.beta, "", formula, "6.4.3(3), 6.39, 6.51")
    elif control.course.shape == "edge":
        yield from of_both[0]
        yield Step("share of the perimeter that counts, u_1* / u_1", "s", control.reduced, clause="6.4.3(4)")
        yield from bound
        formula = bounded.format(en1992.FORMULAS["beta at an edge"])
        yield Step("factor for moments along the edge", "beta", stress.beta, "", formula, "6.4.3(4), 6.44")
    else:
        yield Step("factor for a column at a corner", "beta", stress.beta, clause="6.4.3(6), Figure 6.21N")


def _resistance(demand: Demand, stress: Stress, concrete: Concrete) -> Iterator[Step]:
    """Yield what resists without links."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck_shear / MEGA, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")
    yield Step("ratio of bars in tension that counts", "rho_l", demand.ratio, clause="6.4.4(1)")
    yield Step("factor of size", "k", en1992.size_factor(demand.d), "", en1992.FORMULAS["k"], "6.4.4(1)")
    yield Step("C_Rd,c gamma_C of the annex", "C", concrete.annex.c_rd_c_punching, clause="6.4.4(1)")
    yield Step("least factor of the annex", "v_min", en1992.least_factor(concrete, demand.d), clause="6.2.2(1), 6.3N")
    formula = en1992.FORMULAS["v_Rd,c"]
    yield Step("resistance at 2 d", "v_Rd,c", demand.v_Rd_c / MEGA, "MPa", formula, "6.4.4(1), 6.47")
    resistance = demand.resistance(stress) / MEGA
    assert REACH == 2.0
    yield Step("resistance at a", "v_Rd", resistance, "MPa", en1992.FORMULAS["v_Rd"], "6.4.4(2), 6.50")


def _most(demand: Demand, stress: Stress, concrete: Concrete) -> Iterator[Step]:
    """Yield the most that links can carry."""
    most = concrete.annex.k_max
    v_m = most * demand.resistance(stress) / MEGA
    yield Step("largest resistance with links", "v_Rd,m", v_m, "MPa", f"{most:g} * v_Rd", "6.4.5(1)")
    yield Step("share of it that is used", "eta_m", stress.v_Ed / MEGA / v_m, "", "v_Ed / v_Rd,m", "6.4.5(1)")


def _strength_of_links(demand: Demand, bars: Steel) -> Iterator[Step]:
    """Yield the strength of links that counts."""
    f = en1992.effective_strength(demand.d, bars.f_yd)
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
    formula = en1992.FORMULAS["f_ywd,ef"]
    yield Step("strength of links that counts", "f_ywd,ef", f / MEGA, "MPa", formula, "6.4.5(1)")


def _as_laid(demand: Demand, stress: Stress, steel: Reinforcement, links: LaidLinks) -> Iterator[Step]:
    """Yield what the links that are given carry."""
    given = steel.links_at(demand.name)
    assert given is not None
    yield from _strength_of_links(demand, materials(steel, demand.limit_state)[1])
    if links.alone:
        words = "links given: of both inner perimeters, or of a further one over its share if that is less"
        yield Step(words, "A_sw", links.A_sw * 1e4, "cm2", clause="6.4.5(1) of the annex")
    else:
        yield Step("links given on each perimeter, the least", "A_sw", links.A_sw * 1e4, "cm2", clause="6.4.5(1)")
        words = "perimeters of links that count, at most 1.5 d / s_r and not beyond a"
        yield Step(words, "n_s", links.rows, clause="6.4.5(1)")
    formula = en1992.FORMULAS["v_Rd,cs alone" if links.alone else "v_Rd,cs"]
    yield Step("resistance with the links given", "v_Rd,cs", links.resistance / MEGA, "MPa", formula, "6.4.5(1), 6.52")
    yield Step("share of it that is used", "eta_s", stress.v_Ed / links.resistance, "", "v_Ed / v_Rd,cs", "6.4.5(1)")


def _with_links(demand: Demand, stress: Stress, concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield the links that each perimeter needs, and how far out they are, if they help."""
    limited = limited_with_links(demand, concrete.annex, at_face=demand.face is not None)
    if outer(demand).is_too_far(demand.d) or any(stressed.share > 1 for stressed in limited):
        return
    yield from _strength_of_links(demand, bars)
    apart = concrete.annex.link_rows[1]
    s_r = apart * demand.d
    yield Step("radial distance of their perimeters", "s_r", s_r, "m", f"{apart:g} * d", "9.4.3(1)")
    if concrete.annex.links_alone:
        A_sw = en1992.links_alone(stress.v_Ed * stress.u * demand.d, demand.d, bars.f_yd)
        words, formula = "vertical links of the two inner perimeters together", en1992.FORMULAS["A_sw alone"]
        yield Step(words, "A_sw", A_sw * 1e4, "cm2", formula, "6.4.5(1) of the annex")
    else:
        first = concrete.annex.link_rows[0] * demand.d
        count = en1992.links_that_count(stress.distance, first, s_r, demand.d)
        words = "perimeters of links that count, at most 1.5 d / s_r and not beyond a"
        yield Step(words, "n_s", count, clause="6.4.5(1)")
        A_sw = en1992.links_per_perimeter(stress.v_Ed, demand.resistance(stress), stress.u, demand.d, count, bars.f_yd)
        formula = en1992.FORMULAS["A_sw"]
        yield Step("vertical links on each perimeter", "A_sw", A_sw * 1e4, "cm2", formula, "6.4.5(1), 6.52")
    yield from _reach(demand, concrete.annex)


def _reach(demand: Demand, annex: Annex) -> Iterator[Step]:
    """Yield the outer perimeter and the perimeters of links inside it."""
    beyond, d = outer(demand), demand.d
    if beyond.last is None:
        words = "distance of the perimeter followed next, on which no links are needed"
        yield Step(words, "a_out", beyond.distance, "m", clause="6.4.5(4)")
        yield Step("its length", "u_out", beyond.u, "m", clause="6.4.5(4)")
    else:
        yield from _beyond(beyond, beyond.last)
    last = beyond.last_links(d)
    words = "distance of the outermost links from the face, at least"
    yield Step(words, "a_L", last, "m", f"a_out - {LAST_LINKS:g} * d", "6.4.5(4)")
    nearest, apart, _ = annex.link_rows
    first = nearest * d
    words = "distance of the innermost links from the face, at most"
    yield Step(words, "a_F", first, "m", f"{nearest:g} * d", "9.4.3(4)")
    count = max(LEAST_ROWS, math.ceil((last - first) / (apart * d)) + 1)
    formula = f"max({LEAST_ROWS}, ceil((a_L - a_F) / s_r) + 1)"
    yield Step("perimeters of links, at least", "n_L", float(count), "", formula, "9.4.3(1)")


def _beyond(beyond: Outer, last: Stress) -> Iterator[Step]:
    """Yield the outer perimeter beyond the outermost one that is followed."""
    yield Step("distance of the outermost perimeter that is followed", "a_l", last.distance, "m", clause="6.4.4(2)")
    yield Step("its length, less edges and openings", "u_l", last.u, "m", clause="6.4.2")
    yield Step("stress on it", "v_l", last.v_Ed / MEGA, "MPa", clause="6.4.3(3), 6.38")
    formula = en1992.FORMULAS["u_out"]
    yield Step("length of the perimeter beyond which no links are needed", "u_out", beyond.u, "m", formula, "6.54")
    formula, inner = "2 * pi", beyond.inner
    if inner is not None:
        yield Step("distance of the perimeter inside it", "a_i", inner.distance, "m", clause="6.4.4(2)")
        yield Step("its length, less edges and openings", "u_i", inner.u, "m", clause="6.4.2")
        formula = f"max((u_l - u_i) / (a_l - a_i), {LEAST_GROWTH:g})"
    yield Step("how much longer perimeters are by their distance", "g", beyond.grows, "", formula)
    yield Step("its distance", "a_out", beyond.distance, "m", "a_l + max(u_out - u_l, 0) / g", "6.4.5(4)")


def _face(face: Stress, concrete: Concrete, d: float) -> Iterator[Step]:
    """Yield the stress at the face and what the concrete bears there."""
    yield Step("force that punches at the face", "V_Ed,0", face.V_Ed / MEGA, "MN", clause="6.4.5(3)")
    yield Step("perimeter of the face that counts", "u_0", face.u, "m", clause="6.4.5(3)")
    if face.beta is None:
        added = face.v_Ed * face.u * d - face.V_Ed
        words = "what the column's own moments about the outermost perimeter's center add"
        yield Step(words, "V_M,0", added / MEGA, "MN", clause="6.4.5(3)")
        formula = "(V_Ed,0 + V_M,0) / (u_0 * d)"
    else:
        words = "factor for the column's own force and moments about the outermost perimeter's center"
        yield Step(words, "beta_0", face.beta, clause="6.4.5(3)")
        formula = "beta_0 * V_Ed,0 / (u_0 * d)"
    yield Step("stress at the face", "v_Ed,0", face.v_Ed / MEGA, "MPa", formula, "6.4.5(3)")
    a, b, c = concrete.annex.nu
    yield Step("factor of the concrete in struts", "alpha_cc", concrete.alpha_cc_shear, clause="3.1.6(1)")
    formula = f"{concrete.annex.face:g} * {a:g} * min(1, {b:g} - f_ck / {c:g}) * alpha_cc * f_ck / gamma_C"
    v_Rd_max = (en1992.max_resistance(concrete) or 0.0) / MEGA
    yield Step("largest resistance", "v_Rd,max", v_Rd_max, "MPa", formula, "6.4.5(3), 6.2.2(6)")
    yield Step("share used at the face", "eta_0", face.v_Ed / MEGA / v_Rd_max, "", "v_Ed,0 / v_Rd,max", "6.4.5(3)")
