"""From the description of a problem to its arrays: the one door between Model and Problem."""

from __future__ import annotations

import itertools

import numpy as np

from groundslab import loads, plate
from groundslab.actions import AnyLoad, LineLoad, PointLoad, SelfWeight, UniformLoad, Void
from groundslab.assembly import number, scatter
from groundslab.errors import Fault, InputError
from groundslab.layout import AXIS, OUTWARD, Layout, layout
from groundslab.mesh import elimination_order, sides_on_boundary
from groundslab.model import Model
from groundslab.problem import BETA_X, TOP, Problem, W
from groundslab.shape import Array, Flags, Integers
from groundslab.slab import Plate
from groundslab.subsoil import ground_of, surfaces_of

#: Places closer than this, relative to the plate, are the same.
SAME_PLACE = 1e-9
#: Loaded areas have their arcs replaced by chords at most this far off, relative to the plate.
ARC_CHORD = 1e-6


def discretise(model: Model, coarsening: int = 0, margin: float = 1.0) -> Problem:
    """Return the arrays of a model; `coarsening` halves the counts so many times, `margin` widens the ground beyond."""
    ground = ground_of(model)
    plan = layout(model, ground, coarsening, margin)
    element, materials = plate.ELEMENTS[model.plate.element], _materials(model)
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
        bending=np.array([plate.bending_rigidity(E, nu, t) for E, nu, t in materials]),
        shear=np.array([plate.shear_rigidity(E, nu, t, model.plate.shear_factor) for E, nu, t in materials]),
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


def _materials(model: Model) -> list[tuple[float, float, float]]:
    """Return E [Pa], nu and thickness [m] of each section: the plate's own, then those of its zones."""
    own = (model.plate.E, model.plate.nu, model.plate.thickness)
    zones = [(zone.E, zone.nu, zone.thickness) for zone in model.plate.zones]
    differing = [tuple(a if b is None else b for a, b in zip(own, zone, strict=True)) for zone in zones]
    return [own, *differing]  # type: ignore[list-item]


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

    x0, x1, y0, y1 = model.plate.bounds
    at = {"left": x0, "right": x1, "bottom": y0, "top": y1}
    near = SAME_PLACE * max(model.plate.sides)
    for side, axis in AXIS.items():
        along = 1 - axis
        if symmetry[axis] and OUTWARD[side] < 0:
            present[mesh.nodes[:, axis] == 0.0, BETA_X + axis] = False
            continue
        kind = getattr(model.plate.edges, side)
        on_edge = under & (np.abs(mesh.nodes[:, axis] - at[side]) <= near)
        _hold(present, on_edge, kind, along)
    if model.plate.support != "free":
        _hold_outline(present, model.plate, plan)
    if model.beyond.kind == "margin" and model.beyond.edge == "fixed":
        present[plan.outer, TOP:] = False
    return present


def _hold(present: Flags, nodes: Flags | Integers, kind: str, along: int) -> None:
    """Take away the unknowns that a support along an axis holds at nodes."""
    if kind in ("hinged", "soft", "clamped"):
        present[nodes, W] = False
    if kind in ("hinged", "clamped"):
        present[nodes, BETA_X + along] = False
    if kind == "clamped":
        present[nodes, BETA_X + 1 - along] = False


def _hold_outline(present: Flags, sheet: Plate, plan: Layout) -> None:
    """Take away the unknowns that a support of the whole outline holds."""
    sides = sides_on_boundary(plan.mesh.elements[plan.plate_elements])
    ring, nodes = sheet.ring(), plan.mesh.nodes
    near = SAME_PLACE * max(sheet.sides)
    for edge in ring.segments():
        on_edge = sides[(edge.distance(nodes[sides].reshape(-1, 2)) <= near).reshape(-1, 3).all(axis=1)]
        (x0, y0), (x1, y1) = edge.start, edge.end
        if sheet.support == "hinged" and (not edge.straight or (x0 != x1 and y0 != y1)):
            where = f"the edge from ({x0:g}, {y0:g}) to ({x1:g}, {y1:g}) m"
            expected = 'edges along x or y, or support = "soft" (w = 0) or "clamped"'
            raise InputError([Fault("plate.support", f'"hinged" on {where}', expected)])
        _hold(present, on_edge.ravel(), sheet.support, 0 if y0 == y1 else 1)


def _loads(model: Model, plan: Layout, element: plate.PlateElement, fields: int) -> Array:
    """Return the nodal loads (n, F) [N]; distributed ones are integrated exactly over the meshed part of the plate."""
    mesh, plate_elements = plan.mesh, plan.plate_elements
    by_element = np.zeros((len(plate_elements), 9))
    for load in model.loads:
        by_element += _by_element(load, model, plan)
    if not element.centre_w:
        by_element = np.einsum("ea,eab->eb", by_element, element.w_functions(mesh.xy[plate_elements]))
    load_table = np.zeros((len(mesh.nodes), fields))
    load_table[:, W] = scatter(mesh.elements[plate_elements], by_element, len(mesh.nodes))
    return load_table


def _by_element(load: AnyLoad, model: Model, plan: Layout) -> Array:
    """Return the nodal forces (mp, 9) [N] of one load on the meshed part of the plate."""
    mesh, elements = plan.mesh, plan.plate_elements
    if isinstance(load, PointLoad):
        return load.P * _share(load, plan) * loads.at_point(mesh, elements, _on_meshed_side(load, plan))
    if isinstance(load, LineLoad):
        pieces = [loads.along_line(mesh, elements, np.array(piece)) for piece in itertools.pairwise(load.points)]
        along: Array = np.sum(pieces, axis=0)
        return load.q * along
    if isinstance(load, UniformLoad):
        return load.q * loads.over_elements(mesh, elements)
    if isinstance(load, SelfWeight):
        thickness = np.array([t for _, _, t in _materials(model)])[plan.section]
        return load.unit_weight * thickness[:, None] * loads.over_elements(mesh, elements)
    polygon = load.drawn(ARC_CHORD * max(model.plate.sides))
    return load.q * loads.over_polygon(mesh, elements, polygon)


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
    near = SAME_PLACE * max(model.plate.sides)
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
