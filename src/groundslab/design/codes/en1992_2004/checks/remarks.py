"""What puts a verdict by EN 1992-1-1 in doubt: annexes known in part, restraint without bars."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.en1992_2004.annex import file_of
from groundslab.design.codes.en1992_2004.checks.restraint import without_bars
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Clause, Message
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def remarks(combined: Results, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield that an annex is known in part alone, and restraint that no bars bear."""
    annex = file_of(steel.annex)
    if not annex.complete:
        clauses = ", ".join(dict.fromkeys(parameter["clause"] for parameter in annex.parameters.values()))
        words = Message(
            "only the values of {clauses} are those of {title}; all others are the recommended ones",
            clauses=Clause(clauses),
            title=annex.title,
        )
        yield DesignCheck("national parameters", "attention", words)
    if steel.restraint is not None and not steel.laid:
        results = solved_results(combined)[0]
        yield without_bars(steel, results.elements.at_nodes(results.plate)[0])
