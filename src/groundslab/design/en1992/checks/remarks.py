"""What puts a verdict by EN 1992-1-1 in doubt: parameters that no second source confirms, restraint without bars."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results
from groundslab.design.en1992.annex import unconfirmed
from groundslab.design.en1992.checks.cracks.restraint import without_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def remarks(combined: Results, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield the clauses of the annex that should be checked against the standard, and restraint that no bars bear."""
    open_clauses = unconfirmed(steel.annex)
    if open_clauses:
        words = (
            f"values of {steel.annex}'s annex found in only one source, to be checked against the standard: "
            f"{'; '.join(open_clauses)}"
        )
        yield DesignCheck("national parameters", "attention", words)
    if steel.restraint is not None and not steel.laid:
        results = solved_results(combined)[0]
        yield without_bars(steel, results.elements.at_nodes(results.plate)[0])
