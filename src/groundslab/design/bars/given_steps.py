"""What members have against what they need, step by step: links that are given, their distances, bars along strips."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from groundslab.design.bars.beam_bars import MemberCourse, face_need
from groundslab.design.bars.beam_steps import face_steps
from groundslab.design.rules.bending_steps import CM2
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.design_code import BeamRule
from groundslab.design.rules.webs import ALL_LEGS
from groundslab.model.design.beam_links import BeamLinks
from groundslab.model.design.reinforcement import Reinforcement

SHARE = "share used"


def links(
    course: MemberCourse, place: int, laid: BeamLinks, steel: Reinforcement, rule: BeamRule, state: str
) -> Iterator[Step]:
    """Yield what links a member needs at one place by shear and torsion against those that are given there."""
    steps = [*rule.web_steps(steel, state, course.webs.at(place))]
    yield from steps
    (symbol,) = (step.symbol for step in steps if step.words == ALL_LEGS)
    legs, closed, needed = laid.legs, float(course.web.closed[place]), symbol
    yield Step("legs of each link", "n_w", legs)
    if closed > 0 and legs != 2:
        of_torsion = "2 * a_t" if any(step.symbol == "a_t" for step in steps) else _by_tube(steps)
        yield Step("what both outer legs bear of torsion", "a_c", closed * CM2, "cm2/m", of_torsion)
        needed = "a_req"
        area = float(course.web.links_of(np.array(legs))[place])
        words, formula = "links that are needed with so many legs", f"{symbol} + (n_w / 2 - 1) * a_c"
        yield Step(words, needed, area * CM2, "cm2/m", formula)
    yield Step("diameter of the links given", "phi_w", laid.diameter, "m")
    yield Step("distance of the links given", "s", laid.spacing, "m")
    yield Step("links given, all legs together", "a_g", laid.area * CM2, "cm2/m", "n_w * pi / 4 * phi_w^2 / s * 10000")
    used = float(course.web.links_of(np.array(legs))[place]) / laid.area
    yield Step(SHARE, "eta_w", used, "", f"{needed} / a_g")


def _by_tube(steps: list[Step]) -> str:
    """Return the formula of what both outer legs bear of torsion, by struts as those of shear or at 45 degrees."""
    of_links = next(step.formula for step in steps if step.words == ALL_LEGS)
    return "T_Ed / A_k / (f_ywd * cot) * 10000" if "T_Ed / A_k) / (f_ywd" in of_links else "T_Ed / A_k / f_ywd * 10000"


def distance_of_links(
    course: MemberCourse, place: int, laid: BeamLinks, steel: Reinforcement, rule: BeamRule, state: str
) -> Iterator[Step]:
    """Yield how far links may be from each other at one place against how far they are."""
    assert rule.distance_steps is not None
    along, _ = rule.distance_steps(steel, state, course.webs.at(place), course.strained.at(place))
    yield from along
    yield Step("distance of the links given", "s", laid.spacing, "m")
    yield Step(SHARE, "eta_s", laid.spacing / along[-1].value, "", f"s / {along[-1].symbol}")


def distance_of_legs(
    course: MemberCourse, place: int, laid: BeamLinks, steel: Reinforcement, rule: BeamRule, state: str
) -> Iterator[Step]:
    """Yield how far legs of a link may be from each other at one place against how far they are."""
    assert rule.distance_steps is not None
    _, across = rule.distance_steps(steel, state, course.webs.at(place), course.strained.at(place))
    yield from across
    yield Step("width of the member", "b", course.at_d.b, "m")
    formula, cover = "(b - phi_w) / (n_w - 1)", steel.cover
    if cover is not None:
        yield Step("lesser cover, which the links keep to at their sides", "c", min(cover), "m")
        formula = "(b - 2 * c - phi_w) / (n_w - 1)"
    yield Step("diameter of the links given", "phi_w", laid.diameter, "m")
    yield Step("legs of each link", "n_w", laid.legs)
    apart = float(course.legs_apart(steel, laid.diameter, laid.legs))
    yield Step("distance of the legs", "s_w", apart, "m", formula)
    yield Step(SHARE, "eta_s", apart / across[-1].value, "", f"s_w / {across[-1].symbol}")


def bars_of_strip(
    course: MemberCourse, face: int, place: int, laid: float, steel: Reinforcement, rule: BeamRule, state: str
) -> Iterator[Step]:
    """Yield the bars that a strip needs at a face at one place against the slab's bars over its width, laid [m2]."""
    need = face_need(course, face, place)
    of_moment = course.bars[face][place]
    if need.bars is not None and need.zone is not None and need.bars.moment:
        yield from face_steps(need, steel, rule, state)
    else:
        yield Step("required area", "A_req", float(of_moment) * CM2, "cm2")
    of_torsion, needed = float(course.faces[face][place] - of_moment), "A_req"
    if of_torsion > 0:
        yield Step("bars for torsion at this face, half of all along the member", "A_t", of_torsion * CM2, "cm2")
        needed = "(A_req + A_t)"
    yield Step("bars of the slab over the width of the strip, laid there", "A_l", laid * CM2, "cm2")
    yield Step(SHARE, "eta_A", float(course.faces[face][place]) / laid if laid else math.inf, "", f"{needed} / A_l")
