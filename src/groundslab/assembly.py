"""Symmetric sparse matrices from element matrices, in blocks of the unknowns of two nodes.

The upper half only. The pattern is made once for a mesh and its unknowns; any number of matrices are filled into it.
No list of single entries is ever sorted: node pairs are, and an entry's place follows from its pair by counting.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.shape import Array, Flags, Indices, Integers

_A, _B = np.triu_indices(9)


@dataclass(frozen=True, slots=True)
class Pattern:
    """Where everything goes: unknowns of nodes, pairs of nodes, and the upper CSR pattern that they span."""

    unknown: Integers  # (n, F): number of each node's unknown in each field, -1 where there is none
    size: int  # number of unknowns
    pair_of: Integers  # (m, 45): the node pair of each pair of an element's nodes
    flat: Integers  # (m, 45): its place in the element's 9 x 9 block, the node that is eliminated first as row
    first: Integers  # (pairs,): node eliminated first
    second: Integers  # (pairs,)
    keys: Integers  # (pairs,): ascending, rank of first * n + rank of second
    rank: Integers  # (n,): order of elimination
    base: Integers  # (pairs,): where the pair's entries begin, counted from the start of a row of its first node
    indptr: Integers  # (size + 1,)
    indices: Indices  # (entries,)

    def pairs(self, first: Integers, second: Integers) -> Integers:
        """Return the pair numbers of nodes that share an element."""
        a, b = self.rank[first], self.rank[second]
        keys = np.minimum(a, b) * len(self.rank) + np.maximum(a, b)
        return np.searchsorted(self.keys, keys)


def number(rank: Integers, present: Flags) -> Integers:
    """Return unknown numbers (n, F) for the fields present at each node (n, F), node by node in the order of rank."""
    ordered = np.empty_like(present, dtype=bool)
    ordered[rank] = present
    numbers = np.where(ordered, np.cumsum(ordered.ravel()).reshape(ordered.shape) - 1, -1)
    result: Integers = numbers[rank]
    return result


def pattern(elements: Integers, rank: Integers, unknown: Integers) -> Pattern:
    """Return the pattern of a mesh (m, 9) whose nodes, of the given rank (n,), carry the unknowns (n, F)."""
    n = len(rank)
    r = rank[elements]
    a, b = r[:, _A], r[:, _B]
    flip = a > b
    keys, pair_of = np.unique(np.where(flip, b * n + a, a * n + b), return_inverse=True)
    pair_of = pair_of.reshape(a.shape)
    flat = np.where(flip, _B * 9 + _A, _A * 9 + _B)
    at_rank = np.empty(n, dtype=np.int64)
    at_rank[rank] = np.arange(n)
    first, second = at_rank[keys // n], at_rank[keys % n]

    present = unknown >= 0
    width = present.sum(axis=1)
    ends = np.cumsum(width[second])
    row_start = np.concatenate([[0], np.flatnonzero(np.diff(keys // n)) + 1])
    before = np.concatenate([[0], ends])[row_start]
    base = np.concatenate([[0], ends[:-1]]) - np.repeat(before, np.diff(np.append(row_start, len(keys))))
    row_width = np.zeros(n, dtype=np.int64)
    row_width[first[row_start]] = np.diff(np.append(before, ends[-1]))

    earlier: Integers = np.cumsum(present, axis=1) - present  # unknowns of the node before this one
    size = int(present.sum())
    counts = np.zeros(size, dtype=np.int64)
    counts[unknown[present]] = (row_width[:, None] - earlier)[present]
    indptr = np.concatenate([[0], np.cumsum(counts)])
    indices = np.empty(indptr[-1], np.int32)
    result = Pattern(unknown, size, pair_of, flat, first, second, keys, rank, base, indptr, indices)
    for i in range(unknown.shape[1]):
        for j in range(unknown.shape[1]):
            where, at = positions(result, i, j)
            indices[at] = unknown[result.second[where], j]
    return result


def positions(p: Pattern, i: int, j: int) -> tuple[Integers, Integers]:
    """Return the node pairs that have an entry in fields (i, j), and the entries' places in the data array."""
    row, column = p.unknown[p.first, i], p.unknown[p.second, j]
    exists = (row >= 0) & (column >= 0)
    if i > j:
        exists &= p.first != p.second
    where = np.flatnonzero(exists)
    present = p.unknown >= 0
    earlier: Integers = np.cumsum(present, axis=1) - present
    place = p.indptr[row[where]] + p.base[where] - earlier[p.first[where], i] + earlier[p.second[where], j]
    return where, place


def gather(p: Pattern, matrices: Array, kind: Integers, subset: Integers | slice = slice(None)) -> Array:
    """Return element blocks summed over node pairs, (pairs,).

    matrices (u, 9, 9) are the different blocks, kind (m',) says which one each element of the subset has. Rows belong
    to the first field, columns to the second.
    """
    weights = matrices.reshape(-1, 81)[kind[:, None], p.flat[subset]]
    return scatter(p.pair_of[subset], weights, len(p.keys))


def scatter(places: Integers, values: Array, size: int) -> Array:
    """Return an array (size,) with the sum of the values that fall on each place."""
    return np.bincount(places.ravel(), values.ravel(), size).astype(float, copy=False)


def add(p: Pattern, data: Array, i: int, j: int, values: Array) -> None:
    """Add values of node pairs (pairs,) to the entries of fields (i, j) in data."""
    where, at = positions(p, i, j)
    data[at] += values[where]


def multiply(p: Pattern, data: Array, u: Array) -> Array:
    """Return A u for the symmetric matrix whose upper half is data."""
    from scipy.sparse import csr_array

    upper = csr_array((data, p.indices, p.indptr), shape=(p.size, p.size))
    result: Array = upper @ u + upper.T @ u - data[p.indptr[:-1]] * u
    return result


def congruent(xy: Array) -> tuple[Integers, Integers]:
    """Return representatives (u,) of the element shapes among xy (m, 9, 2), and the kind of each element (m,)."""
    relative = (xy - xy[:, 8:]).reshape(len(xy), 18)
    size = np.abs(relative).max(axis=1)
    scale = 10.0 ** np.floor(np.log10(size))
    rounded = np.round(relative / scale[:, None] * 1e9).astype(np.int64)
    table = np.ascontiguousarray(np.column_stack([np.round(np.log10(scale)).astype(np.int64), rounded]))
    rows = table.view(np.dtype((np.void, table.dtype.itemsize * table.shape[1]))).ravel()
    _, representative, kind = np.unique(rows, return_index=True, return_inverse=True)
    return representative, kind
