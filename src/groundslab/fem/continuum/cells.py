"""Cells of constant pressure under a plate: a regular grid clipped to its outline, and the plate's means over them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.shape_functions import jacobian, q9

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: A cell of which the plate covers less than this share bears nothing.
LEAST_SHARE = 1e-3
#: Each element is divided into so many parts a side for each cell that it is long, with Gauss's two points each way.
PARTS = 2
#: Elements whose points are placed at a time.
_CHUNK = 4096


@dataclass(frozen=True, slots=True)
class Grid:
    """A regular grid of nx by ny cells dx by dy [m] from a corner (x0, y0) [m]; cell i, j has the number i ny + j."""

    x0: float
    y0: float
    dx: float
    dy: float
    nx: int
    ny: int

    @property
    def centers(self) -> tuple[Array, Array]:
        """Return x (nx,) and y (ny,) of the centers [m]."""
        return self.x0 + self.dx * np.arange(0.5, self.nx), self.y0 + self.dy * np.arange(0.5, self.ny)

    def number(self, x: Array, y: Array) -> Integers:
        """Return the numbers of the cells that hold places in the grid."""
        i = np.clip(((x - self.x0) / self.dx).astype(np.int64), 0, self.nx - 1)
        j = np.clip(((y - self.y0) / self.dy).astype(np.int64), 0, self.ny - 1)
        found: Integers = i * self.ny + j
        return found


def make_grid(bounds: tuple[float, float, float, float], size: float) -> Grid:
    """Return the grid over a rectangle (x0, x1, y0, y1) [m] whose cells have about a size [m]."""
    x0, x1, y0, y1 = bounds
    nx, ny = (max(1, round(length / size)) for length in (x1 - x0, y1 - y0))
    return Grid(x0, y0, (x1 - x0) / nx, (y1 - y0) / ny, nx, ny)


@dataclass(frozen=True, slots=True)
class Cells:
    """The c cells of a grid that plates cover, wholly or in part; one that two plates cover stands twice."""

    grid: Grid
    number: Integers  # (c,): of each in the grid
    area: Array  # (c,) [m2]: what the plate covers of it
    center: Array  # (c, 2) [m]: of what the plate covers
    spread: csr_array  # (n, c): share of a force on each cell that goes to w of each node; means of w, transposed
    around: csr_array  # (n, c): what is made of values of cells for nodes, means of those around them
    under: csr_array  # (m, c): the same for elements
    plate: Integers  # (c,): number of the plate

    def on_grid(self, values: Array) -> Array:
        """Return the sums of values (c,) on the whole grid (nx, ny), zero elsewhere."""
        found = np.bincount(self.number, values, self.grid.nx * self.grid.ny).astype(np.float64)
        return found.reshape(self.grid.nx, self.grid.ny)


def cover(grid: Grid, xy: Array, elements: Integers, nodes: int, w: Array, plate: Integers) -> Cells:
    """Return the cells of a grid under the elements of plates.

    Parameters
    ----------
    grid : Grid
        The grid, which holds all of the elements.
    xy : (m, 9, 2) array of float
        Nodes of the elements [m].
    elements : (m, 9) array of int
        Numbers of these nodes.
    nodes : int
        Number of all nodes, n.
    w : (m, 9, 9) array of float
        What makes the settlement of an element's nodes from those that are unknowns.
    plate : (m,) array of int
        Number of each element's plate.

    Returns
    -------
    Cells
        Those covered.
    """
    from scipy.sparse import coo_array, csr_array

    size = grid.nx * grid.ny
    pairs = _pairs(grid, xy)
    element, area = pairs.element, pairs.area
    cell = plate[element] * size + pairs.cell
    on_cells = np.bincount(cell, weights=area, minlength=1).astype(np.float64)
    number = np.flatnonzero(on_cells > LEAST_SHARE * grid.dx * grid.dy)
    covered = on_cells[number]

    def matrix(values: Array, row: Integers, rows: int) -> csr_array:
        column = np.repeat(cell, len(row) // len(cell))
        return csr_array(coo_array((values, (row, column)), shape=(rows, len(on_cells))))[:, number]

    spread = matrix(np.einsum("pa,pab->pb", pairs.shapes, w[element]).ravel(), elements[element].ravel(), nodes)
    return Cells(
        grid,
        number % size,
        covered,
        np.stack([np.bincount(cell, weights=x)[number] / covered for x in pairs.moment.T], axis=1),
        csr_array(spread.multiply(1 / covered[None, :])),
        _rows_to_one(matrix(pairs.hats.ravel(), elements[element].ravel(), nodes)),
        _rows_to_one(matrix(area, element, len(xy))),
        number // size,
    )


def prolong(coarse: Cells, force: Array, fine: Cells) -> Array:
    """Return forces on finer cells (c,) [N] whose pressures follow those of coarser ones linearly."""
    from scipy.interpolate import RegularGridInterpolator

    centers = coarse.grid.centers
    pressure = coarse.on_grid(force / coarse.area)
    if min(pressure.shape) < 2:
        return np.full(len(fine.area), force.sum() / fine.area.sum()) * fine.area
    # beyond the outermost centers pressures are those there
    places = [np.clip(x, c[0], c[-1]) for x, c in zip(fine.center.T, centers, strict=True)]
    found: Array = RegularGridInterpolator(centers, pressure)(np.column_stack(places)) * fine.area
    return found


def _rows_to_one(matrix: csr_array) -> csr_array:
    """Return a matrix whose rows have the sum one, or zero."""
    from scipy.sparse import csr_array

    sums = matrix.sum(axis=1)
    return csr_array(matrix.multiply(np.divide(1.0, sums, out=np.zeros_like(sums), where=sums > 0)[:, None]))


@dataclass(frozen=True, slots=True)
class _Pairs:
    """What p pairs of an element and a cell that it covers have in common."""

    element: Integers  # (p,)
    cell: Integers  # (p,): number in the grid
    area: Array  # (p,) [m2]
    moment: Array  # (p, 2) [m3]: int x dA and int y dA
    shapes: Array  # (p, 9) [m2]: integrals of the element's shape functions
    hats: Array  # (p, 9) [m2]: of functions that are linear between neighboring nodes each way, and positive


def _pairs(grid: Grid, xy: Array) -> _Pairs:
    """Return the pairs of elements (m, 9, 2) and cells that share a part, integrated by points in the elements."""
    points, weights = _points(grid, xy)
    N, dN = q9(points)
    values = np.column_stack([np.ones(len(N)), N, _hats(points)])
    found = []
    for start in range(0, len(xy), _CHUNK):
        part = xy[start : start + _CHUNK]
        at = np.einsum("pa,eax->epx", N, part)
        dA = jacobian(dN, part)[2] * weights
        pair = np.arange(start, start + len(part))[:, None] * (grid.nx * grid.ny) + grid.number(at[..., 0], at[..., 1])
        order = np.argsort(pair, axis=None, kind="stable")
        pair = pair.ravel()[order]
        first = np.flatnonzero(np.diff(pair, prepend=-1))
        all_ = np.column_stack([values[order % len(points)], at.reshape(-1, 2)[order]])
        found.append(np.column_stack([pair[first], np.add.reduceat(dA.ravel()[order, None] * all_, first)]))
    rows = np.concatenate(found)
    element, cell = np.divmod(rows[:, 0].astype(np.int64), grid.nx * grid.ny)
    return _Pairs(element, cell, rows[:, 1], rows[:, 20:], rows[:, 2:11], rows[:, 11:20])


def _hats(points: Array) -> Array:
    """Return functions (p, 9) of an element's nodes that are linear each way between neighboring ones."""
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0], [0, 0]], dtype=float)
    hats: Array = np.maximum(1 - np.abs(points[:, None] - corners), 0.0).prod(axis=2)
    return hats


def _points(grid: Grid, xy: Array) -> tuple[Array, Array]:
    """Return points (p, 2) and weights (p,) of Gauss's rule on parts of an element, as many as the largest needs."""
    extent = np.ptp(xy, axis=1).max(axis=0)
    parts = [max(1, PARTS * round(float(length / d))) for length, d in zip(extent, (grid.dx, grid.dy), strict=True)]
    n = max(parts)
    s, weight = np.polynomial.legendre.leggauss(2)
    edges = np.linspace(-1, 1, n + 1)
    s = (edges[:-1, None] + (s + 1) / n).ravel()
    weight = np.tile(weight, n) / n
    X, Y = np.meshgrid(s, s, indexing="ij")
    return np.column_stack([X.ravel(), Y.ravel()]), np.outer(weight, weight).ravel()
