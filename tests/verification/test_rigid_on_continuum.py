"""Rigid rectangles on a half-space converge to the exact settlement with the first power of the cells' size."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.verification.analytic_continuum import rigid_circle_on_half_space, rigid_rectangle_on_half_space


def settlements(b: float, e: float, cell: float, places: list[float]) -> np.ndarray:
    """Return settlements on the axis of a rigid rectangle 4 m x b under 1 MN at e, on cells of a size."""
    model = Model(
        plate={"length_x": 4.0, "length_y": b, "thickness": 1.0, "E": 20e12, "nu": 0.0},
        ground={"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}, "cell": cell},
        loads=[{"kind": "point", "P": 1e6, "x": e, "y": 0.0}],
        mesh={"counts": (8, round(2 * b))},
    )
    plate = solve(model).plate
    return np.array([plate.value_at("settlement", x, 0.0) for x in places])


@pytest.mark.slow
@pytest.mark.parametrize(("b", "e"), [(4.0, 0.0), (2.0, 0.4)])
def test_extrapolated_from_two_sizes_of_cells(b, e):
    """Errors halve with the cells; extrapolated so, settlement and tilt are exact to 0.02 %."""
    places = [-1.5, 0.0, 1.5]
    exact = np.array([rigid_rectangle_on_half_space(x, 4.0, b, 1e6, 20e6, 0.3, e) for x in places])
    coarse, fine = settlements(b, e, 1 / 16, places), settlements(b, e, 1 / 32, places)
    assert (coarse - exact) / (fine - exact) == pytest.approx(2.0, abs=0.1)
    assert 2 * fine - coarse == pytest.approx(exact, rel=2e-4)


def test_square_by_its_capacitance():
    """A grid graded to its edges gives what the capacitance of a square plate, 0.3667896 of its side, gives."""
    assert rigid_rectangle_on_half_space(0.0, 1.0, 1.0, 1.0, 1.0, 0.0) == pytest.approx(
        1 / (np.pi * 0.3667896), rel=3e-5
    )


def test_a_circle_beyond_its_kern_is_refused():
    """The closed form holds as long as all of the circle presses."""
    with pytest.raises(ValueError, match="lifts off"):
        rigid_circle_on_half_space(0.0, 1.0, 1.0, 1.0, 0.0, 0.34)
