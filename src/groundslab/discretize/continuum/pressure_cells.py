"""The cells on which ground without an end bears a plate: their size, gaps, voids, limit forces, columns, relief."""

from __future__ import annotations

import math

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.continuum.limit_depth import find_limit_depth, overburden
from groundslab.discretize.continuum.piles import pile_group
from groundslab.discretize.ground import deeper_at, medium_of
from groundslab.discretize.interpolation import interpolate_linearly, interpolate_smoothly
from groundslab.discretize.plan_layout import Layout
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.cells import Cells, Grid, cover, make_grid
from groundslab.fem.continuum.elastic_ground import Columns, ElasticGround, Relief, make_operator
from groundslab.fem.continuum.media import Medium
from groundslab.fem.hanging import connect
from groundslab.fem.parts.contact import Bearing
from groundslab.fem.plate import PlateElement
from groundslab.fem.problem import Loading, W
from groundslab.fem.shape_functions import areas
from groundslab.model.ground import ConstrainedModulus, ContinuousGround
from groundslab.model.model import Model
from groundslab.model.plates.pits import pits_of
from groundslab.model.shapes import CHORD

#: Cells along the side of an element of mean area.
CELLS_PER_SIDE = 2
#: At most so many cells, which a grid over the rectangle around a plate has.
MOST_CELLS = 1_000_000


def elastic_ground(
    model: Model, plan: Layout, element: PlateElement, coarsening: int, bearing: Bearing, cases: tuple[Loading, ...]
) -> ElasticGround | None:
    """Return the elastic continuum under a plate with its cells, None if the ground is none.

    `coarsening` doubles the side of given cells so many times; all load cases together give the limit depth. Raises
    InputError for a void without a cell on the finest mesh, and for more than MOST_CELLS cells.
    """
    ground = model.ground
    if not isinstance(ground, ContinuousGround):
        return None
    elements = plan.mesh.elements[plan.plate_elements]
    xy = plan.mesh.nodes[elements]
    grid = make_grid(model.bounds, _size(ground, areas(xy), coarsening))
    if grid.nx * grid.ny > MOST_CELLS:
        count = f"{grid.nx} x {grid.ny} cells of pressure"
        raise InputError([Issue("ground.cell", count, f"at most {MOST_CELLS:,} cells", "larger cells, or elements")])
    moving, kind, P, _ = connect(plan.mesh.elements)
    numbers = plan.plate_elements
    w = element.w_functions(xy) @ P[kind[numbers]]
    cells = cover(grid, xy, elements, len(plan.mesh.nodes), w, plan.plate, moving[numbers])
    void = _depths(model, cells.center, coarsening == 0)
    limit = math.inf if model.contact.limit_pressure is None else model.contact.limit_pressure
    load = sum(float(case.load[:, W].sum()) for case in cases)
    depth = find_limit_depth(ground, cells, load) if isinstance(ground, ConstrainedModulus) else None
    medium = medium_of(ground, ground.layers, depth or math.inf)
    columns = None
    if model.boreholes or (isinstance(ground, ConstrainedModulus) and any(map(pits_of, model.every_plate))):
        columns = _columns(ground, model, medium, grid, cells, depth or math.inf)
    return ElasticGround(
        medium, cells, make_operator(medium, grid), _gaps(model, cells, np.where(np.isinf(void), 0.0, void)),
        np.where(np.isinf(void), 0.0, limit * cells.area), columns, _relief(model, cells), depth,
        pile_group(model, bearing, cells),
    )  # fmt: skip


def _size(ground: ContinuousGround, areas: Array, coarsening: int) -> float:
    """Return the side of the cells [m]: given, or half that of an element of mean area."""
    if ground.cell is not None:
        return ground.cell * 2.0**coarsening
    return float(np.sqrt(areas.mean())) / CELLS_PER_SIDE


def _gaps(model: Model, cells: Cells, void: Array) -> Array:
    """Return the initial gap of cells (c,) [m], with voids of some depth (c,) [m]."""
    gap = model.contact.gap + void
    if model.contact.gaps:
        points = np.array([(point.x, point.y, point.gap) for point in model.contact.gaps])
        gap = gap + interpolate_smoothly(points[:, :2], points[:, 2], cells.center)
    return gap


def _columns(ground: ContinuousGround, model: Model, mean: Medium, grid: Grid, cells: Cells, depth: float) -> Columns:
    """Return the columns of boreholes, between which settlements are interpolated as layers are elsewhere.

    Under pits they begin at the undersides of these.
    """
    holes = [hole.layers for hole in model.boreholes] or [ground.layers]
    at_holes = np.array([(hole.x, hole.y) for hole in model.boreholes] or [(0.0, 0.0)])
    levels = np.unique([0.0, *(pit.deeper for plate in model.every_plate for pit in pits_of(plate))])
    media = tuple(medium_of(ground, layers, depth, above) for above in levels.tolist() for layers in holes)

    def weights_at(places: Array) -> Array:
        weights = interpolate_linearly(at_holes, np.eye(len(holes)), places) if model.boreholes else np.ones((1, 1))
        of_level = np.searchsorted(levels, deeper_at(model, places))[:, None] == np.arange(len(levels))
        normalized: Array = of_level[:, :, None] * (weights / weights.sum(axis=1, keepdims=True))[:, None, :]
        return normalized.reshape(len(places), -1)

    weights = weights_at(cells.center)
    # waves as long as the plate settle most
    k = np.array([np.pi / max(grid.nx * grid.dx, grid.ny * grid.dy)])
    ratios = np.array([float((medium.compliance(k) / mean.compliance(k))[0]) for medium in media])
    operators = tuple(make_operator(medium, grid) for medium in media)
    return Columns(media, operators, weights_at, weights, np.sqrt(weights @ ratios))


def _relief(model: Model, cells: Cells) -> Relief | None:
    """Return what the excavation has taken off: under a pit also the soil above it, where its weight is given."""
    ground = model.ground
    if not isinstance(ground, ConstrainedModulus) or ground.reloading is None:
        return None
    relief = np.full(len(cells.center), ground.relief)
    if ground.unit_weight is not None:
        relief = overburden(ground, deeper_at(model, cells.center))
    return Relief(relief * cells.area, ground.reloading)


def _depths(model: Model, places: Array, finest: bool) -> Array:
    """Return how much deeper voids are at places (c, 2) [m], infinite over cavities; the deepest counts."""
    from shapely import contains_xy

    depth, lost = np.zeros(len(places)), []
    for number, (void, ring) in enumerate(zip(model.contact.voids, model.void_rings, strict=True), start=1):
        within = contains_xy(ring.polygon(CHORD * max(model.plate.sides)), places[:, 0], places[:, 1])
        depth[within] = np.maximum(depth[within], math.inf if void.depth is None else void.depth)
        if finest and not within.any():
            lost.append(Issue(f"contact.voids[{number}]", "a void between cells of pressure", "one that takes a cell",
                              "make the elements, or ground.cell, smaller than the void"))  # fmt: skip
    if lost:
        raise InputError(lost)
    return depth
