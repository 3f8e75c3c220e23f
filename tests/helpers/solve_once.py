"""Results of a slab that is solved once, whatever reinforcement is tried in it."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from groundslab.analysis.driver import solve
from groundslab.model.model import Model
from groundslab.model.outputs import Report
from groundslab.results.results import Results

#: So many slabs, and models of them, are kept.
KEPT = 24


@lru_cache(KEPT)
def solve_once(model: Model) -> Results:
    """Return the results of a model; those of the same slab with another reinforcement or report are taken over.

    Neither changes a force, as long as cracks do not soften the plate. For the same model they are the same results,
    whose checks are made once.
    """
    if model.cracking is not None:
        return solve(model)
    found = _solved(model.model_copy(update={"reinforcement": None, "report": Report()}))
    own = {"reinforcement": model.reinforcement, "report": model.report}
    results = {
        name: replace(each, model=model, solved_model=each.solved_model.model_copy(update=own))
        for name, each in found.results.items()
    }
    return replace(found, model=model, results=results)


@lru_cache(KEPT)
def _solved(model: Model) -> Results:
    """Return the results of a model."""
    return solve(model)
