"""The ground as an operator on forces of cells: it convolves them with a kernel, by Fourier transforms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.cells import Grid
from groundslab.fem.continuum.kernels import SurfaceKernel, cell_means

#: What a cell settles another one by less than this share of what it settles itself is rounding of the kernel: far away
#: in a layer on a rigid base nothing is left, but a heavy load there would show it.
NOTHING = 1e-12


@dataclass(frozen=True, slots=True, weakref_slot=True)
class Flexibility:
    """Mean settlement of each cell of a grid by forces on cells; padded with zeros, so that nothing comes around."""

    grid: Grid
    shape: tuple[int, int]  # padded
    transformed: Array  # real Fourier transform of the kernel, (shape[0], shape[1] // 2 + 1) [m/N]
    own: float  # [m/N]: settlement of a cell by a unit force of its own

    def settle(self, force: Array) -> Array:
        """Return the mean settlement [m] of each cell (nx, ny) by forces on them (nx, ny) [N]."""
        return self.multiply(self.transformed, force)

    def multiply(self, transformed: Array, values: Array) -> Array:
        """Return values (nx, ny) multiplied with something in Fourier space, with zeros around them."""
        from scipy.fft import irfft2, rfft2

        spectrum = rfft2(values, self.shape, workers=-1)
        spectrum *= transformed
        product: Array = irfft2(spectrum, self.shape, workers=-1)[: self.grid.nx, : self.grid.ny]
        return product


def make_flexibility(kernel: SurfaceKernel, grid: Grid) -> Flexibility:
    """Return the operator of ground whose surface has a kernel, on a grid of cells."""
    from scipy.fft import next_fast_len, rfft2

    x, y = np.meshgrid(grid.dx * np.arange(grid.nx), grid.dy * np.arange(grid.ny), indexing="ij")
    means = cell_means(kernel, x, y, grid.dx, grid.dy)
    means[np.abs(means) < NOTHING * means[0, 0]] = 0.0
    shape = next_fast_len(2 * grid.nx - 1, real=True), next_fast_len(2 * grid.ny - 1, real=True)
    padded = np.zeros(shape)
    padded[: grid.nx, : grid.ny] = means
    padded[shape[0] - grid.nx + 1 :, : grid.ny] = means[:0:-1]
    padded[:, shape[1] - grid.ny + 1 :] = padded[:, grid.ny - 1 : 0 : -1]
    # an even kernel has a real transform
    return Flexibility(grid, shape, np.ascontiguousarray(rfft2(padded, workers=-1).real), float(means[0, 0]))
