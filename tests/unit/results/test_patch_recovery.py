"""Patch recovery: what it reproduces, what it falls back to, what does not matter."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.results import patch_recovery
from helpers import quads

#: One field, on its own.
ONE = (np.ones(1),)
ROOT = 1 / np.sqrt(3.0)
#: The 2 x 2 Gauss points in the package's order, and the nine nodes, on the reference square.
POINTS = np.array([(-ROOT, -ROOT), (-ROOT, ROOT), (ROOT, -ROOT), (ROOT, ROOT)])
NODES = np.array([(c - 1.0, r - 1.0) for r, c in quads.PLACES])


def gauss_points(nodes: np.ndarray, elements: np.ndarray) -> np.ndarray:
    """Return the 2 x 2 Gauss points (m, 4, 2) of elements with straight sides: bilinear in their corners."""
    hats = np.stack([(1 + s * POINTS[:, 0]) * (1 + t * POINTS[:, 1]) / 4 for s, t in NODES[:4]], axis=1)
    return np.asarray(hats @ nodes[elements[:, :4]])


def recovered(nodes: np.ndarray, elements: np.ndarray, f: Any) -> np.ndarray:
    """Return what comes back at the nodes from f(x, y), sampled at the Gauss points."""
    points = gauss_points(nodes, elements)
    return patch_recovery.recover_nodes(
        patch_recovery.make_patches(nodes, elements, points), f(points[..., 0], points[..., 1])[..., None], ONE
    )[:, 0]


def quadratic(x: Any, y: Any) -> Any:
    """Return a full quadratic."""
    return 2.0 - x + 3 * y + 0.5 * x * x - 1.5 * x * y + 2.5 * y * y


def bilinear_means(nodes: np.ndarray, elements: np.ndarray, f: Any) -> np.ndarray:
    """Return the mean over its elements of each node's bilinear extrapolation, element after element."""
    points = gauss_points(nodes, elements)
    sums, count = np.zeros(len(nodes)), np.zeros(len(nodes))
    terms = np.column_stack([np.ones(4), POINTS[:, 0], POINTS[:, 1], POINTS[:, 0] * POINTS[:, 1]])
    for element, p in zip(elements, points, strict=True):
        a = np.linalg.solve(terms, f(p[:, 0], p[:, 1]))
        sums[element] += a[0] + a[1] * NODES[:, 0] + a[2] * NODES[:, 1] + a[3] * NODES[:, 0] * NODES[:, 1]
        count[element] += 1
    return sums / np.maximum(count, 1)


@pytest.mark.parametrize("stretch", [1.0, 1e3])
@pytest.mark.parametrize("size", [1e-3, 1e3])
@pytest.mark.parametrize("counts", [(2, 2), (5, 4)])
def test_quadratics_come_back_on_distorted_meshes(counts: tuple[int, int], size: float, stretch: float) -> None:
    """A quadratic is recovered exactly at every node, on edges and corners too, whatever shape and size elements have.

    The mesh is turned, so that no side lies along an axis.
    """
    nodes, elements = quads.mesh(*counts, 1.0, 1.0, amount=0.25)
    x, y = nodes.T * [[stretch], [1.0]]
    turned = size * np.column_stack([0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y])

    def f(X: Any, Y: Any) -> Any:
        return quadratic((0.8 * X + 0.6 * Y) / size / stretch, (0.8 * Y - 0.6 * X) / size)

    np.testing.assert_allclose(recovered(turned, elements, f), f(*turned.T), rtol=0, atol=1e-9)


def test_biquadratics_come_back_on_grids() -> None:
    """On rectangles along x and y, a biquadratic is recovered exactly, where their sizes differ by far, too."""
    nodes, elements = quads.mesh(5, 4, 5.0, 4.0)
    for axis, lines in enumerate(([0.0, 1.0, 1.1, 4.0, 4.01, 5.0], [0.0, 0.02, 2.0, 2.5, 3.0])):
        nodes[:, axis] = np.interp(nodes[:, axis], np.arange(len(lines)), lines)

    def f(x: Any, y: Any) -> Any:
        return quadratic(x, y) + x * x * y - 2 * x * y * y + 0.3 * x * x * y * y

    np.testing.assert_allclose(recovered(nodes, elements, f), f(*nodes.T), rtol=0, atol=1e-9)


@pytest.mark.parametrize("counts", [(1, 1), (6, 1), (1, 3)])
@pytest.mark.parametrize("amount", [0.0, 0.2])
def test_thin_strips_take_bilinear_means(counts: tuple[int, int], amount: float) -> None:
    """Without a corner node inside, each node takes the mean of its elements' bilinear extrapolations."""
    nodes, elements = quads.mesh(*counts, *map(float, counts), amount=amount)
    np.testing.assert_allclose(
        recovered(nodes, elements, quadratic), bilinear_means(nodes, elements, quadratic), rtol=1e-12
    )


def test_a_thin_strip_beside_a_square_spoils_nothing() -> None:
    """Where a strip one element wide sticks out of a square, the square's corners keep the order of their patches."""
    nodes, elements = quads.mesh(5, 3, 5.0, 3.0)
    centre = nodes[elements[:, 8]]
    kept = elements[(centre[:, 0] < 3) | (centre[:, 1] < 1)]
    used = np.unique(kept)
    values = recovered(nodes, kept, quadratic)
    square = used[nodes[used, 0] <= 3]
    np.testing.assert_allclose(values[square], quadratic(*nodes[square].T), rtol=0, atol=1e-10)
    far = used[nodes[used, 0] > 4]
    np.testing.assert_allclose(values[far], bilinear_means(nodes, kept, quadratic)[far], rtol=1e-12)
    assert (values[np.setdiff1d(np.arange(len(nodes)), used)] == 0).all()


def test_points_that_determine_nothing_are_left() -> None:
    """A patch whose points all lie on one line gives no fit, and no warning; the extrapolations give the values."""
    nodes, elements = quads.mesh(2, 2, 2.0, 2.0)
    points = gauss_points(nodes, elements)
    points[..., 1] = 1.0
    values = np.ones((4, 4, 1))
    found = patch_recovery.recover_nodes(patch_recovery.make_patches(nodes, elements, points), values, ONE)
    np.testing.assert_allclose(found, np.ones((len(nodes), 1)), rtol=1e-14)


def test_nothing_passes_between_parts_that_share_no_nodes() -> None:
    """Two squares side by side with nodes of their own on the common line keep different fields apart, exactly."""
    left, elements = quads.mesh(2, 3, 2.0, 3.0)
    nodes = np.vstack([left, left + np.array([2.0, 0.0])])
    both = np.vstack([elements, elements + len(left)])
    points = gauss_points(nodes, both)
    values = quadratic(points[..., 0], points[..., 1])
    values[len(elements) :] *= -7
    wanted = quadratic(*nodes.T) * np.repeat([1, -7], len(left))
    np.testing.assert_allclose(
        patch_recovery.recover_nodes(patch_recovery.make_patches(nodes, both, points), values[..., None], ONE)[:, 0],
        wanted,
        atol=1e-10,
    )


def test_numbering_does_not_matter() -> None:
    """Nodes and elements in another order, each element begun at another corner: the same values at the same places."""
    nodes, elements = quads.mesh(6, 5, 3.0, 2.0, amount=0.25)

    def f(x: Any, y: Any) -> Any:
        return np.sin(2 * x + y) * np.exp(y)

    rng = np.random.default_rng(5)
    new = rng.permutation(len(nodes))
    moved = np.empty_like(nodes)
    moved[new] = nodes
    renumbered = new[elements]
    turned = np.column_stack([np.roll(renumbered[:, :4], 1, axis=1), np.roll(renumbered[:, 4:8], 1, axis=1)])
    other = np.column_stack([turned, renumbered[:, 8]])[rng.permutation(len(elements))]
    np.testing.assert_allclose(recovered(moved, other, f)[new], recovered(nodes, elements, f), rtol=1e-10)


def test_large_meshes_are_done_in_pieces_that_fit_together() -> None:
    """More elements than one piece holds give the values of the same function on a mesh of one piece."""
    nodes, elements = quads.mesh(130, 70, 130.0, 70.0)
    assert len(elements) > patch_recovery._CHUNK
    wanted = quadratic(*nodes.T)
    np.testing.assert_allclose(recovered(nodes, elements, quadratic), wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())


def test_scatter_on_a_flat_peak_is_no_peak() -> None:
    """Where values are nearly alike, what a fit leaves over is their scatter: it is smoothed, not extrapolated."""
    nodes, elements = quads.mesh(6, 6, 6.0, 6.0, amount=0.25)

    def f(x: Any, y: Any) -> Any:
        return 100.0 + 0.3 * np.sin(40 * x) * np.cos(37 * y)

    inside = (np.abs(nodes - 3) < 1.5).all(axis=1)
    error, extrapolated = (np.abs(make(nodes, elements, f)[inside] - 100).max() for make in (recovered, bilinear_means))
    assert error < 0.6 * extrapolated
