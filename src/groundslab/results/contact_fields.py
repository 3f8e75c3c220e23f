"""What happens between plate and ground in a solution: pressure, gap and contact, at nodes and by element."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.hanging import carry, find_hanging
from groundslab.fem.problem import MIDSIDES, TOP
from groundslab.fem.shape_functions import areas, q9_values
from groundslab.fem.system import plate_settlement
from groundslab.results.balance.forces import ground_forces
from groundslab.results.edge_forces import ground_shear, pressure_forces, split_contact_force
from groundslab.results.mirroring import ResultMesh
from groundslab.solvers.solution import Solution

#: A node touches if so much of the cells around it does.
HALF = 0.5
#: Elements are divided into so many parts along each side, on each half of which the field is taken as linear.
PARTS = 8


def contact_fields(solution: Solution, frame: ResultMesh) -> tuple[dict[str, Array], Array]:
    """Return fields at the nodes of a frame (k,), whether they touch as 1 or 0, and each element's mean pressure (mp,).

    A node's pressure is the contact force on its own elements over their share of area, less the line force along the
    plate's edge, so that all nodes together, and all elements together, carry the whole contact force beside that.
    """
    if solution.pressed is not None:
        return _on_cells(solution, frame)
    problem, elements = solution.system.problem, frame.mesh.elements
    pressure, touching, gap, sunk, line_force = _at_depths(solution, frame)
    if len(find_hanging(problem.mesh.elements)):
        pressure, touching, gap, sunk = (
            carry(problem.mesh.elements, nodal) for nodal in (pressure, touching, gap, sunk)
        )
        touching = (touching > HALF).astype(np.float64)
        if problem.contact.tensionless:
            pressure, gap, sunk = (np.maximum(nodal, 0.0) for nodal in (pressure, gap, sunk))
    of = problem.mesh.elements[problem.plate.elements]
    share = frame.mean * areas(frame.mesh.xy)[:, None]

    def by_element(values: Array) -> Array:
        weighted: Array = np.einsum("ed,ead->ea", problem.contact.depths.area_fraction, values[of])
        return weighted

    touches = by_element(touching)
    bears = scatter(elements, _area_that_touches(solution, of, touches) * share, len(frame.node))
    here = frame.node, frame.depth
    in_contact = scatter(elements, touches * share, len(frame.node)) > 0
    at_elements = by_element(pressure)
    at_nodes = pressure[here]
    springs = _springs(solution)
    if springs is not None:
        # where elements are refined a border's nodes carry forces of both sides, so that p = k w on each side instead
        total, w = float((at_elements * share).sum()), plate_settlement(solution.system, solution.U)
        w = carry(problem.mesh.elements, w - problem.contact.initial_gap)
        pressed = springs[:, None] * (np.maximum(w, 0.0) if problem.contact.tensionless else w)[of]
        carried = float((pressed * share).sum())
        at_elements = pressed * (total / carried if carried else 1.0)
    if springs is not None or len(problem.contact.depths.depth) > 1:
        at_nodes = scatter(elements, at_elements * share, len(frame.node)) / frame.area
    return {
        "gap": np.where(in_contact, 0.0, gap[here]),
        "penetration": np.where(in_contact, sunk[here], 0.0),
        "pressure": at_nodes,
        "in_contact": in_contact.astype(np.float64),
        "contact_area": bears,
        "line_force": np.where(frame.edge_length > 0, line_force[frame.node], 0.0),
    }, np.einsum("ea,ea->e", frame.mean, at_elements)


def _area_that_touches(solution: Solution, of: Integers, touches: Array) -> Array:
    """Return what of the area of each element's nodes touches (mp, 9), where the nodes touch (mp, 9) or do not.

    The plate's settlement on springs alone is smooth where it lifts off, and tells the line within the elements (mp, 9)
    of which some nodes touch. On other ground a node touches with all of its area.
    """
    mixed = np.flatnonzero(touches.any(axis=1) & ~touches.all(axis=1))
    s = solution.system
    if not len(mixed) or not lifts_off_springs(solution):
        return touches
    above = s.problem.contact.initial_gap - plate_settlement(s, solution.U)
    area = touches.copy()
    area[mixed] = share_below_zero(carry(s.problem.mesh.elements, above)[of[mixed]])[:, None]
    return area


def lifts_off_springs(solution: Solution) -> bool:
    """Return whether the ground is springs alone that never yield: the plate lifts off where it settles no more."""
    contact = solution.system.problem.contact
    return len(contact.depths.depth) == 1 and np.isinf(contact.limit_pressure) and not solution.column.A1.any()


def _springs(solution: Solution) -> Array | None:
    """Return the stiffness (mp,) [Pa/m] of springs that share a node's force by it, where elements have different ones.

    None of other ground, above voids, and where a limit pressure may share it otherwise.
    """
    problem, column = solution.system.problem, solution.column
    limited = np.isfinite(problem.contact.limit_pressure) or len(problem.contact.depths.depth) > 1
    if limited or not column.varies or column.surfaces > 1 or column.A1.any():
        return None
    k: Array = column.at(problem.plate.elements).A0[..., 0, 0]
    return k


def _on_cells(solution: Solution, frame: ResultMesh) -> tuple[dict[str, Array], Array]:
    """Return the same of an elastic continuum, from the cells around each node and under each element.

    Nodes together carry what the cells carry: means around them are scaled by what little their areas are off.
    """
    elastic, pressed = solution.system.problem.elastic, solution.pressed
    assert elastic is not None
    assert pressed is not None
    cells, here = elastic.cells, frame.node
    p = pressed.force / cells.area
    tensionless = solution.system.problem.contact.tensionless
    touching = cells.around @ ((pressed.force > 0) | (not tensionless)).astype(np.float64)
    at_nodes = (cells.around @ p)[here]
    carried = float(at_nodes @ frame.area)
    gap, in_contact = (cells.around @ pressed.gap)[here], touching[here] >= HALF
    return {
        "gap": np.where(in_contact, 0.0, np.maximum(gap, 0.0)),
        "penetration": np.where(in_contact, np.maximum(-gap, 0.0), 0.0),
        "pressure": at_nodes * (pressed.force.sum() / carried if carried else 1.0),
        "in_contact": in_contact.astype(np.float64),
        "contact_area": touching[here] * frame.area,
        "line_force": np.zeros(len(here)),
    }, cells.under @ p


def _at_depths(solution: Solution, frame: ResultMesh) -> tuple[Array, Array, Array, Array, Array]:
    """Return what lies at each depth at each node of the plate, arrays (n, d), and the edge line force (n,) [N/m].

    The pressure that it carries, 1.0 where it touches the plate, the gap above it and how far the plate has sunk into
    it. A cavity has no bottom: its gap is that above the level of the ground around it, if there is any.
    """
    s, U = solution.system, solution.U
    problem, under = s.problem, s.problem.plate.nodes
    below, b = problem.contact.depths, problem.contact.bearing
    pressure, touching, gap, sunk = np.zeros((4, *below.area.shape))
    if not problem.contact.tensionless:
        bears = under[below.area[under, 0] > 0]  # not at hanging nodes
        resisting = ground_forces(s, U, solution.column)[bears, 1] - problem.load[bears, TOP]
        pressure[bears, 0] = resisting / below.area[bears, 0]
        touching[under, 0] = 1.0
        return pressure, touching, gap, sunk, _line_force(solution, frame, pressure)
    ground = np.flatnonzero(b.support < 0)
    at = b.node[ground], b.depth[ground]
    pressure[at] = solution.contact.force[ground] / below.area[at]
    touching[at] = solution.contact.closed[ground] & (b.law.limit_force[ground] > 0)
    for k in range(1, len(below.depth)):
        # the bottom of a void that takes a part of an element bears at its sides only
        part = problem.mesh.elements[problem.plate.elements]
        part = part[below.shallowest[part[:, 8]] < k]
        touching[part[:, 8], k] = touching[part[:, MIDSIDES], k].mean(axis=1)
    sunk[at] = solution.slip[ground]

    depth = np.where(np.isfinite(below.depth), below.depth, 0.0)
    first = below.shallowest[under]
    clearance = problem.contact.initial_gap - depth[below.shallowest]
    opened = U[under, TOP] + problem.contact.initial_gap[under] + sunk[under, first]
    # ground without shear that bears nothing does not settle
    alone = clearance - plate_settlement(s, U) if below.stepped else np.zeros(len(clearance))
    if not below.stepped:
        alone[under] = opened - depth[first]
    gap[under] = np.maximum(alone[under, None] + depth, 0.0)
    gap[under, first] = opened
    return pressure, touching, gap, sunk, _line_force(solution, frame, pressure)


def _line_force(solution: Solution, frame: ResultMesh, pressure: Array) -> Array:
    """Return the line force along the plate's edge (n,) [N/m], and take it off the pressure (n, d) [Pa] in place.

    pressure holds it at first, spread over the area of each node of the edge. Ground without shear has none.
    """
    s, problem = solution.system, solution.system.problem
    line_force = np.zeros(len(pressure))
    edge = np.flatnonzero(frame.nodal_edge_length)
    if not problem.shear_at_edges or not len(edge):
        return line_force
    at_points = ground_shear(s, solution.U, solution.column)
    shear = frame.at_nodes(at_points, ("shear_x", "shear_y"), ())  # smooth, and linear in U
    share = pressure_forces(s, solution.U, solution.column, frame.edges, shear)
    at = edge, problem.contact.depths.shallowest[edge]
    area = problem.contact.depths.area[at]
    pressure[at], line_force[edge] = split_contact_force(
        pressure[at] * area,
        share[edge],
        area,
        frame.nodal_edge_length[edge],
        problem.contact.limit_pressure,
        problem.contact.tensionless,
    )
    return line_force


def share_below_zero(values: Array) -> Array:
    """Return the share (m,) of each element's area on which a field is negative, by its values (m, 9) at the nodes.

    Elements are taken as parallelograms.
    """
    steps = np.linspace(-1.0, 1.0, PARTS + 1)
    points = np.column_stack([coordinate.ravel() for coordinate in np.meshgrid(steps, steps)])
    at = (values @ q9_values(points).T).reshape(-1, PARTS + 1, PARTS + 1)
    low, right, up, far = at[:, :-1, :-1], at[:, :-1, 1:], at[:, 1:, :-1], at[:, 1:, 1:]
    halves = np.stack([np.stack([low, right, far], axis=-1), np.stack([low, up, far], axis=-1)], axis=-2)
    share: Array = _share_of_triangles(halves).mean(axis=(1, 2, 3))
    return share


def _share_of_triangles(corners: Array) -> Array:
    """Return the share (...) of triangles on which a linear field is negative, by its values at the corners (..., 3).

    A corner alone on its side of the line cuts off a triangle whose sides are a / (a - b) of those that meet in it.
    """
    least, middle, most = np.moveaxis(np.sort(corners, axis=-1), -1, 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        one_below = least**2 / ((least - middle) * (least - most))
        one_above = 1 - most**2 / ((most - middle) * (most - least))
    return np.select([most <= 0, least >= 0, middle >= 0], [np.where(least < 0, 1.0, 0.0), 0.0, one_below], one_above)
