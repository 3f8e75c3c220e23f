"""An elastic continuum under a plate: the cells on which it presses, and the operator of its settlement."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.cells import Cells, Grid
from groundslab.fem.continuum.flexibility import Flexibility, make_flexibility
from groundslab.fem.continuum.kernels import surface_kernel
from groundslab.fem.continuum.transfer import ElasticLayer


@dataclass(frozen=True, slots=True)
class ElasticGround:
    """An elastic continuum and the c cells on which a plate bears on it."""

    layers: tuple[ElasticLayer, ...]
    cells: Cells
    flexibility: Flexibility
    gap: Array  # (c,) [m]: initial one
    limit_force: Array  # (c,) [N]: infinite without a limit, 0 over cavities

    def settle(self, force: Array) -> Array:
        """Return the mean settlement of each cell [m] by forces on them (c,) [N]."""
        found: Array = self.flexibility.settle(self.cells.on_grid(force)).ravel()[self.cells.number]
        return found

    def settle_at(self, force: Array, places: Array) -> Array:
        """Return the settlement [m] of the surface at places (p, 2) [m], anywhere, by forces on the cells (c,) [N].

        Interpolated between the means of cells of the same size that reach over all places.
        """
        from scipy.interpolate import RegularGridInterpolator

        grid, wide = self.cells.grid, _reach_over(self.cells.grid, places)
        first = round((grid.x0 - wide.x0) / grid.dx), round((grid.y0 - wide.y0) / grid.dy)
        on_wide = np.zeros((wide.nx, wide.ny))
        on_wide[first[0] : first[0] + grid.nx, first[1] : first[1] + grid.ny] = self.cells.on_grid(force)
        settlement = make_operator(self.layers, wide).settle(on_wide)
        found: Array = RegularGridInterpolator(wide.centers, settlement)(places)
        return found


def make_operator(layers: tuple[ElasticLayer, ...], grid: Grid) -> Flexibility:
    """Return the operator that settles the cells of a grid on layers."""
    smallest, largest = min(grid.dx, grid.dy), np.hypot(grid.nx * grid.dx, grid.ny * grid.dy)
    return make_flexibility(surface_kernel(layers, smallest / 100, 2 * float(largest)), grid)


def _reach_over(grid: Grid, places: Array) -> Grid:
    """Return the grid with further rows of cells, so that places (p, 2) lie between centers of its cells."""
    low = np.floor((np.array([grid.x0, grid.y0]) - places.min(axis=0)) / [grid.dx, grid.dy]).astype(int) + 2
    size = np.array([grid.x0 + grid.nx * grid.dx, grid.y0 + grid.ny * grid.dy])
    high = np.floor((places.max(axis=0) - size) / [grid.dx, grid.dy]).astype(int) + 2
    low, high = np.maximum(low, 1), np.maximum(high, 1)
    return replace(
        grid,
        x0=grid.x0 - low[0] * grid.dx,
        y0=grid.y0 - low[1] * grid.dy,
        nx=grid.nx + int(low[0] + high[0]),
        ny=grid.ny + int(low[1] + high[1]),
    )
