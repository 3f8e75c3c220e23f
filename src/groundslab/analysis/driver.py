"""The strategy of solution: meshes from coarse to fine, load increments, gamma outside, contact inside."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

import numpy as np

from groundslab.analysis.mesh_hierarchy import Known, Ladder, Level
from groundslab.analysis.parallel import side_by_side
from groundslab.arrays import Array
from groundslab.discretize.discretize import discretise
from groundslab.discretize.ground import Factors
from groundslab.discretize.plan_layout import coarsest
from groundslab.errors import (
    GroundslabError,
    IllConditioned,
    NoEquilibrium,
    NotCertified,
    NotConverged,
    SingularMatrix,
)
from groundslab.fem.bearings import CLOSED, YIELDING, Contact, slipped
from groundslab.fem.foundation import Column
from groundslab.fem.problem import System, W, bearings, nodal, right_hand_side
from groundslab.model.combinations import combinations_of
from groundslab.model.consistency import plate_elements
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.certificate import certificate, decay_squared, worst
from groundslab.results.record import Step
from groundslab.results.recovery import increment, recover
from groundslab.results.results import Combined, Results
from groundslab.solvers import contact, factorization, warm_start
from groundslab.solvers.conditioning import require_digits
from groundslab.solvers.equilibrium import require_equilibrium, require_hold
from groundslab.solvers.solution import Solution

#: gamma is iterated until one more step would change it by less than this share.
GAMMA_TOLERANCE = 1e-6
#: A contact force this small against the largest nodal load is rounding: the ground is not touched.
NOTHING = 1e-9
#: On the coarser meshes gamma need only be good enough to start the next mesh.
GAMMA_TOLERANCE_COARSE = 1e-3
#: Below this gamma, k0 and k1 hardly depend on it any more; its change is then taken relative to this value.
GAMMA_SMALL = 0.01
GAMMA_LIMIT = 60
GAMMA_START = 1.0
#: From one of the nested meshes to the next the elements' size is halved so many times: the forecast is good enough.
STEP = 2
#: So many combinations are solved at the same time at most, each on its share of the threads.
LANES = 4
#: Only if each has no more unknowns than this: every one of them needs memory for a factor.
LARGE = 400_000

#: What is looked into before it is solved has a mesh of at most so many elements.
CHECKED = 20_000
#: Of more loads than this it is not asked there whether they are their own mirror image.
COMPARED = 10_000

OnStep = Callable[[Step], None]
OnCombination = Callable[[Combination], None]


def check(model: Model) -> None:
    """Validate a model: raise the errors that `solve` would raise before it solves anything.

    The arrays of a problem are made as for solving, but those of the loads, whose coordinates the model has checked
    already; of a mesh of more than CHECKED elements a coarser one is made.

    Parameters
    ----------
    model : Model
        The model.

    Raises
    ------
    InputError
        If the model describes no problem that can be solved.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.check(model)
    """
    if model.analysis.solver != "auto":
        factorization.choose(model.analysis.solver)
    coarser = max(0, math.ceil(math.log2(plate_elements(model.plate, model.mesh) / CHECKED) / 2))
    if len(model.loads) > COMPARED:
        model = model.model_copy(update={"mesh": model.mesh.replace(symmetry="off")})
    ground = discretise(model, coarser, loaded=False).ground
    if not isinstance(ground, Column):
        ground.column(ground.gamma or GAMMA_START)


def solve(model: Model, on_step: OnStep | None = None, on_combination: OnCombination | None = None) -> Combined:
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
    model: Model, on_step: OnStep | None = None, on_combination: OnCombination | None = None
) -> Combined:
    """Return the results of every combination of a model as `solve` does, a single one that is refused among them."""
    wanted = combinations_of(model)
    return _all(model, wanted, _each(model, wanted, on_step), on_combination)


class Variants:
    """Solves models that are like a base case, with its meshes, analyses of patterns and contact zones.

    Each is started from the base case's contact zone, not from that of the variant before, so that its results do not
    depend on which others were solved.
    """

    def __init__(self, base: Model) -> None:
        """Solve the base case, whose combinations may be refused; raises InputError as `solve` does."""
        self._known = Known()
        wanted = combinations_of(base)
        #: The results of the base case.
        self.base = _all(base, wanted, _each(base, wanted, None, self._known))
        self._known.close()

    def solve_combinations(
        self, model: Model, factors: Factors | None = None, on_step: OnStep | None = None
    ) -> Combined:
        """Return the results of every combination of a model, as the function of that name does.

        `factors` multiply constants of the ground from place to place, by their names in the file: a function of x and
        y (p,) [m] for "ground.k0", "ground.layers[1].E" and the like. No symmetry is used then. Raises InputError if
        the ground has no such constant.
        """
        if factors:
            model = model.replace(mesh=model.mesh.replace(symmetry="off"))
        wanted = combinations_of(model)
        return _all(model, wanted, _each(model, wanted, on_step, self._known, factors))


def _all(
    model: Model,
    wanted: Sequence[Combination],
    each: Iterator[Results | GroundslabError],
    on_combination: OnCombination | None = None,
) -> Combined:
    """Return the outcome of all combinations together."""
    results: dict[str, Results] = {}
    refused: dict[str, GroundslabError] = {}
    for combination in wanted:
        if on_combination is not None:
            on_combination(combination)
        found = next(each)
        if isinstance(found, GroundslabError):
            refused[combination.name] = found
        else:
            results[combination.name] = found
    return Combined(model, tuple(wanted), results, refused)


def _each(
    model: Model,
    wanted: Sequence[Combination],
    on_step: OnStep | None,
    known: Known | None = None,
    ground: Factors | None = None,
) -> Iterator[Results | GroundslabError]:
    """Yield for each combination its results, or why it has none; those with the same factors are solved once."""
    keys = [tuple(_factors(model, each).tolist()) for each in wanted]
    first: dict[tuple[float, ...], Combination] = {}
    for key, combination in zip(keys, wanted, strict=True):
        first.setdefault(key, combination)
    solved = _solve_each(model, list(first.values()), on_step, known, ground)
    found: dict[tuple[float, ...], Results | GroundslabError] = {}
    for key, combination in zip(keys, wanted, strict=True):
        if key not in found:
            found[key] = next(solved)
        yield _renamed(found[key], combination)


def _renamed(found: Results | GroundslabError, combination: Combination) -> Results | GroundslabError:
    """Return what came out of a combination with the same factors as that of this one."""
    if isinstance(found, NotCertified):
        return NotCertified(_renamed(found.results, combination))
    if not isinstance(found, Results) or found.combination == combination.name:
        return found
    name, limit_state = combination.name, combination.limit_state
    return replace(found, combination=name, limit_state=limit_state, factors=combination.factors)


def _solve_each(
    model: Model,
    wanted: Sequence[Combination],
    on_step: OnStep | None,
    known: Known | None,
    ground: Factors | None,
) -> Iterator[Results | GroundslabError]:
    """Yield for each combination its results, or why it has none; several are solved side by side."""
    name, solver = factorization.choose(model.analysis.solver)
    keep = len(wanted) > 1 or known is not None
    # the effect of the margin is judged on the next coarser mesh, where it costs little
    level = min(STEP, coarsest(model))
    finest = Ladder(model, solver, 0, 1.0, keep, ground, known)
    ladders = [finest, *(Ladder(model, solver, level, margin, keep, ground, known) for margin in (1.0, 2.0))]

    def told(step: Step) -> None:
        if on_step is not None:
            on_step(step)

    lanes = min(LANES, factorization.threads(solver), len(wanted))
    if lanes > 1 and finest.level(0).system.pattern.size > LARGE:
        lanes = 1
    if lanes < 2:
        yield from (_outcome(model, each, ladders, name, told) for each in wanted)
        return
    # what the lanes share is made before
    for ladder in ladders if _infinite(model) else [finest]:
        for coarsening in _meshes(ladder, wanted):
            ladder.level(coarsening)
    finest.level(0).frame(model)
    climbed = [ladders, *([each.beside() for each in ladders] for _ in range(lanes - 1))]
    # whichever lane is faster, each has the same tasks in the same order, and so the same factors to begin with
    tasks = [
        [partial(_outcome, model, each, climbed[lane], name) for each in wanted[lane::lanes]] for lane in range(lanes)
    ]
    threads = factorization.threads(solver) // lanes
    yield from side_by_side(tasks, told, lambda: factorization.use_threads(solver, threads))


def _outcome(
    model: Model, combination: Combination, ladders: Sequence[Ladder], solver: str, on_step: OnStep
) -> Results | GroundslabError:
    """Return the results of a combination, or why it has none; on the finest ladder, and two for the margin's effect.

    `solver` is the name that the results tell.
    """
    finest, *margins = ladders
    steps: list[Step] = []

    def report(step: Step) -> None:
        steps.append(step)
        on_step(step)

    factors = _factors(model, combination)
    try:
        *earlier, solution = _nested(finest, combination.name, factors, report)
        effect = _margin_effect(margins, combination.name, factors) if _infinite(model) else None
        frame, before = finest.frame(solution), _under_their_share(earlier)
        proof = worst([certificate(solution, effect), *(certificate(each, effect) for _, each in before)])
        increments = tuple(increment(model, each, frame, share) for share, each in before)
        results = recover(model, combination, solution, frame, proof, tuple(steps), solver, increments)
        return results if results.certificate.holds else NotCertified(results)
    except (IllConditioned, NoEquilibrium, NotConverged, SingularMatrix) as refusal:
        # what it was raised in holds meshes and factors, which nobody needs any more
        return refusal.with_traceback(None)


def _infinite(model: Model) -> bool:
    """Return whether infinite ground has an effect beyond the plate."""
    return model.beyond.kind == "infinite" and model.ground_reaches


def _under_their_share(earlier: Sequence[Solution]) -> list[tuple[float, Solution]]:
    """Return the solutions of all load increments but the last with the share of the load that each is for."""
    found = []
    for number, solution in enumerate(earlier, start=1):
        share, problem = number / (len(earlier) + 1), solution.system.problem
        own = replace(problem, loading=problem.loading.times(share))
        found.append((share, replace(solution, system=replace(solution.system, problem=own))))
    return found


def _factors(model: Model, combination: Combination) -> Array:
    """Return the factor of each load case in a combination, (cases,)."""
    given = dict(combination.factors)
    return np.array([given.get(case.name, 0.0) for case in model.cases] or [1.0])


def _nested(ladder: Ladder, combination: str, factors: Array, report: OnStep) -> list[Solution]:
    """Return the solution of each load increment on the ladder's finest mesh, reached from the coarsest one upwards.

    Or in one step from that of a model like this one, if that leads there.
    """
    model, before = ladder.model, list[Solution]()

    def loaded(level: Level) -> System:
        problem = level.system.problem.under(factors)
        require_equilibrium(problem)
        soil = problem.ground
        require_digits(level.system, soil if isinstance(soil, Column) else soil.column(soil.gamma or GAMMA_START))
        return replace(level.system, problem=problem)

    if ladder.knows(combination):
        level = ladder.level(ladder.finest)
        s = loaded(level)
        like = ladder.like(combination, s)
        if like:
            with suppress(NotConverged, SingularMatrix):
                return _increments(model, s, level, like, report, True)
    for coarsening in _coarsenings(max(_first(model), ladder.finest), ladder.finest):
        level = ladder.level(coarsening)
        if coarsening == ladder.finest:
            before = _increments(model, loaded(level), level, before, report, True)
        else:
            # what cannot be balanced on a few nodes, or is not solved there, only gives the next mesh no start
            start, before = before, []
            with suppress(NoEquilibrium, NotConverged, SingularMatrix):
                before = _increments(model, loaded(level), level, start, report, False)
    ladder.remember(combination, before)
    return before


def _meshes(ladder: Ladder, wanted: Sequence[Combination]) -> list[int]:
    """Return how often the mesh is coarsened for the meshes that the combinations will be solved on."""
    known = all(ladder.knows(each.name) for each in wanted)
    return _coarsenings(ladder.finest if known else max(_first(ladder.model), ladder.finest), ladder.finest)


def _coarsenings(first: int, last: int) -> list[int]:
    """Return how often the mesh is coarsened, from first to last: STEP halvings at a time, or less to begin with."""
    return sorted({*range(last, first + 1, STEP), first}, reverse=True)


def _first(model: Model) -> int:
    """Return how coarse the first mesh is: the finest where nothing is sought that a coarser one could tell."""
    one_sided = model.contact.tensionless or any(support.acts != "both ways" for support in model.supports)
    sought = getattr(model.ground, "gamma", None) == "iterate"
    return coarsest(model) if one_sided or sought else 0


def _increments(
    model: Model, s: System, level: Level, coarser: list[Solution], report: OnStep, finest: bool
) -> list[Solution]:
    """Return a solution for each load increment, each started from the same increment on the coarser mesh."""
    done: list[Solution] = []
    for number in range(1, model.analysis.increments + 1):
        start = coarser[number - 1] if coarser else (done[-1] if done else None)

        def told(step: Step, number: int = number) -> None:
            report(replace(step, increment=number))

        factor = number / model.analysis.increments
        slip = done[-1].slip if done else None
        done.append(_equilibrium(model, s, level, factor, start, told, finest, slip))
    return done


def _equilibrium(
    model: Model,
    s: System,
    level: Level,
    factor: float,
    start: Solution | None,
    report: OnStep,
    finest: bool,
    slip: Array | None,
) -> Solution:
    """Return the solution for one load on one mesh: gamma, where it is sought, outside; contact inside.

    slip (c,) is what the bearings have slipped before.
    """
    ground = s.problem.ground
    slip = np.zeros(len(s.problem.bearing.law)) if slip is None else slip
    law = bearings(s.problem, factor, slip)
    expected: Array | None = None  # from a coarser mesh
    near: Array | None = None  # from another solution on this one
    if start is None:
        state = np.full(len(s.problem.bearing.law), CLOSED)
    elif start.system.problem.mesh is s.problem.mesh:
        state, near = start.contact.state, start.contact.u if start.system is s else None
    else:
        if level.places is None:
            level.places = warm_start.places(start.system.problem, s.problem)
        state, expected = warm_start.from_coarser(start, s.problem, level.places)

    # what it was started from may have had a limit where there is none now
    state = np.where((state == YIELDING) & np.isinf(law.capacity), CLOSED, state)

    def solved(column: Column, gamma: float | None) -> tuple[Array, Contact]:
        def told(iteration: int, in_contact: int, changed: int) -> None:
            report(Step(s.pattern.size, 1, gamma, iteration, in_contact, changed, finest))

        nonlocal near, state
        A = level.stiffness(column, gamma)
        f = right_hand_side(s, factor)
        if expected is not None and near is None:
            state = warm_start.along_the_border(s, A, f, law, state, expected, level.solver)
        c = contact.solve(A, f, level.latest, law, state, model.analysis.max_iterations, told, near, level.motions)
        near = c.u
        return nodal(s.problem, c.u), c

    def ended(
        U: Array, c: Contact, column: Column, gamma: float | None, change: float, slope: float, iterations: int
    ) -> Solution:
        if finest:
            require_hold(s.problem, c)
        return Solution(s, U, c, column, gamma, change, slope, iterations, law, slip + slipped(law, c))

    if isinstance(ground, Column):
        U, c = solved(ground, None)
        return ended(U, c, ground, None, 0.0, 0.0, 0)
    if ground.gamma is not None:
        column = ground.column(ground.gamma)
        U, c = solved(column, ground.gamma)
        return ended(U, c, column, ground.gamma, 0.0, 0.0, 0)

    gamma, slope = GAMMA_START, 0.0
    if start is not None and start.gamma is not None:
        gamma, slope = start.gamma, start.gamma_slope
    tolerance = GAMMA_TOLERANCE if finest else GAMMA_TOLERANCE_COARSE
    history: list[tuple[float, float]] = []
    while len(history) < GAMMA_LIMIT:
        column = ground.column(gamma)
        U, c = solved(column, gamma)
        state = c.state
        # a plate that its supports carry over the ground leaves nothing to find gamma from
        pushed = c.force[s.problem.bearing.support < 0].max(initial=0.0)
        touches = pushed > NOTHING * np.abs(factor * s.problem.load).max() or not s.problem.tensionless
        found = ground.gamma_of(decay_squared(s, U, column)) if touches else gamma
        history.append((gamma, found))
        change = abs(found - gamma) / max(found, GAMMA_SMALL)
        if change <= tolerance:
            return ended(U, c, column, gamma, change, _slope(history, slope), len(history))
        gamma = next_gamma(history, slope)
    raise NotConverged("gamma", [{"gamma": a, "next": b} for a, b in history], {"U": U, "gamma": gamma})


def next_gamma(history: list[tuple[float, float]], slope: float) -> float:
    """Return the gamma to try next, from pairs of a gamma and what (2.23) made of it; slope serves for the first.

    A secant step, kept inside the gammas known to be too small and too large; every third step halves these bounds, so
    that a contact zone that jumps with gamma cannot make it wander for ever.
    """
    gamma, found = history[-1]
    slope = _slope(history, slope)
    # slopes near or above one would throw the secant far off; then one plain step is taken
    trial = gamma + (found - gamma) / (1 - slope) if slope < 0.98 else found
    trial = min(max(trial, gamma / 4), 4 * gamma)
    low = max((a for a, b in history if b > a), default=0.0)
    high = min((a for a, b in history if b < a), default=np.inf)
    if 0 < low < high < np.inf and (len(history) % 3 == 0 or not low < trial < high):
        return float(np.sqrt(low * high))
    return trial


def _slope(history: list[tuple[float, float]], otherwise: float) -> float:
    """Return by how much the outcome changed with gamma between the last two steps."""
    if len(history) < 2 or history[-1][0] == history[-2][0]:
        return otherwise
    (g0, f0), (g1, f1) = history[-2:]
    return (f1 - f0) / (g1 - g0)


def _margin_effect(margins: Sequence[Ladder], combination: str, factors: Array) -> float:
    """Return by how much a wider margin of infinite ground changes the settlement anywhere, over the largest one.

    Both meshes are the same on the plate, where their nodes have the same numbers.
    """
    unheard = list[Step]()
    narrow, wide = (_nested(ladder, combination, factors, unheard.append)[-1] for ladder in margins)
    under = narrow.system.problem.plate_nodes
    before, after = narrow.U[under, W], wide.U[under, W]
    largest = max(np.abs(before).max(), np.abs(after).max())
    return float(np.abs(after - before).max() / largest) if largest else 0.0
