"""Lines of a grid that come closer towards the plate's edges, and lines beyond them that part."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.mesh import GRADING, divide_graded, graded_size


def towards_edges(low: float, high: float, size: float, edges: Array, edge_size: float) -> Array:
    """Return lines from low to high [m], at most `size` apart, which come as close as `edge_size` at the edges (e,)."""
    limit = graded_size(edges, edge_size)
    return np.append(low, divide_graded(lambda x: np.minimum(size, limit(x)), low, high))


def distances_beyond_edge(width: float, first: float, size: float, scale: float) -> Array:
    """Return the distances of lines from the edge that they follow, up to the last one at `width` [m].

    Intervals are at most `first` long at the edge and grow as fast as elements may, but at the distance d they are at
    most size * (1 + d / scale). There are two at least.
    """
    return divide_graded(
        lambda d: np.minimum(np.minimum(first + GRADING * d, size * (1 + d / scale)), width / 2), 0.0, width
    )
