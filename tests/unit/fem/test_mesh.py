"""Meshes: numbering, location, transfer between meshes, mirroring."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.fem.mesh import (
    GRADING,
    Mesh,
    divide_graded,
    extrude,
    first_at_place,
    graded_size,
    grid,
    interpolate,
    interpolate_bilinear,
    local_coordinates,
    locate,
    locate_nearest,
    mirror,
    renumber_by_rows,
    separate,
    sides_on_boundary,
    with_midpoints,
)
from groundslab.fem.shape_functions import areas, q9

X = np.array([-2.0, -1.5, 0.3, 1.0, 4.0])
Y = np.array([0.0, 0.7, 1.0, 2.5])


def square(n: int) -> Mesh:
    """Return n x n elements on the unit square."""
    return grid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))


def test_grid_puts_every_node_in_its_place() -> None:
    """Each element is the rectangle between its lines, with midsides and centre halfway; no node is unused or twice."""
    mesh = grid(X, Y)
    places = np.array([(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1)]) / 2
    for j in range(len(Y) - 1):
        for i in range(len(X) - 1):
            wanted = [X[i], Y[j]] + places * [X[i + 1] - X[i], Y[j + 1] - Y[j]]
            np.testing.assert_allclose(mesh.xy[i + j * (len(X) - 1)], wanted, atol=1e-14)
    assert len(mesh.nodes) == (2 * len(X) - 1) * (2 * len(Y) - 1)
    assert set(mesh.elements.ravel()) == set(range(len(mesh.nodes)))
    assert len(np.unique(mesh.nodes, axis=0)) == len(mesh.nodes)


def test_with_midpoints() -> None:
    """Midpoints stand between the given lines, which are kept to the last bit."""
    np.testing.assert_array_equal(with_midpoints(np.array([0.0, 1.0, 4.0])), [0, 0.5, 1, 2.5, 4])


@pytest.mark.parametrize("high", [0.1, 1.0, 7.3, 400.0])
@pytest.mark.parametrize("scale", [0.8, 5.0])
def test_graded_lines_follow_the_wanted_size(high: float, scale: float) -> None:
    """The lines end exactly where they should, ascend, and are as far apart as wanted, not much less if many."""
    lines = np.concatenate([[0.0], divide_graded(lambda d: 0.25 * (1 + d / scale), 0.0, high)])
    steps = np.diff(lines)
    assert lines[-1] == high
    assert (steps > 0).all()
    wanted = 0.25 * (1 + (lines[1:] + lines[:-1]) / 2 / scale)
    assert (steps <= wanted * (1 + 1e-5)).all()
    if len(steps) > 10:
        assert (steps >= 0.85 * wanted).all()


def test_graded_lines_are_halved_with_the_size() -> None:
    """Half the size puts a line into each of the old intervals: graded meshes refine alike."""
    coarse = divide_graded(lambda d: 0.25 * (1 + d), 0.0, 6.0)
    fine = divide_graded(lambda d: 0.125 * (1 + d), 0.0, 6.0)
    assert len(fine) == 2 * len(coarse)
    np.testing.assert_allclose(fine[1::2], coarse, rtol=1e-4)


def test_sizes_grow_from_edges() -> None:
    """At an edge elements have its size, a distance away more by GRADING times the distance; no edge sets no limit."""
    limit = graded_size(np.array([-2.0, 3.0]), 0.1)
    np.testing.assert_allclose(limit(np.array([-2.0, 0.0, 2.0, 4.0])), 0.1 + GRADING * np.array([0, 2, 1, 1]))
    assert np.isinf(graded_size(np.zeros(0), 0.1)(np.array([1.0]))).all()


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("outward", [1, -1])
def test_extruded_meshes_add_rows_of_rectangles(axis: int, outward: int) -> None:
    """A grid extruded across a side is the grid with the further lines; its own nodes and elements come first."""
    mesh = grid(X, Y)
    bigger = extrude(mesh, axis, outward, np.array([0.5, 1.5]))
    np.testing.assert_array_equal(bigger.nodes[: len(mesh.nodes)], mesh.nodes)
    np.testing.assert_array_equal(bigger.elements[: len(mesh.elements)], mesh.elements)
    lines = [X, Y]
    end = lines[axis][-1 if outward > 0 else 0]
    lines[axis] = np.sort(np.concatenate([lines[axis], end + outward * np.array([0.5, 1.5])]))
    wanted = grid(*lines)
    one, other = renumber_by_rows(bigger)[0], renumber_by_rows(wanted)[0]
    np.testing.assert_allclose(one.nodes, other.nodes, rtol=0, atol=1e-14)
    assert (areas(bigger.xy) > 0).all()
    # each element has the same nodes, wherever its first corner is
    np.testing.assert_array_equal(np.sort(one.elements, axis=1), np.sort(other.elements, axis=1))
    np.testing.assert_allclose(bigger.xy[:, 4], (bigger.xy[:, 0] + bigger.xy[:, 1]) / 2, atol=1e-14)


def crooked(seed: int = 3) -> Mesh:
    """Return a mesh of crooked quadrilaterals on -2 .. 4 x 0 .. 2.5, with one curved side on its boundary."""
    mesh = grid(X, Y)
    nodes = mesh.nodes.copy()
    inner = (nodes[:, 0] > -2) & (nodes[:, 0] < 4) & (nodes[:, 1] > 0) & (nodes[:, 1] < 2.5)
    nodes[inner] += np.random.default_rng(seed).uniform(-0.04, 0.04, (inner.sum(), 2))
    nodes[mesh.elements[0, 4]] -= [0, 0.05]
    return Mesh(nodes, mesh.elements)


def test_place_in_an_element_is_the_inverse_of_its_map() -> None:
    """The place found for a point maps back to the point, in straight, crooked and curved elements."""
    mesh = crooked()
    place = np.random.default_rng(5).uniform(-1, 1, (len(mesh.elements), 2))
    points = np.einsum("ea,eax->ex", q9(place)[0], mesh.xy)
    np.testing.assert_allclose(local_coordinates(mesh, np.arange(len(place)), points), place, atol=1e-12)


def test_locate_finds_the_element_of_a_point() -> None:
    """A point comes back with an element and a place that map to it; on sides and corners too; -1 outside."""
    mesh = crooked()
    inside = np.random.default_rng(1).uniform([-1.99, 0.01], [3.99, 2.49], (200, 2))
    points = np.vstack([inside, mesh.nodes])
    element, place = locate(mesh, points)
    assert (element >= 0).all()
    assert np.abs(place).max() <= 1 + 1e-8
    np.testing.assert_allclose(np.einsum("pa,pax->px", q9(place)[0], mesh.xy[element]), points, atol=1e-12)
    outside = np.array([[-2.1, 1.0], [5.0, 1.0], [0.0, 2.6], [0.0, -0.06], [1e6, 1e6]])
    np.testing.assert_array_equal(locate(mesh, outside)[0], -1)


def annulus(n: int = 8, turn: float = 0.3) -> Mesh:
    """Return a mesh of n elements around a hole, with curved sides inside and outside, and no node at the extremes."""
    angle = turn + np.pi / n * np.arange(2 * n)
    nodes = np.array([[r * np.cos(t), r * np.sin(t)] for t in angle for r in (1.0, 2.0, 3.0)])
    places = ((0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0), (1, 1))
    elements = [[3 * ((2 * i + a) % (2 * n)) + b for a, b in places] for i in range(n)]
    return Mesh(nodes, np.array(elements))


def test_locate_finds_points_where_a_side_bulges_out_of_the_box_around_its_nodes() -> None:
    """Every point of every element, on its curved sides too, is found."""
    mesh = annulus()
    place = np.random.default_rng(4).uniform(-1, 1, (2000, 2))
    place[::2, 0] = 1.0
    points = np.einsum("pa,eax->epx", q9(place)[0], mesh.xy).reshape(-1, 2)
    element, local = locate(mesh, points)
    assert (element >= 0).all()
    np.testing.assert_allclose(np.einsum("pa,pax->px", q9(local)[0], mesh.xy[element]), points, atol=1e-9)


def test_whole_numbers_are_places_like_any_others() -> None:
    """Integers are found at the same places as floats."""
    mesh = grid(X, Y)
    points = np.array([[-1, 1], [0, 2], [3, 1], [1, 1]])
    for ours, theirs in zip(locate(mesh, points), locate(mesh, points.astype(float)), strict=True):
        np.testing.assert_array_equal(ours, theirs)
    element, at = np.array([0, 0, 1]), np.array([[-1, 1], [1, 2], [3, 1]])
    np.testing.assert_array_equal(
        local_coordinates(mesh, element, at), local_coordinates(mesh, element, at.astype(float))
    )


def test_values_at_points_are_those_of_the_shape_functions() -> None:
    """On rectangles any biquadratic is met exactly."""
    mesh = grid(X, Y)
    points = np.random.default_rng(1).uniform([-2, 0], [4, 2.5], (50, 2))

    def f(p: np.ndarray) -> np.ndarray:
        return 3 - p[:, 0] + p[:, 0] ** 2 * p[:, 1] - 0.4 * p[:, 1] ** 2 * p[:, 0] ** 2

    values = interpolate(mesh, f(mesh.nodes), locate(mesh, points))
    np.testing.assert_allclose(values, f(points), atol=1e-12)


def test_values_between_nodes_keep_bilinear_fields() -> None:
    """A bilinear field goes exactly from one mesh to another whose lines have nothing to do with the first's."""
    coarse = grid(X, Y)
    fine = grid(np.linspace(-2, 4, 8), np.linspace(0, 2.5, 6))

    def field(p: np.ndarray) -> np.ndarray:
        return 1 - 2 * p[:, 0] + 0.5 * p[:, 1] + 3 * p[:, 0] * p[:, 1]

    np.testing.assert_allclose(
        interpolate_bilinear(coarse, field(coarse.nodes), locate_nearest(coarse, fine.nodes)),
        field(fine.nodes),
        atol=1e-12,
    )


def test_values_between_nodes_never_overshoot() -> None:
    """Values stay between the least and the greatest nodal value, outside the first mesh too."""
    coarse = grid(X, Y)
    wide = grid(np.linspace(-5, 9, 30), np.linspace(-3, 5, 30))
    values = np.where(np.random.default_rng(2).random(len(coarse.nodes)) < 0.5, -1.0, 1.0)
    result = interpolate_bilinear(coarse, values, locate_nearest(coarse, wide.nodes))
    assert result.min() >= -1 - 1e-14
    assert result.max() <= 1 + 1e-14
    corner = (coarse.nodes == [X[-1], Y[-1]]).all(axis=1)
    assert result[-1] == pytest.approx(values[corner][0])


def test_sides_on_the_boundary() -> None:
    """The sides found are those on the rectangle's edge, each once, its middle node between its ends."""
    mesh = grid(X, Y)
    sides = sides_on_boundary(mesh.elements)
    assert len(sides) == 2 * (len(X) - 1 + len(Y) - 1)
    ends, middle = mesh.nodes[sides[:, :2]], mesh.nodes[sides[:, 2]]
    np.testing.assert_allclose(ends.mean(axis=1), middle, atol=1e-15)
    assert np.linalg.norm(np.diff(ends, axis=1)[:, 0], axis=1).sum() == pytest.approx(2 * (6 + 2.5))


@pytest.mark.parametrize("axis", [0, 1])
def test_mirror_doubles_about_the_axis(axis: int) -> None:
    """Even and odd functions of a half mesh come out even and odd on the doubled one, whose other axis is untouched."""
    half = grid(np.array([0.0, 0.4, 1.0, 3.0]), np.array([0.0, 2.0, 2.5]))
    whole, source, side = mirror(half, axis)
    position, other = whole.nodes[:, axis], whole.nodes[:, 1 - axis]
    assert len(whole.elements) == 2 * len(half.elements)
    np.testing.assert_allclose(np.abs(position), half.nodes[source, axis], atol=1e-15)
    np.testing.assert_array_equal(other, half.nodes[source, 1 - axis])
    np.testing.assert_array_equal(side, np.where(position < 0, -1.0, 1.0))
    np.testing.assert_allclose(half.nodes[source, axis] ** 3 * side, position**3, atol=1e-14)


def test_mirrored_twice_is_the_full_mesh() -> None:
    """A quarter mirrored about both axes has the very nodes of the grid between the mirrored lines."""
    quarter = grid(np.array([0.0, 0.4, 1.0]), np.array([0.0, 2.0, 2.5]))
    whole = mirror(mirror(quarter, 0)[0], 1)[0]
    direct = grid(np.array([-1.0, -0.4, 0.0, 0.4, 1.0]), np.array([-2.5, -2.0, 0.0, 2.0, 2.5]))
    mine, theirs = np.lexsort(whole.nodes.T), np.lexsort(direct.nodes.T)
    np.testing.assert_allclose(whole.nodes[mine], direct.nodes[theirs], atol=1e-15)
    centres = [sorted(map(tuple, np.round(m.nodes[m.elements[:, 8]], 12))) for m in (whole, direct)]
    assert centres[0] == centres[1]
    xy = whole.xy[:, :4]
    turns = np.roll(xy, -1, axis=1) - xy
    assert (turns[:, 0, 0] * turns[:, 1, 1] - turns[:, 0, 1] * turns[:, 1, 0] > 0).all()
    np.testing.assert_allclose((xy + np.roll(xy, -1, axis=1)) / 2, whole.xy[:, 4:8], atol=1e-15)


def test_parts_made_separate_share_no_nodes() -> None:
    """Each part but the first has nodes of its own where it meets others; what is no part keeps those of the first."""
    mesh = grid(np.arange(4.0), np.arange(3.0))
    part = np.array([0, 1, -1, 0, 2, -1])
    apart = separate(mesh, part)
    nodes = [set(apart.elements[part == number].ravel().tolist()) for number in range(3)]
    assert not (nodes[0] & nodes[1] | nodes[0] & nodes[2] | nodes[1] & nodes[2])
    np.testing.assert_array_equal(apart.xy, mesh.xy)
    np.testing.assert_array_equal(apart.elements[part == -1][:, :4] < len(mesh.nodes), True)
    np.testing.assert_array_equal(apart.elements[part == 0], mesh.elements[part == 0])
    first = first_at_place(apart)
    assert (first[: len(mesh.nodes)] == np.arange(len(mesh.nodes))).all()
    np.testing.assert_array_equal(apart.nodes[first], apart.nodes)
    assert (first[len(mesh.nodes) :] < len(mesh.nodes)).all()
