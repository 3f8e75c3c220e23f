"""Uniform refinement of nine-node meshes: every element is cut into four, so that meshes are nested."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import GRID, SIDES, Mesh
from groundslab.fem.shape_functions import COLUMN, ROW, unique_integers
from groundslab.geometry.plan import SAME_PLACE, Segment

#: Rows and columns, in an element's 5 x 5 grid, of the nodes between the ends and the middles of its sides: for each
#: side the one after its first end, then the one before its second end.
_QUARTERS = np.array([[(0, 1), (0, 3)], [(1, 4), (3, 4)], [(4, 3), (4, 1)], [(3, 0), (1, 0)]])
#: Rows and columns of the nodes of each of the four parts in that grid, (4, 9).
_ROWS, _COLUMNS = np.array([0, 0, 2, 2])[:, None] + ROW, np.array([0, 2, 2, 0])[:, None] + COLUMN


def halve(mesh: Mesh, arcs: Sequence[Segment] = ()) -> Mesh:
    """Return the mesh with every element cut into four; the nodes of the mesh come first and keep their numbers.

    The elements' own geometry is kept; only nodes on sides that lie on one of the arcs are put exactly onto it.

    Parameters
    ----------
    mesh : Mesh
        n nodes [m], m elements.
    arcs : sequence of Segment
        Arcs that sides of the mesh may follow.

    Returns
    -------
    Mesh
        4 m elements, those of the same parent one after the other.
    """
    n, m = len(mesh.nodes), len(mesh.elements)
    number = np.full((m, 5, 5), -1)
    number[:, ::2, ::2] = mesh.elements[:, GRID]
    middles, side = unique_integers(mesh.elements[:, SIDES[:, 2]])
    # two neighbors run along their common side in opposite directions
    first, second = mesh.elements[:, SIDES[:, 0]], mesh.elements[:, SIDES[:, 1]]
    for k, later in enumerate((first > second, first < second)):
        rows, columns = _QUARTERS[:, k].T
        number[:, rows, columns] = n + 2 * side + later
    inner = np.argwhere(number[0] < 0)
    count = n + 2 * len(middles)
    number[:, inner[:, 0], inner[:, 1]] = count + np.arange(m * len(inner)).reshape(m, -1)
    nodes = np.empty((count + m * len(inner), 2))
    nodes[number] = _between(_between(mesh.xy[:, GRID], 1), 2)
    nodes[:n] = mesh.nodes
    for arc in arcs:
        _put_onto(arc, mesh, nodes, number)
    elements: Integers = number[:, _ROWS, _COLUMNS].reshape(4 * m, 9)
    return Mesh(nodes, elements)


def _between(xy: Array, axis: int) -> Array:
    """Return places on a parabola through three at the parameters 0, 1/4, 1/2, 3/4, 1, along an axis of the array."""
    a, b, c = np.moveaxis(xy, axis, 0)
    # in this form what is constant stays so to the last digit
    after, before = a + 0.75 * (b - a) - 0.125 * (c - a), c + 0.75 * (b - c) - 0.125 * (a - c)
    return np.stack([a, after, b, before, c], axis=axis)


def _put_onto(arc: Segment, mesh: Mesh, nodes: Array, number: Integers) -> None:
    """Move the new nodes (k, 2) between nodes of the mesh that lie on an arc onto it, in place."""
    near = 10 * SAME_PLACE * float(np.ptp(mesh.nodes, axis=0).max())
    on_arc = arc.distance(mesh.nodes) <= near
    element, side = np.nonzero(on_arc[mesh.elements[:, SIDES]].all(axis=2))
    rows, columns = np.moveaxis(_QUARTERS[side], 2, 0)
    new = np.unique(number[element[:, None], rows, columns])
    offset = nodes[new] - arc.centre
    nodes[new] = arc.centre + arc.radius * offset / np.linalg.norm(offset, axis=1)[:, None]
