"""Areas: their centers and second moments, with holes."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import Polygon, box
from shapely.affinity import rotate

from groundslab.geometry.areas import inertia


def test_a_hole_is_taken_off() -> None:
    """A frame of 6 m by 4 m around a hole of 2 m by 1 m that lies to one side, by Steiner's theorem."""
    around, hole = (6.0, 4.0, 0.0), (2.0, 1.0, 1.5)
    area = 24.0 - 2.0
    centre, moments = inertia(box(-3, -2, 3, 2).difference(box(0.5, -0.5, 2.5, 0.5)))
    x = -2.0 * hole[2] / area
    assert centre == pytest.approx([x, 0.0])
    I_xx = around[1] * around[0] ** 3 / 12 + 24 * x**2 - hole[1] * hole[0] ** 3 / 12 - 2 * (hole[2] - x) ** 2
    I_yy = around[0] * around[1] ** 3 / 12 - hole[0] * hole[1] ** 3 / 12
    assert moments == pytest.approx(np.diag([I_xx, I_yy]), abs=1e-12)


def test_either_way_around_and_turned() -> None:
    """The direction of a ring does not matter, and principal moments are the same in a turned plan."""
    part = Polygon([(0, 0), (0, 3), (5, 3), (5, 0)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    other = Polygon([(0, 0), (5, 0), (5, 3), (0, 3)], [[(1, 1), (1, 2), (2, 2), (2, 1)]])
    (_, one), (_, same), (_, turned) = inertia(part), inertia(other), inertia(rotate(part, 30))
    assert one == pytest.approx(same)
    assert np.linalg.eigvalsh(turned) == pytest.approx(np.linalg.eigvalsh(one))
