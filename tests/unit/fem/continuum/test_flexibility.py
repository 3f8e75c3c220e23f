"""Settlement of cells by Fourier transforms against the sum over pairs of cells."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.fem.continuum.cells import Grid
from groundslab.fem.continuum.flexibility import Flexibility, make_flexibility
from groundslab.fem.continuum.kernels import cell_means, layered_kernel
from groundslab.fem.continuum.transfer import ElasticLayer, surface_compliance

GRID = Grid(1.0, -2.0, 0.4, 0.3, 9, 6)
GROUNDS = {
    "half-space": [ElasticLayer(20e6, 0.3, math.inf)],
    "layer": [ElasticLayer(20e6, 0.3, 1.5)],
    "stiff on soft": [ElasticLayer(200e6, 0.2, 0.5), ElasticLayer(5e6, 0.4, 3.0), ElasticLayer(60e6, 0.3, math.inf)],
}
RANDOM = np.random.default_rng(4)


def operator(name: str, grid: Grid = GRID) -> Flexibility:
    """Return the operator of a ground."""
    return make_flexibility(layered_kernel(tuple(GROUNDS[name])), grid)


def columns(flexibility: Flexibility) -> np.ndarray:
    """Return the matrix of all unit forces."""
    n = flexibility.grid.nx * flexibility.grid.ny
    shape = flexibility.grid.nx, flexibility.grid.ny
    return np.array([flexibility.settle(unit.reshape(shape)).ravel() for unit in np.eye(n)]).T


@pytest.mark.parametrize("name", GROUNDS)
def test_convolution_is_the_sum_over_pairs(name):
    """Every entry is the mean of the kernel between two cells; nothing comes around the ends of the grid."""
    i, j = np.divmod(np.arange(GRID.nx * GRID.ny), GRID.ny)
    apart = GRID.dx * np.abs(i[:, None] - i), GRID.dy * np.abs(j[:, None] - j)
    pairs = cell_means(layered_kernel(tuple(GROUNDS[name])), *apart, GRID.dx, GRID.dy)
    F = columns(operator(name))
    assert np.abs(F - pairs).max() < 1e-12 * F.max()
    assert operator(name).own == pytest.approx(pairs[0, 0], rel=1e-14)


@pytest.mark.parametrize("name", GROUNDS)
def test_reciprocal_and_positive(name):
    """Two sets of forces do the same work on each other's settlements (Betti), and any forces do work."""
    F = columns(operator(name))
    assert np.abs(F - F.T).max() < 1e-13 * F.max()
    assert np.linalg.eigvalsh((F + F.T) / 2).min() > 0


def test_multiplication_with_other_spectra():
    """One is the identity."""
    flexibility = operator("layer")
    values = RANDOM.normal(size=(GRID.nx, GRID.ny))
    assert flexibility.multiply(np.ones_like(flexibility.transformed), values) == pytest.approx(values, abs=1e-14)


@pytest.mark.parametrize("name", GROUNDS)
def test_waves_settle_by_the_transfer_function(name):
    """In the middle of a large grid a wave of pressure settles by T(k), up to what its ends and cells are off."""
    n, d, k = 512, 0.1, 2 * math.pi / 3.2
    grid = Grid(0.0, 0.0, d, d, n, n)
    flexibility = make_flexibility(layered_kernel(tuple(GROUNDS[name])), grid)
    x = grid.centers[0] - n * d / 2
    wave = np.cos(k * x)[:, None] * np.ones(n)
    # the pressure of a cell and the mean settlement of one each take sin(k d / 2) / (k d / 2) of a wave
    T = float(surface_compliance(GROUNDS[name], np.array([k]))[0]) * np.sinc(k * d / 2 / math.pi) ** 2
    settled = flexibility.settle(wave * d**2)[n // 2 - 32 : n // 2 + 32, n // 2]
    amplitude = 2 * np.mean(settled * np.cos(k * x[n // 2 - 32 : n // 2 + 32]))
    assert amplitude == pytest.approx(T, rel=5e-3)
