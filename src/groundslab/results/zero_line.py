"""What of an element lies on one side of the line on which a field is zero."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.shape_functions import q9

#: Elements are divided into so many parts along each side, on each half of which the field is taken as linear.
PARTS = 8


def share_below_zero(values: Array) -> Array:
    """Return the share (m,) of each element's area on which a field is negative, by its values (m, 9) at the nodes.

    Elements are taken as parallelograms.
    """
    steps = np.linspace(-1.0, 1.0, PARTS + 1)
    points = np.column_stack([each.ravel() for each in np.meshgrid(steps, steps)])
    at = (values @ q9(points)[0].T).reshape(-1, PARTS + 1, PARTS + 1)
    low, right, up, far = at[:, :-1, :-1], at[:, :-1, 1:], at[:, 1:, :-1], at[:, 1:, 1:]
    halves = np.stack([np.stack([low, right, far], axis=-1), np.stack([low, up, far], axis=-1)], axis=-2)
    share: Array = _share_of_triangles(halves).mean(axis=(1, 2, 3))
    return share


def _share_of_triangles(corners: Array) -> Array:
    """Return the share (...) of triangles on which a linear field is negative, by its values at the corners (..., 3).

    A corner alone on its side of the line cuts off a triangle whose sides are a / (a - b) of those that meet in it.
    """
    least, middle, most = np.moveaxis(np.sort(corners, axis=-1), -1, 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        one_below = least**2 / ((least - middle) * (least - most))
        one_above = 1 - most**2 / ((most - middle) * (most - least))
    return np.select([most <= 0, least >= 0, middle >= 0], [np.where(least < 0, 1.0, 0.0), 0.0, one_below], one_above)
