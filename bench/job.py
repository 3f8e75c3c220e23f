"""One job of the bench in a process of its own: the paper's first plate, refined; prints its figures as JSON.

    python bench/job.py linear 100000 5

Kinds: linear (Winkler, glued), winkler and pasternak (tensionless). The bare solve, PARDISO's analysis, factorisation
and one solution of the glued matrix on the finest mesh, is taken in turn with the whole analysis; medians are printed.
"""

from __future__ import annotations

import json
import math
import resource
import statistics
import sys
import time
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

from groundslab import analysis, casefile, contact, problem
from groundslab.discretise import discretise
from groundslab.model import Model

EXAMPLE = Path(__file__).parents[1] / "examples" / "table1.toml"
KINDS: dict[str, dict[str, Any]] = {
    "linear": {"ground": {"kind": "winkler", "k": 32.7862e6}, "contact": {"tensionless": False}},
    "winkler": {"ground": {"kind": "winkler", "k": 32.7862e6}},
    "pasternak": {"ground": {"kind": "pasternak", "k0": 32.7862e6, "k1": 20.660e6}},
}
#: What is timed inside an analysis: the name of the phase, where the function lives, its name there.
PHASES: list[tuple[str, Any, str]] = [
    ("mesh, loads, supports", analysis, "discretise"),
    ("pattern and plate", analysis, "system"),
    ("ground and right-hand side", analysis, "stiffness"),
    ("ground and right-hand side", analysis, "right_hand_side"),
    ("contact, factorisations included", contact, "solve"),
    ("recovery", analysis, "recover"),
    ("certificate", analysis, "certificate"),
]


def model_of(kind: str, unknowns: int) -> Model:
    """Return the job's model with about so many unknowns in its quarter."""
    model = casefile.load(EXAMPLE)
    given = KINDS[kind]
    # 432 elements in the quarter (24 x 18) have 5236 to 6734 unknowns; the counts are those of the whole plate
    scale = math.sqrt(unknowns / 6734)
    counts = tuple(2 * round(n * scale) for n in (24, 18))
    return model.replace(
        ground=given["ground"], contact=given.get("contact", {}), mesh={"counts": counts}, beyond={"kind": "none"}
    )


def timed(function: Callable[..., Any], phase: str, spent: dict[str, float]) -> Callable[..., Any]:
    """Return the function with its time added to a phase."""

    def wrapper(*arguments: Any, **named: Any) -> Any:
        start = time.perf_counter()
        try:
            return function(*arguments, **named)
        finally:
            spent[phase] += time.perf_counter() - start

    return wrapper


def bare(model: Model) -> Callable[[], float]:
    """Return what times PARDISO alone on the glued matrix of the finest mesh."""
    glued = model.replace(contact={"tensionless": False})
    s = problem.system(discretise(glued))
    upper = problem.stiffness(s, s.problem.ground)
    f = problem.right_hand_side(s, upper, 1.0)
    from pypardiso import PyPardisoSolver
    from scipy.sparse import csr_array

    A = csr_array((upper.data, upper.indices, upper.indptr), shape=(upper.size, upper.size))

    def once() -> float:
        solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, its own METIS ordering
        start = time.perf_counter()
        solver.set_phase(13)
        solver._call_pardiso(A, f)
        spent = time.perf_counter() - start
        solver.free_memory(everything=True)
        return spent

    return once


def main(kind: str, unknowns: int, times: int) -> dict[str, Any]:
    """Return the figures of one job."""
    model = model_of(kind, unknowns)
    alone = bare(model)
    spent: dict[str, float] = defaultdict(float)
    for phase, module, name in PHASES:
        setattr(module, name, timed(getattr(module, name), phase, spent))
    totals, bares, phases, results = [], [], [], None
    for _ in range(times):
        bares.append(alone())
        spent.clear()
        start = time.perf_counter()
        results = analysis.solve(model)
        totals.append(time.perf_counter() - start)
        phases.append(dict(spent))
    assert results is not None
    total, one = statistics.median(totals), statistics.median(bares)
    return {
        "kind": kind,
        "unknowns": results.unknowns,
        "total [s]": total,
        "bare solve [s]": one,
        "total / bare": statistics.median(t / b for t, b in zip(totals, bares, strict=True)),
        "iterations on the finest mesh": max(step.iteration for step in results.steps if step.finest),
        "phases [s]": {name: statistics.median(each.get(name, 0.0) for each in phases) for name in phases[0]},
        "peak memory [MiB]": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "settlement [m]": float(results.plate.settlement.max()),
    }


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))))
