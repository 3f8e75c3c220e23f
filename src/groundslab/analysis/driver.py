"""The public entry points of an analysis: solve the combinations of a model, solve variants of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from typing import Any

from groundslab.accuracy.judgment import judge_together
from groundslab.analysis.adaptivity import Analysis, solve_adaptively
from groundslab.analysis.load_step import OnStep
from groundslab.analysis.mesh_hierarchy import MeshHierarchy, ReferenceSolutions, uniform_mesh
from groundslab.analysis.moved_results import move_along, move_back
from groundslab.analysis.tasks.run import Report, Setting, run, solve_settlement
from groundslab.analysis.tasks.task import Outcome, Task, solve_task, task_of
from groundslab.analysis.wall_limits import with_limits
from groundslab.arrays import Array
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import Meshes
from groundslab.errors import GroundslabError, InputError, Issue, NotCertified
from groundslab.fem.mesh import Mesh
from groundslab.geometry.plan import Place
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.model.plan_origin import move_to_center
from groundslab.results.records import Step
from groundslab.results.results import CombinationResult, Results, why_no_start
from groundslab.schema.issues import require
from groundslab.solvers import factorization

#: Variants have the mesh of the base case, made for errors of this share of the accuracy, as theirs may be larger.
BASE_SHARE = 0.5
#: A preview has about so many elements.
PREVIEW_ELEMENTS = 100

OnCombination = Callable[[Combination], None]
OnMesh = Callable[[Results], None]


def solve(
    model: Model,
    on_step: OnStep | None = None,
    on_combination: OnCombination | None = None,
    on_mesh: OnMesh | None = None,
    start: Results | None = None,
) -> Results:
    """Solve every combination of a model, and return the certified results.

    Parameters
    ----------
    model : Model
        The model. Its combinations are those that it lists or that it has made by EN 1990; with neither, each load
        case by itself.
    on_step : callable, optional
        Called with every `Step` of the iteration as it ends.
    on_combination : callable, optional
        Called with every `Combination` as it begins.
    on_mesh : callable, optional
        Called with the `Results` on every mesh on which all combinations were solved, but the last.
    start : Results, optional
        Provisional results of the same model, as `on_mesh` is called with; the refinement goes on from their mesh.

    Returns
    -------
    Results
        The results of all combinations, by name. Of a model with several combinations, one whose foundation fails
        (`without_equilibrium`) or that has no certified result (`unsolved`) does not stop the others.

    Raises
    ------
    InputError
        If the model describes no problem that can be solved, or `start` is not of this model or not provisional.
    NoEquilibrium
        If the foundation fails: ground and supports cannot balance the only combination.
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
    """
    require(model, Model, name="model")
    results = solve_combinations(model, on_step, on_combination, on_mesh, start)
    if len(results.combinations) == 1:
        for refusal in results.refused.values():
            raise refusal
    return results


def solve_combinations(
    model: Model,
    on_step: OnStep | None = None,
    on_combination: OnCombination | None = None,
    on_mesh: OnMesh | None = None,
    start: Results | None = None,
) -> Results:
    """Solve every combination of a model as `solve` does, but keep a single one that is refused in `refused` too."""
    if start is not None and (refusal := why_no_start(start, model)):
        raise InputError([Issue("start", refusal, "provisional results of the same model")])
    local = move_to_center(model)
    solved_model = as_solved(local)

    setting = Setting(solved_model, Meshes())

    def begin(meshes: Meshes) -> tuple[Analysis, None]:
        nonlocal setting
        setting = Setting(solved_model, meshes, earlier=setting.solved())
        return _analysis(local, setting, _report(on_step, on_combination)), None

    def report_mesh(results: Results) -> None:
        if on_mesh is not None:
            on_mesh(move_back(results, model))

    def on_last_mesh(variant: Model) -> Results:
        return analyze(variant, Setting(as_solved(variant), setting.meshes), _report())

    begun = None if start is None else (move_along(start, local), None)
    results, _ = solve_adaptively(solved_model, begin, on_mesh=report_mesh, start=begun)
    if model.output.wall_limits:
        results = with_limits(results, local, on_last_mesh)
    return move_back(results, model)


def solve_preview(model: Model, name: str, on_step: OnStep | None = None) -> Results:
    """Solve one combination on a mesh of few elements, for a first look while all are solved.

    The slab does not crack, and the errors are those of that mesh. The name may be of no combination any more: then it
    is the one with the largest sum of factors. Without a name it is the first one.
    """
    coarse = model.model_copy(update={"mesh": uniform_mesh(model, PREVIEW_ELEMENTS), "cracking": None})
    local = move_to_center(coarse)
    solved_model = as_solved(local)
    combinations = {combination.name: combination for combination in list_combinations(solved_model)}
    first = next(iter(combinations.values()))
    combination = combinations.get(name) or (max(combinations.values(), key=_sum_factors) if name else first)
    task = task_of(solved_model, combination)
    solver_name, solver = factorization.choose(model.analysis.solver)
    hierarchy = MeshHierarchy(solved_model, solver, 0, 1.0, keep=False)
    outcome = solve_task(task, solved_model, combination, [hierarchy], solver_name, on_step or (lambda _: None))
    return move_back(_collect(local, {combination: task}, {task: outcome}), coarse)


def _sum_factors(combination: Combination) -> float:
    """Return the sum of a combination's factors, which is large where it governs."""
    return sum(factor for _, factor in combination.factors)


class Variants:
    """Solves models similar to a base case, reusing its meshes, analyses of patterns and contact zones.

    Each starts from the base case's contact zone, not from that of the variant before, so that its results do not
    depend on which others were solved.
    """

    def __init__(self, base: Model) -> None:
        """Solve the base case, whose combinations may fail; raises InputError as `solve` does."""
        local = move_to_center(base)
        solved_model = as_solved(local)

        def begin(meshes: Meshes) -> tuple[Analysis, ReferenceSolutions]:
            reference = ReferenceSolutions(meshes)
            return _analysis(local, Setting(solved_model, meshes, reference), _report()), reference

        results, self._reference = solve_adaptively(solved_model, begin, BASE_SHARE)
        #: The results of the base case, whose mesh all variants have.
        self.base = move_back(results, base)
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
        setting = Setting(as_solved(local), self._reference.meshes, self._reference, _about(local.origin, factors))
        return move_back(analyze(local, setting, _report(on_step)), model)

    def solve_settlement(self, model: Model, factors: Factors) -> tuple[Mesh, Array]:
        """Return the plate's mesh and its settlement (n,) [m] in the first combination of a model without symmetry.

        Nothing else is found, for trials of constants: the slab does not crack, and nothing is judged. `factors` are as
        in `solve_combinations`. Raises errors as `solve` does, but none of a certificate.
        """
        local = move_to_center(model)
        setting = Setting(as_solved(local), self._reference.meshes, self._reference, _about(local.origin, factors))
        mesh, settlement = solve_settlement(list_combinations(setting.model)[0], setting)
        return (mesh if local is model else Mesh(mesh.nodes + local.origin, mesh.elements)), settlement


def _analysis(model: Model, setting: Setting, report: Report) -> Analysis:
    """Return what solves the combinations of some names on the meshes of a setting."""

    def solve_named(names: Collection[str], draft: bool) -> Results:
        draft_setting = replace(setting, outcomes={}, draft=True) if draft else setting
        return analyze(model, draft_setting, report, names)

    return solve_named


def analyze(model: Model, setting: Setting, report: Report, names: Collection[str] | None = None) -> Results:
    """Return the results of the combinations that are named, by default of all, and of those known in the setting.

    Combinations with the same task are solved once.
    """
    tasks = {c: task_of(setting.model, c) for c in list_combinations(setting.model)}
    first: dict[Task, Combination] = {}
    for combination, task in tasks.items():
        if task not in setting.outcomes and (names is None or combination.name in names):
            first.setdefault(task, combination)
    setting.outcomes.update(run(first, setting, report))
    for combination, task in tasks.items():
        if task in first and combination is not first[task]:
            report(combination)
    return _collect(model, tasks, setting.outcomes)


def _collect(model: Model, tasks: Mapping[Combination, Task], outcomes: Mapping[Task, Outcome]) -> Results:
    """Return the outcomes of combinations together, with the case as written beside the case as solved."""
    results: dict[str, CombinationResult] = {}
    refused: dict[str, GroundslabError] = {}
    solved = tuple(combination for combination, task in tasks.items() if task in outcomes)
    for combination in solved:
        name = combination.name
        about = {"combination": name, "limit_state": combination.limit_state, "factors": combination.factors}
        outcome = _with(outcomes[tasks[combination]], model=model, **about)
        if isinstance(outcome, GroundslabError):
            refused[name] = outcome
        else:
            results[name] = outcome
    return Results(model, solved, judge_together(results), refused)


def _with(outcome: Outcome, **changes: Any) -> Outcome:
    """Return an outcome in which some fields of its results are others; one without results as it is."""
    if isinstance(outcome, NotCertified):
        return NotCertified(replace(outcome.results, **changes))
    return replace(outcome, **changes) if isinstance(outcome, CombinationResult) else outcome


def _about(origin: Place, factors: Factors | None) -> Factors | None:
    """Return factors on the ground's constants as functions of places about an origin [m]."""
    x_0, y_0 = origin

    def moved(factor: Callable[[Array, Array], Array]) -> Callable[[Array, Array], Array]:
        return lambda x, y: factor(x + x_0, y + y_0)

    return None if factors is None else {name: moved(factor) for name, factor in factors.items()}


def _report(on_step: OnStep | None = None, on_combination: OnCombination | None = None) -> Report:
    """Return what takes combinations that begin and their steps to those who want to know."""

    def report(item: Combination | Step) -> None:
        if isinstance(item, Step):
            if on_step is not None:
                on_step(item)
        elif on_combination is not None:
            on_combination(item)

    return report
