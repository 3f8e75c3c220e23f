"""Tilt and settlement differences of plates whose settlement is a formula."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.design.demands.tilt import deflections_between, settlement_differences, tilt
from groundslab.errors import InputError
from helpers.examples import examples
from helpers.plates import crooked, plate_of, straight

SLOPES = st.floats(-5e-3, 5e-3)
POINTS = {"A": (0.5, 0.5), "B": (5.5, 0.5), "C": (5.5, 3.5), "D": (3.0, 2.0)}


@pytest.mark.slow
@settings(max_examples=examples(40), deadline=None, derandomize=True)
@given(a=SLOPES, b=SLOPES, c=st.floats(0, 0.1))
def test_a_plane_is_its_own_best_fit(a: float, b: float, c: float) -> None:
    """A plate that stays flat has the tilt of its plane and no deflection; pairs of points have no relative one."""
    plate = plate_of(crooked(), settlement=lambda x, y: c + a * x + b * y)
    found = tilt(plate)
    np.testing.assert_allclose([found.tilt_x, found.tilt_y], [a, b], atol=1e-12)
    assert found.tilt == pytest.approx(np.hypot(a, b), abs=1e-12)
    assert abs(found.deflection) < 1e-12
    assert found.settlement == pytest.approx(c + a * found.center[0] + b * found.center[1])
    assert settlement_differences(plate, POINTS).relative.max() < 1e-11


def test_a_bowl_on_a_slope() -> None:
    """On a rectangle an even bowl does not tilt the plane: mean and deflection are those of the integrals by hand."""
    plate = plate_of(straight(8, 6), settlement=lambda x, y: 2e-3 * (x - 3) + 1e-3 * (x - 3) ** 2 + 4e-3 * (y - 2) ** 2)
    found = tilt(plate)
    mean = 1e-3 * 3**2 / 3 + 4e-3 * 2**2 / 3
    assert found.center == pytest.approx((3, 2))
    assert (found.settlement, found.tilt_x) == pytest.approx((mean, 2e-3))
    assert found.tilt_y == pytest.approx(0, abs=1e-12)
    assert found.direction == pytest.approx(0, abs=1e-9)
    assert found.deflection == pytest.approx(9e-3 + 16e-3 - mean)
    assert np.abs(np.array(found.place) - [3, 2]) == pytest.approx([3, 2])  # one of the corners


def test_the_plate_goes_down_towards_the_direction() -> None:
    """The direction points to where the settlement grows, and the fit ignores how finely each part is meshed."""
    x = np.concatenate([np.linspace(0, 1, 21), np.linspace(1, 6, 5)[1:]])
    uneven = straight(24, 4)
    nodes = uneven.nodes.copy()
    nodes[:, 0] = np.interp(uneven.nodes[:, 0], np.linspace(0, 6, 25), x)
    plate = plate_of(type(uneven)(nodes, uneven.elements), settlement=lambda x, y: 1e-3 * (x - 3) ** 2 - 1e-3 * y)
    found = tilt(plate)
    assert found.direction == pytest.approx(-np.pi / 2, abs=1e-6)
    assert found.tilt_x == pytest.approx(0, abs=1e-9)


def test_differences_between_columns() -> None:
    """Every pair once: difference of the second less the first, over the distance; the worst is named."""
    plate = plate_of(crooked(), settlement=lambda x, y: 1e-3 * x**2 - 1e-3 * y)
    found = settlement_differences(plate, POINTS)
    w = {name: 1e-3 * x**2 - 1e-3 * y for name, (x, y) in POINTS.items()}
    pairs = [(found.names[i], found.names[j]) for i, j in zip(found.first, found.second, strict=True)]
    assert pairs == [("A", "B"), ("A", "C"), ("A", "D"), ("B", "C"), ("B", "D"), ("C", "D")]
    np.testing.assert_allclose(found.settlement, list(w.values()))
    for k, (one, other) in enumerate(pairs):
        apart = np.hypot(*(np.array(POINTS[one]) - POINTS[other]))
        assert found.distance[k] == pytest.approx(apart)
        assert found.difference[k] == pytest.approx(w[other] - w[one])
        assert found.distortion[k] == pytest.approx(abs(w[other] - w[one]) / apart)
    assert found.worst == max(pairs, key=lambda pair: found.distortion[pairs.index(pair)])


@pytest.mark.parametrize(
    ("points", "places"),
    [
        ({"A": (1.0, 1.0)}, ["points"]),
        ({"A": (1.0, 1.0), "B": (9.0, 1.0), "C": (1.0, -1.0)}, ["points['B']", "points['C']"]),
        ({"A": (1.0, 1.0), "B": (1.0, 1.0)}, ["points['B']"]),
    ],
)
def test_faults(points: dict, places: list[str]) -> None:
    """Too few points, points off the plate, and two points at one place are refused, all at once."""
    with pytest.raises(InputError) as caught:
        settlement_differences(plate_of(straight()), points)
    assert [issue.location for issue in caught.value.issues] == places


def test_deflection_between_neighbors_is_off_the_chord() -> None:
    """On w = c x^2 the middle of a pair along x is c L^2 / 4 off the chord; not so with a column between."""
    c, plate = 1e-3, plate_of(straight(), settlement=lambda x, y: 1e-3 * x**2 + 0.02 * y)
    found = deflections_between(plate, {"A": (0.0, 1.0), "B": (2.0, 1.0), "C": (6.0, 1.0), "D": (2.0, 3.0)})
    ratios = {sag.names: sag.ratio for sag in found}
    assert set(ratios) == {("A", "B"), ("B", "C"), ("B", "D"), ("A", "D"), ("C", "D")}
    assert ratios["A", "B"] == pytest.approx(c * 2 / 4, rel=1e-9)
    assert ratios["B", "C"] == pytest.approx(c * 4 / 4, rel=1e-9)
    assert ratios["B", "D"] == pytest.approx(0.0, abs=1e-12)
