"""Whether all loads take part: what the remarks on a case leave in doubt is no green light for its design."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.checks.check import DesignCheck
from groundslab.design.tables.acting import case_forces
from groundslab.model.remarks import find_remarks
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield each doubtful remark on a case, with the vertical force of the load case that it is on."""
    doubtful = [remark for remark in find_remarks(combined.model, combined.combinations) if remark.doubtful]
    forces = case_forces(combined) if doubtful else {}
    for remark in doubtful:
        force = abs(forces.get(remark.of, 0.0)) / 1e3
        words = f"{remark.words} ({force:.5g} kN)" if force else remark.words
        yield DesignCheck("loads", "attention", words, of=remark.of)
