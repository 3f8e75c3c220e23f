"""What can be judged of the strength from the given data, by the code of the case.

Only what fails whatever is built is called a failure. That nothing fails here is no approval: provided bars are not
known, and anchorage is not looked at.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from groundslab.design.bars import beam_bars, pit_walls, required_bars, wall_bars
from groundslab.design.bars.members import members_of
from groundslab.design.checks import pulling, punching
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import GIVEN_SECTION, DesignCheck, judge_apart, not_judged, some
from groundslab.design.rules.combinations import UNFACTORED, ultimate_results, why_none, without_partial_factors
from groundslab.design.rules.demand_errors import error_of_ratio, scaled
from groundslab.design.rules.design_code import BeamRule, DesignCode, no_rule
from groundslab.messages import Clause, Message, Name, joined
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.model.structure.beams import GivenSection
from groundslab.model.supports import Pile
from groundslab.results.results import Results

#: What is left to the engineer at pits.
PIT_WALLS = (
    "design by hand what is not checked: pressure of earth and water on the walls, their bars along, the bars of their "
    "corners with floor and slab, in which all bars of the slab must be anchored, and shear across the step"
)


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of strength in the ultimate combinations."""
    steel = combined.model.reinforcement
    if steel is None:
        yield DesignCheck("strength", "not checked", "strength was not checked: the case has no [reinforcement]")
        return
    if not ultimate_results(combined):
        words = Message("DESIGN NOT CHECKED: {why_none}", why_none=why_none(combined, STRENGTH, "ultimate combination"))
        yield DesignCheck("strength", "not checked", words)
        return
    code = code_of(steel)
    needs = required_bars.governing_needs(combined, steel)
    yield _bending(needs)
    yield _compression(needs, code.clauses.held_bars)
    if combined.model.columns or combined.model.supports or combined.model.walls:
        yield from _punching(combined, code)
        yield from pulling.checks(combined)
    if any(isinstance(support, Pile) for support in combined.model.supports):
        yield DesignCheck("piles", "not checked", "the strength of the piles themselves is not checked")
    if any(wall.height is not None for wall in combined.model.walls):
        yield from _walls(combined, code)
    yield from _pits(combined)
    if combined.model.beams or members_of(combined.model):
        yield from _beams(combined, code)
    if without_partial_factors(combined):
        yield DesignCheck("partial factors", "attention", UNFACTORED)
    if code.remarks is not None:
        yield from code.remarks(combined, steel)


def _beams(combined: Results, code: DesignCode) -> Iterator[DesignCheck]:
    """Yield whether beams can be reinforced; those that are not of concrete are not judged."""
    steel = combined.model.reinforcement
    assert steel is not None
    if code.beams is None:
        yield no_rule(code, "beams")
        return
    by_properties = [beam.name for beam in combined.model.beams if isinstance(beam.section, GivenSection)]
    if by_properties:
        yield not_judged(
            "beams by their properties", GIVEN_SECTION, Message("the strength of {names}", names=some(by_properties))
        )
    needs = beam_bars.beam_needs(combined, steel)
    if not needs:
        return
    if words := code.beams.cracks(steel):
        yield DesignCheck("cracks of beams", "not checked", words)
    judge = partial(_judged_beams, combined, code.name, code.beams)
    yield from judge_apart(needs, lambda need: need.beam, combined.model.checks.off, judge)


def _judged_beams(
    combined: Results, code: str, rule: BeamRule, needs: list[beam_bars.BeamNeed]
) -> Iterator[DesignCheck]:
    """Yield whether beams of concrete can be reinforced."""
    if flanges := [need for need in needs if need.what == "flange"]:
        yield _flanges(combined, flanges, f"{code} {rule.flange.clauses}")
    yield _webs(combined, needs, f"{code} {rule.web_clauses}")
    bars = [need for need in needs if need.what in ("bottom", "top")]
    clause = f"{code} {rule.clauses}"
    failing = [need for need in bars if np.isinf(need.area)]
    if not failing:
        most = max(bars, key=lambda need: need.area)
        words = Message(
            "they can be reinforced; most at the {what} of {beam}, {area:.4g cm2}",
            what=most.what,
            beam=most.beam,
            area=most.area * 1e4,
        )
        yield DesignCheck("beams", "no failure found", words, clause=clause)
        return
    worst = failing[0]
    words = Message(
        "the concrete of {number} of them is too weak for any reinforcement; {beam}, {what}, {way:.2f m} "
        'from its start: {force:.4g kNm} in "{combination}"',
        number=len({need.beam for need in failing}),
        beam=worst.beam,
        what=worst.what,
        way=worst.way,
        force=worst.force / 1e3,
        combination=Name(worst.combination),
    )
    yield DesignCheck("beams", "fails", words, of=worst.beam, combination=worst.combination, clause=clause)


def _walls(combined: Results, code: DesignCode) -> Iterator[DesignCheck]:
    """Yield whether struts of walls with a height bear their shear forces, and what of these walls is not checked."""
    steel = combined.model.reinforcement
    assert steel is not None
    if code.walls is None:
        yield no_rule(code, "walls")
    elif needs := wall_bars.wall_needs(combined, steel):
        judge = partial(_struts, combined, f"{code.name} {code.walls.clauses}")
        yield from judge_apart(needs, lambda need: need.wall, combined.model.checks.off, judge)
    words = "ties, forces along and across, ends, openings and joints of walls with a height are not designed"
    yield DesignCheck("rest of walls", "not checked", words)


def _pits(combined: Results) -> Iterator[DesignCheck]:
    """Yield whether walls of pits bear what floor and slab hand over at them, and what of pits is not designed."""
    steel = combined.model.reinforcement
    assert steel is not None
    judge = partial(_pit_walls, steel)
    needs = pit_walls.pit_wall_needs(combined, steel)
    if needs:
        yield from judge_apart(needs, lambda need: need.name, combined.model.checks.off, judge)


def _pit_walls(steel: Reinforcement, needs: list[pit_walls.PitWallNeed]) -> Iterator[DesignCheck]:
    """Yield whether walls of pits bear the moments of the slab, which needs attention even then."""
    worst = max(needs, key=lambda need: (need.area, need.design_moment))
    code, weak = code_of(steel), bool(np.isinf(worst.area))
    words: str = Message(
        '{moment:.4g kNm/m} at {place:.3f m} in "{combination}" bend its walls, {wall:g m} thick',
        moment=worst.design_moment / 1e3, place=worst.place, combination=Name(worst.combination), wall=worst.wall,
    )  # fmt: skip
    if worst.d <= 0:
        words = joined((words, "they are thinner than their bars lie deep"), "; ")
    elif weak:
        words = joined((words, "their concrete is too weak for any reinforcement"), "; ")
    else:
        words += Message(": {area:.3g cm2/m} of bars upright at either face", area=worst.area * 1e4)
    yield DesignCheck(
        "walls of pits", "fails" if weak else "attention", joined((words, PIT_WALLS), "; "), of=worst.name,
        combination=worst.combination, place=worst.place, clause=f"{code.name} {code.clauses.bars}",
        steps=tuple(_pit_steps(steel, worst)),
    )  # fmt: skip


def _pit_steps(steel: Reinforcement, need: pit_walls.PitWallNeed) -> Iterator[Step]:
    """Yield the calculation of the upright bars of a pit's walls, without these where the concrete is too weak."""
    yield Step("thickness of the wall", "t_w", need.wall, "m")
    yield Step("distance of the bars' axis from the face", "a_w", need.axis, "m")
    yield Step("effective depth", "d_w", need.d, "m", "t_w - a_w")
    yield Step("moment that floor and slab hand over", "m_n", need.moment / MEGA, "MNm/m")
    yield Step("twist beside it", "m_nt", need.twist / MEGA, "MNm/m")
    yield Step("force by which the floor hangs on the wall", "q_n", need.pull / MEGA, "MN/m")
    formula = "abs(m_n) + abs(m_nt) + max(q_n, 0) * d_w / 2"
    yield Step("moment", "m_Ed", need.design_moment / MEGA, "MNm/m", formula)
    by_steps = code_of(steel).bars_by_steps
    if np.isfinite(need.area) and by_steps is not None:
        yield from by_steps(steel, need.bars, need.limit_state)


def _struts(combined: Results, clause: str, needs: list[wall_bars.WallNeed]) -> Iterator[DesignCheck]:
    """Yield whether struts of walls with a height bear their shear forces."""
    worst = max(needs, key=lambda need: need.used)
    error = error_of_ratio(
        (abs(need.force), need.borne, partial(wall_bars.error_of_force, combined, need)) for need in needs
    )
    words: str = Message(
        "{force:.4g kN} in {wall}, {way:.2f m} from its start, use {used:.3g} of what its struts bear",
        force=abs(worst.force) / 1e3,
        wall=worst.wall,
        way=worst.way,
        used=worst.used,
    )
    if worst.upright is None or worst.level is None:
        words = joined((words, "least bars of walls were not read"), "; ")
    else:
        words += Message(
            "; it needs at least {upright:.3g cm2/m} of bars upright and {level:.3g cm2/m} level, both faces together",
            upright=worst.upright * 1e4,
            level=worst.level * 1e4,
        )
    yield DesignCheck(
        "walls", "no failure found" if worst.used <= 1 else "fails", words, of=worst.wall,
        demand=abs(worst.force) / 1e3, resistance=worst.borne / 1e3, unit="kN", combination=worst.combination,
        place=worst.place, clause=clause, error=scaled(error, worst.borne / 1e3),
        steps=tuple(_wall_steps(combined, worst)),
    )  # fmt: skip


def _wall_steps(combined: Results, need: wall_bars.WallNeed) -> Iterator[Step]:
    """Yield the calculation of a part of a wall."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).walls
    assert rule is not None
    t, height = need.thickness, need.height
    yield Step("shear force", "V", abs(need.force) / MEGA, "MN")
    yield Step("thickness", "t", t, "m")
    yield Step("height, no more than the length", "h", height, "m")
    yield from rule.steps(steel, combined.results[need.combination].limit_state, t, height)
    yield Step("share used", "eta", need.used, "", "V / V_max")


def _webs(combined: Results, needs: list[beam_bars.BeamNeed], clause: str) -> DesignCheck:
    """Return whether the concrete of webs bears shear and torsion, with the links and bars along that these take."""
    worst = max((need for need in needs if need.what == "struts"), key=lambda need: need.area)
    V, T, used = abs(worst.force) / 1e3, worst.torsion / 1e3, worst.area
    words = Message(
        "{V:.4g kN} with {T:.4g kNm} of torsion use {used:.3g} of what the web of {beam} bears {way:.2f "
        "m} from its start",
        V=V,
        T=T,
        used=used,
        beam=worst.beam,
        way=worst.way,
    )
    if used <= 1:
        links, along = (
            next(need.area * 1e4 for need in needs if (need.what, need.beam) == (what, worst.beam))
            for what in ("links", "torsion")
        )
        words += Message(
            "; it needs links of {links:.3g cm2/m}, and {along:.3g cm2} of bars along it for torsion",
            links=links,
            along=along,
        )
    return DesignCheck(
        "webs of beams", "no failure found" if used <= 1 else "fails", words, of=worst.beam, demand=used,
        resistance=1.0, combination=worst.combination, place=worst.place, clause=clause,
        error=_error(combined, [(need.area, 1.0, need) for need in needs if need.what == "struts"]),
    )  # fmt: skip


def _error(combined: Results, judged: list[tuple[float, float, beam_bars.BeamNeed]]) -> float | None:
    """Return the estimated error of the largest of shares used, demands over what resists them, of beams."""
    steel = combined.model.reinforcement
    assert steel is not None
    return error_of_ratio(
        (demand, resistance, partial(beam_bars.error_of_need, combined, steel, need))
        for demand, resistance, need in judged
    )


def _flanges(combined: Results, needs: list[beam_bars.BeamNeed], clause: str) -> DesignCheck:
    """Return whether the shear between ribs and their flanges can be carried, with the bars across that it takes."""
    worst = max(needs, key=lambda need: need.stress / need.limit)
    used = worst.stress / worst.limit
    error = _error(combined, [(need.stress, need.limit, need) for need in needs])
    words = Message(
        "the shear between {beam} and its flange, {stress:.3g MPa} {way:.2f m} from its start, is "
        "{used:.3g} times what its concrete bears",
        beam=worst.beam,
        stress=worst.stress / 1e6,
        way=worst.way,
        used=used,
    )
    if used <= 1:
        words += Message(
            "; it needs {area:.3g cm2/m} of bars across it, those of the slab among them", area=worst.area * 1e4
        )
    return DesignCheck(
        "flanges", "no failure found" if used <= 1 else "fails", words, of=worst.beam, demand=worst.stress / 1e6,
        resistance=worst.limit / 1e6, unit="MPa", combination=worst.combination, place=worst.place, clause=clause,
        error=scaled(error, worst.limit / 1e6),
    )  # fmt: skip


def _punching(combined: Results, code: DesignCode) -> Iterator[DesignCheck]:
    """Yield the checks of columns, piles and ends of walls, or that the code has no rule for them."""
    if code.punching is None:
        yield no_rule(code, "punching")
    else:
        yield from punching.checks(combined)


def _bending(needs: list[required_bars.Need]) -> DesignCheck:
    """Return whether any reinforcement can carry the moments."""
    failing = [need for need in needs if need.governed_by == required_bars.TOO_WEAK]
    if not failing:
        return DesignCheck("bending", "no failure found", "reinforcement can be designed everywhere")
    worst = max(failing, key=lambda need: need.fails)
    share = Message("{share:.3g} % of the plate's area", share=100 * worst.fails)
    return DesignCheck(
        "bending",
        "fails",
        Message("the concrete is too weak for any reinforcement on {share}", share=share) + _where(worst),
    )


def _compression(needs: list[required_bars.Need], clause: str) -> DesignCheck:
    """Return whether bars in compression are counted on."""
    name = "compression reinforcement"
    share = sum({need.section: need.links for need in needs}.values())
    if not share:
        return DesignCheck(name, "no failure found", "the concrete carries bending without bars in compression")
    words = Message(
        "bars in compression, held by links ({clause}), are needed on {share:.3g} % of the plate's area",
        clause=Clause(clause),
        share=100 * share,
    )
    of_them = [need for need in needs if need.governed_by == required_bars.COMPRESSION]
    return DesignCheck(name, "attention", words + (_where(max(of_them, key=lambda need: need.area)) if of_them else ""))


def _where(need: required_bars.Need) -> str:
    """Return which layer it is about, and the moment that governs it."""
    assert need.place is not None
    assert need.moment is not None
    x, y = need.place
    part = Message(", {section}", section=required_bars.section_name(need.section)) if need.section else ""
    return Message(
        '; {layer}{part}: {moment:.4g kNm/m} at {place:.3f m} in "{combination}", thickness {thickness:g m}',
        layer=need.layer.replace("_", " "),
        part=part,
        moment=need.moment / 1e3,
        place=(x, y),
        combination=Name(need.combination),
        thickness=need.thickness,
    )
