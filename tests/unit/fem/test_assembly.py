"""Sparse matrices from element matrices, against dense assembly by loops."""

from __future__ import annotations

from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array

from groundslab.fem import assembly
from groundslab.fem.assembly import Pattern, assemble, build_pattern, find_congruent, number_unknowns, scatter
from groundslab.fem.mesh import grid
from groundslab.fem.sparse.elimination import elimination_order
from groundslab.fem.sparse.symmetric import Symmetric
from helpers.examples import examples
from helpers.quads import quadrilateral


def table(nx: int, ny: int) -> np.ndarray:
    """Return the elements (m, 9) of nx x ny elements."""
    return grid(np.arange(nx + 1.0), np.arange(ny + 1.0)).elements


def by_loops(elements: np.ndarray, unknown: np.ndarray, size: int, matrices: np.ndarray) -> np.ndarray:
    """Return the dense matrix of element matrices (m, F, F, 9, 9), entry by entry."""
    A = np.zeros((size, size))
    for nodes, K in zip(elements, matrices, strict=True):
        for i in range(unknown.shape[1]):
            for j in range(unknown.shape[1]):
                for a in range(9):
                    for b in range(9):
                        row, column = unknown[nodes[a], i], unknown[nodes[b], j]
                        if row >= 0 and column >= 0:
                            A[row, column] += K[i, j, a, b]
    return A


NOTHING = np.zeros(0, dtype=int)


def filled(p: Pattern, matrices: np.ndarray, kinds: np.ndarray) -> Symmetric:
    """Return kinds of element matrices (k, F, F, 9, 9) put together by the module."""
    F = matrices.shape[1]
    by_nodes = matrices.transpose(0, 3, 4, 1, 2)
    return p.matrix(assemble(p, kinds, lambda some: by_nodes[some], NOTHING, np.zeros((0, F, F))))


def dense(A: Symmetric) -> np.ndarray:
    """Return the full matrix."""
    upper = csr_array((A.data, A.indices, A.indptr), shape=(A.size, A.size)).toarray()
    return upper + np.triu(upper, 1).T


@settings(max_examples=examples(12), derandomize=True, deadline=None)
@given(
    shape=st.sampled_from([(1, 1), (2, 1), (2, 2), (3, 2)]),
    chunk=st.sampled_from([1, 40, 2**18]),
    fields=st.integers(1, 4),
    density=st.sampled_from([0.3, 0.8, 1.0]),
    seed=st.integers(0, 1000),
)
def test_assembly_equals_dense_loops(
    shape: tuple[int, int], chunk: int, fields: int, density: float, seed: int
) -> None:
    """Any table of unknowns, any order of elimination, few or many entries at a time: the same sorted upper half."""
    rng = np.random.default_rng(seed)
    elements = table(*shape)
    n = elements.max() + 1
    present = rng.random((n, fields)) < density
    present[0, 0] = True
    rank = rng.permutation(n)
    unknown = number_unknowns(rank, present)
    with patch.object(assembly, "_CHUNK", chunk):
        p = build_pattern(elements, rank, unknown)

    kinds = rng.integers(0, 2, len(elements))
    matrices = rng.standard_normal((2, fields, fields, 9, 9))
    matrices = matrices + matrices.transpose(0, 2, 1, 4, 3)
    A = filled(p, matrices, kinds)

    wanted = by_loops(elements, unknown, p.size, matrices[kinds])
    np.testing.assert_allclose(dense(A), wanted, atol=1e-12)

    assert p.size == present.sum()
    for row in range(p.size):
        columns = p.indices[p.indptr[row] : p.indptr[row + 1]]
        assert columns[0] == row
        assert (np.diff(columns) > 0).all()


@given(seed=st.integers(0, 1000))
@settings(max_examples=examples(10), derandomize=True, deadline=None)
def test_unknowns_are_numbered_in_the_order_of_elimination(seed: int) -> None:
    """Numbers run without holes through the nodes by rank, field by field in a node, and are -1 where none exists."""
    rng = np.random.default_rng(seed)
    present = rng.random((15, 3)) < 0.6
    rank = rng.permutation(15)
    unknown = number_unknowns(rank, present)
    wanted = np.full((15, 3), -1)
    count = 0
    for node in np.argsort(rank):
        for field in range(3):
            if present[node, field]:
                wanted[node, field] = count
                count += 1
    np.testing.assert_array_equal(unknown, wanted)


@pytest.mark.parametrize("chunk", [1, 2**18])
def test_further_blocks_go_to_their_pair_of_nodes_in_either_order(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The pair of two nodes of an element is the same both ways; a block for it makes just these nodes' entries."""
    monkeypatch.setattr(assembly, "_CHUNK", chunk)
    elements = table(2, 2)
    mesh = grid(np.arange(3.0), np.arange(3.0))
    rank = elimination_order(mesh)
    unknown = number_unknowns(rank, np.ones((len(rank), 2), dtype=bool))
    p = build_pattern(elements, rank, unknown)
    one = np.array([[1.0, 2.0], [3.0, 4.0]])
    for a, b in [(0, 0), (0, 6), (12, 6), (24, 18)]:
        pair = p.pairs(np.array([a]), np.array([b]))
        assert pair == p.pairs(np.array([b]), np.array([a]))
        none = np.zeros((1, 9, 9, 2, 2))
        addends = assemble(p, np.zeros(len(elements), dtype=int), lambda some, none=none: none[some], pair, one[None])
        A = dense(p.matrix(addends))
        first, second = (a, b) if rank[a] < rank[b] else (b, a)
        wanted = np.zeros_like(A)
        wanted[np.ix_(unknown[first], unknown[second])] = one if a != b else [[1, 2], [0, 4]]
        np.testing.assert_array_equal(A, wanted + np.triu(wanted, 1).T + np.tril(wanted, -1).T)


def test_scatter_sums_what_falls_together() -> None:
    """Values of the same place are added, places without a value are zero, integers come out as floats."""
    result = scatter(np.array([[0, 2], [2, 2]]), np.array([[1, 2], [3, 4]]), 4)
    np.testing.assert_array_equal(result, [1, 0, 9, 0])
    assert result.dtype == float


def test_congruent_elements_share_a_kind() -> None:
    """Copies moved anywhere are one kind; size, proportions, mirror image and a moved corner each make another."""
    one = quadrilateral()
    other = one.copy()
    other[0, 2] += [1e-4, 0.0]
    shapes = [one, one * 2, one * [1.0, 1.01], one * [-1.0, 1.0], other]
    moved = [s + d for d in ([0.0, 0.0], [3.7, -12.1], [0.001, 900.0]) for s in shapes]
    representatives, kind = find_congruent(np.concatenate(moved))
    assert len(representatives) == len(shapes)
    np.testing.assert_array_equal(kind.reshape(3, -1), np.tile(kind[: len(shapes)], (3, 1)))
    for k, r in enumerate(representatives):
        assert kind[r] == k


@pytest.mark.parametrize("length", [1.0, 9.6, 7.2e-3, 1e4])
@pytest.mark.parametrize("n", [7, 24, 100])
def test_a_regular_mesh_has_hardly_any_kinds(length: float, n: int) -> None:
    """Rounding in equally spaced lines of any size does not tear alike elements apart."""
    lines = np.linspace(-length / 2, length / 2, n + 1)
    xy = grid(lines, np.array([0.0, length / n])).xy
    assert len(find_congruent(xy)[0]) == 1


@pytest.mark.parametrize("chunk", [1, 2**18])
def test_linked_nodes_have_a_pair_to_which_no_element_adds(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks of nodes far from each other go to their pairs; pairs that elements have, too, stay one."""
    monkeypatch.setattr(assembly, "_CHUNK", chunk)
    mesh = grid(np.arange(5.0), np.arange(4.0))
    n, F = len(mesh.nodes), 2
    rank = elimination_order(mesh)
    unknown = number_unknowns(rank, np.random.default_rng(1).random((n, F)) < 0.8)
    linked = np.array([[n - 1, 0], [3, n - 5], [0, 1]])
    p = build_pattern(mesh.elements, rank, unknown, linked)
    kind = np.zeros(len(mesh.elements), dtype=int)
    blocks = np.array([[[1.0, 2.0], [2.0, 5.0]], [[3.0, 4.0], [4.0, 6.0]], [[7.0, 8.0], [8.0, 9.0]]])
    pairs = p.pairs(*linked.T)
    order = np.argsort(pairs)
    A = p.matrix(assemble(p, kind, lambda kinds: np.zeros((len(kinds), 9, 9, F, F)), pairs[order], blocks[order]))
    expected = np.zeros((p.size, p.size))
    for (a, b), block in zip(linked, blocks, strict=True):
        for i in range(F):
            for j in range(F):
                row, column = unknown[a, i], unknown[b, j]
                if row >= 0 and column >= 0:
                    expected[row, column] = expected[column, row] = block[i, j]
    dense = csr_array((A.data, A.indices, A.indptr), shape=expected.shape).toarray()
    np.testing.assert_array_equal(np.triu(dense) + np.triu(dense, 1).T, expected)


def test_shared_unknowns_add_up() -> None:
    """Where nodes share unknowns the matrix is C^T A C, of the one in which each node has its own."""
    rng = np.random.default_rng(0)
    mesh = grid(np.linspace(0, 3, 4), np.linspace(0, 2, 3))
    n, F = len(mesh.nodes), 2
    present, rank = rng.random((n, F)) < 0.8, rng.permutation(n)
    group = np.tile(np.arange(n)[:, None], F)
    for nodes in ((0, 8, 15), (3, 4)):
        group[list(nodes), 0] = nodes[0]
        present[list(nodes), 0] = True
    own, shared = number_unknowns(rank, present), number_unknowns(rank, present, group)
    matrices = rng.normal(size=(1, 9, 9, F, F))
    matrices = matrices + matrices.transpose(0, 2, 1, 4, 3)
    apart, together = (
        p.matrix(assemble(p, np.zeros(6, dtype=int), lambda kinds: matrices[kinds], NOTHING, np.zeros((0, F, F))))
        for p in (build_pattern(mesh.elements, rank, unknown) for unknown in (own, shared))
    )
    C = np.zeros((own.max() + 1, shared.max() + 1))
    C[own[present], shared[present]] = 1.0
    assert C.shape[1] == C.shape[0] - 3
    np.testing.assert_allclose(dense(together), C.T @ dense(apart) @ C, atol=1e-12)
    assert (np.diff(together.indptr) > 0).all()
    np.testing.assert_array_equal(together.indices[together.indptr[:-1]], np.arange(together.size))
