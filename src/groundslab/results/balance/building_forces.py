"""What the building above changes of the loads on its bases, from its stiffness and how they move."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, made_once_by
from groundslab.discretize.building import bases_of, motion_stiffness
from groundslab.fem.parts.building import FIELDS, Building
from groundslab.fem.system import System, stiffness
from groundslab.model.model import Model
from groundslab.results.records import BaseResult
from groundslab.solvers import factorization
from groundslab.solvers.contact import ContactProblem, constrain
from groundslab.solvers.solution import Solution


def base_results(model: Model, solution: Solution, solver: str | None = None) -> tuple[BaseResult, ...]:
    """Return how each base of the building moves, and what that changes of its load.

    A solver by its name also finds what fewer storeys would change.
    """
    above = solution.system.problem.building
    if above is None:
        return ()
    places = [base.place for base in bases_of(model)]
    moved, force = above.motions(solution.U), -above.forces(solution.U)
    # forces of unit motions are by length where these are slopes
    moved = moved / np.where(above.way == 0, 1.0, above.length)
    force = force * np.where(above.way == 0, 1.0, above.length)
    changes = np.zeros((len(force), 0)) if solver is None else _changes_by_storeys(model, solution, above, solver)
    bases = []
    for number, (name, place) in enumerate(zip(above.bases, places, strict=True)):
        unknowns = [np.flatnonzero((above.base == number) & (above.way == way)) for way in range(FIELDS)]
        w, slope_x, slope_y = (moved[at] if len(at) else np.zeros(1) for at in unknowns)
        P, M_x, M_y = (force[at] if len(at) else np.zeros(1) for at in unknowns)
        by_storeys = changes[unknowns[0]] if len(unknowns[0]) else np.zeros((1, changes.shape[1]))
        bases.append(BaseResult(name, np.array([place]), w, slope_x, slope_y, P, M_x, M_y, by_storeys))
    return tuple(bases)


def _changes_by_storeys(model: Model, solution: Solution, above: Building, solver: str) -> Array:
    """Return the changes of loads (k, s) [N] of the lowest 1, 2, .. s storeys alone, with the contact as it is.

    With K_j instead of K the bases move by q_j = (1 + T (K_j - K))^-1 q, where T is what unit forces on them do to
    them, the building included. On an elastic continuum, and of a building given as a matrix, nothing is known.
    """
    building = model.building
    assert building is not None
    if building.matrix or solution.pressed is not None:
        return np.zeros((len(above.base), 0))
    # that of one contact serves all combinations: the ground is nearly the same
    held = solution.contact.state.tobytes()
    flexibilities = _flexibilities(solution, above)
    if held not in flexibilities:
        flexibilities[held] = _flexibility(solution, above, solver)
    T, K, q = flexibilities[held], above.stiffness, above.motions(solution.U)
    changes = []
    for storeys in range(1, len(building.storeys) + 1):
        K_j = motion_stiffness(model, above, storeys)
        changes.append(-K_j @ np.linalg.solve(np.eye(len(K)) + T @ (K_j - K), q))
    return np.column_stack(changes)


@made_once_by(lambda solution, above: (solution.system.problem.mesh.nodes, above))
def _flexibilities(solution: Solution, above: Building) -> dict[bytes, Array]:  # noqa: ARG001
    """Return T by the states of bearings, as they are added, for the building on a mesh."""
    return {}


def _flexibility(solution: Solution, above: Building, solver: str) -> Array:
    """Return T (k, k) [m/N]: what unit forces on bases do to them where the contact stays as it is."""
    s: System = solution.system
    A = stiffness(s, solution.column)
    system, _ = constrain(ContactProblem(A, np.zeros(A.size), solution.law), solution.contact.state)
    factor = factorization.SOLVERS[solver](A.indptr, A.indices).factor(A.constrain(system.fixed, system.diagonal_shift))
    spread, unknown = above.spread.tocoo(), s.problem.unknown[:, :FIELDS].ravel()
    at, motion = unknown[spread.coords[0]], spread.coords[1]
    supported = at >= 0
    G = np.zeros((A.size, len(above.base)), order="F")
    np.add.at(G, (at[supported], motion[supported]), spread.data[supported])
    G[system.fixed] = 0.0
    flexibility: Array = G.T @ factor.solve(G)
    return flexibility
