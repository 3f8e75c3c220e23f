"""Discretization error in energy: recovered fields against those of the elements (Zienkiewicz and Zhu 1992).

Recovered moments, shear forces and slopes of the ground are one order more accurate than those of the elements, so that
their difference is nearly the error. Its energy is summed element by element; what is smooth in parts is recovered part
by part.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import SIDES
from groundslab.fem.problem import Problem, W
from groundslab.fem.shape_functions import areas, determinants, gauss, gradients, inverse_jacobian, q9, q9_values
from groundslab.fem.system import surface_settlement
from groundslab.model.model import Model
from groundslab.results.balance.beam_forces import squared_errors
from groundslab.results.balance.forces import pressing_forces, resistance
from groundslab.results.mirroring import ResultMesh
from groundslab.results.patch_recovery import extrapolation
from groundslab.results.recovery import MeshedFields, own_forces, own_membrane
from groundslab.solvers.solution import Solution


def energy(solution: Solution) -> float:
    """Return twice the strain energy of plate, joints and ground under a solution [N m], which is never negative.

    It is the square of a norm. On an elastic continuum that is the energy of the forces that press it alone: those of
    loads beside the plate have a work on them, which is negative where they lift the plate.
    """
    U, problem, resisting = solution.U, solution.system.problem, resistance(solution)
    work = float((resisting.all * U).sum())
    elastic, pressed = problem.elastic, solution.pressed
    if elastic is None or pressed is None:
        return max(work, 0.0)
    force, settled = pressed.force, elastic.settle(pressed.force)
    stored = float(force @ settled) + work - float(pressing_forces(solution)[:, 0] @ U[:, W])
    if elastic.piles is not None:
        load = solution.contact.force[elastic.piles.bearing]
        stored += float(load @ elastic.piles.settle(load, force) + force @ (load @ elastic.piles.on_cells))
    return max(stored, 0.0)


def energy_errors(model: Model, solution: Solution, fields: MeshedFields) -> Array:
    """Return the squared errors of elements of plate and ground in the energy norm, (m, 3) [N m].

    They are those of moments and membrane forces, of shear forces, and of slopes of the ground, against recovered
    fields. Those of a beam belong to the elements along it.
    """
    of_ground = _ground_errors(solution)
    errors = np.zeros((len(of_ground), 3))
    errors[solution.system.problem.plate.elements, :2] = _plate_errors(solution, fields.forces)
    if fields.membrane is not None:
        errors[solution.system.problem.plate.elements, 0] += _membrane_errors(solution, fields.membrane)
    errors[:, 2] = of_ground
    if model.members:
        errors[:, :2] += _beam_errors(model, solution)
    # squares but for rounding
    return np.maximum(errors, 0.0)


def _beam_errors(model: Model, solution: Solution) -> Array:
    """Return the squared errors of moments and axial forces, and of shear forces, of beams, (m, 2) [N m].

    They belong to the elements along the beams.
    """
    problem = solution.system.problem
    elements, sides = problem.mesh.elements, problem.beams.sides
    M, T, V, N = squared_errors(model, solution).T
    number = np.full(len(problem.mesh.nodes), -1)
    alone = problem.beams.spans
    number[sides[~alone, 2]] = np.flatnonzero(~alone)
    element, side = np.nonzero(number[elements[:, SIDES[:, 2]]] >= 0)
    piece = number[elements[element, SIDES[side, 2]]]
    share = 1 / np.bincount(piece, minlength=len(sides))[piece]
    return np.column_stack([scatter(element, share * squared[piece], len(elements)) for squared in (M + T + N, V)])


def error_density(solution: Solution, frame: ResultMesh, squared: Array, total: float) -> Array:
    """Return rho_e = sqrt((eta_e^2 / E) / (A_e / A)) of each element of the plate, (mp,) [1].

    squared (m,) are the squared errors eta_e^2 of each element of plate and ground, total is the energy E of the
    solution with its error, A_e an element's area, A that of the plate. The mean of rho_e^2 over the area is the part
    of the plate in the squared relative error. Of a half or a quarter that was meshed rho_e is that of the whole plate.
    """
    A = areas(frame.mesh.xy)
    if not total > 0:
        return np.zeros(len(A))
    density: Array = np.sqrt(squared[solution.system.problem.plate.elements] / total * (A.sum() / A))
    return density


def _plate_errors(solution: Solution, recovered: Array) -> Array:
    """Return int (M* - M) . D^-1 (M* - M) and int |Q* - Q|^2 / S of each plate element, (mp, 2)."""
    problem, (points, weights) = solution.system.problem, gauss(3)
    N, dN = q9(points)
    rigidity = problem.plate.rigidity
    compliance, S = np.linalg.inv(problem.plate.bending)[rigidity], problem.plate.shear[rigidity]
    error = N @ recovered - own_forces(problem, solution.U, points)
    moments, shear = error[..., :3], error[..., 3:]
    dA = determinants(dN, problem.mesh.nodes[problem.mesh.elements[problem.plate.elements]]) * weights
    of_moments, of_shear = ((moments @ compliance) * moments).sum(axis=2), (shear**2).sum(axis=2) / S[:, None]
    return np.column_stack([(dA * squared).sum(axis=1) for squared in (of_moments, of_shear)])


def _membrane_errors(solution: Solution, recovered: Array) -> Array:
    """Return int (n* - n) . C^-1 (n* - n) of each plate element (mp,), n* recovered at nodes (mp, 9, 3)."""
    problem, (points, weights) = solution.system.problem, gauss(3)
    N, dN = q9(points)
    sheet = problem.plate
    compliance = np.linalg.inv(sheet.membrane)[sheet.section]
    error = N @ recovered - own_membrane(problem, solution.U, points)
    dA = determinants(dN, problem.mesh.nodes[problem.mesh.elements[sheet.elements]]) * weights
    squared: Array = (dA * ((error @ compliance) * error).sum(axis=2)).sum(axis=1)
    return squared


def _ground_errors(solution: Solution) -> Array:
    """Return int grad(w* - w) . A1 grad(w* - w) of each element, summed over surfaces, (m,).

    Slopes are recovered as means of the elements that meet, on the plate and beyond its edge apart: there they jump.
    """
    s, column = solution.system, solution.column
    problem, mesh = s.problem, s.problem.mesh
    m = len(mesh.elements)
    if not column.A1.any():
        return np.zeros(m)
    w = surface_settlement(s, solution.U)
    parts, n = _parts(problem)
    (at_two, _), (at_three, weights) = gauss(2), gauss(3)
    w_elements = w[:, mesh.elements]
    w_elements = (
        w_elements - w_elements[..., 8:]
    )  # else rounding makes slopes of a settlement that is everywhere the same
    S = len(w)
    inner, outer = (_slopes(points, mesh.xy, w_elements) for points in (at_two, at_three))
    at_nodes = np.einsum("na,eaxs->enxs", extrapolation(), inner)
    meeting = np.bincount(parts.ravel(), minlength=n)
    star = np.stack(
        [scatter(parts, at_nodes[:, :, x, k], n) / meeting for x in range(2) for k in range(S)], axis=-1
    ).reshape(n, 2, S)
    for axis in (0, 1):
        if problem.symmetry[axis]:
            # the slope beyond the line, of the other sign, makes the mean zero
            star[parts[mesh.xy[..., axis] == 0.0], axis] = 0.0
    error = np.einsum("pa,eaxs->epxs", q9_values(at_three), star[parts]) - outer
    dA = determinants(q9(at_three)[1], mesh.xy) * weights
    A1 = np.broadcast_to(column.A1, (m, S, S))
    squares: Array = np.einsum("ep,epxs,est,epxt->e", dA, error, A1, error, optimize=True)
    return squares


def _parts(problem: Problem) -> tuple[Integers, int]:
    """Return the elements of the ground with nodes of their own under the plate and beyond, and how many nodes."""
    under = np.zeros(len(problem.mesh.elements), dtype=np.int64)
    under[problem.plate.elements] = 1
    n = len(problem.mesh.nodes)
    keys, number = np.unique(problem.mesh.elements + n * under[:, None], return_inverse=True)
    return number.reshape(-1, 9), len(keys)


def _slopes(points: Array, xy: Array, w: Array) -> Array:
    """Return the slopes along x and y (m, p, 2, S) of surfaces (S, m, 9) at points (p, 2) of elements."""
    _, dN = q9(points)
    inverse, _ = inverse_jacobian(dN, xy)
    return np.stack([gradients(dN, inverse, settlement) for settlement in w], axis=-1)
