"""Vertical stress in a half-space under loaded areas, by what layers carry down, against published points."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j0, j1

from groundslab.fem.continuum.transfer import ElasticLayer, carry_down


def carried(k: np.ndarray, z: float) -> np.ndarray:
    """Return the share of a pressure of wave numbers k (n,) that arrives at z in a half-space cut there."""
    cut = [ElasticLayer(20e6, 0.3, z), ElasticLayer(20e6, 0.3, math.inf)]
    return carry_down(cut, k)[1][1]


def rule(end: float, parts: int) -> tuple[np.ndarray, np.ndarray]:
    """Return Gauss's places and weights from 0 to an end."""
    s, weight = np.polynomial.legendre.leggauss(16)
    edges = np.linspace(0.0, end, parts + 1)
    half = np.diff(edges)[:, None] / 2
    return ((edges[1:] + edges[:-1])[:, None] / 2 + half * s).ravel(), (half * weight).ravel()


def under_circle(radius: float, z: float) -> float:
    """Return the stress on the axis as a share of the pressure: int sigma(k) a J1(k a) dk."""
    k, weight = rule(40 / z, 60)
    return float(weight @ (carried(k, z) * radius * j1(k * radius)))


def under_force(r: float, z: float) -> float:
    """Return the stress [1/m2] at a distance from a unit force and at a depth."""
    k, weight = rule(40 / z, 80)
    return float(weight @ (carried(k, z) * j0(k * r) * k)) / (2 * math.pi)


def under_rectangle(a: float, b: float, z: float, x: float = 0.0, y: float = 0.0) -> float:
    """Return the stress at x, y from the center of a x b: the Fourier integral over both wave numbers."""
    k, weight = rule(40 / z, 24)
    KX, KY = np.meshgrid(k, k, indexing="ij")
    of_k = np.interp(np.hypot(KX, KY), (fine := np.geomspace(k.min() / 2, 2 * k.max(), 4000)), carried(fine, z))
    along = weight * np.sin(k * a / 2) / k * np.cos(k * x)
    across = weight * np.sin(k * b / 2) / k * np.cos(k * y)
    return float(4 / math.pi**2 * along @ of_k @ across)


@pytest.mark.parametrize(
    ("z", "published"),
    [(1, "992.5"), (2, "948.8"), (3, "863.8"), (4, "756.2"), (5, "646.4"), (6, "546.6"), (7, "461.2"), (10, "284.5")],
)
def test_under_a_circle(z, published):
    """1000 kPa on a circle of 5 m (ELPLA's example 2, data of Scott 1974): exact stresses on its axis in kPa."""
    assert 1000 * under_circle(5.0, z) == pytest.approx(float(published), abs=0.051)
    assert under_circle(5.0, z) == pytest.approx(1 - (1 + (5 / z) ** 2) ** -1.5, rel=1e-8)


def test_under_the_center_of_a_rectangle():
    """Das (Principles of Foundation Engineering, example 5.1) prints 19.65 kPa by a table, 0.2 % off Boussinesq's."""
    assert 150 * under_rectangle(2.5, 5.0, 6.25) == pytest.approx(19.679, abs=0.002)
    assert 150 * under_rectangle(2.5, 5.0, 6.25) == pytest.approx(19.65, rel=2e-3)


def test_under_center_and_corner_of_a_rectangle():
    """50 kPa on 6 x 3 m at 3 m (ELPLA's example 1, data of Das 1983): 24.035 and 9.997 kPa by Boussinesq."""
    assert 50 * under_rectangle(6.0, 3.0, 3.0) == pytest.approx(24.035, abs=0.001)
    assert 50 * under_rectangle(6.0, 3.0, 3.0, 3.0, 1.5) == pytest.approx(9.997, abs=0.001)


def test_under_four_forces():
    """1 kPa on a unit square as four forces, 1 m under one of them: 299.341 Pa (XC's test of a quad loaded area)."""
    total = sum(250 * under_force(r, 1.0) for r in (0.0, 0.5, 0.5, math.hypot(0.5, 0.5)))
    assert total == pytest.approx(299.341, abs=0.001)


@pytest.mark.parametrize("r", [0.0, 0.5, 2.0])
def test_under_a_force(r):
    """3 P z^3 / (2 pi R^5), Boussinesq's stress: int sigma(k) J0(k r) k dk / (2 pi)."""
    assert under_force(r, 1.0) == pytest.approx(3 / (2 * math.pi * (1 + r**2) ** 2.5), rel=1e-7)
