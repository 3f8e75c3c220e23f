"""Netgen, where Gmsh is not to be had: cells of twice the wanted size from its advancing front.

Netgen is given nothing but straight sides that share only their ends: the plan is cut into pieces here, and each piece
into chords of the wanted length. So each node on an arc is on it to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import FLAT, Place, Plan, Segment
from groundslab.meshing.arrangement import Piece, pieces
from groundslab.meshing.cells import Cells, FixedSides, find_sides, project_onto, sides_of, sort_by_corners
from groundslab.meshing.sizing import Sources, cell_sizes, quarter

#: Extent of plans in Netgen's coordinates: it merges places less than 1e-6 of the extent apart.
SCALED_EXTENT = 100.0
#: Settings of Netgen, tried in turn until a mesh is good: quadrilaterals or not, and its grading of sizes (which are
#: given everywhere). Triangles alone are never bad, but become many elements of middling shape.
SETTINGS = ((True, 1.0), (True, 0.3), (False, 0.5))
#: Wanted sizes along an edge are looked up at this many places at least and at most.
SAMPLES, MOST_SAMPLES = 401, 40001
#: An arc is cut into chords that turn by no more than this [rad].
CHORD_TURN = math.pi / 2
#: How often chords that cross others are halved.
HALVINGS = 8
#: A point on no edge is held by two short sides through it: each of this part of the way to what is nearest.
STUB = 0.4


class Chords(NamedTuple):
    """Straight sides that share only their ends, the piece that each stands for (-1: none), and what must be nodes."""

    nodes: Array  # (n, 2)
    ends: Integers  # (e, 2)
    piece: Integers  # (e,)
    points: Integers  # (p,)


def load() -> Any:
    """Return Netgen's modules for plane geometry and for meshing, or raise what keeps them from being loaded."""
    import netgen.geom2d
    import netgen.meshing

    return netgen.geom2d, netgen.meshing


def cells_of(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Netgen's meshes of twice the wanted sizes: mostly quadrilaterals with some triangles, at last triangles."""
    wanted = cell_sizes(plan, size, smaller, scale)
    parts, points = pieces(plan)
    chords = _chords(parts, points, wanted)
    refused = []
    for quadrilaterals, grading in SETTINGS:
        try:
            cells = _cells(plan, parts, chords, *_generate(plan, parts, chords, wanted, quadrilaterals, grading))
        except InputError as error:
            refused.append(error)
        else:
            yield cells
    if len(refused) == len(SETTINGS):
        raise refused[-1]


def _cells(
    plan: Plan, parts: list[Piece], chords: Chords, nodes: Array, cells: tuple[Integers, Integers], sides: Integers
) -> Cells:
    """Return what Netgen made, with all nodes on edges moved exactly there."""
    from scipy.spatial import KDTree

    number = KDTree(nodes).query(chords.nodes)[1].astype(np.int64)
    if not np.linalg.norm(nodes[number] - chords.nodes, axis=1).max() < FLAT * plan.extent:
        raise _rejection("a corner is not met by the mesh")
    nodes[number] = chords.nodes
    drawn = _fixed_sides(parts, chords, nodes, number, sides)
    keys = np.unique(np.concatenate([sides_of(kind, len(nodes)).ravel() for kind in cells]))
    if not find_sides(keys, drawn.ends, len(nodes))[1].all():
        raise _rejection("an edge is not followed by the mesh")
    return Cells(nodes, *cells, drawn)


def _rejection(said: object) -> InputError:
    return InputError([Issue("plan", f"a plan that Netgen refuses ({said})", "one that can be meshed")])


def _chords(parts: list[Piece], points: list[Place], wanted: Callable[[Array], Array]) -> Chords:
    """Return chords of the wanted lengths on all pieces, and short sides through the points."""
    counts = [_count(part.edge, wanted) for part in parts]
    for _ in range(HALVINGS):
        chords = _ends_of(parts, counts, wanted)
        crossing = np.unique(chords.piece[_crossing(chords)])
        if not len(crossing):
            break
        for k in crossing:
            counts[k] *= 2
    else:
        raise _rejection("edges too close to each other")
    return _with_points(chords, points, wanted)


def _count(edge: Segment, wanted: Callable[[Array], Array]) -> int:
    """Return into how many chords an edge is cut."""
    least = 1 if edge.straight else math.ceil(abs(edge.sweep) / CHORD_TURN - 1e-9)
    return max(least, round(float(_sums(edge, wanted)[1][-1])))


def _sums(edge: Segment, wanted: Callable[[Array], Array]) -> tuple[Array, Array]:
    """Return parts of an edge, and how many chords of the wanted lengths come before each."""
    least = wanted(edge.at(np.linspace(0, 1, SAMPLES))).min()
    part = np.linspace(0, 1, min(MOST_SAMPLES, SAMPLES + 4 * math.ceil(edge.length / least)))
    density = edge.length / wanted(edge.at(part))
    return part, np.concatenate([[0.0], np.cumsum(np.diff(part) * (density[1:] + density[:-1]) / 2)])


def _ends_of(parts: list[Piece], counts: list[int], wanted: Callable[[Array], Array]) -> Chords:
    """Return the chords of pieces, each cut into a number of them."""
    number: dict[Place, int] = {}
    places: list[Array] = []
    ends, owner = [], []
    for k, (part, n) in enumerate(zip(parts, counts, strict=True)):
        edge = part.edge
        for place in (edge.start, edge.end):
            if place not in number:
                number[place] = len(places)
                places.append(np.array(place))
        along, sums = _sums(edge, wanted)
        inner = edge.at(np.interp(sums[-1] * np.arange(1, n) / n, sums, along))
        row = [number[edge.start], *range(len(places), len(places) + n - 1), number[edge.end]]
        places += list(inner)
        ends += list(pairwise(row))
        owner += [k] * n
    return Chords(np.array(places), np.array(ends), np.array(owner), np.array(sorted(number.values())))


def _crossing(chords: Chords) -> Integers:
    """Return the chords that meet others elsewhere than at ends that both have."""
    import shapely

    lines = shapely.linestrings(chords.nodes[chords.ends])
    first, second = shapely.STRtree(lines).query(lines, predicate="intersects")
    first, second = first[first < second], second[first < second]
    shared = (chords.ends[first][:, :, None] == chords.ends[second][:, None, :]).sum(axis=(1, 2))
    apart = shapely.length(shapely.intersection(lines[first], lines[second])) > 0
    wrong = (shared == 0) | (shared == 2) | ((shared == 1) & apart)
    numbers: Integers = np.unique(np.concatenate([first[wrong], second[wrong]]))
    return numbers


def _with_points(chords: Chords, points: list[Place], wanted: Callable[[Array], Array]) -> Chords:
    """Return chords with short sides added through points that lie on none: Netgen keeps no node without a side."""
    import shapely

    nodes, ends, fixed_points = [*chords.nodes], [*chords.ends], [*chords.points]
    lines = shapely.multilinestrings(shapely.linestrings(chords.nodes[chords.ends]))
    for place in np.array(points).reshape(-1, 2):
        others = [shapely.Point(other) for other in points if math.dist(other, place) > 0]
        free = min(shapely.Point(place).distance(other) for other in (lines, *others))
        reach = min(float(wanted(place[None])[0]), STUB * free)
        n = len(nodes)
        nodes += list(place + reach * np.array([[0, 0], [-1, 0], [1, 0]]))
        ends += [np.array([n, n + 1]), np.array([n, n + 2])]
        fixed_points.append(n)
    owner = np.concatenate([chords.piece, np.full(len(ends) - len(chords.ends), -1)])
    return Chords(np.array(nodes), np.array(ends), owner, np.array(fixed_points))


def _generate(
    plan: Plan,
    parts: list[Piece],
    chords: Chords,
    wanted: Callable[[Array], Array],
    quadrilaterals: bool,
    grading: float,
) -> tuple[Array, tuple[Integers, Integers], Integers]:
    """Return nodes (n, 2), triangles and quadrilaterals, and sides (s, 2) on chords, as Netgen makes them.

    Netgen works in a plane of its own: centered and scaled.
    """
    geom2d, meshing = load()
    meshing.SetMessageImportance(0)
    x0, y0, x1, y1 = plan.bounds
    middle, scale = np.array([(x0 + x1) / 2, (y0 + y1) / 2]), SCALED_EXTENT / plan.extent
    geometry = geom2d.SplineGeometry()
    for x, y in ((chords.nodes - middle) * scale).tolist():
        geometry.AppendPoint(x, y)
    for (a, b), k in zip(chords.ends.tolist(), chords.piece.tolist(), strict=True):
        left, right = (parts[k].left, parts[k].right) if k >= 0 else (True, True)
        geometry.Append(["line", a, b], leftdomain=int(left), rightdomain=int(right))
    corners, sides = quarter(plan.bounds, wanted)
    places = corners + sides[:, None] / 2
    sizes = wanted(places)
    asked = meshing.MeshingParameters(maxh=float(sizes.max() * scale), quad_dominated=quadrilaterals, grading=grading)
    for (x, y), h in zip(((places - middle) * scale).tolist(), (sizes * scale).tolist(), strict=True):
        asked.RestrictH(x, y, 0.0, h)
    try:
        mesh = geometry.GenerateMesh(mp=asked)
    except Exception as refused:
        # Netgen raises no other exception; its text is for people
        raise _rejection(refused) from None
    nodes = np.array([point.p[:2] for point in mesh.Points()]) / scale + middle
    cells = [[vertex.nr - 1 for vertex in cell.vertices] for cell in mesh.Elements2D()]
    edges = np.array([[vertex.nr - 1 for vertex in edge.vertices] for edge in mesh.Elements1D()], dtype=np.int64)
    return nodes, sort_by_corners(cells), edges


def _fixed_sides(parts: list[Piece], chords: Chords, nodes: Array, number: Integers, sides: Integers) -> FixedSides:
    """Return the sides on pieces, after putting nodes that Netgen added on arcs exactly there."""
    import shapely

    middles = shapely.points(nodes[sides].mean(axis=1))
    nearest = shapely.STRtree(shapely.linestrings(chords.nodes[chords.ends])).nearest(middles)
    owner = chords.piece[nearest]
    on_pieces, owner = sides[owner >= 0], owner[owner >= 0]
    centre = np.array([part.edge.centre for part in parts])[owner]
    radius = np.array([part.edge.radius for part in parts])[owner]
    added = (radius > 0)[:, None] & ~np.isin(on_pieces, number)
    for k in (0, 1):
        at = on_pieces[added[:, k], k]
        nodes[at] = project_onto(nodes[at], centre[added[:, k]], radius[added[:, k]])
    return FixedSides(on_pieces, centre, radius, number[chords.points])
