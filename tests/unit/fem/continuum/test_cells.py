"""Cells of pressure on crooked meshes and cut outlines: areas, forces, moments, means."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import box
from shapely.affinity import translate
from shapely.geometry import Polygon

from groundslab.fem.continuum.cells import LEAST_SHARE, Cells, Grid, cover, make_grid, prolong
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import Mesh
from groundslab.fem.plate import ELEMENTS
from helpers.quads import mesh

CROOKED = mesh(5, 4, 6.0, 4.0, amount=0.2)
STRAIGHT = mesh(6, 4, 6.0, 4.0)


def sheared(xy: np.ndarray, slope: float) -> np.ndarray:
    """Return nodes moved along x by their y: a rectangle becomes a parallelogram."""
    return xy + slope * np.column_stack([xy[:, 1], np.zeros(len(xy))])


def cells_under(nodes: np.ndarray, elements: np.ndarray, size: float, element: str = "mitc9") -> Cells:
    """Return the cells under a plate on a mesh."""
    bounds = nodes[:, 0].min(), nodes[:, 0].max(), nodes[:, 1].min(), nodes[:, 1].max()
    xy = nodes[elements]
    return cover(
        make_grid(bounds, size),
        xy,
        elements,
        len(nodes),
        ELEMENTS[element].w_functions(xy),
        np.zeros(len(xy), dtype=int),
    )


def test_grid_over_a_rectangle():
    """As many cells as come nearest to a size, over the whole of it, numbered along y first."""
    grid = make_grid((-1.0, 2.0, 0.0, 1.0), 0.4)
    assert (grid.nx, grid.ny) == (8, 2)
    assert (grid.nx * grid.dx, grid.ny * grid.dy) == pytest.approx((3.0, 1.0), rel=1e-15)
    x, y = (each.ravel() for each in np.meshgrid(*grid.centers, indexing="ij"))
    assert list(grid.number(x, y)) == list(range(16))


@pytest.mark.parametrize("element", ["mitc9", "q9", "heterosis"])
@pytest.mark.parametrize("size", [0.7, 0.25, 0.1])
@pytest.mark.parametrize("amount", [0.0, 0.2])
def test_forces_keep_resultant_and_moments(element, size, amount):
    """What goes to the nodes from a force on a cell has its size, and its moments about the center of the cell."""
    nodes, elements = mesh(5, 4, 6.0, 4.0, amount=amount)
    cells = cells_under(nodes, elements, size, element)
    assert cells.spread.sum(axis=0) == pytest.approx(1.0, rel=1e-13)
    assert cells.spread.T @ nodes == pytest.approx(cells.center, abs=1e-12)
    force = np.random.default_rng(1).uniform(size=len(cells.number))
    at_nodes = cells.spread @ force
    assert [at_nodes.sum(), *(nodes.T @ at_nodes)] == pytest.approx([force.sum(), *(cells.center.T @ force)], rel=1e-13)


def test_all_cells_bear_under_a_rectangle():
    """Whatever the mesh, the cells are those of the grid, with the area of the plate."""
    for nodes, elements in (STRAIGHT, CROOKED):
        cells = cells_under(nodes, elements, 0.25)
        assert len(cells.number) == 24 * 16
        assert cells.area.sum() == pytest.approx(24.0, rel=1e-13)


def test_means_of_a_quadratic_settlement():
    """The mean of x^2 over a cell is x^2 + dx^2 / 12 on a straight mesh."""
    nodes, elements = STRAIGHT
    cells = cells_under(nodes, elements, 0.25)
    assert cells.spread.T @ nodes[:, 0] ** 2 == pytest.approx(cells.center[:, 0] ** 2 + 0.25**2 / 12, rel=1e-12)


@pytest.mark.parametrize("size", [0.3, 0.12])
def test_cut_cells_bear_that_are_covered_by_half(size):
    """Beside a slanting edge the cells that bear are those of which the plate covers half; near ones are open.

    Together they have the plate's area, up to what a row of cells can be off.
    """
    nodes, elements = sheared(STRAIGHT[0], 0.37), STRAIGHT[1]
    cells = cells_under(nodes, elements, size)
    outline = Polygon([(0, 0), (6, 0), (6 + 4 * 0.37, 4), (4 * 0.37, 4)])
    g = cells.grid
    one = box(g.x0, g.y0, g.x0 + g.dx, g.y0 + g.dy)
    share = np.array(
        [[translate(one, i * g.dx, j * g.dy).intersection(outline).area for j in range(g.ny)] for i in range(g.nx)]
    ).ravel() / (g.dx * g.dy)
    bears = np.isin(np.arange(g.nx * g.ny), cells.number)
    clear = np.abs(share - LEAST_SHARE) > 0.15
    assert clear.mean() > 0.9
    assert (bears == (share > LEAST_SHARE))[clear].all()
    assert cells.area.sum() == pytest.approx(24.0, abs=2 * 4.0 * g.dx * 0.15)


@pytest.mark.parametrize("size", [0.5, 0.15])
def test_nodes_and_elements_take_means_of_the_cells_around_them(size):
    """A constant pressure stays so everywhere, also where the plate covers a cell too little for it to bear."""
    nodes, elements = sheared(CROOKED[0], 0.37), CROOKED[1]
    cells = cells_under(nodes, elements, size)
    one = np.ones(len(cells.number))
    assert cells.around @ one == pytest.approx(1.0, rel=1e-13)
    assert cells.under @ one == pytest.approx(1.0, rel=1e-13)
    assert cells.around.data.min() >= 0
    assert cells.under.data.min() >= 0


@pytest.mark.parametrize("size", [0.5, 0.25, 0.125])
def test_nodes_together_carry_what_the_cells_carry(size):
    """On rectangles the nodes' pressures, over their shares of area, have the resultant of any pressures of cells."""
    nodes, elements = STRAIGHT
    cells = cells_under(nodes, elements, size)
    area = nodal_area(Mesh(nodes, elements), np.arange(len(elements)))
    p = np.random.default_rng(2).uniform(size=len(cells.number)) ** 3
    assert (cells.around @ p) @ area == pytest.approx(p @ cells.area, rel=1e-12)


def test_a_hole_does_not_bear():
    """Cells under an opening carry nothing."""
    nodes, elements = STRAIGHT
    cx, cy = nodes[elements[:, 8]].T
    elements = elements[(cx < 2) | (cx > 4) | (cy < 1) | (cy > 3)]
    cells = cells_under(nodes, elements, 0.25)
    assert cells.area.sum() == pytest.approx(20.0, rel=1e-13)
    x, y = cells.center.T
    assert not ((x > 2) & (x < 4) & (y > 1) & (y < 3)).any()


def two_plates(size: float, gap: float) -> Cells:
    """Return the cells under two plates of 2 x 1 m beside each other, a gap apart along x."""
    nodes, elements = mesh(2, 1, 2.0, 1.0)
    both = np.vstack([nodes, nodes + np.array([2.0 + gap, 0.0])])
    numbers = np.vstack([elements, elements + len(nodes)])
    xy, plate = both[numbers], np.repeat([0, 1], len(elements))
    grid = make_grid((0.0, 4.0 + gap, 0.0, 1.0), size)
    return cover(grid, xy, numbers, len(both), ELEMENTS["mitc9"].w_functions(xy), plate)


def test_plates_share_the_area_of_a_cell_between_them():
    """A cell half of which either covers stands twice, with half of its area each; nodes take their own plate's."""
    cells = two_plates(4 / 3, 0.0)
    assert np.bincount(cells.number).max() == 2
    assert cells.area.sum() == pytest.approx(4.0, rel=1e-13)
    at_nodes = cells.around @ cells.plate
    assert at_nodes == pytest.approx(np.repeat([0.0, 1.0], len(at_nodes) // 2), abs=1e-14)


def test_cells_between_plates_do_not_bear():
    """Neither of two plates covers half of the cells in a wide gap."""
    cells = two_plates(0.25, 1.0)
    assert cells.area.sum() == pytest.approx(4.0, rel=1e-13)
    assert not ((cells.center[:, 0] > 2) & (cells.center[:, 0] < 3)).any()


def test_a_plate_narrower_than_cells_bears_on_those_that_it_covers_best():
    """Two pads so far apart that the grid's cells are wider than they."""
    nodes, elements = mesh(2, 1, 0.2, 1.0)
    both, numbers = np.vstack([nodes, nodes + np.array([7.0, 0.0])]), np.vstack([elements, elements + len(nodes)])
    xy, plate = both[numbers], np.repeat([0, 1], len(elements))
    w = ELEMENTS["mitc9"].w_functions(xy)
    cells = cover(make_grid((0.0, 7.2, 0.0, 1.0), 1.0), xy, numbers, len(both), w, plate)
    assert list(cells.plate) == [0, 1]
    assert cells.center == pytest.approx(np.array([[0.1, 0.5], [7.1, 0.5]]))


def test_finer_cells_follow_coarser_ones():
    """Linear pressures stay linear between the outermost centers, constant ones everywhere."""
    nodes, elements = STRAIGHT
    coarse, fine = cells_under(nodes, elements, 0.5), cells_under(nodes, elements, 0.25)
    assert prolong(coarse, 3.0 * coarse.area, fine) == pytest.approx(3.0 * fine.area, rel=1e-13)
    pressure = 1 + coarse.center @ [0.2, 0.1]
    inside = (np.abs(fine.center - [3.0, 2.0]) <= [2.75, 1.75]).all(axis=1)
    expected = (1 + fine.center @ [0.2, 0.1]) * fine.area
    assert prolong(coarse, pressure * coarse.area, fine)[inside] == pytest.approx(expected[inside], rel=1e-12)


def test_a_single_row_of_cells_hands_on_its_mean():
    """Between cells of which there is but one each way, nothing can be interpolated."""
    nodes, elements = mesh(1, 1, 1.0, 1.0)
    coarse, fine = cells_under(nodes, elements, 1.0), cells_under(nodes, elements, 0.5)
    assert coarse.grid == Grid(0.0, 0.0, 1.0, 1.0, 1, 1)
    assert prolong(coarse, np.array([8.0]), fine) == pytest.approx([2.0] * 4)
