"""The cells on which an elastic continuum bears a plate: their size, gaps, voids, limit forces."""

from __future__ import annotations

import math

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.borders import void_rings
from groundslab.discretize.ground import elastic_layers
from groundslab.discretize.interpolation import interpolate_smoothly
from groundslab.discretize.plan_layout import Layout
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.cells import cover, make_grid
from groundslab.fem.continuum.elastic_ground import ElasticGround, make_operator
from groundslab.fem.plate import PlateElement
from groundslab.fem.shape_functions import areas
from groundslab.model.ground import Continuum
from groundslab.model.model import Model
from groundslab.model.shapes import CHORD

#: Cells along the side of an element of mean area.
CELLS_PER_SIDE = 2
#: At most so many cells, which a grid over the rectangle around a plate has.
MOST_CELLS = 1_000_000


def elastic_ground(model: Model, plan: Layout, element: PlateElement, coarsening: int) -> ElasticGround | None:
    """Return the elastic continuum under a plate with its cells, None if the ground is none.

    `coarsening` doubles the side of given cells so many times. Raises InputError for a void without a cell on the
    finest mesh, and for more than MOST_CELLS cells.
    """
    if not isinstance(model.ground, Continuum):
        return None
    elements = plan.mesh.elements[plan.plate_elements]
    xy = plan.mesh.nodes[elements]
    grid = make_grid(model.plate.bounds, _size(model.ground, areas(xy), coarsening))
    if grid.nx * grid.ny > MOST_CELLS:
        found = f"{grid.nx} x {grid.ny} cells of pressure"
        raise InputError([Issue("ground.cell", found, f"at most {MOST_CELLS:,} cells", "larger cells, or elements")])
    cells = cover(grid, xy, elements, len(plan.mesh.nodes), element.w_functions(xy))
    layers = elastic_layers(model.ground)
    limit = math.inf if model.contact.limit_pressure is None else model.contact.limit_pressure
    depth = _depths(model, cells.center, coarsening == 0)
    gap = np.where(np.isinf(depth), 0.0, depth) + model.contact.gap
    if model.contact.gaps:
        known = np.array([(point.x, point.y, point.gap) for point in model.contact.gaps])
        gap += interpolate_smoothly(known[:, :2], known[:, 2], cells.center)
    return ElasticGround(
        layers, cells, make_operator(layers, grid), gap, np.where(np.isinf(depth), 0.0, limit * cells.area)
    )


def _size(ground: Continuum, areas: Array, coarsening: int) -> float:
    """Return the side of the cells [m]: given, or half that of an element of mean area."""
    if ground.cell is not None:
        return ground.cell * 2.0**coarsening
    return float(np.sqrt(areas.mean())) / CELLS_PER_SIDE


def _depths(model: Model, places: Array, finest: bool) -> Array:
    """Return how much deeper voids are at places (c, 2) [m], infinite over cavities; the deepest counts."""
    from shapely import contains_xy

    depth, lost = np.zeros(len(places)), []
    for number, (void, ring) in enumerate(zip(model.contact.voids, void_rings(model), strict=True), start=1):
        within = contains_xy(ring.polygon(CHORD * max(model.plate.sides)), places[:, 0], places[:, 1])
        depth[within] = np.maximum(depth[within], math.inf if void.depth is None else void.depth)
        if finest and not within.any():
            lost.append(Issue(f"contact.voids[{number}]", "a void between cells of pressure", "one that takes a cell",
                              "make the elements, or ground.cell, smaller than the void"))  # fmt: skip
    if lost:
        raise InputError(lost)
    return depth
