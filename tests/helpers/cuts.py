"""A single straight cut through a plate."""

from typing import NamedTuple

import numpy as np

from groundslab.design.demands.cuts.section_cuts import strip
from groundslab.results.plate_result import PlateResult


class Cut(NamedTuple):
    """What a cut transfers."""

    moment: float
    shear: float
    length: float


def cut_plate(plate: PlateResult, a: tuple[float, float] | np.ndarray, b: tuple[float, float] | np.ndarray) -> Cut:
    """Return the forces on the cut from a to b, n to the right of this way: that across the start of a strip.

    The strip's other station lies far off the plate.
    """
    a, b = np.array(a, dtype=float), np.array(b, dtype=float)
    middle, run = (a + b) / 2, b - a
    found = strip(plate, middle, middle + 1e3 * np.array([run[1], -run[0]]), float(np.hypot(*run)), 2)
    return Cut(*(float(each[0]) for each in (found.moment, found.shear, found.length)))
