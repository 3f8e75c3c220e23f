"""Creases: which elements round a node lie on which side of a wall, by hand; means over discs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.sparse import csr_array

from groundslab.analysis.driver import solve
from groundslab.arrays import Flags
from groundslab.fem.mesh import Mesh, grid, sides_along
from groundslab.geometry.plan import Segment
from groundslab.meshing.refinement import split
from groundslab.model.model import Model
from groundslab.results.disc_means import AcrossEdge, DiscMeans, _disc_points, make_disc_means
from groundslab.results.mirroring import split_at

MESH = grid(np.arange(5.0), np.arange(5.0))
CENTRES = MESH.nodes[MESH.elements[:, 8]]


def groups_at(
    place: tuple[float, float], lines: list[tuple[tuple[float, float], tuple[float, float]]]
) -> set[frozenset[int]]:
    """Return the sets of elements that belong together at a node, with creases along lines."""
    creases = sides_along(MESH, MESH.elements, [Segment(*line) for line in lines])
    number = split_at(MESH.elements, creases, len(MESH.nodes))
    node = int(np.flatnonzero((MESH.nodes == place).all(axis=1))[0])
    at = [(element, number[element, local]) for element, local in zip(*np.nonzero(MESH.elements == node), strict=True)]
    return {frozenset(int(e) for e, n in at if n == label) for _, label in at}


@pytest.mark.parametrize(
    ("place", "lines", "groups"),
    [
        ((2, 2), [((2, 0), (2, 4))], [{5, 9}, {6, 10}]),  # a wall from edge to edge
        ((2, 0), [((2, 0), (2, 4))], [{1}, {2}]),  # where it begins at the edge
        ((2, 2), [((2, 2), (2, 4))], [{5, 6, 9, 10}]),  # a wall that ends within the plate holds nothing apart there
        ((2, 2), [((2, 0), (2, 4)), ((0, 2), (4, 2))], [{5}, {6}, {9}, {10}]),  # a crossing
        ((2, 2), [((2, 0), (2, 2)), ((2, 2), (4, 2))], [{6}, {5, 9, 10}]),  # a corner
        ((2, 2), [((2, 0), (2, 4)), ((2, 2), (4, 2))], [{5, 9}, {6}, {10}]),  # a wall that meets another
        ((1, 1), [((2, 0), (2, 4))], [{0, 1, 4, 5}]),  # away from it
    ],
)
def test_sides_of_walls(place: tuple[float, float], lines: list, groups: list[set[int]]) -> None:
    """Elements belong together if one comes from one to the other round the node without crossing a wall."""
    assert groups_at(place, lines) == {frozenset(group) for group in groups}


def test_without_creases_all_belong_together() -> None:
    """The number is 0 everywhere off the creases."""
    creases = sides_along(MESH, MESH.elements, [Segment((2.0, 0.0), (2.0, 1.0))])
    number = split_at(MESH.elements, creases, len(MESH.nodes))
    on = np.isin(MESH.elements, creases)
    assert not number[~on].any()
    assert len(creases) == 1


def disc_means(t: float = 0.8, elements: int = 8, **changes: Any) -> tuple[Mesh, DiscMeans, Flags]:
    """Return a mesh of 4 m x 4 m, the means for a force in its middle, and which nodes lie within its thickness.

    Where it is `hanging`, elements right of the middle are cut into four.
    """
    given = {
        "plate": {"length_x": 4.0, "length_y": 4.0, "thickness": t, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 1e7},
        "loads": [{"kind": "point", "P": 1e5, "x": 0.0, "y": 0.0}],
    }
    lines = np.linspace(-2, 2, elements + 1)
    mesh = grid(lines, lines)
    if changes.pop("hanging", False):
        mesh, _ = split(mesh, mesh.nodes[mesh.elements[:, 8], 0] > 0)
    of_elements = np.full(len(mesh.elements), t)
    section = (mesh.nodes[mesh.elements[:, 8], 0] > 0).astype(int) if changes.pop("divided", False) else of_elements * 0
    means = make_disc_means(Model.model_validate(given | changes), mesh, section.astype(np.int64), of_elements)
    return mesh, means, np.hypot(*mesh.nodes.T) <= t * (1 + 1e-9)


def test_means_over_discs() -> None:
    """Within a thickness a linear field is its own mean, x^2 is larger by (t / 2)^2 / 4; beyond nothing changes.

    Where the force's own part of the disc is divided, both hold to a hundredth of what changes over the disc.
    """
    mesh, means, near = disc_means()
    assert sorted(means.nodes) == np.flatnonzero(near).tolist()
    x, y = mesh.nodes.T
    np.testing.assert_allclose(means.apply(1 + 2 * x - 3 * y), 1 + 2 * x - 3 * y, atol=2e-3)
    np.testing.assert_allclose(means.apply(x * x) - x * x, np.where(near, 0.4**2 / 4, 0), atol=4e-4)
    np.testing.assert_array_equal(means.apply(x)[~near], x[~near])


@pytest.mark.parametrize("hanging", [False, True])
def test_means_over_discs_between_corners(hanging: bool) -> None:
    """Small elements have the mean of their corners' means, of x^2 larger by at most (side / 2)^2."""
    mesh, means, near = disc_means(elements=100, hanging=hanging)
    assert sorted([*means.nodes, *means.between]) == np.flatnonzero(near).tolist()
    assert len(means.between) > 2 * len(means.nodes)
    np.testing.assert_allclose(mesh.nodes[means.corners].mean(axis=1), mesh.nodes[means.between], atol=1e-12)
    x, y = mesh.nodes.T
    np.testing.assert_allclose(means.apply(1 + 2 * x - 3 * y), 1 + 2 * x - 3 * y, atol=2e-3)
    np.testing.assert_allclose(means.apply(x * x) - x * x, np.where(near, 0.4**2 / 4, 0), atol=4e-4 + 0.02**2)


def test_means_over_discs_keep_to_their_section() -> None:
    """A field that is another constant in each section stays so; without a singular place there are no means."""
    mesh, means, _ = disc_means(divided=True)
    inside = means.nodes[mesh.nodes[means.nodes, 0] > 0]
    field = np.where(mesh.nodes[:, 0] >= 0, 5.0, 1.0)
    np.testing.assert_allclose(means.apply(field)[inside], 5.0)
    assert not len(disc_means(loads=[{"kind": "uniform", "q": 1e4}])[1].nodes)


@pytest.mark.parametrize(
    ("support", "bends", "twists"), [("free", False, False), ("hinged", False, True), ("clamped", True, True)]
)
def test_means_vanish_at_edges_as_moments_do(support: str, bends: bool, twists: bool) -> None:
    """By hand: at an edge m_x = m_xy = 2 - x have the mean 0, or the half disc's, 4 r / 3 pi, where they may act.

    Inside, where the disc of r = 0.4 m still meets the edge, they are their own mean; along the edge m_y has that of
    what lies on the plate.
    """
    at_edge = [{"kind": "point", "P": 1e5, "x": 2.0, "y": 0.0}]
    plate = {"length_x": 4.0, "length_y": 4.0, "thickness": 0.8, "E": 30e9, "nu": 0.2, "edges": {"right": support}}
    mesh, means, _ = disc_means(elements=40, loads=at_edge, plate=plate)
    x, y = mesh.nodes.T
    m_x, m_y, m_xy = means.apply_to_moments(np.column_stack([2 - x] * 3)).T
    near = np.hypot(x - 2, y) < 0.3
    edge = near & (x == 2.0)
    half = 4 * 0.4 / (3 * np.pi)
    np.testing.assert_allclose(m_y[edge], half, atol=5e-3)
    np.testing.assert_allclose(m_x[edge], half if bends else 0.0, atol=5e-3)
    np.testing.assert_allclose(m_xy[edge], half if twists else 0.0, atol=5e-3)
    if not bends:
        np.testing.assert_allclose(m_x[near], (2 - x)[near], atol=6e-3)


def test_corners_that_point_into_the_plate_keep_their_moments() -> None:
    """No field goes on across edges that end there: a constant one is its own mean around an opening's corner."""
    opening = [{"kind": "rectangle", "x": (-1.0, 0.0), "y": (-1.0, 0.0)}]
    plate = {"length_x": 4.0, "length_y": 4.0, "thickness": 0.8, "E": 30e9, "nu": 0.2, "openings": opening}
    mesh, means, _ = disc_means(elements=40, plate=plate, loads=[{"kind": "uniform", "q": 1e4}])
    found = means.apply_to_moments(np.ones((len(mesh.nodes), 3)))
    corner = np.hypot(*mesh.nodes.T) < 0.01
    assert corner.any()
    np.testing.assert_allclose(found[corner], 1.0)


def test_moments_vanish_across_an_oblique_edge() -> None:
    """At 45 degrees a tensor keeps what bends along the edge, m_tt.

    Of m_x = 3, m_y = 1, m_xy = 2 it is (3 + 1) / 2 - 2 = 0; of 6, 4, -1 it is 5 + 1 = 6, which is 3, 3, -3 alone.
    """
    one = csr_array(np.eye(1))
    edge = AcrossEdge(np.array([0]), np.array([1.0, 1.0]) / np.sqrt(2), 0 * one, twists=False)
    none = np.zeros((0, 4), dtype=int)
    means = DiscMeans(np.array([0]), one, none[:, 0], none, (edge,))
    np.testing.assert_allclose(means.apply_to_moments(np.array([[3.0, 1.0, 2.0]])), 0.0, atol=1e-12)
    np.testing.assert_allclose(means.apply_to_moments(np.array([[6.0, 4.0, -1.0]])), [[3.0, 3.0, -3.0]])


def test_means_over_discs_that_hold_a_singular_place() -> None:
    """The mean of 1 / sqrt(r) over discs around places near r = 0 is low by a percent, wherever they lie."""
    x, y = np.meshgrid(np.linspace(0.0, 0.45, 19), np.linspace(0.0, 0.2, 9))
    centres = np.column_stack([x.ravel(), y.ravel()])
    row, offset, weight = _disc_points(centres, np.full(len(centres), 0.5), [(0.0, 0.0)])
    np.testing.assert_allclose(np.bincount(row, weight), 1.0, rtol=1e-12)
    found = np.bincount(row, weight / np.sqrt(np.hypot(*(centres[row] + offset).T)))
    # around the singular place: int r dr / sqrt(r) over each ray, up to where it leaves the disc
    angle = 2 * np.pi * (np.arange(2000) + 0.5) / 2000
    along = centres @ [np.cos(angle), np.sin(angle)]
    end = along + np.sqrt(0.25 - (centres**2).sum(axis=1)[:, None] + along**2)
    exact = (end**1.5 / 1.5).mean(axis=1) * 2 / 0.25
    np.testing.assert_allclose(found, exact, rtol=0.02)
    assert np.std(found / exact) < 0.005


@pytest.mark.parametrize("size", [0.1, 0.2])
def test_shear_forces_beside_a_wall_are_half_of_its_load(size: float) -> None:
    """On both sides of the middle of a footing of 1.2 m under a wall of 150 kN/m, whatever the mesh that follows it."""
    given = {
        "plate": {"length_x": 6.0, "length_y": 1.2, "thickness": 0.4, "E": 30e9, "nu": 0.0},
        "ground": {"kind": "winkler", "k": 2e7},
        "loads": [{"kind": "line", "q": 150e3, "points": [(-3.0, 0.0), (3.0, 0.0)]}],
        "mesh": {"size": size},
    }
    plate = solve(Model.model_validate(given)).only.plate
    on_wall = np.flatnonzero((plate.nodes[:, 1] == 0.0) & (np.abs(plate.nodes[:, 0]) < 2.0))
    assert len(on_wall) == 2 * len(np.unique(plate.nodes[on_wall, 0]))
    np.testing.assert_allclose(np.abs(plate.shear_y[on_wall]), 75e3, rtol=0.01)
    assert plate.shear_y[on_wall].sum() == pytest.approx(0.0, abs=1.0)


def test_shear_forces_have_a_kink_along_an_arc_that_the_mesh_follows() -> None:
    """At the border of a pressure on a disk Q = q b / 2, along x and along y (statics of a circular plate)."""
    given = {
        "plate": {
            "outline": {"kind": "circle", "radius": 2.0},
            "thickness": 0.1,
            "E": 30e9,
            "nu": 0.2,
            "support": "clamped",
        },
        "ground": {"kind": "winkler", "k": 1.0},
        "contact": {"tensionless": False},
        "loads": [{"kind": "area", "q": 1e3, "shape": {"kind": "circle", "radius": 0.8}}],
        "mesh": {"accuracy": 0.05},
    }
    plate = solve(Model.model_validate(given)).only.plate
    on_border = np.abs(np.hypot(*plate.nodes.T) - 0.8) < 1e-6
    shear = np.hypot(plate.shear_x, plate.shear_y)[on_border]
    assert len(shear) > 16
    np.testing.assert_allclose(shear, 400.0, rtol=0.01)


@pytest.mark.parametrize("tensionless", [True, False])
@pytest.mark.parametrize("mesh", [{"size": 0.5}, {"accuracy": 0.05}], ids=["grid", "adaptive"])
def test_pressures_at_the_border_of_two_springs_have_both_sides(tensionless: bool, mesh: dict[str, float]) -> None:
    """Each is the settlement there times the stiffness of its side, and both together carry the load."""
    zone = {"shape": {"kind": "rectangle", "x": (0.0, 4.0), "y": (-3.0, 3.0)}, "ground": {"kind": "winkler", "k": 60e6}}
    found = solve(
        Model.model_validate({
            "plate": {"length_x": 8.0, "length_y": 6.0, "thickness": 0.4, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "winkler", "k": 20e6},
            "soil_zones": [zone],
            "contact": {"tensionless": tensionless},
            "loads": [{"kind": "uniform", "q": 50e3}],
            "mesh": mesh,
        })
    ).only  # fmt: skip
    plate = found.plate
    on_border = np.flatnonzero(np.abs(plate.nodes[:, 0]) < 1e-9)
    y = plate.nodes[on_border, 1].round(9)
    k = plate.pressure[on_border] / plate.settlement[on_border]
    soft = k < 40e6
    # where one side has smaller elements, every other place is of this side alone
    assert len(y) == len(np.unique(y[soft])) + len(np.unique(y[~soft]))
    assert len(np.intersect1d(y[soft], y[~soft])) > len(y) / 3
    np.testing.assert_allclose(k, np.where(soft, 20e6, 60e6), rtol=2e-3)
    assert plate.contact_force.sum() == pytest.approx(50e3 * 48.0, rel=1e-9)
