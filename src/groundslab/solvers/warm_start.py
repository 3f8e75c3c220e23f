"""What a solution on a coarser mesh tells of the next one: unknowns, and where the plate will touch the ground.

The contact zone is found on a strip along its border alone, held to the coarser solution around it. That costs little
and leaves next to nothing for the whole mesh to change.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import NotConverged, SingularMatrix
from groundslab.fem.bearings import CLOSED, LAWS, OPEN, YIELDING, Bearings
from groundslab.fem.mesh import Whereabouts, between, interpolated, whereabouts
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, Problem, W
from groundslab.fem.sparse import Symmetric
from groundslab.fem.system import System, on_lines, plate_settlement, surface_settlement
from groundslab.solvers import contact
from groundslab.solvers.factor_reuse import Latest
from groundslab.solvers.protocols import Solver
from groundslab.solvers.solution import Solution

#: A node starts closed where the coarser mesh's contact (-1 closed, 1 open, linear between) is below this: the value
#: for which the zone then changes least; it costs a step or two if it is off, never the result.
CLOSED_AT = -0.25
#: Rings of elements around the border of the contact zone that make up the strip.
RINGS = 4
#: The border may come near the strip's rim; then it is laid anew around where the border went, so many times at most.
STRIPS = 4
LIMIT = 30


@dataclass(frozen=True, slots=True)
class Places:
    """Where the nodes of a mesh lie in a coarser one."""

    everywhere: Whereabouts  # (n,)
    on_plate: Whereabouts  # of the plate's nodes alone, in elements of the plate


def places(before: Problem, problem: Problem) -> Places:
    """Return where a problem's nodes lie in the mesh of a coarser one."""
    coarse, nodes, under = before.mesh, problem.mesh.nodes, problem.plate_nodes
    element, place = whereabouts(coarse, nodes)
    own, there = element[under], place[under]
    # nodes on the plate's edge may have been found in an element beside it
    on_plate = np.zeros(len(coarse.elements), dtype=bool)
    on_plate[before.plate_elements] = True
    astray = np.flatnonzero(~on_plate[own])
    if len(astray):
        own[astray], there[astray] = whereabouts(coarse, nodes[under[astray]], before.plate_elements)
    return Places((element, place), (own, there))


def from_coarser(start: Solution, problem: Problem, at: Places) -> tuple[Integers, Array]:
    """Return the states (c,) of the bearings and the unknowns (n, F) to expect after a solution on a coarser mesh."""
    before, b = start.system.problem, problem.bearing
    coarse, nodes, under = before.mesh, problem.mesh.nodes, problem.plate_nodes
    state = np.full(len(b.law), CLOSED)
    ground = np.flatnonzero(b.field == TOP)  # none, or one at each node of the plate
    state[(b.support < 0) & (b.field != TOP)] = OPEN
    if len(ground):
        touching = between(coarse, start.nodes_in(CLOSED, YIELDING), at.on_plate) <= CLOSED_AT
        state[ground] = np.where(touching, CLOSED, OPEN)
        if (start.contact.state == YIELDING).any():
            yielding = between(coarse, start.nodes_in(YIELDING), at.on_plate) <= CLOSED_AT
            limited = np.isfinite(b.law.capacity[ground]) & ~on_lines(problem)[ground]
            state[ground[yielding & limited]] = YIELDING
    for support in np.unique(b.support[b.support >= 0]):
        new, old = (np.flatnonzero((x.support == support) & (x.field == W)) for x in (b, before.bearing))
        if len(new) and len(old):
            offset = nodes[b.node[new], None] - coarse.nodes[before.bearing.node[old]]
            state[new] = start.contact.state[old[np.argmin((offset**2).sum(axis=2), axis=1)]]

    U = np.zeros((len(nodes), problem.unknown.shape[1]))
    plate = (plate_settlement(start.system, start.U), start.U[:, BETA_X], start.U[:, BETA_Y])
    surfaces = surface_settlement(start.system, start.U)
    U[under, :TOP] = interpolated(coarse, np.column_stack(plate), at.on_plate)
    U[:, TOP:] = interpolated(coarse, surfaces.T, at.everywhere)
    U[under, TOP] -= U[under, W]
    U[problem.unknown < 0] = 0.0
    return state, U


def along_the_border(
    s: System, A: Symmetric, f: Array, law: Bearings, state: Integers, U: Array, solver: Solver
) -> Integers:
    """Return the states (c,) of the bearings once those along the contact zone's border are in equilibrium.

    U (n, F) is what the solution is expected to be near.
    """
    problem = s.problem
    has = problem.unknown >= 0
    u = np.zeros(A.size)
    u[problem.unknown[has]] = U[has]
    for _ in range(STRIPS):
        inside = _strip(problem, state, RINGS)
        own = np.zeros(A.size, dtype=bool)
        own[problem.unknown[inside][has[inside]]] = True
        which = np.flatnonzero(own[law.at])
        if not len(which):
            break
        numbers = np.flatnonzero(own)
        part, load = A.part(numbers), (f - A @ np.where(own, 0.0, u))[numbers]
        some = Bearings((np.cumsum(own) - 1)[law.at[which]], *(getattr(law, name)[which] for name in LAWS))
        latest = Latest(solver(part.indptr, part.indices))
        try:
            found = contact.solve(part, load, latest, some, state[which], LIMIT, lambda *_: None)
        except (NotConverged, SingularMatrix):
            break  # the strip alone tells nothing: the whole mesh will
        before, state = state, state.copy()
        state[which] = found.state
        u[numbers] = found.u
        if (state == before).all() or not (_strip(problem, state, RINGS // 2) & ~inside).any():
            break
    return state


def _strip(problem: Problem, state: Integers, rings: int) -> Flags:
    """Return the nodes (n,) inside so many rings of elements around those in which the ground changes its state."""
    b, elements = problem.bearing, problem.mesh.elements
    ground = np.flatnonzero(b.field == TOP)
    at = np.full(len(problem.mesh.nodes), -1, dtype=np.int8)
    at[b.node[ground]] = state[ground]
    each = at[elements]
    near = each.max(axis=1) > np.where(each < 0, np.int8(99), each).min(axis=1)
    for _ in range(rings):
        touched = np.zeros(len(at), dtype=bool)
        touched[elements[near]] = True
        near = touched[elements].any(axis=1)
    inside = np.zeros(len(at), dtype=bool)
    inside[elements[near]] = True
    inside[elements[~near]] = False  # the rim belongs to what is around
    return inside
