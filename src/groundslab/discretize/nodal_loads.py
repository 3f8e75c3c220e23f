"""From described loads to arrays: forces on nodes, free curvatures of elements, settlements of supports."""

from __future__ import annotations

import math

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.plan_layout import Layout
from groundslab.fem import load_vectors, plate
from groundslab.fem.assembly import scatter
from groundslab.fem.problem import BETA_X, TOP, Loading, W
from groundslab.geometry.plan import FLAT, SAME_PLACE
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads import load_types as loads
from groundslab.model.loads.clipping import clip_line_load, get_plate_region
from groundslab.model.model import Model

#: Points each way by which a load beside the plate acts on an elastic continuum.
POINTS = 100


def loadings(model: Model, plan: Layout, element: plate.PlateElement, fields: int) -> tuple[Loading, ...]:
    """Return the loading of each case of a model, of a nameless one if it has no cases; fields is F."""
    names = [case.name for case in model.cases] or [""]
    return tuple(_loading([load for load in model.loads if load.case == name], model, plan, element, fields)
                 for name in names)  # fmt: skip


def materials(model: Model) -> list[tuple[float, float, float]]:
    """Return E [Pa], nu and thickness [m] of each section: a plate's own, those of its zones, then the next plate's."""
    found: list[tuple[float, float, float]] = []
    for each in model.every_plate:
        found.append((each.E, each.nu, each.thickness))
        for zone in each.zones:
            t = each.thickness if zone.thickness is None else zone.thickness
            found.append((each.E if zone.E is None else zone.E, each.nu if zone.nu is None else zone.nu, t))
    return found


def _loading(
    acting: list[loads.AnyLoad], model: Model, plan: Layout, element: plate.PlateElement, fields: int
) -> Loading:
    """Return the loading of some loads; distributed ones are integrated exactly over the meshed part of the plate."""
    mesh, elements = plan.mesh, plan.plate_elements
    n = len(mesh.nodes)
    forces, couples, size = (
        np.zeros((len(elements), 9)),
        np.zeros((2, len(elements), 9)),
        np.zeros(len(model.every_plate)),
    )
    beside, pressing = np.zeros(n), [np.zeros((0, 3))]
    length = plan.plate_lengths
    warp, settlement = np.zeros(len(elements)), np.zeros(len(model.supports))
    thickness = np.array([t for _, _, t in materials(model)])[plan.section]
    expansion = np.array([each.thermal_expansion for each in model.every_plate])[plan.plate]
    for load in acting:
        if isinstance(load, loads.TemperatureLoad):
            # u = -z beta_x, and the bottom, z = t/2, is warmer by the difference
            warp -= _on_plate(load, model, plan) * expansion * load.difference / thickness
        elif isinstance(load, loads.ShrinkageLoad):
            # as if the top were colder by the difference over the thermal expansion
            warp -= _on_plate(load, model, plan) * (load.top - load.bottom) / thickness
        elif isinstance(load, loads.SettlementLoad):
            settlement[[support.name for support in model.supports].index(load.support)] += load.w
        elif isinstance(load, loads.PointLoad):
            force, couple = _at_point(load.on(model.columns), model, plan)
            forces, couples = forces + force, couples + couple
            size += _by_plate(force, plan) + _by_plate(np.abs(couple).sum(axis=0), plan) / length
        elif loads.presses_ground(load):
            beside += _on_ground(load, plan)
            pressing.append(_points_on_ground(load, model))
        else:
            force = _spread(load, model, plan, thickness)
            forces += force
            size += _by_plate(force, plan)
    if not element.center_w:
        forces = np.einsum("ea,eab->eb", forces, element.w_functions(mesh.xy[elements]))
    table = np.zeros((n, fields))
    table[:, W], table[:, TOP] = scatter(mesh.elements[elements], forces, n), beside
    # under the edge of the plate, too, the ground's surface settles by the sum of both
    if not isinstance(model.ground, ContinuousGround):
        table[plan.plate_nodes, W] += beside[plan.plate_nodes]
    if warp.any():
        D = np.array([plate.bending_rigidity(E, nu, t) for E, nu, t in materials(model)])[plan.section]
        couples = couples + plate.free_couples(mesh.xy[elements], D, np.column_stack([warp, warp]))
    for axis in (0, 1):
        if couples[axis].any():
            table[:, BETA_X + axis] = scatter(mesh.elements[elements], couples[axis], n)
    return Loading(table, np.column_stack([warp, warp]), settlement, size, np.vstack(pressing))


def _by_plate(forces: Array, plan: Layout) -> Array:
    """Return the sum of sizes of nodal forces (mp, 9) on each plate, (plates,)."""
    return scatter(plan.plate, np.abs(forces).sum(axis=1), len(plan.plate_lengths))


def _on_ground(load: loads.OnGround, plan: Layout) -> Array:
    """Return the nodal forces (n,) [N] of a load on the meshed ground beside the plate."""
    mesh = plan.mesh
    elements = np.setdiff1d(np.arange(len(mesh.elements)), plan.plate_elements)
    pressure, area = loads.pressure_function(load), load.to_shapely(math.inf)
    forces = load_vectors.integrate_over_polygon(mesh, elements, area, pressure)
    return scatter(mesh.elements[elements], forces, len(mesh.nodes))


def _points_on_ground(load: loads.OnGround, model: Model) -> Array:
    """Return places x, y [m] and forces [N] (f, 3) that together make a load on an elastic continuum."""
    if not isinstance(model.ground, ContinuousGround):
        return np.zeros((0, 3))
    from shapely import contains_xy

    shape = load.to_shapely(math.inf).difference(get_plate_region(model.plate, model.plates).grown)
    x0, y0, x1, y1 = shape.bounds
    steps = np.arange(0.5, POINTS) / POINTS
    x, y = np.meshgrid(x0 + (x1 - x0) * steps, y0 + (y1 - y0) * steps)
    within = contains_xy(shape, x, y)
    places = np.column_stack([x[within], y[within]])
    return np.column_stack([places, loads.pressure_function(load)(places) * shape.area / len(places)])


def _spread(
    load: loads.UniformLoad | loads.PatchLoad | loads.AreaLoad | loads.LineLoad | loads.SelfWeight,
    model: Model,
    plan: Layout,
    thickness: Array,
) -> Array:
    """Return the nodal forces (mp, 9) [N] of a distributed load on the meshed part of the plate."""
    mesh, elements = plan.mesh, plan.plate_elements
    if isinstance(load, loads.SelfWeight):
        weight = _on_plate(load, model, plan) * load.unit_weight * thickness
        return weight[:, None] * load_vectors.integrate_over_elements(mesh, elements)
    if isinstance(load, loads.LineLoad):
        total = np.zeros((len(elements), 9))
        for piece in clip_line_load(model.plate, load, model.plates):
            total += load_vectors.integrate_along_line(mesh, elements, piece.edge, piece.q)
        return total
    pressure = loads.pressure_function(load)
    if isinstance(load, loads.UniformLoad):
        return _on_plate(load, model, plan)[:, None] * load_vectors.integrate_over_elements(mesh, elements, pressure)
    return load_vectors.integrate_over_polygon(mesh, elements, load.to_shapely(math.inf), pressure)


def _on_plate(load: loads.OnEveryPlate, model: Model, plan: Layout) -> Array:
    """Return 1.0 for the elements of the plate that a load names, of all plates if it names none, else 0.0, (mp,)."""
    names = np.array([plate.name for plate in model.every_plate])
    return np.where((load.plate == "") | (names == load.plate)[plan.plate], 1.0, 0.0)


def _at_point(load: loads.PointLoad, model: Model, plan: Layout) -> tuple[Array, Array]:
    """Return nodal forces (mp, 9) [N] and couples (2, mp, 9) [N m] of a load at a point or on its footprint.

    On a footprint a force is a uniform pressure, a moment one that grows linearly from the middle.
    """
    mesh, elements = plan.mesh, plan.plate_elements
    place = load.to_shapely(FLAT * max(model.sides))
    none = np.zeros((2, len(elements), 9))
    if place.geom_type == "Point":
        N = _share(load, plan) * load_vectors.integrate_at_point(mesh, elements, _on_meshed_side(load, plan))
        return load.P * N, np.array([load.M_x * N, load.M_y * N])
    centre, inertia = load_vectors.inertia(place)
    slope = np.array([load.M_x, load.M_y]) @ np.linalg.inv(inertia)

    def pressure(places: Array) -> Array:
        q: Array = load.P / place.area + (places - centre) @ slope
        return q

    return load_vectors.integrate_over_polygon(mesh, elements, place, pressure), none


def _share(load: loads.PointLoad, plan: Layout) -> float:
    """Return the share of a point load that the meshed part takes: none beyond a mirror, half on it, else all."""
    near = SAME_PLACE * np.ptp(plan.mesh.nodes, axis=0).max()
    share = 1.0
    for value, mirrored in zip((load.x, load.y), plan.symmetry, strict=True):
        assert value is not None
        if mirrored:
            share *= 0.0 if value < -near else 0.5 if value <= near else 1.0
    return share


def _on_meshed_side(load: loads.PointLoad, plan: Layout) -> Array:
    """Return the place (2,) of a point load or of its meshed mirror image, on the plate to the last digit."""
    given = np.array([load.x, load.y])
    place = np.where(plan.symmetry, np.abs(given), given)
    nodes = plan.mesh.nodes[plan.mesh.elements[plan.plate_elements]]
    return np.clip(place, nodes.min(axis=(0, 1)), nodes.max(axis=(0, 1)))
