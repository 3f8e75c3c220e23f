"""Forces on nodes by plate, beams, building, ground and joints, from the solution and element matrices alone."""

from __future__ import annotations

from dataclasses import dataclass
from operator import attrgetter

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.fem.assembly import scatter
from groundslab.fem.bearings import SURFACE
from groundslab.fem.foundation import EDGE_MASS, EDGE_SLOPE, Column
from groundslab.fem.hanging import collect
from groundslab.fem.parts.beams import without_motion
from groundslab.fem.problem import (
    TOP,
    Problem,
    W,
    free_motions,
    membrane_unknowns,
    move_plates,
    plate_unknowns,
)
from groundslab.fem.system import (
    System,
    beam_fields,
    beam_unknowns,
    edge_decays,
    edge_lengths,
    link_forces,
    link_stiffness,
    surface_fields,
    surface_settlement,
)
from groundslab.solvers.solution import Solution

_CHUNK = 4096


def decay_squared(s: System, U: Array, column: Column) -> float:
    """Return int |grad w0|^2 / int w0^2 [1/m2] over all ground, that beyond infinite edges included (paper (2.23))."""
    problem, b = s.problem, s.blocks
    w = surface_settlement(s, U)
    we = w[0][problem.mesh.elements]
    squares = _by_kind(b.mass, b.kind, we, we)
    varying = we - we[:, 8:]  # else rounding makes slopes of a settlement that is everywhere the same
    slopes = _by_kind(b.slope, b.kind, varying, varying)
    if len(problem.edges):
        t, at_corners = edge_decays(problem, column)
        X, Y, _, _ = t.square_integrals()
        _, _, Xc, Yc = at_corners.square_integrals()
        length = edge_lengths(problem)
        # the amplitudes' products are summed over edges and corners where the tails are the same
        products = "emn" if t.varies else "mn"
        c = np.einsum("...ms,s...k->...km", t.projection, w[:, problem.edges])
        along = np.einsum(f"e,ekm,kl,eln->{products}", length, c, EDGE_MASS, c)
        across = np.einsum(f"e,ekm,kl,eln->{products}", 1 / length, c, EDGE_SLOPE, c)
        c = np.einsum("...ms,s...->...m", at_corners.projection, w[:, problem.corners])
        corner = np.einsum(f"em,en->{products}", c, c)
        squares += float((X * along).sum() + (Xc * corner).sum())
        slopes += float((Y * along).sum() + (X * across).sum() + (Yc * corner).sum())
    return max(slopes, 0.0) / squares if squares > 0 else 0.0


def _by_kind(matrices: Array, kind: Integers, u: Array, v: Array) -> float:
    """Return the sum over elements of u_e . M_kind(e) v_e."""
    return float(np.einsum("ea,ea->", u, apply(matrices, kind, v)))


def apply(matrices: Array, kind: Integers, v: Array) -> Array:
    """Return M_kind(e) v_e for every element, (m, rows), some thousand elements at a time to spare memory."""
    if len(matrices) == 1:
        only: Array = v @ matrices[0].T
        return only
    out = np.empty((len(v), matrices.shape[1]))
    for start in range(0, len(v), _CHUNK):
        part = slice(start, start + _CHUNK)
        out[part] = np.einsum("eab,eb->ea", matrices[kind[part]], v[part], optimize=True)
    return out


def plate_forces(s: System, U: Array) -> Array:
    """Return the forces (n, 3) that the plate's deformation puts on w, beta_x, beta_y of each node."""
    problem, b = s.problem, s.blocks
    elements = problem.mesh.elements[problem.plate.elements]
    f = apply(b.plate, b.kind[problem.plate.elements], plate_unknowns(problem, U))
    n = len(problem.mesh.nodes)
    forces = np.column_stack([scatter(elements, f[:, 9 * i : 9 * i + 9], n) for i in range(3)])
    return collect(problem.mesh.elements, forces)


def membrane_forces(s: System, U: Array) -> Array:
    """Return the forces (n, 2) that the plates' deformation in their plane puts on u and v of each node."""
    problem, b = s.problem, s.blocks
    elements, n = problem.mesh.elements[problem.plate.elements], len(problem.mesh.nodes)
    f = apply(b.membrane, b.kind[problem.plate.elements], membrane_unknowns(problem, U))
    return collect(problem.mesh.elements, np.column_stack([scatter(elements, f[:, half], n) for half in _HALVES]))


#: u and v among the unknowns of an element.
_HALVES = slice(0, 9), slice(9, 18)


def beam_forces(s: System, U: Array) -> Array:
    """Return the forces (n, F) that the deformation of beams and walls puts on nodes."""
    forces, sides = np.zeros_like(U), s.problem.beams.sides
    if len(sides):
        u = without_motion(s.problem.beams, s.problem.mesh.nodes, beam_unknowns(s.problem, U))
        on_nodes = np.einsum("bacij,bcj->bai", s.beams, u)
        for which, fields, in_element in beam_fields(s.problem):
            np.add.at(forces, (sides[which][..., None], fields), on_nodes[which][..., in_element])
    return forces


def building_forces(problem: Problem, U: Array) -> Array:
    """Return the forces (n, 3) with which the building above resists on w, beta_x, beta_y of each node."""
    return np.zeros((len(U), TOP)) if problem.building is None else problem.building.on_nodes(U)


def ground_forces(s: System, U: Array, column: Column) -> Array:
    """Return the forces (n, 1 + S) that the ground's deformation puts on the plate's w and on each surface.

    The first column differs from the second only where a plate's center w hangs on its element's other nodes.
    """
    problem, b = s.problem, s.blocks
    w = surface_settlement(s, U)
    elements, n = problem.mesh.elements, len(problem.mesh.nodes)
    forces = np.zeros((n, 1 + column.surfaces))
    mass = [apply(b.mass, b.kind, w[j][elements]) for j in range(column.surfaces)]
    slope = [apply(b.slope, b.kind, w[j][elements]) for j in range(column.surfaces)]
    for i in range(column.surfaces):
        by_element = np.zeros_like(mass[0])
        for j in range(column.surfaces):
            by_element += column.A0[..., i, j, None] * mass[j] + column.A1[..., i, j, None] * slope[j]
        forces[:, 1 + i] = scatter(elements, by_element, n)
        if i == 0:
            on_w = np.einsum("ea,eab->eb", by_element, b.T[b.kind])
            forces[:, 0] = scatter(elements, on_w, n)
    forces = collect(elements, forces)
    beside = np.ones(n, dtype=bool)
    beside[problem.plate.nodes] = False
    forces[beside, 0] = 0.0
    if len(problem.edges):
        forces[:, 1:] += tail_forces(problem, w, column)
    if len(problem.links.joint):
        surface = link_forces(s, U, column, joints=False)
        forces += surface[:, [W, *range(TOP, TOP + column.surfaces)]]
    return forces


def exact_rigid_products(s: System, column: Column) -> tuple[Array, Array]:
    """Return orthonormal rigid motions of the plate with the ground under it (size, 3), and their forces (size, 3).

    The forces are those of ground, joints and the building above alone, which the matrix knows with the rounding of a
    plate that may be much stiffer.
    Of a plate that supports hold, or of which a part is meshed, the motions that are left, (size, m).
    """
    problem, size = s.problem, s.pattern.size
    nodes, free = problem.plate.nodes, free_motions(problem)
    motions, forces = np.zeros((size, free.shape[1])), np.zeros((size, free.shape[1]))
    has = problem.unknown >= 0
    for number, motion in enumerate(np.moveaxis(move_plates(problem, free), 2, 0)):
        U = np.zeros(problem.unknown.shape)
        U[nodes, :TOP] = motion[nodes]
        U = problem.with_followers(U)
        ground = ground_forces(s, U, column)
        resisting = link_forces(s, U, column, joints=True)
        resisting[:, :TOP] += building_forces(problem, U)
        for surface in range(column.surfaces):
            for field in surface_fields(surface):
                resisting[:, field] += ground[:, 0] if field == W else ground[:, 1 + surface]
        motions[problem.unknown[has], number] = U[has]
        np.add.at(forces[:, number], problem.unknown[has], resisting[has])
    Q, R = np.linalg.qr(motions)
    return Q, np.linalg.solve(R.T, forces.T).T


def tail_forces(problem: Problem, w: Array, column: Column) -> Array:
    """Return the forces (n, S) that infinite ground puts on the outer edges."""
    (t, at_corners), length = edge_decays(problem, column), edge_lengths(problem)
    we = w[:, problem.edges]
    f = np.einsum("...ij,...,kl,j...l->i...k", t.spring, length, EDGE_MASS, we)
    f += np.einsum("...ij,...,kl,j...l->i...k", t.slope, 1 / length, EDGE_SLOPE, we)
    n = len(problem.mesh.nodes)
    forces = np.column_stack([scatter(problem.edges, force, n) for force in f])
    forces[problem.corners] += np.einsum("...ij,j...->...i", at_corners.corner, w[:, problem.corners])
    return forces


@dataclass(frozen=True, slots=True)
class Resistance:
    """What resists the loads at n nodes: all of it, and what of it ground and joints contribute."""

    all: Array  # (n, F) [N, N m]
    ground: Array  # (n, 1 + S) [N]: on the plate's w, and on each surface
    joints: Array  # (l,) [N, N m]: of each link across a joint on its first node, upwards


def pressing_forces(solution: Solution) -> Array:
    """Return the forces (n, 2) that the cells of an elastic continuum put on the plate's w, and on their surface."""
    elastic, pressed = solution.system.problem.elastic, solution.pressed
    assert elastic is not None
    assert pressed is not None
    on_w = elastic.cells.spread @ pressed.force
    return np.column_stack([on_w, on_w])


@made_once_by(attrgetter("U", "system"))
def resistance(solution: Solution) -> Resistance:
    """Return the forces with which plate, beams, building, ground and joints resist."""
    s, U, column = solution.system, solution.U, solution.column
    ground = ground_forces(s, U, column) if solution.pressed is None else pressing_forces(solution)
    inner = beam_forces(s, U)
    inner[:, :TOP] += plate_forces(s, U) + building_forces(s.problem, U)
    if s.problem.in_plane:
        inner[:, list(s.problem.in_plane)] += membrane_forces(s, U)
    for surface in range(column.surfaces):
        for field in surface_fields(surface):
            inner[:, field] += ground[:, 0] if field == W else ground[:, 1 + surface]
    joints = _joint_forces(solution, inner)
    return Resistance(inner + s.problem.links.spread(joints, len(U)), ground, joints)


def bearing_forces(solution: Solution) -> Array:
    """Return the forces (n, F) with which bearings push."""
    problem, borne = solution.system.problem, np.zeros_like(solution.U)
    bearing = problem.contact.bearing
    np.add.at(borne, (bearing.node, bearing.field), bearing.law.sign * solution.contact.force)
    return borne


def _joint_forces(solution: Solution, inner: Array) -> Array:
    """Return the force (l,) [N], or moment, of each link of joint or member on its first node, 0 of all other links.

    inner (n, F) are the forces with which plate and ground resist. Elastic joints resist by their stiffness. Hinges,
    and members that go on across a joint, carry what then is left over at the nodes that they hold together: the
    plates' equations are taken for each alone.
    """
    s, problem = solution.system, solution.system.problem
    links = problem.links
    stiffness = np.where(links.joint != SURFACE, link_stiffness(s, solution.column), 0.0)
    force = stiffness * links.difference(solution.U)
    if links.shared.any():
        left = inner - problem.load - bearing_forces(solution) + links.spread(force, len(inner))
        for field in np.flatnonzero(links.fields[links.shared].any(axis=0)):
            of_field = links.shared & links.fields[:, field] & (problem.unknown[links.nodes[:, 0], field] >= 0)
            force[of_field] = _balancing(links.nodes[of_field], left[:, field])
    return force


def _balancing(pairs: Integers, left: Array) -> Array:
    """Return the forces (k,) between pairs of nodes (k, 2) that balance what is left over at the nodes, (n,).

    Each is that on the first node of its pair. Where more than two nodes meet, the least of those that balance.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    force = left[pairs[:, 1]].copy()
    n = len(left)
    place = connected_components(coo_array((np.ones(len(pairs)), pairs.T), shape=(n, n)), directed=False)[1]
    _, number, count = np.unique(place[pairs[:, 0]], return_inverse=True, return_counts=True)
    for which in np.flatnonzero(count > 1):
        of_plate = np.flatnonzero(number == which)
        nodes, ends = np.unique(pairs[of_plate], return_inverse=True)
        incidence = np.zeros((len(nodes), len(of_plate)))
        incidence[ends.reshape(-1, 2).T, np.arange(len(of_plate))] = np.array([[1.0], [-1.0]])
        force[of_plate] = np.linalg.lstsq(incidence, -left[nodes], rcond=None)[0]
    return force
