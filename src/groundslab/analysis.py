"""The strategy of solution: meshes from coarse to fine, load increments, gamma outside, contact inside."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from groundslab import contact, linear
from groundslab.checks import certificate, decay_squared
from groundslab.contact import Contact
from groundslab.discretise import discretise
from groundslab.errors import NotCertified, NotConverged
from groundslab.ground import Column
from groundslab.layout import coarsest
from groundslab.linear import Solver, Symbolic
from groundslab.mesh import Mesh, values_between
from groundslab.model import Model
from groundslab.problem import Problem, System, nodal, right_hand_side, stiffness, system
from groundslab.recover import recover
from groundslab.results import Results, Step
from groundslab.shape import Array, Flags
from groundslab.solution import Solution
from groundslab.statics import require_equilibrium

#: gamma is iterated until one more step would change it by less than this share.
GAMMA_TOLERANCE = 1e-6
#: On the coarser meshes gamma need only be good enough to start the next mesh.
GAMMA_TOLERANCE_COARSE = 1e-3
#: Below this gamma, k0 and k1 hardly depend on it any more; its change is then taken relative to this value.
GAMMA_SMALL = 0.01
GAMMA_LIMIT = 60
GAMMA_START = 1.0
#: A node starts closed where the coarser mesh's contact (-1 closed, 1 open, linear between) is below this: the value
#: for which the zone then changes least; it costs a step or two if it is off, never the result.
CLOSED_AT = -0.25

OnStep = Callable[[Step], None]


def solve(model: Model, on_step: OnStep | None = None) -> Results:
    """Return the certified results of a model.

    on_step is told every step of the iteration as it ends. Raises InputError for a description without a problem in it,
    NoEquilibrium if the loads cannot be balanced, NotConverged with history and last iterate, SingularMatrix, and
    NotCertified, which holds the results, if they do not fulfil the equations.
    """
    name, solver = linear.choose(model.analysis.solver)
    steps: list[Step] = []

    def report(step: Step) -> None:
        steps.append(step)
        if on_step is not None:
            on_step(step)

    solution = _nested(model, solver, report, finest=0, margin=1.0)
    effect = _margin_effect(model, solver) if model.beyond.kind == "infinite" else None
    results = recover(model, solution, certificate(solution, effect), tuple(steps), name)
    if not results.certificate.holds:
        raise NotCertified(results)
    return results


def _nested(model: Model, solver: Solver, report: OnStep, finest: int, margin: float) -> Solution:
    """Return the solution on the mesh coarsened `finest` times, reached from the coarsest mesh upwards."""
    before: list[Solution] = []
    for coarsening in range(max(coarsest(model), finest), finest - 1, -1):
        problem = discretise(model, coarsening, margin)
        require_equilibrium(problem)
        before = _increments(model, system(problem), solver, before, report, coarsening == finest)
    return before[-1]


def _increments(
    model: Model, s: System, solver: Solver, coarser: list[Solution], report: OnStep, finest: bool
) -> list[Solution]:
    """Return a solution for each load increment, each started from the same increment on the coarser mesh."""
    symbolic = solver(s.pattern.indptr, s.pattern.indices)
    done: list[Solution] = []
    for number in range(1, model.analysis.increments + 1):
        start = coarser[number - 1] if coarser else (done[-1] if done else None)

        def told(step: Step, number: int = number) -> None:
            report(replace(step, increment=number))

        factor = number / model.analysis.increments
        done.append(_equilibrium(model, s, symbolic, factor, start, told, finest))
    return done


def _equilibrium(
    model: Model, s: System, symbolic: Symbolic, factor: float, start: Solution | None, report: OnStep, finest: bool
) -> Solution:
    """Return the solution for one load on one mesh: gamma, where it is sought, outside; contact inside."""
    ground, closed = s.problem.ground, _zone(start, s.problem)

    def solved(column: Column, gamma: float | None) -> tuple[Array, Contact]:
        def told(iteration: int, in_contact: int, changed: int) -> None:
            report(Step(s.pattern.size, 1, gamma, iteration, in_contact, changed, finest))

        data = stiffness(s, column)
        f = right_hand_side(s, data, factor)
        c = contact.solve(s.pattern, data, f, symbolic, s.problem.gaps, closed, model.analysis.max_iterations, told)
        return nodal(s.problem, c.u), c

    if isinstance(ground, Column):
        U, c = solved(ground, None)
        return Solution(s, U, c, ground, None, 0.0, 0.0, 0)
    if ground.gamma is not None:
        column = ground.column(ground.gamma)
        U, c = solved(column, ground.gamma)
        return Solution(s, U, c, column, ground.gamma, 0.0, 0.0, 0)

    gamma, slope = GAMMA_START, 0.0
    if start is not None and start.gamma is not None:
        gamma, slope = start.gamma, start.gamma_slope
    tolerance = GAMMA_TOLERANCE if finest else GAMMA_TOLERANCE_COARSE
    history: list[tuple[float, float]] = []
    while len(history) < GAMMA_LIMIT:
        column = ground.column(gamma)
        U, c = solved(column, gamma)
        closed = c.closed
        # a plate that its supports carry over the ground leaves nothing to find gamma from
        touches = c.closed.any() or not s.problem.tensionless
        found = ground.gamma_of(decay_squared(s, U, column)) if touches else gamma
        history.append((gamma, found))
        change = abs(found - gamma) / max(found, GAMMA_SMALL)
        if change <= tolerance:
            return Solution(s, U, c, column, gamma, change, _slope(history, slope), len(history))
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
    trial = gamma + (found - gamma) / (1 - slope) if slope < 0.8 else found
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


def _zone(start: Solution | None, problem: Problem) -> Flags:
    """Return which gaps to close at first: all, or those closed in a solution on the same or a coarser mesh."""
    nodes = problem.plate_nodes
    if not problem.tensionless:
        return np.zeros(0, dtype=bool)
    if start is None:
        return np.ones(len(nodes), dtype=bool)
    coarse: Mesh = start.system.problem.mesh
    if coarse is problem.mesh:
        return start.contact.closed
    zone: Flags = values_between(coarse, start.closed, problem.mesh.nodes[nodes]) <= CLOSED_AT
    return zone


def _margin_effect(model: Model, solver: Solver) -> float:
    """Return by how much doubling the meshed margin of infinite ground changes the largest settlement, relatively.

    Judged on the next coarser mesh, where it costs little.
    """
    level = min(1, coarsest(model))
    largest, unheard = [], list[Step]()
    for margin in (1.0, 2.0):
        solution = _nested(model, solver, unheard.append, level, margin)
        largest.append(np.abs(solution.U[:, 0]).max())
    return float(abs(largest[1] - largest[0]) / max(largest)) if any(largest) else 0.0
