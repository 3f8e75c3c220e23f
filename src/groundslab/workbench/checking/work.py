"""How much there is to solve, counted by the mesher in a child process before anything is solved."""

from __future__ import annotations

import threading
from dataclasses import dataclass

from groundslab.errors import GroundslabError
from groundslab.workbench.checking import parsing
from groundslab.workbench.checking.bounded_process import BoundedProcess, CallFailure

#: Time in which the first mesh must be made [s].
LIMIT = 20.0


@dataclass(frozen=True, slots=True)
class Work:
    """What a case has to be solved: combinations, unknowns of its first mesh with errors, the accuracy asked for.

    `accuracy` is None where the case gives the mesh, which is then the only one.
    """

    combinations: int
    unknowns: int
    accuracy: float | None


class WorkCounter:
    """Counts in a process of its own, which starts when it is first needed; what was counted last is kept."""

    def __init__(self, seconds: float = LIMIT) -> None:
        self._process = BoundedProcess(parsing.warm_up)
        self._seconds = seconds
        self._lock = threading.Lock()
        self._known: tuple[str, Work | None] = ("", None)

    def count(self, fingerprint: str, text: str) -> Work | None:
        """Return the work of a model with a fingerprint that a text describes, None if it cannot be counted in time."""
        with self._lock:
            if self._known[0] != fingerprint:
                try:
                    self._known = fingerprint, self._process.call(count_work, text, seconds=self._seconds)
                except (CallFailure, GroundslabError):
                    self._known = fingerprint, None
            return self._known[1]

    def close(self) -> None:
        """End the process."""
        self._process.close()


def count_work(text: str) -> Work:
    """Return the work of the case that a text describes; raises GroundslabError."""
    from groundslab.case import casefile
    from groundslab.discretize.discretize import discretize
    from groundslab.discretize.plan_layout import has_coarser
    from groundslab.discretize.symmetry import symmetries
    from groundslab.model.combinations import as_solved, list_combinations
    from groundslab.model.plan_origin import move_to_center

    model = casefile.loads(text)
    solved_model = as_solved(move_to_center(model))
    # its elements are those of the coarser mesh, each divided in four
    coarsening = int(has_coarser(solved_model, symmetries(solved_model)))
    problem = discretize(solved_model, coarsening, loaded=False)
    unknowns = (int(problem.unknown.max()) + 1) * 4**coarsening
    accuracy = model.mesh.largest_error if model.mesh.adaptive else None
    return Work(len(list_combinations(model)), unknowns, accuracy)
