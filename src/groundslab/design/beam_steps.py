"""Calculations of beams step by step: the bars and links that the table of their reinforcement has, at their places."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.design_code import Calculation
from groundslab.design.beam_bars import BeamNeed, beam_needs
from groundslab.design.codes import code_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: What is calculated at webs, each by what its calculation is called.
OF_WEBS = {"links": "links of beams", "torsion": "torsion of beams", "struts": "webs of beams"}


def beam_steps(combined: Results, steel: Reinforcement) -> Iterator[tuple[str, Calculation]]:
    """Yield the name and the calculation of what webs of beams need, those at one place once."""
    code = code_of(steel)
    if code.beams is None:
        return
    states = {name: results.limit_state for name, results in combined.results.items()}
    done = set[tuple[str, float, str]]()
    for need in beam_needs(combined, steel):
        key = need.beam, need.way, need.combination
        if need.web is None or key in done or (need.what == "torsion" and need.area == 0):
            continue
        done.add(key)
        steps = tuple(code.beams.web_steps(steel, states[need.combination], need.web))
        yield OF_WEBS[need.what], Calculation(_of(need), need.combination, steps, place=need.place)


def _of(need: BeamNeed) -> str:
    """Return what a calculation is of."""
    return f"{need.beam}, {need.way:.2f} m from its start"
