"""What a run will cost, told before it begins: from what the mesher counts, and the last run on this machine."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from groundslab.model.settings import ACCURACIES
from groundslab.workbench.checking.work import Work
from groundslab.workbench.editing.document import Document

if TYPE_CHECKING:
    from groundslab.results.results import Results
    from groundslab.workbench.solver.answer import Answer

#: Unknowns times combinations that are solved in a second where no run has told it: bench/default_answer.py.
USUAL_RATE = 80_000.0
#: A factorization takes about as long as so many combinations.
FACTORIZATION = 2
#: What every run takes besides, and how long one must take for its rate to be believed [s].
BEGINNING, TELLING = 0.5, 1.0
#: Unknowns of the last mesh over those of the first one with errors, for a draft and for a strict result, and how many
#: meshes they take: a rough guess, from ten slabs that were solved.
GROWTH, MESHES = (0.9, 1.8), (1, 3)


@dataclass(frozen=True, slots=True)
class Cost:
    """What a run takes: unknowns of its last mesh, number of meshes, combinations, seconds."""

    unknowns: int
    meshes: int
    combinations: int
    seconds: float


def estimate(work: Work, accuracy: float | None, rate: float) -> Cost:
    """Return what solving takes on a machine with a rate; without an accuracy on the first mesh alone."""
    unknowns = _growth(accuracy) * work.unknowns
    meshes = 1 if accuracy is None else round(MESHES[0] + _share(accuracy) * (MESHES[1] - MESHES[0]))
    seconds = BEGINNING + _work(unknowns, work.combinations) / rate
    return Cost(round(unknowns), meshes, work.combinations, seconds)


def list_costs(work: Work, rate: float, last: tuple[str, Answer] | None = None) -> dict[str, dict[str, Any]]:
    """Return the cost of each accuracy that can be asked for, "" for that of the case, as data for the page.

    `last` is the accuracy of the last run of the same model, whose cost is known, and its answer.
    """
    choices: dict[str, float | None] = {"": work.accuracy}
    if work.accuracy is not None:
        choices |= ACCURACIES
    costs = {name: asdict(estimate(work, accuracy, rate)) for name, accuracy in choices.items()}
    if last is not None:
        name, answer = last
        costs[name] = asdict(Cost(answer.unknowns, answer.meshes, work.combinations, answer.seconds))
    return costs


def measure_rate(answer: Answer) -> float | None:
    """Return the rate of the machine in a run, None if it was too short to tell."""
    if answer.seconds < TELLING or answer.unknowns == 0:
        return None
    return _work(answer.unknowns, len(answer.summary["combinations"])) / (answer.seconds - BEGINNING)


def count_made(results: Results) -> tuple[int, int, float | None]:
    """Return the unknowns of the last mesh, how many meshes were made, and the accuracy asked for, if it refines them.

    Unknowns are 0 where all combinations are refused.
    """
    mesh = results.model.mesh
    first, accuracy = next(iter(results.values()), None), mesh.largest_error if mesh.adaptive else None
    if first is None:
        return 0, 1, accuracy
    return first.unknowns, 1 if first.mesh_history is None else len(first.mesh_history.unknowns), accuracy


def find_work(answer: Answer) -> Work:
    """Return the work of a case that was solved with its own accuracy."""
    growth = _growth(answer.accuracy)
    return Work(len(answer.summary["combinations"]), round(answer.unknowns / growth), answer.accuracy)


def with_accuracy(text: str, accuracy: str) -> str:
    """Return the text of a case that asks for an accuracy; raises InputError.

    It stays as it is with "", and where the case gives the mesh, of which no accuracy can be asked.
    """
    document = Document(text)
    mesh = (document.data or {}).get("mesh", {})
    if not accuracy or "size" in mesh or "counts" in mesh:
        return text
    return document.apply([{"op": "set", "path": ["mesh", "accuracy"], "value": accuracy}]).text


def _work(unknowns: float, combinations: int) -> float:
    return unknowns * (combinations + FACTORIZATION)


def _growth(accuracy: float | None) -> float:
    """Return the unknowns of the last mesh over those of the first one with errors."""
    return 1.0 if accuracy is None else GROWTH[0] + _share(accuracy) * (GROWTH[1] - GROWTH[0])


def _share(accuracy: float) -> float:
    """Return where an accuracy lies between that of a draft, 0, and that of a strict result, 1, or beyond."""
    draft, strict = ACCURACIES["draft"], ACCURACIES["strict"]
    return max(0.0, math.log(draft / accuracy) / math.log(draft / strict))
