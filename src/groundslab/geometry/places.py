"""When places in plan are one, which depends on how far from x = y = 0 they are."""

from __future__ import annotations

import math

from groundslab.geometry.plan import SAME_PLACE, Plan

#: Places are not told apart by less than so many steps of double precision.
ROUNDED = 4


def same_place(x0: float, x1: float, y0: float, y1: float) -> float:
    """Return how far apart places are that count as one [m], of a plan within a rectangle.

    No less than coordinates are rounded, which is much far from x = y = 0.
    """
    rounding = math.ulp(max(map(abs, (x0, x1, y0, y1))))
    return max(SAME_PLACE * max(x1 - x0, y1 - y0), ROUNDED * rounding)


def same_place_in(plan: Plan) -> float:
    """Return how far apart places of a plan are that count as one [m]."""
    x0, y0, x1, y1 = plan.bounds
    return same_place(x0, x1, y0, y1)
