"""From described loads to arrays: forces on nodes, free curvatures of elements, settlements of supports."""

from __future__ import annotations

import math

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.plan_layout import Layout
from groundslab.fem import load_vectors, plate
from groundslab.fem.assembly import scatter
from groundslab.fem.hanging import collect
from groundslab.fem.parts.beams import Beams
from groundslab.fem.parts.spans import COLUMNS, end_forces, from_to
from groundslab.fem.problem import BETA_X, TOP, Loading, W
from groundslab.geometry.plan import FLAT, SAME_PLACE
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.acting import (
    Acting,
    AreaPressure,
    LineForce,
    PlateAction,
    PointForce,
    SupportSettlement,
)
from groundslab.model.loads.clipping import pieces_on_spans
from groundslab.model.loads.spreading import spread_line
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region

#: Points each way by which a load beside the plate acts on an elastic continuum.
POINTS = 100


def loadings(model: Model, plan: Layout, beams: Beams, element: plate.PlateElement, fields: int) -> tuple[Loading, ...]:
    """Return the loading of each case of a model, of a nameless one if it has no cases; fields is F."""
    acting: dict[str, list[Acting]] = {name: [] for name in [case.name for case in model.cases] or [""]}
    for load, shape in model.acting:
        acting[load.case].append(shape)
    return tuple(_loading(shapes, model, plan, beams, element, fields) for shapes in acting.values())


def materials(model: Model) -> list[tuple[float, float, float]]:
    """Return E [Pa], nu and thickness [m] of each section: a plate's own, those of its zones, then the next plate's."""
    sections: list[tuple[float, float, float]] = []
    for slab in model.every_plate:
        sections.append((slab.E, slab.nu, slab.thickness))
        for zone in slab.zones:
            t = slab.thickness if zone.thickness is None else zone.thickness
            sections.append((slab.E if zone.E is None else zone.E, slab.nu if zone.nu is None else zone.nu, t))
    return sections


def _loading(
    acting: list[Acting], model: Model, plan: Layout, beams: Beams, element: plate.PlateElement, fields: int
) -> Loading:
    """Return the loading of some shapes; distributed ones are integrated exactly over the meshed part of the plate."""
    mesh = plan.mesh
    elements = plan.plate_elements
    n = len(mesh.nodes)
    forces = np.zeros((len(elements), 9))
    couples = np.zeros((2, len(elements), 9))
    size, lengths = np.zeros(len(model.every_plate)), plan.plate_lengths
    beside = np.zeros(n)
    pressing = [np.zeros((0, 3))]
    warp = np.zeros(len(elements))
    settlement = np.zeros(len(model.supports))
    spans, on_spans = model.spans, [np.zeros((0, COLUMNS))]
    for shape in acting:
        if isinstance(shape, SupportSettlement):
            settlement[[support.name for support in model.supports].index(shape.support)] += shape.w
        elif isinstance(shape, AreaPressure) and shape.on == "ground":
            beside += _on_ground(shape, plan)
            pressing.append(_points_on_ground(shape, model))
        else:
            force, couple = _on_plate(shape, model, plan)
            forces += force
            couples += couple
            acts = np.abs(force).sum(axis=1), np.abs(couple).sum(axis=(0, 2))
            of_forces, of_couples = (scatter(plan.plate, values, len(size)) for values in acts)
            size += of_forces + of_couples / lengths
            if isinstance(shape, PlateAction):
                warp += _warp(shape, model, plan)
            if isinstance(shape, LineForce):
                for number, piece in pieces_on_spans(shape, spans):
                    start, end = (math.dist(spans[number].start, at) for at in (piece.edge.start, piece.edge.end))
                    on_spans.append(from_to(number, start, end, piece.q, piece.m))
    if not element.center_w:
        forces = np.einsum("ea,eab->eb", forces, element.w_functions(mesh.xy[elements]))
    table = np.zeros((n, fields))
    table[:, W] = scatter(mesh.elements[elements], forces, n)
    table[:, TOP] = beside
    # under the edge of the plate, too, the ground's surface settles by the sum of both
    if not isinstance(model.ground, ContinuousGround):
        table[plan.plate_nodes, W] += beside[plan.plate_nodes]
    if warp.any():
        D = np.array([plate.bending_rigidity(E, nu, t) for E, nu, t in materials(model)])[plan.section]
        couples = couples + plate.free_couples(mesh.xy[elements], D, np.column_stack([warp, warp]))
    for axis in (0, 1):
        if couples[axis].any():
            table[:, BETA_X + axis] = scatter(mesh.elements[elements], couples[axis], n)
    table = collect(mesh.elements, table)
    of_spans = np.vstack(on_spans)
    if len(of_spans):
        force, turning, twisting = end_forces(beams, of_spans)
        _add_from_spans(table, beams, mesh.nodes, (force, turning, twisting))
        plate_at = np.full(n, -1)
        plate_at[mesh.elements[elements]] = plan.plate[:, None]
        under = plate_at[beams.sides[beams.spans, 0]]
        np.add.at(
            size, under, np.abs(force).sum(axis=1) + np.abs([turning, twisting]).sum(axis=(0, 2)) / lengths[under]
        )
    return Loading(table, np.column_stack([warp, warp]), settlement, size, np.vstack(pressing), of_spans)


def _add_from_spans(table: Array, beams: Beams, nodes: Array, at_ends: tuple[Array, Array, Array]) -> None:
    """Add to nodal loads (n, F) what spans bring to their ends, as `end_forces` returns it, between nodes (n, 2)."""
    spans = np.flatnonzero(beams.spans)
    deep = beams.theta[spans]
    way = nodes[beams.sides[spans, 1]] - nodes[beams.sides[spans, 0]]
    t = way / np.linalg.norm(way, axis=1, keepdims=True)
    n = np.column_stack([-t[:, 1], t[:, 0]])
    for end in (0, 1):
        node, (force, turning, twisting) = beams.sides[spans, end], (values[:, end] for values in at_ends)
        np.add.at(table, (node, W), force)
        # of a wall, whose direction may be against that of its span, the couple turns its sections
        couples = turning * (t * beams.along[spans, end]).sum(axis=1)
        np.add.at(table, (node[deep > 0], deep[deep > 0]), couples[deep > 0])
        couple = np.where(deep > 0, 0.0, turning)[:, None] * t + twisting[:, None] * n
        for axis in (0, 1):
            np.add.at(table, (node, BETA_X + axis), couple[:, axis])


def _on_ground(area: AreaPressure, plan: Layout) -> Array:
    """Return the nodal forces (n,) [N] of a pressure on the meshed ground beside the plate."""
    mesh = plan.mesh
    beside = np.ones(len(mesh.elements), dtype=bool)
    beside[plan.plate_elements] = False
    elements = np.flatnonzero(beside)
    forces = load_vectors.integrate_over_polygon(mesh, elements, area.to_shapely(), area.pressure)
    return scatter(mesh.elements[elements], forces, len(mesh.nodes))


def _points_on_ground(area: AreaPressure, model: Model) -> Array:
    """Return places x, y [m] and forces [N] (f, 3) that together make a pressure on an elastic continuum."""
    if not isinstance(model.ground, ContinuousGround):
        return np.zeros((0, 3))
    from shapely import contains_xy

    shape = area.to_shapely().difference(get_plate_region(model.plate, model.plates).grown)
    x0, y0, x1, y1 = shape.bounds
    steps = np.arange(0.5, POINTS) / POINTS
    x, y = np.meshgrid(x0 + (x1 - x0) * steps, y0 + (y1 - y0) * steps)
    within = contains_xy(shape, x, y)
    places = np.column_stack([x[within], y[within]])
    return np.column_stack([places, area.pressure(places) * shape.area / len(places)])


def _on_plate(
    shape: PointForce | LineForce | AreaPressure | PlateAction, model: Model, plan: Layout
) -> tuple[Array, Array]:
    """Return nodal forces (mp, 9) [N] and couples (2, mp, 9) [N m] on the meshed part of the plate."""
    mesh = plan.mesh
    elements = plan.plate_elements
    no_couples = np.zeros((2, len(elements), 9))
    if isinstance(shape, PointForce):
        return _at_point(shape, model, plan)
    if isinstance(shape, LineForce):
        forces = np.zeros((len(elements), 9))
        couples = no_couples
        along, areas = spread_line(model.plate, shape, model.plates)
        for area, pressure in areas:
            forces += load_vectors.integrate_over_polygon(mesh, elements, area, pressure)
        for piece in along:
            if any(piece.q):
                forces += load_vectors.integrate_along_line(mesh, elements, piece.edge, piece.q)
            if any(piece.m):
                couples = couples + load_vectors.integrate_couple_along_line(mesh, elements, piece.edge, piece.m)
        return forces, couples
    if isinstance(shape, AreaPressure):
        return load_vectors.integrate_over_polygon(mesh, elements, shape.to_shapely(), shape.pressure), no_couples
    forces = load_vectors.integrate_over_elements(mesh, elements, shape.pressure)
    if shape.unit_weight:
        weight = shape.unit_weight * _thickness(model, plan)
        forces += weight[:, None] * load_vectors.integrate_over_elements(mesh, elements)
    return _takes_part(shape, model, plan)[:, None] * forces, no_couples


def _takes_part(action: PlateAction, model: Model, plan: Layout) -> Array:
    """Return 1.0 for the elements of the plate that an action names, or of all plates, else 0.0, (mp,)."""
    names = np.array([plate.name for plate in model.every_plate])
    return np.where((action.plate == "") | (names == action.plate)[plan.plate], 1.0, 0.0)


def _thickness(model: Model, plan: Layout) -> Array:
    """Return the thickness of the elements of the plate (mp,) [m]."""
    return np.array([t for _, _, t in materials(model)])[plan.section]


def _warp(action: PlateAction, model: Model, plan: Layout) -> Array:
    """Return the free curvature of the elements of the plate (mp,) [1/m], the same along x and y."""
    expansion = np.array([plate.thermal_expansion for plate in model.every_plate])[plan.plate]
    # u = -z beta_x, and the bottom, z = t/2, is warmer; shrinkage is as if the top were colder
    strain = expansion * action.temperature + action.shrinkage
    return -_takes_part(action, model, plan) * strain / _thickness(model, plan)


def _at_point(force: PointForce, model: Model, plan: Layout) -> tuple[Array, Array]:
    """Return nodal forces (mp, 9) [N] and couples (2, mp, 9) [N m] of a force at a point or on its footprint.

    On a footprint a force is a uniform pressure, a couple one that grows linearly from the middle.
    """
    mesh = plan.mesh
    elements = plan.plate_elements
    place = force.to_shapely(FLAT * max(model.sides))
    if force.ring is None:
        N = _share(force, plan) * load_vectors.integrate_at_point(mesh, elements, _on_meshed_side(force, plan))
        M_x, M_y = force.M
        return force.P * N, np.array([M_x * N, M_y * N])
    forces = load_vectors.integrate_over_polygon(mesh, elements, place, force.pressure(place))
    return forces, np.zeros((2, len(elements), 9))


def _share(force: PointForce, plan: Layout) -> float:
    """Return the share of a force that the meshed part takes: none beyond a mirror, half on it, else all."""
    near = SAME_PLACE * np.ptp(plan.mesh.nodes, axis=0).max()
    share = 1.0
    for value, mirrored in zip(force.place, plan.symmetry, strict=True):
        if mirrored:
            share *= 0.0 if value < -near else 0.5 if value <= near else 1.0
    return share


def _on_meshed_side(force: PointForce, plan: Layout) -> Array:
    """Return the place (2,) of a force or of its meshed mirror image, on the plate to the last digit."""
    point = np.array(force.place)
    place = np.where(plan.symmetry, np.abs(point), point)
    nodes = plan.mesh.nodes[plan.mesh.elements[plan.plate_elements]]
    return np.clip(place, nodes.min(axis=(0, 1)), nodes.max(axis=(0, 1)))
