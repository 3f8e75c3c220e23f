"""What stands for the inverse of plate and ground: symmetric, positive, and near enough."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.fem.continuum.cells import cover, make_grid
from groundslab.fem.continuum.elastic_ground import ElasticGround, make_operator
from groundslab.fem.continuum.media import BondedLayers
from groundslab.fem.continuum.preconditioner import make_preconditioner
from groundslab.fem.continuum.transfer import ElasticLayer
from groundslab.fem.plate import ELEMENTS
from helpers.quads import mesh

HALF_SPACE = (ElasticLayer(20e6, 0.3, math.inf),)
STIFF_ON_SOFT = (ElasticLayer(200e6, 0.3, 1.0), ElasticLayer(10e6, 0.3, 5.0))


def ground(layers: tuple[ElasticLayer, ...], n: int) -> ElasticGround:
    """Return a ground under a plate of 4 x 2 m with n x n / 2 cells."""
    nodes, elements = mesh(2, 1, 4.0, 2.0)
    xy = nodes[elements]
    grid = make_grid((0.0, 4.0, 0.0, 2.0), 4.0 / n)
    cells = cover(grid, xy, elements, len(nodes), ELEMENTS["mitc9"].w_functions(xy), np.zeros(len(xy), dtype=int))
    none = np.zeros(len(cells.number))
    medium = BondedLayers(layers)
    return ElasticGround(medium, cells, make_operator(medium, grid), none, none + math.inf)


def matrices(g: ElasticGround, D: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the preconditioner and the ground's flexibility as full matrices."""
    unit = np.eye(len(g.cells.number))
    apply = make_preconditioner(g, D).apply
    return np.array([apply(each) for each in unit]), np.array([g.settle(each) for each in unit])


@pytest.mark.parametrize("layers", [HALF_SPACE, STIFF_ON_SOFT])
def test_symmetric_and_positive(layers):
    """As conjugate gradients need it."""
    M, _ = matrices(ground(layers, 12), 1e6)
    assert np.abs(M - M.T).max() < 1e-12 * M.max()
    assert np.linalg.eigvalsh(M).min() > 0


@pytest.mark.parametrize("layers", [HALF_SPACE, STIFF_ON_SOFT])
@pytest.mark.parametrize("n", [8, 16, 24])
def test_near_the_inverse_of_the_ground(layers, n):
    """Under a rigid plate the condition is below twenty on any grid; singular pressures at edges let it grow a little.

    A force on all cells together is left out: equilibrium gives it.
    """
    M, F = matrices(ground(layers, n), 1e30)
    Q = np.linalg.qr(np.column_stack([np.ones(len(F)), np.eye(len(F))[:, 1:]]))[0][:, 1:]
    values = np.linalg.eigvals((Q.T @ M @ Q) @ (Q.T @ F @ Q)).real
    assert values.min() > 0
    assert values.max() / values.min() < 20


def test_a_soft_plate_takes_little_force():
    """Waves that bend the plate more easily than they settle the ground are stiff by D k^4 alone.

    Pressures and settlements are means over cells: sin(k d / 2) / (k d / 2) of a wave's amplitude, twice.
    """
    g, D = ground(HALF_SPACE, 16), 1e-3
    M = make_preconditioner(g, D)
    x = g.cells.center[:, 0]
    k = np.pi / 4.0 * 2
    wave = np.cos(k * x)
    mean = np.sin(k * g.cells.grid.dx / 2) / (k * g.cells.grid.dx / 2)
    expected = D * k**4 / mean**2 * g.cells.grid.dx * g.cells.grid.dy * wave
    assert M.apply(wave) == pytest.approx(expected, rel=1e-4, abs=1e-12)
