"""Equilibrium under one load on an elastic continuum: forces of cells and supports, by the plate's factor alone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from groundslab.analysis.extrapolation import Extrapolation
from groundslab.analysis.load_step import LoadStep
from groundslab.analysis.mesh_hierarchy import Level
from groundslab.arrays import Array, Integers
from groundslab.errors import IllConditioned, NotConverged
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING, Bearings, Contact, plastic_slip
from groundslab.fem.continuum.cells import prolong
from groundslab.fem.foundation import single
from groundslab.fem.problem import TOP, Problem, settlement_by_loads_beside
from groundslab.fem.system import System, current_bearings, nodal_table, right_hand_side
from groundslab.results.records import Step
from groundslab.solvers import bounded_forces
from groundslab.solvers.bounded_forces import BoundedSolution
from groundslab.solvers.coarser_plate import make_coarser_plate
from groundslab.solvers.equilibrium import require_hold
from groundslab.solvers.plate_on_continuum import PlateOnContinuum, bound_forces, make_plate_on_continuum, move
from groundslab.solvers.solution import Pressed, Solution

#: Gaps are wrong by at most this share of the displacements.
TOLERANCE = 1e-7
#: On the coarser meshes they need only be good enough to start the next one, and to compare with.
TOLERANCE_COARSE = 1e-6
#: Products with the operator for each contact step that an analysis may take, and on coarser meshes at all.
PRODUCTS, PRODUCTS_COARSE = 10, 300
#: A plate of an elastic length of fewer cells, about that of an element, bends too differently on a coarser mesh.
THIN = 2.0
#: A plate that may lift off has an elastic length of at least this share of a cell.
SHORTEST = 0.3


def solve_pressures(step: LoadStep, start: Solution | None) -> Solution:
    """Return the solution of a load step, started from a solution on this mesh or on a coarser one."""
    s, problem = step.system, step.system.problem
    law, f = current_bearings(problem, step.factor, step.slip), right_hand_side(s, step.factor)
    operator = _operator(step.level, s)
    if step.finest and problem.contact.tensionless:
        _require_resolution(operator)

    def report(iteration: int, bearing: int, changed: int) -> None:
        step.report(Step(s.pattern.size, 1, None, iteration, bearing, changed, step.finest))

    pressures = _iterate(step, operator, law, f, _start(problem, start), report)
    u = move(operator, f, pressures)
    c = len(problem.elastic.gap) if problem.elastic else 0
    contact = Contact(u, _states(law, pressures.x[c:]), pressures.x[c:])
    pressed = Pressed(pressures.x[:c], pressures.y[:c])
    U, slip = _table(step, contact, pressed), step.slip + plastic_slip(law, contact)
    solution = Solution(s, U, contact, single(0.0, 0.0), None, law, slip, pressed=pressed)
    if step.finest:
        require_hold(problem, contact, pressed.force)
    return solution


def _iterate(
    step: LoadStep, p: PlateOnContinuum, law: Bearings, f: Array, x: Array, report: Callable[[int, int, int], None]
) -> BoundedSolution:
    """Return the forces (c + b,), started from x, under loads f (size,).

    What ground that varies over the plan or was loaded before settles beyond a symmetric linear operator is a gap that
    is iterated, extrapolated from the steps before.
    """
    ground, c = p.ground, len(p.ground.gap)
    tolerance = TOLERANCE if step.finest else TOLERANCE_COARSE
    limit = PRODUCTS * step.max_iterations if step.finest else PRODUCTS_COARSE
    beside = step.factor * settlement_by_loads_beside(step.system.problem, ground.cells.center)
    history = list[dict[str, float]]()
    further, bend = np.zeros(c), _bending_of_coarser(step)
    if not ground.linear:
        further = ground.settle(x[:c]) - ground.settle_mutually(x[:c])
    extrapolation = Extrapolation()
    while True:
        problem = bound_forces(p, step.system.problem, law, f, further + beside, bend)
        forces = bounded_forces.solve(problem, x, tolerance, limit, report)
        if ground.linear:
            return forces
        x, settled = forces.x, ground.settle(forces.x[:c])
        after = settled - ground.settle_mutually(x[:c])
        change = float(np.abs(after - further).max() / np.abs(settled).max(initial=1e-300))
        history.append({"iteration": len(history) + 1, "change": change})
        if change <= tolerance:
            return forces
        if len(history) >= step.max_iterations:
            raise NotConverged("the settlement of the ground", history, {"x": x})
        further = extrapolation.next(further, after)


def _bending_of_coarser(step: LoadStep) -> Callable[[Array], Array] | None:
    """Return how the plate of a coarser mesh bends, which takes less than that of the step's."""
    level, coarser = step.level, step.coarser
    fine = _operator(level, step.system)
    grid = fine.ground.cells.grid
    if coarser is None or fine.elastic_length < THIN * max(grid.dx, grid.dy):
        return None
    if level.coarser_plate is None:
        plate = _operator(coarser, coarser.system)
        level.coarser_plate = make_coarser_plate(plate, coarser.system.problem, step.system.problem)
    return level.coarser_plate.bend


def _require_resolution(p: PlateOnContinuum) -> None:
    """Raise IllConditioned if the plate is so thin that it bends within a cell."""
    cell = max(p.ground.cells.grid.dx, p.ground.cells.grid.dy)
    if p.elastic_length < SHORTEST * cell:
        raise IllConditioned(
            f"the plate's elastic length on this ground, {p.elastic_length:.3g} m, is too short for cells of pressure "
            f"of {cell:.3g} m where it may lift off; make them smaller (mesh.size, ground.cell), or glue the plate to "
            "the ground with contact.tensionless = false"
        )


def _operator(level: Level, s: System) -> PlateOnContinuum:
    """Return the plate of a level on its continuum, factorized if it is not yet."""
    A = level.stiffness(single(0.0, 0.0), None)
    operator = level.on_continuum
    if operator is None or operator.A is not A:
        operator = level.on_continuum = make_plate_on_continuum(s, A, level.factorization)
    return operator


def _states(law: Bearings, force: Array) -> Integers:
    """Return the states (b,) of supports that carry some forces (b,)."""
    state = np.where(law.bilateral | (force > 0), CLOSED, OPEN)
    return np.where(~law.bilateral & (force >= law.limit_force) & (force > 0), YIELDING, state)


def _start(problem: Problem, start: Solution | None) -> Array:
    """Return the forces (c + b,) from which the iteration starts."""
    assert problem.elastic is not None
    cells, supports = problem.elastic.cells, len(problem.contact.bearing.law)
    if start is None or start.pressed is None:
        return np.concatenate([cells.area, np.zeros(supports)])
    start_problem = start.system.problem
    assert start_problem.elastic is not None
    if start_problem.mesh is problem.mesh and len(start_problem.elastic.gap) == len(cells.area):
        return np.concatenate([start.pressed.force, start.contact.force])
    on_supports = np.zeros(supports)
    for number in np.unique(problem.contact.bearing.support):
        on_ground, before = problem.contact.bearing.support == number, start_problem.contact.bearing.support == number
        # a line hands its force to more nodes
        on_supports[on_ground] = start.contact.force[before].sum() / on_ground.sum()
    # below zero over open gaps, so that pressures on the finer cells end where the contact does
    tension = np.maximum(start.pressed.gap, 0.0) / start_problem.elastic.flexibility.own
    return np.concatenate([prolong(start_problem.elastic.cells, start.pressed.force - tension, cells), on_supports])


def _table(step: LoadStep, contact: Contact, pressed: Pressed) -> Array:
    """Return unknowns as a table (n, F), and with them the settlement of the ground's surface at every node."""
    problem, elastic = step.system.problem, step.system.problem.elastic
    assert elastic is not None
    U = nodal_table(problem, contact.u)
    under = problem.plate.nodes
    U[under, TOP] = (elastic.cells.around @ pressed.gap - problem.contact.initial_gap)[under]
    beyond = np.setdiff1d(np.arange(len(U)), under)
    if len(beyond):
        places = problem.mesh.nodes[beyond]
        U[beyond, TOP] = elastic.settle_at(pressed.force, places)
        U[beyond, TOP] += step.factor * settlement_by_loads_beside(problem, places)
        if elastic.piles is not None:
            U[beyond, TOP] += elastic.piles.settle_at(contact.force[elastic.piles.bearing], places)
    return U
