"""Refinement of nine-node meshes: elements are cut into four, all or some of them, so that meshes are nested."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import GRID, SIDES, Mesh
from groundslab.fem.shape_functions import COLUMN, ROW
from groundslab.geometry.plan import SAME_PLACE, Segment

#: Rows and columns, in an element's 5 x 5 grid, of the nodes between the ends and the middles of its sides: for each
#: side the one after its first end, then the one before its second end.
_QUARTERS = np.array([[(0, 1), (0, 3)], [(1, 4), (3, 4)], [(4, 3), (4, 1)], [(3, 0), (1, 0)]])
#: Rows and columns of the nodes of each of the four parts in that grid, (4, 9).
_ROWS, _COLUMNS = np.array([0, 0, 2, 2])[:, None] + ROW, np.array([0, 2, 2, 0])[:, None] + COLUMN


def halve(mesh: Mesh, arcs: Sequence[Segment] = ()) -> Mesh:
    """Return the mesh with every element cut into four, see `split`."""
    return split(mesh, np.ones(len(mesh.elements), dtype=bool), arcs)[0]


def split(mesh: Mesh, marked: Flags, arcs: Sequence[Segment] = ()) -> tuple[Mesh, Integers]:
    """Return the mesh with marked elements cut into four, and which element each of its own comes from.

    The nodes of the mesh come first and keep their numbers. The elements' own geometry is kept; only nodes on sides
    that lie on one of the arcs are put exactly onto it. Beside an element that is left whole nodes hang: no element
    whose own side is already half of a neighbor's may be cut without that neighbor, see `close`.

    Parameters
    ----------
    mesh : Mesh
        n nodes [m], m elements.
    marked : (m,) array of bool
        Which elements are cut.
    arcs : sequence of Segment
        Arcs that sides of the mesh may follow.

    Returns
    -------
    mesh : Mesh
        The elements in the order of those that they come from.
    parent : (k,) array of int
        Numbers of these.
    """
    n, part = len(mesh.nodes), Mesh(mesh.nodes, mesh.elements[marked])
    m = len(part.elements)
    number = np.full((m, 5, 5), -1)
    number[:, ::2, ::2] = part.elements[:, GRID]
    quarter = _quarters(mesh)
    # two neighbors run along their common side in opposite directions
    first, second, middle = np.moveaxis(part.elements[:, SIDES], 2, 0)
    lacking = np.unique(middle[quarter[middle, 0] < 0])
    quarter[lacking] = n + np.arange(2 * len(lacking)).reshape(-1, 2)
    for k, later in enumerate((first > second, first < second)):
        rows, columns = _QUARTERS[:, k].T
        number[:, rows, columns] = quarter[middle, later.astype(np.int64)]
    inner = np.argwhere((number[:1] < 0).any(axis=0))
    count = n + 2 * len(lacking)
    number[:, inner[:, 0], inner[:, 1]] = count + np.arange(m * len(inner)).reshape(m, -1)
    nodes = np.empty((count + m * len(inner), 2))
    nodes[number] = _between(_between(part.xy[:, GRID], 1), 2)
    nodes[:n] = mesh.nodes
    for arc in arcs:
        _put_onto(arc, part, nodes, number)
    parent = np.repeat(np.arange(len(marked)), np.where(marked, 4, 1))
    elements = mesh.elements[parent]
    elements[marked[parent]] = number[:, _ROWS, _COLUMNS].reshape(4 * m, 9)
    return Mesh(nodes, elements), parent


def _quarters(mesh: Mesh) -> Integers:
    """Return the nodes that hang on each middle of a side, (n, 2), that near the end of lower number first, or -1."""
    quarters = np.full((len(mesh.nodes), 2), -1)
    node, near, middle, far = find_hanging(mesh.elements).T
    quarters[middle, (near > far).astype(np.int64)] = node
    return quarters


def close(mesh: Mesh, marked: Flags, whole: Integers) -> Flags:
    """Return which elements are cut if some are marked (m,): with each the larger ones on whose sides it lies.

    And its neighbors across sides with the middles `whole` (w,), on which nothing may hang.
    """
    elements, m = mesh.elements, len(mesh.elements)
    larger = np.full(len(mesh.nodes), -1)
    larger[elements[:, 4:8]] = np.arange(m)[:, None]
    node, _, middle, _ = find_hanging(elements).T
    beside = np.full(len(mesh.nodes), -1)
    beside[node] = larger[middle]
    small, side = np.nonzero(beside[elements[:, 4:8]] >= 0)
    on = beside[elements[small, 4 + side]]
    is_whole = np.zeros(len(mesh.nodes), dtype=bool)
    is_whole[whole] = True
    here, side = np.nonzero(is_whole[elements[:, 4:8]])
    across = larger[elements[here, 4 + side]]
    pairs = here != across
    leading, following = (
        np.concatenate([small, here[pairs], across[pairs]]),
        np.concatenate([on, across[pairs], here[pairs]]),
    )
    cut, before = marked.copy(), np.zeros(m, dtype=bool)
    while (cut != before).any():
        before = cut.copy()
        cut[following[cut[leading]]] = True
    return cut


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
