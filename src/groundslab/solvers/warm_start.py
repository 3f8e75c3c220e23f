"""Warm start from the solution on a coarser mesh: unknowns and states of the bearings.

The border of the contact zone is found on a strip along it, with the coarser solution fixed around it. That costs
little and leaves next to nothing to change on the full mesh.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NotConverged, SingularMatrix
from groundslab.fem.bearings import CLOSED, OPEN, YIELDING
from groundslab.fem.mesh import MeshLocations, interpolate, interpolate_bilinear, locate_nearest
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, Problem, W
from groundslab.fem.system import on_plate_edge, plate_settlement, surface_settlement
from groundslab.solvers import contact
from groundslab.solvers.contact import ContactProblem
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.factor_reuse import CachedFactorization
from groundslab.solvers.solution import Solution

#: A node starts closed where the coarser mesh's contact (-1 closed, 1 open, linear between) is below this: the value
#: for which the zone then changes least; a poor value costs a step or two, never the result.
CLOSED_AT = -0.25
#: Rings of elements around the border of the contact zone that make up the strip.
RINGS = 4
#: Where the border comes near the strip's rim, another strip follows around the new border, so many at most.
MAX_STRIPS = 4
MAX_ITERATIONS = 30


@dataclass(frozen=True, slots=True)
class NodeLocations:
    """Where the nodes of a mesh lie in a coarser one."""

    everywhere: MeshLocations  # (n,)
    on_plate: MeshLocations  # of the plate's nodes alone, in elements of the plate


def locate_nodes(before: Problem, problem: Problem) -> NodeLocations:
    """Return where a problem's nodes lie in the mesh of a coarser one."""
    coarse, nodes, under = before.mesh, problem.mesh.nodes, problem.plate.nodes
    element, place = locate_nearest(coarse, nodes)
    elements, places = element[under], place[under]
    # nodes on the plate's edge may have been found in an element beside it
    on_plate = np.zeros(len(coarse.elements), dtype=bool)
    on_plate[before.plate.elements] = True
    astray = np.flatnonzero(~on_plate[elements])
    if len(astray):
        elements[astray], places[astray] = locate_nearest(coarse, nodes[under[astray]], before.plate.elements)
    return NodeLocations((element, place), (elements, places))


def from_coarser(start: Solution, problem: Problem, at: NodeLocations) -> tuple[Integers, Array]:
    """Return the states (c,) of the bearings and the unknowns (n, F) interpolated from a solution on a coarser mesh."""
    before, b = start.system.problem, problem.contact.bearing
    coarse, nodes, under = before.mesh, problem.mesh.nodes, problem.plate.nodes
    state = np.full(len(b.law), CLOSED)
    ground = np.flatnonzero(b.field == TOP)  # none, or one at each node of the plate that does not hang
    element, place = at.on_plate
    numbers = np.searchsorted(under, b.node[ground])
    at_own = element[numbers], place[numbers]
    state[((b.support < 0) & (b.field != TOP)) | (b.field > TOP)] = OPEN  # bottoms of voids, and play
    if len(ground):
        touching = interpolate_bilinear(coarse, start.nodes_in(CLOSED, YIELDING), at_own) <= CLOSED_AT
        state[ground] = np.where(touching, CLOSED, OPEN)
        if (start.contact.state == YIELDING).any():
            yielding = interpolate_bilinear(coarse, start.nodes_in(YIELDING), at_own) <= CLOSED_AT
            limited = np.isfinite(b.law.limit_force[ground]) & ~on_plate_edge(problem)[ground]
            state[ground[yielding & limited]] = YIELDING
    for support in np.unique(b.support[b.support >= 0]):
        new, old = (np.flatnonzero((x.support == support) & (x.field == W)) for x in (b, before.contact.bearing))
        if len(new) and len(old):
            offset = nodes[b.node[new], None] - coarse.nodes[before.contact.bearing.node[old]]
            state[new] = start.contact.state[old[np.argmin((offset**2).sum(axis=2), axis=1)]]

    U = np.zeros((len(nodes), problem.unknown.shape[1]))
    plate = (plate_settlement(start.system, start.U), start.U[:, BETA_X], start.U[:, BETA_Y])
    surfaces = surface_settlement(start.system, start.U)
    U[under, :TOP] = interpolate(coarse, np.column_stack(plate), at.on_plate)
    U[:, TOP : TOP + problem.surfaces] = interpolate(coarse, surfaces.T, at.everywhere)
    U[under, TOP] -= U[under, W]
    U[problem.unknown < 0] = 0.0
    return state, problem.with_followers(U)


def unknowns_in(problem: Problem, U: Array) -> Array:
    """Return the unknowns (size,) in a table (n, F)."""
    has = problem.unknown >= 0
    u = np.zeros(problem.unknown.max(initial=-1) + 1)
    u[problem.unknown[has]] = U[has]
    return u


def solve_contact_border(
    problem: Problem, whole: ContactProblem, state: Integers, U: Array, solver: Solver
) -> Integers:
    """Return the states (c,) of the bearings after solving the contact on a strip along the contact zone's border.

    The contact on the whole mesh of the problem is given; U (n, F) approximates its solution.
    """
    has, u = problem.unknown >= 0, unknowns_in(problem, U)
    for _ in range(MAX_STRIPS):
        inside = _strip(problem, state, RINGS)
        free = np.zeros(whole.A.size, dtype=bool)
        free[problem.unknown[inside][has[inside]]] = True
        try:
            solved = _solve_strip(whole, state, u, free, solver)
        except (NotConverged, SingularMatrix):
            break  # the strip alone decides nothing: the full mesh will
        if solved is None:
            break
        before, (state, u) = state, solved
        if (state == before).all() or not (_strip(problem, state, RINGS // 2) & ~inside).any():
            break
    return state


def _solve_strip(
    whole: ContactProblem, state: Integers, u: Array, free: Flags, solver: Solver
) -> tuple[Integers, Array] | None:
    """Return states (c,) and unknowns (size,) with the contact on the free unknowns (size,) solved, all else fixed.

    None if there are no bearings on them.
    """
    A, law = whole.A, whole.bearings
    which = np.flatnonzero(free[law.unknown])
    if not len(which):
        return None
    numbers = np.flatnonzero(free)
    part = A.submatrix(numbers)
    load = (whole.f - A @ np.where(free, 0.0, u))[numbers]
    bearings = law.select(which)
    bearings = replace(bearings, unknown=(np.cumsum(free) - 1)[bearings.unknown])
    factorization = CachedFactorization(solver(part.indptr, part.indices))
    solution = contact.solve(
        ContactProblem(part, load, bearings), factorization, state[which], MAX_ITERATIONS, lambda *_: None
    )
    state, u = state.copy(), u.copy()
    state[which] = solution.state
    u[numbers] = solution.u
    return state, u


def _strip(problem: Problem, state: Integers, rings: int) -> Flags:
    """Return the nodes (n,) inside some rings of elements around those in which the ground changes its state."""
    b, elements = problem.contact.bearing, problem.mesh.elements
    ground = np.flatnonzero(b.field == TOP)
    at_node = np.full(len(problem.mesh.nodes), -1, dtype=np.int8)
    at_node[b.node[ground]] = state[ground]
    at_corner = at_node[elements]
    near = at_corner.max(axis=1) > np.where(at_corner < 0, np.int8(99), at_corner).min(axis=1)
    for _ in range(rings):
        touched = np.zeros(len(at_node), dtype=bool)
        touched[elements[near]] = True
        near = touched[elements].any(axis=1)
    inside = np.zeros(len(at_node), dtype=bool)
    inside[elements[near]] = True
    inside[elements[~near]] = False  # the rim belongs to the surroundings
    return inside
