"""From the description of a problem to its arrays: the one door between Model and Problem."""

from __future__ import annotations

import numpy as np

from groundslab import loads, plate
from groundslab.assembly import number, scatter
from groundslab.errors import Fault, InputError
from groundslab.layout import AXIS, OUTWARD, Layout, layout
from groundslab.mesh import elimination_order
from groundslab.model import Model, PatchLoad, PointLoad, UniformLoad, Void
from groundslab.problem import BETA_X, TOP, Problem, W
from groundslab.shape import Array, Flags, Integers
from groundslab.subsoil import ground_of, surfaces_of

#: Places closer than this, relative to the plate, are the same.
SAME_PLACE = 1e-9


def discretise(model: Model, coarsening: int = 0, margin: float = 1.0) -> Problem:
    """Return the arrays of a model; `coarsening` halves the counts so many times, `margin` widens the ground beyond."""
    ground = ground_of(model)
    plan = layout(model, ground, coarsening, margin)
    element, sheet = plate.ELEMENTS[model.plate.element], model.plate
    present = _present(model, plan, element, surfaces_of(ground))
    load = _loads(model, plan, element, present.shape[1])
    if not load.any():
        fault = Fault("loads", "loads that are all zero", "at least one load that is not", "nothing would settle")
        raise InputError([fault])
    rank = elimination_order(plan.mesh)
    edges, corners = _infinite_edges(model, plan)
    return Problem(
        mesh=plan.mesh,
        plate_elements=plan.plate_elements,
        element=element,
        bending=plate.bending_rigidity(sheet.E, sheet.nu, sheet.thickness)[None],
        shear=np.array([plate.shear_rigidity(sheet.E, sheet.nu, sheet.thickness, sheet.shear_factor)]),
        section=plan.section,
        ground=ground,
        rank=rank,
        unknown=number(rank, present),
        load=load,
        initial_gap=_initial_gap(model, plan, coarsening == 0),
        tensionless=model.contact.tensionless,
        edges=edges,
        corners=corners,
        symmetry=plan.symmetry,
    )


def _infinite_edges(model: Model, plan: Layout) -> tuple[Integers, Integers]:
    """Return the outer sides (e, 3: end, end, middle) and corner nodes (c,) beyond which the ground is infinite."""
    if model.beyond.kind != "infinite":
        return np.zeros((0, 3), dtype=np.int64), np.zeros(0, dtype=np.int64)
    across_x, across_y = (plan.outer[plan.outer_axis == axis] for axis in (0, 1))
    return plan.outer, np.intersect1d(across_x, across_y)


def _present(model: Model, plan: Layout, element: plate.PlateElement, surfaces: int) -> Flags:
    """Return which unknowns exist and are not held at zero, (n, F)."""
    mesh, plate_elements, symmetry = plan.mesh, plan.plate_elements, plan.symmetry
    n = len(mesh.nodes)
    under = np.zeros(n, dtype=bool)
    under[mesh.elements[plate_elements]] = True
    present = np.ones((n, TOP + surfaces), dtype=bool)
    present[:, :TOP] = under[:, None]
    present[:, TOP] = model.contact.tensionless | ~under
    if not element.centre_w:
        present[mesh.elements[plate_elements, 8], W] = False

    half = np.array([model.plate.length_x, model.plate.length_y]) / 2
    for side, axis in AXIS.items():
        along = 1 - axis
        if symmetry[axis] and OUTWARD[side] < 0:
            present[mesh.nodes[:, axis] == 0.0, BETA_X + axis] = False
            continue
        kind = getattr(model.plate.edges, side)
        on_edge = under & (mesh.nodes[:, axis] == OUTWARD[side] * half[axis])
        if kind in ("hinged", "soft", "clamped"):
            present[on_edge, W] = False
        if kind in ("hinged", "clamped"):
            present[on_edge, BETA_X + along] = False
        if kind == "clamped":
            present[on_edge, BETA_X + axis] = False
    if model.beyond.kind == "margin" and model.beyond.edge == "fixed":
        present[plan.outer, TOP:] = False
    return present


def _loads(model: Model, plan: Layout, element: plate.PlateElement, fields: int) -> Array:
    """Return the nodal loads (n, F) [N]; distributed ones are integrated exactly over the meshed part of the plate."""
    mesh, plate_elements = plan.mesh, plan.plate_elements
    by_element = np.zeros((len(plate_elements), 9))
    for load in model.loads:
        if isinstance(load, PointLoad):
            by_element += (
                load.P * _share(load, plan) * loads.at_point(mesh, plate_elements, _on_meshed_side(load, plan))
            )
        elif isinstance(load, UniformLoad):
            by_element += load.q * loads.over_elements(mesh, plate_elements)
        else:
            by_element += load.q * _over_patch(load, plan)
    if not element.centre_w:
        by_element = np.einsum("ea,eab->eb", by_element, element.w_functions(mesh.xy[plate_elements]))
    load_table = np.zeros((len(mesh.nodes), fields))
    load_table[:, W] = scatter(mesh.elements[plate_elements], by_element, len(mesh.nodes))
    return load_table


def _over_patch(load: PatchLoad, plan: Layout) -> Array:
    """Return the integrals (mp, 9) [m2] of the shape functions over a patch."""
    from shapely import box

    return loads.over_polygon(plan.mesh, plan.plate_elements, box(load.x[0], load.y[0], load.x[1], load.y[1]))


def _share(load: PointLoad, plan: Layout) -> float:
    """Return the share of a point load that the meshed part takes: none beyond a mirror, half on it, else all."""
    near = SAME_PLACE * np.ptp(plan.mesh.nodes, axis=0).max()
    share = 1.0
    for value, mirrored in zip((load.x, load.y), plan.symmetry, strict=True):
        if mirrored:
            share *= 0.0 if value < -near else 0.5 if value <= near else 1.0
    return share


def _on_meshed_side(load: PointLoad, plan: Layout) -> Array:
    """Return the place (2,) of a point load or of its meshed mirror image, on the plate to the last digit."""
    given = np.array([load.x, load.y])
    place = np.where(plan.symmetry, np.abs(given), given)
    nodes = plan.mesh.nodes[plan.mesh.elements[plan.plate_elements]]
    on_plate: Array = np.clip(place, nodes.min(axis=(0, 1)), nodes.max(axis=(0, 1)))
    return on_plate


def _initial_gap(model: Model, plan: Layout, finest: bool) -> Array:
    """Return the initial gap at every node (n,) [m], zero beyond the plate."""
    mesh, plate_elements, symmetry = plan.mesh, plan.plate_elements, plan.symmetry
    gap = np.zeros(len(mesh.nodes))
    under = np.unique(mesh.elements[plate_elements])
    gap[under] = model.contact.gap
    x, y = mesh.nodes[under].T
    extra = np.zeros(len(under))
    near = SAME_PLACE * max(model.plate.length_x, model.plate.length_y)
    faults: list[Fault] = []
    mend = "make the elements smaller than the void"
    for place, void in enumerate(model.contact.voids, start=1):
        inside = (x >= void.x[0] - near) & (x <= void.x[1] + near) & (y >= void.y[0] - near) & (y <= void.y[1] + near)
        if finest and not inside.any() and not _mirrored_away(void, symmetry):
            faults.append(Fault(f"contact.voids[{place}]", "a void between the nodes", "one that holds a node", mend))
        extra = np.where(inside, np.maximum(extra, void.depth), extra)
    if faults:
        raise InputError(faults)
    gap[under] += extra
    return gap


def _mirrored_away(void: Void, symmetry: tuple[bool, bool]) -> bool:
    """Return whether a void lies on the side of a mirror that is not meshed; its image is there."""
    return (symmetry[0] and void.x[1] < 0) or (symmetry[1] and void.y[1] < 0)
