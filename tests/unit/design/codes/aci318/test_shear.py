"""One-way and two-way shear by ACI 318: limits by hand, J_c by quadrature, stresses in equilibrium."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.design.codes.aci318 import punching, shear
from groundslab.design.codes.aci318.materials import Concrete, Steel

C30 = Concrete(30e6)


def rectangle(b_1: float, b_2: float) -> Array:
    """Return the four sides (4, 2, 2) of a rectangle about the origin."""
    corners = np.array([[-b_1, -b_2], [b_1, -b_2], [b_1, b_2], [-b_1, b_2]]) / 2
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)


def test_one_way_shear_by_hand() -> None:
    """D = 250 mm has no size effect: 0.66 0.01^(1/3) 30^(1/2) = 0.7788 MPa; 0.415 30^(1/2) is the most."""
    v = shear.without_links(C30, np.array([0.25, 0.25, 1.0]), np.array([0.01, 0.5, 0.01]))
    assert v[0] / 0.25 == pytest.approx(0.66 * 0.01 ** (1 / 3) * math.sqrt(30) * 1e6)
    assert v[1] / 0.25 == pytest.approx(0.415 * math.sqrt(30) * 1e6)
    assert v[2] / 1.0 == pytest.approx(v[0] / 0.25 * math.sqrt(2 / 5))
    assert shear.without_links(Concrete(30e6, size_effect=False), np.array(1.0), np.array(0.01)) == pytest.approx(
        4 * v[0]
    )


def test_strong_concrete_counts_up_to_a_limit() -> None:
    """(f'c)^(1/2) is 8.3 MPa at most, that of 69 MPa (22.5.3.1)."""
    assert Concrete(90e6).root == pytest.approx(8.3e6)
    assert C30.root == pytest.approx(5.4772e6, rel=1e-4)


def test_links_carry_the_rest_and_have_a_limit() -> None:
    """Phi (v_c + a_v f_yt d) is the demand; beyond phi 0.826 (f'c)^(1/2) d none help; few are needed in any case."""
    d, steel = 0.4, Steel(500e6)
    most = 0.75 * 0.826 * math.sqrt(30) * 1e6 * d
    area = shear.links(0.9 * most, d, C30, steel)
    assert 0.75 * (0.166 * math.sqrt(30) * 1e6 * d + area * 413.6e6 * d) == pytest.approx(0.9 * most)
    assert math.isinf(shear.links(1.001 * most, d, C30, steel))
    assert shear.links(1.0, d, C30, steel) == pytest.approx(0.35 / 413.6)


@pytest.mark.parametrize(
    ("d", "b_o", "beta", "alpha_s", "factor"),
    [
        (0.25, 2.0, 1.0, 40.0, 0.33),  # a square column in a thin slab
        (0.25, 2.0, 4.0, 40.0, 0.166 * 1.5),  # a long one
        (0.2, 8.0, 1.0, 20.0, 0.083 * 2.5),  # a large one at a corner
    ],
)
def test_two_way_shear_by_hand(d: float, b_o: float, beta: float, alpha_s: float, factor: float) -> None:
    """Each of the three expressions of Table 22.6.5.2 where it governs; d up to 250 mm has no size effect."""
    v_c = punching.without_links(C30, d, b_o, beta, alpha_s)
    assert v_c == pytest.approx(factor * math.sqrt(30) * 1e6)


def test_polar_moment_by_quadrature() -> None:
    """J_c is the integral of e^2, and of z^2 on sides along the eccentricity, over the faces of the section."""
    d, n = 0.3, 400
    legs = np.array([[[-0.4, -0.3], [0.5, -0.3]], [[0.5, -0.3], [0.5, 0.6]], [[0.5, 0.6], [-0.1, 0.9]]])
    at, z = (np.arange(n) + 0.5) / n, ((np.arange(n) + 0.5) / n - 0.5) * d
    expected = np.zeros(2)
    for start, end in legs:
        length, cos2 = np.linalg.norm(end - start), ((end - start) / np.linalg.norm(end - start)) ** 2
        e = start + at[:, None] * (end - start)
        for axis in (0, 1):
            expected[axis] += (e[:, None, axis] ** 2 + z**2 * cos2[axis]).mean() * length * d
    assert np.diag(punching.polar_moments(legs, np.zeros(2), d)) == pytest.approx(expected, rel=1e-4)


def test_polar_moment_of_a_rectangle() -> None:
    """D (a^3 / 6 + b a^2 / 2) + a d^3 / 6, the commentary's R8.4.4.2.3 for a column inside."""
    a, b, d = 0.9, 0.7, 0.4
    J = np.diag(punching.polar_moments(rectangle(a, b), np.zeros(2), d))
    assert J[0] == pytest.approx(d * (a**3 / 6 + b * a**2 / 2) + a * d**3 / 6)
    assert J[1] == pytest.approx(d * (b**3 / 6 + a * b**2 / 2) + b * d**3 / 6)


def test_stress_with_a_moment() -> None:
    """A square section, gamma_v = 0.4: V / (b_o d) + 0.4 M (b / 2) / J on one side."""
    b, d, V, M = 0.8, 0.35, 900e3, 200e3
    J = d * (b**3 / 6 + b**3 / 2) + b * d**3 / 6
    legs = rectangle(b, b)
    v_u = punching.stress(V, np.array([M, 0.0]), legs, d)
    assert v_u == pytest.approx(V / (4 * b * d) + 0.4 * M * b / 2 / J)
    assert punching.stress(V, np.array([0.0, -M]), legs, d) == pytest.approx(v_u)
    assert punching.gamma_v(1.0, 1.0) == pytest.approx(0.4)


def test_stirrups_around_a_column() -> None:
    """v_c of 0.166 and the stirrups carry v_u / phi; 0.498 (f'c)^(1/2) is the most (22.6.6.3)."""
    d, b_o, v_u, steel = 0.25, 2.4, 1.6e6, Steel(420e6)
    per_meter = punching.links(v_u, d, b_o, C30, steel)
    assert 0.75 * (0.166 * math.sqrt(30) * 1e6 + per_meter * 413.6e6 / b_o) == pytest.approx(v_u)
    assert punching.most_with_links(C30) == pytest.approx(0.498 * math.sqrt(30) * 1e6)
