"""What puts a verdict by EN 1992-1-1:2023 in doubt: where its formulas were read, what is not checked, combinations."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.rules.check import DesignCheck
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: Where the formulas were read.
SECOND_HAND = (
    "EN 1992-1-1:2023 by formulas read second hand (Blueprints after FprEN 1992-1-1:2023, structuralcodes, "
    "henri421/blog after the published text), with recommended values"
)


def remarks(_: Results, __: Reinforcement) -> Iterator[DesignCheck]:
    """Yield that the formulas were read second hand, and what of the standard is not checked."""
    words: str = Message(
        "{second_hand}; docs/theory.md lists them, to be checked against the standard and its national annex",
        second_hand=SECOND_HAND,
    )
    yield DesignCheck("formulas of the code", "attention", words)
    words = (
        "durability by exposure resistance classes (clause 6.4), fatigue (10), anchorage and laps (11), detailing of "
        "links (12.4.2, 12.5.1) and limits of deflection (clause 9.3) are not checked"
    )
    yield DesignCheck("rest of EN 1992-1-1:2023", "attention", words)
