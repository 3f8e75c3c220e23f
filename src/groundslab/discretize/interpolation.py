"""Interpolation of scattered values over the plan: boreholes, measured gaps."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from groundslab.arrays import Array

#: Places whose spread across a line is less than this share of that along it lie on the line.
ON_A_LINE = 1e-6
#: Decimals to which places are distinguished, relative to their extent.
APART = 6
#: Values that are not negative end in zero below this share of the largest; so many halvings find what becomes one.
TURNING, HALVINGS = 0.1, 60
#: Largest number of distances that are held at a time.
MOST_DISTANCES = 10_000_000


def interpolate_linearly(places: Array, values: Array, wanted: Array) -> Array:
    """Return values (m, v) at the places wanted (m, 2), from values (h, v) known at h places (h, 2), all different.

    A constant plus a cone over each known place, that is kriging with a linear variogram (Matheron 1963): exact at the
    known places; between two of them linear along the line through both, and constant beyond; one place holds
    everywhere. No value leaves the range of the known ones, which three places and more could otherwise make it do.
    Values that are the same everywhere stay so to the last digit.
    """
    size = np.ptp(places, axis=0).max() or 1.0
    interpolated = _interpolate(_cone, places / size, values - values[0], wanted / size, degree=0)
    result: Array = np.clip(values[0] + interpolated, values.min(axis=0), values.max(axis=0))
    return result


def interpolate_smoothly(places: Array, values: Array, wanted: Array) -> Array:
    """Return values (m,) at the places wanted (m, 2), from values (h,) known at h places (h, 2), all different.

    A thin plate spline (Duchon 1977): exact at the known places, smooth everywhere, and a plane wherever the values lie
    on one. Along a line it is the natural cubic spline, the same across; one place holds everywhere. No value leaves
    the range of the known ones by more than that range, nor by more than their plane of best fit does; and none is
    negative unless a known one is. Where one were, what is below a tenth of the largest known one ends in zero without
    a crease, which ground with shear would answer by a line reaction.
    """
    interpolated = _spline(places, values, wanted)
    if values.min() < 0 or interpolated.min() >= 0:
        return interpolated
    turning = TURNING * values.max()
    return _keep_positive(_spline(places, _before_kept_positive(values, turning), wanted), turning)


def _keep_positive(values: Array, turning: float) -> Array:
    """Return values as they are above the turning, and from there falling to 0 at 0 with two smooth derivatives."""
    t = np.clip(values / turning, 0.0, 1.0)
    return np.where(values < turning, turning * t**3 * (6 - 8 * t + 3 * t**2), values)


def _before_kept_positive(values: Array, turning: float) -> Array:
    """Return what `_keep_positive` turns into values (h,), none below 0."""
    low, high = np.zeros_like(values), np.full_like(values, turning)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        below = _keep_positive(middle, turning) < values
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.where(values < turning, np.where(values > 0, high, 0.0), values)


def _spline(places: Array, values: Array, wanted: Array) -> Array:
    """Return values (m,) of a thin plate spline that stays about the range of the known ones."""
    size = np.ptp(places, axis=0).max() or 1.0
    merged, offsets = _merge_close((places - places[0]) / size, values - values[0])
    middle = merged.mean(axis=0)
    _, spread, axes = np.linalg.svd(merged - middle)
    rank = int((spread > ON_A_LINE * spread[0]).sum()) if len(merged) > 1 else 0
    if rank == 0:
        return np.full(len(wanted), values[0] + offsets.mean())
    along = axes[:rank].T
    local, at = (merged - middle) @ along, ((wanted - places[0]) / size - middle) @ along
    interpolated = _interpolate(_cube if rank == 1 else _thin_plate, local, offsets, at, degree=1)
    trend = np.linalg.lstsq(np.column_stack([np.ones(len(local)), local]), offsets, rcond=None)[0]
    plane = np.column_stack([np.ones(len(at)), at]) @ trend
    low, high = offsets.min(), offsets.max()
    most = high - low
    interpolated = np.maximum(interpolated, np.minimum(low, np.maximum(plane, low - most)))
    interpolated = np.minimum(interpolated, np.maximum(high, np.minimum(plane, high + most)))
    result: Array = values[0] + interpolated
    return result


def _interpolate(kernel: Callable[[Array], Array], places: Array, values: Array, wanted: Array, degree: int) -> Array:
    """Return values (m, ...) of a kernel around each place (h, d) and a polynomial of a degree, 0 or 1.

    The weights of the kernels are orthogonal to all such polynomials: exact for these, and one solution.
    """

    def terms(at: Array) -> Array:
        return np.column_stack([np.ones(len(at)), at])[:, : 1 + degree * at.shape[1]]

    def around(at: Array) -> Array:
        distances = np.sqrt(((at[:, None] - places) ** 2).sum(axis=2))
        return np.column_stack([kernel(distances), terms(at)])

    trend = terms(places)
    orthogonal = np.column_stack([trend.T, np.zeros((trend.shape[1], trend.shape[1]))])
    right_side = np.concatenate([values, np.zeros((trend.shape[1], *values.shape[1:]))])
    weights = np.linalg.solve(np.concatenate([around(places), orthogonal]), right_side)
    parts = np.array_split(wanted, 1 + len(wanted) * len(places) // MOST_DISTANCES)
    return np.concatenate([around(part) @ weights for part in parts])


def _cone(r: Array) -> Array:
    """Return the kernel of a linear variogram."""
    return -r


def _cube(r: Array) -> Array:
    """Return that of the natural cubic spline."""
    cubes: Array = r**3
    return cubes


def _thin_plate(r: Array) -> Array:
    """Return that of the thin plate spline."""
    return r**2 * np.log(np.where(r > 0, r, 1.0))


def _merge_close(places: Array, values: Array) -> tuple[Array, Array]:
    """Return places (u, 2) and values (u,), with those too close to distinguish replaced by their means."""
    group = np.unique(np.round(places, APART), axis=0, return_inverse=True)[1].ravel()
    count = np.bincount(group)
    x, y, value = (np.bincount(group, weights=column) / count for column in (*places.T, values))
    return np.column_stack([x, y]), value
