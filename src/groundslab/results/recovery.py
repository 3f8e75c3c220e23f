"""Recovers results from unknowns: moments and shear forces, contact pressure, the full plate from its meshed part."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem import plate
from groundslab.fem.assembly import scatter
from groundslab.fem.continuum.pressed_cells import PressedCells, press
from groundslab.fem.hanging import find_halves
from groundslab.fem.mesh import Mesh
from groundslab.fem.parts import membrane as stretching
from groundslab.fem.problem import BETA_X, BETA_Y, Problem, W, membrane_unknowns, plate_unknowns
from groundslab.fem.shape_functions import gauss
from groundslab.fem.system import plate_settlement, surface_settlement
from groundslab.fem.vlasov import Soil
from groundslab.messages import Message
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.balance.beam_forces import beam_results
from groundslab.results.balance.building_forces import base_results
from groundslab.results.balance.forces import resistance
from groundslab.results.contact_fields import contact_fields
from groundslab.results.fields import MEMBRANE
from groundslab.results.mirroring import ResultMesh
from groundslab.results.plate_result import ElementResult, GroundResult, PlateResult
from groundslab.results.records import Certificate, Constants, JointResult, Step, SupportResult
from groundslab.results.results import CombinationResult, Comparison, Increment
from groundslab.solvers.cracking import laws
from groundslab.solvers.solution import Solution

#: What is recovered from the Gauss points, in the order of plate.section_forces.
FORCES = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
#: Weights of their squares in the size of the moment tensor, and of the shear force, in any direction alike.
SIZES = (np.array([1.0, 1.0, 2.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0, 1.0]))
#: The same weights of the membrane forces.
OF_TENSOR = (np.array([1.0, 1.0, 2.0]),)


@dataclass(frozen=True, slots=True)
class MeshedFields:
    """Fields of the meshed part of plate and ground: k nodes of the results' mesh, mp plate elements, S surfaces."""

    forces: Array  # (mp, 9, 5): recovered section forces at the nodes of each element, see FORCES
    nodal: dict[str, Array]  # (k,)
    elements: dict[str, Array]  # (mp,)
    surfaces: Array  # (S, n) [m]: settlements
    cells: PressedCells | None = None
    membrane: Array | None = None  # (mp, 9, 3): recovered forces in the plane at nodes of elements, as fields.MEMBRANE


@dataclass(frozen=True, slots=True)
class Recovered:
    """What was recovered from the solutions of a combination: fields on the full plate and ground, and how good."""

    parts: tuple[PlateResult, ElementResult, GroundResult]  # under the full load
    increments: tuple[Increment, ...]  # under smaller shares of it
    comparison: Comparison | None  # with the next coarser mesh
    certificate: Certificate


def recover(
    model: Model,
    combination: Combination,
    solution: Solution,
    recovered: Recovered,
    steps: tuple[Step, ...],
    solver: str,
) -> CombinationResult:
    """Return the results of a solution, of which fields and certificate are recovered.

    The model is the case as solved; the driver, which knows it, puts the case as written in its place.
    """
    plate, elements, ground = recovered.parts
    return CombinationResult(
        model=model,
        solved_model=model,
        plate=plate,
        elements=elements,
        ground=ground,
        constants=ground_constants(solution),
        certificate=recovered.certificate,
        steps=steps,
        solver=solver,
        unknowns=solution.system.pattern.size,
        mesh_plan=solution.system.problem.mesh_plan,
        combination=combination.name,
        limit_state=combination.limit_state,
        factors=combination.factors if model.cases else (),
        supports=support_results(model, solution),
        joints=joint_results(model, solution),
        beams=beam_results(model, solution),
        bases=base_results(model, solution, solver),
        increments=recovered.increments,
        comparison=recovered.comparison,
    )


def recover_fields(solution: Solution, frame: ResultMesh) -> MeshedFields:
    """Return the fields of a solution on the meshed part."""
    s, U, problem = solution.system, solution.U, solution.system.problem
    contact, pressure = contact_fields(solution, frame)
    at_points = own_forces(problem, U, gauss(2)[0])
    forces = frame.at_nodes(at_points, FORCES, SIZES)
    moved = {"settlement": plate_settlement(s, U), "rotation_x": U[:, BETA_X], "rotation_y": U[:, BETA_Y]}
    nodal = {name: field[frame.node] for name, field in moved.items()}
    nodal |= {"area": frame.area, "edge_length": frame.edge_length} | section_forces(frame, forces) | contact
    elements = _element_fields(problem, at_points) | {"pressure": pressure}
    membrane = None
    if problem.in_plane:
        membrane_forces = own_membrane(problem, U, gauss(2)[0])
        elements |= dict(zip(MEMBRANE, membrane_forces.mean(axis=1).T, strict=True))
        membrane = frame.at_nodes(membrane_forces, tuple(MEMBRANE), OF_TENSOR)
    return MeshedFields(forces, nodal, elements, surface_settlement(s, U), _press(solution), membrane)


def settlement_of(solution: Solution, frame: ResultMesh) -> tuple[Mesh, Array]:
    """Return the full plate's mesh and its settlement (n,) [m] alone, as the fields of a solution have it."""
    settlement = plate_settlement(solution.system, solution.U)[frame.node]
    return frame.plate.mesh, frame.plate.nodal("settlement", settlement)


def _press(solution: Solution) -> PressedCells | None:
    """Return the cells that bear the plate, None on ground without such."""
    problem, pressed = solution.system.problem, solution.pressed
    if problem.elastic is None or pressed is None:
        return None
    return press(problem.elastic, pressed.force, problem.loading.beside)


def expand(fields: MeshedFields, frame: ResultMesh) -> tuple[PlateResult, ElementResult, GroundResult]:
    """Return the full plate, its elements and the ground with their fields.

    Where moments and shear forces are singular the nodal ones are means, see `DiscMeans`.
    """
    plate, ground = frame.plate, frame.ground
    nodal = {name: plate.nodal(name, field) for name, field in fields.nodal.items()}
    moments = frame.means.apply_to_moments(np.column_stack([nodal[name] for name in FORCES[:3]]))
    nodal |= dict(zip(FORCES[:3], moments.T, strict=True))
    nodal |= {name: frame.means.apply(nodal[name]) for name in FORCES[3:]}
    elements = {name: plate.by_element(name, field) for name, field in fields.elements.items()}
    section = elements.pop("section").astype(np.int64)
    in_contact = nodal.pop("in_contact") > 0
    return (
        PlateResult(plate.mesh.nodes, plate.mesh.elements, in_contact=in_contact, **nodal),
        ElementResult(section=section, **elements),
        GroundResult(ground.mesh.nodes, ground.mesh.elements, fields.surfaces[:, ground.node], fields.cells),
    )


def support_results(model: Model, solution: Solution) -> tuple[SupportResult, ...]:
    """Return what each support carries."""
    problem, b = solution.system.problem, solution.system.problem.contact.bearing
    if not model.supports:
        return ()
    rest = resistance(solution).all - problem.load
    w = plate_settlement(solution.system, solution.U)
    force = b.law.sign * solution.contact.force
    supports = []
    for number, support in enumerate(model.supports):
        bearings = np.flatnonzero((b.support == number) & (b.field == W))
        nodes = b.node[bearings]
        moments = np.zeros((len(nodes), 2))
        for axis in (0, 1):
            if support.rotation == "fixed":
                moments[:, axis] = rest[nodes, BETA_X + axis]
            turned = np.flatnonzero((b.support == number) & (b.field == BETA_X + axis))
            if len(turned) and len(nodes):
                moments[:, axis] += force[turned]
        supports.append(
            SupportResult(
                name=support.name or Message("support {number}", number=number + 1),
                nodes=problem.mesh.nodes[nodes],
                length=b.length[bearings],
                settlement=w[nodes],
                force=-force[bearings],
                moment_x=moments[:, 0],
                moment_y=moments[:, 1],
            )
        )
    return tuple(supports)


def joint_results(model: Model, solution: Solution) -> tuple[JointResult, ...]:
    """Return what each joint carries from its first plate to its second one."""
    problem, joints = solution.system.problem, list[JointResult]()
    if not model.joints:
        return ()
    force, w = resistance(solution).joints, plate_settlement(solution.system, solution.U)
    for number, joint in enumerate(model.joints):
        of_joint = problem.links.joint == number
        first, second = problem.links.nodes[of_joint].T
        joints.append(
            JointResult(
                name=joint.title,
                nodes=problem.mesh.nodes[first],
                length=problem.links.length[of_joint],
                step=w[first] - w[second],
                force=force[of_joint],
            )
        )
    return tuple(joints)


def _element_fields(problem: Problem, at_points: Array) -> dict[str, Array]:
    """Return the fields at the centers of the plate's elements (mp,) but the pressure, the section's number a float."""
    forces = dict(zip(FORCES, at_points.mean(axis=1).T, strict=True))
    fields = {**forces, "thickness": problem.plate.thickness, "section": problem.plate.section.astype(np.float64)}
    if problem.plate.cracking is not None:
        uncracked = laws(problem).B_I
        B = uncracked if problem.plate.stiffness is None else problem.plate.stiffness
        fields["stiffness_ratio"] = (B / uncracked).min(axis=1)
    return fields


def own_forces(problem: Problem, U: Array, points: Array) -> Array:
    """Return m_x, m_y, m_xy [N m/m], q_x, q_y [N/m] at points (p, 2) of the plate's elements, (mp, p, 5).

    The elements' own, of which nothing is averaged between them; the curvature that they would take freely makes no
    moments. The mean over the 2 x 2 Gauss points is the value at the center.
    """
    sheet, elements = problem.plate, problem.mesh.elements
    D, S, u = sheet.bending[sheet.rigidity], sheet.shear[sheet.rigidity], plate_unknowns(problem, U)
    xy, halves = problem.mesh.nodes[elements[sheet.elements]], find_halves(elements)[sheet.elements]
    forces = plate.section_forces(sheet.element, points, xy, D, S, u, halves)
    forces[..., :3] += np.einsum("eij,ej->ei", D[:, :, :2], problem.loading.free_curvature)[:, None]
    return forces


def own_membrane(problem: Problem, U: Array, points: Array) -> Array:
    """Return n_x, n_y, n_xy [N/m] at points (p, 2) of the plate's elements, (mp, p, 3), the elements' own."""
    sheet = problem.plate
    xy = problem.mesh.nodes[problem.mesh.elements[sheet.elements]]
    return stretching.forces(points, xy, sheet.membrane[sheet.section], membrane_unknowns(problem, U))


def section_forces(frame: ResultMesh, forces: Array) -> dict[str, Array]:
    """Return moments [N m/m] and shear forces [N/m] at the nodes of the plate's mesh from those of elements (mp, 9, 5).

    They are recovered from the 2 x 2 Gauss points, where they are most accurate, by patches (Zienkiewicz and Zhu 1992)
    in the parts of the mesh in which they are smooth, whose nodes stand apart; nodes that are one take the mean.
    """
    mesh = frame.mesh
    n = len(mesh.nodes)
    meeting = np.bincount(mesh.elements.ravel(), minlength=n)
    return {name: scatter(mesh.elements, forces[..., i], n) / meeting for i, name in enumerate(FORCES)}


def ground_constants(solution: Solution) -> Constants:
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
    limit_depth = None if problem.elastic is None else problem.elastic.limit_depth
    return Constants(tuple(map(float, k0)), tuple(map(float, k1)), gamma, solution.gamma_iterations, decay, limit_depth)
