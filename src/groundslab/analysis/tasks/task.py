"""What is solved once: combinations of the same loads on the same ground, however they are called."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from groundslab.accuracy.comparison import compare
from groundslab.analysis.cracking_iteration import solve_cracked_meshes
from groundslab.analysis.load_step import OnStep
from groundslab.analysis.mesh_hierarchy import MeshHierarchy
from groundslab.analysis.nested import margin_effect, solve_nested
from groundslab.errors import GroundslabError, IllConditioned, NoEquilibrium, NotCertified, NotConverged, SingularMatrix
from groundslab.model.combinations import case_factors
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.certificate import certificate, worst
from groundslab.results.records import Step
from groundslab.results.recovery import Recovered, expand, recover, recover_fields
from groundslab.results.results import CombinationResult, Increment
from groundslab.solvers.solution import Solution

#: The results of a combination, or why it has none.
Outcome = CombinationResult | GroundslabError


@dataclass(frozen=True, slots=True)
class Task:
    """The loads and the ground of combinations, and whether the slab cracks in them."""

    factors: tuple[float, ...]  # of each load case
    cracks: bool
    lasting: bool  # whether the ground is that under lasting loads


def task_of(model: Model, combination: Combination) -> Task:
    """Return what is solved for a combination."""
    state = combination.limit_state
    factors = tuple(case_factors(model, combination).tolist())
    return Task(factors, model.cracking is not None and state in model.cracking.limit_states, model.lasts(state))


def solve_task(
    task: Task,
    model: Model,
    combination: Combination,
    hierarchies: Sequence[MeshHierarchy],
    solver: str,
    on_step: OnStep,
) -> Outcome:
    """Return the results of the first combination of a task, or why it has none.

    Parameters
    ----------
    task : Task
        What is solved.
    model : Model
        The case as solved.
    combination : Combination
        The combination that the results are of.
    hierarchies : sequence of MeshHierarchy
        The finest meshes, and two for the effect of the margin of infinite ground if that is judged.
    solver : str
        Name of the direct solver, for the results.
    on_step : callable
        Called with every step.

    Returns
    -------
    CombinationResult or GroundslabError
        The results, or why there are none.
    """
    finest, *margins = hierarchies
    factors = np.array(task.factors)
    steps: list[Step] = []

    def report(step: Step) -> None:
        steps.append(step)
        on_step(step)

    try:
        solutions = solve_nested(finest, combination.name, factors, report)
        effect = None
        if margins and ends_in_tails(model):
            effect = margin_effect(margins, combination.name, factors, solutions)
        *earlier, solution = solutions[finest.finest]
        coarser = next(reversed(solutions.get(finest.finest + 1, [])), None)
        if task.cracks:
            solution, coarser = solve_cracked_meshes(finest, solution, coarser, report)
        solved = _Solved(solution, coarser, earlier, effect, tuple(steps), solver)
        results = _recover(model, combination, finest, solved)
        return results if results.certificate.holds else NotCertified(results)
    except (IllConditioned, NoEquilibrium, NotConverged, SingularMatrix) as error:
        # its traceback would keep meshes and factors alive
        return error.with_traceback(None)


@dataclass(frozen=True, slots=True)
class _Solved:
    """What was solved for a combination."""

    solution: Solution  # under the full load, on the finest mesh
    coarser: Solution | None  # the same on the next coarser mesh
    earlier: Sequence[Solution]  # under smaller shares of the load
    margin_effect: float | None
    steps: tuple[Step, ...]
    solver: str


def _recover(model: Model, combination: Combination, finest: MeshHierarchy, solved: _Solved) -> CombinationResult:
    """Return fields, forces, errors and certificate of what was solved."""
    solution = solved.solution
    effect = solved.margin_effect
    frame = finest.result_mesh(solution, finest.finest)
    before = _with_load_shares(solved.earlier)
    proof = worst([certificate(solution, effect), *(certificate(state, effect) for _, state in before)])
    increments = tuple(Increment(share, *expand(recover_fields(state, frame), frame)) for share, state in before)
    fields = recover_fields(solution, frame)
    comparison = None
    if solved.coarser is not None:
        prolongation = finest.prolongation(solved.coarser, solution, frame)
        comparison, fields = compare(model, solution, solved.coarser, prolongation, fields)
    recovered = Recovered(expand(fields, frame), increments, comparison, proof)
    return recover(model, combination, solution, recovered, solved.steps, solved.solver)


def ends_in_tails(model: Model) -> bool:
    """Return whether infinite ground beyond the plate is meshed and ends in tails."""
    return model.beyond.kind == "infinite" and model.ground_reaches and not isinstance(model.ground, ContinuousGround)


def _with_load_shares(earlier: Sequence[Solution]) -> list[tuple[float, Solution]]:
    """Return the solutions of all load increments but the last, each with its share of the load."""
    states = []
    for number, solution in enumerate(earlier, start=1):
        share = number / (len(earlier) + 1)
        problem = solution.system.problem
        loaded = replace(problem, loading=problem.loading.scale(share))
        states.append((share, replace(solution, system=replace(solution.system, problem=loaded))))
    return states
