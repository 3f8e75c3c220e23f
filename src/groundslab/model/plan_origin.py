"""A model far from x = y = 0 is analyzed about its own center: the only place where plans are moved.

Coordinates of national grids leave too few digits for products of coordinates, such as moments and areas. So the
analysis moves the model first, and its results back at the end (docs/decisions/0026-plan-origin.md).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from groundslab.geometry.plan import Place
from groundslab.schema.base import move

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: A model whose middle is further from x = y = 0 than so many times its longer side is far.
FAR = 8
#: The new origin is the middle but for this share of the longer side: a round binary number, so that coordinates can
#: be moved there and back without rounding.
ROUND = 2.0**-6


def plan_origin(model: Model) -> Place:
    """Return where x = y = 0 is to lie for the analysis of a model [m]: at the model's middle if that is far off."""
    if model.plate.outline is None:  # a rectangle about x = y = 0
        return 0.0, 0.0
    x0, x1, y0, y1 = model.bounds
    size = max(x1 - x0, y1 - y0)
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    if max(map(abs, middle)) <= FAR * size:
        return 0.0, 0.0
    step = 2.0 ** math.floor(math.log2(ROUND * size))
    x, y = (step * round(value / step) for value in middle)
    return x, y


def move_to_center(model: Model) -> Model:
    """Return a model about its own center if it is far from x = y = 0, itself otherwise; it knows its `origin`."""
    origin = plan_origin(model)
    if origin == (0.0, 0.0):
        return model
    moved = move(model, (-origin[0], -origin[1]))
    return moved.with_origin((model.origin[0] + origin[0], model.origin[1] + origin[1]))
