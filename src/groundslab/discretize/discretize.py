"""Converts a Model into the arrays of a Problem."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.discretize.beams import MembersAcross, beams_on, members_across, with_in_plane, with_turning
from groundslab.discretize.building import building_on, with_building
from groundslab.discretize.constraints import (
    JointLine,
    concatenate,
    fixed_nodes,
    ground_bearing,
    joined_nodes,
    joint_lines,
    make_links,
    slip_bearing,
    support_bearing,
)
from groundslab.discretize.continuum.pressure_cells import elastic_ground
from groundslab.discretize.cracking import cracked_sections
from groundslab.discretize.ground import Factors, carries_shear, ground_under, grounds_of, surfaces_of
from groundslab.discretize.nodal_loads import loadings, materials
from groundslab.discretize.plan_layout import AXIS, OUTWARD, Layout, Meshes, layout
from groundslab.discretize.voids import find_depths, initial_gap
from groundslab.fem import plate
from groundslab.fem.assembly import number_unknowns
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import sides_on_boundary
from groundslab.fem.parts.beams import Beams
from groundslab.fem.parts.contact import Bearing, ContactConditions, Depths
from groundslab.fem.parts.membrane import membrane_rigidity
from groundslab.fem.parts.plates import Plates
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, Loading, Problem, W
from groundslab.geometry.plan import SAME_PLACE
from groundslab.messages import Message
from groundslab.model.ground import ContinuousGround
from groundslab.model.model import Model
from groundslab.model.plate import Plate

#: Parts of a model on which the loading of a mesh depends.
ACTING = ("plate", "plates", "columns", "walls", "cores", "beams", "supports", "cases", "loads")


def discretize(
    model: Model,
    coarsening: int = 0,
    margin: float = 1.0,
    meshes: Meshes | None = None,
    factors: Factors | None = None,
    like: tuple[Model, Problem] | None = None,
    loaded: bool = True,
) -> Problem:
    """Return the arrays of a model; `coarsening` halves the counts so many times; `margin` widens the ground beyond.

    The mesh is reused from `meshes` if it has one of that shape, the loading from a similar model if its loads are the
    same. `factors` multiply constants of the ground from place to place. Without `loaded` nothing acts on the problem.
    """
    plan = layout(model, grounds_of(model), coarsening, margin, meshes or Meshes())
    ground, constants = ground_under(model, plan.mesh, plan.plate_elements, factors, plan.mesh_plan.followed_zones)
    element = plate.ELEMENTS[model.plate.element]
    surfaces = surfaces_of(ground)
    lines = joint_lines(model, plan, surfaces)
    present = _with_slips(_present(model, plan, element, surfaces), lines)
    beams = beams_on(model, plan, materials(model), present.shape[1])
    present, in_plane = with_in_plane(model, with_turning(present, beams), plan, beams)
    building = building_on(model, plan, element, present)
    present = with_building(present, building)
    members = members_across(model, plan, beams, in_plane, fields := present.shape[1])
    cases = _cases(model, plan, beams, element, fields, like, loaded)
    unknown = _numbered(model, plan, lines, members, present)
    below, gap = find_depths(model, plan, ground, coarsening == 0), initial_gap(model, plan)
    of_ground = ground_bearing(model, plan, unknown, below, ground, gap)
    bearing = concatenate(of_ground, support_bearing(model, plan, unknown), slip_bearing(model, lines, unknown))
    edges, corners = _infinite_edges(model, plan)
    return Problem(
        mesh=plan.mesh,
        plate=_plates(model, plan, element, bool(in_plane)),
        ground=ground,
        constants=constants,
        rank=plan.rank,
        unknown=unknown,
        surfaces=surfaces,
        cases=cases,
        loading=sum(cases[1:], cases[0]),
        contact=_contact(model, gap, below, bearing),
        shear_at_edges=carries_shear(ground),
        links=make_links(model, plan, lines, members, surfaces, carries_shear(ground)),
        beams=beams,
        in_plane=in_plane,
        building=building,
        edges=edges,
        corners=corners,
        mesh_plan=plan.mesh_plan,
        origin=model.origin,
        elastic=elastic_ground(model, plan, element, coarsening, bearing, cases),
    )


def _plates(model: Model, plan: Layout, element: plate.PlateElement, in_plane: bool) -> Plates:
    """Return the plates with their sections; in_plane says whether they stretch."""
    sections = _with_shear_factors(model)
    centers = plan.mesh.nodes[plan.mesh.elements[plan.plate_elements, -1]]
    return Plates(
        elements=plan.plate_elements,
        nodes=plan.plate_nodes,
        element=element,
        bending=np.array([plate.bending_rigidity(E, nu, t) for E, nu, t, _ in sections]),
        shear=np.array([plate.shear_rigidity(*section) for section in sections]),
        membrane=np.array([membrane_rigidity(E, nu, t) for E, nu, t, _ in sections if in_plane]).reshape(-1, 3, 3),
        rigidity=plan.section,
        section=plan.section,
        number=plan.plate,
        names=tuple(sheet.name or Message("plate {n}", n=n) for n, sheet in enumerate(model.every_plate, start=1)),
        thickness=np.array([t for _, _, t, _ in sections])[plan.section],
        edges=plan.plate_edges,
        cracking=cracked_sections(model, plan.section, centers),
    )


def _with_shear_factors(model: Model) -> list[tuple[float, float, float, float]]:
    """Return E [Pa], nu, thickness [m] and shear factor of each section."""
    factors = [slab.shear_factor for slab in model.every_plate for _ in (slab, *slab.zones)]
    return [(*material, factor) for material, factor in zip(materials(model), factors, strict=True)]


def _contact(model: Model, gap: Array, below: Depths, bearing: Bearing) -> ContactConditions:
    """Return the conditions of contact; the gap (n,) [m] is that without the depth of voids."""
    most = model.contact.limit_pressure
    return ContactConditions(
        initial_gap=gap + np.where(np.isfinite(below.depth), below.depth, 0.0)[below.shallowest],
        depths=below,
        bearing=bearing,
        tensionless=model.contact.tensionless,
        limit_pressure=np.inf if most is None else most,
    )


def _cases(
    model: Model,
    plan: Layout,
    beams: Beams,
    element: plate.PlateElement,
    fields: int,
    like: tuple[Model, Problem] | None,
    loaded: bool,
) -> tuple[Loading, ...]:
    """Return the loading of each case, that of a similar model if its loads are the same; fields is F."""
    if like is not None:
        earlier, problem = like
        if (
            problem.mesh is plan.mesh
            and problem.plate.element is element
            and problem.load.shape[1] == fields
            and all(getattr(earlier, name) == getattr(model, name) for name in ACTING)
        ):
            return problem.cases
    acting = model if loaded else model.model_copy(update={"cases": (), "loads": ()})
    return loadings(acting, plan, beams, element, fields)


def _infinite_edges(model: Model, plan: Layout) -> tuple[Integers, Integers]:
    """Return the outer sides (e, 3: end, end, middle) and corner nodes (c,) beyond which the ground is infinite."""
    if model.beyond.kind != "infinite" or isinstance(model.ground, ContinuousGround):
        return np.zeros((0, 3), dtype=np.int64), np.zeros(0, dtype=np.int64)
    across_x, across_y = (plan.outer[plan.outer_axis == axis] for axis in (0, 1))
    return plan.outer, np.intersect1d(across_x, across_y)


def _present(model: Model, plan: Layout, element: plate.PlateElement, surfaces: int) -> Flags:
    """Return which unknowns exist and are not fixed at zero, (n, F)."""
    mesh, plate_elements, symmetry = plan.mesh, plan.plate_elements, plan.symmetry
    n = len(mesh.nodes)
    under = np.zeros(n, dtype=bool)
    under[mesh.elements[plate_elements]] = True
    present = np.ones((n, TOP + surfaces), dtype=bool)
    present[:, :TOP] = under[:, None]
    present[:, TOP] = model.contact.tensionless | ~under
    present[find_hanging(mesh.elements)[:, 0]] = False
    if isinstance(model.ground, ContinuousGround):
        present[:, TOP] = False  # what it settles follows from the pressures
    if not element.center_w:
        present[mesh.elements[plate_elements, 8], W] = False

    first = np.zeros(n, dtype=bool)
    first[mesh.elements[plate_elements[plan.plate == 0]]] = True
    x0, x1, y0, y1 = model.plate.bounds
    at = {"left": x0, "right": x1, "bottom": y0, "top": y1}
    near = SAME_PLACE * max(model.sides)
    for side, axis in AXIS.items():
        along = 1 - axis
        if symmetry[axis] and OUTWARD[side] < 0:
            present[mesh.nodes[:, axis] == 0.0, BETA_X + axis] = False
            continue
        kind = getattr(model.plate.edges, side)
        on_edge = first & (np.abs(mesh.nodes[:, axis] - at[side]) <= near)
        _fix(present, on_edge, kind, along)
    if model.plate.support != "free":
        _fix_outline(present, model.plate, plan)
    present[fixed_nodes(model, plan), BETA_X : BETA_Y + 1] = False
    if model.beyond.kind == "margin" and model.beyond.edge == "fixed":
        present[plan.outer, TOP:] = False
    return present


def _with_slips(present: Flags, lines: list[JointLine]) -> Flags:
    """Return which unknowns exist (n, F), with the slips of joints that have play."""
    fields = max([present.shape[1], *(line.slip + 1 for line in lines)])
    extended = np.pad(present, ((0, 0), (0, fields - present.shape[1])))
    for line in lines:
        if line.slip:
            extended[line.pairs[:, 1], line.slip] = True
    return extended


def _numbered(model: Model, plan: Layout, lines: list[JointLine], members: MembersAcross, present: Flags) -> Integers:
    """Return the numbers of the unknowns that are present, (n, F), which nodes that hold together share."""
    if not (model.joints or len(members.pairs)):
        return number_unknowns(plan.rank, present)
    group, left = joined_nodes(model, lines, members, present)
    return number_unknowns(plan.rank, left, group)


def _fix(present: Flags, nodes: Flags | Integers, kind: str, along: int) -> None:
    """Remove the unknowns that a support along an axis fixes at nodes."""
    if kind in ("hinged", "soft", "clamped"):
        present[nodes, W] = False
    if kind in ("hinged", "clamped"):
        present[nodes, BETA_X + along] = False
    if kind == "clamped":
        present[nodes, BETA_X + 1 - along] = False


def _fix_outline(present: Flags, sheet: Plate, plan: Layout) -> None:
    """Remove the unknowns that a support of the entire outline fixes."""
    sides = sides_on_boundary(plan.mesh.elements[plan.plate_elements])
    ring, nodes = sheet.ring(), plan.mesh.nodes
    near = SAME_PLACE * max(sheet.sides)
    for edge in ring.segments():
        on_edge = sides[(edge.distance(nodes[sides].reshape(-1, 2)) <= near).reshape(-1, 3).all(axis=1)]
        # a hinged edge runs along x or y; the others hold all rotations or none
        _fix(present, on_edge.ravel(), sheet.support, 0 if edge.start[1] == edge.end[1] else 1)
