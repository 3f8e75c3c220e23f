"""The order in which nodes are eliminated: with few entries in the factor, on meshes that are graded too."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Integers
from groundslab.optional import import_pardiso

if TYPE_CHECKING:
    from groundslab.fem.mesh import Mesh


def elimination_order(mesh: Mesh, graded: bool = False) -> Integers:
    """Return the rank of each node of a mesh, (n,).

    On meshes of elements that are alike a nested dissection by coordinates is as good as any, and quickly made. Where
    elements of different sizes meet, its cuts run through the small ones: METIS (Karypis and Kumar 1998) finds better
    ones, if PARDISO, which has it, can be loaded.
    """
    if graded:
        try:
            return _by_metis(mesh)
        except ImportError:
            pass
    return _by_coordinates(mesh)


def _by_metis(mesh: Mesh) -> Integers:
    """Return the ranks by a nested dissection of the graph of nodes; raises ImportError without PARDISO."""
    solver = import_pardiso().PyPardisoSolver(mtype=2, phase=11)
    from scipy.sparse import csr_array, eye_array, triu

    n, elements = len(mesh.nodes), mesh.elements
    within = csr_array(
        (np.ones(elements.size), elements.ravel(), np.arange(0, elements.size + 1, elements.shape[1])),
        shape=(len(elements), n),
    )
    graph = triu(within.T @ within + eye_array(n), format="csr")
    solver.set_iparm(1, 1)
    solver.set_iparm(2, 2)  # METIS
    solver.set_iparm(5, 2)  # the order is given back in perm
    solver.perm = np.zeros(n, dtype=np.int32)
    solver._call_pardiso(graph, np.zeros(n))
    rank = np.empty(n, dtype=np.int64)
    rank[solver.perm - 1] = np.arange(n)
    solver.free_memory(everything=True)
    return rank


def _by_coordinates(mesh: Mesh) -> Integers:
    """Return the rank of each node in a nested dissection of the mesh by its coordinates, (n,).

    Elements are halved again and again at the median of their centers' longer extent. A node belongs to the smallest
    part that holds all its elements; parts are eliminated before the part that they are halves of.
    """
    centre = mesh.nodes[mesh.elements[:, 8]]
    m = len(centre)
    depth = max(0, int(np.ceil(np.log2(m / 2))))
    code = np.zeros(m, dtype=np.int64)
    order = np.arange(m)
    bounds = np.array([0, m])
    for _ in range(depth):
        starts = bounds[:-1]
        part = np.repeat(np.arange(len(starts)), np.diff(bounds))
        low = np.minimum.reduceat(centre[order], starts, axis=0)
        high = np.maximum.reduceat(centre[order], starts, axis=0)
        axis = np.argmax(high - low, axis=1)
        order = order[np.lexsort((centre[order, axis[part]], part))]
        middle = (bounds[:-1] + bounds[1:]) // 2
        code *= 2
        code[order] += np.arange(m) >= middle[part]
        bounds = np.sort(np.concatenate([bounds, middle[middle > starts]]))
        # a part of one element is not halved: its code goes on with a 1, alone, and keeps its place
    flat = mesh.elements.ravel()
    codes = np.repeat(code, 9)
    lowest = np.full(len(mesh.nodes), np.iinfo(np.int64).max)
    highest = np.full(len(mesh.nodes), -1)
    np.minimum.at(lowest, flat, codes)
    np.maximum.at(highest, flat, codes)
    unused = highest < 0
    lowest[unused] = highest[unused] = 0
    differing = lowest ^ highest
    height = np.where(differing > 0, np.floor(np.log2(np.maximum(differing, 1))).astype(np.int64) + 1, 0)
    last_of_part = highest | ((np.int64(1) << height) - 1)
    rank = np.empty(len(mesh.nodes), dtype=np.int64)
    # within a separator, along its longer extent, so that neighbors stay neighbors
    rank[np.lexsort((mesh.nodes[:, 0], mesh.nodes[:, 1], height, last_of_part))] = np.arange(len(mesh.nodes))
    return rank
