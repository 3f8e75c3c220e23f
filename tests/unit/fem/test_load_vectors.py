"""Loads on parts of a plate: integrals over elements that a part covers, cuts or only touches."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import Point, Polygon, box

from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh, grid
from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.plan import Ring, circle, segment

SQUARE = grid(np.linspace(0, 2, 4), np.linspace(0, 1.5, 3))


def moments(mesh: Mesh, shares: np.ndarray) -> np.ndarray:
    """Return sum, sum x and sum y of element shares: integrals of 1, x, y, as the functions give back linear fields."""
    elements = np.arange(len(mesh.elements))
    return np.array([shares.sum(), (shares * mesh.xy[elements, :, 0]).sum(), (shares * mesh.xy[elements, :, 1]).sum()])


def crooked() -> Mesh:
    """Return a mesh of crooked quadrilaterals with straight sides on 2 x 1.5."""
    mesh = grid(np.linspace(0, 2, 4), np.linspace(0, 1.5, 3))
    corners = mesh.nodes.copy()
    inner = (corners[:, 0] > 0) & (corners[:, 0] < 2) & (corners[:, 1] > 0) & (corners[:, 1] < 1.5)
    corners[inner] += np.random.default_rng(4).uniform(-0.1, 0.1, (inner.sum(), 2))
    xy = corners[mesh.elements]
    for side, (a, b) in enumerate([(0, 1), (1, 2), (2, 3), (3, 0)]):
        xy[:, 4 + side] = (xy[:, a] + xy[:, b]) / 2
    xy[:, 8] = xy[:, :4].mean(axis=1)
    nodes = corners.copy()
    nodes[mesh.elements] = xy
    return Mesh(nodes, mesh.elements)


POLYGONS = {
    "inside one element": box(0.1, 0.1, 0.3, 0.2),
    "across elements": box(0.3, 0.2, 1.7, 1.3),
    "all": box(-1, -1, 5, 5),
    "triangle": Polygon([(0.1, 0.1), (1.9, 0.4), (0.7, 1.4)]),
    "re-entrant": Polygon([(0, 0), (2, 0), (2, 1.5), (1, 0.2), (0, 1.5)]),
    "with a hole": box(0.2, 0.2, 1.8, 1.3).difference(Point(1, 0.7).buffer(0.3, quad_segs=3)),
    "in two parts": box(0, 0, 0.3, 0.3).union(box(1.5, 1, 1.8, 1.4)),
    "beside it": box(3, 3, 4, 4),
    "touching it": box(2, 0, 3, 1),
}


@pytest.mark.parametrize("polygon", POLYGONS.values(), ids=POLYGONS.keys())
@pytest.mark.parametrize("mesh", [SQUARE, crooked()], ids=["rectangles", "crooked"])
def test_forces_and_moments_of_an_area_load(polygon: Polygon, mesh: Mesh) -> None:
    """The nodal forces sum to the loaded area and to its first moments, whatever the polygon and the elements."""
    shares = load_vectors.integrate_over_polygon(mesh, np.arange(len(mesh.elements)), polygon)
    loaded = polygon.intersection(box(0, 0, 2, 1.5))
    centre = loaded.centroid
    wanted = [0, 0, 0] if loaded.area == 0 else [loaded.area, loaded.area * centre.x, loaded.area * centre.y]
    np.testing.assert_allclose(moments(mesh, shares), wanted, atol=1e-12)


@pytest.mark.parametrize("mesh", [SQUARE, crooked()], ids=["rectangles", "crooked"])
def test_polygons_that_overlap_are_integrated_together(mesh: Mesh) -> None:
    """Each has the shares that it has alone, under a pressure that varies and for some of the elements."""
    elements = np.array([5, 0, 3, 2])
    together = load_vectors.integrate_over_polygons(mesh, elements, [*POLYGONS.values()], lambda x: 1 + x[..., 0])
    for polygon, shares in zip(POLYGONS.values(), together, strict=True):
        alone = load_vectors.integrate_over_polygon(mesh, elements, polygon, lambda x: 1 + x[..., 0])
        np.testing.assert_allclose(shares, alone, rtol=0, atol=1e-14)
        one_by_one = [load_vectors.integrate_over_polygon(mesh, elements[i : i + 1], polygon)[0] for i in range(4)]
        whole = load_vectors.integrate_over_polygon(mesh, elements, polygon)
        np.testing.assert_allclose(whole, one_by_one, rtol=0, atol=1e-14)


def test_parts_of_an_area_load_add_up() -> None:
    """The nodal forces of a whole are those of its halves together, node by node, however they are cut."""
    mesh, whole = crooked(), box(0.2, 0.1, 1.9, 1.45)
    cut = Polygon([(-1, -1), (1.3, -1), (0.4, 3), (-1, 3)])
    elements = np.arange(len(mesh.elements))
    parts = [load_vectors.integrate_over_polygon(mesh, elements, part) for part in (whole & cut, whole - cut)]
    np.testing.assert_allclose(sum(parts), load_vectors.integrate_over_polygon(mesh, elements, whole), atol=1e-9)


def test_a_whole_element_is_met_exactly_in_pieces() -> None:
    """Cut into pieces along its diagonal a rectangle gives the same shares as integrated whole."""
    elements = np.arange(len(SQUARE.elements))
    halves = [Polygon([(0, 0), (2, 0), (2, 1.5)]), Polygon([(0, 0), (2, 1.5), (0, 1.5)])]
    pieces = sum(load_vectors.integrate_over_polygon(SQUARE, elements, half) for half in halves)
    np.testing.assert_allclose(pieces, load_vectors.integrate_over_elements(SQUARE, elements), atol=1e-14)


LINES = {
    "inside": [(0.1, 0.1), (0.3, 0.2)],
    "across": [(0.05, 0.1), (1.9, 1.45)],
    "along common sides": [(0.0, 0.75), (2.0, 0.75)],
    "on the edge": [(0.0, 0.0), (2.0, 0.0)],
}


@pytest.mark.parametrize("ends", LINES.values(), ids=LINES.keys())
@pytest.mark.parametrize("mesh", [SQUARE, crooked()], ids=["rectangles", "crooked"])
def test_forces_and_moments_of_a_line_load(ends: list[tuple[float, float]], mesh: Mesh) -> None:
    """The nodal forces sum to the length and to its first moments, along and across the sides of elements."""
    line = np.array(ends)
    shares = load_vectors.integrate_along_line(mesh, np.arange(len(mesh.elements)), segment(*ends))
    length, middle = np.linalg.norm(line[1] - line[0]), line.mean(axis=0)
    np.testing.assert_allclose(moments(mesh, shares), [length, *(length * middle)], atol=1e-12)


ARCS = {
    "quarter": ((1.6, 0.7), (1.0, 1.3), math.tan(math.pi / 8)),
    "three quarters, clockwise": ((1.6, 0.7), (1.0, 1.3), -math.tan(3 * math.pi / 8)),
    "shallow": ((0.1, 0.2), (1.9, 0.4), 0.01),
    "half, touching the edge": ((0.25, 0.5), (1.25, 0.5), 1.0),
}


@pytest.mark.parametrize("arc", ARCS.values(), ids=ARCS.keys())
@pytest.mark.parametrize("mesh", [SQUARE, crooked()], ids=["rectangles", "crooked"])
def test_forces_and_moments_of_an_arc(arc: tuple[tuple[float, float], tuple[float, float], float], mesh: Mesh) -> None:
    """A line load q = 1 to 3 on an arc gives int q ds and its moments, by the integrals over the angle in closed form.

    From the angle a over the sweep t the way is r t s, q = 1 + 2 s: int q ds = 2 r |t|, and int x ds by parts.
    """
    edge = segment(*arc)
    r, a, t, (cx, cy) = edge.radius, edge.angle, edge.sweep, edge.centre
    # int_0^1 (1 + 2 s) cos(a + t s) ds and the same of sin
    cos = (3 * math.sin(a + t) - math.sin(a)) / t + 2 * (math.cos(a + t) - math.cos(a)) / t**2
    sin = (-3 * math.cos(a + t) + math.cos(a)) / t + 2 * (math.sin(a + t) - math.sin(a)) / t**2
    length = r * abs(t)
    wanted = [2 * length, length * (2 * cx + r * cos), length * (2 * cy + r * sin)]
    shares = load_vectors.integrate_along_line(mesh, np.arange(len(mesh.elements)), edge, (1.0, 3.0))
    np.testing.assert_allclose(moments(mesh, shares), wanted, rtol=1e-10, atol=1e-12)


def test_a_ring_gives_its_area_and_its_moments() -> None:
    """A pressure on a circle of 0.5 m with a hole of 0.3 m beside its middle: pi (R^2 - r^2) and first moments."""
    area = equal_area_polygon(circle((1.0, 0.7), 0.5)).difference(equal_area_polygon(circle((1.1, 0.7), 0.3)))
    shares = load_vectors.integrate_over_polygon(SQUARE, np.arange(len(SQUARE.elements)), area)
    R, r = math.pi * 0.25, math.pi * 0.09
    np.testing.assert_allclose(moments(SQUARE, shares), [R - r, R - 1.1 * r, 0.7 * (R - r)], rtol=1e-9)


@pytest.mark.parametrize("bulge", [0.01, 0.4, 1.0, 3.0, -0.4, 1e3])
def test_chords_keep_the_area_below_an_arc(bulge: float) -> None:
    """A triangle with an arc for a side, convex or hollow, has its exact area as a polygon for loads."""
    ring = Ring(((0.0, 0.0), (10.0, 0.0), (5.0, 9.0)), (bulge,) if bulge > 0 else (0.0, bulge))
    if abs(bulge) > 1:
        ring = Ring(((0.0, 0.0), (10.0, 0.0)), (bulge, 0.0))
    assert equal_area_polygon(ring).area == pytest.approx(ring.area, rel=1e-11)


def test_a_force_on_a_node_goes_to_the_node() -> None:
    """At a node all of the force is that node's; anywhere its shares sum to one about the point."""
    mesh, elements = crooked(), np.arange(6)
    node = mesh.elements[2, 5]
    shares = load_vectors.integrate_at_point(mesh, elements, mesh.nodes[node])
    np.testing.assert_allclose(np.bincount(mesh.elements.ravel(), shares.ravel())[node], 1, atol=1e-12)
    shares = load_vectors.integrate_at_point(mesh, elements, np.array([0.33, 1.2]))
    np.testing.assert_allclose(moments(mesh, shares), [1, 0.33, 1.2], atol=1e-12)


def test_a_point_off_the_plate_is_refused() -> None:
    """A force beside the plate is an error, not lost."""
    with pytest.raises(ValueError, match="does not lie on the plate"):
        load_vectors.integrate_at_point(SQUARE, np.arange(6), np.array([2.1, 1.0]))


def test_curved_elements_keep_their_area() -> None:
    """An element with a curved side, cut in two, gives its area: chords follow the side that enclose the same area."""
    mesh = grid(np.array([0.0, 1.0]), np.array([0.0, 1.0]))
    nodes = mesh.nodes.copy()
    nodes[mesh.elements[0, 5]] = [1.1, 0.5]
    curved = Mesh(nodes, mesh.elements)
    elements = np.arange(1)
    whole = load_vectors.integrate_over_elements(curved, elements).sum()
    halves = [load_vectors.integrate_over_polygon(curved, elements, box(0, a, 2, a + 0.5)).sum() for a in (0.0, 0.5)]
    assert whole == pytest.approx(1 + 2 / 3 * 0.1, rel=1e-12)
    assert sum(halves) == pytest.approx(whole, rel=1e-12)


@pytest.mark.parametrize("polygon", POLYGONS.values(), ids=POLYGONS.keys())
@pytest.mark.parametrize("mesh", [SQUARE, crooked()], ids=["rectangles", "crooked"])
def test_elements_that_are_not_near_carry_nothing(polygon: Polygon, mesh: Mesh) -> None:
    """Over the elements near a polygon the integrals are those over all, and all others have none."""
    near = load_vectors.find_elements_near(mesh, polygon)
    whole = load_vectors.integrate_over_polygon(mesh, np.arange(len(mesh.elements)), polygon)
    assert np.array_equal(load_vectors.integrate_over_polygon(mesh, near, polygon), whole[near])
    assert not np.delete(whole, near, axis=0).any()


def test_a_curved_side_reaches_beyond_its_nodes() -> None:
    """A side through (1, 0), (1.3, 0.5) and (1.3, 1) bulges beyond x = 1.3; what lies there alone is near."""
    xy = [(0, 0), (1, 0), (1.3, 1), (0, 1), (0.5, 0), (1.3, 0.5), (0.65, 1), (0, 0.5), (0.6, 0.5)]
    mesh = Mesh(np.array(xy, dtype=float), np.arange(9)[None])
    bulge = box(1.305, 0, 2, 1)
    assert load_vectors.integrate_over_polygon(mesh, np.array([0]), bulge).sum() > 0
    assert load_vectors.find_elements_near(mesh, bulge).tolist() == [0]
    assert load_vectors.find_elements_near(mesh, box(2, 0, 3, 1)).tolist() == []
