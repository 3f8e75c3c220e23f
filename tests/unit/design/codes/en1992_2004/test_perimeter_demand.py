"""The demand of punching on one perimeter: forces against fields that are formulas, faults with their place."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.design.codes.en1992_2004.perimeter_demand import RectangularColumn, RoundColumn, demand
from groundslab.errors import InputError
from helpers.plates import crooked, plate_of, straight

SLAB = plate_of(straight(16, 12, 8.0, 6.0))
#: Circles are followed by chords, a little shorter than their arcs.
CHORDS = 5e-5


@pytest.mark.slow
def test_forces_by_formulas() -> None:
    """A pressure linear in x and a source of shear: V, the pressure inside and the shear along the way as by hand."""
    plate = plate_of(
        crooked(9, 7, 8.0, 6.0),
        pressure=lambda x, y: 3e4 + 2e3 * (x - 4) - 1e3 * (y - 3),
        shear_x=lambda x, _: -5e4 * (x - 4),
        shear_y=lambda _, y: -3e4 * (y - 3),
    )
    column, d, distance = RoundColumn(4, 3, 0.4), 0.3, 0.7
    found = demand(plate, column, d, 9e5, distributed=7e3, distance=distance)
    area, around = np.pi * 0.81, 2 * np.pi * 0.9
    assert found.area == pytest.approx(area, rel=2e-4)
    assert found.pressure_inside == pytest.approx(3e4 * area, rel=2e-4)
    assert found.V_Ed == pytest.approx(9e5 - 3e4 * area + 7e3 * area, rel=1e-5)
    assert found.v_Ed == pytest.approx(found.V_Ed / (around * d), rel=CHORDS)
    assert found.shear == pytest.approx(8e4 * found.area, rel=1e-6)  # the divergence theorem
    assert found.largest == pytest.approx(5e4 * 0.9, rel=1e-3)


def test_two_depths_unless_given() -> None:
    """The basic control perimeter is two effective depths away (6.4.2 (1))."""
    assert demand(SLAB, RoundColumn(4, 3, 0.4), 0.3, 1e5).u == pytest.approx(2 * np.pi * 0.8, rel=CHORDS)


@pytest.mark.parametrize(
    ("column", "d", "distance", "place"),
    [
        (RoundColumn(4, 3, 0.4), 0.0, 1.0, "d"),
        (RoundColumn(4, 3, 0.4), 0.3, -1.0, "distance"),
        (RoundColumn(8, 3, 0.4), 0.3, 1.0, "column"),
        (RectangularColumn(4, 3, 0.0, 0.4), 0.3, 1.0, "column"),
        (RoundColumn(4, 3, 0.4), 0.3, 20.0, "column"),
    ],
)
def test_faults(column: RectangularColumn | RoundColumn, d: float, distance: float, place: str) -> None:
    """A column off the plate, or a perimeter of which nothing is on the plate, is refused with its place."""
    with pytest.raises(InputError) as caught:
        demand(SLAB, column, d, 1e5, distance=distance)
    assert [issue.location for issue in caught.value.issues] == [place]
