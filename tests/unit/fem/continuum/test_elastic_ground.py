"""An elastic continuum under cells: what it settles by beneath the plate and anywhere beyond it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.fem.continuum.cells import cover, make_grid
from groundslab.fem.continuum.elastic_ground import ElasticGround, make_operator
from groundslab.fem.continuum.media import BondedLayers
from groundslab.fem.continuum.transfer import ElasticLayer
from groundslab.fem.plate import ELEMENTS
from helpers.quads import mesh

HALF_SPACE = (ElasticLayer(20e6, 0.3, math.inf),)
LAYER = (ElasticLayer(20e6, 0.3, 3.0),)


def ground(layers: tuple[ElasticLayer, ...], size: float = 0.25) -> ElasticGround:
    """Return a ground under an L-shaped plate of 4 x 3 m less a corner of 2 x 1.5 m."""
    nodes, elements = mesh(8, 6, 4.0, 3.0)
    center = nodes[elements[:, 8]]
    elements = elements[(center[:, 0] < 2) | (center[:, 1] < 1.5)]
    xy = nodes[elements]
    grid = make_grid((0.0, 4.0, 0.0, 3.0), size)
    cells = cover(grid, xy, elements, len(nodes), ELEMENTS["mitc9"].w_functions(xy), np.zeros(len(xy), dtype=int))
    none = np.zeros(len(cells.number))
    medium = BondedLayers(layers)
    return ElasticGround(medium, cells, make_operator(medium, grid), none, none + math.inf)


@pytest.mark.parametrize("layers", [HALF_SPACE, LAYER])
def test_settlement_is_reciprocal_on_any_plan(layers):
    """Cells that do not bear neither press nor are asked; the rest do the same work on each other."""
    g = ground(layers)
    a, b = np.random.default_rng(3).normal(size=(2, len(g.cells.number)))
    assert a @ g.settle(b) == pytest.approx(b @ g.settle(a), rel=1e-11)
    assert a @ g.settle(a) > 0


def test_settlement_at_centers_is_that_of_the_cells():
    """Between the means of cells it is interpolated, so at their centers nothing changes."""
    g = ground(LAYER)
    force = np.random.default_rng(3).uniform(size=len(g.cells.number))
    x, y = np.meshgrid(*g.cells.grid.centers, indexing="ij")
    centers = np.column_stack([x.ravel(), y.ravel()])[g.cells.number]
    assert g.settle_at(force, centers) == pytest.approx(g.settle(force), rel=1e-5)


def test_far_away_the_plate_is_a_point():
    """(1 - nu^2) P / (pi E r) on a half-space, about the centroid of the forces, up to the square of size / r."""
    g = ground(HALF_SPACE)
    force = 1e3 * g.cells.area
    centroid = g.cells.center.T @ force / force.sum()
    for direction in ((1.0, 0.0), (0.0, -1.0), (-0.6, 0.8)):
        place = centroid + 25 * np.array(direction)
        expected = (1 - 0.3**2) * force.sum() / (math.pi * 20e6 * 25)
        assert g.settle_at(force, place[None])[0] == pytest.approx(expected, rel=3e-3)


def test_far_away_a_layer_does_not_settle():
    """Four thicknesses from the plate the surface of a layer on a rigid base is all but at rest."""
    g = ground(LAYER)
    force = 1e3 * g.cells.area
    assert abs(g.settle_at(force, np.array([[16.0, 1.0]]))[0]) < 2e-3 * g.settle(force).max()


def test_settlement_beside_a_load_is_that_of_love():
    """1 m beside a pressed rectangle the half-space settles by Boussinesq's integral over it (closed form)."""
    g, q = ground(HALF_SPACE, 0.125), 5e4
    force = np.where((g.cells.center < [2.0, 1.5]).all(axis=1), q * g.cells.area, 0.0)

    def corner(a: float, b: float) -> float:
        r = math.hypot(a, b)
        return a * math.log((b + r) / a) + b * math.log((a + r) / b)

    # the place (3, 1.5) sees the rectangle as the difference of two, 3 x 1.5 and 1 x 1.5
    expected = q * (1 - 0.3**2) / (math.pi * 20e6) * (corner(3.0, 1.5) - corner(1.0, 1.5))
    assert g.settle_at(force, np.array([[3.0, 1.5]]))[0] == pytest.approx(expected, rel=2e-3)
