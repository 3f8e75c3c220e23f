"""The nearest of many places; without SciPy's search trees, which take long to load, where there are few."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers

#: Distances between so many pairs of places take less time than loading the trees,
MOST_PAIRS = 2**21
#: so many at a time.
CHUNK = 2**16
#: Places with the same coordinates to this share of the largest distance along an axis are looked for by sorting.
ROUNDED = 1e-7


def nearest_distance(places: Array, among: Array, reach: float) -> Array:
    """Return the distance (p,) [m] of places (p, 2) from the nearest of others (n, 2), inf where beyond a reach [m]."""
    low, high = places.min(axis=0, initial=np.inf) - reach, places.max(axis=0, initial=-np.inf) + reach
    among = among[((among >= low) & (among <= high)).all(axis=1)]
    if len(places) * len(among) > MOST_PAIRS:
        from scipy.spatial import KDTree

        distance: Array = KDTree(among).query(places, distance_upper_bound=reach)[0]
        return distance
    squared = np.full(len(places), np.inf)
    rows = max(1, CHUNK // max(1, len(among)))
    for start in range(0, len(places), rows):
        part = slice(start, start + rows)
        x, y = (places[part, axis, None] - among[:, axis] for axis in (0, 1))
        squared[part] = (x * x + y * y).min(axis=1, initial=np.inf)
    return np.where(squared < reach**2, np.sqrt(squared), np.inf)


def nearest_of_same(points: Array, among: Array) -> tuple[Integers, Array]:
    """Return for each of some places (k, 2) which of others (n, 2) is nearest, and its distance (k,) [m].

    Places that are the same but for rounding are found by sorting.
    """
    step = ROUNDED * float(np.ptp(among, axis=0).max()) or 1.0
    low = among.min(axis=0)
    keys, wanted = (np.round((places - low) / step).astype(np.int64) @ [2**31, 1] for places in (among, points))
    order = np.argsort(keys)
    at = order[np.minimum(np.searchsorted(keys, wanted, sorter=order), len(keys) - 1)]
    distance = np.hypot(*(points - among[at]).T)
    if distance.max(initial=0.0) <= step / 100:
        return at, distance
    from scipy.spatial import KDTree

    far, nearest = KDTree(among).query(points)
    return np.asarray(nearest, dtype=np.int64), far
