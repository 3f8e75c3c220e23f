"""A plate on an elastic continuum as a problem of forces: what they do to each other by the ground and by the plate.

Forces x of cells and of supports act on the plate, K u = f + C x, and against the gaps y = F x + C^T u + l: F is the
ground's flexibility, and 1 / k of each support. K has the plate's rigid motions R in its kernel, so that C^T R alpha is
added to the gaps and R^T (f + C x) = 0 is required (docs/theory.md, elastic continuum).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.bearings import Bearings, largest_of_parts
from groundslab.fem.continuum.elastic_ground import ElasticGround
from groundslab.fem.continuum.media import elastic_length
from groundslab.fem.continuum.preconditioner import Preconditioner, make_preconditioner
from groundslab.fem.problem import TOP, Problem, W, free_motions, move_plates
from groundslab.fem.shape_functions import areas
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.fem.system import System
from groundslab.solvers.bounded_forces import BoundedForces, BoundedSolution
from groundslab.solvers.factor_reuse import CachedFactorization, ConstrainedSystem

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@dataclass(frozen=True, slots=True)
class PlateOnContinuum:
    """The factorized plate, held at as few unknowns as it has rigid motions, and where forces act on it."""

    A: Symmetric
    ground: ElasticGround
    system: ConstrainedSystem
    factorization: CachedFactorization
    C: csr_array  # (size, c + b): of a force on each cell and each support
    R: Array  # (size, r): rigid motions
    preconditioner: Preconditioner
    elastic_length: float  # [m]: of plate and ground
    D: float  # [N m]: mean bending rigidity

    def solve(self, f: Array) -> Array:
        """Return the displacements (size,) under forces (size,) in equilibrium, up to rigid motions."""
        if not self.factorization.holds(self.system):
            self.factorization.factorize(self.system)
        u: Array = self.factorization.solve(np.where(self.system.fixed, 0.0, f))
        return np.where(self.system.fixed, 0.0, u)


def make_plate_on_continuum(s: System, A: Symmetric, factorization: CachedFactorization) -> PlateOnContinuum:
    """Return the plate of a system whose matrix (the plate's alone) is A."""
    from scipy.sparse import coo_array, csr_array, hstack

    problem = s.problem
    ground = problem.elastic
    assert ground is not None
    R = _rigid_motions(problem, A.size)
    fixed = np.zeros(A.size, dtype=bool)
    fixed[_holding(R, problem.unknown[:, W])] = True
    spread = ground.cells.spread.tocoo()
    unknown = problem.unknown[spread.coords[0], W]
    mask = unknown >= 0
    pressed = coo_array((-spread.data[mask], (unknown[mask], spread.coords[1][mask])), shape=(A.size, spread.shape[1]))
    law = problem.contact.bearing.law
    pushed = coo_array((law.sign, (law.unknown, np.arange(len(law)))), shape=(A.size, len(law)))
    sheet = problem.plate
    D = float(np.average(sheet.bending[sheet.rigidity, 0, 0], weights=areas(problem.mesh.xy[sheet.elements])))
    none = np.zeros(A.size)
    return PlateOnContinuum(
        A, ground, ConstrainedSystem(A, fixed, none, none), factorization, csr_array(hstack([pressed, pushed])), R,
        make_preconditioner(ground, D), elastic_length(ground.medium, D), D,
    )  # fmt: skip


def bound_forces(
    p: PlateOnContinuum,
    problem: Problem,
    law: Bearings,
    f: Array,
    further: Array,
    bend: Callable[[Array], Array] | None = None,
) -> BoundedForces:
    """Return the problem of the forces on a plate under loads f (size,), whose supports follow a law.

    further (c,) [m] is what cells settle beside what the forces do to them mutually; bend takes forces (c + b,) to
    about the settlements of the plate that they cause, for less than a substitution.
    """
    c, ground, settle = len(p.ground.gap), p.ground, _settling(p.ground, law)
    initial = np.concatenate([ground.gap + further, -law.sign * law.offset])
    C, Ct, G = p.C, p.C.T.tocsr(), (p.C.T @ p.R).T
    planes_of_gaps = np.linalg.qr(G.T)[0]
    part = None
    if len(problem.plate.names) > 1:
        part = np.concatenate([ground.cells.plate, problem.plate_at_nodes[problem.contact.bearing.node]])

    def gaps(x: Array) -> tuple[Array, Array]:
        settled, bent = settle(x), Ct @ p.solve(f + C @ x)
        shape = bent - planes_of_gaps @ (planes_of_gaps.T @ bent)
        with_further = np.concatenate([np.abs(settled[:c] + further), np.zeros(len(settled) - c)])
        sizes = np.maximum.reduce([np.abs(settled), with_further, np.abs(shape)])
        return settled + bent + initial, largest_of_parts(sizes, part)

    def multiply(x: Array) -> Array:
        bent: Array = Ct @ p.solve(C @ x)
        return settle(x) + bent

    def approximate(x: Array) -> Array:
        assert bend is not None
        return settle(x) + bend(x)

    # a support's own give, and that of a plate on springs under a force (Westergaard 1926)
    of_support = _give(law) + p.elastic_length**2 / (8 * p.D)
    if ground.piles is not None:
        of_support[ground.piles.bearing] += np.diag(ground.piles.own)

    def precondition(y: Array) -> Array:
        return np.concatenate([p.preconditioner.apply(y[:c]), y[c:] / of_support])

    weight = np.concatenate([ground.cells.area, np.full(len(law), ground.cells.area.mean())])
    flexibility = np.concatenate([np.full(c, ground.flexibility.own), of_support])
    return BoundedForces(
        gaps, multiply, precondition, G, -p.R.T @ f, *_bounds(ground, problem, law), weight, flexibility,
        None if bend is None else approximate,
    )  # fmt: skip


def _give(law: Bearings) -> Array:
    """Return how far supports give way under a unit force (b,)."""
    return np.where(np.isinf(law.stiffness), 0.0, 1 / law.stiffness)


def _settling(ground: ElasticGround, law: Bearings) -> Callable[[Array], Array]:
    """Return what takes forces (c + b,) to the settlements of cells and supports (c + b,) [m]."""
    c, give, piles = len(ground.gap), _give(law), ground.piles

    def settle(x: Array) -> Array:
        settled = np.concatenate([ground.settle_mutually(x[:c]), give * x[c:]])
        if piles is not None:
            load = x[c + piles.bearing]
            settled[:c] += load @ piles.on_cells
            settled[c + piles.bearing] = piles.settle(load, x[:c])
        return settled

    return settle


def _bounds(ground: ElasticGround, problem: Problem, law: Bearings) -> tuple[Array, Array]:
    """Return between which bounds the forces of cells and supports lie, (c + b,) each [N]."""
    c, piles = len(ground.gap), ground.piles
    glued = np.full(c, not problem.contact.tensionless)
    lower = np.where(np.concatenate([glued, law.bilateral]), -np.inf, 0.0)
    upper = np.concatenate([ground.limit_force, np.where(law.bilateral, np.inf, law.limit_force)])
    if piles is not None:
        lower[c + piles.bearing], upper[c + piles.bearing] = piles.lower, piles.upper
    return lower, upper


def move(p: PlateOnContinuum, f: Array, solution: BoundedSolution) -> Array:
    """Return the displacements (size,) of the plate under loads f (size,) and the forces of a solution."""
    u: Array = p.solve(f + p.C @ solution.x) + p.R @ solution.alpha
    return u


def _rigid_motions(problem: Problem, size: int) -> Array:
    """Return the rigid motions (size, r) of plates without their supports and the play of joints, which are forces.

    What a joint with play slips is an unknown without stiffness, and follows the plates, as walls and a building do.
    """
    links, none = problem.links, np.zeros(len(problem.contact.bearing.law), dtype=bool)
    slips = np.asarray(links.fields[:, TOP + 1 :].any(axis=1) & (links.joint >= 0))
    contact = replace(problem.contact, bearing=problem.contact.bearing.select(none))
    alone = replace(problem, contact=contact, links=links.select(~slips), elastic=None)
    moved, has = move_plates(problem, free_motions(alone)), problem.unknown >= 0
    R = np.zeros((size, moved.shape[2]))
    for number, motion in enumerate(np.moveaxis(moved, 2, 0)):
        U = np.pad(motion, ((0, 0), (0, problem.unknown.shape[1] - TOP)))
        R[problem.unknown[has], number] = problem.with_followers(U)[has]
    for (first, second), mask in zip(links.nodes[slips], links.fields[slips], strict=True):
        field = TOP + 1 + int(np.flatnonzero(mask[TOP + 1 :])[0])
        R[problem.unknown[second, field]] = moved[first, W] - moved[second, W]
    return R


def _holding(R: Array, settlements: Integers) -> Integers:
    """Return as many settlements among the unknowns as hold the rigid motions (size, r)."""
    from scipy.linalg import qr

    unknowns = settlements[settlements >= 0]
    order = qr(R[unknowns].T, pivoting=True, mode="r")[1]
    chosen: Integers = unknowns[order[: R.shape[1]]]
    return chosen
