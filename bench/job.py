"""One job of the bench in a process of its own: the paper's first plate, refined; prints its figures as JSON.

    python bench/job.py linear 100000 5
    python bench/job.py memory pasternak 1000000             # one analysis, in a process that does nothing else
    mpirun -n 2 python bench/job.py memory pasternak 250000 mumps

Kinds: linear (Winkler, glued), winkler and pasternak (tensionless), raft (an L-shaped one, tensionless, meshed by Gmsh
or Netgen). The bare solve, PARDISO's analysis, factorisation and one solution of the glued matrix on the finest mesh,
is taken in turn with the whole analysis; medians are printed. And kinds of their own: gamma (iterated, in turn with the
gamma that comes out given), combinations (of three load cases, in turn with the first of them alone), variants (of the
ground, each in turn with a cold solution of the same model, on one thread as in a study), study (the same variants by
two workers and by one), solvers (a further factorization by each of them, on one thread), threads (an analysis on one
and on all), continuum (the first combination of the same loads on bonded layers, in turn with the bare solve of the
plate alone, and with all combinations) and cases:

    python bench/job.py case bench/slabs/house_raft.toml 5   # beside as many bare solves as it has combinations
"""

from __future__ import annotations

import ctypes
import json
import math
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.accuracy.judgment import judge
from groundslab.analysis import driver, gamma_iteration, mesh_hierarchy, nested, pressure_iteration
from groundslab.analysis.tasks import run, task
from groundslab.arrays import Array
from groundslab.case import casefile
from groundslab.discretize.discretize import discretize
from groundslab.fem import system
from groundslab.fem.foundation import single
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.solvers import contact, factor_reuse, factorization
from groundslab.solvers.direct import pardiso
from groundslab.solvers.plate_on_continuum import make_plate_on_continuum

if TYPE_CHECKING:
    from groundslab.study.definition.files import StudyInput

EXAMPLE = Path(__file__).parents[1] / "examples" / "table1.toml"
KINDS: dict[str, dict[str, Any]] = {
    "linear": {"ground": {"kind": "winkler", "k": 32.7862e6}, "contact": {"tensionless": False}},
    "winkler": {"ground": {"kind": "winkler", "k": 32.7862e6}},
    "pasternak": {"ground": {"kind": "pasternak", "k0": 32.7862e6, "k1": 20.660e6}},
}
#: The raft's columns [m], and the size of its elements [m] for about 100,000 unknowns.
COLUMNS = [(1, 1), (11, 1), (20, 1), (29, 1), (1, 9), (11, 9), (20, 9), (29, 9), (1, 19)]
RAFT_SIZE = 0.263
#: The ground whose gamma is sought, and what lies on the plate for the combinations, by load case.
SOIL = {"kind": "vlasov", "layers": [{"E": 20e6, "nu": 0.25, "thickness": 5.0}]}
CASES = ["middle", "ends", "everywhere"]
LOADS = [
    {"kind": "patch", "case": "middle", "q": 1e6, "x": (-1.2, 1.2), "y": (-1.2, 1.2)},
    {"kind": "patch", "case": "ends", "q": 4e5, "x": (-4.8, -3.6), "y": (-1.2, 1.2)},
    {"kind": "patch", "case": "ends", "q": 4e5, "x": (3.6, 4.8), "y": (-1.2, 1.2)},
    {"kind": "uniform", "case": "everywhere", "q": 1e4},
]
COMBINATIONS = {
    "all": (1.0, 1.0, 1.0),
    "middle alone": (1.0, 0.0, 1.0),
    "ends alone": (0.0, 1.0, 1.0),
    "middle the most": (1.5, 0.75, 1.35),
    "ends the most": (0.75, 1.5, 1.35),
}
#: What is timed inside an analysis: the name of the phase, where the function lives, its name there.
PHASES: list[tuple[str, Any, str]] = [
    ("mesh, loads, supports", mesh_hierarchy, "discretize"),
    ("equilibrium possible", nested, "require_equilibrium"),
    ("assembly", mesh_hierarchy, "build_system"),
    ("assembly", mesh_hierarchy, "stiffness"),
    ("assembly", gamma_iteration, "right_hand_side"),
    ("forecast", gamma_iteration.warm_start, "from_coarser"),
    ("forecast", gamma_iteration.warm_start, "solve_contact_border"),
    ("contact, all meshes and strips", contact, "solve"),
    ("of which analysis and factorisations", factor_reuse.CachedFactorization, "factorize"),
    ("of which solutions with the factor", pardiso.Pardiso, "solve"),
    ("recovery", task, "recover_fields"),
    ("recovery", task, "compare"),
    ("certificate", task, "certificate"),
]
#: Variants of the ground: how many are solved each time, and by how much k0 and k1 scatter.
VARIANTS, SCATTER = 10, 0.3
#: Variants of the study at the smallest size, enough for its start not to count.
STUDY = 400
MALLOC = {"M_MMAP_MAX": (-4, 0), "M_TRIM_THRESHOLD": (-1, -1)}


def model_of(kind: str, unknowns: int) -> Model:
    """Return the job's model with about so many unknowns, in its quarter where it has one."""
    if kind == "raft":
        return raft(unknowns)
    model = casefile.load(EXAMPLE)
    given = KINDS.get(kind, KINDS["pasternak"])
    if kind == "gamma":
        given = {"ground": SOIL}
    elif kind == "continuum":
        given = {"ground": SOIL | {"kind": "continuum"}}
    if kind in ("combinations", "continuum"):
        together = [
            {"name": name, "factors": dict(zip(CASES, factors, strict=True))} for name, factors in COMBINATIONS.items()
        ]
        model = model.replace(loads=LOADS, cases=[{"name": case} for case in CASES], combinations=together)
    # 432 elements in the quarter (24 x 18) have 5236 to 6734 unknowns; the counts are those of the whole plate, which
    # on a continuum is solved as a whole, without a surface of the ground
    scale = math.sqrt(unknowns / (19_515 if kind == "continuum" else 6734))
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


def measure(function: Callable[..., Any], *arguments: Any) -> tuple[float, Any]:
    """Return the time [s] that a call takes, and what it returns."""
    start = time.perf_counter()
    found = function(*arguments)
    return time.perf_counter() - start, found


def glued_system(model: Model) -> tuple[Symmetric, Array]:
    """Return the matrix of the finest mesh without contact, and its right-hand side."""
    s = system.build_system(discretize(model.replace(contact={"tensionless": False})))
    return system.stiffness(s, s.problem.ground), system.right_hand_side(s, 1.0)


def bare(upper: Symmetric, f: Array) -> Callable[[], float]:
    """Return what times PARDISO alone on a matrix."""
    from pypardiso import PyPardisoSolver
    from scipy.sparse import csr_array

    A = csr_array((upper.data, upper.indices, upper.indptr), shape=(upper.size, upper.size))

    def once() -> float:
        solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, its own METIS ordering
        solver.set_phase(13)
        spent, _ = measure(solver._call_pardiso, A, f)
        solver.free_memory(everything=True)
        return spent

    return once


def settlements(results: CombinationResult) -> dict[str, float]:
    """Return the settlements [m] by which the first plate is compared with other programs; uplift is negative."""
    x, y = results.plate.nodes.T
    w = results.plate.settlement
    return {
        "settlement at the centre [m]": float(w[(x**2 + y**2).argmin()]),
        "settlement at the corner [m]": float(w[(x + y).argmax()]),
    }


def keep_memory() -> None:
    """Let freed memory stay with the process, as far as the C library allows.

    Where a machine is itself a guest on another, the first touch of memory can take longer than all computing, and
    differently from run to run. Both sides of every ratio here profit alike.
    """
    if sys.platform == "linux":
        library = ctypes.CDLL(None)
        for parameter, value in MALLOC.values():
            library.mallopt(parameter, value)


def assembly(model: Model) -> float:
    """Return the time [s] that pattern, element matrices, matrix and right-hand side of the finest mesh take."""
    spent, s = measure(system.build_system, discretize(model))
    return spent + measure(system.stiffness, s, s.problem.ground)[0] + measure(system.right_hand_side, s, 1.0)[0]


def largest_memory() -> float:
    """Return the most memory that this process had [MiB].

    Where Linux tells it, from there: a process's resource usage begins with that of the one that started it.
    """
    status = Path("/proc/self/status")
    if status.exists():
        return float(status.read_text().split("VmHWM:")[1].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


@contextmanager
def no_estimates() -> Iterator[None]:
    """Make no coarser mesh to compare with, but those from which contact starts."""
    has_coarser = nested.has_coarser
    nested.has_coarser = lambda *_: False  # type: ignore[attr-defined]
    try:
        yield
    finally:
        nested.has_coarser = has_coarser  # type: ignore[attr-defined]


def judged(model: Model) -> Results:
    """Return results with the errors of their values."""
    results = driver.solve(model)
    judge(results.only)
    return results


def memory(model: Model) -> dict[str, float]:
    """Return time and largest memory of this process in one analysis, and what PARDISO held for the finest mesh.

    The analysis is that of the first combination, if there are several. Of an MPI run with another solver each process
    tells its own.
    """
    held: list[float] = []
    factor = pardiso.Pardiso.factor

    def watched(self: Any, data: Any) -> Any:
        found = factor(self, data)
        # kilobytes that stay after the analysis, and of the factor
        held.append((int(self.handle.get_iparm(16)) + int(self.handle.get_iparm(17))) / 1024)
        return found

    pardiso.Pardiso.factor = watched  # type: ignore[method-assign]
    spent, results = measure(driver.solve, model.replace(combinations=model.combinations[:1]))
    cells = results.only.ground.cells
    peak = largest_memory()
    return {
        "unknowns": results.only.unknowns,
        **({} if cells is None else {"cells": len(cells.force)}),
        "one analysis [s]": spent,
        "peak memory [MiB]": peak,
        **({"PARDISO's memory [MiB]": max(held), "peak / factor": peak / max(held)} if held else {}),
    }


def written(results: CombinationResult) -> float:
    """Return the time [s] that writing the results takes, all files but the picture."""
    from groundslab.views.files import results_folder  # not needed by whoever times a whole process

    with tempfile.TemporaryDirectory() as folder:
        return measure(results_folder.save_results, results, Path(folder) / "results")[0]


def beside_the_bare_solve(kind: str, unknowns: int, times: int) -> dict[str, Any]:
    """Return the figures of a job that is taken in turn with the bare solve."""
    model = model_of(kind, unknowns)
    alone = bare(*glued_system(model))
    spent: dict[str, float] = defaultdict(float)
    for phase, module, name in PHASES:
        setattr(module, name, timed(getattr(module, name), phase, spent))
    totals, bares, puts, phases, others = [], [], [], [], []
    for _ in range(times):
        bares.append(alone())
        puts.append(assembly(model))
        with no_estimates():
            others.append(measure(driver.solve, model)[0])
        spent.clear()
        total, results = measure(judged, model)
        totals.append(total)
        phases.append(dict(spent))
    results = results.only
    fresh = subprocess.run(
        [sys.executable, __file__, "memory", kind, str(unknowns)], check=True, capture_output=True, text=True
    )
    return {
        "unknowns": results.unknowns,
        "total [s]": statistics.median(totals),
        "bare solve [s]": statistics.median(bares),
        "total / bare": statistics.median(t / b for t, b in zip(totals, bares, strict=True)),
        "assembly / bare": statistics.median(t / b for t, b in zip(puts, bares, strict=True)),
        "estimates / analysis": statistics.median(t / o for t, o in zip(totals, others, strict=True)) - 1,
        "iterations on the finest mesh": max(step.iteration for step in results.steps if step.finest),
        "phases [s]": {name: statistics.median(each.get(name, 0.0) for each in phases) for name in phases[0]},
        "output [s]": written(results),
        **json.loads(fresh.stdout),
        "settlement [m]": float(results.plate.settlement.max()),
        **({} if kind == "raft" else settlements(results)),
    }


def gamma(unknowns: int, times: int) -> dict[str, Any]:
    """Return what it costs to look for gamma: iterated, in turn with the gamma that comes out given."""
    iterated = model_of("gamma", unknowns)
    results = driver.solve(iterated).only
    known = iterated.replace(ground={**SOIL, "gamma": results.constants.gamma})
    ratios, totals = [], []
    for _ in range(times):
        given, total = (measure(driver.solve, model)[0] for model in (known, iterated))
        totals.append(total)
        ratios.append(total / given)
    return {
        "unknowns": results.unknowns,
        "total [s]": statistics.median(totals),
        "gamma": results.constants.gamma,
        "iterations of gamma on the finest mesh": results.constants.gamma_iterations,
        "iterated / known": statistics.median(ratios),
    }


def combinations(unknowns: int, times: int) -> dict[str, Any]:
    """Return by how much a further combination of loads lengthens an analysis, beside the time of the first alone."""
    model = model_of("combinations", unknowns)
    first = model.replace(combinations=model.combinations[:1])
    ratios, totals, steps = [], [], dict[str, int]()
    for _ in range(times):
        alone, _ = measure(driver.solve_combinations, first)
        total, combined = measure(driver.solve_combinations, model)
        totals.append(total)
        ratios.append((total - alone) / (len(COMBINATIONS) - 1) / alone)
        assert not combined.refused
        steps = {name: max(s.iteration for s in found.steps if s.finest) for name, found in combined.results.items()}
    return {
        "unknowns": next(iter(combined.results.values())).unknowns,
        "total [s]": statistics.median(totals),
        "iterations on the finest mesh, by combination": steps,
        "further / first": statistics.median(ratios),
    }


def continuum(unknowns: int, times: int) -> dict[str, Any]:
    """Return what an analysis on a continuum takes, beside the bare solve of its plate, and further combinations."""
    model = model_of("continuum", unknowns)
    first = model.replace(combinations=model.combinations[:1])
    s = system.build_system(discretize(first))
    plate = make_plate_on_continuum(s, system.stiffness(s, single(0.0, 0.0)), None)  # type: ignore[arg-type]
    held = plate.A.constrain(plate.system.fixed, np.zeros(plate.A.size))
    alone = bare(Symmetric(plate.A.indptr, plate.A.indices, held), system.right_hand_side(s, 1.0))
    products = list[int]()
    solve = pressure_iteration.bounded_forces.solve

    def counted(*arguments: Any) -> Any:
        found = solve(*arguments)
        products.append(found.products)
        return found

    pressure_iteration.bounded_forces.solve = counted  # type: ignore[assignment]
    figures = defaultdict[str, list[float]](list)
    for _ in range(times):
        least = alone()
        total, results = measure(driver.solve_combinations, first)
        products.clear()
        together, combined = measure(driver.solve_combinations, model)
        assert not combined.refused
        figures["total [s]"].append(total)
        figures["bare solve [s]"].append(least)
        figures["total / bare"].append(total / least)
        figures["further / first"].append((together - total) / (len(COMBINATIONS) - 1) / total)
    (found,) = results.results.values()
    return {
        "unknowns": found.unknowns,
        **{name: statistics.median(each) for name, each in figures.items()},
        "products, all meshes and combinations": products,
        "iterations on the finest mesh": max(step.iteration for step in found.steps if step.finest),
    }


@factorization.one_thread()
def variants(unknowns: int, times: int) -> dict[str, Any]:
    """Return what a variant of the ground costs on one thread, beside a cold solution of the same model."""
    base = model_of("pasternak", unknowns)
    alike, draw, ratios, totals = driver.Variants(base), np.random.default_rng(1), [], []
    for _ in range(times * VARIANTS):
        k0, k1 = draw.lognormal(sigma=SCATTER, size=2) * (32.7862e6, 20.660e6)
        model = base.replace(ground={"kind": "pasternak", "k0": k0, "k1": k1})
        cold, _ = measure(driver.solve_combinations, model)
        total, combined = measure(alike.solve_combinations, model)
        totals.append(total)
        ratios.append(total / cold)
    return {
        "unknowns": combined.only.unknowns,
        "total [s]": statistics.median(totals),
        "variant / cold": statistics.median(ratios),
    }


def scattering(case: Model, count: int) -> StudyInput:
    """Return a study of so many variants of a case, whose k0 and k1 scatter, and one result of each."""
    from groundslab.study.definition import files
    from groundslab.study.definition.schema import StudyFile

    cov = {"kind": "lognormal", "cov": SCATTER}
    described = StudyFile(
        title="Ground that scatters",
        case="",
        seed=1,
        sampling={"kind": "monte carlo", "count": count},
        vary=[
            {"path": "ground.k0", "distribution": {**cov, "mean": 32.7862e6}},
            {"path": "ground.k1", "distribution": {**cov, "mean": 20.660e6}},
        ],
        keep=[{"of": "settlement", "take": "largest"}],
    )
    return files.resolve(described, case)


def study(unknowns: int, times: int) -> dict[str, Any]:
    """Return how much of twice one worker's pace two workers reach; the pace is that from the first rows to the last.

    The efficiency has in it whatever these processes, the one that keeps the rows and the rest of the machine take from
    each other.
    """
    from groundslab.study.execution import runner

    case, count = model_of("pasternak", unknowns), STUDY * 6734 // unknowns
    read = scattering(case, count)
    found: dict[int, list[float]] = {1: [], 2: []}
    for _ in range(times):
        for workers, paces in found.items():
            seen: list[tuple[float, int]] = []
            with tempfile.TemporaryDirectory() as folder:
                runner.run(
                    read, Path(folder) / "study", runner.Resources(workers), False,
                    lambda progress, seen=seen: seen.append((time.perf_counter(), progress.rows)),
                )  # fmt: skip
            (begin, first), (end, last) = next(each for each in seen if each[1]), seen[-1]
            assert last == count
            paces.append((last - first) / (end - begin))
    one, two = (statistics.median(found[workers]) for workers in (1, 2))
    return {
        "unknowns": next(iter(driver.solve_combinations(case).results.values())).unknowns,
        "total [s]": count / two,
        "variants per second, one worker": one,
        "variants per second, two workers": two,
        "efficiency on two workers": two / (2 * one),
    }


def solvers(unknowns: int, times: int) -> dict[str, Any]:
    """Return how long a further factorization of one pattern takes on one thread, beside PARDISO's."""
    upper, _ = glued_system(model_of("linear", unknowns))
    spent: dict[str, list[float]] = defaultdict(list)
    with factorization.one_thread():
        for name in ("pardiso", "cholmod", "superlu"):
            analyzed = factorization.choose(name)[1](upper.indptr, upper.indices)
            analyzed.factor(upper.data)
            spent[name] = [measure(analyzed.factor, upper.data)[0] for _ in range(times)]
    medians = {name: statistics.median(each) for name, each in spent.items()}
    return {
        "unknowns": upper.size,
        "total [s]": medians["pardiso"],
        **{f"{name} / pardiso": medians[name] / medians["pardiso"] for name in ("cholmod", "superlu")},
    }


def threads(unknowns: int, times: int) -> dict[str, Any]:
    """Return an analysis on one thread beside the same on all."""
    model = model_of("winkler", unknowns)
    ratios, totals = [], []
    for _ in range(times):
        with factorization.one_thread():
            alone, _ = measure(driver.solve, model)
        total, results = measure(driver.solve, model)
        totals.append(total)
        ratios.append(alone / total)
    return {
        "unknowns": results.only.unknowns,
        "total [s]": statistics.median(totals),
        "one thread / all": statistics.median(ratios),
    }


def case(path: str, times: int) -> dict[str, Any]:
    """Return solving and the whole process of a case beside as many bare solves as it has combinations.

    The bare solve is that of the largest matrix that was factorized on the way. The share of the direct solver is
    taken with one combination at a time.
    """
    model, spent, largest = casefile.load(path), defaultdict[str, float](float), dict[int, Symmetric]()
    factor = pardiso.Pardiso.factor

    def watched(self: Any, data: Any) -> Any:
        if len(data) > max(largest, default=0):
            largest.clear()
            largest[len(data)] = Symmetric(self.indptr, self.indices, data)
        return factor(self, data)

    pardiso.Pardiso.factor = watched  # type: ignore[method-assign]
    combined = driver.solve(model)
    pardiso.Pardiso.factor = factor  # type: ignore[method-assign]
    (upper,) = largest.values()
    alone, n = bare(upper, np.ones(upper.size)), len(combined.combinations)
    figures = defaultdict[str, list[float]](list)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "groundslab", "solve", path, "--quiet", "--out", f"{folder}/results"]
        for _ in range(times):
            least = n * alone()
            solving = measure(driver.solve, model)[0]
            whole, ended = measure(subprocess.run, command)
            if ended.returncode not in (0, 3):  # 3: a design that fails a check
                raise RuntimeError(f"{' '.join(command)} ended with {ended.returncode}")
            figures["total [s]"].append(solving)
            figures["solving / bare"].append(solving / least)
            figures["whole process [s]"].append(whole)
            figures["whole process / bare"].append(whole / least)
    # single combinations, so that times in the solver do not overlap
    pardiso.Pardiso._call = timed(pardiso.Pardiso._call, "solver", spent)  # type: ignore[method-assign]
    run.MAX_LANES = 1
    for _ in range(times):
        spent.clear()
        solving = measure(driver.solve, model)[0]
        figures["direct solver / solving"].append(spent["solver"] / solving)
    return {
        "unknowns": next(iter(combined.results.values())).unknowns,
        "combinations": n,
        **{name: statistics.median(each) for name, each in figures.items()},
    }


def main(kind: str, unknowns: int, times: int) -> dict[str, Any]:
    """Return the figures of one job."""
    keep_memory()
    own = {
        "gamma": gamma, "combinations": combinations, "variants": variants, "study": study, "solvers": solvers,
        "threads": threads, "continuum": continuum,
    }  # fmt: skip
    if kind in own:
        return {"kind": kind, **own[kind](unknowns, times)}
    return {"kind": kind, **beside_the_bare_solve(kind, unknowns, times)}


if __name__ == "__main__":
    if sys.argv[1] == "case":
        keep_memory()
        print(json.dumps({"kind": Path(sys.argv[2]).stem, **case(sys.argv[2], int(sys.argv[3]))}))
    elif sys.argv[1] == "memory":
        solver = {"solver": sys.argv[4]} if len(sys.argv) > 4 else {}
        print(json.dumps(memory(model_of(sys.argv[2], int(sys.argv[3])).replace(analysis=solver))))
    else:
        print(json.dumps(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))))
