"""Nine-node meshes: grids, where a point lies, sides, the order of elimination, mirroring."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.errors import InputError, Issue
from groundslab.fem.shape_functions import COLUMN, ROW, parallelograms, q9_values, unique_integers
from groundslab.geometry.plan import SAME_PLACE, Segment, format_place

if TYPE_CHECKING:
    from shapely import STRtree

#: The nodes of an element's four sides: end, end, middle.
SIDES = np.array([[0, 1, 4], [1, 2, 5], [2, 3, 6], [3, 0, 7]])
#: The nodes of an element in the order that its mirror image needs to run counter-clockwise again.
MIRRORED = np.array([1, 0, 3, 2, 4, 7, 6, 5, 8])
#: The nodes of an element on its 3 x 3 grid, by row and column.
GRID = np.array([[0, 4, 1], [7, 8, 5], [3, 6, 2]])
#: Coefficients of 1, x, x^2 in the quadratic Lagrange polynomials on (-1, 0, 1), by row.
MONOMIALS = np.array([[0.0, 1.0, 0.0], [-0.5, 0.0, 0.5], [0.5, -1.0, 0.5]])
#: A point this far outside an element, relative to its size, still counts as in it.
NEAR = 1e-9
#: An error names at most so many points outside, and counts the others.
MOST_NAMED = 100

#: Elements may grow by this share of the distance from where smaller ones are required.
GRADING = 0.35

Place = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Mesh:
    """Nine-node quadrilaterals: nodes (n, 2) [m] and elements (m, 9), counter-clockwise."""

    nodes: Array
    elements: Integers

    @property
    def xy(self) -> Array:
        """Return the nodes of each element, (m, 9, 2)."""
        return self.nodes[self.elements]


def grid(x: Array, y: Array) -> Mesh:
    """Return the mesh between ascending lines x and y [m]; midside nodes halve the sides."""
    X, Y = with_midpoints(x), with_midpoints(y)
    nodes = np.column_stack([np.tile(X, len(Y)), np.repeat(Y, len(X))])
    column, row = np.meshgrid(np.arange(len(x) - 1), np.arange(len(y) - 1))
    elements = (2 * column.reshape(-1, 1) + COLUMN) + (2 * row.reshape(-1, 1) + ROW) * len(X)
    return Mesh(nodes, elements)


def with_midpoints(x: Array) -> Array:
    """Return x with the middle of each interval between."""
    out = np.empty(2 * len(x) - 1)
    out[::2], out[1::2] = x, (x[:-1] + x[1:]) / 2
    return out


def graded_size(edges: Array, size: float) -> Callable[[Array], Array]:
    """Return a function from coordinates (p,) to the largest size (p,) [m] of elements that grow from the edges (e,).

    At the edges they have the given size [m]; without edges there is no limit.
    """
    return lambda x: size + GRADING * np.abs(x[:, None] - edges).min(axis=1, initial=np.inf)


def divide_graded(size: Callable[[Array], Array], low: float, high: float) -> Array:
    """Return lines that divide low .. high [m] into intervals of at most size(x) [m], low left out."""
    x = _samples(low, high)
    wanted = size(x)
    if np.ptp(wanted) <= 1e-9 * wanted[0]:
        return np.linspace(low, high, math.ceil((high - low) / wanted[0] - 1e-6) + 1)[1:]
    sums = _sum(1 / wanted, x)
    n = max(1, math.ceil(sums[-1] - 1e-6))
    lines: Array = np.interp(sums[-1] * np.arange(1, n + 1) / n, sums, x)
    lines[-1] = high
    return lines


def count_intervals(size: Callable[[Array], Array], low: float, high: float) -> float:
    """Return how many intervals of the length size(x) [m] fit between low and high [m], as a fraction."""
    x = _samples(low, high)
    return float(_sum(1 / size(x), x)[-1])


def _samples(low: float, high: float) -> Array:
    """Return places between two lines, closer near both."""
    return low + (high - low) * (1 - np.cos(np.linspace(0, math.pi, 2001))) / 2


def _sum(density: Array, x: Array) -> Array:
    """Return the integral of a density up to each of the places x."""
    return np.concatenate([[0.0], np.cumsum(np.diff(x) * (density[1:] + density[:-1]) / 2)])


def extrude(mesh: Mesh, axis: int, outward: int, distances: Array) -> Mesh:
    """Return the mesh with rows of elements added along its outermost straight edge across an axis.

    The rows end at the distances [m], ascending, from that edge to the side `outward` (1 or -1) of the axis. The mesh's
    own nodes and elements come first and keep their numbers.
    """
    sides, n = sides_on_boundary(mesh.elements), len(mesh.nodes)
    coordinate = outward * mesh.nodes[:, axis]
    sides = sides[(coordinate[sides] == coordinate.max()).all(axis=1)]
    along, row = unique_integers(sides)
    offsets = with_midpoints(np.concatenate([[0.0], distances]))[1:]
    shift = np.zeros((len(offsets), 1, 2))
    shift[:, 0, axis] = outward * offsets
    # number of each node of the edge in row k of nodes, the edge itself being row 0
    number = np.vstack([along, n + np.arange(len(offsets) * len(along)).reshape(len(offsets), -1)])
    end, start, middle = row.T  # the old elements lie to the left from end to start, the new ones to the right
    elements = [
        np.column_stack([
            low[start], low[end], high[end], high[start], low[middle], between[end], high[middle], between[start],
            between[middle],
        ])
        for low, between, high in zip(number[:-1:2], number[1::2], number[2::2], strict=True)
    ]  # fmt: skip
    nodes = (mesh.nodes[along] + shift).reshape(-1, 2)
    return Mesh(np.vstack([mesh.nodes, nodes]), np.vstack([mesh.elements, *elements]))


def bounding_boxes(mesh: Mesh, reach: float = NEAR) -> STRtree:
    """Return the elements' bounding boxes, larger by `reach` times their size, as a tree to search for points in.

    A curved side may bulge out of the box around its nodes: the box is that of the element's Bezier points.
    """
    import shapely

    xy = mesh.xy
    low, high = xy.min(axis=1), xy.max(axis=1)
    other = np.flatnonzero(~parallelograms(xy))
    # along each line of three nodes a, b, c the parabola has the Bezier points a, 2 b - (a + c) / 2, c
    net = xy[other][:, GRID]
    for axis in (1, 2):
        a, b, c = np.moveaxis(net, axis, 0)
        net = np.stack([a, 2 * b - (a + c) / 2, c], axis=axis)
    low[other], high[other] = net.min(axis=(1, 2)), net.max(axis=(1, 2))
    margin = reach * (high - low).max(axis=1, keepdims=True)
    low, high = low - margin, high + margin
    return shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))


@made_once_by(attrgetter("elements", "nodes"))
def boxes_of(mesh: Mesh) -> STRtree:
    """Return the mesh's `bounding_boxes`, which are made once of the same nodes and elements."""
    return bounding_boxes(mesh)


def locate(mesh: Mesh, points: Array, reach: float = NEAR, boxes: STRtree | None = None) -> tuple[Integers, Array]:
    """Return the element that holds each point (p, 2) and the point's place in it, (p, 2) on the reference square.

    A point on a common side belongs to one of the elements. A point that lies outside the mesh by more than `reach`
    times an element's size gets the element -1. For repeated calls pass the mesh's `bounding_boxes` of that reach, as
    `boxes_of` keeps them.
    """
    import shapely

    points = np.asarray(points, dtype=float)
    boxes = bounding_boxes(mesh, reach) if boxes is None else boxes
    which, candidate = boxes.query(shapely.points(points))
    local = local_coordinates(mesh, candidate, points[which])
    beside = np.abs(local).max(axis=1, initial=0)
    inside = np.flatnonzero(beside <= 1 + 10 * reach)
    order = inside[np.lexsort((candidate[inside], beside[inside], which[inside]))]
    best = order[np.unique(which[order], return_index=True)[1]]
    element, place = np.full(len(points), -1), np.zeros((len(points), 2))
    element[which[best]], place[which[best]] = candidate[best], local[best]
    return element, place


#: Points that are located at a time, few enough to stay near the processor.
_CHUNK = 2**12


def local_coordinates(mesh: Mesh, element: Integers, points: Array) -> Array:
    """Return where points (c, 2) lie in elements (c,) of a mesh, on the reference square, by Newton's method.

    Points far outside their element are only followed to its neighborhood.
    """
    used, which = unique_integers(element)
    xy = mesh.nodes[mesh.elements[used]]
    # from the element's middle x = sum of C[i, j] xi^i eta^j; with straight sides that are halved, powers end at 1,
    # and in parallelograms there is none of xi eta
    C = np.einsum("ia,jb,mbax->xijm", MONOMIALS, MONOMIALS, (xy - xy[:, 8:])[:, GRID], optimize=True)
    rounding = 1e-14 * abs(xy).max(axis=(1, 2))
    curved = np.maximum(abs(C[:, 2]), abs(C[:, :, 2])).max(axis=(0, 1)) > rounding
    skew = ~curved & (abs(C[:, 1, 1]).max(axis=0) > rounding)
    local = np.zeros((2, len(points)))
    flat = np.flatnonzero(~(curved | skew)[which])
    if len(flat):
        local[:, flat] = _in_parallelograms(C, xy[:, 8], which[flat], points[flat])
    for powers, of_kind in ((2, skew), (3, curved)):
        indices = np.flatnonzero(of_kind[which])
        for start in range(0, len(indices), _CHUNK):
            left = indices[start : start + _CHUNK]
            coefficients, offset = C[:, :powers, :powers, which[left]], (points[left] - xy[which[left], 8]).T
            local[:, left] = _invert(coefficients, offset)
    return local.T


def _in_parallelograms(C: Array, middle: Array, which: Integers, points: Array) -> Array:
    """Return where points (c, 2) are in parallelograms (c,) of those with coefficients C and middles: (2, c)."""
    (x_xi, y_xi), (x_eta, y_eta) = C[:, 1, 0], C[:, 0, 1]
    inverse = np.array([[y_eta, -x_eta], [-y_xi, x_xi]]) / (x_xi * y_eta - x_eta * y_xi)
    dx, dy = (points - middle[which]).T
    (xi_x, xi_y), (eta_x, eta_y) = inverse[:, :, which]
    local: Array = np.clip([xi_x * dx + xi_y * dy, eta_x * dx + eta_y * dy], -1.5, 1.5)
    return local


def _invert(C: Array, offset: Array) -> Array:
    """Return where polynomials with coefficients C (2, n, n, c) are an offset (2, c): (2, c), by Newton's method."""
    local, left = np.zeros(offset.shape), np.arange(offset.shape[1])
    for _ in range(20):
        if not len(left):
            break
        before = local[:, left]
        (x, x_xi, x_eta), (y, y_xi, y_eta) = (_polynomial(coefficients, *before) for coefficients in C)
        dx, dy = offset - (x, y)
        step = np.array([y_eta * dx - x_eta * dy, x_xi * dy - y_xi * dx]) / (x_xi * y_eta - x_eta * y_xi)
        local[:, left] = np.clip(before + step, -1.5, 1.5)
        # Newton's steps shrink by their squares: after one so small nothing but rounding is left
        on = (abs(local[:, left] - before) > 1e-10).any(axis=0)
        if not on.all():
            left, C, offset = left[on], C[..., on], offset[:, on]
    return local


def _polynomial(C: Array, xi: Array, eta: Array) -> tuple[Array, Array, Array]:
    """Return sum of C[i, j] xi^i eta^j and its derivatives by xi and eta at points (c,), C (n, n, c)."""
    value = d_xi = d_eta = np.zeros(len(xi))
    for row in C[::-1]:
        inner = d_inner = np.zeros(len(xi))
        for c in row[::-1]:
            inner, d_inner = inner * eta + c, d_inner * eta + inner
        value, d_xi, d_eta = value * xi + inner, d_xi * xi + value, d_eta * xi + d_inner
    return value, d_xi, d_eta


MeshLocations = tuple[Integers, Array]


def in_space(nodes: Array) -> Array:
    """Return nodes (n, 2) as points (n, 3) at z = 0."""
    return np.column_stack([nodes, np.zeros(len(nodes))])


def locate_within(mesh: Mesh, points: Array, region: str) -> MeshLocations:
    """Return the elements that hold points (..., 2) and where in them; InputError names points outside."""
    where = locate(mesh, points.reshape(-1, 2), boxes=boxes_of(mesh))
    outside = np.argwhere(where[0].reshape(points.shape[:-1]) < 0)
    issues = []
    for index in outside[:MOST_NAMED]:
        x, y = points[tuple(index)]
        issues.append(Issue(f"point{index.tolist() or ''}", f"{format_place((x, y))} m", f"a point on {region}"))
    if len(outside) > MOST_NAMED:
        rest = f"{len(outside) - MOST_NAMED} more points outside"
        issues.append(Issue("points", rest, f"points on {region}"))
    if issues:
        raise InputError(issues)
    return where


def locate_nearest(mesh: Mesh, points: Array, elements: Integers | None = None) -> MeshLocations:
    """Return the element that holds each point (p, 2) or, for points outside, the nearest; and the places in them.

    Of some elements only, if they are given. Where a boundary is curved, a finer mesh has points a little outside a
    coarser one.
    """
    import shapely

    part = mesh if elements is None else Mesh(mesh.nodes, mesh.elements[elements])
    element, place = locate(part, points, boxes=boxes_of(mesh) if elements is None else None)
    outside = element < 0
    if outside.any():
        low, high = part.xy.min(axis=1), part.xy.max(axis=1)
        boxes = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
        element[outside] = boxes.nearest(shapely.points(points[outside]))
        place[outside] = local_coordinates(part, element[outside], points[outside])
    return (element if elements is None else elements[element]), place


def interpolate(mesh: Mesh, values: Array, where: MeshLocations) -> Array:
    """Return nodal values (n,) or (n, k) at places in elements, by the shape functions, (p,) or (p, k)."""
    element, place = where
    result: Array = np.einsum("pa,pa...->p...", q9_values(place), values[mesh.elements[element]])
    return result


def interpolate_bilinear(mesh: Mesh, values: Array, where: MeshLocations) -> Array:
    """Return nodal values (n,) at places in elements, bilinear between neighboring nodes, (p,)."""
    element, place = where
    hat = np.maximum(0.0, 1 - np.abs(np.clip(place, -1, 1)[:, None, :] - np.array([-1.0, 0.0, 1.0])[:, None]))
    result: Array = np.einsum("pa,pa,pa->p", hat[:, COLUMN, 0], hat[:, ROW, 1], values[mesh.elements[element]])
    return result


def sides_on_boundary(elements: Integers) -> Integers:
    """Return the sides (s, 3: end, end, middle) that belong to one element only, and are no half of another one."""
    sides = elements[:, SIDES].reshape(-1, 3)
    alone = sides[np.bincount(sides[:, 2])[sides[:, 2]] == 1]
    # the middle of a side that two halves meet is an end of theirs
    alone = alone[~meeting_halves(elements)[alone].any(axis=1)]
    boundary: Integers = alone[np.argsort(alone[:, 2])]
    return boundary


def meeting_halves(elements: Integers) -> Flags:
    """Return which nodes (n,) are corners of some elements and the middle of another one's side."""
    corner, middle = np.zeros((2, int(elements.max(initial=-1)) + 1), dtype=bool)
    corner[elements[:, :4]] = middle[elements[:, 4:8]] = True
    both: Flags = corner & middle
    return both


def sides_along(mesh: Mesh, elements: Integers, edges: Iterable[Segment]) -> Integers:
    """Return the sides (s, 3: end, end, middle) of some elements (m, 9) that lie on edges, each once."""
    return select_along(mesh, sides_of(mesh, elements), edges)


def sides_of(mesh: Mesh, elements: Integers) -> Integers:
    """Return the sides (s, 3: end, end, middle) of some elements (m, 9), each once."""
    sides = elements[:, SIDES].reshape(-1, 3)
    one_of = np.full(len(mesh.nodes), -1)
    one_of[sides[::-1, 2]] = np.arange(len(sides))[::-1]
    unique: Integers = sides[one_of[one_of >= 0]]
    return unique


def select_along(mesh: Mesh, sides: Integers, edges: Iterable[Segment]) -> Integers:
    """Return those of some sides (s, 3: end, end, middle) that lie on edges."""
    near = 10 * SAME_PLACE * float(np.ptp(mesh.nodes, axis=0).max())
    middle = mesh.nodes[sides[:, 2]]
    on_any = np.zeros(len(sides), dtype=bool)
    for edge in edges:
        x0, x1, y0, y1 = edge.bounds
        low = np.array((x0, y0))
        high = np.array((x1, y1))
        nearby = np.flatnonzero(((middle >= low - near) & (middle <= high + near)).all(axis=1) & ~on_any)
        on_any[nearby] = (edge.distance(mesh.nodes[sides[nearby]].reshape(-1, 2)).reshape(-1, 3) <= near).all(axis=1)
    along: Integers = sides[on_any]
    return along


def separate(mesh: Mesh, part: Integers) -> Mesh:
    """Return a mesh in which parts of it share no nodes.

    part (m,) is the number of each element's part, -1 for what keeps the nodes of the first part that it meets. Each
    further part that meets there has nodes of its own, which come last.
    """
    in_part = part >= 0
    keys, number = unique_integers(mesh.elements[in_part] * (part.max(initial=0) + 1) + part[in_part][:, None])
    node = keys // (part.max(initial=0) + 1)
    again = np.concatenate([[False], node[1:] == node[:-1]])
    renumbered = np.where(again, len(mesh.nodes) + np.cumsum(again) - 1, node)
    elements = mesh.elements.copy()
    elements[in_part] = renumbered[number].reshape(-1, 9)
    return Mesh(np.vstack([mesh.nodes, mesh.nodes[node[again]]]), elements)


def first_at_place(mesh: Mesh) -> Integers:
    """Return the first node at the place of each node (n,), exactly there: itself unless parts were made separate."""
    _, first, same = np.unique(mesh.nodes + 0.0, axis=0, return_index=True, return_inverse=True)
    nodes: Integers = first[same.reshape(-1)]
    return nodes


def renumber_by_rows(mesh: Mesh) -> tuple[Mesh, Integers, Integers]:
    """Return the mesh with nodes and elements numbered by y, then x; old numbers of nodes (n,), elements (m,)."""
    old = np.lexsort((mesh.nodes[:, 0], mesh.nodes[:, 1]))
    new = np.empty_like(old)
    new[old] = np.arange(len(old))
    centre = mesh.nodes[mesh.elements[:, 8]]
    order = np.lexsort((centre[:, 0], centre[:, 1]))
    return Mesh(mesh.nodes[old], new[mesh.elements[order]]), old, order


def mirror(mesh: Mesh, axis: int) -> tuple[Mesh, Integers, Array]:
    """Return the mesh doubled about the line where the coordinate along `axis` is zero.

    Also the source node of each node (n2,) and whether it lies on the mirrored side: -1.0 there, else 1.0 (n2,).
    """
    n = len(mesh.nodes)
    apart = mesh.nodes[:, axis] != 0.0
    images = mesh.nodes[apart]
    images[:, axis] *= -1
    image_of = np.arange(n)
    image_of[apart] = n + np.arange(apart.sum())
    doubled = Mesh(np.vstack([mesh.nodes, images]), np.vstack([mesh.elements, image_of[mesh.elements[:, MIRRORED]]]))
    source = np.concatenate([np.arange(n), np.flatnonzero(apart)])
    return doubled, source, np.repeat([1.0, -1.0], [n, len(images)])
