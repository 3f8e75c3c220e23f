"""Equilibrium under one load on one mesh: gamma iterated outside, contact inside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from groundslab.analysis.load_step import LoadStep
from groundslab.analysis.pressure_iteration import solve_pressures
from groundslab.arrays import Array, Integers
from groundslab.errors import NotConverged
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Contact, plastic_slip
from groundslab.fem.foundation import Column
from groundslab.fem.problem import TOP, W
from groundslab.fem.system import current_bearings, nodal_table, right_hand_side
from groundslab.fem.vlasov import GAMMA_START, Soil
from groundslab.results.balance.forces import decay_squared
from groundslab.results.records import Step
from groundslab.solvers import contact, warm_start
from groundslab.solvers.contact import ContactProblem
from groundslab.solvers.equilibrium import require_hold
from groundslab.solvers.solution import Solution

#: gamma is iterated until one more step would change it by less than this share.
GAMMA_TOLERANCE = 1e-6
#: On the coarser meshes gamma need only be good enough to start the next mesh.
GAMMA_TOLERANCE_COARSE = 1e-3
#: Below this gamma, k0 and k1 hardly depend on it any more; its change is then taken relative to this value.
GAMMA_SMALL = 0.01
MAX_GAMMA_ITERATIONS = 60
#: A contact force this small against the largest nodal_table load is rounding: the plate does not touch the ground.
NO_CONTACT = 1e-9


class _ContactIteration:
    """Solves the contact of a load step for one column of ground after another, each started from the one before."""

    def __init__(self, step: LoadStep, start: Solution | None) -> None:
        problem = step.system.problem
        self.step = step
        self.law = current_bearings(problem, step.factor, step.slip)
        self.expected: Array | None = None  # U (n, F) interpolated from a coarser mesh
        self.near: Array | None = None  # u (size,) of another solution on this mesh
        self.coarser: Integers | None = None  # states of the solution on a coarser mesh
        state: Integers = np.where(
            problem.contact.bearing.field > TOP, OPEN, CLOSED
        )  # joints with play do not bear at first
        if start is not None and start.system.problem.mesh is problem.mesh:
            alike = start.system is step.system or problem.plate.stiffness is not None
            state, self.near = start.contact.state, start.contact.u if alike else None
        elif start is not None and len(problem.contact.bearing.law):
            located = step.level.locations_in(start.system.problem)
            state, self.expected = warm_start.from_coarser(start, problem, located)
            self.coarser = start.contact.state.astype(np.int8)
        # the start may have yielded at a limit that there is no longer
        self.state = np.where((state == YIELDING) & np.isinf(self.law.limit_force), CLOSED, state)

    def solve(self, column: Column, gamma: float | None) -> Contact:
        """Return the solution for a column of ground, which belongs to a gamma if it depends on one."""
        step, level = self.step, self.step.level

        def report(iteration: int, in_contact: int, changed: int) -> None:
            step.report(Step(step.system.pattern.size, 1, gamma, iteration, in_contact, changed, step.finest))

        problem = self._problem(column, gamma)
        if self.expected is not None and self.near is None:
            self.state, self.near = self._start_from_coarser(problem, self.expected)
        try:
            solution = contact.solve(problem, level.factorization, self.state, step.max_iterations, report, self.near)
        except NotConverged as error:
            last = error.last
            if step.finest and "force" in last:
                # which of many solutions it is may never be decided
                state = np.where(last["closed"], CLOSED, OPEN)
                require_hold(step.system.problem, Contact(last["u"], state, last["force"]))
            raise
        self.near, self.state = solution.u, solution.state
        # where digits are few, what is found leads nowhere without refinement
        return solution if problem.A.exact_products is None else self._refine(solution, problem)

    def _start_from_coarser(self, problem: ContactProblem, expected: Array) -> tuple[Integers, Array]:
        """Return states (c,) and unknowns (size,) to start from, by what was expected (n, F) from a coarser mesh.

        The states are those of a combination with nearly the same ones there, else those of a strip along their border.
        """
        level, near = self.step.level, warm_start.unknowns_in(self.step.system.problem, expected)
        alike = None if self.coarser is None else level.zone_like(self.coarser)
        if alike is not None:
            return alike, near
        state = warm_start.solve_contact_border(self.step.system.problem, problem, self.state, expected, level.solver)
        return state, near

    def _problem(self, column: Column, gamma: float | None) -> ContactProblem:
        """Return what is solved for a column of ground, which belongs to a gamma if it depends on one."""
        system, level = self.step.system, self.step.level
        A = level.stiffness(column, gamma)
        f = right_hand_side(system, self.step.factor)
        of_supports = system.problem.contact.bearing.support >= 0
        return ContactProblem(A, f, self.law, level.motions, system.problem.measures, of_supports)

    def _refine(self, ground_contact: Contact, problem: ContactProblem) -> Contact:
        """Return a solution just found without the rounding of its factorization."""
        return contact.refine(problem, self.step.level.factorization, ground_contact)

    def solution(self, ground_contact: Contact, column: Column, gamma: float | None) -> Solution:
        """Return the solution of the load step; on the finest mesh raises NeutralEquilibrium if nothing holds it."""
        step, problem = self.step, self.step.system.problem
        if step.finest:
            ground_contact = self._refine(ground_contact, self._problem(column, gamma))
            require_hold(problem, ground_contact)
        if self.coarser is not None:
            step.level.zones.append((self.coarser, ground_contact.state.astype(np.int8)))
        slip = step.slip + plastic_slip(self.law, ground_contact)
        return Solution(
            step.system, nodal_table(problem, ground_contact.u), ground_contact, column, gamma, self.law, slip
        )


def solve_load_step(step: LoadStep, start: Solution | None) -> Solution:
    """Return the solution of a load step, started from a solution on this mesh or on a coarser one."""
    if step.system.problem.elastic is not None:
        return solve_pressures(step, start)
    iteration, ground = _ContactIteration(step, start), step.system.problem.ground
    if isinstance(ground, Column):
        column, gamma = ground, None
    else:
        fixed_gamma = ground.gamma if step.gamma is None else step.gamma
        if fixed_gamma is None:
            return _iterate_gamma(iteration, ground, start)
        column, gamma = ground.column(fixed_gamma), fixed_gamma
    return iteration.solution(iteration.solve(column, gamma), column, gamma)


def _iterate_gamma(iteration: _ContactIteration, soil: Soil, start: Solution | None) -> Solution:
    """Return the solution whose gamma is the one that its own settlement gives by (2.23); see docs/theory.md."""
    step, problem = iteration.step, iteration.step.system.problem
    gamma, slope = GAMMA_START, 0.0
    if start is not None and start.gamma is not None:
        gamma, slope = start.gamma, start.gamma_slope
    tolerance = GAMMA_TOLERANCE if step.finest else GAMMA_TOLERANCE_COARSE
    history: list[tuple[float, float]] = []
    while len(history) < MAX_GAMMA_ITERATIONS:
        column = soil.column(gamma, by_table=start is not None or len(history) > 0)
        ground_contact = iteration.solve(column, gamma)
        U = nodal_table(problem, ground_contact.u)
        # a plate that its supports carry clear of the ground leaves nothing to find gamma from
        pushed = ground_contact.force[problem.contact.bearing.support < 0].max(initial=0.0)
        touches = (
            pushed > NO_CONTACT * np.abs(step.factor * problem.load[:, W]).max() or not problem.contact.tensionless
        )
        after = soil.gamma_of(decay_squared(step.system, U, column)) if touches else gamma
        history.append((gamma, after))
        change = abs(after - gamma) / max(after, GAMMA_SMALL)
        if change <= tolerance:
            solution = iteration.solution(ground_contact, column, gamma)
            slope = _slope(history, slope)
            return replace(solution, gamma_change=change, gamma_slope=slope, gamma_iterations=len(history))
        gamma = next_gamma(history, slope)
    raise NotConverged("gamma", [{"gamma": a, "next": b} for a, b in history], {"U": U, "gamma": gamma})


def next_gamma(history: list[tuple[float, float]], slope: float) -> float:
    """Return the gamma to try next, from pairs of a gamma and the one that (2.23) gives; slope serves for the first.

    A secant step, kept inside the gammas known to be too small and too large; every third step halves these bounds, so
    that a contact zone that jumps with gamma cannot make the iteration wander forever.
    """
    gamma, last = history[-1]
    slope = _slope(history, slope)
    # slopes near or above one would throw the secant far off; then one plain step is taken
    trial = gamma + (last - gamma) / (1 - slope) if slope < 0.98 else last
    trial = min(max(trial, gamma / 4), 4 * gamma)
    low = max((a for a, b in history if b > a), default=0.0)
    high = min((a for a, b in history if b < a), default=np.inf)
    if 0 < low < high < np.inf and (len(history) % 3 == 0 or not low < trial < high):
        return float(np.sqrt(low * high))
    return trial


def _slope(history: list[tuple[float, float]], default: float) -> float:
    """Return the change of the outcome over that of gamma between the last two steps."""
    if len(history) < 2 or history[-1][0] == history[-2][0]:
        return default
    (g0, f0), (g1, f1) = history[-2:]
    return (f1 - f0) / (g1 - g0)
