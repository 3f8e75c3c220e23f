"""Crack widths: a published calculation, the cracked section by strips, limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.cracking import Bars
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel

C25, B500 = Concrete(25e6), Steel(500e6)


def test_a_published_calculation() -> None:
    """calculocivil.com's example as kept by the program XC: 0.4 x 0.3 m, 3 bars of 16 mm, cover 35 mm, C25, 175.74 MPa.

    It takes twice the distance of the bars as the effective depth in tension, 0.086 m, and 0.17 m of spacing.
    """
    area, depth, sigma_s = 3 * math.pi * 0.016**2 / 4 / 0.4, 0.086, np.array([175.74e6])
    rho = np.array([area / depth])
    bars = Bars(0.016, 0.17, 0.035)
    s_r = cracking.largest_spacing(bars, np.array([0.3]), np.array([0.0599]), rho)
    strain = cracking.mean_strain(sigma_s, rho, C25, B500)
    assert s_r == pytest.approx([0.274123], rel=1e-5)
    assert strain == pytest.approx([5.5354e-4], rel=1e-4)
    assert s_r * strain == pytest.approx([0.151738e-3], rel=1e-4)


@given(st.floats(0.1, 1.5), st.floats(1e-4, 5e-3), st.floats(5, 30))
def test_the_cracked_section_is_in_equilibrium(d: float, area: float, ratio: float) -> None:
    """Compression of the concrete and tension of the bars are equal and make up the moment."""
    x = cracking.neutral_axis(np.array([d]), np.array([area]), ratio)[0]
    sigma_s = cracking.steel_stress(np.array([1e5]), np.array([d]), np.array([area]), ratio)[0]
    assert 0 < x < d
    y = np.linspace(0, x, 2001)
    sigma_c = sigma_s / ratio * (x - y) / (d - x)
    assert np.trapezoid(sigma_c, y) == pytest.approx(area * sigma_s, rel=1e-6)
    assert np.trapezoid(sigma_c * (d - y), y) == pytest.approx(1e5, rel=1e-6)


def test_width_grows_with_moment_and_spacing() -> None:
    """More moment, wider cracks; the same bars with twice the distance, wider ones still."""
    close, far = Bars(0.012, 0.15, 0.04), Bars(0.012, 0.30, 0.04)
    m = np.array([50e3, 80e3, 120e3])
    widths = cracking.crack_width(m, np.array(0.3), close, C25, B500)
    assert (np.diff(widths) > 0).all()
    assert (cracking.crack_width(m, np.array(0.3), far, C25, B500) > widths).all()


def test_bars_far_apart_have_the_free_spacing() -> None:
    """Beyond 5 (c + phi / 2) = 230 mm the spacing is 1.3 (h - x)."""
    far = cracking.largest_spacing(Bars(0.012, 0.231, 0.04), np.array([0.3]), np.array([0.05]), np.array([0.01]))
    near = cracking.largest_spacing(Bars(0.012, 0.229, 0.04), np.array([0.3]), np.array([0.05]), np.array([0.01]))
    assert far == pytest.approx([0.325])
    assert near == pytest.approx([3.4 * 0.04 + 0.8 * 0.5 * 0.425 * 0.012 / 0.01])


@pytest.mark.parametrize(("h", "k"), [(0.2, 1.0), (0.3, 1.0), (0.55, 0.825), (0.8, 0.65), (1.5, 0.65)])
def test_least_bars(h: float, k: float) -> None:
    """7.1 with k_c = 0.4 and half of the section in tension."""
    found = cracking.minimum_area(np.array([h]), C25, 500e6)
    assert found == pytest.approx([0.4 * k * C25.f_ctm * h / 2 / 500e6])
