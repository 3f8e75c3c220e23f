"""Design moments: they cover the bending moment in every direction, and no smaller sum would."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.design.demands.design_moments import principal_moments, wood_armer
from helpers.examples import examples

MOMENTS = st.floats(-100, 100).map(lambda value: round(value, 3))
ANGLES = np.linspace(0, np.pi, 721)


def one(function, *moments: float):
    """Return what a function makes of one point's moments."""
    return function(*(np.array([moment]) for moment in moments))


def bending(m_x: float, m_y: float, m_xy: float) -> np.ndarray:
    """Return the bending moment of strips in every direction, by the transformation of a symmetric tensor."""
    return m_x * np.cos(ANGLES) ** 2 + m_y * np.sin(ANGLES) ** 2 + 2 * m_xy * np.sin(ANGLES) * np.cos(ANGLES)


@pytest.mark.slow
@settings(max_examples=examples(200), deadline=None, derandomize=True)
@given(MOMENTS, MOMENTS, MOMENTS)
def test_principal_moments_are_the_extremes(m_x: float, m_y: float, m_xy: float) -> None:
    """m_1 and m_2 are the largest and smallest bending moments of all directions, m_1 in its own direction."""
    found = one(principal_moments, m_x, m_y, m_xy)
    tensor = np.array([[m_x, m_xy], [m_xy, m_y]])
    np.testing.assert_allclose([found.m_2[0], found.m_1[0]], np.linalg.eigvalsh(tensor), atol=1e-10)
    along = np.array([np.cos(found.direction[0]), np.sin(found.direction[0])])
    assert along @ tensor @ along == pytest.approx(found.m_1[0], abs=1e-9)


@pytest.mark.slow
@settings(max_examples=examples(300), deadline=None, derandomize=True)
@given(MOMENTS, MOMENTS, MOMENTS)
def test_design_moments_cover_every_direction(m_x: float, m_y: float, m_xy: float) -> None:
    """Reinforcement for the design moments resists sagging and hogging in all directions, and is never negative."""
    found = one(wood_armer, m_x, m_y, m_xy)
    acting = bending(m_x, m_y, m_xy)
    for x, y, sign in ((found.bottom_x[0], found.bottom_y[0], 1), (found.top_x[0], found.top_y[0], -1)):
        assert sign * x >= 0
        assert sign * y >= 0
        assert (sign * bending(x, y, 0) - sign * acting >= -1e-9).all()


@pytest.mark.slow
@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(MOMENTS, MOMENTS, MOMENTS)
def test_no_smaller_sum_would_do(m_x: float, m_y: float, m_xy: float) -> None:
    """Of all pairs on a fine net that cover every direction none has a smaller sum than the design moments."""
    found = one(wood_armer, m_x, m_y, m_xy)
    acting = bending(m_x, m_y, m_xy)
    x = np.linspace(0, 250, 126)
    squares = np.cos(ANGLES) ** 2, np.sin(ANGLES) ** 2
    # for each x* the least y* that covers all directions but the one along x, where y* does not count
    off_axis = squares[1] > 1e-9
    least = ((acting - x[:, None] * squares[0])[:, off_axis] / squares[1][off_axis]).max(axis=1)
    y = np.maximum(least, 0)
    covered = (x[:, None] * squares[0] + y[:, None] * squares[1] >= acting - 1e-9).all(axis=1) & (x >= m_x)
    between_directions = 2e-3
    assert found.bottom_x[0] + found.bottom_y[0] <= (x + y)[covered].min() + between_directions


def test_known_states() -> None:
    """Pure twist asks for its size everywhere; without twist the moments themselves; hogging asks nothing below."""
    twist = one(wood_armer, 0, 0, 7)
    assert [m[0] for m in (twist.bottom_x, twist.bottom_y, twist.top_x, twist.top_y)] == [7, 7, -7, -7]
    plain = one(wood_armer, 5, -3, 0)
    assert [m[0] for m in (plain.bottom_x, plain.bottom_y, plain.top_x, plain.top_y)] == [5, 0, 0, -3]
    mixed = one(wood_armer, -10, 8, 4)
    assert mixed.bottom_x[0] == 0
    assert mixed.bottom_y[0] == pytest.approx(8 + 16 / 10)
