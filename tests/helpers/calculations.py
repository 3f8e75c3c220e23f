"""Calculations followed by hand: every formula with its numbers gives its value."""

from __future__ import annotations

import math
from collections.abc import Iterable

import pytest

from groundslab.design.rules.calculation import Step, with_numbers
from groundslab.views.tables.table import Table

#: What formulas call.
NAMES = {"max": max, "min": min, "abs": abs} | {
    name: getattr(math, name) for name in ("sqrt", "ceil", "floor", "exp", "log10", "sin", "cos", "tan", "atan", "pi")
}


def evaluate(numbers: str) -> float:
    """Return what a formula with its numbers gives."""
    return float(eval(numbers.replace("^", "**"), {}, NAMES))


def follow(table: Table) -> int:
    """Hold every value to its formula with its numbers, as far as six digits go; return how many there are."""
    followed = 0
    for numbers, value in zip(table["with numbers"], table["value"], strict=True):
        if numbers:
            assert evaluate(str(numbers)) == pytest.approx(value, rel=5e-5, abs=1e-6), numbers
            followed += 1
    return followed


def follow_steps(steps: Iterable[Step]) -> dict[str, float]:
    """Hold every step to its formula with the numbers above it; return the values by their symbols."""
    known = dict[str, float]()
    for step in steps:
        if step.formula:
            numbers = with_numbers(step, known)
            assert evaluate(numbers) == pytest.approx(step.value, rel=5e-5, abs=1e-6), (step.symbol, numbers)
        known[step.symbol] = step.value
    return known
