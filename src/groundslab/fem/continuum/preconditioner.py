"""About the inverse of what a plate on an elastic continuum gives way to pressures, by cosine transforms."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from operator import attrgetter

import numpy as np

from groundslab.arrays import Array, made_once_by
from groundslab.fem.continuum.elastic_ground import ElasticGround

#: T(k) is interpolated between so many wave numbers.
TABLE = 400
#: Shorter waves, up to so many further ones along each side of a cell, look alike in the means over cells.
ALIASES = 1


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
        forces: Array = idctn(waves * self.stiffness, norm="ortho", workers=-1, overwrite_x=True)
        return forces.ravel()[cells.number]


def make_preconditioner(ground: ElasticGround, D: float) -> Preconditioner:
    """Return the preconditioner for a plate of a bending rigidity D [N m] on a ground."""
    grid = ground.cells.grid
    by_ground, by_plate = _settled(ground)
    return Preconditioner(ground, grid.dx * grid.dy / (by_ground + by_plate / D))


@made_once_by(attrgetter("flexibility", "medium"))
def _settled(ground: ElasticGround) -> tuple[Array, Array]:
    """Return the mean settlement of cells by waves of pressures that are means over cells, (nx, ny) each.

    By the ground [m/Pa], and by a plate of a bending rigidity of one [N m2/Pa].
    """
    medium, grid = ground.medium, ground.cells.grid
    k_x = np.arange(grid.nx, dtype=np.float64) * (np.pi / (grid.nx * grid.dx))
    k_y = np.arange(grid.ny, dtype=np.float64) * (np.pi / (grid.ny * grid.dy))
    # the mean is left to equilibrium
    least = np.pi / (2 * max(grid.nx * grid.dx, grid.ny * grid.dy))
    most = (2 * ALIASES + 1) * np.pi * np.hypot(1 / grid.dx, 1 / grid.dy)
    table = np.geomspace(least, most, TABLE)
    T = np.log(medium.compliance(table))
    by_ground, by_plate = np.zeros((2, grid.nx, grid.ny))
    for i, j in product(range(-ALIASES, ALIASES + 1), repeat=2):
        along_x, along_y = k_x + 2 * np.pi * i / grid.dx, k_y + 2 * np.pi * j / grid.dy
        k = np.maximum(np.hypot(along_x[:, None], along_y), least)
        means = np.sinc(along_x * grid.dx / (2 * np.pi))[:, None] * np.sinc(along_y * grid.dy / (2 * np.pi))
        by_ground += means**2 * np.exp(np.interp(np.log(k), np.log(table), T))
        by_plate += means**2 / k**4
    return by_ground, by_plate
