"""What puts a verdict by EN 1992-1-1 in doubt: national parameters that no second source confirms."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.check import DesignCheck
from groundslab.design.en1992.annex import unconfirmed
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def remarks(_: Results, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield the clauses of the annex that should be checked against the standard."""
    open_clauses = unconfirmed(steel.annex)
    if open_clauses:
        words = (
            f"values of {steel.annex}'s annex found in only one source, to be checked against the standard: "
            f"{'; '.join(open_clauses)}"
        )
        yield DesignCheck("national parameters", "attention", words)
