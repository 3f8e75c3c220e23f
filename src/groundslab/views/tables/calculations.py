"""Calculations of checks step by step, so that they can be followed by hand."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from groundslab.arrays import made_once
from groundslab.design.bars.beam_steps import beam_steps
from groundslab.design.bars.required_bars import MINIMUM, MOMENT, Need, governing_needs, section_name
from groundslab.design.checks import check_design, punching
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.perimeters import SketchedPerimeter
from groundslab.design.demands.support_moments import origin_of
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.calculation import Step, with_numbers
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.design_code import Calculation
from groundslab.design.rules.punching import Heads
from groundslab.messages import Clause, joined
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

#: Areas that are followed by hand; where bars in compression count there is no calculation.
FOLLOWED = (MOMENT, MINIMUM)
_HEADS: Heads = (
    ("check", ""), ("of", ""), ("combination", ""), ("quantity", ""), ("symbol", ""), ("formula", ""),
    ("with numbers", ""), ("value", ""), ("unit", ""), ("clause", ""), ("x", "m"), ("y", "m"),
)  # fmt: skip
_NOTES = (
    "Each at its governing place and in its governing combination, see the table checks. What a value is made of "
    "stands above it; angles in formulas are in radians. In punching axis 1 runs along the edge at a column beside "
    "one, from one end of the perimeter to the other at a corner, and along c_x of a column inside; places are from "
    "the center of what counts of the perimeter.",
)


def calculations(combined: Results) -> Table:
    """Return the calculations of checks, as the report of the case wants them."""
    rows: list[list[Cell]] = []
    for check, (of, combination, steps, perimeter, place) in _calculations(combined):
        x, y = place or ((None, None) if perimeter is None else map(float, perimeter.center))
        values: dict[str, float] = {}
        for step in steps:
            numbers = with_numbers(step, values) if step.formula else ""
            about: list[Cell] = [check, of, combination, step.words, step.symbol, step.formula, numbers]
            rows.append([*about, step.value, step.unit, Clause(step.clause), x, y])
            values[step.symbol] = step.value
    return table_of("calculations", "Calculations", _HEADS, rows, _NOTES)


def perimeters(combined: Results) -> dict[tuple[str, str, str], SketchedPerimeter]:
    """Return the perimeters of calculations by check, what it is of, and combination."""
    return {
        (check, calculation.of, calculation.combination): calculation.perimeter
        for check, calculation in _calculations(combined)
        if calculation.perimeter is not None
    }


@made_once
def _calculations(combined: Results) -> tuple[tuple[str, Calculation], ...]:
    """Return the name of each check that is followed by hand, and its calculation."""
    return tuple(_followed(combined))


def _followed(combined: Results) -> Iterator[tuple[str, Calculation]]:
    """Yield the name of a check, and its calculation."""
    for check in check_design(combined).checks:
        if check.steps:
            yield check.name, Calculation(check.of, check.combination, check.steps, place=check.place)
    steel = combined.model.reinforcement
    if steel is None:
        return
    code = code_of(steel)
    if code.bars_by_steps is not None:
        yield from _bending(combined, steel, code.bars_by_steps)
    yield from beam_steps(combined, steel)
    for name, calculated in punching.calculations(combined):
        for calculation in calculated:
            yield name, calculation


def _used_most(needs: Iterable[Need]) -> Iterator[Need]:
    """Yield of each layer and section what uses most of the bars that are laid; all where none are."""
    most: dict[tuple[str, int], Need] = {}
    for need in needs:
        key, before = (need.layer, need.section), most.get((need.layer, need.section))
        if before is None or need.area * (before.laid or 1.0) > before.area * (need.laid or 1.0):
            most[key] = need
    yield from most.values()


def _bending(
    combined: Results, steel: Reinforcement, by_steps: Callable[[Reinforcement, BarsNeeded, str], Iterator[Step]]
) -> Iterator[tuple[str, Calculation]]:
    """Yield the calculations of each layer of bars that are in tension."""
    ultimate = ultimate_results(combined)
    if not ultimate:
        return
    states, nodes = {result.combination: result.limit_state for result in ultimate}, ultimate[0].plate.nodes
    laid = {layer: laid_bars(steel, layer, nodes).area for layer in LAYERS} if steel.laid else None
    axes = dict(zip(LAYERS, (*steel.bottom_axes, *steel.top_axes), strict=True))
    for need in _used_most(governing_needs(combined, steel, laid)):
        if need.governed_by not in FOLLOWED or need.combination is None or need.moment is None or need.place is None:
            continue
        results, axis = combined.results[need.combination], axes[need.layer]
        origin = origin_of(results, steel, need.layer, need.place, need.moment)
        bars = BarsNeeded(need.moment, need.thickness, axis, need.area, need.minimum, origin, need.laid)
        state = states[need.combination]
        rule = code_of(steel).bending(steel, state)
        alone = rule.required(np.array([abs(bars.moment)]), bars.d, thickness=bars.thickness)
        if not alone.fails[0]:  # without bars in compression, which the steps know nothing of
            of = joined((need.layer.replace("_", " "), section_name(need.section)))
            yield "bending", Calculation(of, need.combination, tuple(by_steps(steel, bars, state)), place=need.place)
