"""Values between the places where they are known: of boreholes, of measured gaps."""

from __future__ import annotations

import numpy as np

from groundslab.shape import Array


def interpolated(places: Array, values: Array, wanted: Array) -> Array:
    """Return values (m, v) at the places wanted (m, 2), from values (h, v) known at h places (h, 2), all different.

    A constant plus a cone over each known place, that is kriging with a linear variogram (Matheron 1963): exact at the
    known places; between two of them linear along the line through both, and constant beyond; one place holds
    everywhere. No value leaves the range of the known ones, which three places and more could otherwise make it do.
    Values that are the same everywhere stay so to the last digit.
    """
    from scipy.interpolate import RBFInterpolator

    size = np.ptp(places, axis=0).max() or 1.0
    found = RBFInterpolator(places / size, values - values[0], kernel="linear", degree=0)(wanted / size)
    result: Array = np.clip(values[0] + found, values.min(axis=0), values.max(axis=0))
    return result
