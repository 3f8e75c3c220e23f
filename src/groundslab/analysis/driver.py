"""The public entry points of an analysis: solve the combinations of a model, solve variants of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from groundslab.accuracy.comparison import compare
from groundslab.analysis.adaptivity import solve_adaptively
from groundslab.analysis.cracking_iteration import solve_cracked_meshes
from groundslab.analysis.load_step import OnStep
from groundslab.analysis.mesh_hierarchy import MeshHierarchy, ReferenceSolutions
from groundslab.analysis.moved_results import move_back
from groundslab.analysis.nested import HALVINGS, margin_effect, required_coarsenings, solve_nested
from groundslab.analysis.parallel import run_parallel
from groundslab.arrays import Array
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import Meshes, coarsest
from groundslab.discretize.serviceability.lasting_ground import lasts, with_lasting_ground
from groundslab.errors import GroundslabError, IllConditioned, NoEquilibrium, NotCertified, NotConverged, SingularMatrix
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.model.plan_origin import move_to_center
from groundslab.model.settings import Mesh
from groundslab.results.certificate import certificate, worst
from groundslab.results.record import Step
from groundslab.results.recovery import expand, recover, recover_fields
from groundslab.results.results import CombinationResult, Increment, Results
from groundslab.solvers import factorization
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.solution import Solution

#: Variants have the mesh of the base case, made for errors of this share of the accuracy, as theirs may be larger.
BASE_SHARE = 0.5
#: A preview has about so many elements.
PREVIEW_ELEMENTS = 100
#: At most so many combinations are solved at the same time, each on its share of the threads,
MAX_LANES = 4
#: and only if each has no more unknowns than this: every lane needs memory for a factor.
MAX_PARALLEL_UNKNOWNS = 400_000

OnCombination = Callable[[Combination], None]
OnMesh = Callable[[Results], None]


def solve(model: Model, on_step: OnStep | None = None, on_combination: OnCombination | None = None) -> Results:
    """Solve every combination of a model, and return the certified results.

    Meshes, matrices and factors are kept from one combination to the next.

    Parameters
    ----------
    model : Model
        The model. Its combinations are those that it lists or that it has made by EN 1990; with neither, each load
        case by itself.
    on_step : callable, optional
        Called with every `Step` of the iteration as it ends.
    on_combination : callable, optional
        Called with every `Combination` as it begins.

    Returns
    -------
    Results
        The results of all combinations, by name. Of a model with several combinations, one that has no equilibrium or
        no certified result does not stop the others: `refused` says why it has none.

    Raises
    ------
    InputError
        If the model describes no problem that can be solved.
    NoEquilibrium
        If the only combination cannot be balanced by ground and supports.
    NotConverged
        If the only combination does not converge; holds history and last iterate.
    IllConditioned, SingularMatrix
        If stiffnesses of the only combination differ by too much.
    NotCertified
        If the only combination's results do not satisfy the equations; holds them all the same.

    See Also
    --------
    check : Validate a model without solving it.

    Examples
    --------
    >>> import groundslab
    >>> results = groundslab.solve(model)
    >>> results.certificate.holds
    True
    >>> print(f"{1e3 * results.plate.settlement.max():.2f} mm")
    3.00 mm
    """
    found = solve_combinations(model, on_step, on_combination)
    if len(found.combinations) == 1:
        for refusal in found.refused.values():
            raise refusal
    return found


def solve_combinations(
    model: Model,
    on_step: OnStep | None = None,
    on_combination: OnCombination | None = None,
    on_mesh: OnMesh | None = None,
) -> Results:
    """Solve every combination of a model as `solve` does, but keep a single one that is refused in `refused` too.

    on_mesh is called with the results on each mesh that is not the last.
    """
    local = move_to_center(model)
    combinations, placed = list_combinations(local), place_patterns(local)

    def solve_on(meshes: Meshes) -> Results:
        return _combine(local, combinations, _outcomes(placed, combinations, on_step, meshes), on_combination)

    def report(results: Results) -> None:
        if on_mesh is not None:
            on_mesh(move_back(results, model))

    return move_back(solve_adaptively(placed, solve_on, on_mesh=report), model)


def solve_preview(model: Model, name: str, on_step: OnStep | None = None) -> Results:
    """Solve one combination on a mesh of few elements, for a first look while all are solved.

    The slab does not crack, and nothing says how large the errors are. The name may be of no combination: then it is
    the first one.
    """
    local = move_to_center(model)
    combinations, placed = list_combinations(local), place_patterns(local)
    one = next((each for each in combinations if each.name == name), combinations[0])
    area = sum(math.prod(plate.sides) for plate in model.every_plate)
    mesh = Mesh(size=math.sqrt(area / PREVIEW_ELEMENTS))
    coarse = placed.model_copy(update={"mesh": mesh, "cracking": None})
    solver_name, solver = factorization.choose(model.analysis.solver)
    hierarchy = MeshHierarchy(coarse, solver, 0, 1.0, keep=False)
    outcome = _outcome(coarse, one, [hierarchy], solver_name, on_step or (lambda _: None))
    found = _combine(coarse, [one], iter([outcome]))
    return move_back(found, model.model_copy(update={"mesh": mesh, "cracking": None}))


class Variants:
    """Solves models similar to a base case, reusing its meshes, analyses of patterns and contact zones.

    Each starts from the base case's contact zone, not from that of the variant before, so that its results do not
    depend on which others were solved.
    """

    def __init__(self, base: Model) -> None:
        """Solve the base case, whose combinations may fail; raises InputError as `solve` does."""
        local = move_to_center(base)
        combinations, placed = list_combinations(local), place_patterns(local)

        def solve_on(meshes: Meshes) -> Results:
            self._reference = ReferenceSolutions(meshes)
            return _combine(local, combinations, _outcomes(placed, combinations, None, meshes, self._reference))

        #: The results of the base case, whose mesh all variants have.
        self.base = move_back(solve_adaptively(placed, solve_on, BASE_SHARE), base)
        self._reference.close()

    def solve_combinations(
        self, model: Model, factors: Factors | None = None, on_step: OnStep | None = None
    ) -> Results:
        """Return the results of every combination of a model, as the function of that name does.

        `factors` multiply constants of the ground from place to place, by their names in the file: a function of x and
        y (p,) [m] for "ground.k0", "ground.layers[1].E" and the like. No symmetry is used then. Raises InputError if
        the ground has no such constant.
        """
        if factors:
            model = model.model_copy(update={"mesh": model.mesh.replace(symmetry="off")})
        local = move_to_center(model)
        combinations, placed = list_combinations(local), place_patterns(local)
        reference = self._reference
        outcomes = _outcomes(placed, combinations, on_step, reference.meshes, reference, factors)
        return move_back(_combine(local, combinations, outcomes), model)


def _combine(
    model: Model,
    combinations: Sequence[Combination],
    outcomes: Iterator[CombinationResult | GroundslabError],
    on_combination: OnCombination | None = None,
) -> Results:
    """Return the outcomes of all combinations together."""
    results: dict[str, CombinationResult] = {}
    refused: dict[str, GroundslabError] = {}
    for combination in combinations:
        if on_combination is not None:
            on_combination(combination)
        outcome = next(outcomes)
        if isinstance(outcome, GroundslabError):
            refused[combination.name] = outcome
        else:
            results[combination.name] = outcome
    return Results(model, tuple(combinations), results, refused)


def _outcomes(
    model: Model,
    combinations: Sequence[Combination],
    on_step: OnStep | None,
    meshes: Meshes,
    reference: ReferenceSolutions | None = None,
    ground: Factors | None = None,
) -> Iterator[CombinationResult | GroundslabError]:
    """Yield for each combination its results, or why it has none; those with the same factors are solved once."""
    keys = [
        (_cracks(model, each), lasts(model, each.limit_state), *_case_factors(model, each).tolist())
        for each in combinations
    ]
    first: dict[tuple[float, ...], Combination] = {}
    for key, combination in zip(keys, combinations, strict=True):
        first.setdefault(key, combination)
    solved = _solve_each(model, list(first.values()), on_step or (lambda _: None), meshes, reference, ground)
    found: dict[tuple[float, ...], CombinationResult | GroundslabError] = {}
    for key, combination in zip(keys, combinations, strict=True):
        if key not in found:
            found[key] = next(solved)
        yield _rename(found[key], combination)


def _rename(
    outcome: CombinationResult | GroundslabError, combination: Combination
) -> CombinationResult | GroundslabError:
    """Return the outcome of a combination as that of another one with the same factors."""
    if isinstance(outcome, NotCertified):
        return NotCertified(_rename(outcome.results, combination))
    if not isinstance(outcome, CombinationResult) or outcome.combination == combination.name:
        return outcome
    name, limit_state = combination.name, combination.limit_state
    return replace(outcome, combination=name, limit_state=limit_state, factors=combination.factors)


def _solve_each(
    model: Model,
    combinations: Sequence[Combination],
    on_step: OnStep,
    meshes: Meshes,
    reference: ReferenceSolutions | None,
    ground: Factors | None,
) -> Iterator[CombinationResult | GroundslabError]:
    """Yield for each combination its results, or why it has none; several are solved in parallel."""
    name, solver = factorization.choose(model.analysis.solver)
    factorization.warm_up(solver)
    keep = len(combinations) > 1 or reference is not None or model.cracking is not None
    make = partial(_hierarchies, solver=solver, keep=keep, meshes=meshes, ground=ground)
    # softer ground under lasting loads is another problem, of which a similar model knows nothing
    lasting = [lasts(model, each.limit_state) for each in combinations]
    on_ground = {
        long: make(with_lasting_ground(model), None) if long else make(model, reference) for long in set(lasting)
    }
    # one combination does not wait for the number of threads, which a solver tells when it is loaded
    lanes = 1 if len(combinations) == 1 else min(MAX_LANES, factorization.threads(solver), len(combinations))
    if lanes > 1 and on_ground[lasting[0]][0].level(0).system.pattern.size > MAX_PARALLEL_UNKNOWNS:
        lanes = 1
    if lanes < 2:
        for each, long in zip(combinations, lasting, strict=True):
            yield _outcome(model, each, on_ground[long], name, on_step)
        return
    # make what the lanes share first
    for finest, *margins in on_ground.values():
        for coarsening in required_coarsenings(finest, combinations):
            finest.level(coarsening)
        for hierarchy in margins if _is_infinite(model) else []:
            hierarchy.level(hierarchy.finest)
        for coarsening in {0, 1} & finest.levels.keys():
            finest.level(coarsening).result_mesh(model)
    # whichever lane is faster, each has the same tasks in the same order, and so the same factors to begin with
    tasks = []
    for lane in range(lanes):
        own = {long: [each.clone() for each in found] if lane else found for long, found in on_ground.items()}
        some = zip(combinations[lane::lanes], lasting[lane::lanes], strict=True)
        tasks.append([partial(_outcome, model, each, own[long], name) for each, long in some])
    threads = factorization.threads(solver) // lanes
    yield from run_parallel(tasks, on_step, lambda: factorization.use_threads(solver, threads))


def _hierarchies(
    model: Model,
    reference: ReferenceSolutions | None,
    solver: Solver,
    keep: bool,
    meshes: Meshes,
    ground: Factors | None,
) -> list[MeshHierarchy]:
    """Return the finest meshes of a model, and two for the effect of the margin.

    That is judged on the next coarser mesh, where it costs little.
    """
    level = min(HALVINGS, coarsest(model))
    return [
        MeshHierarchy(model, solver, finest, margin, keep, meshes, ground, reference)
        for finest, margin in ((0, 1.0), (level, 1.0), (level, 2.0))
    ]


def _outcome(
    model: Model, combination: Combination, hierarchies: Sequence[MeshHierarchy], solver: str, on_step: OnStep
) -> CombinationResult | GroundslabError:
    """Return the results of a combination, or why it has none.

    hierarchies are the finest meshes, and two for the effect of the margin if that is judged; `solver` is the name in
    the results.
    """
    finest, *margins = hierarchies
    steps: list[Step] = []

    def report(step: Step) -> None:
        steps.append(step)
        on_step(step)

    factors = _case_factors(model, combination)
    try:
        (*earlier, solution), coarser = solve_nested(finest, combination.name, factors, report)
        found = (*earlier, solution)
        effect = margin_effect(margins, combination.name, factors, found) if margins and _is_infinite(model) else None
        if _cracks(model, combination):
            solution, coarser = solve_cracked_meshes(finest, solution, coarser, report)
        frame, before = finest.result_mesh(solution, 0), _with_load_shares(earlier)
        proof = worst([certificate(solution, effect), *(certificate(each, effect) for _, each in before)])
        increments = tuple(Increment(share, *expand(recover_fields(each, frame), frame)) for share, each in before)
        fields = recover_fields(solution, frame)
        comparison = None
        if coarser is not None:
            prolongation = finest.prolongation(coarser, solution, frame)
            comparison, fields = compare(model, solution, coarser, prolongation, fields)
        parts = expand(fields, frame)
        results = recover(model, combination, solution, parts, proof, tuple(steps), solver, increments, comparison)
        return results if results.certificate.holds else NotCertified(results)
    except (IllConditioned, NoEquilibrium, NotConverged, SingularMatrix) as error:
        # its traceback would keep meshes and factors alive
        return error.with_traceback(None)


def _cracks(model: Model, combination: Combination) -> bool:
    """Return whether the slab has cracked stiffness in a combination."""
    return model.cracking is not None and combination.limit_state in model.cracking.limit_states


def _is_infinite(model: Model) -> bool:
    """Return whether infinite ground beyond the plate is meshed and ends in tails."""
    return model.beyond.kind == "infinite" and model.ground_reaches and not isinstance(model.ground, ContinuousGround)


def _with_load_shares(earlier: Sequence[Solution]) -> list[tuple[float, Solution]]:
    """Return the solutions of all load increments but the last, each with its share of the load."""
    found = []
    for number, solution in enumerate(earlier, start=1):
        share, problem = number / (len(earlier) + 1), solution.system.problem
        own = replace(problem, loading=problem.loading.scale(share))
        found.append((share, replace(solution, system=replace(solution.system, problem=own))))
    return found


def _case_factors(model: Model, combination: Combination) -> Array:
    """Return the factor of each load case in a combination, (cases,)."""
    given = dict(combination.factors)
    return np.array([given.get(case.name, 0.0) for case in model.cases] or [1.0])
