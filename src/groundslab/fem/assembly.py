"""Symmetric sparse matrices from element matrices, in blocks of the unknowns of two nodes.

The upper half only. The pattern is made once for a mesh and its unknowns; any number of matrices are filled into it.
No list of single entries is ever sorted: what elements add to pairs of nodes is, by counting, and an entry's place
follows from its pair.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Indices, Integers
from groundslab.fem.sparse.symmetric import Symmetric

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_A, _B = np.triu_indices(9)
NONE_LINKED = np.zeros((0, 2), dtype=np.int64)
#: Entries whose places are found at a time: few enough to stay near the processor.
_CHUNK = 2**18


@dataclass(frozen=True, slots=True)
class Merging:
    """Where the entries of a matrix of unknowns that each node has for itself go, if nodes share some of them."""

    entry: Integers  # (addends,): which entry each of them adds to
    weight: Array  # (addends,): 2 off the diagonal where row and column become one, else 1


@dataclass(frozen=True, slots=True)
class Pattern:
    """Where everything goes: unknowns of nodes, pairs of nodes, and the upper CSR pattern that they span.

    Every two nodes of an element add to a pair of nodes; these contributions are listed pair by pair.
    """

    unknown: Integers  # (n, F): number of each node's unknown in each field, -1 where there is none
    rank: Integers  # (n,): order of elimination
    first: Integers  # (pairs,): node eliminated first
    second: Integers  # (pairs,)
    keys: Integers  # (pairs,): ascending, rank of first * n + rank of second
    starts: Indices  # (pairs + 1,): where each pair's contributions begin
    element: Indices  # (contributions,): which element adds it
    place: Indices  # (contributions,): its place in the element's 9 x 9 block, the node eliminated first as row
    indptr: Indices  # (size + 1,)
    indices: Indices  # (entries,)
    cuts: Integers  # (chunks + 1,): pairs at which rows of pairs are cut into chunks
    entries: Integers  # (chunks + 1,): addends at which these begin
    taken: Indices  # (addends,): place of each addend in the blocks (pairs, F, F) of its chunk
    merging: Merging | None = None  # of addends to entries, where nodes share unknowns; else they are the same

    @property
    def size(self) -> int:
        """Return the number of unknowns."""
        return len(self.indptr) - 1

    def matrix(self, addends: Array) -> Symmetric:
        """Return the matrix whose entries are sums of addends (addends,)."""
        m = self.merging
        if m is not None:
            addends = scatter(m.entry, m.weight * addends, len(self.indices))
        return Symmetric(self.indptr, self.indices, addends)

    def pairs(self, first: Integers, second: Integers) -> Integers:
        """Return the pair numbers of nodes that share an element."""
        a, b = self.rank[first], self.rank[second]
        keys = np.minimum(a, b) * len(self.rank) + np.maximum(a, b)
        return np.searchsorted(self.keys, keys)


def number_unknowns(rank: Integers, present: Flags, shared: Integers | None = None) -> Integers:
    """Return unknown numbers (n, F) for the fields present at each node (n, F), node by node in the order of rank.

    Nodes of one group, by a number for each node and field (n, F), share the unknown, which has its place at the node
    eliminated last.
    """
    if shared is not None:
        return _number_shared(rank, present, shared)
    ordered = np.empty_like(present, dtype=bool)
    ordered[rank] = present
    numbers = np.where(ordered, np.cumsum(ordered.ravel()).reshape(ordered.shape) - 1, -1)
    return numbers[rank]


def _number_shared(rank: Integers, present: Flags, group: Integers) -> Integers:
    """Return unknown numbers (n, F) of which the nodes of one group in a field (n, F) share one."""
    n, fields = present.shape
    last = np.full((n, fields), -1)
    for column in range(fields):
        np.maximum.at(last[:, column], group[:, column], rank)
    at_last = np.take_along_axis(last, group, axis=0) == rank[:, None]
    numbers = number_unknowns(rank, present & at_last)
    of_group = np.full((n, fields), -1)
    node, field = np.nonzero(at_last)
    of_group[group[node, field], field] = numbers[node, field]
    return np.where(present, np.take_along_axis(of_group, group, axis=0), -1)


def build_pattern(elements: Integers, rank: Integers, unknown: Integers, linked: Integers = NONE_LINKED) -> Pattern:
    """Return the pattern of a mesh (m, 9) whose nodes, of the given rank (n,), carry the unknowns (n, F).

    Further pairs of nodes are linked (l, 2), to which no element adds.
    """
    n = len(rank)
    r = rank[elements].astype(np.int32)
    a, b = r[:, _A].ravel(), r[:, _B].ravel()
    low, high = np.minimum(a, b), np.maximum(a, b)
    order = _counting_sort(high, n)
    order = order[_counting_sort(low[order], n)]
    low, high = low[order], high[order]
    new = np.flatnonzero(np.concatenate([[True], (low[1:] != low[:-1]) | (high[1:] != high[:-1])]))
    starts = np.append(new, len(order)).astype(np.int32)
    places = np.stack([_A * 9 + _B, _B * 9 + _A]).astype(np.int32)
    place = places[(a > b)[order].astype(np.int8), order % len(_A)]
    element = order // np.int32(len(_A))

    at_rank = np.empty(n, dtype=np.int64)
    at_rank[rank] = np.arange(n)
    low, high = low[new].astype(np.int64), high[new].astype(np.int64)
    keys, starts = _add_pairs(low * n + high, starts, np.sort(rank[linked], axis=1), n)
    low, high = np.divmod(keys, n)
    first, second = at_rank[low], at_rank[high]
    rows = np.concatenate([[0], np.flatnonzero(np.diff(low)) + 1, [len(low)]])
    indptr, base = _index_rows(rows, first, second, unknown >= 0)
    cuts, entries = _cut_rows(rows, first, unknown >= 0, indptr)
    unmerged = number_unknowns(rank, unknown >= 0)
    indices, taken = _place_entries(first, second, unmerged, indptr, base, cuts)
    merging = None
    if unmerged.max(initial=-1) > unknown.max(initial=-1):
        indptr, indices, merging = _merge(indptr, indices, unmerged, unknown)
    return Pattern(
        unknown, rank, first, second, keys, starts, element, place, indptr, indices, cuts, entries, taken, merging
    )


def _merge(
    indptr: Indices, indices: Indices, unmerged: Integers, unknown: Integers
) -> tuple[Indices, Indices, Merging]:
    """Return the pattern between unknowns (n, F) that nodes share, from that of those they have for themselves."""
    size = int(unknown.max()) + 1
    shared = np.empty(len(indptr) - 1, dtype=np.int64)
    shared[unmerged[unmerged >= 0]] = unknown[unmerged >= 0]
    row, column = np.repeat(shared, np.diff(indptr)), shared[indices]
    keys, entry = np.unique(np.minimum(row, column) * size + np.maximum(row, column), return_inverse=True)
    rows, columns = np.divmod(keys, size)
    same = np.repeat(np.arange(len(shared)), np.diff(indptr)) == indices
    starts = np.searchsorted(rows, np.arange(size + 1)).astype(np.int32)
    weight = np.where((row == column) & ~same, 2.0, 1.0)
    return starts, columns.astype(np.int32), Merging(entry, weight)


def _add_pairs(keys: Integers, starts: Indices, linked: Integers, n: int) -> tuple[Integers, Indices]:
    """Return ascending keys of pairs and where their contributions begin, with linked pairs (l, 2) that have none."""
    wanted = np.unique(linked[:, 0] * n + linked[:, 1])
    where = np.searchsorted(keys, wanted)
    lacking = np.append(keys, -1)[where] != wanted
    more, where = wanted[lacking], where[lacking]
    return np.insert(keys, where, more), np.insert(starts, where, starts[where])


def _counting_sort(key: Indices, size: int) -> Indices:
    """Return the order (k,) that sorts keys (k,) from 0 to size - 1, equal ones as they came: a sort by counting."""
    from scipy.sparse import csr_array

    k = len(key)
    one_each = np.arange(k + 1, dtype=np.int32)
    order: Indices = csr_array((one_each[:-1], key, one_each), shape=(k, size)).tocsc().data
    return order


def _index_rows(rows: Integers, first: Integers, second: Integers, present: Flags) -> tuple[Indices, Integers]:
    """Return indptr of a pattern, and how many columns a row has before those of each pair (pairs,).

    Pairs (pairs,) of nodes stand row by row, the second ones in order of elimination; rows (n + 1,) is where each row
    begins.
    """
    ends = np.concatenate([[0], np.cumsum(present.sum(axis=1)[second])])  # of each pair's columns
    node = first[rows[:-1]]
    counts = (np.diff(ends[rows])[:, None] - _earlier(present)[node])[present[node]]
    indptr = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
    return indptr, ends[:-1] - np.repeat(ends[rows[:-1]], np.diff(rows))


def _earlier(present: Flags) -> Integers:
    """Return how many unknowns of its node stand before each field, (n, F)."""
    earlier: Integers = np.cumsum(present, axis=1) - present
    return earlier


def _cut_rows(rows: Integers, first: Integers, present: Flags, indptr: Indices) -> tuple[Integers, Integers]:
    """Return the pairs at which rows are cut into chunks of about _CHUNK entries, and the entries there."""
    step = max(1, _CHUNK // present.shape[1] ** 2)
    cut_rows = np.unique(np.searchsorted(rows, np.append(np.arange(0, rows[-1], step), rows[-1])))
    before = np.concatenate([[0], np.cumsum(present[first[rows[:-1]]].sum(axis=1))])
    return rows[cut_rows], indptr[before[cut_rows]]


def _place_entries(
    first: Integers, second: Integers, unknown: Integers, indptr: Indices, base: Integers, cuts: Integers
) -> tuple[Indices, Indices]:
    """Return indices and taken of a pattern, chunk by chunk; base (pairs,) is as from `_index_rows`."""
    F, present, begin = unknown.shape[1], unknown >= 0, 0
    earlier, upper = _earlier(present), np.triu(np.ones((F, F), dtype=bool))
    indices, taken = (np.empty(indptr[-1], np.int32) for _ in range(2))
    # where the entry of a pair's fields (i, j) goes is a part that the row knows and one that the column does
    of_row = indptr[np.maximum(unknown, 0)] - earlier
    for start, stop in pairwise(cuts):
        row, column = first[start:stop], second[start:stop]
        exists = present[row][:, :, None] & present[column][:, None, :]
        exists[row == column] &= upper
        where = np.flatnonzero(exists).astype(np.int32)
        in_row = (of_row[row] + base[start:stop, None] - begin).astype(np.int32)
        at = (in_row[:, :, None] + earlier[column].astype(np.int32)[:, None, :]).ravel()[where]
        order = np.empty_like(where)
        order[at] = where
        here = slice(begin, begin + len(where))
        taken[here] = order
        indices[here] = unknown[column].astype(np.int32).ravel()[order // (F * F) * F + order % F]
        begin += len(where)
    return indices, taken


def assemble(
    p: Pattern, kind: Integers, matrices: Callable[[Integers], Array], pairs: Integers, blocks: Array
) -> Array:
    """Return the addends of the matrix that element matrices and further blocks of node pairs add up to.

    kind (m,) says which matrix each element has; matrices gives those of some kinds (k,) as (k, 9, 9, F, F). Further
    blocks (t, F, F) go to pairs (t,), ascending. Rows belong to the first node and field, columns to the second.
    Some node pairs at a time, whose entries follow each other, so that next to nothing is stored but the result.
    """
    from scipy.sparse import csr_array

    data = np.empty(len(p.taken))
    number, F = np.zeros(int(kind.max()) + 1, dtype=np.int32), p.unknown.shape[1]
    for (start, stop), entries in zip(pairwise(p.cuts), pairwise(p.entries), strict=True):
        chunk = slice(p.starts[start], p.starts[stop])
        which = kind[p.element[chunk]]
        number[which] = 1
        kinds = np.flatnonzero(number)
        number[kinds] = np.arange(len(kinds))
        column = number[which] * np.int32(81) + p.place[chunk]
        added = csr_array(
            (np.ones(len(column)), column, p.starts[start : stop + 1] - p.starts[start]),
            shape=(stop - start, 81 * len(kinds)),
        )
        number[kinds] = 0
        sums = added @ matrices(kinds).reshape(81 * len(kinds), F * F)
        further = slice(*np.searchsorted(pairs, (start, stop)))
        sums[pairs[further] - start] += blocks[further].reshape(-1, F * F)
        data[slice(*entries)] = sums.ravel()[p.taken[slice(*entries)]]
    return data


def sums_over_elements(p: Pattern, kind: Integers, matrices: Array) -> csr_array:
    """Return what takes factors of elements (m,) to the sums (pairs,) of their matrices times these.

    kind (m,) says which of the matrices (u, 9, 9) each element has.
    """
    from scipy.sparse import csr_array

    values = matrices.reshape(len(matrices), 81)[kind[p.element], p.place]
    return csr_array((values, p.element, p.starts), shape=(len(p.first), len(kind)))


def entries_of_pairs(p: Pattern) -> Indices:
    """Return which addends of the matrix are those (pairs, F, F) of each pair of nodes, -1 where there are none."""
    F = p.unknown.shape[1]
    addends = np.full(len(p.first) * F * F, -1, dtype=np.int32)
    for start, (begin, end) in zip(p.cuts, pairwise(p.entries), strict=False):
        addends[start * F * F + p.taken[begin:end]] = np.arange(begin, end)
    return addends.reshape(-1, F, F)


def scatter(places: Integers, values: Array, size: int) -> Array:
    """Return an array (size,) with the sum of the values that fall on each place."""
    return np.bincount(places.ravel(), values.ravel(), size).astype(float, copy=False)


def find_congruent(xy: Array) -> tuple[Integers, Integers]:
    """Return representatives (u,) of the element shapes among xy (m, 9, 2), and the kind of each element (m,)."""
    relative = (xy - xy[:, 8:]).reshape(len(xy), 18)
    size = np.abs(relative).max(axis=1)
    scale = 10.0 ** np.floor(np.log10(size))
    rounded = np.round(relative / scale[:, None] * 1e9).astype(np.int64)
    table = np.ascontiguousarray(np.column_stack([np.round(np.log10(scale)).astype(np.int64), rounded]))
    rows = table.view(np.dtype((np.void, table.dtype.itemsize * table.shape[1]))).ravel()
    _, representative, kind = np.unique(rows, return_index=True, return_inverse=True)
    return representative, kind
