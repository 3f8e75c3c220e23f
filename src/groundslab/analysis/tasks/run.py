"""Runs tasks one after the other, or in parallel lanes, each lane with its share of the threads."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from groundslab.analysis.mesh_hierarchy import MeshHierarchy, ReferenceSolutions, Solved, direction
from groundslab.analysis.nested import HALVINGS, required_coarsenings, solve_nested
from groundslab.analysis.tasks.parallel import run_parallel
from groundslab.analysis.tasks.task import Outcome, Task, ends_in_tails, solve_task, task_of
from groundslab.arrays import Array
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import Meshes, coarsest
from groundslab.fem.mesh import Mesh
from groundslab.model.combinations import list_combinations
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.records import Step
from groundslab.results.recovery import settlement_of
from groundslab.solvers import factorization
from groundslab.solvers.direct.protocols import Solver

#: At most so many tasks are solved at the same time,
MAX_LANES = 4
#: and only if each has no more unknowns than this: every lane needs memory for a factor.
MAX_PARALLEL_UNKNOWNS = 400_000

#: Called with a combination as it begins, and with every step of it.
Report = Callable[[Combination | Step], None]
#: The meshes of a model on its ground, and on the ground under lasting loads: the finest, two for the margin's effect.
Grounds = dict[bool, list[MeshHierarchy]]


@dataclass(frozen=True, slots=True)
class Setting:
    """What all tasks of a model have in common.

    Attributes
    ----------
    model : Model
        The case as solved.
    meshes : Meshes
        Meshes made so far.
    reference : ReferenceSolutions or None
        Solutions of a similar model from which the tasks start, or where theirs are kept.
    factors : Factors or None
        Factors on the ground's constants, from place to place.
    grounds : dict
        Meshes with what was made on them, for further tasks.
    outcomes : dict
        Outcomes of the tasks that are done.
    earlier : dict
        What was solved on the coarsest of the meshes before, by the ground.
    draft : bool
        Whether they are solved on the next coarser mesh alone, whose solutions those on the finest one then start from.
    """

    model: Model
    meshes: Meshes
    reference: ReferenceSolutions | None = None
    factors: Factors | None = None
    grounds: Grounds = field(default_factory=dict)
    outcomes: dict[Task, Outcome] = field(default_factory=dict)
    earlier: dict[bool, list[Solved]] = field(default_factory=dict)
    draft: bool = False

    def solved(self) -> dict[bool, list[Solved]]:
        """Return what was solved on the coarsest mesh, from which combinations start on the next meshes."""
        if isinstance(self.model.ground, ContinuousGround):
            return {}
        return {lasting: finest.solved() for lasting, (finest, *_) in self.grounds.items()}


def run(tasks: Mapping[Task, Combination], setting: Setting, report: Report) -> Iterator[tuple[Task, Outcome]]:
    """Yield each task with its outcome, for the combination that it is the first of.

    Tasks whose loads are multiples of each other follow one another.
    """
    name, solver = factorization.choose(setting.model.analysis.solver)
    factorization.warm_up(solver)
    grounds = _prepare_grounds(tasks, setting, solver)
    if setting.draft:
        grounds = {lasting: [finest.draft()] for lasting, (finest, *_) in grounds.items()}
    lanes = _distribute(tasks, _count_lanes(tasks, grounds, solver))
    jobs = {task: partial(_solve, task, combinations, setting.model, name) for task, combinations in tasks.items()}
    if len(lanes) == 1:
        for task in lanes[0]:
            yield jobs[task](grounds, report)
        return
    _make_what_lanes_share(tasks, setting.model, grounds)
    # whichever lane is faster, each has the same tasks in the same order, and so the same factors to begin with
    meshes_of_lanes = [grounds, *(_clone(grounds) for _ in lanes[1:])]
    by_lane = [
        [partial(jobs[task], meshes) for task in lane] for lane, meshes in zip(lanes, meshes_of_lanes, strict=True)
    ]
    threads = factorization.threads(solver) // len(lanes)
    yield from run_parallel(by_lane, report, lambda: factorization.use_threads(solver, threads))


def solve_settlement(combination: Combination, setting: Setting) -> tuple[Mesh, Array]:
    """Return the plate's mesh and its settlement (n,) [m] in a combination in which the slab does not crack.

    Nothing else is solved, recovered or judged. Raises an error as `solve` does, but none of a certificate.
    """
    _, solver = factorization.choose(setting.model.analysis.solver)
    factorization.warm_up(solver)
    task = task_of(setting.model, combination)
    finest, *_ = _prepare_grounds([task], setting, solver)[task.lasting]
    solutions = solve_nested(finest, combination.name, np.array(task.factors), lambda _: None)
    solution = solutions[finest.finest][-1]
    return settlement_of(solution, finest.result_mesh(solution, finest.finest))


def _distribute(tasks: Iterable[Task], lanes: int) -> list[list[Task]]:
    """Return the tasks of each lane; multiples of the same loads follow one another in one of them."""
    alike: dict[tuple[bool, bytes], list[Task]] = {}
    for task in tasks:
        alike.setdefault((task.lasting, direction(np.array(task.factors))), []).append(task)
    lanes_of_tasks: list[list[Task]] = [[] for _ in range(lanes)]
    for group in alike.values():
        min(lanes_of_tasks, key=len).extend(group)
    return [lane for lane in lanes_of_tasks if lane] or [[]]


def _solve(
    task: Task, combination: Combination, model: Model, solver: str, grounds: Grounds, report: Report
) -> tuple[Task, Outcome]:
    """Return a task with its outcome on its ground."""
    report(combination)
    return task, solve_task(task, model, combination, grounds[task.lasting], solver, report)


def _prepare_grounds(tasks: Iterable[Task], setting: Setting, solver: Solver) -> Grounds:
    """Return the meshes of a setting, with those on each ground that tasks need.

    Softer ground under lasting loads is another problem, of which a similar model knows nothing.
    """
    model = setting.model
    keep = len(list_combinations(model)) > 1 or setting.reference is not None or model.cracking is not None

    def hierarchies(model: Model, reference: ReferenceSolutions | None) -> list[MeshHierarchy]:
        # the margin's effect is judged on the next coarser mesh, where it costs little
        level = min(HALVINGS, coarsest(model))
        return [
            MeshHierarchy(model, solver, finest, margin, keep, setting.meshes, setting.factors, reference)
            for finest, margin in ((0, 1.0), (level, 1.0), (level, 2.0))
        ]

    for lasting in {task.lasting for task in tasks} - setting.grounds.keys():
        ground = (model.with_lasting_ground(), None) if lasting else (model, setting.reference)
        setting.grounds[lasting] = hierarchies(*ground)
        setting.grounds[lasting][0].earlier = setting.earlier.get(lasting, ())
    return setting.grounds


def _count_lanes(tasks: Mapping[Task, Combination], grounds: Grounds, solver: Solver) -> int:
    """Return how many tasks are solved at the same time."""
    if len(tasks) <= 1:  # it does not wait for the number of threads, which a solver tells when it is loaded
        return 1
    lanes = min(MAX_LANES, factorization.threads(solver), len(tasks))
    finest = grounds[next(iter(tasks)).lasting][0]
    if lanes > 1 and finest.level(finest.finest).system.pattern.size > MAX_PARALLEL_UNKNOWNS:
        return 1
    return lanes


def _make_what_lanes_share(tasks: Mapping[Task, Combination], model: Model, grounds: Grounds) -> None:
    """Make meshes, systems and the meshes of results before lanes clone them."""
    names = [combination.name for combination in tasks.values()]
    for finest, *margins in grounds.values():
        for coarsening in required_coarsenings(finest, names):
            finest.level(coarsening)
        for hierarchy in margins if ends_in_tails(model) else []:
            if hierarchy.margin > 1 or hierarchy.finest not in finest.levels:
                hierarchy.level(hierarchy.finest)
        for coarsening in {finest.finest, finest.finest + 1} & finest.levels.keys():
            finest.level(coarsening).result_mesh(model)
        finest.level(finest.finest).result_mesh(model).make_means()


def _clone(grounds: Grounds) -> Grounds:
    """Return the same meshes with factors of their own, for use on another thread."""
    return {lasting: [hierarchy.clone() for hierarchy in several] for lasting, several in grounds.items()}
