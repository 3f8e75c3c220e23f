"""Kernels of the surface and their means over cells, against quadrature and closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import dblquad, quad
from scipy.special import ellipe, ellipk, j1

from groundslab.fem.continuum.kernels import FAR, cell_means, hankel, layered_kernel, mean_inverse_distance
from groundslab.fem.continuum.transfer import ElasticLayer, surface_compliance
from helpers.layered_ground import burmister, by_distance, mean_over_rectangle

#: Ratios of the moduli of top layer and half-space.
RATIOS = [0.1, 0.3, 1.0, 3.0, 10.0, 100.0]
#: Nearly incompressible, for Burmister's closed form.
NU = 0.5 - 1e-9


def two_layers(ratio: float) -> list[ElasticLayer]:
    """Return a layer of 1 m on a half-space of another modulus."""
    return [ElasticLayer(1.0, NU, 1.0), ElasticLayer(1.0 / ratio, NU, math.inf)]


def of_distances(x: float, y: float, dx: float, dy: float) -> float:
    """Return the mean of 1 / r between two cells by quadrature over the triangular density of distances."""
    value, _ = dblquad(
        lambda t, s: (1 - abs(s)) * (1 - abs(t)) / math.hypot(x + s * dx, y + t * dy), -1, 1, -1, 1, epsabs=1e-10
    )
    return float(value)


@pytest.mark.parametrize(("x", "y"), [(2.5, 0.5), (3.0, 0.0), (0.0, 2.0), (7.0, 5.0), (40.0, 3.0)])
def test_mean_inverse_distance_of_two_cells(x, y):
    """Cells beside each other and, by a series that ends before (dx / r)^4, far apart; of any ratio of sides."""
    found = mean_inverse_distance(np.array(x), np.array(y), 1.2, 0.5)
    assert float(found) == pytest.approx(of_distances(x, y, 1.2, 0.5), rel=1e-7 if x > FAR * 1.2 else 1e-8)


def test_mean_inverse_distance_of_a_square_with_itself():
    """4 (ln(1 + sqrt 2) - (sqrt 2 - 1) / 3) / a, the mean potential of a square (polar coordinates about a corner)."""
    expected = 4 * (math.log(1 + math.sqrt(2)) - (math.sqrt(2) - 1) / 3) / 0.3
    assert float(mean_inverse_distance(np.array(0.0), np.array(0.0), 0.3, 0.3)) == pytest.approx(expected, rel=1e-13)


def test_mean_inverse_distance_of_a_rectangle_with_itself():
    """1 / r is also integrated over long cells that lie on each other and side by side."""
    own = mean_over_rectangle(lambda _: 1.0, 2.0, 0.5)
    assert float(mean_inverse_distance(np.array(0.0), np.array(0.0), 2.0, 0.5)) == pytest.approx(own, rel=1e-8)
    pair = mean_over_rectangle(lambda _: 1.0, 4.0, 0.5)
    beside = float(mean_inverse_distance(np.array(2.0), np.array(0.0), 2.0, 0.5))
    assert (own + beside) / 2 == pytest.approx(pair, rel=1e-8)


def test_closed_form_and_series_meet():
    """Where the one takes over from the other both have seven digits."""
    x = np.array([FAR - 1e-9, FAR + 1e-9])
    near, far = mean_inverse_distance(x, np.full(2, 4.0), 1.0, 1.0)
    assert near == pytest.approx(far, rel=1e-7)


def test_transform_of_a_known_pair():
    """R = exp(-k a), int k exp(-k a) J0(k r) dk = a / (a^2 + r^2)^(3/2)."""
    at, r, a = hankel(lambda k: k * np.exp(-k * 0.7), 1e-3, 50.0), np.geomspace(1e-3, 50, 40), 0.7
    assert at(r) == pytest.approx(a / (2 * np.pi * (a**2 + r**2) ** 1.5), rel=1e-5, abs=1e-9)


def test_half_space_has_no_smooth_part():
    """Boussinesq: (1 - nu^2) / (pi E r) alone."""
    kernel = layered_kernel((ElasticLayer(3.0, 0.25, math.inf),))
    assert kernel.half_space / (2 * np.pi) == pytest.approx((1 - 0.25**2) / (np.pi * 3.0), rel=1e-14)
    assert not kernel.smooth(np.array([0.0, 1.0])).any()


def test_layers_of_one_soil_are_a_half_space():
    """Images and rest of bonds within one soil vanish."""
    soil = [ElasticLayer(3.0, 0.25, 1.0), ElasticLayer(3.0, 0.25, 0.2), ElasticLayer(3.0, 0.25, math.inf)]
    kernel = layered_kernel(tuple(soil))
    r = np.array([0.0, 0.1, 1.0, 10.0])
    assert np.abs(kernel.smooth(r)).max() < 1e-9 * kernel.half_space / (2 * np.pi * 10.0)


@pytest.mark.parametrize("ratio", RATIOS)
def test_unit_force_on_two_layers(ratio):
    """K(r) of Burmister's two layers by quadrature, from a tenth of the layer's thickness to twenty of it."""
    kernel, rK = layered_kernel(tuple(two_layers(ratio))), by_distance(burmister(ratio, 1.0, 1.0), 1.5, 1.0)
    r = np.array([0.1, 0.4, 1.0, 3.0, 8.0, 20.0])
    found = kernel.half_space / (2 * np.pi) + r * kernel.smooth(r)
    assert found == pytest.approx([rK(each) for each in r], rel=1e-5)


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("radius", [0.2, 1.0, 5.0])
def test_flexible_circle_on_two_layers(ratio, radius):
    """The middle of a circle under a unit pressure: int K 2 pi r dr, and int T(k) a J1(k a) dk by quadrature."""
    kernel, T = layered_kernel(tuple(two_layers(ratio))), burmister(ratio, 1.0, 1.0)
    found = quad(lambda r: kernel.half_space + 2 * np.pi * r * float(kernel.smooth(np.array(r))), 0, radius)[0]
    # T = (1.5 + what dies out as exp(-2 k)) / k, and int J1(k a) a / k dk = a
    rest = quad(lambda k: (T(k) * k - 1.5) * radius * j1(k * radius) / k, 1e-12, 25, limit=400, epsrel=1e-10)[0]
    assert found == pytest.approx(1.5 * radius + rest, rel=1e-5)


@pytest.mark.parametrize(("ratio", "a", "b"), [(0.1, 1.0, 0.4), (1.0, 0.1, 0.1), (10.0, 3.0, 2.0), (100.0, 1.0, 0.4)])
def test_mean_settlement_of_a_rectangle_on_two_layers(ratio, a, b):
    """A cell under its own pressure, small or large beside the layer's thickness, by an independent quadrature."""
    kernel = layered_kernel(tuple(two_layers(ratio)))
    found = float(cell_means(kernel, np.zeros(1), np.zeros(1), a, b)[0])
    rK = by_distance(burmister(ratio, 1.0, 1.0), 1.5, 1.0)
    assert found == pytest.approx(mean_over_rectangle(rK, a, b), rel=1e-4 if max(a, b) > 1 else 1e-5)


def test_one_layer_on_a_rigid_base():
    """The kernel's transform is T: the mean over a circle's rim, by Sonine's integral, of a layer of 2 m."""
    layers, radius = [ElasticLayer(10.0, 0.3, 2.0)], 1.5
    kernel = layered_kernel(tuple(layers))
    found = quad(lambda r: kernel.half_space + 2 * np.pi * r * float(kernel.smooth(np.array(r))), 0, radius)[0]

    def rest(k: float) -> float:
        T = float(surface_compliance(layers, np.array([k]))[0])
        return (T * k - kernel.half_space) * radius * float(j1(k * radius)) / k

    assert found == pytest.approx(kernel.half_space * radius + quad(rest, 1e-9, 15, limit=400)[0], rel=1e-5)


def test_edge_of_a_circle_on_a_half_space():
    """4 q a (1 - nu^2) / (pi E) at the rim, from cells: complete elliptic integrals give the same (Love 1929)."""
    radius, c = 1.0, (1 - 0.3**2) / 7.0
    r = 0.5
    inside = 4 * c * radius / np.pi * ellipe((r / radius) ** 2)
    outside = 4 * c * 2.0 / np.pi * (ellipe(0.25) - 0.75 * ellipk(0.25))
    d = 0.02
    n = np.arange(-50, 51) * d
    X, Y = np.meshgrid(n, n, indexing="ij")
    share = np.clip((radius - np.hypot(X, Y)) / d + 0.5, 0, 1)
    kernel = layered_kernel((ElasticLayer(7.0, 0.3, math.inf),))

    def at(x: float) -> float:
        return float((share * d**2 * cell_means(kernel, X - x, Y, d, d)).sum())

    assert at(r) == pytest.approx(inside, rel=2e-4)
    assert at(2.0) == pytest.approx(outside, rel=2e-4)
    assert at(radius) == pytest.approx(4 * c * radius / np.pi, rel=2e-3)
