"""Settlement and vertical stress in the depth of an elastic continuum against closed forms, equilibrium and bounds."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1

from groundslab.arrays import Array
from groundslab.errors import InputError
from groundslab.fem.continuum.cells import Grid
from groundslab.fem.continuum.depth import LoadedCells, settle_below
from groundslab.fem.continuum.elastic_ground import make_operator
from groundslab.fem.continuum.media import BondedLayers
from groundslab.fem.continuum.pressed_cells import PressedCells
from groundslab.fem.continuum.transfer import ElasticLayer, carry_down

E, NU, Q = 30e6, 0.3, 100e3
HALF_SPACE = (ElasticLayer(E, NU, np.inf),)
#: The same half-space, said in parts: the kernels of layers take the place of closed forms below the first.
IN_PARTS = (ElasticLayer(E, NU, 0.8), ElasticLayer(E, NU, 2.5), ElasticLayer(E, NU, np.inf))
LAYERS = (ElasticLayer(10e6, 0.3, 1.0), ElasticLayer(40e6, 0.2, 3.0))
ON_HALF_SPACE = (*LAYERS, ElasticLayer(90e6, 0.25, np.inf))
CENTER = np.zeros((1, 2))


def loaded_rectangle(a: float, b: float, nx: int, ny: int) -> LoadedCells:
    """Return a rectangle a by b [m] around the origin under Q, of nx by ny cells."""
    x, y = ((np.arange(n) + 0.5) * side / n - side / 2 for side, n in ((a, nx), (b, ny)))
    X, Y = np.meshgrid(x, y, indexing="ij")
    size = a / nx, b / ny
    return LoadedCells(np.column_stack([X.ravel(), Y.ravel()]), size, np.full(nx * ny, Q * size[0] * size[1]))


def loaded_circle(radius: float, n: int) -> LoadedCells:
    """Return a circle around the origin under Q, of n cells across it, those at its edge by the area in it."""
    size = 2 * radius / n
    fine = (np.arange(20 * n) + 0.5) * size / 20 - radius
    within = (fine[:, None] ** 2 + fine**2 < radius**2).reshape(n, 20, n, 20).mean(axis=(1, 3))
    center = (np.arange(n) + 0.5) * size - radius
    X, Y = np.meshgrid(center, center, indexing="ij")
    some = within > 0
    return LoadedCells(np.column_stack([X[some], Y[some]]), (size, size), Q * size**2 * within[some])


def newmark(m: Array, n: Array) -> Array:
    """Return sigma_z / q below the corner of a rectangle m z by n z (Newmark 1935, with the angle between 0 and pi)."""
    v, p = m**2 + n**2 + 1, m**2 * n**2
    root = 2 * m * n * np.sqrt(v)
    found: Array = (root / (v + p) * (v + 1) / v + np.arctan2(root, v - p)) / (4 * np.pi)
    return found


@pytest.mark.parametrize("layers", [HALF_SPACE, IN_PARTS], ids=["half-space", "half-space in parts"])
def test_stress_below_the_corner_of_a_rectangle_is_newmarks(layers: tuple[ElasticLayer, ...]) -> None:
    """At all depths, near the surface by closed forms and below by kernels, to five digits of q."""
    z = np.array([0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0])
    _, stress = settle_below(layers, loaded_rectangle(4.0, 2.0, 20, 10), np.array([[2.0, 1.0]]), z)
    np.testing.assert_allclose(stress[0], Q * newmark(4 / z, 2 / z), atol=1e-5 * Q)


@pytest.mark.parametrize("layers", [HALF_SPACE, IN_PARTS], ids=["half-space", "half-space in parts"])
def test_below_the_center_of_a_circle_is_boussinesqs_integral(layers: tuple[ElasticLayer, ...]) -> None:
    """sigma_z = q (1 - (z/R)^3) and w by integration over the circle; the edge's cells are off by 1e-4."""
    z, a = np.array([0.0, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0]), 1.0
    settlement, stress = settle_below(layers, loaded_circle(a, 64), CENTER, z)
    R = np.hypot(a, z)
    np.testing.assert_allclose(stress[0], Q * (1 - (z / R) ** 3), atol=2e-4 * Q)
    exact = Q * (1 + NU) / E * (2 * (1 - NU) * (R - z) + z - z**2 / R)
    np.testing.assert_allclose(settlement[0], exact, rtol=2e-4)


@pytest.mark.parametrize("layers", [LAYERS, ON_HALF_SPACE], ids=["on a rigid base", "on a half-space"])
def test_layers_below_a_circle_by_quadrature(layers: tuple[ElasticLayer, ...]) -> None:
    """Below the center int W(k, z) J_1(k a) dk a q by quadrature, without tables, splines or cells."""
    z, a = np.array([0.5, 1.0, 2.5, 3.9]), 1.0
    settlement, stress = settle_below(layers, loaded_circle(a, 64), CENTER, z)
    cuts = [0.0, 0.5, 1.0, 2.5, 3.9, 4.0]
    tops = np.array([0.0, 1.0, 4.0])
    cut = [layers[int(np.searchsorted(tops, t, side="right")) - 1] for t in cuts[:-1]]
    cut = [ElasticLayer(each.E, each.nu, h) for each, h in zip(cut, np.diff(cuts), strict=True)] + [*layers[2:]]
    # what arrives at z decays like exp(-k z): at k = 60 / m nothing is left
    s, weight = np.polynomial.legendre.leggauss(400)
    k = 30 * (s + 1)
    for found, carried in zip((settlement, stress), carry_down(cut, k), strict=True):
        exact = Q * a * (carried[1:5] * j1(k * a)) @ (30 * weight)
        np.testing.assert_allclose(found[0], exact, rtol=3e-4)


@pytest.mark.parametrize("layers", [HALF_SPACE, LAYERS, ON_HALF_SPACE], ids=["half-space", "base", "layers"])
def test_stress_over_a_plane_carries_the_load(layers: tuple[ElasticLayer, ...]) -> None:
    """Int sigma_z dA = P at depths that the plane of integration, 80 m wide, resolves and holds."""
    cells = loaded_rectangle(2.0, 1.0, 8, 4)
    x = np.arange(80) + 0.5 - 40
    X, Y = np.meshgrid(x, x)
    z = np.array([1.6, 2.0, 2.4])
    _, stress = settle_below(layers, cells, np.column_stack([X.ravel(), Y.ravel()]), z)
    # beyond the plane Boussinesq's stress leaves (z / 40)^3, at most 2e-4
    np.testing.assert_allclose(stress.sum(axis=0), cells.force.sum(), rtol=3e-4)


@pytest.mark.parametrize("layers", [LAYERS, ON_HALF_SPACE], ids=["on a rigid base", "on a half-space"])
def test_nothing_jumps_where_layers_meet_or_closed_forms_end(layers: tuple[ElasticLayer, ...]) -> None:
    """Settlement and stress just above and just below borders of layers and the depth up to which cells are near."""
    cells = loaded_rectangle(2.0, 1.0, 8, 4)
    for border in (0.5, 1.0, *((4.0,) if len(layers) > 2 else ())):
        z = border + 1e-7 * np.array([-1.0, 1.0])
        for found in settle_below(layers, cells, np.array([[0.0, 0.0], [0.6, 0.4], [3.0, 1.0]]), z):
            np.testing.assert_allclose(found[:, 0], found[:, 1], rtol=1e-5, atol=1e-6 * found.max())


def test_the_base_does_not_settle_and_the_surface_bears_the_pressure() -> None:
    """W at the rigid base is zero, sigma_z at the surface the pressure of a cell, and nothing beside the cells."""
    cells = loaded_rectangle(2.0, 1.0, 8, 4)
    settlement, stress = settle_below(LAYERS, cells, np.array([[0.1, 0.1], [3.0, 0.0]]), np.array([0.0, 4.0]))
    assert abs(settlement[0, 1]) < 1e-6 * settlement[0, 0]
    np.testing.assert_allclose(stress[:, 0], [Q, 0.0], atol=1e-9 * Q)


@pytest.mark.parametrize("layers", [HALF_SPACE, LAYERS, ON_HALF_SPACE], ids=["half-space", "base", "layers"])
def test_the_surface_settles_as_the_analysis_says(layers: tuple[ElasticLayer, ...]) -> None:
    """Settlement at depth 0, averaged over a cell, is that of the operator of the analysis."""
    cells = loaded_rectangle(2.0, 1.0, 8, 4)
    wanted = make_operator(BondedLayers(layers), Grid(-1.0, -0.5, 0.25, 0.25, 8, 4)).settle(cells.force.reshape(8, 4))
    s, weight = np.polynomial.legendre.leggauss(6)
    X, Y = np.meshgrid(s / 8, s / 8, indexing="ij")
    for i, j in ((3, 1), (0, 0)):
        places = cells.center[4 * i + j] + np.column_stack([X.ravel(), Y.ravel()])
        settlement, _ = settle_below(layers, cells, places, np.zeros(1))
        mean = settlement[:, 0] @ np.outer(weight, weight).ravel() / 4
        assert mean == pytest.approx(wanted[i, j], rel=1e-4)


def test_layers_compressed_by_the_stresses_of_a_half_space() -> None:
    """Settlement below a circle's center is the sum over the layers below of int sigma_z dz / M, in closed form."""
    a, z = 1.0, np.array([0.0, 0.03, 0.5, 1.0, 2.0, 4.0, 9.0])
    layers = (ElasticLayer(8e6, 0.0, 1.0), ElasticLayer(20e6, 0.0, 3.0))
    settlement, stress = settle_below(layers, loaded_circle(a, 64), CENTER, z, bonded=False)

    def integral(depth: Array) -> Array:
        """Return int (1 - z^3 / R^3) dz = z - R - a^2 / R."""
        R = np.hypot(depth, a)
        found: Array = depth - R - a**2 / R
        return found

    within = [np.clip(z, top, bottom) for top, bottom in ((0.0, 1.0), (1.0, 4.0))]
    ends = zip(within, (1.0, 4.0), layers, strict=True)
    exact = Q * sum((integral(np.array(bottom)) - integral(top)) / layer.E for top, bottom, layer in ends)
    np.testing.assert_allclose(settlement[0], exact, rtol=2e-4, atol=1e-9)
    np.testing.assert_allclose(stress[0], Q * (1 - (z / np.hypot(z, a)) ** 3), atol=2e-4 * Q)


def test_points_outside_the_ground_are_refused_all_at_once() -> None:
    """Above the surface, below the base, and no numbers; depths may come in any order."""
    layers = np.array([(each.E, each.nu, each.thickness) for each in LAYERS])
    cells = PressedCells(CENTER, np.array([1.0, 1.0]), np.array([1e3]), np.array([1e3]), layers, True, np.zeros((0, 3)))
    assert cells.base == 4.0
    with pytest.raises(InputError, match="rigid base"):
        cells.at_points(np.array([[0.0, 0.0, 5.0]]))
    with pytest.raises(InputError) as raised:
        cells.at_points(np.array([[0.0, np.nan, 1.0], [0.0, 0.0, -1.0]]))
    assert [issue.location for issue in raised.value.issues] == ["x, y, z", "z"]
    points = np.array([[0.0, 0.0, 2.0], [1.0, 0.0, 0.5], [0.0, 0.0, 0.5]])
    together = cells.at_points(points)
    alone = [cells.at_points(point[None]) for point in points]
    np.testing.assert_allclose(together, np.hstack(alone), rtol=1e-5)
