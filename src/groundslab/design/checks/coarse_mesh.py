"""Whether the mesh tells moments and shear forces at all: a design on one that is known not to is not passed.

Elements much larger than a footprint give moments and shear forces below it that are too small, and cannot tell their
error either. Nor is it known where a mesh has too few elements to be compared with those twice as large.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.accuracy.resolution import find_unresolved
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.design.floors import TR34Floor
from groundslab.results.results import Results

NAME = "size of elements"


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield that the mesh does not resolve a footprint, or that its error is not known, if anything is designed."""
    model = combined.model
    by_mesh = model.floor is not None and not isinstance(model.floor, TR34Floor)
    if combined.provisional or (model.reinforcement is None and model.limits is None and not by_mesh):
        return
    for result in solved_results(combined):
        small = find_unresolved(result)
        if small is not None:
            words: str = Message(
                "a footprint of {footprint:.3g m} in elements of {element:.3g m}: moments and shear forces there "
                "are too small",
                footprint=small.footprint,
                element=small.element,
            )
        elif not result.mesh_plan.has_coarser:
            words = "the mesh has too few elements for its discretization error to be known"
        else:
            continue
        yield DesignCheck(NAME, "attention", words, combination=result.combination)
        return
