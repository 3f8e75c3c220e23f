"""A slab's plan as cells along the axes, and what bars need in each of them.

Where what is needed is symmetric about the middle of the plan, the two halves are folded onto each other: a cell stands
for itself and its image, with the larger need of both, so that what is found for it is symmetric.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import Mesh, MeshLocations, interpolate_bilinear, locate_nearest
from groundslab.results.plate_result import PlateResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Cells of a plan at most: beyond, they are two, three, ... times as wide as the rounding.
MOST_CELLS = 10_000
#: Finer cells over one, along and across.
PARTS = 3
#: A place is on a line between cells if it is no farther from it than this over the width of a cell.
ON_LINE = 1e-6
#: Needs are symmetric if what they are above their mean grows by no more than this share where both halves have the
#: larger need: where needs peak and jump, meshes that are not symmetric change them.
SYMMETRIC = 0.1

#: First and last cell along x and y, the last one excluded.
Window = tuple[int, int, int, int]
#: A rectangle by its sides along x and y [m].
Rectangle = tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True, slots=True)
class PlanGrid:
    """Cells of one width over a plan: from its lower left corner, along folded axes from its middle.

    Attributes
    ----------
    bounds : tuple of float
        Of the plan: the lower and the upper one along x, then along y [m].
    step : float
        Width of a cell along both axes [m].
    area : array (n_x, n_y)
        What of each cell and of its images is in the plan [m2].
    folded : tuple of bool
        Along which axes a cell has an image on the other side of the middle.
    """

    bounds: tuple[float, float, float, float]
    step: float
    area: Array
    folded: tuple[bool, bool] = (False, False)

    def origin(self, axis: int) -> float:
        """Return where cells begin along an axis [m]."""
        low, high = self.bounds[2 * axis : 2 * axis + 2]
        return (low + high) / 2 if self.folded[axis] else low

    def rectangles(self, cells: Window) -> list[Rectangle]:
        """Return the sides along x and y [m] of a rectangle of cells and of its images, to the micrometer."""
        return list(itertools.product(self._sides(0, *cells[:2]), self._sides(1, *cells[2:])))

    def _sides(self, axis: int, first: int, last: int) -> list[tuple[float, float]]:
        """Return the sides of cells along an axis [m], from below; those that begin at the middle are one side."""
        origin, (low, high) = self.origin(axis), self.bounds[2 * axis : 2 * axis + 2]
        before, after = origin + first * self.step, origin + last * self.step
        sides = [(before, after)]
        if self.folded[axis]:
            image = 2 * origin - after
            sides = [(image, 2 * origin - before), *sides] if first > 0 else [(image, after)]
        return [(round(max(start, low), 6), round(min(end, high), 6)) for start, end in sides]


def make_grid(area: BaseGeometry, rounding: float, folded: tuple[bool, bool] = (False, False)) -> PlanGrid:
    """Return the cells of a plan, as wide as the rounding [m] or, of a large one, a multiple of it."""
    from shapely import area as area_of
    from shapely import box, intersection

    x0, y0, x1, y1 = area.bounds
    sides = np.array([x1 - x0, y1 - y0])
    times = max(1, math.ceil(math.sqrt(sides.prod() / MOST_CELLS) / rounding))
    step = times * rounding
    n_x, n_y = (max(1, math.ceil(side / (1 + fold) / step - ON_LINE)) for side, fold in zip(sides, folded, strict=True))
    grid = PlanGrid((x0, x1, y0, y1), step, np.zeros((n_x, n_y)), folded)
    left, low = np.meshgrid(
        grid.origin(0) + step * np.arange(n_x), grid.origin(1) + step * np.arange(n_y), indexing="ij"
    )
    cells = area_of(intersection(box(left, low, left + step, low + step), area)) * (1 + folded[0]) * (1 + folded[1])
    return PlanGrid(grid.bounds, step, cells, folded)


@dataclass(frozen=True, slots=True)
class CellValues:
    """Where nodal values of a plate lie in the cells of a plan, in cells that are PARTS times finer.

    Attributes
    ----------
    grid : PlanGrid
        The cells.
    plate : PlateResult
        The plate.
    centers : array (k, 2)
        The finer cells that are in the plan.
    where : tuple of tuples of arrays
        The elements under their centers and those of their images, and the places in them.
    """

    grid: PlanGrid
    plate: PlateResult
    centers: Integers
    where: tuple[MeshLocations, ...]

    def largest(self, values: Array, axis: int) -> Array:
        """Return the largest of nodal values (n,) in cells, finer along an axis: (PARTS n_x, n_y) or (n_x, PARTS n_y).

        Values are those at nodes in a cell or on its border, and at the centers of the finer cells; 0 off the plan.
        """
        n_x, n_y = self.grid.area.shape
        fine = np.zeros((PARTS * n_x, PARTS * n_y))
        mesh = Mesh(self.plate.nodes, self.plate.elements)
        for where in self.where:
            np.maximum.at(fine, tuple(self.centers.T), interpolate_bilinear(mesh, values, where))
        distance = self.plate.nodes - [self.grid.origin(0), self.grid.origin(1)]
        position = np.where(self.grid.folded, np.abs(distance), distance) / self.grid.step * PARTS
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
    distance = grid.step / PARTS * (centers + 0.5)
    origin, mesh = np.array([grid.origin(0), grid.origin(1)]), Mesh(plate.nodes, plate.elements)
    turns = itertools.product(*((1, -1) if fold else (1,) for fold in grid.folded))
    where = tuple(locate_nearest(mesh, origin + np.array(turn) * distance) for turn in turns)
    return CellValues(grid, plate, centers, where)


def symmetric_axes(plan: BaseGeometry, plate: PlateResult, needs: Mapping[str, Array]) -> dict[str, tuple[bool, bool]]:
    """Return about the middle of which axes a plan, and what its nodes need (n,) by layer, mirror themselves.

    Needs are compared where they are above their mean: what is less, the base covers.
    """
    from shapely.affinity import scale

    x0, y0, x1, y1 = plan.bounds
    middle, mesh = np.array([x0 + x1, y0 + y1]) / 2, Mesh(plate.nodes, plate.elements)

    def about(turn: tuple[float, float]) -> dict[str, bool]:
        image = scale(plan, *turn, origin=tuple(middle))
        if plan.symmetric_difference(image).area > ON_LINE * plan.area:
            return dict.fromkeys(needs, False)
        where = locate_nearest(mesh, middle + turn * (plate.nodes - middle))
        return {layer: grows_little(here, interpolate_bilinear(mesh, here, where)) for layer, here in needs.items()}

    def grows_little(here: Array, mirrored: Array) -> bool:
        floor = np.average(here, weights=plate.area) * (1 + ON_LINE)
        above, of_image = (np.maximum(values - floor, 0.0) for values in (here, mirrored))
        both = (np.maximum(above, of_image) * plate.area).sum()
        return bool(both <= (1 + SYMMETRIC) * (above * plate.area).sum())

    along_x, along_y = about((-1.0, 1.0)), about((1.0, -1.0))
    return {layer: (along_x[layer], along_y[layer]) for layer in needs}


def spread_along(cells: Array, reach: Array) -> Array:
    """Return the largest value of cells (m, w) that reach to each along the first axis, by whole cells (m, w) each."""
    spread = cells.copy()
    for shift in range(1, min(int(reach.max(initial=0)), len(cells) - 1) + 1):
        far = np.where(reach >= shift, cells, 0.0)
        spread[shift:] = np.maximum(spread[shift:], far[:-shift])
        spread[:-shift] = np.maximum(spread[:-shift], far[shift:])
    return spread
