"""About the inverse of what a plate on an elastic continuum gives way to pressures, by cosine transforms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.elastic_ground import ElasticGround
from groundslab.fem.continuum.transfer import surface_compliance

#: T(k) is interpolated between so many wave numbers.
TABLE = 400


@dataclass(frozen=True, slots=True)
class Preconditioner:
    """Takes gaps of cells to forces that would close them if ground and plate went on without an end.

    Waves cos(k_x x) cos(k_y y) of the rectangle around the plate settle by T(k) on the ground, and bend a plate by
    1 / (D k^4).
    """

    ground: ElasticGround
    stiffness: Array  # (nx, ny) [N/m]: of a cell's force, by wave

    def apply(self, gap: Array) -> Array:
        """Return forces (c,) [N] for gaps (c,) [m]."""
        from scipy.fft import dctn, idctn

        cells = self.ground.cells
        waves = dctn(cells.on_grid(gap), norm="ortho", workers=-1)
        found: Array = idctn(waves * self.stiffness, norm="ortho", workers=-1, overwrite_x=True)
        return found.ravel()[cells.number]


def make_preconditioner(ground: ElasticGround, D: float) -> Preconditioner:
    """Return the preconditioner for a plate of a bending rigidity D [N m] on a ground."""
    grid = ground.cells.grid
    k_x, k_y = (np.pi * np.arange(n) / (n * d) for n, d in ((grid.nx, grid.dx), (grid.ny, grid.dy)))
    # the mean is left to equilibrium
    k_x[0] = k_y[0] = np.pi / (4 * max(grid.nx * grid.dx, grid.ny * grid.dy))
    settled = np.zeros((grid.nx, grid.ny))
    for x in (k_x, k_x - 2 * np.pi / grid.dx, k_x + 2 * np.pi / grid.dx):
        for y in (k_y, k_y - 2 * np.pi / grid.dy, k_y + 2 * np.pi / grid.dy):
            settled += _settle(ground, x, y)
    bent = 1 / (D * np.hypot(k_x[:, None], k_y) ** 4)
    return Preconditioner(ground, grid.dx * grid.dy / (settled + bent))


def _settle(ground: ElasticGround, k_x: Array, k_y: Array) -> Array:
    """Return the mean settlement [m/Pa] of cells by waves of pressures that are constant on them, (nx, ny)."""
    grid, k = ground.cells.grid, np.hypot(k_x[:, None], k_y)
    table = np.geomspace(k.min(), k.max(), TABLE)
    T = np.exp(np.interp(np.log(k), np.log(table), np.log(surface_compliance(ground.layers, table))))
    means = np.sinc(k_x * grid.dx / (2 * np.pi))[:, None] * np.sinc(k_y * grid.dy / (2 * np.pi))
    found: Array = means**2 * T
    return found
