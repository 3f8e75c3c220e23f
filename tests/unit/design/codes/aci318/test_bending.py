"""Bending by ACI 318: sections that carry exactly their moment, limits, the least bars of a slab."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from groundslab.design.codes.aci318.bending import deepest_axis, minimum, required
from groundslab.design.codes.aci318.materials import Concrete, Steel
from groundslab.errors import InputError

GRADE_60 = Steel(420e6)


def strength(f_c: float, d: float, d_2: float, A_s: float, A_s2: float) -> tuple[float, float, float]:
    """Return phi M_n [N m/m], c [m] and the strain of the bars in tension, written a second time from chapter 22.

    c is sought by bisection so that the forces of the strain plane add up to nothing.
    """
    beta_1 = min(0.85, max(0.65, 0.85 - 0.05 * (f_c / 1e6 - 27.57) / 6.89))  # from 4000 psi on, by 1000 psi

    def forces(c: float) -> tuple[float, float, float]:
        tension = A_s * min(200e9 * 0.003 * (d - c) / c, 420e6)
        compressed = A_s2 * max(-420e6, min(200e9 * 0.003 * (c - d_2) / c, 420e6))
        return 0.85 * f_c * beta_1 * c, compressed, tension

    low, high = 1e-6, d
    for _ in range(200):
        c = (low + high) / 2
        block, compressed, tension = forces(c)
        low, high = (c, high) if block + compressed < tension else (low, c)
    M_n = block * (d - beta_1 * c / 2) + compressed * (d - d_2)
    return 0.9 * M_n, c, 0.003 * (d - c) / c


@given(st.floats(18e6, 60e6), st.floats(0.1, 1.5), st.floats(0.01, 0.999))
def test_bars_carry_their_moment(f_c: float, d: float, share: float) -> None:
    """With the bars found, phi M_n is the moment, and the section is controlled by tension."""
    concrete, xi = Concrete(f_c), deepest_axis(GRADE_60)
    a = concrete.beta_1 * xi
    m = share * 0.9 * 0.85 * f_c * a * (1 - a / 2) * d**2
    found = required(np.array(m), d, concrete, GRADE_60)
    carried, c, strain = strength(f_c, d, 0.0, float(found.tension), 0.0)
    assert carried == pytest.approx(m, rel=1e-9)
    assert c / d == pytest.approx(float(found.neutral_axis), rel=1e-9)
    assert strain >= 0.0021 + 0.003 - 1e-12


@given(st.floats(1.01, 1.6), st.floats(0.05, 0.3))
def test_bars_in_compression_take_the_rest(times: float, ratio: float) -> None:
    """Beyond the limit of tension control both layers together carry the moment, at that limit."""
    concrete, d, xi = Concrete(30e6), 0.5, deepest_axis(GRADE_60)
    a = concrete.beta_1 * xi
    m = times * 0.9 * 0.85 * 30e6 * a * (1 - a / 2) * d**2
    found = required(np.array(m), d, concrete, GRADE_60, d_2=ratio * d)
    carried, c, _ = strength(30e6, d, ratio * d, float(found.tension), float(found.compression))
    assert carried == pytest.approx(m, rel=1e-6)
    assert c / d == pytest.approx(xi, rel=1e-6)
    assert required(np.array(m), d, concrete, GRADE_60).fails


def test_limit_of_tension_control() -> None:
    """Table 21.2.2: 0.003 / (0.003 + 420 / 200000 + 0.003) = 0.3704 for Grade 420."""
    assert deepest_axis(GRADE_60) == pytest.approx(0.003 / 0.0081)


def test_least_bars() -> None:
    """0.0018 of the gross area where there is a moment, none where there is none; the thickness is needed."""
    found = required(np.array([0.0, 1.0]), 0.45, Concrete(30e6), GRADE_60, thickness=0.5)
    assert found.area == pytest.approx([0.0, 0.0009], rel=1e-12)
    with pytest.raises(InputError, match="thickness"):
        minimum(np.array(0.45))


def test_weak_concrete_is_refused() -> None:
    """Less than 17 MPa is no structural concrete (19.2.1.1)."""
    with pytest.raises(InputError, match="17 MPa"):
        Concrete(16e6)
