"""Cells of constant pressure under a plate: a regular grid clipped to its outline, and the plate's means over them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.shape_functions import determinants, q9

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: A cell of which the plate covers less than this share bears nothing, one of which it covers more bears wholly: half
#: keeps the area of the plate, and its outline, where they are. A little less, so that rounding does not decide.
LEAST_SHARE = 0.5 - 1e-6
#: Each element is divided into so many parts a side for each cell that it is long, with Gauss's two points each way;
#: thirds are where the functions of its nodes have their kinks.
PARTS = 3
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
        numbers: Integers = i * self.ny + j
        return numbers


def make_grid(bounds: tuple[float, float, float, float], size: float) -> Grid:
    """Return the grid over a rectangle (x0, x1, y0, y1) [m] whose cells have about a size [m]."""
    x0, x1, y0, y1 = bounds
    nx, ny = (max(1, round(length / size)) for length in (x1 - x0, y1 - y0))
    return Grid(x0, y0, (x1 - x0) / nx, (y1 - y0) / ny, nx, ny)


@dataclass(frozen=True, slots=True)
class Cells:
    """The c cells of a grid half of which plates cover at least; one that two plates share stands twice."""

    grid: Grid
    number: Integers  # (c,): of each in the grid
    area: Array  # (c,) [m2]: of the whole cell, on which the ground feels the pressure
    center: Array  # (c, 2) [m]: of what the plate covers
    spread: csr_array  # (n, c): share of a force on each cell that goes to w of each node; means of w, transposed
    around: csr_array  # (n, c): what is made of values of cells for nodes, means of those around them
    under: csr_array  # (m, c): the same for elements
    plate: Integers  # (c,): number of the plate

    def on_grid(self, values: Array) -> Array:
        """Return the sums of values (c,) on the whole grid (nx, ny), zero elsewhere."""
        sums = np.bincount(self.number, values, self.grid.nx * self.grid.ny).astype(np.float64)
        return sums.reshape(self.grid.nx, self.grid.ny)


def cover(
    grid: Grid, xy: Array, elements: Integers, nodes: int, w: Array, plate: Integers, moving: Integers | None = None
) -> Cells:
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
        What makes the settlement of an element's nodes from those of the nodes that move them.
    plate : (m,) array of int
        Number of each element's plate.
    moving : (m, 9) array of int, optional
        Numbers of the nodes that move each element, where some of its own hang, see `hanging.connect`.

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
    on_cells = np.bincount(cell, weights=area, minlength=size * (int(plate.max()) + 1)).astype(np.float64)
    # of a plate narrower than cells those bear that it covers best
    whole = np.minimum(on_cells.reshape(-1, size).max(axis=1), grid.dx * grid.dy)
    number = np.flatnonzero(on_cells >= LEAST_SHARE * whole.repeat(size))
    covered, near, within = on_cells[number], _nearest(grid, number, cell), number % size

    def matrix(values: Array, row: Integers, rows: int, to: Integers) -> csr_array:
        column = np.repeat(to, len(row) // len(cell))
        return csr_array(coo_array((values, (row, column)), shape=(rows, len(on_cells))))[:, number]

    moving = elements if moving is None else moving
    spread = matrix(np.einsum("pa,pab->pb", pairs.shapes, w[element]).ravel(), moving[element].ravel(), nodes, cell)
    return Cells(
        grid,
        within,
        grid.dx * grid.dy / np.bincount(within, minlength=size)[within],
        np.stack([np.bincount(cell, weights=x)[number] / covered for x in pairs.moment.T], axis=1),
        csr_array(spread.multiply(1 / covered[None, :])),
        _rows_to_one(matrix(pairs.hats.ravel(), elements[element].ravel(), nodes, near)),
        _rows_to_one(matrix(area, element, len(xy), near)),
        number // size,
    )


def _nearest(grid: Grid, number: Integers, cell: Integers) -> Integers:
    """Return for some cells (p,), counted through the plates, the nearest one under the same plate that bears (c,)."""
    from scipy.spatial import cKDTree

    nearest, lost = cell.copy(), ~np.isin(cell, number)
    if lost.any() and len(number):
        far = grid.nx * grid.ny * max(grid.dx, grid.dy)
        places = [
            np.column_stack(np.unravel_index(numbers % (grid.nx * grid.ny), (grid.nx, grid.ny))) * [grid.dx, grid.dy]
            for numbers in (number, cell[lost])
        ]
        plates = [far * (numbers // (grid.nx * grid.ny)) for numbers in (number, cell[lost])]
        bearing, asked = (np.column_stack(columns) for columns in zip(places, plates, strict=True))
        nearest[lost] = number[cKDTree(bearing).query(asked)[1]]
    return nearest


def prolong(coarse: Cells, force: Array, fine: Cells) -> Array:
    """Return forces on finer cells (c,) [N] whose pressures follow those of coarser ones linearly, plate by plate.

    Where a gap is open the force may be the tension that would close it, were the cell alone: then pressure ends where
    gaps begin, between the centers of coarser cells.
    """
    from scipy.interpolate import RegularGridInterpolator

    centers, pressures = coarse.grid.centers, np.zeros(len(fine.area))
    for plate in np.unique(fine.plate):
        pressure, mask = _pressures(coarse, force, coarse.plate == plate), fine.plate == plate
        if min(pressure.shape) < 2:
            pressures[mask] = pressure.mean()
            continue
        # beyond the outermost centers pressures are those there
        places = [np.clip(x, c[0], c[-1]) for x, c in zip(fine.center[mask].T, centers, strict=True)]
        pressures[mask] = RegularGridInterpolator(centers, pressure)(np.column_stack(places))
    return pressures * fine.area


def _pressures(cells: Cells, force: Array, mask: Flags) -> Array:
    """Return the pressures of some cells (c,) on the grid (nx, ny), elsewhere those of the nearest of them."""
    from scipy.ndimage import distance_transform_edt

    shape = cells.grid.nx, cells.grid.ny
    pressure, covered = np.zeros(shape), np.zeros(shape, dtype=bool)
    pressure.flat[cells.number[mask]], covered.flat[cells.number[mask]] = (force / cells.area)[mask], True
    nearest = distance_transform_edt(~covered, return_distances=False, return_indices=True)
    filled: Array = pressure[tuple(nearest)]
    return filled


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
    hats: Array  # (p, 9) [m2]: of positive functions of its nodes, which share its area as shape functions do


def _pairs(grid: Grid, xy: Array) -> _Pairs:
    """Return the pairs of elements (m, 9, 2) and cells that share a part, integrated by points in the elements."""
    from scipy.sparse import csr_array

    points, weights = _points(grid, xy)
    N, dN = q9(points)
    values, size = np.column_stack([np.ones(len(N)), N, _hats(points)]), grid.nx * grid.ny
    pairs, sums = list[Integers](), list[Array]()
    for start in range(0, len(xy), _CHUNK):
        part = xy[start : start + _CHUNK]
        x, y = (part[..., axis] @ N.T for axis in (0, 1))
        dA = (determinants(dN, part) * weights).ravel()
        pair = (np.arange(start, start + len(part))[:, None] * size + grid.number(x, y)).ravel()
        order = np.argsort(pair, kind="stable")
        pair = pair[order]
        first = np.append(np.flatnonzero(np.diff(pair, prepend=-1)), len(pair))
        of_pairs = csr_array((dA[order], order % len(points), first), shape=(len(first) - 1, len(points)))
        pairs.append(pair[first[:-1]])
        sums.append(of_pairs @ values)
    (element, cell), table = np.divmod(np.concatenate(pairs), size), np.concatenate(sums)
    shapes = table[:, 1:10]
    return _Pairs(element, cell, table[:, 0], np.einsum("pa,pax->px", shapes, xy[element]), shapes, table[:, 10:])


def _hats(points: Array) -> Array:
    """Return functions (p, 9) of an element's nodes, positive, with the sum one, linear each way.

    Each way they reach a third of the element from its ends and leave two thirds to its middle: so they have the
    integrals of the shape functions, by which nodes share the element's area.
    """
    ends = np.maximum(0.0, 1 - 1.5 * (1 - points[:, None] * np.array([[-1.0], [1.0]])))
    along = np.stack([ends[:, 0], 1 - ends.sum(axis=1), ends[:, 1]])  # (3, p, 2), of the nodes at -1, 0, 1
    corners = np.array([[0, 0], [2, 0], [2, 2], [0, 2], [1, 0], [2, 1], [1, 2], [0, 1], [1, 1]])
    hats: Array = (along[corners[:, 0], :, 0] * along[corners[:, 1], :, 1]).T
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
