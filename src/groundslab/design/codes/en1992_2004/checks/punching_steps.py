"""Punching by EN 1992-1-1 at columns, piles, zones and ends of walls, step by step, as it can be followed by hand.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import numpy as np

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
from groundslab.design.demands.line_properties import total_length
from groundslab.design.rules.calculation import (
    BY_CHORDS,
    MEGA,
    SAME,
    Step,
    Support,
    axis_step,
    depth_steps,
    from_below,
    inside_steps,
    length_by_figures,
    moment_steps,
    punching_force,
    thinner_steps,
    width_steps,
)
from groundslab.design.rules.punching_beta import beta_in_steps, other_betas_in_steps
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement

#: Where DIN EN 1992-1-1/NA, the one annex with a bound, has the least beta: for slabs and for foundations.
LEAST_BETA = "6.4.3(3), NA.6.39.1, 6.4.4(2), NA.6.51.1"
TRANSFERRED = "share of it that shear transfers"
AT_CORNER, BY_MOMENTS = "factor for a column at a corner", "factor for moments"


def steps(demand: Demand, steel: Reinforcement, support: Support) -> Iterator[Step]:
    """Yield the steps of a demand on the perimeter that uses most."""
    worst = governing(demand, steel)
    assert worst is not None
    stress = worst.stress
    concrete, bars = materials(steel, demand.limit_state)
    what = support, demand.pulls
    axes = steel.top_axes if from_below(what) else steel.bottom_axes
    yield from depth_steps(demand.d, axes, clause="6.4.2(1)")
    words = "distance of the perimeter from the face, where v_Ed / v_Rd is largest"
    yield Step(words, "a", stress.distance, "m", clause="6.4.4(2)")
    if stress.control is not None:
        inside = demand.force, stress.others, stress.pressure, stress.edge
        size, relieves = (stress.control.loads.size, stress.cases), steel.line_force_relieves
        symbols, clause = ("N_Ed", "V_Ed"), "6.4.4(2), 6.48"
        yield from punching_force(what, symbols, inside, size, stress.V_Ed, clause, relieves=relieves)
        constant = _has_constant(stress, stress.control)
        yield from _length(stress.control, along_axes=not constant or _face_has_moments(demand, concrete))
        yield from _beta(stress, stress.control, concrete.annex.least_beta, what, demand.force)
    else:
        assert demand.wall is not None
        opened = not math.isclose(stress.u, demand.wall.whole(stress.distance), rel_tol=BY_CHORDS)
        whole = "u_w" if opened else "u"
        yield from demand.wall.course_steps(stress.distance, ("d", "a", whole, "u"), "6.4.2")
        yield from demand.wall.force_steps(stress.distance, stress.V_Ed, (whole, "V_Ed"), "6.4.4(2)")
        yield Step(
            "factor for an end or a corner", "beta", stress.beta or 0.0, clause="DIN EN 1992-1-1/NA Figure NA.6.21.1"
        )
    formula = en1992.FORMULAS["v_Ed by M" if stress.beta is None else "v_Ed"]
    yield Step("stress", "v_Ed", stress.v_Ed / MEGA, "MPa", formula, "6.4.3(3), 6.38")
    yield from _resistance(demand, stress, concrete, bars)
    yield Step("share used", "eta", demand.used(stress), "", "v_Ed / v_Rd", "6.4.4(2)")
    links = laid_links(demand, stress, steel)
    if stress.v_Ed > demand.resistance(stress) or links is not None:
        yield from _most(demand, stress, concrete)
    if links is not None:
        yield from _as_laid(demand, stress, steel, links)
    elif stress.v_Ed > demand.resistance(stress):
        yield from _with_links(demand, stress, concrete, bars)
    if demand.face is not None and stress.control is not None and concrete.annex.face:
        if constant and _face_has_moments(demand, concrete):
            yield axis_step(stress.control.course.frame)
        yield from _face(demand.face, stress.control, demand, concrete, what)


def _length(control: ControlPerimeter, *, along_axes: bool) -> Iterator[Step]:
    """Yield what the length of a perimeter is made of, at a corner with extents along axes only if these are used."""
    line = control.sketch.line
    at_corner = control.course.shape == "corner"
    formulas = ("", "")
    if at_corner:
        for n, width in enumerate(control.sides, 1):
            yield Step(Message("width of what is loaded across edge {n}", n=n), f"w_{n}", width, "m")
        angle, formulas = _extents_at_corner(control)
        if formulas[0] and along_axes:
            words = "angle between axis 1 and the direction across edge 1"
            yield Step(words, "beta_1", math.degrees(angle), "degrees")
    widths = () if formulas[0] and not along_axes else control.widths
    yield from width_steps(widths, line.setbacks, formulas=formulas)
    whole, legs = total_length(control.sketch.line.whole), total_length(control.legs)
    openings, thinner = whole - legs, legs - control.u
    less = [
        (words, symbol, length)
        for words, symbol, length in (
            ("what lies between the tangents to openings", "u_o", openings),
            ("what counts less in thinner slab", "u_t", thinner),
        )
        if length > SAME * whole
    ]
    yield from thinner_steps(control.sketch.parts, _of_thinner, "6.4.4(2), 6.4.2(8)", away=True)
    symbol = "u_w" if less else "u"
    formula = _by_figures(control, "a", whole)
    yield Step("length of the perimeter on the slab", symbol, whole, "m", formula, "6.4.2")
    for words, name, length in less:
        yield Step(words, name, length, "m", clause="6.4.2(3)" if name == "u_o" else "6.4.4(2)")
    if less:
        formula = " - ".join([symbol, *(name for _, name, _ in less)])
        yield Step("what counts of it", "u", control.u, "m", formula, "6.4.2")


def _of_thinner(n: int) -> str:
    """Return the formula of the share of a length that counts in part n of thinner slab."""
    return f"min(1, max(1, 2 * (d - t_{n}) / (a - b_{n})) * a * (d - t_{n}) / (2 * d^2))"


def _has_constant(stress: Stress, control: ControlPerimeter) -> bool:
    """Return whether beta of a perimeter at a corner is the constant, and none of moments about its center."""
    simple = stress.beta is not None and stress.way == "code" and not stress.both
    return simple and control.course.shape not in ("closed", "edge")


def _face_has_moments(demand: Demand, concrete: Concrete) -> bool:
    """Return whether what counts at the face follows from moments about the center of the outermost perimeter."""
    face = demand.face
    if face is None or face.outer is None or not concrete.annex.face or face.way != "code":
        return False
    return not _has_constant(face, face.outer)


def _extents_at_corner(control: ControlPerimeter) -> tuple[float, tuple[str, str]]:
    """Return the angle [rad] between axis 1 and the direction across the first edge, and formulas of both extents.

    They are those of a rectangle whose sides run along two edges at a right angle; without formulas it is none such.
    """
    if len(control.sides) != 2:
        return 0.0, ("", "")
    (w_1, w_2), across = control.sides, control.course.inward[0]
    cosine, sine = (abs(float(axis @ across)) for axis in control.course.frame)
    by_hand = w_1 * cosine + w_2 * sine, w_1 * sine + w_2 * cosine
    if not all(math.isclose(*pair, rel_tol=SAME) for pair in zip(by_hand, control.widths, strict=True)):
        return 0.0, ("", "")
    c, s = "abs(cos(beta_1 * pi / 180))", "abs(sin(beta_1 * pi / 180))"
    return math.atan2(sine, cosine), (f"w_1 * {c} + w_2 * {s}", f"w_1 * {s} + w_2 * {c}")


def _beta(
    stress: Stress, control: ControlPerimeter, least: float, what: tuple[Support, bool], force: float
) -> Iterator[Step]:
    """Yield how beta follows from the moments of all forces inside about the perimeter's center, or else."""
    if stress.way == "code":
        yield from _beta_by_moments(stress, control, least, what, ("N_Ed", force), "V_Ed")
    else:
        yield beta_in_steps(stress.way, stress.beta or 0.0, "beta", "6.4.3(6), Figure 6.21N")
    if stress.beta is not None:
        yield from other_betas_in_steps(stress.way, stress.beta, stress.other_betas(), "beta", "6.4.3")


def _beta_by_moments(
    stress: Stress,
    control: ControlPerimeter,
    least: float,
    what: tuple[Support, bool],
    column_force: tuple[str, float],
    raised: str,
    of: str = "",
) -> Iterator[Step]:
    """Yield how beta follows from the moments of all forces inside about the perimeter's center.

    `column_force` is the symbol and size of the force at the column [N], `raised` the symbol of what beta raises, and
    `of` what ends the symbols.
    """
    symbol, shape = "beta_0" if of else "beta", control.course.shape
    if _has_constant(stress, control):
        yield Step(AT_CORNER, symbol, stress.beta or 0.0, clause="6.4.3(6), Figure 6.21N")
        return
    at_edge = shape == "edge" and stress.beta is not None
    general = stress.both or not at_edge
    if not of:
        yield axis_step(control.course.frame)
    for n in (1, 2) if general else (1,):
        yield from _moment(n, stress, what, column_force, of)
        if general:
            yield from _share(n, control, of)
        yield _modulus(n, control, of)
    if at_edge:
        yield from _edge_share(control, of)
        yield from _reduced(control, of)
    if stress.beta is None:
        return
    if least > 1 and not of:
        yield Step("least factor of the annex", "beta_min", least, clause=LEAST_BETA)
    formulas = {"beta": _formula("beta", raised, of), "beta at an edge": _formula("beta at an edge", raised, of)}
    clauses = {"beta": "6.4.3(3), 6.39, 6.51", "beta at an edge": "6.4.3(4), 6.44"}
    words, name = (BY_MOMENTS, "beta") if general else ("factor for moments along the edge", "beta at an edge")
    bounds = ["beta_min"] if least > 1 else []
    if not stress.both:
        formula = f"max({bounds[0]}, {formulas[name]})" if bounds else formulas[name]
        yield Step(words, symbol, stress.beta, "", formula, clauses[name])
        return
    force = stress.V_Ed if not of else column_force[1]
    by_moments, simple = _both(stress, control, force)
    yield Step(BY_MOMENTS, f"beta_g{of}", by_moments, "", formulas["beta"], clauses["beta"])
    if at_edge:
        words, formula = "factor for moments along the edge", formulas["beta at an edge"]
        yield Step(words, f"beta_e{of}", simple, "", formula, clauses["beta at an edge"])
    else:
        yield Step(AT_CORNER, f"beta_e{of}", simple, clause="6.4.3(6), Figure 6.21N")
    formula = f"max({', '.join([*bounds, f'beta_g{of}', f'beta_e{of}'])})"
    words = "factor beside an opening, or where the column is bent outwards: the larger one"
    yield Step(words, symbol, stress.beta, "", formula, "6.4.3")


def _both(stress: Stress, control: ControlPerimeter, force: float) -> tuple[float, float]:
    """Return beta by 6.39, and by 6.44 at an edge or the constant at a corner, of a force [N]."""
    shares, moduli = [*map(float, control.shares)], [*map(float, control.moduli)]
    general = en1992.raised(stress.moments, shares, force, control.u, moduli)
    if control.course.shape != "edge":
        return general / force, en1992.CORNER
    share = en1992.transfer_share(en1992.edge_ratio(*control.widths))
    simple = en1992.raised_at_an_edge(control.reduced, stress.moments[0], share, force, control.u, moduli[0])
    return general / force, simple / force


def _formula(name: str, raised: str, of: str) -> str:
    """Return a formula of beta with the symbol of the force that it raises, and what ends the other symbols."""
    formula = en1992.FORMULAS[name].replace("V_Ed", raised)
    if of:
        formula = re.sub(r"\b([kMW]_[12e])\b", rf"\1{of}", formula)
        formula = re.sub(r"\b([us])\b", rf"\1_{of[1:]}", formula)
    return formula


def _moment(
    n: int, stress: Stress, what: tuple[Support, bool], column_force: tuple[str, float], of: str
) -> Iterator[Step]:
    """Yield the moment along axis n = 1 or 2."""
    assert stress.parts is not None
    sums = stress.others, stress.pressure, stress.edge
    yield from moment_steps(n, stress.parts, column_force, stress.moments[n - 1], what, of, sums)


def _share(n: int, control: ControlPerimeter, of: str) -> Iterator[Step]:
    """Yield the share of a moment along axis n = 1 or 2 that shear transfers."""
    formula = en1992.FORMULAS["k_n"].replace("c_n", f"c_{n}").replace("c_m", f"c_{3 - n}")
    yield Step(TRANSFERRED, f"k_{n}{of}", float(control.shares[n - 1]), "", formula, "Table 6.1")


def _edge_share(control: ControlPerimeter, of: str) -> Iterator[Step]:
    """Yield the share of a moment along an edge that shear transfers, and the ratio of sides that it is taken by."""
    ratio = en1992.edge_ratio(*control.widths)
    words = "ratio of sides c_1 / (2 c_2), the larger of both ways to read it"
    formula = en1992.FORMULAS["k_e"].replace("c_r", f"c_r{of}")
    yield Step(words, f"c_r{of}", ratio, "", en1992.FORMULAS["c_r"], "6.4.3(4)")
    words = "share of the moment along the edge that shear transfers"
    yield Step(words, f"k_e{of}", en1992.transfer_share(ratio), "", formula, "6.4.3(4), Table 6.1")


def _modulus(n: int, control: ControlPerimeter, of: str) -> Step:
    """Return the modulus of a perimeter along axis n = 1 or 2."""
    words = Message("modulus of the perimeter along axis {n}, the integral of the distance from its center", n=n)
    return Step(words, f"W_{n}{of}", float(control.moduli[n - 1]), "m2", clause="6.40")


def _reduced(control: ControlPerimeter, of: str) -> Iterator[Step]:
    """Yield the share of a perimeter at an edge that counts for moments across it."""
    c_1, c_2 = control.widths
    least = min(1.5 * control.depth, 0.5 * c_2)
    by_figure = c_1 + 2 * least + math.pi * control.distance
    length = control.reduced * control.u
    a, u, s, u_r = (f"{symbol}_{of[1:]}" if of else symbol for symbol in ("a", "u", "s", "u_r"))
    follows = math.isclose(by_figure, length, rel_tol=BY_CHORDS)
    formula = f"c_1 + 2 * min(1.5 * d, 0.5 * c_2) + pi * {a}" if follows else ""
    yield Step("part of the perimeter that counts", u_r, length, "m", formula, "Figure 6.20a")
    yield Step("its share, u_1* / u_1", s, control.reduced, "", f"{u_r} / {u}", "6.4.3(4)")


def _resistance(demand: Demand, stress: Stress, concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield what resists without links."""
    yield Step("strength of the concrete", "f_ck", concrete.f_ck_shear / MEGA, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")
    yield from _bars(demand, concrete, bars)
    yield Step("factor of size", "k", en1992.size_factor(demand.d), "", en1992.FORMULAS["k"], "6.4.4(1)")
    yield Step("C_Rd,c gamma_C of the annex", "C", concrete.annex.c_rd_c_punching, clause="6.4.4(1)")
    yield Step("least factor of the annex", "v_min", en1992.least_factor(concrete, demand.d), clause="6.2.2(1), 6.3N")
    formula = en1992.FORMULAS["v_Rd,c"]
    yield Step("resistance at 2 d", "v_Rd,c", demand.v_Rd_c / MEGA, "MPa", formula, "6.4.4(1), 6.47")
    resistance = demand.resistance(stress) / MEGA
    assert REACH == 2.0
    yield Step("resistance at a", "v_Rd", resistance, "MPa", en1992.FORMULAS["v_Rd"], "6.4.4(2), 6.50")


def _bars(demand: Demand, concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield the ratio of bars in tension that counts."""
    most, formula = en1992.most_bars(concrete, bars), f"{en1992.MOST_BARS:g}"
    limit = concrete.annex.rho_strength
    if limit * concrete.f_cd / bars.f_yd < en1992.MOST_BARS:
        yield Step("design strength of the concrete", "f_cd", concrete.f_cd / MEGA, "MPa", clause="3.1.6(1)")
        yield Step("design yield strength", "f_yd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
        formula = f"{limit:g} * f_cd / f_yd"
    yield Step("largest ratio of bars that counts", "rho_max", most, "", formula, "6.4.4(1)")
    if demand.bars is None:
        yield Step("ratio of bars in tension, none being laid the largest", "rho_l", demand.ratio, "", "rho_max")
        return
    for axis, area in zip("xy", demand.bars, strict=True):
        words = Message("bars along {axis}, mean over the width and 3 d on each side", axis=Name(axis))
        yield Step(words, f"A_{axis}", area * 1e4, "cm2/m", clause="6.4.4(1)")
    formula = "min(rho_max, sqrt(A_x * A_y) / (10000 * d))"
    yield Step("ratio of bars in tension that counts", "rho_l", demand.ratio, "", formula, "6.4.4(1)")


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
    laid = steel.links_at(demand.name)
    assert laid is not None
    yield from _strength_of_links(demand, materials(steel, demand.limit_state)[1])
    yield Step("diameter of the links given", "phi_w", laid.diameter, "m")
    legs = links.A_sw / laid.leg_area
    area, clause = "n_w * pi / 4 * phi_w^2 * 10000", "6.4.5(1)"
    if links.alone:
        words = "legs of both inner perimeters, or of a further one over its share if that is less"
        yield Step(words, "n_w", legs, clause="6.4.5(1) of the annex")
        yield Step("links that count", "A_sw", links.A_sw * 1e4, "cm2", area, "6.4.5(1) of the annex")
    else:
        yield Step("legs on each perimeter, the fewest", "n_w", legs)
        yield Step("links given on each perimeter", "A_sw", links.A_sw * 1e4, "cm2", area, clause)
        s_r = laid.apart or materials(steel, demand.limit_state)[0].annex.link_rows[1] * demand.d
        yield Step("distance of perimeters, the largest", "s_r", s_r, "m", clause=clause)
        yield Step("distance of the innermost one from the face", "a_F", laid.distances[0], "m", clause=clause)
        by_clause = en1992.links_that_count(stress.distance, laid.distances[0], s_r, demand.d)
        formula = en1992.FORMULAS["n_s"] if math.isclose(links.rows, by_clause) else ""
        words = "perimeters of links that count, no more than are given"
        yield Step(words, "n_s", links.rows, "", formula, clause)
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
        formula = f"{concrete.annex.link_rows[0]:g} * d"
        yield Step("distance of the innermost links from the face, at most", "a_F", first, "m", formula, "9.4.3(4)")
        words = "perimeters of links that count, at most 1.5 d / s_r and not beyond a"
        yield Step(words, "n_s", count, "", en1992.FORMULAS["n_s"], "6.4.5(1)")
        A_sw = en1992.links_per_perimeter(stress.v_Ed, demand.resistance(stress), stress.u, demand.d, count, bars.f_yd)
        formula = en1992.FORMULAS["A_sw"]
        yield Step("vertical links on each perimeter", "A_sw", A_sw * 1e4, "cm2", formula, "6.4.5(1), 6.52")
    yield from _reach(demand, concrete.annex, stress.control)


def _reach(demand: Demand, annex: Annex, governing_one: ControlPerimeter | None) -> Iterator[Step]:
    """Yield the outer perimeter and the perimeters of links inside it."""
    beyond, d = outer(demand), demand.d
    if beyond.last is None:
        words = "distance of the perimeter followed next, on which no links are needed"
        yield Step(words, "a_out", beyond.distance, "m", clause="6.4.5(4)")
        yield Step("its length", "u_out", beyond.u, "m", clause="6.4.5(4)")
    else:
        yield from _beyond(beyond, beyond.last, governing_one)
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


def _beyond(beyond: Outer, last: Stress, governing_one: ControlPerimeter | None) -> Iterator[Step]:
    """Yield the outer perimeter beyond the outermost one that is followed."""
    yield Step("distance of the outermost perimeter that is followed", "a_l", last.distance, "m", clause="6.4.4(2)")
    yield from _length_beyond(last, "l", governing_one)
    yield Step("stress on it", "v_l", last.v_Ed / MEGA, "MPa", clause="6.4.3(3), 6.38")
    formula = en1992.FORMULAS["u_out"]
    yield Step("length of the perimeter beyond which no links are needed", "u_out", beyond.u, "m", formula, "6.54")
    formula, inner = "2 * pi", beyond.inner
    if inner is not None:
        yield Step("distance of the perimeter inside it", "a_i", inner.distance, "m", clause="6.4.4(2)")
        yield from _length_beyond(inner, "i", governing_one)
        formula = f"max((u_l - u_i) / (a_l - a_i), {LEAST_GROWTH:g})"
    yield Step("how much longer perimeters are by their distance", "g", beyond.grows, "", formula)
    yield Step("its distance", "a_out", beyond.distance, "m", "a_l + max(u_out - u_l, 0) / g", "6.4.5(4)")


def _length_beyond(stress: Stress, end: str, governing_one: ControlPerimeter | None) -> Iterator[Step]:
    """Yield the length of a perimeter beyond the governing one, by its extents and setbacks if both have the same.

    `end` is what ends the symbols of its distance a, its length u, and of what openings and thinner slab take off.
    """
    control, words, u = stress.control, "its length, less edges and openings", f"u_{end}"
    if control is None:
        yield Step(words, u, stress.u, "m", clause="6.4.2")
        return
    whole = total_length(control.sketch.line.whole)
    less = whole - stress.u > BY_CHORDS * whole
    alike = governing_one is not None and _runs_alike(control, governing_one)
    formula, symbol = _by_figures(control, f"a_{end}", whole) if alike else "", f"u_w,{end}" if less else u
    yield Step("its length on the slab" if less else words, symbol, whole if less else stress.u, "m", formula, "6.4.2")
    if less:
        yield Step("what openings and thinner slab take off it", f"u_o,{end}", whole - stress.u, "m", clause="6.4.2(3)")
        yield Step(words, u, stress.u, "m", f"u_w,{end} - u_o,{end}", "6.4.2")


def _runs_alike(one: ControlPerimeter, other: ControlPerimeter) -> bool:
    """Return whether two perimeters run out to the same edges, and have the same extents along their axes."""
    first, second = one.sketch.line.setbacks, other.sketch.line.setbacks
    return (
        one.course.shape == other.course.shape
        and len(first) == len(second)
        and np.allclose((*first, *one.widths), (*second, *other.widths), rtol=SAME)
    )


def _by_figures(control: ControlPerimeter, a: str, whole: float) -> str:
    """Return the formula of a perimeter's length [m] on the slab, if one has it."""
    widths, names = control.widths, ("c_1", "c_2")
    if len(control.sides) == 2 and control.course.shape == "corner":
        widths, names = (control.sides[0], control.sides[1]), ("w_1", "w_2")
    return length_by_figures(widths, control.sketch.line.setbacks, (a, control.distance), whole, symbols=names)


def _face(
    face: Stress, control: ControlPerimeter, demand: Demand, concrete: Concrete, what: tuple[Support, bool]
) -> Iterator[Step]:
    """Yield the stress at the face and what the concrete bears there."""
    assert face.outer is not None
    signs = ("-", "+") if from_below(what) else ("+", "-")
    size = control.loads.size if face.control is None else face.control.loads.size
    yield from inside_steps((face.others, face.pressure), size, face.cases, ",0")
    without = demand.force + (face.others - face.pressure) * (-1.0 if from_below(what) else 1.0)
    formula = f"N_Ed {signs[0]} N_o,0 {signs[1]} N_p,0"
    follows = abs(without - face.V_Ed) <= SAME * max(abs(without), demand.force)
    yield Step(
        "force that punches at the face", "V_Ed,0", face.V_Ed / MEGA, "MN", formula if follows else "", "6.4.5(3)"
    )
    formula = _face_by_clause(face, control, demand.d)
    yield Step("perimeter of the face that counts", "u_0", face.u, "m", formula, "6.4.5(3)")
    outer = face.outer
    yield Step("distance of the outermost perimeter, about which moments count", "a_R", outer.distance, "m")
    yield Step("its length", "u_R", outer.u, "m", clause="6.4.2")
    column_force = "N_Ed", demand.force
    if face.beta is None:
        yield from _beta_by_moments(face, outer, 1.0, what, column_force, "N_Ed", ",R")
        formula = "sqrt((k_1,R * M_1,R * u_R / W_1,R)^2 + (k_2,R * M_2,R * u_R / W_2,R)^2)"
        added = face.v_Ed * face.u * demand.d - face.V_Ed
        yield Step("what the column's own moments add", "V_M,0", added / MEGA, "MN", formula, "6.4.5(3)")
        formula = "(V_Ed,0 + V_M,0) / (u_0 * d)"
    else:
        if face.way == "code":
            least = concrete.annex.least_beta
            yield from _beta_by_moments(face, outer, least, what, column_force, "N_Ed", ",R")
        else:
            yield beta_in_steps(face.way, face.beta, "beta_0", "6.4.3(6), Figure 6.21N")
        formula = "beta_0 * V_Ed,0 / (u_0 * d)"
    yield Step("stress at the face", "v_Ed,0", face.v_Ed / MEGA, "MPa", formula, "6.4.5(3)")
    a, b, c = concrete.annex.nu
    yield Step("factor of the concrete in struts", "alpha_cc", concrete.alpha_cc_shear, clause="3.1.6(1)")
    formula = f"{concrete.annex.face:g} * {a:g} * min(1, {b:g} - f_ck / {c:g}) * alpha_cc * f_ck / gamma_C"
    v_Rd_max = (en1992.max_resistance(concrete) or 0.0) / MEGA
    yield Step("largest resistance", "v_Rd,max", v_Rd_max, "MPa", formula, "6.4.5(3), 6.2.2(6)")
    yield Step("share used at the face", "eta_0", face.v_Ed / MEGA / v_Rd_max, "", "v_Ed,0 / v_Rd,max", "6.4.5(3)")


def _face_by_clause(face: Stress, control: ControlPerimeter, d: float) -> str:
    """Return the formula of u_0 by 6.4.5(3), if one has it: inside, at an edge along axis 1, or at a corner.

    The perimeter that governs says which edges are near, and how far the face is from them.
    """
    c_1, c_2 = control.widths
    setbacks = [max(setback, 0.0) for setback in control.sketch.line.setbacks]
    s, names = sum(setbacks), [f"s_{n}" for n in range(1, len(setbacks) + 1)]
    whole = {"2 * (c_1 + c_2)": 2 * (c_1 + c_2), "pi * c_1": math.pi * c_1}
    by_edges = {
        1: {"c_1 + 2 * s_1 + min(3 * d, 2 * c_2)": c_1 + 2 * s + min(3 * d, 2 * c_2)},
        2: {" + ".join([*names, "min(3 * d, w_1 + w_2)"]): s + min(3 * d, sum(control.sides))},
    }
    candidates = by_edges.get(len(setbacks), {}) | whole
    return next((formula for formula, u in candidates.items() if math.isclose(u, face.u, rel_tol=BY_CHORDS)), "")
