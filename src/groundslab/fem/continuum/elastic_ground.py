"""An elastic continuum under a plate: the cells on which it presses, and the operator of its settlement."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.fem.continuum.cells import Cells, Grid
from groundslab.fem.continuum.flexibility import Flexibility, make_flexibility
from groundslab.fem.continuum.media import Medium
from groundslab.fem.continuum.pile_group import PileGroup


@dataclass(frozen=True, slots=True)
class Columns:
    """Ground that differs over the plan: at each place the settlement is a mean of those that h columns would give."""

    media: tuple[Medium, ...]
    flexibility: tuple[Flexibility, ...]
    weights_at: Callable[[Array], Array]  # weights (p, h) at places (p, 2), with the sum one
    weights: Array  # (c, h): at the cells
    softness: Array  # (c,): root of the settlement there over that of the mean ground

    def settle(self, cells: Cells, force: Array) -> Array:
        """Return the mean settlement of each cell [m] by forces on them (c,) [N]."""
        on_grid = cells.on_grid(force)
        of_each = np.stack([column.settle(on_grid).ravel()[cells.number] for column in self.flexibility], axis=1)
        settlement: Array = (self.weights * of_each).sum(axis=1)
        return settlement


@dataclass(frozen=True, slots=True)
class Relief:
    """Ground that was loaded before: forces up to those of the excavation settle it less."""

    force: Array  # (c,) [N]
    ratio: float  # stiffness under reloading over that under first loading


@dataclass(frozen=True, slots=True)
class ElasticGround:
    """An elastic continuum and the c cells on which a plate bears on it."""

    medium: Medium
    cells: Cells
    flexibility: Flexibility  # of the medium, which is the mean of the columns, if there are such
    gap: Array  # (c,) [m]: initial one
    limit_force: Array  # (c,) [N]: infinite without a limit, 0 over cavities
    columns: Columns | None = None
    relief: Relief | None = None
    limit_depth: float | None = None  # [m]: below it nothing settles
    piles: PileGroup | None = None

    @property
    def linear(self) -> bool:
        """Return whether settlements are linear in the forces, and what one cell does to another is mutual."""
        return self.columns is None and self.relief is None

    def settle(self, force: Array) -> Array:
        """Return the mean settlement of each cell [m] by forces on them (c,) [N]."""
        return self._settle_first(self.settling(force))

    def settling(self, force: Array) -> Array:
        """Return what of forces on the cells (c,) [N] settles the ground as under first loading."""
        if self.relief is None:
            return force
        again = np.clip(force, 0.0, self.relief.force)
        return force - again * (1 - 1 / self.relief.ratio)

    def _settle_first(self, force: Array) -> Array:
        """Return the settlement of each cell (c,) [m] under first loading."""
        if self.columns is not None:
            return self.columns.settle(self.cells, force)
        return self._settle_medium(force)

    def _settle_medium(self, force: Array) -> Array:
        settlement: Array = self.flexibility.settle(self.cells.on_grid(force)).ravel()[self.cells.number]
        return settlement

    def settle_mutually(self, force: Array) -> Array:
        """Return settlements (c,) [m] close to those, by a symmetric positive definite operator."""
        if self.columns is None:
            return self._settle_medium(force)
        return self.columns.softness * self._settle_medium(self.columns.softness * force)

    def settle_at(self, force: Array, places: Array) -> Array:
        """Return the settlement [m] of the surface at places (p, 2) [m], anywhere, by forces on the cells (c,) [N].

        Interpolated between the means of cells of the same size that reach over all places.
        """
        force = self.settling(force)
        grid, wide = self.cells.grid, _reach_over(self.cells.grid, places)
        first = round((grid.x0 - wide.x0) / grid.dx), round((grid.y0 - wide.y0) / grid.dy)
        on_wide = np.zeros((wide.nx, wide.ny))
        on_wide[first[0] : first[0] + grid.nx, first[1] : first[1] + grid.ny] = self.cells.on_grid(force)
        return self._settle_wide(wide, on_wide, places)

    def settle_by(self, force: Array, points: Array, places: Array) -> Array:
        """Return the settlement [m] of the surface at places (p, 2) [m] by forces (f,) [N] at points (f, 2) beside it.

        Each force is spread over the four cells around it, of a grid that reaches over points and places.
        """
        wide = _reach_over(self.cells.grid, np.vstack([points, places]))
        at = (points - [wide.x0, wide.y0]) / [wide.dx, wide.dy] - 0.5
        low = np.floor(at).astype(int)
        on_wide = np.zeros((wide.nx, wide.ny))
        for i in (0, 1):
            for j in (0, 1):
                weight = np.abs(1 - np.array([i, j]) - (at - low)).prod(axis=1)
                np.add.at(on_wide, (low[:, 0] + i, low[:, 1] + j), weight * force)
        return self._settle_wide(wide, on_wide, places)

    def _settle_wide(self, wide: Grid, force: Array, places: Array) -> Array:
        """Return the settlement (p,) [m] at places by forces on a grid, interpolated between its cells."""
        from scipy.interpolate import RegularGridInterpolator

        def settle(medium: Medium, of: Flexibility) -> Array:
            operators = _wider(of)
            if wide not in operators:
                operators[wide] = make_operator(medium, wide)
            operator = operators[wide]
            settlement: Array = RegularGridInterpolator(wide.centers, operator.settle(force))(places)
            return settlement

        if self.columns is None:
            return settle(self.medium, self.flexibility)
        of_each = [settle(*column) for column in zip(self.columns.media, self.columns.flexibility, strict=True)]
        mean: Array = (self.columns.weights_at(places) * np.stack(of_each, axis=1)).sum(axis=1)
        return mean

    def under(self, plates: Sequence[int]) -> ElasticGround:
        """Return the ground with the cells under some of several plates only, renumbered as these are."""
        mask = np.isin(self.cells.plate, plates)
        cells = replace(
            self.cells,
            number=self.cells.number[mask],
            area=self.cells.area[mask],
            center=self.cells.center[mask],
            spread=self.cells.spread[:, mask],
            around=self.cells.around[:, mask],
            under=self.cells.under[:, mask],
            plate=np.searchsorted(plates, self.cells.plate[mask]),
        )
        return replace(self, cells=cells, gap=self.gap[mask], limit_force=self.limit_force[mask], columns=None,
                       relief=None, piles=None)  # fmt: skip


@made_once
def _wider(of: Flexibility) -> dict[Grid, Flexibility]:  # noqa: ARG001
    """Return the operators of wider grids than that of the cells, as they are added."""
    return {}


def make_operator(medium: Medium, grid: Grid) -> Flexibility:
    """Return the operator that settles the cells of a grid on some ground."""
    return make_flexibility(medium.kernel(), grid)


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
