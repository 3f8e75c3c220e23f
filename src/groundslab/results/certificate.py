"""The certificate of a result: equilibrium and complementarity, computed from the solution alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.bearings import CLOSED, LEAST, MEMBER, YIELDING, largest_of_parts
from groundslab.fem.continuum.pile_group import PileGroup
from groundslab.fem.foundation import Column
from groundslab.fem.problem import (
    BETA_X,
    BETA_Y,
    TOP,
    Problem,
    W,
    groups_of_plates,
    settlement_by_loads_beside,
    single_plates,
)
from groundslab.fem.system import (
    System,
    link_stiffness,
    surface_settlement,
)
from groundslab.results.balance.forces import bearing_forces, building_forces, resistance, tail_forces
from groundslab.results.records import Certificate
from groundslab.solvers.conditioning import plate_stiffness
from groundslab.solvers.cracking import error_of_law
from groundslab.solvers.solution import Solution

#: A settlement this small against the plate, or a contact force this small against the load, counts as none.
NOTHING = 1e-12
#: Forces are exact to 1e-15 of stiffness times displacement: the share of it whose TOLERANCE that is.
ROUNDING = 1e-15 / Certificate.TOLERANCE


def certificate(solution: Solution, margin_effect: float | None) -> Certificate:
    """Return the certificate of a solution under the full load."""
    U, c, problem = solution.U, solution.contact, solution.system.problem
    under, bearing = problem.plate.nodes, problem.contact.bearing
    resisting, load = resistance(solution), problem.load
    inner, ground = resisting.all, resisting.ground
    rest = inner - load

    fixed, borne = problem.unknown < 0, bearing_forces(solution)
    # what holds plates in their plane may carry nothing
    fixed[:, list(problem.in_plane)] = False
    elastic = np.isfinite(solution.law.stiffness)
    rounding = _rounding(solution)
    residual = _residual(solution, inner, np.where(fixed, 0.0, rest - borne), rounding)

    # what the supports push on the plate
    support = np.where(fixed[:, :TOP], rest[:, :TOP], 0.0)
    support[:, W] *= _own_w(problem)
    on_plate = bearing.field < TOP
    np.add.at(support, (bearing.node[on_plate], bearing.field[on_plate]), (bearing.law.sign * c.force)[on_plate])
    across = problem.links.spread(resisting.joints, len(U))
    support -= across[:, :TOP] + problem.turned(across)
    # what presses on the ground beside the plate's edge does not reach the plate
    contact = ground[:, 0].copy()
    if solution.pressed is None:
        contact[under] -= load[under, TOP]
    pushed, beside = contact.sum(), load[:, TOP].sum()
    above = building_forces(problem, U)
    sizes = problem.loading.size
    # what a plate without loads of its own carries is the rounding of those of others
    nothing = NOTHING / Certificate.TOLERANCE * np.where(sizes > 0, sizes, sizes.max())
    least = np.maximum(nothing, max(rounding, ROUNDING * sizes.max()))
    balances = [
        _balance(plate, contact, support, above, np.abs(c.force[held & elastic]), float(least[number]))
        for number, (plate, held) in enumerate(single_plates(problem))
    ]
    size = sum(balance.size for balance in balances)

    scales = _scales(problem, U, np.array([balance.size for balance in balances]))
    gap, force, product = _bearing_errors(solution, scales)
    share = 2.0 ** sum(problem.symmetry)
    return Certificate(
        residual=residual,
        load=sum(balance.load for balance in balances) * share,
        reaction=sum(balance.reaction for balance in balances) * share,
        force_balance=max(balance.force for balance in balances),
        moment_balance=max(balance.moment for balance in balances),
        ground_balance=float(abs(_sum_down(solution, rest) - pushed - beside) / (size + abs(beside))),
        worst_gap=gap,
        worst_pressure=force,
        worst_product=product,
        gamma_change=solution.gamma_change,
        margin_effect=margin_effect,
        section_law=None if problem.plate.stiffness is None else error_of_law(problem, U),
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
        nodes = problem.nodes_of(number)
        length = np.ptp(problem.mesh.nodes[nodes], axis=0).max()
        settlement[number] = max(np.abs(U[nodes, W]).max(), NOTHING * length)
    least = LEAST * settlement.max()
    return _Scales(np.maximum(settlement, least), NOTHING / Certificate.TOLERANCE * size)


def _residual(solution: Solution, inner: Array, left: Array, rounding: float) -> float:
    """Return the largest force that is left over at a node (n, F), over the largest one of its plate or plates.

    A load that a rigid support takes at once is no measure of what plate, ground and springs resist.
    """
    problem, law = solution.system.problem, solution.law
    b = problem.contact.bearing
    elastic = np.isfinite(law.stiffness)
    borne = np.zeros_like(inner)
    np.add.at(borne, (b.node[elastic], b.field[elastic]), solution.contact.force[elastic])
    force = np.maximum(problem.nodal_sizes(inner), problem.nodal_sizes(borne))
    scale = np.full(len(force), force.max())
    if len(problem.plate.names) > 1:
        plate = problem.plate_at_nodes
        # members make one structure of their plates, of which one may carry nothing but the rounding of the others
        part = groups_of_plates(problem, problem.links.joint == MEMBER)[plate]
        scale = np.where(plate < 0, scale, largest_of_parts(force, np.where(plate < 0, -1, part)))
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


def _balance(plate: Problem, contact: Array, support: Array, above: Array, springs: Array, rounding: float) -> _Balance:
    """Return the balance of a single plate: what ground (n,) and supports (n, 3) push on it, and forces of springs.

    What the building above (n, 3) takes off a plate is less of a load.
    """
    under, load = plate.plate.nodes, plate.plate_load - above
    nodes, load, contact, support = (nodal[under] for nodal in (plate.mesh.nodes, load, contact, support))
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
    plate = problem.plate_at_nodes[problem.contact.bearing.node]
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
    way_off, force_off, product_off = (max(0.0, *errors) for errors in zip(of_bearings, of_cells, strict=True))
    return way_off, force_off, product_off


def _forces_of_kind(problem: Problem, force: Array, plate: Integers) -> Array:
    """Return for each bearing (c,) the largest force (c,) of its kind on its plate (c,).

    At a node of the ground it is what the largest pressure would give on its area, at a support the largest force of a
    support.
    """
    bearing, scale = problem.contact.bearing, np.zeros(len(force))
    ground = bearing.support < 0
    part = plate if len(problem.plate.names) > 1 else None
    scale[~ground] = largest_of_parts(force[~ground], None if part is None else part[~ground])
    area = problem.contact.depths.area[bearing.node[ground], bearing.depth[ground]]
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
    errors: Array = np.maximum(
        np.maximum(below, above), np.maximum(load - piles.upper, piles.lower - load) * np.diag(piles.own)
    )
    return errors


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
    pressure = largest_of_parts(force / area, plate if len(problem.plate.names) > 1 else None)
    scale, settlement = np.maximum(area * pressure, scales.nothing[plate]), scales.settlement[plate]
    yielding = (force >= limit) & (limit > 0)
    bears = limit > 0
    if not problem.contact.tensionless:
        return float((np.abs(gap) / settlement).max()), 0.0, 0.0
    broken = (np.where(yielding, gap, -gap) / settlement)[bears]
    wrong = np.maximum(-force, np.where(np.isinf(limit), 0.0, force - limit)) / scale
    product = np.where(yielding, 0.0, np.abs(force * gap)) / scale / settlement
    return float(broken.max(initial=0.0)), float(wrong.max(initial=0.0)), float(product.max(initial=0.0))


def _own_w(problem: Problem) -> Array:
    """Return 0.0 at centers whose w hangs on other nodes, else 1.0, (n,): no support can push there."""
    scale = np.ones(len(problem.mesh.nodes))
    if not problem.plate.element.center_w:
        scale[problem.mesh.elements[problem.plate.elements, 8]] = 0.0
    return scale


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
    fixed[problem.plate.nodes] = False
    edge = -rest[:, of_ground][fixed].sum()
    lost = tail_forces(problem, w, column).sum() if len(problem.edges) else 0.0
    return float(base + edge + lost)
