"""Which combinations a design is made of, and why there are none."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab.messages import Message
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.results.results import CombinationResult, Results

#: What a reader of a design without partial factors must know.
UNFACTORED = "No factor of the ultimate combinations is above 1: the loads must hold the partial factors already."


def solved_results(combined: Results) -> list[CombinationResult]:
    """Return the results there are, in the order of the combinations."""
    return [
        combined.results[combination.name]
        for combination in combined.combinations
        if combination.name in combined.results
    ]


def ultimate_results(combined: Results) -> list[CombinationResult]:
    """Return the results of the ultimate combinations, the accidental and seismic ones among them."""
    return [results for results in solved_results(combined) if results.limit_state in STRENGTH]


def why_none(combined: Results, states: Sequence[str], called: str) -> str:
    """Return why no combination of some limit states has results, by what such a combination is called."""
    has_any = any(combination.limit_state in states for combination in combined.combinations)
    return (
        Message("no {called} has a certified result", called=called)
        if has_any
        else Message("the case has no {called}", called=called)
    )


def without_partial_factors(combined: Results) -> bool:
    """Return whether there are ultimate combinations, and no factor of any of them is above 1."""
    factors = [
        abs(factor)
        for combination in combined.combinations
        if combination.limit_state == "ultimate"
        for _, factor in combination.factors
    ]
    return bool(factors) and max(factors) <= 1
