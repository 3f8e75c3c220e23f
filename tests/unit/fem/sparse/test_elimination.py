"""The order of elimination: a nested dissection, with few entries in the factor on graded meshes too."""

from __future__ import annotations

from unittest.mock import patch

import numpy as np
import pytest
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

from groundslab.fem.hanging import connect
from groundslab.fem.mesh import Mesh, grid
from groundslab.fem.sparse import elimination
from groundslab.fem.sparse.elimination import elimination_order
from groundslab.meshing.refinement import split
from groundslab.solvers.direct.pardiso import pardiso_import_error


def square(n: int) -> Mesh:
    """Return n x n elements on the unit square."""
    return grid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))


def graded() -> Mesh:
    """Return elements on the unit square that are cut around nine places, with what moves hanging nodes in them."""
    mesh, places = square(8), np.stack(np.meshgrid(*2 * [[0.2, 0.5, 0.8]]), axis=-1).reshape(-1, 1, 2)
    for _ in range(4):
        away = np.abs(mesh.xy[:, 8] - places).max(axis=2).min(axis=0)
        mesh, _ = split(mesh, away < np.sqrt(2) * np.ptp(mesh.xy[..., 0], axis=1))
    return Mesh(mesh.nodes, connect(mesh.elements)[0])


def graph(mesh: Mesh) -> sp.csr_array:
    """Return the matrix of which nodes share an element."""
    m, n = len(mesh.elements), len(mesh.nodes)
    owns = sp.coo_array((np.ones(9 * m), (np.repeat(np.arange(m), 9), mesh.elements.ravel())), shape=(m, n)).tocsr()
    return (owns.T @ owns).tocsr()


def fill(mesh: Mesh, order: np.ndarray) -> int:
    """Return how many entries SuperLU's factor has, nodes being eliminated in some order."""
    A = sp.csc_array(graph(mesh) + 100 * sp.eye_array(len(mesh.nodes)))
    lu = splu(A[order][:, order], permc_spec="NATURAL", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return int(lu.L.nnz)


@pytest.mark.parametrize("shape", [(1, 1), (1, 2), (1, 7), (5, 1), (3, 7), (8, 8), (24, 10)])
def test_elimination_order_is_a_permutation(shape: tuple[int, int]) -> None:
    """Every node gets one rank, on meshes of one element, strips and odd counts too."""
    mesh = grid(np.arange(shape[0] + 1.0), np.arange(shape[1] + 1.0) * 1.7)
    np.testing.assert_array_equal(np.sort(elimination_order(mesh)), np.arange(len(mesh.nodes)))


def test_elimination_order_is_a_nested_dissection() -> None:
    """The nodes eliminated last are one line across, without them the mesh is two halves, and so on in each half."""
    mesh = square(16)
    adjacency, rank = graph(mesh), elimination_order(mesh)
    parts = [np.arange(len(mesh.nodes))]
    for separator in (33, 16, 16):
        halves: list[np.ndarray] = []
        for part in parts:
            inside = part[np.argsort(rank[part])][:-separator]
            count, label = connected_components(adjacency[inside][:, inside])
            assert count == 2
            pair = [inside[label == k] for k in (0, 1)]
            assert abs(len(pair[0]) - len(pair[1])) <= separator
            halves += pair
        parts = halves
    for part in parts:
        # a part is eliminated in one go
        assert np.ptp(rank[part]) == len(part) - 1


def test_elimination_order_saves_fill() -> None:
    """On 24 x 24 elements the factor is much smaller than row by row."""
    mesh = square(24)
    assert fill(mesh, np.argsort(elimination_order(mesh))) < 0.6 * fill(mesh, np.arange(len(mesh.nodes)))


@pytest.mark.skipif(bool(pardiso_import_error()), reason="METIS comes with PARDISO")
def test_graded_meshes_are_ordered_by_metis() -> None:
    """Cuts go around what is fine: the factor has at most four fifths of the entries; the same again each time."""
    mesh = graded()
    rank = elimination_order(mesh, graded=True)
    np.testing.assert_array_equal(np.sort(rank), np.arange(len(mesh.nodes)))
    np.testing.assert_array_equal(rank, elimination_order(mesh, graded=True))
    assert fill(mesh, np.argsort(rank)) < 0.8 * fill(mesh, np.argsort(elimination_order(mesh)))


def test_without_pardiso_coordinates_order_graded_meshes() -> None:
    """Where PARDISO cannot be loaded there is an order all the same."""
    mesh = graded()
    with patch.object(elimination, "import_pardiso", side_effect=ImportError("no MKL")):
        np.testing.assert_array_equal(elimination_order(mesh, graded=True), elimination_order(mesh))
