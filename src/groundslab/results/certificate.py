"""The certificate of a result: equilibrium and complementarity, computed from the solution alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.bearings import CLOSED, YIELDING
from groundslab.fem.continuum.pile_group import PileGroup
from groundslab.fem.foundation import EDGE_MASS, EDGE_SLOPE, Column
from groundslab.fem.problem import (
    BETA_X,
    BETA_Y,
    LEAST,
    TOP,
    Problem,
    W,
    free_motions,
    largest_of_parts,
    move_plates,
    plate_unknowns,
    settlement_by_loads_beside,
    single_plates,
)
from groundslab.fem.system import (
    System,
    edge_decays,
    edge_lengths,
    link_forces,
    link_stiffness,
    surface_fields,
    surface_settlement,
)
from groundslab.results.record import Certificate
from groundslab.solvers.conditioning import plate_stiffness
from groundslab.solvers.cracking import error_of_law
from groundslab.solvers.solution import Solution

_CHUNK = 4096
#: A settlement this small against the plate, or a contact force this small against the load, counts as none.
NOTHING = 1e-12
#: Forces are exact to 1e-15 of stiffness times displacement: the share of it whose TOLERANCE that is.
ROUNDING = 1e-15 / Certificate.TOLERANCE


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
    elements = problem.mesh.elements[problem.plate_elements]
    f = apply(b.plate, b.kind[problem.plate_elements], plate_unknowns(problem, U))
    n = len(problem.mesh.nodes)
    return np.column_stack([scatter(elements, f[:, 9 * i : 9 * i + 9], n) for i in range(3)])


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
            under = problem.plate_nodes
            forces[under, 0] = scatter(elements, on_w, n)[under]
    if len(problem.edges):
        forces[:, 1:] += _tail_forces(problem, w, column)
    if len(problem.links.joint):
        surface = link_forces(s, U, column, joints=False)
        forces += surface[:, [W, *range(TOP, TOP + column.surfaces)]]
    return forces


def exact_rigid_products(s: System, column: Column) -> tuple[Array, Array]:
    """Return orthonormal rigid motions of the plate with the ground under it (size, 3), and their forces (size, 3).

    The forces are the ground's alone, which the matrix knows with the rounding of a plate that may be much stiffer.
    Of a plate that supports hold, or of which a part is meshed, the motions that are left, (size, m).
    """
    problem, size = s.problem, s.pattern.size
    nodes, free = problem.plate_nodes, free_motions(problem)
    motions, forces = np.zeros((size, free.shape[1])), np.zeros((size, free.shape[1]))
    has = problem.unknown >= 0
    for number, motion in enumerate(np.moveaxis(move_plates(problem, free), 2, 0)):
        U = np.zeros(problem.unknown.shape)
        U[nodes, :TOP] = motion[nodes]
        ground = ground_forces(s, U, column)
        resisting = link_forces(s, U, column, joints=True)
        for surface in range(column.surfaces):
            for field in surface_fields(surface):
                resisting[:, field] += ground[:, 0] if field == W else ground[:, 1 + surface]
        motions[problem.unknown[has], number] = U[has]
        np.add.at(forces[:, number], problem.unknown[has], resisting[has])
    Q, R = np.linalg.qr(motions)
    return Q, np.linalg.solve(R.T, forces.T).T


def _tail_forces(problem: Problem, w: Array, column: Column) -> Array:
    """Return the forces (n, S) that infinite ground puts on the outer edges."""
    (t, at_corners), length = edge_decays(problem, column), edge_lengths(problem)
    we = w[:, problem.edges]
    f = np.einsum("...ij,...,kl,j...l->i...k", t.spring, length, EDGE_MASS, we)
    f += np.einsum("...ij,...,kl,j...l->i...k", t.slope, 1 / length, EDGE_SLOPE, we)
    n = len(problem.mesh.nodes)
    forces = np.column_stack([scatter(problem.edges, each, n) for each in f])
    forces[problem.corners] += np.einsum("...ij,j...->...i", at_corners.corner, w[:, problem.corners])
    return forces


@dataclass(frozen=True, slots=True)
class Resistance:
    """What resists the loads at n nodes: all of it, and what of it ground and joints contribute."""

    all: Array  # (n, F) [N, N m]
    ground: Array  # (n, 1 + S) [N]: on the plate's w, and on each surface
    joints: Array  # (l,) [N]: of each link across a joint on its first node, upwards


def pressing_forces(solution: Solution) -> Array:
    """Return the forces (n, 2) that the cells of an elastic continuum put on the plate's w, and on their surface."""
    elastic, pressed = solution.system.problem.elastic, solution.pressed
    assert elastic is not None
    assert pressed is not None
    on_w = elastic.cells.spread @ pressed.force
    return np.column_stack([on_w, on_w])


def resistance(solution: Solution) -> Resistance:
    """Return the forces with which plate, ground and joints resist."""
    s, U, column = solution.system, solution.U, solution.column
    ground = ground_forces(s, U, column) if solution.pressed is None else pressing_forces(solution)
    inner = np.zeros_like(U)
    inner[:, :TOP] += plate_forces(s, U)
    for surface in range(column.surfaces):
        for field in surface_fields(surface):
            inner[:, field] += ground[:, 0] if field == W else ground[:, 1 + surface]
    joints = _joint_forces(solution, inner)
    return Resistance(inner + s.problem.links.spread(joints, len(U)), ground, joints)


def bearing_forces(solution: Solution) -> Array:
    """Return the forces (n, F) with which bearings push."""
    problem, borne = solution.system.problem, np.zeros_like(solution.U)
    bearing = problem.bearing
    np.add.at(borne, (bearing.node, bearing.field), bearing.law.sign * solution.contact.force)
    return borne


def _joint_forces(solution: Solution, inner: Array) -> Array:
    """Return the force (l,) [N] of each link of a joint on its first node, upwards, 0 of all other links.

    inner (n, F) are the forces with which plate and ground resist. Elastic joints resist by their stiffness. Hinges
    carry what then is left over at the nodes that they hold together: the plates' equations are taken for each alone.
    """
    s, problem = solution.system, solution.system.problem
    links = problem.links
    stiffness = np.where(links.joint >= 0, link_stiffness(s, solution.column), 0.0)
    force = stiffness * links.difference(solution.U)
    hinges = links.shared & (problem.unknown[links.nodes[:, 0], W] >= 0)
    if hinges.any():
        left = inner - problem.load - bearing_forces(solution) + links.spread(force, len(inner))
        force[hinges] = _balancing(links.nodes[hinges], left[:, W])
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
        own = np.flatnonzero(number == which)
        nodes, ends = np.unique(pairs[own], return_inverse=True)
        incidence = np.zeros((len(nodes), len(own)))
        incidence[ends.reshape(-1, 2).T, np.arange(len(own))] = np.array([[1.0], [-1.0]])
        force[own] = np.linalg.lstsq(incidence, -left[nodes], rcond=None)[0]
    return force


def certificate(solution: Solution, margin_effect: float | None) -> Certificate:
    """Return the certificate of a solution under the full load."""
    U, c, problem = solution.U, solution.contact, solution.system.problem
    under, bearing = problem.plate_nodes, problem.bearing
    resisting, load = resistance(solution), problem.load
    inner, ground = resisting.all, resisting.ground
    rest = inner - load

    fixed, borne = problem.unknown < 0, bearing_forces(solution)
    elastic = np.isfinite(solution.law.stiffness)
    rounding = _rounding(solution)
    residual = _residual(solution, inner, np.where(fixed, 0.0, rest - borne), rounding)

    # what the supports push on the plate
    support = np.where(fixed[:, :TOP], rest[:, :TOP], 0.0)
    support[:, W] *= _own_w(problem)
    own = bearing.field < TOP
    np.add.at(support, (bearing.node[own], bearing.field[own]), (bearing.law.sign * c.force)[own])
    support[:, W] -= problem.links.spread(resisting.joints, len(U))[:, W]
    # what presses on the ground beside the plate's edge does not reach the plate
    contact = ground[:, 0].copy()
    if solution.pressed is None:
        contact[under] -= load[under, TOP]
    pushed, beside = contact.sum(), load[:, TOP].sum()
    sizes = problem.loading.size
    # what a plate without loads of its own carries is the rounding of those of others
    nothing = NOTHING / Certificate.TOLERANCE * np.where(sizes > 0, sizes, sizes.max())
    least = np.maximum(nothing, max(rounding, ROUNDING * sizes.max()))
    balances = [
        _balance(plate, contact, support, np.abs(c.force[held & elastic]), float(least[number]))
        for number, (plate, held) in enumerate(single_plates(problem))
    ]
    size = sum(each.size for each in balances)

    scales = _scales(problem, U, np.array([each.size for each in balances]))
    gap, force, product = _bearing_errors(solution, scales)
    share = 2.0 ** sum(problem.symmetry)
    return Certificate(
        residual=residual,
        load=sum(each.load for each in balances) * share,
        reaction=sum(each.reaction for each in balances) * share,
        force_balance=max(each.force for each in balances),
        moment_balance=max(each.moment for each in balances),
        ground_balance=float(abs(_sum_down(solution, rest) - pushed - beside) / (size + abs(beside))),
        worst_gap=gap,
        worst_pressure=force,
        worst_product=product,
        gamma_change=solution.gamma_change,
        margin_effect=margin_effect,
        section_law=None if problem.stiffness is None else error_of_law(problem, U),
        ground_load=float(beside * share),
        joint_mismatch=_mismatch(problem, U, scales) if len(problem.links.joint) else None,
    )


@dataclass(frozen=True, slots=True)
class _Scales:
    """What errors are judged by, of each plate by itself, so that a heavy load on one hides nothing on another."""

    settlement: Array  # (plates,) [m]: the largest
    nothing: Array  # (plates,) [N]: a force that counts as none


def _scales(problem: Problem, U: Array, size: Array) -> _Scales:
    """Return the scales of plates whose forces have a size (plates,) [N]."""
    settlement = np.zeros(len(size))
    for number in range(len(size)):
        own = problem.nodes_of(number)
        length = np.ptp(problem.mesh.nodes[own], axis=0).max()
        settlement[number] = max(np.abs(U[own, W]).max(), NOTHING * length)
    least = LEAST * settlement.max()
    return _Scales(np.maximum(settlement, least), NOTHING / Certificate.TOLERANCE * size)


def _residual(solution: Solution, inner: Array, left: Array, rounding: float) -> float:
    """Return the largest force that is left over at a node (n, F), over the largest one of its plate.

    A load that a rigid support takes at once is no measure of what plate, ground and springs resist.
    """
    problem, law = solution.system.problem, solution.law
    elastic = np.isfinite(law.stiffness)
    borne = np.zeros_like(inner)
    np.add.at(borne, (problem.bearing.node[elastic], problem.bearing.field[elastic]), solution.contact.force[elastic])
    force = np.maximum(problem.nodal_sizes(inner), problem.nodal_sizes(borne))
    scale = np.full(len(force), force.max())
    if len(problem.plate_names) > 1:
        plate = problem.plate_at_nodes
        scale = np.where(plate < 0, scale, largest_of_parts(force, plate))
    scale = np.maximum(scale, rounding)
    largest = problem.nodal_sizes(left)
    return float(np.divide(largest, scale, out=np.zeros_like(largest), where=scale > 0).max())


def _rounding(solution: Solution) -> float:
    """Return the force [N] that counts as none: the rounding of stiffnesses times displacements, and of loads."""
    s, problem = solution.system, solution.system.problem
    way = np.abs(solution.law.offset[solution.contact.state == CLOSED]).max(initial=0.0)
    rounding = max(ROUNDING * plate_stiffness(s) * way, NOTHING * problem.nodal_sizes(problem.load).max())
    if len(problem.links.joint):
        stiffest = link_stiffness(s, solution.column)[problem.links.joint >= 0].max(initial=0.0)
        rounding = max(rounding, ROUNDING * stiffest * np.abs(solution.U[:, W]).max())
    return float(rounding)


@dataclass(frozen=True, slots=True)
class _Balance:
    """The balance of a plate: sums of loads and reactions [N], what is missing as a share of their size [N]."""

    load: float
    reaction: float
    force: float
    moment: float
    size: float


def _balance(plate: Problem, contact: Array, support: Array, springs: Array, rounding: float) -> _Balance:
    """Return the balance of a single plate: what ground (n,) and supports (n, 3) push on it, and forces of springs."""
    under, load = plate.plate_nodes, plate.plate_load
    nodes, load, contact, support = (each[under] for each in (plate.mesh.nodes, load, contact, support))
    # moments about the plate's middle, as far from it they would be differences of large numbers
    nodes = nodes - (nodes.min(axis=0) + nodes.max(axis=0)) / 2
    up = np.column_stack([contact, np.zeros((len(nodes), 2))])
    reaction, wanted = _resultant(nodes, up - support), _resultant(nodes, load)
    missing, length = np.abs(reaction - wanted), np.ptp(nodes, axis=0).max()
    parts = ((load + support) / [1.0, length, length], contact, springs)
    size = max(rounding, *(np.abs(part).sum() for part in parts)) or 1.0
    moments = missing[1:] * ~np.array(plate.symmetry)  # those about a line of symmetry vanish by themselves
    return _Balance(
        load=float(wanted[0]),
        reaction=float(reaction[0]),
        force=float(missing[0] / size),
        moment=float(moments.max() / (size * length)),
        size=float(size),
    )


def _sum_down(solution: Solution, rest: Array) -> float:
    """Return the force that the ground carries down and out, which is what its cells bear if it has such."""
    if solution.pressed is not None:
        return float(solution.pressed.force.sum() + solution.system.problem.load[:, TOP].sum())
    return _sum_lost_forces(solution.system, solution.U, solution.column, rest)


def _mismatch(problem: Problem, U: Array, scales: _Scales) -> float:
    """Return the largest difference across links that should have none, over the larger settlement of both plates.

    These are links of the ground's surface, and hinges.
    """
    links = problem.links
    settlement = scales.settlement[problem.plate_at_nodes[links.nodes]].max(axis=1)
    return float((np.abs(links.difference(U)) / settlement)[links.rigid].max(initial=0.0))


def worst(proofs: Sequence[Certificate]) -> Certificate:
    """Return the first certificate with the largest of all for every figure that must vanish."""
    names = proofs[0].must_vanish()
    return replace(proofs[0], **{name: max(getattr(proof, name) for proof in proofs) for name in names})


def _bearing_errors(solution: Solution, scales: _Scales) -> tuple[float, float, float]:
    """Return how badly the laws of the bearings are broken: way, force, and force times way.

    One-sided bearings may not be driven in further than their force says, pull, exceed their capacity, or carry
    anything while there is a way to go. Forces are relative to those of their own kind: at a node of the ground to what
    the largest pressure would give on its area, at a support to the largest force of a support, and each to a force
    that counts as nothing. Ways are relative to the largest settlement. All that is of the same plate.
    """
    problem, law, c = solution.system.problem, solution.law, solution.contact
    of_cells = _cell_errors(solution, scales)
    if not len(law):
        return of_cells
    plate = problem.plate_at_nodes[problem.bearing.node]
    scale = np.maximum(_forces_of_kind(problem, c.force, plate), scales.nothing[plate])
    elastic = np.isfinite(law.stiffness)
    way = law.penetration(c.u)
    way[elastic] -= c.force[elastic] / law.stiffness[elastic]
    one_sided = ~law.bilateral
    yielding = c.state == YIELDING
    broken = np.where(law.bilateral, np.abs(way), np.where(yielding, -way, way))
    if problem.elastic is not None and problem.elastic.piles is not None:
        piles = problem.elastic.piles.bearing
        broken[piles] = _pile_errors(solution, problem.elastic.piles)
    settlement = scales.settlement[plate]
    broken = (broken / settlement)[law.limit_force > 0]
    force = np.where(one_sided, np.maximum(-c.force, c.force - law.limit_force), 0.0) / scale
    product = np.where(one_sided & ~yielding, np.abs(c.force * way), 0.0) / scale / settlement
    of_bearings = float(broken.max(initial=0.0)), float(force.max()), float(product.max())
    way_off, force_off, product_off = (max(0.0, *each) for each in zip(of_bearings, of_cells, strict=True))
    return way_off, force_off, product_off


def _forces_of_kind(problem: Problem, force: Array, plate: Integers) -> Array:
    """Return for each bearing (c,) the largest force (c,) of its kind on its plate (c,).

    At a node of the ground it is what the largest pressure would give on its area, at a support the largest force of a
    support.
    """
    bearing, scale = problem.bearing, np.zeros(len(force))
    ground = bearing.support < 0
    part = plate if len(problem.plate_names) > 1 else None
    scale[~ground] = largest_of_parts(force[~ground], None if part is None else part[~ground])
    area = problem.depths.area[bearing.node[ground], bearing.depth[ground]]
    pressure = np.divide(force[ground], area, out=np.zeros_like(area), where=area > 0)
    scale[ground] = area * largest_of_parts(pressure, None if part is None else part[ground])
    return scale


def _pile_errors(solution: Solution, piles: PileGroup) -> Array:
    """Return how far the heads of piles are from where their loads and the ground put them (p,) [m].

    At the limit in compression the plate may lie deeper than the pile by itself, at that in tension higher.
    """
    assert solution.pressed is not None
    load = solution.contact.force[piles.bearing]
    deeper = solution.law.penetration(solution.contact.u)[piles.bearing] - piles.settle(load, solution.pressed.force)
    below, above = np.where(load >= piles.upper, 0.0, deeper), np.where(load <= piles.lower, 0.0, -deeper)
    found: Array = np.maximum(
        np.maximum(below, above), np.maximum(load - piles.upper, piles.lower - load) * np.diag(piles.own)
    )
    return found


def _cell_errors(solution: Solution, scales: _Scales) -> tuple[float, float, float]:
    """Return the same for the cells of an elastic continuum, whose gaps follow from its settlement and the plate's."""
    elastic, pressed, problem = solution.system.problem.elastic, solution.pressed, solution.system.problem
    if elastic is None or pressed is None:
        return 0.0, 0.0, 0.0
    force, area, limit = pressed.force, elastic.cells.area, elastic.limit_force
    gap = elastic.settle(force) + elastic.gap - elastic.cells.spread.T @ solution.U[:, W]
    gap += settlement_by_loads_beside(problem, elastic.cells.center)
    if elastic.piles is not None:
        gap += solution.contact.force[elastic.piles.bearing] @ elastic.piles.on_cells
    plate = elastic.cells.plate
    pressure = largest_of_parts(force / area, plate if len(problem.plate_names) > 1 else None)
    scale, settlement = np.maximum(area * pressure, scales.nothing[plate]), scales.settlement[plate]
    yielding = (force >= limit) & (limit > 0)
    bears = limit > 0
    if not problem.tensionless:
        return float((np.abs(gap) / settlement).max()), 0.0, 0.0
    broken = (np.where(yielding, gap, -gap) / settlement)[bears]
    wrong = np.maximum(-force, np.where(np.isinf(limit), 0.0, force - limit)) / scale
    product = np.where(yielding, 0.0, np.abs(force * gap)) / scale / settlement
    return float(broken.max(initial=0.0)), float(wrong.max(initial=0.0)), float(product.max(initial=0.0))


def _own_w(problem: Problem) -> Array:
    """Return 0.0 at centers whose w hangs on other nodes, else 1.0, (n,): no support can push there."""
    own = np.ones(len(problem.mesh.nodes))
    if not problem.element.center_w:
        own[problem.mesh.elements[problem.plate_elements, 8]] = 0.0
    return own


def _resultant(nodes: Array, forces: Array) -> Array:
    """Return sum F, sum F x + M_x, sum F y + M_y of nodal forces (n, 3) on w, beta_x, beta_y."""
    F = forces[:, W]
    return np.array([F.sum(), F @ nodes[:, 0] + forces[:, BETA_X].sum(), F @ nodes[:, 1] + forces[:, BETA_Y].sum()])


def _sum_lost_forces(s: System, U: Array, column: Column, rest: Array) -> float:
    """Return the force that leaves the ground: into the rigid base, into fixed outer edges and into infinite ground."""
    problem = s.problem
    w = surface_settlement(s, U)
    volume = s.blocks.mass.sum(axis=1)[s.blocks.kind]  # int N over each element
    base = np.einsum("...ij,j...a,...a->...", column.A0, w[:, problem.mesh.elements], volume).sum()
    of_ground = slice(TOP, TOP + problem.surfaces)
    fixed = (problem.unknown[:, of_ground] < 0) & (rest[:, of_ground] != 0)
    fixed[problem.plate_nodes] = False
    edge = -rest[:, of_ground][fixed].sum()
    lost = _tail_forces(problem, w, column).sum() if len(problem.edges) else 0.0
    return float(base + edge + lost)
