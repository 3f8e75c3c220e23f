"""Recovers results from unknowns: moments and shear forces, contact pressure, the full plate from its meshed part."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.assembly import scatter
from groundslab.fem.problem import BETA_X, BETA_Y, Problem, W, without_rigid_motion
from groundslab.fem.system import plate_settlement, surface_settlement
from groundslab.fem.vlasov import Soil
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.certificate import apply, resistance
from groundslab.results.contact_fields import contact_fields
from groundslab.results.mesh_results import ElementResult, GroundResult, PlateResult
from groundslab.results.record import Certificate, Constants, Step
from groundslab.results.result_mesh import ResultMesh
from groundslab.results.results import CombinationResult, Increment, SupportResult
from groundslab.solvers.solution import Solution

#: What is recovered from the Gauss points, in the order of plate.section_forces.
FORCES = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
#: Weights of their squares in the size of the moment tensor, and of the shear force, in any direction alike.
SIZES = (np.array([1.0, 1.0, 2.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0, 1.0]))


def recover(
    model: Model,
    combination: Combination,
    solution: Solution,
    frame: ResultMesh,
    proof: Certificate,
    steps: tuple[Step, ...],
    solver: str,
    increments: tuple[Increment, ...] = (),
) -> CombinationResult:
    """Return the results of a solution: nodal fields on the full plate and ground."""
    plate, elements, ground = _parts(solution, frame)
    return CombinationResult(
        model=model,
        plate=plate,
        elements=elements,
        ground=ground,
        constants=_constants(solution),
        certificate=proof,
        steps=steps,
        solver=solver,
        unknowns=solution.system.pattern.size,
        symmetry=solution.system.problem.symmetry,
        combination=combination.name,
        limit_state=combination.limit_state,
        factors=combination.factors if model.cases else (),
        supports=_supports(model, solution),
        increments=increments,
    )


def increment(solution: Solution, frame: ResultMesh, share: float) -> Increment:
    """Return the state under a share of the load; the solution's problem has that share for its load."""
    return Increment(share, *_parts(solution, frame))


def _parts(solution: Solution, frame: ResultMesh) -> tuple[PlateResult, ElementResult, GroundResult]:
    """Return the full plate, its elements and the ground with their fields."""
    problem, plate, ground = solution.system.problem, frame.plate, frame.ground
    contact, pressure = contact_fields(solution, frame)
    s, U = solution.system, solution.U
    fields = {"settlement": plate_settlement(s, U), "rotation_x": U[:, BETA_X], "rotation_y": U[:, BETA_Y]}
    fields = {name: field[frame.node] for name, field in fields.items()}
    fields |= {"area": frame.area, "edge_length": frame.edge_length}
    fields |= section_forces(problem, U, frame) | contact
    at_centres = _element_fields(problem, U, frame) | {"pressure": pressure}
    nodal = {name: plate.nodal(name, field) for name, field in fields.items()}
    elements = {name: plate.by_element(name, field) for name, field in at_centres.items()}
    section = elements.pop("section").astype(np.int64)
    in_contact = nodal.pop("in_contact") > 0
    surfaces = surface_settlement(s, U)
    return (
        PlateResult(plate.mesh.nodes, plate.mesh.elements, in_contact=in_contact, **nodal),
        ElementResult(section=section, **elements),
        GroundResult(ground.mesh.nodes, ground.mesh.elements, surfaces[:, ground.node]),
    )


def _supports(model: Model, solution: Solution) -> tuple[SupportResult, ...]:
    """Return what each support carries."""
    problem, b = solution.system.problem, solution.system.problem.bearing
    if not model.supports:
        return ()
    rest = resistance(solution)[0] - problem.load
    w = plate_settlement(solution.system, solution.U)
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


def _element_fields(problem: Problem, U: Array, frame: ResultMesh) -> dict[str, Array]:
    """Return the fields at the centers of the plate's elements (mp,) but the pressure, the section's number a float."""
    forces = dict(zip(FORCES, centre_forces(problem, U, frame).T, strict=True))
    return {**forces, "thickness": problem.thickness, "section": problem.section.astype(np.float64)}


def gauss_forces(problem: Problem, U: Array, frame: ResultMesh) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at the 2 x 2 Gauss points of the plate's elements, (mp, 4, 5)."""
    elements = problem.mesh.elements[problem.plate_elements]
    U = without_rigid_motion(problem, U)
    u = np.concatenate([U[elements, field] for field in (W, BETA_X, BETA_Y)], axis=1)
    forces = apply(frame.matrices, frame.kind, u).reshape(len(elements), 4, 5)
    if problem.loading.thermal_curvature.any():
        # what bends freely carries nothing
        free = problem.bending[:, :, :2].sum(axis=2)[problem.section] * problem.loading.thermal_curvature[:, None]
        forces[..., :3] += free[:, None]
    return forces


def centre_forces(problem: Problem, U: Array, frame: ResultMesh) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at the centers of the plate's elements, (mp, 5).

    Nothing is averaged between elements: each has the mean of its 2 x 2 Gauss points, which is their bilinear field's
    value at its center. The elements are those of the meshed part, in its order.
    """
    centers: Array = gauss_forces(problem, U, frame).mean(axis=1)
    return centers


def section_forces(problem: Problem, U: Array, frame: ResultMesh) -> dict[str, Array]:
    """Return moments [N m/m] and shear forces [N/m] at the nodes of the plate's mesh, recovered part by part.

    From the 2 x 2 Gauss points, where they are most accurate, by patches (Zienkiewicz and Zhu 1992) in the parts of the
    mesh in which they are smooth, whose nodes stand apart; nodes that are one in the mesh take the mean.
    """
    mesh = frame.mesh
    at_nodes = frame.at_nodes(gauss_forces(problem, U, frame), FORCES, SIZES)
    n = len(mesh.nodes)
    meeting = np.bincount(mesh.elements.ravel(), minlength=n)
    return {name: scatter(mesh.elements, at_nodes[..., i], n) / meeting for i, name in enumerate(FORCES)}


def _constants(solution: Solution) -> Constants:
    """Return k0 and k1 of each layer, given or from gamma; where the ground varies, the means over the plate's area."""
    problem, gamma, decay = solution.system.problem, solution.gamma, None
    ground = problem.ground
    if isinstance(ground, Soil):
        assert gamma is not None
        decay = gamma / ground.gamma_of(1.0)
        k0, k1 = ground.layer_parameters(gamma)
        if ground.area_fraction is not None:
            k0, k1 = ground.area_fraction @ k0, ground.area_fraction @ k1
    else:
        k0, k1 = problem.constants
    return Constants(tuple(map(float, k0)), tuple(map(float, k1)), gamma, solution.gamma_iterations, decay)
