"""Creases: which elements round a node lie on which side of a wall, by hand."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.fem.mesh import grid, sides_along
from groundslab.results.result_mesh import split_at

MESH = grid(np.arange(5.0), np.arange(5.0))
CENTRES = MESH.nodes[MESH.elements[:, 8]]


def groups_at(
    place: tuple[float, float], lines: list[tuple[tuple[float, float], tuple[float, float]]]
) -> set[frozenset[int]]:
    """Return the sets of elements that belong together at a node, with creases along lines."""
    creases = sides_along(MESH, MESH.elements, lines)
    number = split_at(MESH.elements, creases, len(MESH.nodes))
    node = int(np.flatnonzero((MESH.nodes == place).all(axis=1))[0])
    at = [(element, number[element, local]) for element, local in zip(*np.nonzero(MESH.elements == node), strict=True)]
    return {frozenset(int(e) for e, n in at if n == label) for _, label in at}


@pytest.mark.parametrize(
    ("place", "lines", "groups"),
    [
        ((2, 2), [((2, 0), (2, 4))], [{5, 9}, {6, 10}]),  # a wall from edge to edge
        ((2, 0), [((2, 0), (2, 4))], [{1}, {2}]),  # where it begins at the edge
        ((2, 2), [((2, 2), (2, 4))], [{5, 6, 9, 10}]),  # a wall that ends within the plate holds nothing apart there
        ((2, 2), [((2, 0), (2, 4)), ((0, 2), (4, 2))], [{5}, {6}, {9}, {10}]),  # a crossing
        ((2, 2), [((2, 0), (2, 2)), ((2, 2), (4, 2))], [{6}, {5, 9, 10}]),  # a corner
        ((2, 2), [((2, 0), (2, 4)), ((2, 2), (4, 2))], [{5, 9}, {6}, {10}]),  # a wall that meets another
        ((1, 1), [((2, 0), (2, 4))], [{0, 1, 4, 5}]),  # away from it
    ],
)
def test_sides_of_walls(place: tuple[float, float], lines: list, groups: list[set[int]]) -> None:
    """Elements belong together if one comes from one to the other round the node without crossing a wall."""
    assert groups_at(place, lines) == {frozenset(group) for group in groups}


def test_without_creases_all_belong_together() -> None:
    """The number is 0 everywhere off the creases."""
    creases = sides_along(MESH, MESH.elements, [((2.0, 0.0), (2.0, 1.0))])
    number = split_at(MESH.elements, creases, len(MESH.nodes))
    on = np.isin(MESH.elements, creases)
    assert not number[~on].any()
    assert len(creases) == 1
