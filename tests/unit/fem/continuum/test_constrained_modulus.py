"""Settlement by constrained moduli: sums over layers, reloading, overburden, limit depth."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from groundslab.fem.continuum.boussinesq import compression, surface_settlement, vertical_stress
from groundslab.fem.continuum.constrained_modulus import (
    CHARACTERISTIC_POINT,
    Columns,
    effective_overburden,
    limit_depth,
    settlement_kernels,
    split_by_relief,
)

COLUMNS = Columns(
    np.array([[2.0, 3.0, 10.0], [1.0, 0.0, 4.0]]),
    np.array([[10e6, 5e6, 40e6], [10e6, 5e6, 40e6]]),
    np.array([[30e6, 15e6, 80e6], [30e6, 15e6, 80e6]]),
)
X, Y = np.array([[0.0], [1.0], [9.0]]), np.array([0.0, 2.0, 3.0, 50.0])


@pytest.mark.parametrize("mean", [False, True])
def test_kernels_sum_over_layers(mean: bool) -> None:
    """Each column is compressed by its layers, with the moduli for loading or for reloading; empty layers count not."""

    def layer(top: float, bottom: float) -> np.ndarray:
        return compression(X, Y, top, bottom, (1, 1), mean)

    first, second = settlement_kernels(X, Y, (1, 1), COLUMNS, mean=mean)
    np.testing.assert_allclose(first, layer(0, 2) / 10e6 + layer(2, 5) / 5e6 + layer(5, 15) / 40e6, rtol=1e-13)
    np.testing.assert_allclose(second, layer(0, 1) / 10e6 + layer(1, 5) / 40e6, rtol=1e-13)
    _, second = settlement_kernels(X, Y, (1, 1), COLUMNS, reload=True, mean=mean)
    np.testing.assert_allclose(second, layer(0, 1) / 30e6 + layer(1, 5) / 80e6, rtol=1e-13)


def test_one_infinite_layer_is_the_half_space() -> None:
    """With E_s = E / (1 - nu^2) an infinite layer settles as the half-space does, whose stresses it has."""
    column = Columns(np.array([[math.inf]]), np.array([[20e6 / (1 - 0.3**2)]]))
    half_space = surface_settlement(X, Y, (1, 1), 20e6, 0.3)
    np.testing.assert_allclose(settlement_kernels(X, Y, (1, 1), column)[0], half_space, rtol=1e-13)


def test_wide_load_is_confined_compression() -> None:
    """Under a very wide load a layer is compressed by q h / E_s."""
    kernel = settlement_kernels(0, 0, (1e4, 1e4), COLUMNS)
    np.testing.assert_allclose(kernel, [2 / 10e6 + 3 / 5e6 + 10 / 40e6, 1 / 10e6 + 4 / 40e6], rtol=1e-6)


def test_cells_add_up_to_the_area() -> None:
    """The kernel summed over the cells of a rectangle is what the rectangle settles at its centre."""
    offsets = np.arange(-2, 3)
    cells = settlement_kernels(offsets[:, None], 0.5 * offsets, (1, 0.5), COLUMNS).sum(axis=(1, 2))
    np.testing.assert_allclose(cells, settlement_kernels(0, 0, (5, 2.5), COLUMNS), rtol=1e-12)


def test_cut() -> None:
    """Below the depth of a cut nothing is compressed; each column may have its own."""
    cut = COLUMNS.cut([3.0, 20.0])
    np.testing.assert_allclose(cut.thickness, [[2, 1, 0], [1, 0, 4]])
    np.testing.assert_allclose(COLUMNS.cut(0.5).thickness, [[0.5, 0, 0], [0.5, 0, 0]])


def test_relief() -> None:
    """Pressure up to the relief reloads, the rest loads: 50 kPa of 80 kPa, all of 30 kPa, nothing without relief."""
    reloading, loading = split_by_relief([80e3, 30e3, 0.0], 50e3)
    np.testing.assert_array_equal(reloading, [50e3, 30e3, 0])
    np.testing.assert_array_equal(loading, [30e3, 0, 0])
    np.testing.assert_array_equal(split_by_relief(80e3, 0.0), [0, 80e3])


def test_overburden() -> None:
    """Gamma above groundwater, gamma' under it, layer by layer, by hand; water above the surface wets everything."""
    thickness, gamma, submerged = np.array([2.0, 3.0]), np.array([18e3, 20e3]), np.array([9e3, 10e3])
    stress = effective_overburden([0, 1, 2, 3, 5, 8], thickness, gamma, submerged, water=3.0, surcharge=27e3)
    np.testing.assert_allclose(stress, np.array([0, 18, 36, 56, 76, 106]) * 1e3 + 27e3)
    assert effective_overburden(4.0, thickness, gamma, submerged, water=-1.0) == pytest.approx(38e3)
    assert effective_overburden(4.0, thickness, gamma, submerged) == pytest.approx(76e3)


def test_limit_depth_of_a_strip() -> None:
    """Under a strip of 2 m, q = 100 kPa in 1 m depth of soil of 20 kN/m3: the root of the strip's closed form."""

    def strip(z: float) -> float:
        alpha = 2 * math.atan(1 / z)
        return 100 * (alpha + math.sin(alpha)) / math.pi - 0.2 * 20 * (1 + z)

    found = limit_depth(
        lambda z: 100e3 * vertical_stress(0, 0, z, (1e5, 2)),
        lambda z: effective_overburden(z, np.array([1.0]), np.array([20e3]), np.array([10e3]), surcharge=20e3),
        30.0,
    )
    assert found == pytest.approx(brentq(strip, 0.1, 30), rel=1e-7)


def test_limit_depth_at_its_ends() -> None:
    """It is 0 for a stress that counts nowhere, infinite for one that counts everywhere, the lower of two crossings."""

    def overburden(z: np.ndarray) -> np.ndarray:
        return effective_overburden(z, np.array([1.0]), np.array([20e3]), np.array([10e3]), surcharge=10e3)

    def load(q: float, x: float = 0.0) -> Callable[[np.ndarray], np.ndarray]:
        return lambda z: q * vertical_stress(x, 0, z, (2, 2))

    assert limit_depth(load(1e3), overburden, 30) == 0
    assert limit_depth(load(1e9), overburden, 30) == math.inf
    beside = limit_depth(load(200e3, 2.0), overburden, 30)
    assert load(200e3, 2.0)(beside) == pytest.approx(0.2 * overburden(np.array(beside)))
    assert load(200e3, 2.0)(0.01) < 0.2 * overburden(np.array(0.01))
    assert beside > 1


def test_characteristic_point_settles_as_the_rigid_square() -> None:
    """At 0.37 B from the centre the flexible square settles as the rigid one, computed cell by cell, within 3 %."""
    at = CHARACTERISTIC_POINT
    assert surface_settlement(at, at, (1, 1), 1, 0) == pytest.approx(0.872, rel=0.03)
