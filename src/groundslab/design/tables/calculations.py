"""Calculations of checks step by step, so that they can be followed by hand."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.calculation import Step, with_numbers
from groundslab.design.basis.punching_columns import Heads
from groundslab.design.checks import check_design
from groundslab.design.codes import code_of
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.results.results import Results

_HEADS: Heads = (
    ("check", ""), ("of", ""), ("combination", ""), ("quantity", ""), ("symbol", ""), ("formula", ""),
    ("with numbers", ""), ("value", ""), ("unit", ""), ("clause", ""),
)  # fmt: skip
_NOTES = (
    "Each at its governing place and in its governing combination, see the table checks. What a value is made of "
    "stands above it. In punching axis 1 runs along the edge at a column beside one; places are from the center of "
    "what counts of the perimeter.",
)


def calculations(combined: Results) -> Table:
    """Return the calculations of checks by the code of the case, as its report wants them."""
    rows: list[list[Cell]] = []
    for check, of, combination, steps in _calculations(combined):
        known: dict[str, float] = {}
        for step in steps:
            numbers = with_numbers(step, known) if step.formula else ""
            about: list[Cell] = [check, of, combination, step.words, step.symbol, step.formula, numbers]
            rows.append([*about, step.value, step.unit, step.clause])
            known[step.symbol] = step.value
    return table_of("calculations", "Calculations", _HEADS, rows, _NOTES)


def _calculations(combined: Results) -> Iterator[tuple[str, str, str, tuple[Step, ...]]]:
    """Yield check, what it is of, combination and steps of each calculation."""
    steel = combined.model.reinforcement
    assert steel is not None
    for check in check_design(combined).checks:
        if check.steps:
            yield check.name, check.of, check.combination, check.steps
    rule = code_of(steel).punching
    if rule is not None and combined.model.columns:
        for number, (name, combination, steps) in enumerate(rule.sheets(combined, steel)):
            if number == 0 or combined.model.report.sheets == "all":
                yield "punching", name, combination, steps
