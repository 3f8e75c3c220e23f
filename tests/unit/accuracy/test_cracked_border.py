"""Which elements lie on both sides of a side, where elements are alike and where nodes hang."""

from __future__ import annotations

import numpy as np

from groundslab.accuracy.cracked_border import _pairs
from groundslab.fem.mesh import grid
from groundslab.meshing.refinement import split


def test_elements_on_both_sides() -> None:
    """Of 3 x 2 elements seven sides lie inside; where one is cut, its neighbors meet two of its parts each."""
    mesh = grid(np.arange(4.0), np.arange(3.0))
    one, other = _pairs(mesh.elements)
    assert len(one) == 7
    marked = np.arange(6) == 1
    mesh, parent = split(mesh, marked)
    one, other = _pairs(mesh.elements)
    met = np.sort(np.stack([parent[one], parent[other]]), axis=0).T
    kinds, count = np.unique(met, axis=0, return_counts=True)
    assert kinds.tolist() == [[0, 1], [0, 3], [1, 1], [1, 2], [1, 4], [2, 5], [3, 4], [4, 5]]
    assert count.tolist() == [2, 1, 4, 2, 2, 1, 1, 1]
