"""Calculations of beams step by step: the bars and links that the table of their reinforcement has, at their places."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.bars.beam_bars import BeamNeed, beam_needs
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.bending_steps import CM2
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.design_code import BeamRule, Calculation
from groundslab.design.rules.webs import Web
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: What is calculated of beams, each by what its calculation is called.
NAMES = {
    "bottom": "bars of beams", "top": "bars of beams", "flange": "flanges", "links": "links of beams",
    "torsion": "torsion of beams", "struts": "webs of beams",
}  # fmt: skip


def beam_steps(combined: Results, steel: Reinforcement) -> Iterator[tuple[str, Calculation]]:
    """Yield the name and the calculation of what beams need, of the same web once."""
    rule = code_of(steel).beams
    if rule is None:
        return
    states = {name: results.limit_state for name, results in combined.results.items()}
    webs = list[tuple[str, str, Web]]()
    for need in beam_needs(combined, steel):
        state, of = (
            states[need.combination],
            Message("{beam}, {way:.2f m} from its start", beam=need.beam, way=need.way),
        )
        if need.web is not None:
            if (need.what == "torsion" and need.area == 0) or (need.beam, need.combination, need.web) in webs:
                continue
            webs.append((need.beam, need.combination, need.web))
            steps = tuple(rule.web_steps(steel, state, need.web))
        elif need.flange is not None:
            steps = (*need.flange.steps(), *rule.flange.steps(steel, state, need.flange))
        elif need.bars is None or need.zone is None or need.bars.moment == 0:
            continue
        else:
            of = Message("{beam}, {what}, {way:.2f m} from its start", beam=need.beam, what=need.what, way=need.way)
            steps = tuple(face_steps(need, steel, rule, state))
        yield NAMES[need.what], Calculation(of, need.combination, steps, place=need.place)


def face_steps(need: BeamNeed, steel: Reinforcement, rule: BeamRule, state: str) -> Iterator[Step]:
    """Yield the calculation of the bars at a face at one place, where concrete alone bears its compression."""
    assert need.bars is not None
    assert need.zone is not None
    yield from _moment(need)
    yield from rule.bars_by_steps(steel, need.bars, state)
    yield from rule.minimum_by_steps(steel, state, need.zone)
    yield _required(need)


def _moment(need: BeamNeed) -> Iterator[Step]:
    """Yield the design moment, the section, and the moment per meter of the width in compression."""
    bars = need.bars
    assert bars is not None
    yield Step("design moment of the section", "M", abs(need.force) / MEGA, "MNm")
    yield Step("width in compression", "b", need.width, "m")
    yield Step("height with the flange", "h", bars.thickness, "m")
    yield Step("distance of the bars' axis from the face", "a_1", bars.axis, "m")
    yield Step("effective depth", "d", bars.d, "m", "h - a_1")
    yield Step("design moment per width", "m", abs(bars.moment) / MEGA, "MNm/m", "M / b")


def _required(need: BeamNeed) -> Step:
    """Return the step to the bars that are required."""
    return Step("required area", "A_req", need.area * CM2, "cm2", "max(A_s * b, A_min)")
