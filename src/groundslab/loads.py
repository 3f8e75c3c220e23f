"""Loads on part of a plate as forces on the nodes of its elements: integrals of the shape functions over the part.

Each function returns integrals (m, 9) over the m elements given; times a pressure, line load or force they are nodal
loads. Parts need not follow the mesh: elements that a part cuts are cut as well, and the pieces integrated.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from groundslab.mesh import Mesh, locate, place_in
from groundslab.shape import Array, Integers, gauss, gauss_line, jacobian, q9

if TYPE_CHECKING:
    from shapely import Polygon

#: Points each way of the rule on pieces; products of two biquadratic functions and a bilinear map are met exactly.
PIECE_POINTS = 5
#: Curved sides are followed by this many straight ones where an element is cut.
CHORDS = 16
#: A piece this small, relative to the largest one, is nothing but rounding.
SLIVER = 1e-15

#: A pressure [Pa] as a function of places (..., 2).
Pressure = Callable[[Array], Array]


def one(places: Array) -> Array:
    """Return a pressure of 1 at places (..., 2)."""
    return np.ones(places.shape[:-1])


def inertia(part: Polygon) -> tuple[Array, Array]:
    """Return the centre (2,) [m] of a polygon and its second moments of area about it (2, 2) [m4]."""
    from shapely import get_coordinates

    centre = get_coordinates(part.centroid)[0]
    x = get_coordinates(part.exterior) - centre
    a, b = x[:-1], x[1:]
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    # each edge makes a triangle with the centre, whose moments its corners give
    total = np.einsum("e,ei,ej->ij", cross, a + b, a + b)
    total += np.einsum("e,ei,ej->ij", cross, a, a) + np.einsum("e,ei,ej->ij", cross, b, b)
    return centre, total / 24 * np.sign(cross.sum())


def over_elements(mesh: Mesh, elements: Integers, pressure: Pressure = one) -> Array:
    """Return int q N dA (m, 9) over whole elements: [m2], or [N] for a pressure q [Pa] of places (..., 2)."""
    points, weights = gauss(3)
    N, dN = q9(points)
    xy = mesh.nodes[mesh.elements[elements]]
    q = pressure(np.einsum("pa,eax->epx", N, xy))
    shares: Array = (q * jacobian(dN, xy)[2] * weights) @ N
    return shares


def near(mesh: Mesh, part: Polygon) -> Integers:
    """Return the elements that may meet a polygon, by the boxes around both.

    A curved side leaves the box of its three nodes by 1/8 of its size at most.
    """
    x0, y0, x1, y1 = part.bounds
    low, high = mesh.xy.min(axis=1), mesh.xy.max(axis=1)
    reach = (high - low) / 8
    return np.flatnonzero(((low - reach <= (x1, y1)) & (high + reach >= (x0, y0))).all(axis=1))


def over_polygon(mesh: Mesh, elements: Integers, part: Polygon, pressure: Pressure = one) -> Array:
    """Return int q N dA (m, 9) over the part of each element that lies in a polygon: [m2], or [N] for a q [Pa]."""
    from shapely import contains, intersection, intersects, polygons, prepare

    shares = np.zeros((len(elements), 9))
    outlines = polygons(_outlines(mesh.nodes[mesh.elements[elements]]))
    prepare(part)
    touched = intersects(outlines, part)
    inside = touched & contains(part, outlines)
    shares[inside] = over_elements(mesh, elements[inside], pressure)
    cut = np.flatnonzero(touched & ~inside)
    pieces = intersection(outlines[cut], part)
    triangles, owner = _triangles(pieces)
    if len(triangles):
        points, weights = _triangle_rule(PIECE_POINTS)
        a, b, c = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
        x = a[:, None] + points[:, :1] * b[:, None] + points[:, 1:] * c[:, None]
        dA = np.abs(b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0])[:, None] * weights * pressure(x)
        element = np.repeat(elements[cut[owner]], len(weights))
        N, _ = q9(place_in(mesh.nodes[mesh.elements[element]], x.reshape(-1, 2)))
        np.add.at(shares, cut[owner], np.einsum("tp,tpa->ta", dA, N.reshape(*dA.shape, 9)))
    return shares


def along_line(mesh: Mesh, elements: Integers, ends: Array, q: tuple[float, float] = (1.0, 1.0)) -> Array:
    """Return int q N ds (m, 9) along the straight line between two points (2, 2) on the plate: [m], or [N] for [N/m].

    q changes linearly from the first to the second point. The line is cut where it enters another element; a line along
    common sides goes to one element each.
    common sides goes to one element each.
    """
    from shapely import LineString, get_coordinates, intersection, polygons

    along = ends[1] - ends[0]
    length = np.linalg.norm(along)
    pieces = intersection(polygons(_outlines(mesh.xy[elements])), LineString(ends))
    cuts = (get_coordinates(pieces) - ends[0]) @ along / length**2
    at = np.unique(np.round(np.clip(np.concatenate([[0.0, 1.0], cuts]), 0, 1), 12))
    x, weights = gauss_line(4)
    low, high = at[:-1, None], at[1:, None]
    s = ((low + high) / 2 + (high - low) / 2 * x).ravel()
    ds = ((high - low) / 2 * weights * length).ravel()
    return _at_points(mesh, elements, ends[0] + s[:, None] * along, ds * (q[0] + (q[1] - q[0]) * s))


def at_point(mesh: Mesh, elements: Integers, point: Array) -> Array:
    """Return N (m, 9) at a point (2,) of the plate, in the one element that holds it."""
    return _at_points(mesh, elements, point[None], np.ones(1))


def _at_points(mesh: Mesh, elements: Integers, points: Array, weights: Array) -> Array:
    """Return the sum of weighted N (m, 9) at points (p, 2), each in one element that holds it."""
    owner, local = locate(Mesh(mesh.nodes, mesh.elements[elements]), points)
    if (owner < 0).any():
        raise ValueError(f"the point {points[np.argmin(owner)]} does not lie on the plate")
    shares = np.zeros((len(elements), 9))
    np.add.at(shares, owner, weights[:, None] * q9(local)[0])
    return shares


def _outlines(xy: Array) -> Array:
    """Return the elements' outlines (m, 4 c, 2): their sides, curved ones followed by chords."""
    t = np.linspace(-1, 1, CHORDS, endpoint=False) if _curved(xy) else np.array([-1.0])
    one = np.ones_like(t)
    around = np.concatenate([np.column_stack(side) for side in ((t, -one), (one, t), (-t, one), (-one, -t))])
    outlines: Array = np.einsum("pa,eax->epx", q9(around)[0], xy)
    return outlines


def _curved(xy: Array) -> bool:
    """Return whether any side of the elements is curved."""
    middle = (xy[:, [0, 1, 2, 3]] + xy[:, [1, 2, 3, 0]]) / 2
    size = np.ptp(xy, axis=1).max(initial=0)
    return bool(np.abs(xy[:, 4:8] - middle).max(initial=0) > 1e-9 * size)


def _triangles(pieces: Array) -> tuple[Array, Integers]:
    """Return triangles (t, 3, 2) that fill polygons, and the polygon that each belongs to (t,)."""
    from shapely import area, constrained_delaunay_triangles, get_coordinates, get_parts

    parts, piece = get_parts(pieces, return_index=True)
    solid = area(parts) > SLIVER * area(parts).max(initial=0)  # not the points and lines where a part only touches
    triangles, owner = get_parts(constrained_delaunay_triangles(parts[solid]), return_index=True)
    return get_coordinates(triangles).reshape(-1, 4, 2)[:, :3], piece[solid][owner]


def _triangle_rule(n: int) -> tuple[Array, Array]:
    """Return points (n*n, 2) and weights of a rule on the triangle (0,0), (1,0), (0,1) with twice its area as sum one.

    The square's Gauss rule, one side drawn together into a corner.
    """
    points, weights = gauss(n)
    u, v = (points.T + 1) / 2
    return np.column_stack([u * (1 - v), v]), weights / 4 * (1 - v)
