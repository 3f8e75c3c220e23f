"""Nested iteration: load increments on meshes from coarse to fine, and the effect of the margin of ground."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

import numpy as np

from groundslab.analysis.gamma_iteration import solve_load_step
from groundslab.analysis.load_step import LoadStep, OnStep
from groundslab.analysis.mesh_hierarchy import Level, MeshHierarchy, Solved
from groundslab.arrays import Array
from groundslab.discretize.plan_layout import coarsest, has_coarser
from groundslab.discretize.symmetry import symmetries
from groundslab.errors import NoEquilibrium, NotConverged, SingularMatrix
from groundslab.fem.bearings import largest_of_parts
from groundslab.fem.problem import W
from groundslab.model.ground import ContinuousGround
from groundslab.model.model import Model
from groundslab.model.plates.joints import play_of
from groundslab.results.records import Step
from groundslab.solvers.conditioning import require_digits
from groundslab.solvers.equilibrium import require_equilibrium
from groundslab.solvers.solution import Solution

#: The elements' size is halved so many times from one of the nested meshes to the next.
HALVINGS = 2
#: After so many steps of contact a combination is told to be unlike those before.
FEW_STEPS = 6

#: Solutions to start from, and the most steps of contact that are worth it.
Start = tuple[list[Solution], int]


def solve_nested(
    hierarchy: MeshHierarchy, combination: str, factors: Array, report: OnStep
) -> dict[int, list[Solution]]:
    """Return the solution of each load increment on each of the meshes, by how often it is coarsened.

    That on the finest mesh is reached from the coarsest one upwards, which starts from the nearest combination of those
    solved before, on this mesh or on the one made before; or it starts from that of a similar model, if that converges.
    On coarser meshes there may be none. factors (cases,) are those of the combination.
    """
    model, solutions, before = hierarchy.model, dict[int, list[Solution]](), None
    if hierarchy.has_reference(combination):
        level = hierarchy.level(hierarchy.finest)
        full = _full_load(model, level, factors, report, True)
        start = hierarchy.matching(combination, full.system)
        if start:
            with suppress(NotConverged, SingularMatrix):
                return {hierarchy.finest: _solve_increments(full, model, start)}
    start = list[Solution]()
    for coarsening in _coarsenings(hierarchy):
        level = hierarchy.level(coarsening)
        solved = level.solved.get(factors.tobytes())
        if solved is not None:
            start = solved.solutions
        else:
            start = level.multiple(factors) or (start if solutions else hierarchy.start(level, factors))
            starts = _starts(hierarchy, combination, factors, start, first=not solutions)
            finest = coarsening == hierarchy.finest
            on_step = report if finest or model.analysis.nested else _ignore
            make_load = partial(_full_load, model, level, factors, on_step, finest, before)
            start = (_solve_finest if finest else _solve_coarser)(make_load, model, starts)
        solutions[coarsening] = start
        if start and len(solutions) == 1 and coarsening > 0:
            level.add(Solved(factors, start))
        if start and hierarchy.keep:
            level.keep_for_multiples(Solved(factors, start))
        before = None if level.system.problem.elastic is None else level
    hierarchy.store(combination, start)
    return solutions


def _starts(
    hierarchy: MeshHierarchy, combination: str, factors: Array, start: list[Solution], first: bool
) -> Iterator[Start]:
    """Yield solutions to start from on a mesh, each with the most steps of contact that are worth it.

    On the first mesh a combination unlike those before starts from a mesh of few elements of one size, on which its
    contact zone is found in many steps that cost nothing.
    """
    model = hierarchy.model
    if first and _first(model) > 0 and model.mesh.adaptive and not isinstance(model.ground, ContinuousGround):
        yield start, min(FEW_STEPS, model.analysis.max_iterations)
        start = _solve_uniform(hierarchy.make_uniform(), combination, factors) or start
    yield start if model.analysis.nested else [], model.analysis.max_iterations


def _solve_uniform(uniform: MeshHierarchy, combination: str, factors: Array) -> list[Solution]:
    """Return the solutions on a mesh of few elements, if there are any."""
    with suppress(NoEquilibrium, NotConverged, SingularMatrix):
        return solve_nested(uniform, combination, factors, _ignore)[uniform.finest]
    return []


def _solve_finest(make_load: Callable[[], LoadStep], model: Model, starts: Iterable[Start]) -> list[Solution]:
    """Return the solution of each load increment on the finest mesh, without a start if all of them mislead."""
    load = make_load()
    for start, steps in starts:
        tried = steps < load.max_iterations
        if start or tried:
            # after few steps what would hold the plate may not be found yet
            with suppress(NotConverged, *([NoEquilibrium] if tried else [])):
                return _solve_increments(replace(load, max_iterations=steps), model, start)
    return _solve_increments(load, model, [])


def _solve_coarser(make_load: Callable[[], LoadStep], model: Model, starts: Iterable[Start]) -> list[Solution]:
    """Return the solution of each load increment on one of the coarser meshes, nothing else of which is kept.

    Without equilibrium or convergence there the next mesh has no start.
    """
    with suppress(NoEquilibrium):
        load = make_load()
        for start, steps in starts:
            with suppress(NotConverged, SingularMatrix):
                return _solve_increments(replace(load, max_iterations=steps), model, start)
    return []


def _ignore(_: Step) -> None:
    """Report no step."""


def margin_effect(
    margins: Sequence[MeshHierarchy],
    combination: str,
    factors: Array,
    by_level: Mapping[int, Sequence[Solution]],
) -> float:
    """Return the change of any settlement by a wider margin of infinite ground, over its plate's largest settlement.

    Both meshes are the same on the plate, where their nodes stand in the same order. The solutions on the narrow one
    may have been found on the way to the finest mesh; else they start from those on that, and have their gammas.
    """
    first, second = margins
    before = by_level.get(first.finest) or _solve_from(first, combination, factors, by_level[min(by_level)])
    after = _solve_from(second, combination, factors, before)
    narrow, wide = (solutions[-1].U[solutions[-1].system.problem.plate.nodes, W] for solutions in (before, after))
    problem = before[-1].system.problem
    largest = largest_of_parts(np.maximum(np.abs(narrow), np.abs(wide)), problem.plate_at_nodes[problem.plate.nodes])
    return float(np.divide(np.abs(wide - narrow), largest, out=np.zeros_like(largest), where=largest > 0).max())


def _solve_from(
    hierarchy: MeshHierarchy, combination: str, factors: Array, earlier: Sequence[Solution]
) -> Sequence[Solution]:
    """Return the solutions with the gammas found, started from what is known, if that converges."""
    model = hierarchy.model
    level = hierarchy.level(hierarchy.finest)
    full = _full_load(model, level, factors, _ignore, True)
    matching = hierarchy.matching(combination, full.system) if hierarchy.has_reference(combination) else []
    gammas = [solution.gamma for solution in earlier]
    with suppress(NotConverged, SingularMatrix):
        solutions = _solve_increments(full, model, matching or level.multiple(factors) or earlier, gammas)
        level.keep_for_multiples(Solved(factors, solutions))
        hierarchy.store(combination, solutions)
        return solutions
    return solve_nested(hierarchy, combination, factors, _ignore)[hierarchy.finest]


def required_coarsenings(hierarchy: MeshHierarchy, combinations: Sequence[str]) -> list[int]:
    """Return how often the mesh is coarsened for each of the meshes on which the combinations will be solved."""
    has_references = all(map(hierarchy.has_reference, combinations))
    return [hierarchy.finest] if has_references else _coarsenings(hierarchy)


def _coarsenings(hierarchy: MeshHierarchy) -> list[int]:
    """Return how often the mesh is coarsened for each of the meshes, the coarsest first.

    The next coarser mesh shows how far the results of the finest one depend on the mesh; before it the size changes by
    HALVINGS at a time.
    """
    if hierarchy.coarsenings is None:
        hierarchy.coarsenings = _list_coarsenings(hierarchy)
    return hierarchy.coarsenings


def _list_coarsenings(hierarchy: MeshHierarchy) -> list[int]:
    """Return them, which takes looking at the symmetry of all loads."""
    last, first = hierarchy.finest, max(_first(hierarchy.model), hierarchy.finest)
    if last > 0 or not has_coarser(hierarchy.model, symmetries(hierarchy.model)):
        return sorted({*range(last, first + 1, HALVINGS), first}, reverse=True)
    return sorted({last, *range(last + 1, first + 1, HALVINGS), max(first, last + 1)}, reverse=True)


def _first(model: Model) -> int:
    """Return how coarse the first mesh is: the finest one where a coarser one would not help."""
    one_sided = model.contact.tensionless or any(support.acts != "both ways" for support in model.supports)
    one_sided = one_sided or any(map(play_of, model.joints))
    iterated = getattr(model.ground, "gamma", None) == "iterate"
    return coarsest(model) if one_sided or iterated else 0


def _full_load(
    model: Model, level: Level, factors: Array, report: OnStep, finest: bool, before: Level | None = None
) -> LoadStep:
    """Return load cases times factors on a mesh, with no slip before; raises an error if that cannot be solved."""
    problem = level.system.problem.combine(factors)
    require_equilibrium(problem)
    if problem.elastic is None:
        require_digits(level.system, level.first_column)
    slip = np.zeros(len(problem.contact.bearing.law))
    s = replace(level.system, problem=problem)
    return LoadStep(s, level, 1.0, slip, finest, model.analysis.max_iterations, report, coarser=before)


def _solve_increments(
    full: LoadStep, model: Model, coarser: Sequence[Solution], gammas: Sequence[float | None] = ()
) -> list[Solution]:
    """Return a solution for each increment of the full load, each started from the same one on the coarser mesh.

    gammas are those of the increments, where they are not to be found.
    """
    increments: list[Solution] = []
    for number in range(1, model.analysis.increments + 1):
        start = coarser[number - 1] if coarser else (increments[-1] if increments else None)

        def report_increment(step: Step, number: int = number) -> None:
            full.report(replace(step, increment=number))

        share = replace(
            full,
            factor=number / model.analysis.increments,
            slip=increments[-1].slip if increments else full.slip,
            report=report_increment,
            gamma=gammas[number - 1] if gammas else None,
        )
        increments.append(solve_load_step(share, start))
    return increments
