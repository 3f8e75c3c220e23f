"""From unknowns to results: moments and shear forces, contact pressure, the full plate from its meshed part."""

from __future__ import annotations

import numpy as np

from groundslab import plate
from groundslab.assembly import scatter
from groundslab.checks import ground_forces
from groundslab.mesh import Mesh, mirror, row_by_row, sides_on_boundary
from groundslab.model import InterfaceLayer, Layered, Model
from groundslab.problem import BETA_X, BETA_Y, TOP, Problem, W, nodal_area, plate_settlement, surface_settlement
from groundslab.results import Certificate, Constants, GroundResult, PlateResult, Results, Step
from groundslab.shape import COLUMN, ROW, Array, Flags, Integers, gauss
from groundslab.solution import Solution
from groundslab.subsoil import consistent_parts
from groundslab.vlasov import Soil

#: Fields that change sign in the mirror x = 0 and in the mirror y = 0.
ODD = (
    {"rotation_x", "shear_x", "moment_xy"},
    {"rotation_y", "shear_y", "moment_xy"},
)


def recover(model: Model, solution: Solution, proof: Certificate, steps: tuple[Step, ...], solver: str) -> Results:
    """Return the results of a solution: nodal fields on the whole plate and the whole ground."""
    s, U = solution.system, solution.U
    problem = s.problem
    under = np.zeros(len(problem.mesh.nodes), dtype=bool)
    under[problem.plate_nodes] = True
    fields = _plate_fields(solution)
    ground = dict(enumerate(surface_settlement(problem, U)))
    area = nodal_area(problem.mesh, problem.plate_elements)
    closed = under.copy()
    if problem.tensionless:
        closed[problem.plate_nodes] = solution.contact.closed

    mesh = problem.mesh
    for axis in (0, 1):
        if not problem.symmetry[axis]:
            continue
        mesh, source, side = mirror(mesh, axis)
        on_axis = mesh.nodes[:, axis] == 0.0
        # on the axis the means of both sides' odd fields vanish; those of the meshed side alone need not
        odd = np.where(on_axis, 0.0, side)
        fields = {name: f[source] * (odd if name in ODD[axis] else 1.0) for name, f in fields.items()}
        ground = {number: w[source] for number, w in ground.items()}
        area, closed, under = area[source] * np.where(on_axis, 2.0, 1.0), closed[source], under[source]

    mesh, old = row_by_row(mesh)  # the same numbers whether a part was computed or the whole
    fields = {name: f[old] for name, f in fields.items()}
    ground = {number: w[old] for number, w in ground.items()}
    area, closed, under = area[old], closed[old], under[old]
    elements, edge = _plate_part(mesh, under)
    return Results(
        model=model,
        plate=PlateResult(
            nodes=mesh.nodes[under],
            elements=elements,
            **{name: field[under] for name, field in fields.items()},
            in_contact=closed[under],
            on_edge=edge,
            area=area[under],
        ),
        ground=GroundResult(mesh.nodes, mesh.elements, np.vstack(list(ground.values()))),
        constants=_constants(model, solution),
        certificate=proof,
        steps=steps,
        solver=solver,
        unknowns=s.pattern.size,
        symmetry=problem.symmetry,
    )


def _plate_fields(solution: Solution) -> dict[str, Array]:
    """Return every plate field at the nodes of the meshed part (n,), zero beyond the plate."""
    s, U = solution.system, solution.U
    problem = s.problem
    nodes = problem.plate_nodes
    area = nodal_area(problem.mesh, problem.plate_elements)
    force = solution.contact.force if problem.tensionless else ground_forces(s, U, solution.column)[nodes, 1]
    pressure = np.zeros(len(problem.mesh.nodes))
    pressure[nodes] = force / area[nodes]
    gap = np.zeros_like(pressure)
    if problem.tensionless:
        gap[nodes] = U[nodes, TOP]
    w = plate_settlement(problem, U)
    fields = {"settlement": w, "rotation_x": U[:, BETA_X], "rotation_y": U[:, BETA_Y], "gap": gap, "pressure": pressure}
    names = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
    return fields | dict(zip(names, nodal_section_forces(problem, U), strict=True))


def nodal_section_forces(problem: Problem, U: Array) -> list[Array]:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at the nodes (n,), averaged over the elements that meet there.

    Taken at the 2 x 2 Gauss points, where they are most accurate, and extrapolated bilinearly within each element.
    """
    elements = problem.mesh.elements[problem.plate_elements]
    points, _ = gauss(2)
    u = np.concatenate([U[elements, field] for field in (W, BETA_X, BETA_Y)], axis=1)
    D, S = problem.bending[problem.section], problem.shear[problem.section]
    M, Q = plate.section_forces(problem.element, points, problem.mesh.nodes[elements], D, S, u)
    at_nodes = np.column_stack([COLUMN - 1, ROW - 1]) * np.sqrt(3.0)
    sign = np.sign(points)
    extrapolate = (1 + at_nodes[:, :1] * sign[:, 0]) * (1 + at_nodes[:, 1:] * sign[:, 1]) / 4
    values = extrapolate @ np.concatenate([M, Q], axis=2)
    n = len(problem.mesh.nodes)
    meeting = np.maximum(np.bincount(elements.ravel(), minlength=n), 1)
    return [scatter(elements, values[..., i], n) / meeting for i in range(5)]


def _plate_part(mesh: Mesh, under: Flags) -> tuple[Integers, Flags]:
    """Return the plate's elements in the numbers of its own nodes, and which of these lie on the plate's edge."""
    elements = (np.cumsum(under) - 1)[mesh.elements[under[mesh.elements[:, 8]]]]
    edge = np.zeros(under.sum(), dtype=bool)
    edge[sides_on_boundary(elements)] = True
    return elements, edge


def _constants(model: Model, solution: Solution) -> Constants:
    """Return k0 and k1 of each layer: given, from gamma, or of a consistent stack the means of Ec / h and G h."""
    ground, gamma = solution.system.problem.ground, solution.gamma
    if isinstance(ground, Soil):
        assert gamma is not None
        k0, k1 = ground.layer_parameters(gamma)
    elif isinstance(model.ground, Layered) and model.ground.coupling == "consistent":
        parts = consistent_parts(model.ground)
        k0 = np.array([part.constrained * part.mean / part.thickness for part in parts])
        k1 = np.array([part.shear * part.mean * part.thickness for part in parts])
    elif isinstance(model.ground, Layered):
        k0 = np.array([layer.k0 for layer in model.ground.layers if isinstance(layer, InterfaceLayer)])
        k1 = np.array([layer.k1 for layer in model.ground.layers if isinstance(layer, InterfaceLayer)])
    else:
        k0, k1 = ground.A0[0], ground.A1[0]
    return Constants(tuple(map(float, k0)), tuple(map(float, k1)), gamma, solution.gamma_iterations)
