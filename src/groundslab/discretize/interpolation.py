"""Interpolation of scattered values over the plan: boreholes, measured gaps."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array

#: Places whose spread across a line is less than this share of that along it lie on the line.
ON_A_LINE = 1e-6
#: Decimals to which places are distinguished, relative to their extent.
APART = 6


def interpolate_linearly(places: Array, values: Array, wanted: Array) -> Array:
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


def interpolate_smoothly(places: Array, values: Array, wanted: Array) -> Array:
    """Return values (m,) at the places wanted (m, 2), from values (h,) known at h places (h, 2), all different.

    A thin plate spline (Duchon 1977): exact at the known places, smooth everywhere, and a plane wherever the values lie
    on one. Along a line it is the natural cubic spline, the same across; one place holds everywhere. No value leaves
    the range of the known ones by more than that range, nor by more than their plane of best fit does; and none is
    negative unless a known one is.
    """
    from scipy.interpolate import RBFInterpolator

    size = np.ptp(places, axis=0).max() or 1.0
    known, given = _merge_close((places - places[0]) / size, values - values[0])
    middle = known.mean(axis=0)
    _, spread, axes = np.linalg.svd(known - middle)
    rank = int((spread > ON_A_LINE * spread[0]).sum()) if len(known) > 1 else 0
    if rank == 0:
        return np.full(len(wanted), values[0] + given.mean())
    along = axes[:rank].T
    own, at = (known - middle) @ along, ((wanted - places[0]) / size - middle) @ along
    found = RBFInterpolator(own, given, kernel="cubic" if rank == 1 else "thin_plate_spline", degree=1)(at)
    trend = np.linalg.lstsq(np.column_stack([np.ones(len(own)), own]), given, rcond=None)[0]
    plane = np.column_stack([np.ones(len(at)), at]) @ trend
    low, high = given.min(), given.max()
    most = high - low
    found = np.maximum(found, np.minimum(low, np.maximum(plane, low - most)))
    found = np.minimum(found, np.maximum(high, np.minimum(plane, high + most)))
    result: Array = values[0] + found
    return np.maximum(result, 0.0) if values.min() >= 0 else result


def _merge_close(places: Array, values: Array) -> tuple[Array, Array]:
    """Return places (u, 2) and values (u,), with those too close to distinguish replaced by their means."""
    group = np.unique(np.round(places, APART), axis=0, return_inverse=True)[1].ravel()
    count = np.bincount(group)
    x, y, value = (np.bincount(group, weights=each) / count for each in (*places.T, values))
    return np.column_stack([x, y]), value
