"""The tables of a study: variants, statistics, errors, limit states, Sobol indices, tornado, correlations, failures."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.study.evaluation import sensitivity, statistics
from groundslab.study.evaluation.samples import condition
from groundslab.study.evaluation.statistics import LEVEL, Estimate
from groundslab.views.tables.table import Cell, Head, Table, table_of

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.study.definition.setup import Limit
    from groundslab.study.evaluation.samples import Group, Input, Output, Samples

#: Quantiles of each output.
QUANTILES = (0.05, 0.5, 0.95)
#: Names of all tables.
NAMES = (
    "variants", "statistics", "discretization", "limit_states", "exceedance", "sobol", "tornado", "correlations",
    "missing",
)  # fmt: skip
#: Points of an exceedance curve in its table.
MOST_POINTS = 200


def tables_of(sample: Samples, level: float = LEVEL) -> tuple[Table, ...]:
    """Return all tables that a study's kind of sampling permits; level is the confidence of the intervals."""
    tables: list[Table | None] = [
        tabulate_variants(sample),
        tabulate_statistics(sample, level),
        tabulate_discretization(sample),
        tabulate_limit_states(sample, level),
        tabulate_exceedance(sample, level),
        tabulate_sobol_indices(sample, level),
        tabulate_influence(sample, level),
        tabulate_correlations(sample),
        tabulate_missing_results(sample),
    ]
    return tuple(table for table in tables if table is not None)


def tabulate_variants(sample: Samples) -> Table:
    """Return a row for each variant: inputs, outputs, why there is no result, seconds."""
    heads: list[Head] = [("variant", "")]
    columns: list[list[Cell]] = [[int(number) + 1 for number in sample.number]]
    for entry in sample.inputs:
        heads.append((entry.name, entry.unit.name))
        columns.append([entry.cell(row) for row in range(len(sample.number))])
    for output in sample.outputs:
        heads.append((output.name, output.unit.name))
        columns.append([_cell(value * output.unit.scale) for value in output.values])
    heads += [("no result because", ""), ("seconds", "s")]
    columns += [[why or None for why in sample.reason], [_cell(value) for value in sample.seconds]]
    return table_of("variants", "Variants", heads, list(zip(*columns, strict=True)))


def tabulate_statistics(sample: Samples, level: float = LEVEL) -> Table:
    """Return count, mean, standard deviation, quantiles and extremes of each output, design by design."""
    heads = ["design", "output", "unit", "variants", "least", "greatest"]
    if sample.random:
        spread = [*_interval("mean"), *_interval("standard deviation"), "coefficient of variation"]
        quantiles = [head for p in QUANTILES for head in _interval(f"{p:.0%} quantile")]
        heads = [*heads[:4], *spread, "least", *quantiles, "greatest"]
    rows = [
        [group.label, output.name, output.unit.name, *_statistics_cells(sample, group, output, level)]
        for group in sample.groups
        for output in sample.outputs
    ]
    notes = [_interval_note(sample, level)] if sample.random else [NO_CHANCE]
    infinite = {output.name: int(np.isinf(output.values).sum()) for output in sample.outputs}
    notes += [
        f"{count} variants have an infinite {name}; they are left out here, but not in the limit states."
        for name, count in infinite.items()
        if count
    ]
    if lost := int(sample.collapsed.sum()):
        notes.append(f"The foundation of {lost} variants fails; they are left out here, but not in the limit states.")
    return _tabulate(sample, "statistics", "Statistics of the outputs", heads, rows, notes)


def tabulate_discretization(sample: Samples) -> Table | None:
    """Return the discretization error of each output in the case as it is; None if none has any."""
    errors = [(output, *sample.errors[output.name]) for output in sample.outputs if output.name in sample.errors]
    if not errors:
        return None
    rows = [[output.name, output.unit.name, *(x * output.unit.scale for x in both)] for output, *both in errors]
    notes = [
        "Of the base case, estimated from the same analysis on elements twice as large. The variants start from its "
        "solution and have no coarser mesh."
    ]
    heads = ["output", "unit", "value in the case", "discretization error"]
    table = _tabulate(sample, "discretization", "Discretization errors of the case", heads, rows, notes)
    *others, value, error = table.columns
    return replace(table, columns=(*others, value, replace(error, error_of=value.name)))


NO_CHANCE = "The variants were set, not drawn: their shares are not probabilities, and means are omitted."


def _statistics_cells(sample: Samples, group: Group, output: Output, level: float) -> list[Cell]:
    """Return the statistics of an output in one design."""
    x = sample.of(output, group) * output.unit.scale
    if len(x) == 0:
        return [0, *[None] * (2 + (7 + 3 * len(QUANTILES)) * sample.random)]
    if not sample.random:
        return [len(x), float(x.min()), float(x.max())]
    middle, spread = statistics.mean(x, level), statistics.deviation(x, level)
    ratio = spread.value / abs(middle.value) if middle.value else None
    quantiles = [cell for p in QUANTILES for cell in _estimate_cells(statistics.percentile(x, p, level))]
    return [
        len(x), *_estimate_cells(middle), *_estimate_cells(spread), ratio, float(x.min()), *quantiles, float(x.max())
    ]  # fmt: skip


def tabulate_limit_states(sample: Samples, level: float = LEVEL) -> Table | None:
    """Return how often each limit state failed, design by design, and the probability of failure."""
    if not sample.limits:
        return None
    heads, notes = ["design", "limit state", "condition", "variants", "failed"], [NO_CHANCE]
    aimed = sample.random and any(limit.target is not None for limit in sample.limits)
    if sample.random:
        heads += [*_interval("probability of failure"), "reliability index"]
        heads += ["without a result", "high if these fail", *["target", "target kept"] * aimed]
        notes = [
            f"Intervals of {level:.0%} confidence for the probability by Wilson (1927). The reliability index is "
            "-Phi^-1 of the probability.",
            "A variant without equilibrium, whose foundation fails, counts as failed. Others without a result are not "
            "counted; a column has the high end if all of them fail."
            + " A target is kept if even that end lies below it."
            * aimed,
        ]

    rows = []
    for group, limit in itertools.product(sample.groups, sample.limits):
        cells = _limit_cells(sample, group, limit, level)
        rows.append([group.label, limit.name, *cells[: len(heads) - 2]])
    return _tabulate(sample, "limit_states", "Limit states", heads, rows, notes)


def failure_probability(sample: Samples, group: Group, limit: Limit, level: float = LEVEL) -> Estimate:
    """Return the probability that a limit state fails in one design; it does where the foundation fails.

    Other variants without a result are not counted.
    """
    x = sample.there(sample.output(limit.output), group, limit.sense == "at least")
    return statistics.probability(int(limit.fails(x).sum()), len(x), level)


def _limit_cells(sample: Samples, group: Group, limit: Limit, level: float) -> list[Cell]:
    """Return condition and failures; then, if chance decides, probability, index, missing results, and the verdict."""
    from scipy.special import ndtri

    output = sample.output(limit.output)
    x = sample.there(output, group, limit.sense == "at least")
    failed, n = int(limit.fails(x).sum()), len(x)
    p = statistics.probability(failed, n, level)
    lost = int(sample.by_chance[group.rows].sum()) - n
    high = statistics.probability(failed + lost, n + lost, level).high
    index = -float(ndtri(p.value)) if 0 < failed < n else None
    verdict = None if limit.target is None else ("yes" if high < limit.target else "no")
    shown = condition(limit, output)
    return [shown, n, failed, *_estimate_cells(p), index, lost, high, limit.target, verdict]


def tabulate_exceedance(sample: Samples, level: float = LEVEL) -> Table | None:
    """Return the curves of exceedance: the share of variants above each value, design by design."""
    if not sample.random:
        return None
    rows: list[list[Any]] = []
    for group, output in itertools.product(sample.groups, sample.outputs):
        value, *curve = exceedance_curve(sample, output, group, level)
        about = [group.label, output.name, output.unit.name]
        side = "below" if sample.falls(output) else "above"
        rows += [
            [*about, value[at], side, *(values[at] for values in curve)] for at in thin_out(len(value), MOST_POINTS)
        ]
    notes = [
        f"The share of variants above each value; below it for outputs whose limit states say at least. At most "
        f"{MOST_POINTS} points of each curve. {_interval_note(sample, level)}"
    ]
    heads = ["design", "output", "unit", "value", "side", *_interval("probability")]
    return _tabulate(sample, "exceedance", "Curves of exceedance", heads, rows, notes)


def exceedance_curve(
    sample: Samples, output: Output, group: Group, level: float = LEVEL
) -> tuple[Array, Array, Array, Array]:
    """Return an output's finite values in one design, in the unit of display and in rising order, with their shares.

    The shares of all variants beyond each value, to the side that is bad, and the ends of their intervals.
    """
    x = sample.there(output, group) * output.unit.scale
    value, p, low, high = statistics.exceedance(x, level, below=sample.falls(output))
    finite = np.isfinite(value)
    return value[finite], p[finite], low[finite], high[finite]


def thin_out(n: int, most: int) -> list[int]:
    """Return at most `most` of the positions 0 ... n - 1, spread evenly, the first and the last among them."""
    return sorted({round(at) for at in np.linspace(0, n - 1, min(n, most))}) if n else []


def tabulate_sobol_indices(sample: Samples, level: float = LEVEL) -> Table | None:
    """Return Sobol's first-order and total indices of each input for each output; only of Saltelli's sample."""
    if sample.kind != "saltelli":
        return None
    heads = ["output", "input", *_interval("first-order index"), *_interval("total index"), "blocks used"]
    rows: list[list[Cell]] = []
    left_out = False
    for output in sample.outputs:
        indices = compute_sobol_indices(sample, output, level)
        if indices is None:
            rows += [[output.name, entry.name, *[None] * 6, None] for entry in sample.inputs]
            continue
        left_out = left_out or indices.blocks < indices.of
        for entry, first, total in zip(sample.inputs, indices.first, indices.total, strict=True):
            rows.append([output.name, entry.name, *_estimate_cells(first), *_estimate_cells(total), indices.blocks])
    notes = [
        "Shares of the output's variance (Saltelli 2010): first order, the share due to the input alone; total, "
        "including its interaction with all others. Intervals of {level:.0%} confidence from "
        f"{sensitivity.RESAMPLES} resamples of the blocks.",
    ]
    if left_out:
        notes.append("Blocks with a variant that has no result are left out.")
    return _tabulate(sample, "sobol", "Sobol indices", heads, rows, notes)


def compute_sobol_indices(sample: Samples, output: Output, level: float = LEVEL) -> sensitivity.SobolIndices | None:
    """Return the Sobol indices of one output of a Saltelli sample, without incomplete blocks.

    None where they are not defined: too few blocks, or an output that does not vary.
    """
    A, B, AB = sample.mixed(output)
    return sensitivity.sobol_indices(A, B, AB, sample.seed, level)


def tabulate_influence(sample: Samples, level: float = LEVEL) -> Table | None:
    """Return the influence of each input on each output: by its low and high value alone, or by rank correlation."""
    if sample.kind == "tornado":
        return _tabulate_swings(sample)
    if not sample.random or not sample.varied:
        return None
    rows = [
        [group.label, output.name, name, *_estimate_cells(r)]
        for group in sample.groups
        for output in sample.outputs
        for name, r in rank_inputs(sample, group, output, level)
    ]
    notes = [
        "By Spearman's rank correlation of input and output, the strongest first; intervals of "
        f"{level:.0%} confidence by Bonett and Wright (2000). Inputs that are correlated share in each other's. "
        "Random fields have none."
    ]
    heads = ["design", "output", "input", *_interval("rank correlation")]
    return _tabulate(sample, "tornado", "Influence of the inputs (rank correlation)", heads, rows, notes)


def rank_inputs(sample: Samples, group: Group, output: Output, level: float = LEVEL) -> list[tuple[str, Estimate]]:
    """Return the rank correlation of each input that varies by chance with an output, the strongest first."""
    rows = _complete_rows(sample, group, output)
    correlations = [
        (entry.name, statistics.rank_correlation(entry.values[rows], output.values[rows], level))
        for entry in sample.varied
    ]
    return sorted(correlations, key=lambda pair: -abs(np.nan_to_num(pair[1].value)))


def _complete_rows(sample: Samples, group: Group, output: Output) -> Integers:
    """Return the rows of a design that were drawn and have the output."""
    rows = group.rows[sample.by_chance[group.rows]]
    return rows[np.isfinite(output.values[rows])]


def _tabulate_swings(sample: Samples) -> Table:
    """Return the tornado of variants with one input low or high at a time."""
    heads = ["output", "unit", "input", "at medians", "input low", "input high", "swing"]
    rows: list[list[Cell]] = []
    for output in sample.outputs:
        base, swings = compute_swings(sample, output)
        for swing in swings:
            scaled = [
                _cell(value * output.unit.scale) for value in (base, swing.low, swing.high, swing.high - swing.low)
            ]
            rows.append([output.name, output.unit.name, swing.input, *scaled])
    notes = ["One input at a time at its 10 % and its 90 % quantile, all others at their medians; the widest first."]
    return _tabulate(sample, "tornado", "Influence of the inputs (one at a time)", heads, rows, notes)


def compute_swings(sample: Samples, output: Output) -> tuple[float, tuple[sensitivity.Swing, ...]]:
    """Return an output (SI) with all inputs at their medians, and its swings, the widest first."""
    y = np.full(sample.planned, np.nan)
    y[sample.number] = output.values
    return sensitivity.tornado(y, tuple(entry.name for entry in sample.inputs))


def tabulate_correlations(sample: Samples) -> Table | None:
    """Return Pearson's and Spearman's coefficients of each output with each input and each other output."""
    if not sample.random:
        return None
    rows: list[list[Cell]] = []
    for group, (place, output) in itertools.product(sample.groups, enumerate(sample.outputs)):
        complete = _complete_rows(sample, group, output)
        others: tuple[Input | Output, ...] = (*sample.varied, *sample.outputs[:place])
        for other in others:
            at = complete[np.isfinite(other.values[complete])]
            x, y = other.values[at], output.values[at]
            both = statistics.correlation(x, y), statistics.rank_correlation(x, y).value
            rows.append([group.label, output.name, other.name, len(at), *map(_cell, both)])
    heads = ["design", "output", "with", "variants", "Pearson", "Spearman"]
    return _tabulate(sample, "correlations", "Correlations", heads, rows) if rows else None


def tabulate_missing_results(sample: Samples) -> Table | None:
    """Return why variants have no result, with how many and which; None if all have one."""
    count = Counter(why for why in sample.reason if why)
    if not count:
        return None
    first = {why: sample.reason.index(why) for why in count}
    rows = [
        ["yes" if sample.collapsed[first[why]] else None, why, times, int(sample.number[first[why]]) + 1]
        for why, times in count.most_common()
    ]
    heads = ["foundation fails", "reason", "variants", "first of them"]
    return _tabulate(sample, "missing", "Variants without a result", heads, rows)


def _tabulate(
    sample: Samples,
    name: str,
    title: str,
    heads: Sequence[str],
    rows: Iterable[Sequence[Any]],
    notes: Sequence[str] = (),
) -> Table:
    """Return a table without units in its header; a first column of designs is left out if there is but one."""
    first = 1 if heads[0] == "design" and not sample.groups[0].label else 0
    return table_of(name, title, [(head, "") for head in heads[first:]], [row[first:] for row in rows], notes)


def _interval(name: str) -> list[str]:
    """Return the headers of an estimate and its two ends."""
    return [name, f"{name}, low", f"{name}, high"]


def _estimate_cells(estimate: Estimate) -> list[Cell]:
    """Return an estimate and its ends as cells; an infinite end is empty."""
    return [_cell(value) for value in (estimate.value, estimate.low, estimate.high)]


def _cell(value: float) -> float | None:
    """Return a number as a cell, empty if it is not finite."""
    return float(value) if np.isfinite(value) else None


def _interval_note(sample: Samples, level: float) -> str:
    """Return a note on the intervals."""
    text = f"Intervals of {level:.0%} confidence for independent samples."
    return text if sample.kind == "monte carlo" else f"{text} This sample is spread more evenly: they are too wide."
