"""Whether all loads take part: what the remarks on a case leave in doubt is no green light for its design."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.checks.check import DesignCheck
from groundslab.model.remarks import find_remarks
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield each doubtful remark on a case."""
    for remark in find_remarks(combined.model, combined.combinations):
        if remark.doubtful:
            yield DesignCheck("loads", "attention", remark.words, of=remark.of)
