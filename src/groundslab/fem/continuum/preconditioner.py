"""About the inverse of what a plate on an elastic continuum gives way to pressures, by cosine transforms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.elastic_ground import ElasticGround

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
    k = np.hypot(k_x[:, None], k_y)
    # the mean is left to equilibrium
    k[0, 0] = np.pi / (2 * max(grid.nx * grid.dx, grid.ny * grid.dy))
    table = np.geomspace(k.min(), k.max(), TABLE)
    T = np.exp(np.interp(np.log(k), np.log(table), np.log(ground.medium.compliance(table))))
    means = np.sinc(k_x * grid.dx / (2 * np.pi))[:, None] * np.sinc(k_y * grid.dy / (2 * np.pi))
    return Preconditioner(ground, grid.dx * grid.dy / (means**2 * T + 1 / (D * k**4)))
