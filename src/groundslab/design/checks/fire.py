"""Resistance to fire by the code of the case, if it asks for any: of the slab as it is, in whatever combination."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.registry import code_of
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of resistance to fire."""
    steel, results = combined.model.reinforcement, solved_results(combined)
    if steel is None or not results:
        return
    rule = code_of(steel).fire
    if rule is not None:
        yield from rule(results[0], steel)
