"""Fields of two results on the same mesh whose nodes stand at some places more than once in one of them."""

from __future__ import annotations

import numpy as np
from scipy.spatial import KDTree

from groundslab.arrays import Array, Integers
from groundslab.results.plate_result import PlateResult


def nodes_at(plate: PlateResult, places: Array) -> Integers:
    """Return a node of a plate at each of some places (k, 2), where it must have one."""
    distance, node = KDTree(plate.nodes).query(places)
    np.testing.assert_array_equal(distance, 0.0)
    found: Integers = node
    return found
