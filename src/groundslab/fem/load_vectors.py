"""Loads on part of a plate as forces on the nodes of its elements: integrals of the shape functions over the part.

Each function returns integrals (m, 9) over the m elements given; times a pressure, line load or force they are nodal
loads. Parts need not follow the mesh: elements that a part cuts are cut as well, and the pieces integrated.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh, local_coordinates, locate
from groundslab.fem.shape_functions import determinants, gauss, gauss_line, q9, q9_values
from groundslab.geometry.plan import Segment

if TYPE_CHECKING:
    from shapely import Polygon

#: Points each way of the rule on pieces; products of two biquadratic functions and a bilinear map are met exactly.
PIECE_POINTS = 5
#: The same where a shape function is integrated alone.
SHAPE_POINTS = 3
#: Curved sides are followed by this many straight ones where an element is cut.
CHORDS = 16
#: Arcs of line loads are integrated in pieces of this angle [rad] at most, so many of them at least.
ARC_PIECE = 2 * np.pi / 256
ARC_PIECES = 4
#: A line along a curved edge of the plate lies off its elements by at most this, relative to their size.
ALONG_EDGE = 0.02
#: A piece this small, relative to the largest one, is nothing but rounding.
SLIVER = 1e-15

#: A pressure [Pa] as a function of places (..., 2).
Pressure = Callable[[Array], Array]


def one(places: Array) -> Array:
    """Return a pressure of 1 at places (..., 2)."""
    return np.ones(places.shape[:-1])


def integrate_over_elements(mesh: Mesh, elements: Integers, pressure: Pressure = one) -> Array:
    """Return int q N dA (m, 9) over whole elements: [m2], or [N] for a pressure q [Pa] of places (..., 2)."""
    points, weights = gauss(3)
    N, dN = q9(points)
    xy = mesh.nodes[mesh.elements[elements]]
    q = pressure(np.einsum("pa,eax->epx", N, xy))
    return (q * determinants(dN, xy) * weights) @ N


def nodal_area(mesh: Mesh, elements: Integers) -> Array:
    """Return each node's share of the area of some elements, int N dA (n,) [m2]."""
    return scatter(mesh.elements[elements], integrate_over_elements(mesh, elements), len(mesh.nodes))


def find_elements_near(mesh: Mesh, part: Polygon) -> Integers:
    """Return the elements that may meet a polygon, by the boxes around both.

    A curved side leaves the box of its three nodes by 1/8 of its size at most.
    """
    return np.flatnonzero(_meets_box(mesh, part.bounds))


def _meets_box(mesh: Mesh, bounds: tuple[float, float, float, float]) -> Flags:
    """Return which elements of a mesh (m,) may meet a box x0, y0, x1, y1."""
    x0, y0, x1, y1 = bounds
    (low_x, low_y), (high_x, high_y) = _boxes(mesh)
    return np.asarray((low_x <= x1) & (low_y <= y1) & (high_x >= x0) & (high_y >= y0))


@made_once_by(attrgetter("elements", "nodes"))
def _boxes(mesh: Mesh) -> tuple[Array, Array]:
    """Return the lower left and upper right corners (2, m) of boxes around elements, however their sides curve."""
    low, high = mesh.xy.min(axis=1), mesh.xy.max(axis=1)
    reach = (high - low) / 8
    return np.ascontiguousarray((low - reach).T), np.ascontiguousarray((high + reach).T)


def areas_within(mesh: Mesh, elements: Integers, part: Polygon) -> Array:
    """Return the area (m,) [m2] of each element that lies in a polygon."""
    from shapely import area, intersection, polygons

    covered: Array = area(intersection(polygons(_outlines(mesh.nodes[mesh.elements[elements]])), part))
    return covered


def integrate_over_polygon(
    mesh: Mesh, elements: Integers, part: Polygon, pressure: Pressure = one, rule: int = PIECE_POINTS
) -> Array:
    """Return int q N dA (m, 9) over the part of each element that lies in a polygon: [m2], or [N] for a q [Pa].

    Pieces of elements have a rule of so many points each way.
    """
    (shares,) = integrate_over_polygons(mesh, elements, [part], pressure, rule)
    return shares


def integrate_over_polygons(
    mesh: Mesh, elements: Integers, parts: Sequence[Polygon], pressure: Pressure = one, rule: int = PIECE_POINTS
) -> list[Array]:
    """Return the integrals (m, 9) of `integrate_over_polygon` over each of several polygons, which may overlap."""
    from shapely import contains, intersection, intersects, polygons, prepare

    met = np.array([_meets_box(mesh, part.bounds)[elements] for part in parts])
    near = np.flatnonzero(met.any(axis=0))
    outlines = polygons(_outlines(mesh.nodes[mesh.elements[elements[near]]]))
    shares = np.zeros((len(parts), len(near), 9))
    cut, pieces = [], []
    wholly = np.zeros((len(parts), len(near)), dtype=bool)
    for number, part in enumerate(parts):
        prepare(part)
        candidates = np.flatnonzero(met[number, near])
        candidates = candidates[intersects(outlines[candidates], part)]
        inside = contains(part, outlines[candidates])
        wholly[number, candidates[inside]] = True
        cut.append(number * len(near) + candidates[~inside])
        pieces.append(intersection(outlines[candidates[~inside]], part))
    whole = np.flatnonzero(wholly.any(axis=0))
    of_whole = np.zeros((len(near), 9))
    of_whole[whole] = integrate_over_elements(mesh, elements[near[whole]], pressure)
    shares[wholly] = np.broadcast_to(of_whole, shares.shape)[wholly]
    _add_pieces(
        shares.reshape(-1, 9), np.concatenate(cut), np.concatenate(pieces), (mesh, elements[near]), pressure, rule
    )
    totals = np.zeros((len(parts), len(elements), 9))
    totals[:, near] = shares
    return [*totals]


def _add_pieces(
    shares: Array, cut: Integers, pieces: Array, of: tuple[Mesh, Integers], pressure: Pressure, rule: int
) -> None:
    """Add int q N dA over pieces (p,) of elements (e,) of a mesh to rows (p,) of shares (k e, 9)."""
    mesh, elements = of
    triangles, owner = _triangles(pieces)
    if not len(triangles):
        return
    points, weights = _triangle_rule(rule)
    a, b, c = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    x = a[:, None] + points[:, :1] * b[:, None] + points[:, 1:] * c[:, None]
    dA = np.abs(b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0])[:, None] * weights * pressure(x)
    element = np.repeat(elements[cut[owner] % len(elements)], len(weights))
    N = q9_values(local_coordinates(mesh, element, x.reshape(-1, 2)))
    np.add.at(shares, cut[owner], np.einsum("tp,tpa->ta", dA, N.reshape(*dA.shape, 9)))


def integrate_along_line(mesh: Mesh, elements: Integers, edge: Segment, q: tuple[float, float] = (1.0, 1.0)) -> Array:
    """Return int q N ds (m, 9) along a straight line or an arc on the plate: [m], or [N] for a q [N/m].

    q changes linearly from the start to the end. The line is cut where it enters another element; a line along common
    sides goes to one element each. Along a curved edge of the plate it may lie a little outside the elements.
    """
    s, ds = _points_along(mesh, elements, edge)
    return _integrate_at_points(mesh, elements, edge.at(s), ds * _linear(q, s), ALONG_EDGE)


def integrate_couple_along_line(mesh: Mesh, elements: Integers, edge: Segment, m: tuple[float, float]) -> Array:
    """Return int m n_x N ds and int m n_y N ds (2, m, 9) [N m] along a line, n to its left, of a couple m [N m/m].

    Along the line as in `integrate_along_line`.
    """
    s, ds = _points_along(mesh, elements, edge)
    weights = (ds * _linear(m, s))[:, None] * edge.left(s)
    return np.array([_integrate_at_points(mesh, elements, edge.at(s), weight, ALONG_EDGE) for weight in weights.T])


def _linear(ends: tuple[float, float], s: Array) -> Array:
    """Return values that change linearly from the first to the second, after parts s (p,) of the way."""
    return ends[0] + (ends[1] - ends[0]) * s


def _points_along(mesh: Mesh, elements: Integers, edge: Segment) -> tuple[Array, Array]:
    """Return points of integration along an edge as parts of it (p,), and their weights (p,) [m]."""
    n = 1 if edge.straight else max(ARC_PIECES, math.ceil(abs(edge.sweep) / ARC_PIECE))
    at = np.unique(np.concatenate([np.arange(n + 1) / n, _find_crossings(mesh, elements, edge, n)]))
    x, weights = gauss_line(4)
    low = at[:-1, None]
    high = at[1:, None]
    s = ((low + high) / 2 + (high - low) / 2 * x).ravel()
    return s, ((high - low) / 2 * weights * edge.length).ravel()


def _find_crossings(mesh: Mesh, elements: Integers, edge: Segment, chords: int) -> Array:
    """Return the parts (k,) of an edge after which its chords enter another one of the elements (m,)."""
    from shapely import LineString, get_coordinates, intersection, polygons

    flat = LineString(edge.at(np.arange(chords + 1) / chords))
    near = elements[_meets_box(mesh, flat.bounds)[elements]]
    places = get_coordinates(intersection(polygons(_outlines(mesh.nodes[mesh.elements[near]])), flat))
    if edge.straight:
        along = np.array(edge.end) - np.array(edge.start)
        parts = (places - edge.start) @ along / (along @ along)
    else:
        offset = places - np.array(edge.centre)
        turn = (np.arctan2(offset[:, 1], offset[:, 0]) - edge.angle) * math.copysign(1.0, edge.sweep)
        middle = abs(edge.sweep) / 2
        # the turn that is nearest to the middle of the arc, so that rounding at its ends does not lead once around
        parts = (np.mod(turn - middle + math.pi, 2 * math.pi) + middle - math.pi) / abs(edge.sweep)
    rounded: Array = np.round(np.clip(parts, 0, 1), 12)
    return rounded


def integrate_at_point(mesh: Mesh, elements: Integers, point: Array) -> Array:
    """Return N (m, 9) at a point (2,) of the plate, in the one element that holds it."""
    return _integrate_at_points(mesh, elements, point[None], np.ones(1))


def _integrate_at_points(mesh: Mesh, elements: Integers, points: Array, weights: Array, reach: float = 0.0) -> Array:
    """Return the sum of weighted N (m, 9) at points (p, 2), each in one element that holds it.

    Points outside all elements by at most `reach` times an element's size count as in the nearest one.
    """
    part = Mesh(mesh.nodes, mesh.elements[elements])
    owner, local = locate(part, points)
    beside = np.flatnonzero(owner < 0)
    if reach and len(beside):
        owner[beside], local[beside] = locate(part, points[beside], reach)
    if (owner < 0).any():
        raise ValueError(f"the point {points[np.argmin(owner)]} does not lie on the plate")
    shares = np.zeros((len(elements), 9))
    np.add.at(shares, owner, weights[:, None] * q9_values(local))
    return shares


def _outlines(xy: Array) -> Array:
    """Return the elements' outlines (m, 4 c, 2): their sides, curved ones as chords that enclose the same area."""
    n = CHORDS if _is_curved(xy) else 1
    t = np.linspace(-1, 1, n, endpoint=False)
    a, b, middle = xy[:, [0, 1, 2, 3], None], xy[:, [1, 2, 3, 0], None], xy[:, 4:8, None]
    bend = (a + b) / 2 - middle  # c of the side's a + b t + c t^2
    sides = middle + (b - a) / 2 * t[:, None] + bend * (t**2)[:, None]
    if n > 1:
        # between a chord over 2/n of t and the side lies |b x c| (2/n)^3 / 6; n of these are made up for by moving
        # n - 1 corners, each of which takes |b x c| (2/n) times its way against c
        sides[:, :, 1:] -= bend * (4 / n**2) * n / (6 * (n - 1))
    return sides.reshape(len(xy), 4 * n, 2)


def _is_curved(xy: Array) -> bool:
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
