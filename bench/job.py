"""One job of the bench in a process of its own: the paper's first plate, refined; prints its figures as JSON.

    python bench/job.py linear 100000 5

Kinds: linear (Winkler, glued), winkler and pasternak (tensionless), raft (an L-shaped one, tensionless, meshed by Gmsh
or Netgen). The bare solve, PARDISO's analysis, factorisation
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
from groundslab.results import Results

EXAMPLE = Path(__file__).parents[1] / "examples" / "table1.toml"
KINDS: dict[str, dict[str, Any]] = {
    "linear": {"ground": {"kind": "winkler", "k": 32.7862e6}, "contact": {"tensionless": False}},
    "winkler": {"ground": {"kind": "winkler", "k": 32.7862e6}},
    "pasternak": {"ground": {"kind": "pasternak", "k0": 32.7862e6, "k1": 20.660e6}},
}
#: The raft's columns [m], and the size of its elements [m] for about 100,000 unknowns.
COLUMNS = [(1, 1), (11, 1), (20, 1), (29, 1), (1, 9), (11, 9), (20, 9), (29, 9), (1, 19)]
RAFT_SIZE = 0.263
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
    """Return the job's model with about so many unknowns, in its quarter where it has one."""
    if kind == "raft":
        return raft(unknowns)
    model = casefile.load(EXAMPLE)
    given = KINDS[kind]
    # 432 elements in the quarter (24 x 18) have 5236 to 6734 unknowns; the counts are those of the whole plate
    scale = math.sqrt(unknowns / 6734)
    counts = tuple(2 * round(n * scale) for n in (24, 18))
    return model.replace(
        ground=given["ground"], contact=given.get("contact", {}), mesh={"counts": counts}, beyond={"kind": "none"}
    )


def raft(unknowns: int) -> Model:
    """Return an L-shaped tensionless raft with one load case; its cut corner keeps it from being meshed by a grid."""
    points = [(0, 0), (30, 0), (30, 10), (12, 10), (12, 17), (9, 20), (0, 20)]
    loads = [{"kind": "uniform", "q": 1e3}]
    loads += [{"kind": "patch", "q": 1e6, "x": (x - 0.5, x + 0.5), "y": (y - 0.5, y + 0.5)} for x, y in COLUMNS]
    return Model(
        title="L-shaped raft",
        plate={"outline": {"kind": "polygon", "points": points}, "thickness": 0.5, "E": 30e9, "nu": 0.2},
        ground=KINDS["winkler"]["ground"],
        loads=loads,
        mesh={"size": RAFT_SIZE * math.sqrt(100_000 / unknowns)},
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


def settlements(results: Results) -> dict[str, float]:
    """Return the settlements [m] by which the first plate is compared with other programs; uplift is negative."""
    x, y = results.plate.nodes.T
    w = results.plate.settlement
    return {
        "settlement at the centre [m]": float(w[(x**2 + y**2).argmin()]),
        "settlement at the corner [m]": float(w[(x + y).argmax()]),
    }


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
        **({} if kind == "raft" else settlements(results)),
    }


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))))
