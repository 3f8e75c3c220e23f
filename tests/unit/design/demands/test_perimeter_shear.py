"""Shear forces along a perimeter, contraflexure, and what counts of long straight parts."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from groundslab.design.demands.line_properties import limited_straights, total_length
from groundslab.design.demands.perimeter_shear import contraflexure, moment_lines, perimeter_shear
from groundslab.design.demands.perimeters import Openings, RectangularColumn, perimeter_at, surroundings
from groundslab.results.plate_result import PlateResult
from helpers import synthetic


def radial(force: float = 100.0, turned: float = 0.0) -> PlateResult:
    """Return a plate whose shear forces run away from its middle, force / (2 pi r) [N/m], and more by x."""
    plate = synthetic.results(40).plate
    r = np.maximum(np.hypot(*plate.nodes.T), 1e-9)
    size = -force / (2 * math.pi * r) * (1 + turned * plate.nodes[:, 0] / r)
    return replace(plate, shear_x=size * plate.nodes[:, 0] / r, shear_y=size * plate.nodes[:, 1] / r)


def circle(radius: float, count: int = 256) -> np.ndarray:
    """Return the places around a circle, the first one again at the end."""
    angle = np.linspace(0, 2 * math.pi, count + 1)
    places = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    places[-1] = places[0]
    return places


def test_a_radial_flow_is_even() -> None:
    """The mean over any length is the force over the circumference; away from the support it has the other sign."""
    plate = radial()
    shear = perimeter_shear(plate, circle(0.5), np.zeros(2), 0.6)
    assert shear is not None
    assert shear.closed
    assert shear.largest_mean(plate, 0.6) == pytest.approx(100 / math.pi, rel=2e-2)
    assert shear.largest_mean(plate, 100.0) == pytest.approx(100 / math.pi, rel=2e-2)
    assert shear.largest_mean(plate, 0.6, -1.0) == pytest.approx(-100 / math.pi, rel=2e-2)


def test_a_mean_is_over_its_length() -> None:
    """Of q (1 + t cos phi) over an arc of the half angle a the largest mean is q (1 + t sin a / a)."""
    plate, over = radial(turned=0.5), 0.8
    shear = perimeter_shear(plate, circle(0.5), np.zeros(2), over)
    assert shear is not None
    half = over / 0.5 / 2
    assert shear.largest_mean(plate, over) == pytest.approx(100 / math.pi * (1 + 0.5 * math.sin(half) / half), rel=2e-2)


def test_contraflexure_of_a_known_field() -> None:
    """m_x = 1 - (x / 0.6)^2 and m_y = 1 - (y - 0.1) / 0.5: zero at 0.6, and the farther of 0.6 and the edge."""
    plate = synthetic.results(40).plate
    x, y = plate.nodes.T
    plate = replace(plate, moment_x=1 - (x / 0.6) ** 2, moment_y=1 - (y - 0.1) / 0.5)
    edge = float(-y.min())
    lines = moment_lines(plate, np.zeros(2), 10.0)
    along_x, along_y = contraflexure(lines, plate, 1.0)
    assert along_x == pytest.approx(0.6, rel=1e-2)
    assert along_y == pytest.approx(max(0.6, edge), rel=5e-2)
    near = moment_lines(plate, np.zeros(2), 0.3)
    assert contraflexure(near, plate, 1.0) == (math.inf, math.inf)
    assert contraflexure(lines, plate, -1.0)[0] == math.inf  # not the tension that the force makes


def test_long_straight_parts_count_at_their_ends() -> None:
    """Of a rectangle of 2 m by 0.5 m 0.6 m count of each long side, half at each end, wherever the ring begins."""
    corners = np.array([[0, 0], [1.2, 0], [2, 0], [2, 0.5], [0, 0.5]])
    for start in range(5):
        ring = np.roll(corners, -start, axis=0)
        legs = np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)
        counted = limited_straights(legs, 0.6)
        assert total_length(counted) == pytest.approx(2 * 0.6 + 2 * 0.5)
        middles = counted.mean(axis=1)
        assert not ((middles[:, 0] > 0.3) & (middles[:, 0] < 1.7)).any()
    assert total_length(limited_straights(legs, 2.0)) == pytest.approx(5.0)
    assert len(limited_straights(legs[:0], 1.0)) == 0


def test_arcs_are_not_straight() -> None:
    """Around a long column arcs count in full, of its sides 3 d: b_0.5 = 2 (3 d) + 2 c + pi d."""
    plate = synthetic.results(40).plate
    column, d = RectangularColumn(0.0, 0.0, 0.6, 0.2), 0.12
    around = surroundings(plate, column, d, Openings())
    line = perimeter_at(around, d / 2)
    found = total_length(limited_straights(line.whole, 3 * d))
    assert found == pytest.approx(6 * d + 2 * 0.2 + math.pi * d, rel=1e-4)
    assert line.loaded.equals(column.footprint())
