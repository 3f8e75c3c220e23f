"""Punching by EN 1992-1-1:2023 at columns, piles, zones and walls' ends, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import isclose, isfinite

from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.codes.en1992_2023.checks.critical_sections import CriticalSection
from groundslab.design.codes.en1992_2023.checks.punching import LaidLinks, laid_links, links_needed, outermost_depth
from groundslab.design.codes.en1992_2023.checks.punching_demand import Punching
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import in_shear
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
    inside_steps,
    length_by_figures,
    moment_steps,
    punching_force,
    some,
    thinner_steps,
    width_steps,
)
from groundslab.design.rules.punching_beta import beta_in_steps, other_betas_in_steps
from groundslab.design.rules.wall_ends import WallSite
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement

F = en1992.FORMULAS


def steps(demand: Punching, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand."""
    concrete, bars = materials(steel, demand.limit_state)
    what = support, demand.pulls
    axes = steel.top_axes if from_below(what) else steel.bottom_axes
    yield from depth_steps(demand.d, axes, "d_v", "8.4.2(1), 8.91")
    if demand.wall is not None:
        yield from _at_wall(demand, demand.wall)
    else:
        inside = demand.force, demand.others, demand.pressure, demand.edge
        symbols, relieves = ("N_Ed", "V_Ed"), steel.line_force_relieves
        loads_inside = demand.inside, demand.cases
        yield from punching_force(what, symbols, inside, loads_inside, demand.V_Ed, "8.4.2(6)", relieves=relieves)
        assert demand.section is not None
        yield from _length(demand, demand.section)
    if demand.section is None:
        yield Step("factor for an end or a corner", "beta_e", demand.beta_e or 0.0, clause="Figure 8.21")
    elif demand.way == "code":
        yield from _beta(demand, demand.section, what)
    else:
        yield beta_in_steps(demand.way, demand.beta_e or 0.0, "beta_e", "8.4.2(6), Table 8.3")
    if demand.section is not None and demand.beta_e is not None:
        others = demand.other_betas()
        yield from other_betas_in_steps(demand.way, demand.beta_e, others, "beta_e", "8.4.2(6)")
    yield from _stress(demand)
    yield from in_shear(concrete, bars, demand.d, "d_v")
    formula = _face_of_wall(demand) if demand.section is None else _by_figures(demand.section, 0.0, demand.b_0)
    yield Step("perimeter at the face that counts", "b_0", demand.b_0, "m", formula, "8.4.3(1), Figure 8.18")
    formula = F["k_pb"]
    if not isclose(demand.gradient_length, demand.b_05, rel_tol=BY_CHORDS):
        words = "perimeter at d_v / 2 without what openings or thinner slab take off there alone"
        yield Step(words, "b_g", demand.gradient_length, "m", clause="8.4.3(1)")
        formula = formula.replace("b_05", "b_g")
    yield Step("factor of the shear gradient", "k_pb", demand.k_pb, "", formula, "8.4.3(1), 8.96")
    yield from _bars(demand)
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
    laid = steel.links_at(demand.name)
    assert laid is not None
    concrete, bars = materials(steel, demand.limit_state)
    yield from _stress_with_links(demand)
    yield Step("share of the concrete", "eta_c", links.eta[0], "", "min(1, tau_Rd,c / tau_Ed)", "8.4.4(1), 8.105")
    yield Step("diameter of the links given", "phi_w", laid.diameter * 1e3, "mm")
    yield Step("share of links", "eta_s", links.eta[1], "", F["eta_s"], "8.4.4(1), 8.106")
    yield Step("strength of links", "f_ywd", bars.f_yd / MEGA, "MPa", clause="5.2.4")
    yield Step("legs on each perimeter, the fewest", "n_w", links.A_sw / laid.leg_area)
    formula = "n_w * pi / 4 * (phi_w / 10)^2"
    yield Step("links given on each perimeter", "A_sw", links.A_sw * 1e4, "cm2", formula, "8.4.4(1)")
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


def _at_wall(demand: Punching, wall: WallSite) -> Iterator[Step]:
    """Yield the perimeter at an end or a corner of walls, and the shear force across it."""
    a, clause = en1992.DISTANCE * demand.d, "8.4.2(2) to (5)"
    whole = "b_05" if isclose(demand.b_05, wall.whole(a), rel_tol=BY_CHORDS) else "b_w"
    yield Step("distance of the perimeter from the face", "a", a, "m", f"{en1992.DISTANCE:g} * d_v", "8.4.2(2)")
    yield from wall.course_steps(a, ("d_v", "a", whole, "b_05"), clause)
    yield from wall.force_steps(a, demand.V_Ed, (whole, "V_Ed"), "8.4.2(6)")


def _face_of_wall(demand: Punching) -> str:
    """Return the formula of the perimeter at the faces of an end or a corner of walls."""
    assert demand.wall is not None
    area = demand.wall.area
    along = "2 * l_1" if demand.wall.end.kind == "end" else "l_1 + l_2"
    formula = f"b_e + {along}" if area.across else along
    return formula if isclose(area.across + sum(area.along), demand.b_0, rel_tol=BY_CHORDS) else ""


def _length(demand: Punching, section: CriticalSection) -> Iterator[Step]:
    """Yield what the length of a perimeter is made of."""
    a = en1992.DISTANCE * demand.d
    yield Step("distance of the perimeter from the face", "a", a, "m", f"{en1992.DISTANCE:g} * d_v", "8.4.2(2)")
    yield from width_steps(section.sides, section.line.setbacks)
    whole = total_length(section.line.whole)
    yield from thinner_steps(section.parts, lambda n: f"1 - t_{n} / d_v", "8.4.2(2) to (5)")
    yield from counted_length(whole, _by_figures(section, a, whole), ("b_05", demand.b_05), "8.4.2(2) to (5)")


def _by_figures(section: CriticalSection, a: float, length: float) -> str:
    """Return the formula of a perimeter's length [m] at a distance a [m] from the face, if one has it."""
    formula = length_by_figures(section.sides, section.line.setbacks, ("a", a), length)
    return formula if a else re.sub(r" \+ [\w /*]*\ba$", "", formula.replace("(c_1 + 2 * a)", "c_1"))


def _beta(demand: Punching, section: CriticalSection, what: tuple[Support, bool]) -> Iterator[Step]:
    """Yield how beta_e follows from the support's eccentricity, or what moments add where nothing pushes."""
    assert demand.parts is not None
    support, _ = what
    yield axis_step(section.axes)
    moments, at_zone = demand.beta_e is None, support == "zone"
    for n, e, width in zip((1, 2), demand.eccentricities, section.widths, strict=True):
        if moments or at_zone:
            M = e if moments else e * demand.V_Ed
            sums = demand.others, demand.pressure, demand.edge
            yield from moment_steps(n, demand.parts, ("N_Ed", demand.force), M, what, sums=sums)
        else:
            M_c, away = float(demand.parts.own[n - 1]), float(demand.parts.away[n - 1])
            words = Message("moment of the {support} itself along axis {n}", support=support, n=n)
            yield Step(words, f"M_c,{n}", M_c / MEGA, "MNm")
            words = Message(
                "center of the {support} from that of what counts of the perimeter, along axis {n}",
                support=support,
                n=n,
            )
            yield Step(words, f"x_{n}", some(away), "m")
        if not moments:
            words = Message("eccentricity of the {name}'s force along axis {n}", name=support, n=n)
            formula = f"M_{n} / V_Ed" if at_zone else f"x_{n} + M_c,{n} / N_Ed"
            yield Step(words, f"e_b,{n}", some(e), "m", formula, "Table 8.3")
        words = Message("overall width of the perimeter along axis {n}", n=n)
        yield Step(words, f"b_{n}", width, "m", clause="Figure 8.21")
    counted = en1992.eccentricity(section.course.shape, *demand.eccentricities)
    formula = F[f"e_b {_kind(section)}"]
    if moments:
        yield Step("moment that counts", "M_b", counted / MEGA, "MNm", formula.replace("e_", "M_"), "Table 8.3")
        return
    formula = formula.replace("e_1", "e_b,1").replace("e_2", "e_b,2")
    yield Step("eccentricity that counts", "e_b", some(counted), "m", formula, "Table 8.3")
    yield Step("factor of concentrated shear", "beta_e", demand.beta_e or 0.0, "", F["beta_e"], "8.4.2(6), Table 8.3")


def _bars(demand: Punching) -> Iterator[Step]:
    """Yield the ratio of bars in tension that counts."""
    most, clause = f"{en1992.MOST_BARS:g}", "8.4.3(1), 8.95"
    if demand.bars is None:
        words = "ratio of bars in tension, none being laid the largest that counts"
        yield Step(words, "rho_l", demand.ratio, "", most, clause)
        return
    for axis, area in zip("xy", demand.bars, strict=True):
        words = Message("bars along {axis}, mean over the width and 3 d on each side", axis=Name(axis))
        yield Step(words, f"A_{axis}", area * 1e4, "cm2/m", clause=clause)
    formula = f"min({most}, sqrt(A_x * A_y) / (10000 * d_v))"
    yield Step("ratio of bars in tension that counts", "rho_l", demand.ratio, "", formula, clause)


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


def _stress_with_links(demand: Punching) -> Iterator[Step]:
    """Yield tau_Ed of a slab with links, in which the pressure up to the perimeter relieves."""
    words, formula = "stress with links, the pressure up to the perimeter relieving", ""
    others, pressure = demand.inside_links
    way = -1.0 if from_below(("column", demand.pulls)) else 1.0
    pushing = (
        demand.wall is None and abs(demand.force + way * (others - pressure) - demand.V_links) < 1e-6 * demand.force
    )
    if pushing and demand.beta_e is not None:
        assert demand.section is not None
        yield from inside_steps((others, pressure), demand.section.inside.size, demand.cases_links, ",l")
        signs = ("-", "+") if way < 0 else ("+", "-")
        of_force = f"N_Ed {signs[0]} N_o,l {signs[1]} N_p,l"
        yield Step("force that punches with links", "V_l", demand.V_links / MEGA, "MN", of_force, "8.4.2(6)")
        by_force = demand.beta_e * demand.V_links / (demand.b_05 * demand.d)
        formula = F["tau_Ed"].replace("V_Ed", "V_l") if isclose(by_force, demand.tau_links, rel_tol=1e-9) else ""
    yield Step(words, "tau_Ed", demand.tau_links / MEGA, "MPa", formula, "8.4.2(6)")


def _links(demand: Punching, steel: Reinforcement) -> Iterator[Step]:
    """Yield the links that are needed, and the most that they can carry."""
    concrete, bars = materials(steel, demand.limit_state)
    out = outermost_depth(demand, steel)
    links = links_needed(demand, steel, out)
    yield from _stress_with_links(demand)
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
