"""What puts a verdict by ACI 318-19 in doubt: combinations that are not made by it."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.rules.check import DesignCheck
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.results.results import Results


def remarks(combined: Results, _: Reinforcement) -> Iterator[DesignCheck]:
    """Yield whether combinations of strength are made by EN 1990."""
    rules = [combination.rule for combination in combined.combinations if combination.limit_state in STRENGTH]
    if any(rule.startswith("EN 1990") for rule in rules):
        words = "combinations by EN 1990 are not those of ACI 318-19 5.3, which combine.expression can select"
        yield DesignCheck("load combinations", "attention", words, clause="ACI 318-19 5.3.1")
