"""Perimeters around ends and corners of walls, and the shear force of the slab across them.

No code's formulas are in here but for the lengths that count, by Figure NA.6.12.1 of DIN EN 1992-1-1/NA, as EN 1992-1-1
and ACI 318-19 have none for ends of walls: b_1 = min(b, 2.8 d) across a wall of thickness b, and along each side of it
a_1 / 2, a_1 = min(a, 2 b, 5.6 d - b_1) with the length a of the wall. At the distance a from the faces a perimeter runs
along one side, in quarter circles around the corners and straight across the end, and back along the other side. At a
corner of walls it runs along the outer faces and around the outer corner. The part on the inner side, which the figure
does not show, is left out: there both walls share what the slab carries, and the perimeter is the shorter without it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh, locate
from groundslab.fem.shape_functions import q9_values, unique_integers
from groundslab.geometry.plan import FLAT
from groundslab.model.structure.wall_ends import WallEnd, WallLeg
from groundslab.results.plate_result import PlateResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon
    from shapely.geometry.base import BaseGeometry

#: The largest b_1, and what a_1 and b_1 together have at most, over the effective depth.
MOST_ACROSS, MOST_AROUND = 2.8, 5.6
#: Straight pieces are read in the middle of so many parts, quarter circles in the middle of so many chords.
PARTS, QUARTER_CHORDS = 16, 64
#: So much of its quarter circles must be on the plate: what hardly turns cuts the slab, which is one-way shear.
LEAST_TURNED = 0.25
#: Where the outer angle of a corner is larger, its point is cut off across the end of the axes, as a wall's end is.
SHARP = math.radians(300.0)


@dataclass(frozen=True, slots=True)
class LoadedArea:
    """What of an end or a corner of walls punches: how far it reaches along its walls and across."""

    end: WallEnd
    along: tuple[float, float]  # a_1 / 2 on the first and the last leg [m]
    across: float  # b_1 at an end, all of what a sharp corner has across [m]
    outer: Array  # (2, 2): the corners of the faces that the perimeter runs around, at most corners twice the same [m]
    run: Array  # (2, 2): unit vectors along both legs
    outward: Array  # (2, 2): unit vectors from their outer faces

    @property
    def center(self) -> Array:
        """Return where openings are seen from (2,) [m]: the center at an end, where the axes meet at a corner."""
        return self.points.mean(axis=0) if self.end.kind == "end" else np.array(self.end.place)

    @property
    def points(self) -> Array:
        """Return the corners (p, 2) of the area that is loaded [m]."""
        ends = self.outer + np.array(self.along)[:, None] * self.run
        thickness = np.array([[self.end.legs[0].thickness], [self.end.legs[-1].thickness]])
        return np.concatenate([self.outer, ends, ends - thickness * self.outward])


def loaded_area(end: WallEnd, d: float, most_along: float = math.inf) -> LoadedArea:
    """Return what of an end or a corner punches a slab of effective depth d [m], along each wall at most so many d."""
    legs = end.legs[0], end.legs[-1]
    run = np.array([[math.cos(leg.angle), math.sin(leg.angle)] for leg in legs])
    left = np.stack([-run[:, 1], run[:, 0]], axis=1)
    outward = left * np.array([[1.0], [-1.0]])
    faces = np.array([leg.place for leg in legs]) + outward * np.array([[leg.thickness / 2] for leg in legs])
    if end.outer_angle <= SHARP:
        # where both faces meet
        way = np.linalg.solve(np.stack([run[0], -run[1]], axis=1), faces[1] - faces[0])
        faces = np.tile(faces[0] + way[0] * run[0], (2, 1))
    along = (min(half_length(legs[0], d), most_along * d), min(half_length(legs[1], d), most_along * d))
    whole = float(np.linalg.norm(faces[1] - faces[0]))
    across = whole if end.kind == "corner" else min(whole, MOST_ACROSS * d)
    return LoadedArea(end, along, across, faces, run, outward)


def half_length(leg: WallLeg, d: float) -> float:
    """Return a_1 / 2 [m] along a wall."""
    b_1 = min(leg.thickness, MOST_ACROSS * d)
    return min(leg.length, 2 * leg.thickness, MOST_AROUND * d - b_1) / 2


@dataclass(frozen=True, slots=True)
class Course:
    """The pieces of a perimeter, each with what it cuts off on its left."""

    legs: Array  # (l, 2, 2) [m]
    turns: Flags  # (l,): whether a piece belongs to a quarter circle


def course(area: LoadedArea, distance: float) -> Course:
    """Return how the perimeter runs at a distance [m] from the faces."""
    along = np.array(area.along)[:, None] * area.run
    starts = area.outer + distance * area.outward
    first = math.atan2(area.outward[0, 1], area.outward[0, 0])
    last = first + area.end.outer_angle - math.pi
    whole = area.outer[1] - area.outer[0]
    straight = [_straight(starts[0] + along[0], starts[0]), _straight(starts[1], starts[1] + along[1])]
    if area.across:
        turned = (math.atan2(-whole[0], whole[1]) - first) % (2 * math.pi)
        ahead = min(first + turned, last)
        straight += _across(area, distance * np.array([math.cos(ahead), math.sin(ahead)]))
        arcs = [_arc(area.outer[0], distance, first, ahead), _arc(area.outer[1], distance, ahead, last)]
    else:
        arcs = [_arc(area.outer[0], distance, first, last)]
    turns = np.repeat([False, True], [sum(map(len, straight)), sum(map(len, arcs))])
    return Course(np.concatenate([*straight, *arcs]), turns)


def _across(area: LoadedArea, off: Array) -> list[Array]:
    """Return the straight piece across an end, off the faces (2,) [m], of a thick wall the parts at both corners."""
    ends = area.outer + off
    whole = ends[1] - ends[0]
    share = area.across / float(np.linalg.norm(whole))
    if share >= 1 - FLAT:
        return [_straight(ends[0], ends[1])]
    return [_straight(ends[0], ends[0] + share / 2 * whole), _straight(ends[1] - share / 2 * whole, ends[1])]


def _straight(start: Array, end: Array) -> Array:
    """Return the parts (l, 2, 2) of a straight piece."""
    return _chords(start + np.linspace(0, 1, PARTS + 1)[:, None] * (end - start))


def _arc(center: Array, radius: float, first: float, last: float) -> Array:
    """Return the chords (l, 2, 2) of an arc between two angles [rad]."""
    count = max(1, round(QUARTER_CHORDS * (last - first) / (math.pi / 2)))
    angles = np.linspace(first, last, count + 1)
    return _chords(center + radius * np.column_stack([np.cos(angles), np.sin(angles)]))


def _chords(places: Array) -> Array:
    """Return the legs (l, 2, 2) between places (l + 1, 2)."""
    return np.stack([places[:-1], places[1:]], axis=1)


class LegsOnPlate(NamedTuple):
    """The legs of a perimeter on the plate, and the share of the length of each that counts."""

    legs: Array  # (l, 2, 2) [m]
    shares: Array  # (l,)

    def shear(self, plate: PlateResult) -> Array:
        """Return - int q_n ds on each leg (l,) [N], as `WallPerimeters.shear` has them together."""
        _, nodes, inward = _read(plate, self.legs)
        q = np.stack([plate.shear_x[nodes], plate.shear_y[nodes]])
        return np.asarray(np.einsum("ilk,ilk->l", inward, q))


@dataclass(frozen=True, slots=True)
class WallPerimeters:
    """The perimeters of an end or a corner on the plate, and the nodes that its shear forces are read from."""

    distances: Array  # (k,): from the faces [m]
    u: Array  # (k,): the lengths that count [m]
    whole: Array  # (k,): of what lies on the plate [m]
    nodes: Integers  # (n,)
    across: Array  # (2, k, n): of nodal shear_x and shear_y in what they are across a perimeter, inwards positive [m]
    legs: tuple[LegsOnPlate, ...] = ()  # of each perimeter

    def shear(self, plate: PlateResult) -> Array:
        """Return - int q_n ds (k,) [N], n outwards: what presses inside less what bears it there."""
        q = np.stack([plate.shear_x[self.nodes], plate.shear_y[self.nodes]])
        return np.asarray(np.einsum("ikn,in->k", self.across, q))


def wall_perimeters(
    plate: PlateResult,
    plan: Polygon | MultiPolygon,
    area: LoadedArea,
    distances: Array,
    shadow: BaseGeometry,
    shares: Callable[[Array, float], Array] | None = None,
) -> WallPerimeters:
    """Return the perimeters at distances [m] that run around the end or the corner on the plan of the plate.

    What lies in the shadow of openings does not count in their lengths; at places (n, 2) of a perimeter at a distance
    shares count, if they are given.
    """
    from shapely import contains_xy, prepare

    courses = [course(area, float(distance)) for distance in distances]
    legs = np.concatenate([line.legs for line in courses])
    number = np.repeat(np.arange(len(courses)), [len(line.legs) for line in courses])
    middle = legs.mean(axis=1)
    prepare(plan)
    on_mesh, of_nodes, inward = _read(plate, legs)
    on = on_mesh & contains_xy(plan, *middle.T)
    counted = on if shadow.is_empty else on & ~contains_xy(shadow, *middle.T)
    turns = np.concatenate([line.turns for line in courses])
    of_turns, on_plate = (np.bincount(number[mask], minlength=len(courses)) for mask in (turns, turns & on))
    u = np.zeros(len(courses))
    length = np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)
    share = counted.astype(float)
    whole = np.asarray(np.bincount(number[on], length[on], minlength=len(courses)), dtype=float)
    if shares is not None:
        for k, distance in enumerate(distances):
            share[number == k] *= shares(middle[number == k], float(distance))
    np.add.at(u, number, share * length)
    kept = np.flatnonzero((on_plate >= LEAST_TURNED * of_turns) & (u > 0))
    nodes, which = unique_integers(of_nodes[on])
    across = np.zeros((2, len(courses), len(nodes)))
    rows = np.repeat(number[on][:, None], of_nodes.shape[1], axis=1)
    for axis in (0, 1):
        np.add.at(across[axis], (rows, which.reshape(rows.shape)), inward[axis, on])
    on_each = tuple(LegsOnPlate(legs[on & (number == k)], share[on & (number == k)]) for k in kept)
    return WallPerimeters(distances[kept], u[kept], whole[kept], nodes, across[:, kept], on_each)


def _read(plate: PlateResult, legs: Array) -> tuple[Flags, Integers, Array]:
    """Return how shear forces are read in the middle of legs (l, 2, 2) with their left side inwards.

    They are whether a leg lies on the plate (l,), the nodes of its element (l, 9), and nodal shear_x and shear_y in
    what they are across it (2, l, 9) [m].
    """
    from shapely import box

    middle, run = legs.mean(axis=1), legs[:, 1] - legs[:, 0]
    mesh = Mesh(plate.nodes, plate.elements)
    near = load_vectors.find_elements_near(mesh, box(*middle.min(axis=0), *middle.max(axis=0)))
    element, local = locate(Mesh(mesh.nodes, mesh.elements[near]), middle)
    on_mesh = element >= 0
    N = np.where(on_mesh[:, None], q9_values(local), 0.0)
    inward = np.stack([-run[:, 1], run[:, 0]])[:, :, None] * N
    return on_mesh, mesh.elements[near[np.maximum(element, 0)]], inward
