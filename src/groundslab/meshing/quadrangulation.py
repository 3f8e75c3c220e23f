"""From cells to nine-node quadrilaterals: cutting, smoothing, improving bad elements, adding midside nodes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.shape_functions import SERENDIPITY_CENTER
from groundslab.meshing.cells import Cells, FixedSides, angles_of, find_sides, middles_of, sides_of, sort_by_corners
from groundslab.meshing.quality import scaled_jacobians

#: A corner with a larger angle than this is cut up [rad].
FLAT_CORNER = math.radians(145)
#: Pieces of such a cell have no smaller sine than this, or it is left whole.
FLATTEST_PIECE = 0.05
#: Rounds in which the corners inside move towards the middle of their neighbors.
SMOOTHING = 5
#: An element whose angles all have at least this sine may become a little worse when its neighbors gain by it.
GOOD = 0.7
#: Elements with a smaller scaled Jacobian are improved, in so many rounds.
POOR, MAX_IMPROVEMENTS = 0.4, 6

#: A side by its two nodes; cells by number, each with its corners in turn.
Side = frozenset[int]
Polygons = dict[int, list[int]]


def make_elements(cells: Cells) -> tuple[Array, Integers]:
    """Return nodes (n, 2) and nine-node quadrilaterals (m, 9), as good as they become, that cells are cut into."""
    nodes, quadrilaterals, drawn = split_into_quadrilaterals(split_flat_corners(cells))
    nodes = smooth(nodes, [quadrilaterals], drawn)
    improve(nodes, quadrilaterals, drawn)
    return add_midside_nodes(nodes, quadrilaterals, drawn)


def cut_triangles(cells: Cells) -> tuple[Array, Integers]:
    """Return nodes (n, 2) and nine-node quadrilaterals (m, 9): those among the cells, and what triangles are cut into.

    Nodes hang on the sides between both.
    """
    cells = split_flat_corners(cells)
    drawn, three, four = cells.drawn, cells.triangles, cells.quadrilaterals
    nodes = smooth(cells.nodes, [three, four], drawn)
    improve(nodes, four, drawn._replace(points=np.union1d(drawn.points, three)))
    n = len(nodes)
    sides, number = np.unique(sides_of(three, n), return_inverse=True)
    number = number.reshape(three.shape)
    places = np.concatenate([nodes, middles_of(nodes, sides, drawn), nodes[three].mean(axis=1)])
    after, center = n + number, n + len(sides) + np.arange(len(three))
    before = np.roll(after, 1, axis=1)
    parts = [np.column_stack([three[:, k], after[:, k], center, before[:, k]]) for k in range(3)]
    keys = sides // n * len(places) + sides % n
    return add_midside_nodes(places, np.concatenate([four, *parts]), _halved(drawn, sides, n), (keys, n))


def _halved(drawn: FixedSides, sides: Integers, n: int) -> FixedSides:
    """Return what is drawn with the halves of those sides, given by ascending keys, that have a node in the middle."""
    place, cut = find_sides(sides, drawn.ends, n)
    middle, (start, end) = n + place[cut], drawn.ends[cut].T
    ends = np.concatenate([drawn.ends, np.column_stack([start, middle]), np.column_stack([middle, end])])
    twice = np.concatenate([np.arange(len(drawn.ends)), np.flatnonzero(cut), np.flatnonzero(cut)])
    return FixedSides(ends, drawn.centre[twice], drawn.radius[twice], drawn.points)


def split_flat_corners(cells: Cells) -> Cells:
    """Return a mesh in which cells whose corner is nearly flat are cut up into triangles that meet at this corner.

    A triangle can be flat only where both sides lie on the border; it is joined with the cell on its third side first.
    """
    polygons = dict(enumerate([*cells.triangles.tolist(), *cells.quadrilaterals.tolist()]))
    flat = _flat_corners(cells)
    if not flat:
        return cells
    drawn = {frozenset(ends) for ends in cells.drawn.ends.tolist()}
    owners = _owners(polygons)
    for i, middle in flat:
        if i not in polygons:
            continue
        gone, around = _open_cell(polygons, owners, drawn, i, middle)
        fan = [[middle, a, b] for a, b in pairwise(around)]
        if not fan or (least_sine(cells.nodes[np.array(fan)]) < FLATTEST_PIECE).any():
            continue
        for j in gone:
            del polygons[j]
        # new cells get numbers that no side knows: they are not cut again
        number = max(polygons, default=-1) + 1 + len(owners)
        polygons |= {number + m: piece for m, piece in enumerate(fan)}
    return Cells(cells.nodes, *sort_by_corners(polygons.values()), cells.drawn)


def _flat_corners(cells: Cells) -> list[tuple[int, int]]:
    """Return cells, triangles counted first, and those of their nodes at which they are nearly flat."""
    flat: list[tuple[int, int]] = []
    for first, kind in ((0, cells.triangles), (len(cells.triangles), cells.quadrilaterals)):
        if len(kind):
            which, corner = np.nonzero(angles_of(cells.nodes, kind, cells.drawn) > FLAT_CORNER)
            flat += zip((first + which).tolist(), kind[which, corner].tolist(), strict=True)
    return flat


def _owners(polygons: Polygons) -> dict[Side, list[int]]:
    """Return the cells on either hand of each side."""
    owners: dict[Side, list[int]] = {}
    for i, corners in polygons.items():
        for side in zip(corners, corners[1:] + corners[:1], strict=True):
            owners.setdefault(frozenset(side), []).append(i)
    return owners


def _open_cell(
    polygons: Polygons, owners: dict[Side, list[int]], drawn: set[Side], i: int, middle: int
) -> tuple[list[int], list[int]]:
    """Return the cells to cut up from a corner of cell i, and their other corners in turn; none where it cannot be."""
    k = polygons[i].index(middle)
    around = polygons[i][k + 1 :] + polygons[i][:k]
    if len(around) > 2:
        return [i], around
    third = frozenset(around)
    beside = [j for j in owners[third] if j != i]
    if third in drawn or not beside or beside[0] not in polygons:
        return [], []
    other = polygons[beside[0]]
    k = other.index(around[1])
    return [i, *beside], around[:1] + (other[k:] + other[:k])[2:] + around[1:]


def split_into_quadrilaterals(cells: Cells) -> tuple[Array, Integers, FixedSides]:
    """Return nodes and quadrilaterals, and what is drawn, with each cell cut up between its middle and its sides'."""
    nodes, drawn = cells.nodes, cells.drawn
    n = len(nodes)
    kinds = [kind for kind in (cells.triangles, cells.quadrilaterals) if len(kind)]
    sides = np.unique(np.concatenate([sides_of(kind, n).ravel() for kind in kinds]))
    places = [nodes, middles_of(nodes, sides, drawn)]
    quadrilaterals = []
    total = n + len(sides)
    for kind in kinds:
        after = n + np.searchsorted(sides, sides_of(kind, n))
        before = np.roll(after, 1, axis=1)
        centre = total + np.arange(len(kind))
        places.append(nodes[kind].mean(axis=1))
        total += len(kind)
        quadrilaterals += [
            np.column_stack([kind[:, k], after[:, k], centre, before[:, k]]) for k in range(kind.shape[1])
        ]
    # edges of what was cut off have no cells
    half, used = find_sides(sides, drawn.ends, n)
    half, ends = n + half[used], drawn.ends[used]
    halves = np.concatenate([np.column_stack([ends[:, 0], half]), np.column_stack([half, ends[:, 1]])])
    twice = FixedSides(halves, np.tile(drawn.centre[used], (2, 1)), np.tile(drawn.radius[used], 2), drawn.points)
    return np.concatenate(places), np.concatenate(quadrilaterals), twice


def smooth(nodes: Array, kinds: Sequence[Integers], drawn: FixedSides) -> Array:
    """Return the nodes after moving those inside towards the mean of their neighbors, where no cell suffers."""
    free = np.ones(len(nodes), dtype=bool)
    free[drawn.ends] = free[drawn.points] = False
    after = np.concatenate([np.roll(cells, -1, axis=1).ravel() for cells in kinds])
    here = np.concatenate([cells.ravel() for cells in kinds])
    count = np.bincount(here, minlength=len(nodes)) + np.bincount(after, minlength=len(nodes))
    free &= count > 0
    for _ in range(SMOOTHING):
        total = np.zeros_like(nodes)
        for axis in (0, 1):
            total[:, axis] = np.bincount(here, nodes[after, axis], len(nodes))
            total[:, axis] += np.bincount(after, nodes[here, axis], len(nodes))
        least = [np.minimum(least_sine(nodes[cells]), GOOD) - 1e-12 for cells in kinds]
        moved = np.where(free[:, None], total / np.maximum(count, 1)[:, None], nodes)
        while len(back := _worse(moved, kinds, least)):
            moved[back] = nodes[back]
        nodes = moved
    return nodes


def _worse(nodes: Array, kinds: Sequence[Integers], least: Sequence[Array]) -> Integers:
    """Return the corners of cells whose least sine is below the one given."""
    worse = [cells[least_sine(nodes[cells]) < limit].ravel() for cells, limit in zip(kinds, least, strict=True)]
    return np.concatenate(worse)


def least_sine(xy: Array) -> Array:
    """Return the least sine of the angles of polygons (p, corners, 2), negative where one is inverted."""
    to = np.roll(xy, -1, axis=1) - xy
    back = np.roll(xy, 1, axis=1) - xy
    cross = to[..., 0] * back[..., 1] - to[..., 1] * back[..., 0]
    sine: Array = (cross / np.maximum(np.linalg.norm(to, axis=2) * np.linalg.norm(back, axis=2), 1e-300)).min(axis=1)
    return sine


def improve(nodes: Array, quadrilaterals: Integers, drawn: FixedSides) -> None:
    """Move corners of bad elements, one by one, to where the worst element around them is best."""
    keys, number = np.unique(sides_of(quadrilaterals, len(nodes)), return_inverse=True)
    number = number.reshape(quadrilaterals.shape)
    place, fixed = find_sides(keys, drawn.ends, len(nodes))
    centre, radius = np.zeros((len(keys), 2)), np.zeros(len(keys))
    centre[place[fixed]], radius[place[fixed]] = drawn.centre[fixed], drawn.radius[fixed]
    fixed_points = np.zeros(len(nodes), dtype=bool)
    fixed_points[drawn.ends] = fixed_points[drawn.points] = True
    angle = np.arange(16) * math.pi / 8
    ways = np.concatenate([r * np.column_stack([np.cos(angle), np.sin(angle)]) for r in (0.03, 0.1, 0.25, 0.5)])

    def rated(corners: Array, sides: Integers) -> Array:
        middles = (corners + np.roll(corners, -1, axis=-2)) / 2
        offset = middles - centre[sides]
        away = np.maximum(np.linalg.norm(offset, axis=-1), 1e-300)
        curved = centre[sides] + offset * (radius[sides] / away)[..., None]
        eight = np.concatenate([corners, np.where(radius[sides][..., None] > 0, curved, middles)], axis=-2)
        nine = np.concatenate([eight, (SERENDIPITY_CENTER @ eight)[..., None, :]], axis=-2)
        return scaled_jacobians(nine.reshape(-1, 9, 2)).reshape(corners.shape[:-2])

    for _ in range(MAX_IMPROVEMENTS):
        bad = rated(nodes[quadrilaterals], number) < POOR
        corners = np.unique(quadrilaterals[bad])
        for corner in corners[~fixed_points[corners]]:
            around = np.flatnonzero((quadrilaterals == corner).any(axis=1))
            cells = quadrilaterals[around]
            reach = np.linalg.norm(nodes[cells] - nodes[corner], axis=2).max() / 2
            tried = nodes[corner] + np.concatenate([np.zeros((1, 2)), reach * ways])
            xy = np.where((cells == corner)[None, :, :, None], tried[:, None, None, :], nodes[cells][None])
            sides = np.broadcast_to(number[around], xy.shape[:-1])
            nodes[corner] = tried[np.argmax(rated(xy, sides).min(axis=1))]


def add_midside_nodes(
    nodes: Array, quadrilaterals: Integers, drawn: FixedSides, numbered: tuple[Integers, int] | None = None
) -> tuple[Array, Integers]:
    """Return nodes and elements with nodes at the middles of sides and of elements added.

    Some sides, known by ascending keys, have a node in the middle already: the first of them that of a given number,
    the others those that follow.
    """
    n = len(nodes)
    sides = sides_of(quadrilaterals, n)
    keys, number = np.unique(sides, return_inverse=True)
    new, middle = np.ones(len(keys), dtype=bool), np.zeros(len(keys), dtype=np.int64)
    if numbered is not None:
        existing = np.flatnonzero(np.isin(keys, numbered[0]))
        new[existing], middle[existing] = False, numbered[1] + np.searchsorted(numbered[0], keys[existing])
    middle[new] = n + np.arange(new.sum())
    places = np.concatenate([nodes, middles_of(nodes, keys[new], drawn)])
    eight = np.column_stack([quadrilaterals, middle[number.reshape(sides.shape)]])
    centre = SERENDIPITY_CENTER @ places[eight]
    elements = np.column_stack([eight, len(places) + np.arange(len(eight))])
    return np.concatenate([places, centre]), elements
