"""A slab's plan as cells along the axes, and what bars need in each of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import Mesh, MeshLocations, interpolate_bilinear, locate_nearest
from groundslab.results.plate_result import PlateResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Cells of a plan at most: beyond, they are two, three, ... times as wide as the rounding.
MOST_CELLS = 3_000
#: Finer cells over one, along and across.
PARTS = 3
#: A place is on a line between cells if it is no farther from it than this over the width of a cell.
ON_LINE = 1e-6


@dataclass(frozen=True, slots=True)
class PlanGrid:
    """Cells of one width over the bounds of a plan, from its lower left corner.

    Attributes
    ----------
    origin : tuple of float
        That corner [m].
    step : float
        Width of a cell along both axes [m].
    area : array (n_x, n_y)
        What of each cell is in the plan [m2].
    """

    origin: tuple[float, float]
    step: float
    area: Array

    def line(self, axis: int, number: int) -> float:
        """Return where a line between cells is along an axis [m], to the micrometer."""
        return round(self.origin[axis] + number * self.step, 6)


def make_grid(area: BaseGeometry, rounding: float) -> PlanGrid:
    """Return the cells of a plan, as wide as the rounding [m] or, of a large one, a multiple of it."""
    from shapely import area as area_of
    from shapely import box, intersection

    x0, y0, x1, y1 = area.bounds
    sides = np.array([x1 - x0, y1 - y0])
    times = max(1, math.ceil(math.sqrt(sides.prod() / MOST_CELLS) / rounding))
    step = times * rounding
    n_x, n_y = (max(1, math.ceil(side / step - ON_LINE)) for side in sides)
    left, low = np.meshgrid(x0 + step * np.arange(n_x), y0 + step * np.arange(n_y), indexing="ij")
    return PlanGrid((x0, y0), step, area_of(intersection(box(left, low, left + step, low + step), area)))


@dataclass(frozen=True, slots=True)
class CellValues:
    """Where nodal values of a plate lie in the cells of a plan, in cells that are PARTS times finer.

    Attributes
    ----------
    grid : PlanGrid
        The cells.
    plate : PlateResult
        The plate.
    where : tuple of arrays
        The element under the center of each finer cell of the plan, and the place in it.
    centers : array (k, 2)
        Which of the finer cells these are.
    """

    grid: PlanGrid
    plate: PlateResult
    where: MeshLocations
    centers: Integers

    def largest(self, values: Array, axis: int) -> Array:
        """Return the largest of nodal values (n,) in cells, finer along an axis: (PARTS n_x, n_y) or (n_x, PARTS n_y).

        Values are those at nodes in a cell or on its border, and at the centers of the finer cells; 0 off the plan.
        """
        n_x, n_y = self.grid.area.shape
        fine = np.zeros((PARTS * n_x, PARTS * n_y))
        mesh = Mesh(self.plate.nodes, self.plate.elements)
        fine[tuple(self.centers.T)] = np.maximum(interpolate_bilinear(mesh, values, self.where), 0.0)
        position = (self.plate.nodes - self.grid.origin) / self.grid.step * PARTS
        low, high = (np.floor(position + side * ON_LINE).astype(int) for side in (-1, 1))
        for i in (low[:, 0], high[:, 0]):
            for j in (low[:, 1], high[:, 1]):
                within = (i >= 0) & (i < fine.shape[0]) & (j >= 0) & (j < fine.shape[1])
                np.maximum.at(fine, (i[within], j[within]), values[within])
        parts = (n_x * PARTS, n_y, PARTS) if axis == 0 else (n_x, PARTS, n_y * PARTS)
        return np.asarray(fine.reshape(parts).max(axis=2 if axis == 0 else 1))


def locate_cells(grid: PlanGrid, plate: PlateResult) -> CellValues:
    """Return where a plate's nodal values lie in the cells of a plan."""
    inside = np.repeat(np.repeat(grid.area > 0, PARTS, axis=0), PARTS, axis=1)
    centers = np.argwhere(inside)
    places = np.asarray(grid.origin) + grid.step / PARTS * (centers + 0.5)
    return CellValues(grid, plate, locate_nearest(Mesh(plate.nodes, plate.elements), places), centers)


def spread_along(cells: Array, reach: int) -> Array:
    """Return the largest value of cells (m, w) within so many cells before and after each along the first axis."""
    spread = cells.copy()
    for shift in range(1, min(reach, len(cells) - 1) + 1):
        spread[shift:] = np.maximum(spread[shift:], cells[:-shift])
        spread[:-shift] = np.maximum(spread[:-shift], cells[shift:])
    return spread
