"""From unknowns to results: moments and shear forces, contact pressure, the full plate from its meshed part."""

from __future__ import annotations

import numpy as np

from groundslab import patches, plate
from groundslab.assembly import congruent, scatter
from groundslab.checks import apply, ground_forces, left_over
from groundslab.creases import apart, loaded, walls
from groundslab.loadcases import Combination
from groundslab.loading import materials
from groundslab.mesh import Mesh, mirror, row_by_row, sides_on_boundary
from groundslab.model import Model
from groundslab.problem import BETA_X, BETA_Y, TOP, Problem, W, nodal_area, plate_settlement, surface_settlement
from groundslab.results import (
    Certificate,
    Constants,
    ElementResult,
    GroundResult,
    PlateResult,
    Results,
    Step,
    SupportResult,
)
from groundslab.shape import Array, Integers, distinct, gauss, jacobian, q9
from groundslab.solution import Solution
from groundslab.vlasov import Soil

#: Fields that change sign in the mirror x = 0 and in the mirror y = 0.
ODD = (
    {"rotation_x", "shear_x", "moment_xy"},
    {"rotation_y", "shear_y", "moment_xy"},
)
#: What is recovered from the Gauss points, in the order of plate.section_forces.
FORCES = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
#: Weights of their squares in the size of the moment tensor, and of the shear force, in any direction alike.
SIZES = (np.array([1.0, 1.0, 2.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0, 1.0]))
#: The 2 x 2 Gauss points in the order that an element's mirror image has them.
XI_TURNED = np.array([2, 3, 0, 1])


def recover(
    model: Model,
    combination: Combination,
    solution: Solution,
    proof: Certificate,
    steps: tuple[Step, ...],
    solver: str,
) -> Results:
    """Return the results of a solution: nodal fields on the whole plate and the whole ground."""
    problem = solution.system.problem
    mesh, fields = _plate_fields(model, solution)
    at_centres = _element_fields(model, problem, solution.U, mesh, fields["pressure"])
    mesh, fields, at_centres = _whole(mesh, fields, problem.symmetry, at_centres)
    section = at_centres.pop("section").astype(np.int64)
    in_contact, on_edge = (fields.pop(name) > 0 for name in ("in_contact", "on_edge"))
    surfaces = surface_settlement(problem, solution.U)
    ground, settlements, _ = _whole(problem.mesh, {str(i): w for i, w in enumerate(surfaces)}, problem.symmetry, {})
    return Results(
        model=model,
        plate=PlateResult(mesh.nodes, mesh.elements, in_contact=in_contact, on_edge=on_edge, **fields),
        elements=ElementResult(section=section, **at_centres),
        ground=GroundResult(ground.nodes, ground.elements, np.vstack(list(settlements.values()))),
        constants=_constants(solution),
        certificate=proof,
        steps=steps,
        solver=solver,
        unknowns=solution.system.pattern.size,
        symmetry=problem.symmetry,
        combination=combination.name,
        limit_state=combination.limit_state,
        factors=combination.factors if model.cases else (),
        supports=_supports(model, solution),
    )


def _supports(model: Model, solution: Solution) -> tuple[SupportResult, ...]:
    """Return what each support carries."""
    problem, b = solution.system.problem, solution.system.problem.bearing
    if not model.supports:
        return ()
    _, rest = left_over(solution)
    w = plate_settlement(problem, solution.U)
    force = b.law.sign * solution.contact.force
    found = []
    for number, support in enumerate(model.supports):
        own = np.flatnonzero((b.support == number) & (b.field == W))
        nodes = b.node[own]
        moments = np.zeros((len(nodes), 2))
        for axis in (0, 1):
            if support.rotation == "fixed":
                moments[:, axis] = rest[nodes, BETA_X + axis]
            turned = np.flatnonzero((b.support == number) & (b.field == BETA_X + axis))
            if len(turned) and len(nodes):
                moments[:, axis] += force[turned]
        found.append(
            SupportResult(
                name=support.name or f"support {number + 1}",
                nodes=problem.mesh.nodes[nodes],
                length=b.length[own],
                settlement=w[nodes],
                force=-force[own],
                moment_x=moments[:, 0],
                moment_y=moments[:, 1],
            )
        )
    return tuple(found)


def _whole(
    mesh: Mesh, fields: dict[str, Array], symmetry: tuple[bool, bool], at_centres: dict[str, Array]
) -> tuple[Mesh, dict[str, Array], dict[str, Array]]:
    """Return mesh, nodal fields (n,) and fields of elements (m,) of the whole from those of the meshed part.

    Nodes and elements are numbered row by row.
    """
    for axis in (0, 1):
        if not symmetry[axis]:
            continue
        mesh, source, side = mirror(mesh, axis)
        on_axis = mesh.nodes[:, axis] == 0.0
        # on the axis the means of both sides' odd fields vanish; those of the meshed side alone need not
        odd, shared = np.where(on_axis, 0.0, side), np.where(on_axis, 2.0, 1.0)
        factors = {**dict.fromkeys(ODD[axis], odd), "area": shared}
        fields = {name: field[source] * factors.get(name, 1.0) for name, field in fields.items()}
        at_centres = {
            name: np.concatenate([field, -field if name in ODD[axis] else field]) for name, field in at_centres.items()
        }
    mesh, old, order = row_by_row(mesh)
    nodal = {name: field[old] for name, field in fields.items()}
    return mesh, nodal, {name: field[order] for name, field in at_centres.items()}


def _plate_fields(model: Model, solution: Solution) -> tuple[Mesh, dict[str, Array]]:
    """Return the meshed part of the plate and its fields (n,), flags as 0 and 1.

    A node on the border of two sections, or along a line support, stands once for each side, so that nothing is
    averaged across.
    """
    s, U = solution.system, solution.U
    problem = s.problem
    n, under = len(problem.mesh.nodes), problem.plate_nodes

    force, gap, closed, sunk = np.zeros(n), np.zeros(n), np.ones(n), np.zeros(n)
    if problem.tensionless:
        ground = np.flatnonzero(problem.bearing.support < 0)
        force[under], closed[under] = solution.contact.force[ground], solution.contact.closed[ground]
        sunk[under] = solution.slip[ground]
        gap[under] = np.where(closed[under] > 0, 0.0, U[under, TOP] + sunk[under])
    else:
        force[under] = ground_forces(s, U, solution.column)[under, 1]
    pressure = np.zeros(n)
    pressure[under] = force[under] / nodal_area(problem.mesh, problem.plate_elements)[under]
    fields = {
        "settlement": plate_settlement(problem, U),
        "rotation_x": U[:, BETA_X],
        "rotation_y": U[:, BETA_Y],
        "gap": gap,
        "penetration": sunk,
        "pressure": pressure,
        "in_contact": closed,
        "on_edge": _on_edge(problem),
    }

    supported = walls(model, problem)
    mesh, node = _by_section(problem, supported)
    smooth, _ = _by_section(problem, np.concatenate([supported, loaded(model, problem)]))
    fields = {name: field[node] for name, field in fields.items()}
    fields["area"] = nodal_area(mesh, np.arange(len(mesh.elements)))
    return mesh, fields | _section_forces(problem, U, mesh, smooth)


def _element_fields(model: Model, problem: Problem, U: Array, mesh: Mesh, pressure: Array) -> dict[str, Array]:
    """Return the fields at the centres of the plate's elements (mp,), the number of the section as a float among them.

    mesh and pressure (n,) are those of the plate by sections: the mean of an element's pressure is int N p dA over
    its area, so that all of them together are the whole contact force.
    """
    points, weights = gauss(3)
    N, dN = q9(points)
    share = jacobian(dN, mesh.xy)[2] * weights
    mean = np.einsum("eg,ga,ea->e", share, N, pressure[mesh.elements]) / share.sum(axis=1)
    thickness = np.array([t for _, _, t in materials(model)])[problem.section]
    forces = dict(zip(FORCES, centre_forces(problem, U).T, strict=True))
    return {"pressure": mean, **forces, "thickness": thickness, "section": problem.section.astype(np.float64)}


def _by_section(problem: Problem, creases: Integers) -> tuple[Mesh, Integers]:
    """Return the mesh of the plate whose nodes stand once for each section they belong to; which node each was.

    Nodes along creases (k, 3) stand once for each side, so that nothing is averaged across them.
    """
    elements, n = problem.mesh.elements[problem.plate_elements], len(problem.mesh.nodes)
    key = elements + n * problem.section[:, None]
    if len(creases):
        key = key + n * len(problem.bending) * apart(elements, creases, n)
    keys, own = distinct(key)
    return Mesh(problem.mesh.nodes[keys % n], own), keys % n


def _on_edge(problem: Problem) -> Array:
    """Return 1.0 at the nodes (n,) on the plate's edge, openings' edges too, else 0.0; lines of symmetry are none."""
    nodes = problem.mesh.nodes
    sides = sides_on_boundary(problem.mesh.elements[problem.plate_elements])
    for axis in (0, 1):
        if problem.symmetry[axis]:
            sides = sides[(nodes[sides, axis] != 0.0).any(axis=1)]
    edge = np.zeros(len(nodes))
    edge[sides] = 1.0
    return edge


def gauss_forces(problem: Problem, U: Array) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at the 2 x 2 Gauss points of the plate's elements, (mp, 4, 5)."""
    elements = problem.mesh.elements[problem.plate_elements]
    xy, sections = problem.mesh.nodes[elements], len(problem.bending)
    shapes, shape = congruent(xy)
    pairs, kind = np.unique(shape * sections + problem.section, return_inverse=True)
    D, S = problem.bending[pairs % sections], problem.shear[pairs % sections]
    matrices = plate.section_matrices(problem.element, gauss(2)[0], xy[shapes[pairs // sections]], D, S)
    u = np.concatenate([U[elements, field] for field in (W, BETA_X, BETA_Y)], axis=1)
    forces = apply(matrices.reshape(len(pairs), 20, 27), kind, u).reshape(len(elements), 4, 5)
    if problem.loading.warp.any():
        # what bends freely carries nothing
        free = problem.bending[:, :, :2].sum(axis=2)[problem.section] * problem.loading.warp[:, None]
        forces[..., :3] += free[:, None]
    return forces


def centre_forces(problem: Problem, U: Array) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at the centres of the plate's elements, (mp, 5).

    Nothing is averaged between elements: each has the mean of its 2 x 2 Gauss points, which is their bilinear field's
    value at its centre. The elements are those of the meshed part, in its order.
    """
    centres: Array = gauss_forces(problem, U).mean(axis=1)
    return centres


def _section_forces(problem: Problem, U: Array, mesh: Mesh, smooth: Mesh) -> dict[str, Array]:
    """Return moments [N m/m] and shear forces [N/m] at the nodes of the plate's mesh, recovered part by part.

    From the 2 x 2 Gauss points, where they are most accurate, by patches (Zienkiewicz and Zhu 1992) in the parts of the
    mesh in which they are smooth, whose nodes stand apart; nodes that are one in the mesh take the mean.
    """
    points, values = q9(gauss(2)[0])[0] @ mesh.xy, gauss_forces(problem, U)
    parts, n = smooth, len(mesh.nodes)
    for axis in (0, 1):
        if problem.symmetry[axis]:
            parts, points, values = _beyond_the_line(parts, points, values, axis)
    at_nodes = patches.nodal(parts.nodes, parts.elements, points, values, SIZES)[smooth.elements]
    meeting = np.bincount(mesh.elements.ravel(), minlength=n)
    return {name: scatter(mesh.elements, at_nodes[..., i], n) / meeting for i, name in enumerate(FORCES)}


def _beyond_the_line(mesh: Mesh, points: Array, values: Array, axis: int) -> tuple[Mesh, Array, Array]:
    """Return the mesh, its Gauss points and their section forces with the images of the elements near a symmetry line.

    Two rings of them, so that a corner node on the line has the patch it would have in the whole plate, and so has its
    neighbour across. The mesh's own nodes come first.
    """
    near = mesh.nodes[:, axis] == 0.0
    for _ in range(2):
        copied = near[mesh.elements].any(axis=1)
        near[mesh.elements[copied]] = True
    doubled, _, _ = mirror(mesh, axis)
    turn = np.where(np.arange(2) == axis, -1.0, 1.0)
    sign = np.array([-1.0 if name in ODD[axis] else 1.0 for name in FORCES])
    images = np.concatenate([np.ones(len(copied), dtype=bool), copied])
    # an image runs through its reference square with xi turned round
    return (
        Mesh(doubled.nodes, doubled.elements[images]),
        np.vstack([points, turn * points[copied][:, XI_TURNED]]),
        np.vstack([values, sign * values[copied][:, XI_TURNED]]),
    )


def _constants(solution: Solution) -> Constants:
    """Return k0 and k1 of each layer, given or from gamma; where the ground varies, the means over the plate's area."""
    problem, gamma = solution.system.problem, solution.gamma
    ground = problem.ground
    if isinstance(ground, Soil):
        assert gamma is not None
        k0, k1 = ground.layer_parameters(gamma)
        if ground.share is not None:
            k0, k1 = ground.share @ k0, ground.share @ k1
    else:
        k0, k1 = problem.constants
    return Constants(tuple(map(float, k0)), tuple(map(float, k1)), gamma, solution.gamma_iterations)
