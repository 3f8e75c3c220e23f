"""Bars that are laid: against what bending needs, and what else the code of the case rules of them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars import required_bars
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.support_moments import bar_moments
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.design.rules.demand_errors import greatest_moments
from groundslab.design.rules.design_code import DesignCode, no_rule
from groundslab.messages import Clause, Message, Name
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results

CM2 = 1e4
#: A peak that is larger than the moment by more is named.
NOT_AVERAGED = 0.005


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of each layer of bars, if any are laid."""
    steel, results = combined.model.reinforcement, solved_results(combined)
    if steel is None or not steel.laid or not results:
        return
    laid = {layer: laid_bars(steel, layer, results[0].plate.nodes) for layer in LAYERS}
    needs = required_bars.governing_needs(combined, steel, {layer: bars.area for layer, bars in laid.items()})
    code = code_of(steel)
    for layer in LAYERS:
        of_layer = [need for need in needs if need.layer == layer]
        if of_layer:
            worst = max(of_layer, key=lambda need: need.area / (need.laid or np.inf))
            yield _area(worst, code, _error(combined, steel, worst, laid[layer].area))
    if code.bars is None:
        yield no_rule(code, "distance and cover of bars")
    else:
        yield from code.bars(combined, steel, laid)


def _area(worst: required_bars.Need, code: DesignCode, error: float | None) -> DesignCheck:
    """Return whether the bars of a layer are as much as bending and the minimum need, where it is used most."""
    name, clause, laid = worst.layer.replace("_", " "), code.clauses.bars, worst.laid
    assert laid is not None
    enough = worst.area <= laid
    where = Message(" at {place:.3f m}", place=worst.place) if worst.place is not None else ""
    by = (
        Message(
            ' in "{combination}", by {governed_by}', combination=Name(worst.combination), governed_by=worst.governed_by
        )
        if worst.combination is not None
        else ""
    )
    if worst.moment is not None and worst.peak is not None and abs(worst.peak) > abs(worst.moment) * (1 + NOT_AVERAGED):
        peak, moment = abs(worst.peak) / 1e3, abs(worst.moment) / 1e3
        by += Message("; {moment:.4g kNm/m}, not averaged {peak:.4g kNm/m}", moment=moment, peak=peak)
    return DesignCheck(
        Message("bars at the {name}", name=name),
        "no failure found" if enough else "fails",
        Message(
            "{area:.4g (cm2/m)} {sign} {laid:.4g cm2/m}{where}{by} ({clause})",
            area=worst.area * CM2,
            sign="<=" if enough else ">",
            laid=laid * CM2,
            where=where,
            by=by,
            clause=Clause(clause),
        ),
        of=name,
        demand=worst.area * CM2 if np.isfinite(worst.area) else None,
        resistance=laid * CM2,
        unit="cm2/m",
        clause=f"{code.name} {clause}",
        combination=worst.combination or "",
        place=worst.place,
        error=error,
    )


def _error(combined: Results, steel: Reinforcement, worst: required_bars.Need, laid: Array) -> float | None:
    """Return the error of the area [cm2/m] where a layer is used most of bars laid (n,) [m2/m], by its combination."""
    results = None if worst.combination is None else combined.results[worst.combination]
    greatest = None if results is None else greatest_moments(results, steel)
    if results is None or greatest is None:
        return None
    assert worst.laid is not None
    thickness, _ = results.elements.at_nodes(results.plate)
    used, most = (
        float((getattr(areas, worst.layer) / laid).max())
        for moments in (bar_moments(results, steel), greatest)
        for areas in [required_bars.areas_for(moments, thickness, steel, results.limit_state)]
    )
    return (most - used) * worst.laid * CM2 if np.isfinite(most) else None
