"""Means of section forces over discs, where they are singular."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.mesh import SIDES, Mesh, bounding_boxes, locate
from groundslab.fem.shape_functions import q9_values
from groundslab.geometry.plan import FLAT, Place, Ring
from groundslab.model.loads.acting import LineForce, PointForce
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import first_sections
from groundslab.model.remarks.singular_places import near_places, singular_places

if TYPE_CHECKING:
    from scipy.sparse import csr_array
    from shapely.geometry.base import BaseGeometry

#: Rings and rays of the points by which a field is integrated over a disc; no ray runs along an axis or a diagonal.
RINGS, RAYS = 4, 16
#: Those closer to a singular place than this share of the disc's diameter are replaced by so many by so many, and of
#: these again those that are as many times closer.
CLOSE, DIVIDED, TIMES = 0.15, 3, 2
#: Elements no larger than this share of a disc's radius need its mean at their corners only.
SMALL = 1 / 8
#: Edges meet at a corner if the sine of the angle between them is above this.
BENT = 1e-6
#: Distances that differ by less than this share are one, so that no unit of length counts.
ROUNDING = 1e-6
#: Parts of moments are told apart at a corner if what is theirs alone is above this share.
PARALLEL = 0.1
#: By which m_x, m_y, m_xy are a vector whose length does not depend on the axes.
WEIGHTS = np.array([1.0, 1.0, np.sqrt(2)])
#: Of so many nodes at a time, to spare memory.
CHUNK = 512


@dataclass(frozen=True, slots=True)
class AcrossEdge:
    """What takes fields (n,) that vanish at a straight edge to their means at k of r nodes, see `DiscMeans`."""

    rows: Integers  # (k,): which of the r nodes
    normal: Array  # (2,): of the edge
    matrix: csr_array  # (k, n)
    twists: bool  # whether the twisting moment does not vanish there


@dataclass(frozen=True, slots=True)
class DiscMeans:
    """What takes nodal fields of the plate (n,) to their means over discs at r of its nodes.

    Such a mean exists where the value at a point does not. Far from edges it is the value under a force that has spread
    at 45 degrees from the surface to the middle plane, over a disc as wide as the plate is thick. What of a disc lies
    off the plate is left out. But at an edge that is free to turn, a joint's too, m_n is zero, and so is the twisting
    moment if the edge also turns along itself: beyond the edge they go on as inside, with the other sign, so that means
    are zero at the edge, too.
    """

    nodes: Integers  # (r,)
    matrix: csr_array  # (r, n)
    between: Integers  # (k,): nodes of small elements that have the mean of their corners' means
    corners: Integers  # (k, 4)
    across: tuple[AcrossEdge, ...] = ()

    def apply(self, field: Array) -> Array:
        """Return a field with its means at these nodes."""
        if not len(self.nodes):
            return field
        return self._with(field, self.matrix @ field)

    def apply_to_moments(self, moments: Array) -> Array:
        """Return m_x, m_y, m_xy (n, 3) with their means at these nodes."""
        if not len(self.nodes):
            return moments
        means = self.matrix @ moments
        if self.across:
            rows, of, off = (np.concatenate(parts) for parts in zip(*self._across(moments, means), strict=True))
            means += _corrections(rows, of, off, len(means))
        return self._with(moments, means)

    def _across(self, moments: Array, means: Array) -> Iterator[tuple[Integers, Array, Array]]:
        """Yield rows (k,) whose m_n or m_nt edges change, what of m_x, m_y, sqrt(2) m_xy it is (k, 3), by how much."""
        for edge in self.across:
            x, y = edge.normal
            bending, twist = [x * x, y * y, np.sqrt(2) * x * y], [-x * y, x * y, (x * x - y * y) / np.sqrt(2)]
            for of in (bending,) if edge.twists else (bending, twist):
                off = edge.matrix @ (moments @ (of * WEIGHTS)) - means[edge.rows] @ (of * WEIGHTS)
                yield edge.rows, np.tile(of, (len(off), 1)), off

    def _with(self, field: Array, means: Array) -> Array:
        """Return a field (n, ...) with means (r, ...) at these nodes."""
        averaged = field.copy()
        averaged[self.nodes] = means
        averaged[self.between] = averaged[self.corners].mean(axis=1)
        return averaged


def _corrections(rows: Integers, of: Array, off: Array, count: int) -> Array:
    """Return the least changes of m_x, m_y, m_xy (count, 3) by which parts of them in some rows (k,) change so much.

    Edges that meet at a corner may ask for different twisting moments, or be nearly parallel: then the squares of what
    is missing are least, so that no order of the edges counts.
    """
    order = np.argsort(rows, kind="stable")
    rows, of, off = rows[order], of[order], off[order]
    unique, start, sizes = np.unique(rows, return_index=True, return_counts=True)
    place = np.repeat(np.arange(len(unique)), sizes), np.arange(len(rows)) - np.repeat(start, sizes)
    wanted, asked = np.zeros((len(unique), sizes.max(), 3)), np.zeros((len(unique), sizes.max(), 1))
    wanted[place], asked[place] = of, off[:, None]
    changes = np.zeros((count, 3))
    changes[unique] = (np.linalg.pinv(wanted, PARALLEL) @ asked)[:, :, 0] / WEIGHTS
    return changes


def make_disc_means(model: Model, mesh: Mesh, section: Integers, thickness: Array) -> DiscMeans:
    """Return the means over discs as wide as the plate is thick, of nodes within a thickness of singular places.

    The mesh is that of the full plate; section (m,) and thickness (m,) [m] are those of its elements. What of a disc
    lies off the plate or in another section is left out.
    """
    from scipy.sparse import csr_array, vstack

    of_node, t = np.zeros(len(mesh.nodes), dtype=np.int64), np.zeros(len(mesh.nodes))
    of_node[mesh.elements], t[mesh.elements] = section[:, None], thickness[:, None]
    singular = [place for places in singular_places(model).values() for place in places]
    near = near_places(singular, mesh.nodes, t)
    between, corners = _between_corners(mesh, near, t / 2)
    near[between] = False
    nodes = np.flatnonzero(near)
    boxes = bounding_boxes(mesh) if len(nodes) else None
    edges = [*_edges_near(model, mesh.nodes[nodes], t[nodes] / 2)] if len(nodes) else []
    turns = _turn_freely(model, mesh.nodes[nodes], t[nodes]) if edges else near[nodes]
    first = np.array(first_sections(model.every_plate))
    parts, across = [csr_array((0, len(mesh.nodes)))], list[AcrossEdge]()
    for start in range(0, len(nodes), CHUNK):
        chunk = nodes[start : start + CHUNK]
        row, offset, weight = _disc_points(mesh.nodes[chunk], t[chunk] / 2, singular)
        points = mesh.nodes[chunk[row]] + offset
        element, place = locate(mesh, points, boxes=boxes)
        inside = (element >= 0) & (section[element] == of_node[chunk[row]])
        disc = _Points(row[inside], weight[inside], element[inside], place[inside])
        parts.append(_mean_over(disc, mesh, chunk))
        of_plate = np.searchsorted(first, of_node[chunk], side="right") - 1
        for edge in edges:
            beside = turns[start : start + CHUNK] & (of_plate == edge.plate)
            rows = np.flatnonzero(beside & edge.near(mesh.nodes[chunk], t[chunk] / 2))
            beyond = np.flatnonzero(np.isin(row, rows) & ~inside & edge.faces(points))
            turned, at = locate(mesh, edge.mirrored(points[beyond]), boxes=boxes)
            same_section = (turned >= 0) & (section[turned] == of_node[chunk[row[beyond]]])
            if not same_section.any():
                continue
            beyond, in_rows = beyond[same_section], np.isin(disc.row, rows)
            both = _Points(
                np.concatenate([disc.row[in_rows], row[beyond]]),
                np.concatenate([disc.weight[in_rows], -weight[beyond]]),
                np.concatenate([disc.element[in_rows], turned[same_section]]),
                np.concatenate([disc.place[in_rows], at[same_section]]),
            )
            across.append(AcrossEdge(start + rows, edge.inward, _mean_over(both, mesh, chunk)[rows], edge.twists))
    return DiscMeans(nodes, vstack(parts, format="csr"), between, corners, tuple(across))


@dataclass(frozen=True, slots=True)
class _Points:
    """Points of discs: whose they are, their weights, the elements that hold them, and where in these."""

    row: Integers  # (p,)
    weight: Array  # (p,): negative of what counts with the other sign
    element: Integers  # (p,)
    place: Array  # (p, 2)


def _mean_over(disc: _Points, mesh: Mesh, nodes: Integers) -> csr_array:
    """Return what takes fields (n,) to their means over the points of discs around nodes (k,), (k, n)."""
    from scipy.sparse import csr_array

    total = np.bincount(disc.row, weights=np.abs(disc.weight), minlength=len(nodes))
    # beside a sharp corner no point may be left: the value stays
    alone = np.flatnonzero(total == 0)
    N = q9_values(disc.place) * (disc.weight / total[disc.row])[:, None]
    values = np.concatenate([N.ravel(), np.ones(len(alone))])
    rows = np.concatenate([np.repeat(disc.row, N.shape[1]), alone])
    columns = np.concatenate([mesh.elements[disc.element].ravel(), nodes[alone]])
    return csr_array((values, (rows, columns)), shape=(len(nodes), len(mesh.nodes)))


@dataclass(frozen=True, slots=True)
class _Edge:
    """A straight edge of a plate, across which no moment bends it."""

    plate: int
    start: Array  # (2,) [m]
    along: Array  # (2,): its direction
    length: float  # [m]
    inward: Array  # (2,): across it, into the plate
    twists: bool  # whether a twisting moment acts along it, as it cannot turn along itself
    corners: tuple[bool, bool]  # whether the plate ends where it starts, and where it ends, rather than turns inwards

    def near(self, nodes: Array, reach: Array) -> Flags:
        """Return around which nodes (n, 2) discs of a reach (n,) [m] meet the edge, but nothing of the plate beside it.

        Around a corner that points into the plate no field goes on beyond the edge.
        """
        way, off = (nodes - self.start) @ self.along, (nodes - self.start) @ self.inward
        half = np.sqrt(np.maximum(reach**2 - off**2, 0.0))
        # at a corner that points out of the plate its disc may reach past the edge
        low, high = (way - (1 - 2 * corner) * half * side for side, corner in zip((1, -1), self.corners, strict=True))
        least = ROUNDING * reach
        is_near: Flags = (half > least) & (low > least) & (high < self.length - least)
        return is_near

    def faces(self, points: Array) -> Flags:
        """Return which points (p, 2) lie beyond the edge, between its ends."""
        way = (points - self.start) @ self.along
        faces_it: Flags = ((points - self.start) @ self.inward < 0) & (way >= 0) & (way <= self.length)
        return faces_it

    def mirrored(self, points: Array) -> Array:
        """Return the points (p, 2) on the other side of the edge."""
        images: Array = points - 2 * ((points - self.start) @ self.inward)[:, None] * self.inward
        return images


def _edges_near(model: Model, nodes: Array, reach: Array) -> Iterator[_Edge]:
    """Yield the straight edges of plates near nodes (n, 2), so far [m] each."""
    import shapely

    chord = FLAT * max(max(plate.sides) for plate in model.every_plate)
    hinged = shapely.union_all([*_supported(model.plate, "hinged", chord)]).buffer(chord)
    for number, plate in enumerate(model.every_plate):
        for ring, side in zip(plate.rings(), (1, *[-1] * len(plate.openings)), strict=True):
            turn = side * np.sign(ring.signed_area)
            out = _points_out(ring, turn)
            for i, segment in enumerate(ring.segments()):
                if not segment.straight:
                    continue
                start, end = np.array(segment.start), np.array(segment.end)
                length = float(np.linalg.norm(end - start))
                along = (end - start) / length
                inward = turn * np.array([-along[1], along[0]])
                twists = hinged.intersects(shapely.Point(segment.middle))
                edge = _Edge(number, start, along, length, inward, twists, (out[i], out[(i + 1) % len(out)]))
                if edge.near(nodes, reach).any():
                    yield edge


def _turn_freely(model: Model, nodes: Array, reach: Array) -> Flags:
    """Return beside which nodes (n, 2), so far [m], edges are free to turn about themselves.

    Clamped edges are not, nor where a beam, a support that holds rotations, or couples act.
    """
    import shapely

    chord = FLAT * max(max(plate.sides) for plate in model.every_plate)
    held = shapely.union_all([*_supported(model.plate, "clamped", chord), *_held(model, chord)])
    if held.is_empty:
        return np.ones(len(nodes), dtype=bool)
    shapely.prepare(held)
    free: Flags = ~shapely.dwithin(shapely.points(nodes), held, (1 + ROUNDING) * reach)
    return free


def _points_out(ring: Ring, turn: float) -> list[bool]:
    """Return whether the corner at which each edge of a ring starts points out of the plate, to the left of turn 1."""
    edges = ring.segments()
    pairs = zip((edges[-1], *edges[:-1]), edges, strict=True)
    angles = [edge.direction(0.0) - before.direction(1.0) for before, edge in pairs]
    return [bool(turn * np.sin(angle) > BENT) for angle in angles]


def _supported(plate: Plate, kind: str, chord: float) -> Iterator[BaseGeometry]:
    """Yield the edges of a plate that are supported in a way."""
    import shapely

    x0, x1, y0, y1 = plate.bounds
    sides = {"left": (x0, y0, x0, y1), "right": (x1, y0, x1, y1), "bottom": (x0, y0, x1, y0), "top": (x0, y1, x1, y1)}
    for side, (a, b, c, d) in sides.items():
        if getattr(plate.edges, side) == kind:
            yield shapely.LineString([(a, b), (c, d)])
    if plate.support == kind:
        yield plate.ring().polygon(chord).exterior


def _held(model: Model, chord: float) -> Iterator[BaseGeometry]:
    """Yield what else may bend a plate across its edge, if it lies there."""
    import shapely

    for support in model.supports:
        if support.rotation == "fixed" or getattr(support, "rotational_stiffness", None) is not None:
            yield shapely.LineString([*support.points, support.points[-1]])
    if model.building is not None:
        yield from (column.to_shapely(chord) for column in model.columns)
        yield from (wall.to_shapely(chord) for wall in model.placed_walls)
    for beam in model.members:
        yield beam.to_shapely(chord)
    for _, shape in model.acting:
        if isinstance(shape, LineForce) and any(shape.m):
            yield shape.to_shapely(chord)
        if isinstance(shape, PointForce) and any(shape.M):
            yield shape.to_shapely(chord)


def _between_corners(mesh: Mesh, near: Flags, radius: Array) -> tuple[Integers, Integers]:
    """Return which nodes lie halfway between corners near singular places, (k,), and these corners, (k, 4).

    Only of elements that are small beside discs of a radius (n,) [m], over whose size a mean changes. Where nodes hang,
    the middle of a longer side is a corner of others.
    """
    xy, corner = mesh.xy[:, :4], mesh.elements[:, :4]
    longest = np.linalg.norm(xy - np.roll(xy, 1, axis=1), axis=2).max(axis=1)
    small = mesh.elements[near[corner].all(axis=1) & (longest <= SMALL * radius[corner[:, 0]])]
    corners = np.full((len(mesh.nodes), 4), -1)
    for start, end, middle in SIDES:
        corners[small[:, middle]] = small[:, [start, end, start, end]]
    corners[small[:, 8]] = small[:, :4]
    corners[mesh.elements[:, :4]] = -1
    between = np.flatnonzero(near & (corners[:, 0] >= 0))
    return between, corners[between]


def _disc_points(centres: Array, radius: Array, singular: Sequence[Place]) -> tuple[Integers, Array, Array]:
    """Return points that integrate over discs (r,): whose they are (p,), where from the centre (p, 2), weights (p,).

    Parts of a disc near a singular place, around which fields change much, are divided.
    """
    from scipy.spatial import KDTree

    # a part is a piece of a ring and of a ray; by squares of the radius, rings have the sizes of Gauss's weights
    x, of_ring = np.polynomial.legendre.leggauss(RINGS)
    ring, ray = (grid.ravel() for grid in np.indices((RINGS, RAYS)))
    height, wide = of_ring / 2, 2 * np.pi / RAYS
    first = np.column_stack([(np.cumsum(height) - height)[ring], height[ring], wide * ray, np.full(len(ring), wide)])
    row, part = np.repeat(np.arange(len(centres)), len(first)), np.tile(first, (len(centres), 1))
    squared = np.tile((1 + x[ring]) / 2, len(centres))
    tree, parts = KDTree(singular), (np.arange(DIVIDED) / DIVIDED for _ in range(2))
    steps = np.column_stack([grid.ravel() for grid in np.meshgrid(*parts)])
    places = []
    for time in range(TIMES + 1):
        angle = part[:, 2] + part[:, 3] / 2
        offset = (radius[row] * np.sqrt(squared) * (np.cos(angle), np.sin(angle))).T
        close = np.zeros(len(row), dtype=bool)
        if time < TIMES:
            reach = CLOSE * 2 * radius[row] / DIVIDED**time
            close = tree.query(centres[row] + offset, distance_upper_bound=reach.max(initial=0))[0] <= reach
        places.append((row[~close], offset[~close], (part[:, 1] * part[:, 3] / (2 * np.pi))[~close]))
        row, part = np.repeat(row[close], len(steps)), np.repeat(part[close], len(steps), axis=0)
        part[:, [0, 2]] += np.tile(steps, (int(close.sum()), 1)) * part[:, [1, 3]]
        part[:, [1, 3]] /= DIVIDED
        squared = part[:, 0] + part[:, 1] / 2
    rows, offsets, weights = (np.concatenate(grid) for grid in zip(*places, strict=True))
    return rows, offsets, weights
