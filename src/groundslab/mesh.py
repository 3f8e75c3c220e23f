"""Nine-node meshes: rectilinear grids, their order of elimination, values between nodes, mirroring."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.shape import COLUMN, ROW, Array, Integers, lagrange


@dataclass(frozen=True, slots=True)
class Mesh:
    """A rectilinear mesh of nine-node quadrilaterals between the lines x (nx+1,) and y (ny+1,) [m]."""

    x: Array
    y: Array
    nodes: Array  # (n, 2) [m]
    elements: Integers  # (nx * ny, 9)

    @property
    def xy(self) -> Array:
        """Return the nodes of each element, (m, 9, 2)."""
        xy: Array = self.nodes[self.elements]
        return xy


def grid(x: Array, y: Array) -> Mesh:
    """Return the mesh between ascending lines x and y [m]; midside nodes halve the sides."""
    X, Y = with_midpoints(x), with_midpoints(y)
    nodes = np.column_stack([np.tile(X, len(Y)), np.repeat(Y, len(X))])
    column, row = np.meshgrid(np.arange(len(x) - 1), np.arange(len(y) - 1))
    elements = (2 * column.reshape(-1, 1) + COLUMN) + (2 * row.reshape(-1, 1) + ROW) * len(X)
    return Mesh(x, y, nodes, elements)


def with_midpoints(x: Array) -> Array:
    """Return x with the middle of each interval between."""
    out = np.empty(2 * len(x) - 1)
    out[::2], out[1::2] = x, (x[:-1] + x[1:]) / 2
    return out


def lines_beyond(start: float, width: float, first: float, scale: float) -> Array:
    """Return lines from start outwards over a signed width [m], the start left out.

    At a distance d the intervals are about first * (1 + d / scale) long, so that halving `first` halves them all.
    """
    reach = np.log1p(abs(width) / scale)
    n = max(2, int(np.ceil(reach * scale / first)))
    distance = scale * np.expm1(reach * np.arange(1, n + 1) / n)
    distance[-1] = abs(width)
    lines: Array = start + np.sign(width) * distance
    return lines


def locate(x: Array, values: Array) -> tuple[Integers, Array]:
    """Return the interval of the ascending lines x that holds each value, and the local coordinate in it (-1 .. 1).

    Values outside lie in the first or last interval, with a local coordinate beyond -1 or 1.
    """
    i = np.clip(np.searchsorted(x, values, side="right") - 1, 0, len(x) - 2)
    return i, 2 * (values - x[i]) / (x[i + 1] - x[i]) - 1


def functions_at(mesh: Mesh, points: Array) -> tuple[Integers, Array]:
    """Return the element of each point (p,) and the shape functions there (p, 9)."""
    i, xi = locate(mesh.x, points[:, 0])
    j, eta = locate(mesh.y, points[:, 1])
    N = lagrange(xi)[0][:, COLUMN] * lagrange(eta)[0][:, ROW]
    return i + j * (len(mesh.x) - 1), N


def interpolate_linear(mesh: Mesh, values: Array, target: Mesh) -> Array:
    """Return nodal values (n,) of one mesh at the nodes of another, bilinear between neighbouring nodes."""
    X, Y = with_midpoints(mesh.x), with_midpoints(mesh.y)
    table = values.reshape(len(Y), len(X))
    along_x = _linear(X, with_midpoints(target.x))
    along_y = _linear(Y, with_midpoints(target.y))
    (i, s), (j, t) = along_x, along_y
    rows = table[:, i] * (1 - s) + table[:, i + 1] * s
    result: Array = rows[j] * (1 - t[:, None]) + rows[j + 1] * t[:, None]
    return result.ravel()


def _linear(x: Array, values: Array) -> tuple[Integers, Array]:
    i, xi = locate(x, np.clip(values, x[0], x[-1]))
    return i, (xi + 1) / 2


def elimination_order(mesh: Mesh) -> Integers:
    """Return the rank of each node in a nested dissection of the mesh by its coordinates, (n,).

    Elements are halved again and again at the median of their centres' longer extent. A node belongs to the smallest
    part that holds all its elements; parts are eliminated before the part that they are halves of.
    """
    centre = mesh.nodes[mesh.elements[:, 8]]
    m = len(centre)
    depth = max(0, int(np.ceil(np.log2(m / 2))))
    code = np.zeros(m, dtype=np.int64)
    order = np.arange(m)
    bounds = np.array([0, m])
    for _ in range(depth):
        starts = bounds[:-1]
        part = np.repeat(np.arange(len(starts)), np.diff(bounds))
        low = np.minimum.reduceat(centre[order], starts, axis=0)
        high = np.maximum.reduceat(centre[order], starts, axis=0)
        axis = np.argmax(high - low, axis=1)
        order = order[np.lexsort((centre[order, axis[part]], part))]
        middle = (bounds[:-1] + bounds[1:]) // 2
        code *= 2
        code[order] += np.arange(m) >= middle[part]
        bounds = np.sort(np.concatenate([bounds, middle[middle > starts]]))
        # a part of one element is not halved: its code goes on with a 1, alone, and keeps its place
    flat = mesh.elements.ravel()
    codes = np.repeat(code, 9)
    lowest = np.full(len(mesh.nodes), np.iinfo(np.int64).max)
    highest = np.full(len(mesh.nodes), -1)
    np.minimum.at(lowest, flat, codes)
    np.maximum.at(highest, flat, codes)
    differing = lowest ^ highest
    height = np.where(differing > 0, np.floor(np.log2(np.maximum(differing, 1))).astype(np.int64) + 1, 0)
    last_of_part = highest | ((np.int64(1) << height) - 1)
    rank = np.empty(len(mesh.nodes), dtype=np.int64)
    # within a separator, along its longer extent, so that neighbours stay neighbours
    rank[np.lexsort((mesh.nodes[:, 0], mesh.nodes[:, 1], height, last_of_part))] = np.arange(len(mesh.nodes))
    return rank


def mirror(mesh: Mesh, axis: int) -> tuple[Mesh, Integers, Array]:
    """Return the mesh doubled about the line where its lowest coordinate along `axis` lies at 0.

    Also the source node of each node (n2,) and whether it lies on the mirrored side: -1.0 there, else 1.0 (n2,).
    """
    lines = [mesh.x, mesh.y]
    lines[axis] = np.concatenate([-lines[axis][:0:-1], lines[axis]])
    doubled = grid(lines[0], lines[1])
    counts = [2 * len(mesh.x) - 1, 2 * len(mesh.y) - 1]
    place = [np.arange(c) for c in counts]
    side = [np.ones(c) for c in counts]
    k = np.arange(2 * counts[axis] - 1) - (counts[axis] - 1)
    place[axis], side[axis] = np.abs(k), np.where(k < 0, -1.0, 1.0)
    source = (place[0][None, :] + place[1][:, None] * counts[0]).ravel()
    sign = (np.ones((len(place[1]), len(place[0]))) * (side[0][None, :] if axis == 0 else side[1][:, None])).ravel()
    return doubled, source, sign
