"""A model is analyzed about its own center, wherever it lies: the only place where plans are moved.

Coordinates of national grids leave too few digits for products of coordinates, such as moments and areas. So the
analysis moves the model first, and its results back at the end (docs/decisions/0026-plan-origin.md).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from groundslab.geometry.plan import Place
from groundslab.schema.places import move

if TYPE_CHECKING:
    from groundslab.model.model import Model


def plan_origin(model: Model) -> Place:
    """Return where x = y = 0 is to lie for the analysis of a model [m]: at its middle, but for a tenth of its size."""
    if model.plate.outline is None:  # a rectangle about x = y = 0
        return 0.0, 0.0
    x0, x1, y0, y1 = model.bounds
    digits = 1 - math.floor(math.log10(max(x1 - x0, y1 - y0)))
    return round((x0 + x1) / 2, digits), round((y0 + y1) / 2, digits)


def move_to_center(model: Model) -> Model:
    """Return a model about its own center, itself if it is there already; it knows its `origin`.

    Coordinates keep the decimals that those given have in double precision. So models that differ by where they lie are
    one and the same, down to the last digit. Raises InputError of a subclass of Model.
    """
    from groundslab.model.model import Model

    # a subclass would be solved by what no file says of it
    Model.model_validate(model)
    origin = plan_origin(model)
    if origin == (0.0, 0.0):
        return model
    x0, x1, y0, y1 = model.bounds
    digits = math.floor(-math.log10(math.ulp(max(map(abs, (x0, x1, y0, y1))))))
    return move(model, (-origin[0], -origin[1]), digits).with_origin(origin)
