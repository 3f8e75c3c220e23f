"""Cuts across necks of a slab, from edge to edge: between two openings, or between an opening and the slab's edge.

A neck is where the largest circle that touches a place of the edge from within has a radius of at most 2 h, h being the
thickness there, and touches another place of the edge nearly opposite; the cut runs from one place to the other. All
that is loaded beyond a neck passes through it, whatever happens at its own edges, so what counts is the mean over the
cut, as of a beam of that width (EN 1992-1-1 6.2.2(1), EN 1992-1-1:2023 8.2.1(4), ACI 318-19 22.5.1.1).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.checks.one_way_shear.faces import Bearer, webs_of
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.perimeter_loads import PunchingForce
from groundslab.design.demands.perimeters import outline
from groundslab.design.rules.wide_beam import Cut, cut_along, singular_nodes
from groundslab.fem.mesh import Mesh
from groundslab.model.remarks.singular_places import forces_without_footprint
from groundslab.model.supports import LineSupport
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import LinearRing, Polygon
    from shapely.geometry.base import BaseGeometry

#: The largest radius of a circle in a neck over the thickness. In wider slab nodes count in the middle (`places`).
NARROW = 2.0
#: Places of the edge are so far apart at most, over the thickness, and at a corner into the slab so many degrees.
APART, TURN = 0.5, 15.0
#: The cosine of the angle between what a circle touches, seen from its center: more and it lies in a corner.
OPPOSITE = -0.5
#: Halvings that find a circle's radius, and the share of it by which a slightly larger one is no longer free.
HALVINGS, LARGER = 30, 1e-4


def neck_cuts(results: CombinationResult, thickness: Array) -> list[Cut]:
    """Return the cuts across all necks of a slab with a thickness (n,) [m] at its nodes, without the webs of beams."""
    from shapely import LineString, get_coordinates, get_parts

    plate = results.plate
    mesh = Mesh(plate.nodes, plate.elements)
    plans = [outline(part) for part in results_by_plate(results).values()]
    cuts = [_legs(part, plate.nodes, thickness) for plan in plans for part in get_parts(plan)]
    singular, (webs, _) = singular_nodes(results), webs_of(results.solved_model)
    beside_webs = [get_parts(LineString(leg).difference(webs)) for leg in np.concatenate(cuts)]
    legs = [np.array([get_coordinates(part) for part in parts if part.length]) for parts in beside_webs]
    return [cut_along(mesh, those, singular) for those in legs if len(those)]


def is_beside(
    results: CombinationResult, cut: Cut, d: float, forces: Sequence[PunchingForce], pressing: Sequence[Bearer]
) -> bool:
    """Return whether a cut is nearer than d to the face of what bears on the slab there, so that less counts.

    Of lines those count that run along the cut rather than across it: what a wall presses on a neck that it follows
    passes through the neck all the same.
    """
    from shapely import LineString, Point, distance

    model, line = results.solved_model, LineString(cut.legs.reshape(-1, 2))
    bare = [support.points[0] for support in model.supports
            if not isinstance(support, LineSupport) and support.diameter is None]  # fmt: skip
    shapes: list[BaseGeometry] = [Point(place) for place in (*bare, *forces_without_footprint(model))]
    shapes += [force.footprint.footprint() for force in forces if not force.at_zone]
    shapes += [bearer.shape for bearer in pressing if bearer.shape.area > 0]
    if shapes and (distance(line, shapes) < d * (1 - LARGER)).any():
        return True
    walls = (bearer for bearer in pressing if not bearer.shape.area)
    return any(_runs_along(bearer.shape, line, cut, bearer.face + d) for bearer in walls)


def _runs_along(wall: BaseGeometry, line: BaseGeometry, cut: Cut, reach: float) -> bool:
    """Return whether the part of a wall within a distance [m] of a cut extends along it rather than across."""
    from shapely import get_coordinates

    near = get_coordinates(wall.intersection(line.buffer(reach * (1 - LARGER), cap_style="flat")))
    if not len(near):
        return False
    n_x, n_y = cut.normal
    return bool(np.ptp(near @ (-n_y, n_x)) > np.ptp(near @ (n_x, n_y)))


def _legs(plan: Polygon, nodes: Array, thickness: Array) -> Array:
    """Return the cuts across the necks of a plan (l, 2, 2) [m]."""
    from scipy.spatial import cKDTree
    from shapely import distance, get_coordinates, points, shortest_line
    from shapely.geometry.polygon import orient

    rounding = LARGER * float(thickness.min())
    turned = orient(plan.simplify(rounding))
    step = APART * float(thickness.min())
    starts, normals = map(np.concatenate, zip(*(_places(ring, step) for ring in _rings(turned)), strict=True))
    most = NARROW * thickness[cKDTree(nodes).query(starts)[1]]
    edge = turned.boundary

    def is_free(radius: Array, chosen: Flags) -> Flags:
        """Return which circles of these radii [m] that touch the edge at some places meet it nowhere else."""
        centers = starts[chosen] + radius[:, None] * normals[chosen]
        return np.asarray(distance(points(centers), edge) >= radius * (1 - LARGER))

    narrow = ~is_free(most, np.ones(len(starts), dtype=bool))
    low, high = np.zeros(narrow.sum()), most[narrow]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        free = is_free(middle, narrow)
        low, high = np.where(free, middle, low), np.where(free, high, middle)
    centers = starts[narrow] + high[:, None] * normals[narrow]
    others = get_coordinates(shortest_line(points(centers), edge)).reshape(-1, 2, 2)[:, 1]
    cosine = (-normals[narrow] * (others - centers)).sum(axis=1) / high
    across = (cosine < OPPOSITE) & (high > rounding)
    legs: Array = np.stack([starts[narrow], others], axis=1)[across]
    # both ends of a cut are places of the edge
    same = np.column_stack([legs.mean(axis=1), np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)])
    return legs[np.unique(np.round(same / rounding), axis=0, return_index=True)[1]]


def _rings(plan: Polygon) -> list[LinearRing]:
    """Return the closed curves around a plan."""
    return [plan.exterior, *plan.interiors]


def _places(ring: LinearRing, step: float) -> tuple[Array, Array]:
    """Return places along a closed curve with the plan to its left, (k, 2) [m], and the unit vectors into the plan."""
    from shapely import get_coordinates

    corners = get_coordinates(ring)
    along = np.diff(corners, axis=0)
    length = np.linalg.norm(along, axis=1)
    angles = np.degrees(np.arctan2(along[:, 1], along[:, 0]))
    starts, directions = [], []
    for (start, _), run, size, angle, before in zip(
        pairwise(corners), along, length, angles, np.roll(angles, 1), strict=True
    ):
        n = max(1, int(np.ceil(size / step)))
        starts.append(start + (np.arange(n)[:, None] + 0.5) / n * run)
        directions.append(np.full(n, angle))
        # to the left of a curve with the plan to its left, a turn to the right is a corner that points into the plan
        turn = (before - angle + 180) % 360 - 180
        if turn > TURN:
            fan = np.linspace(before, before - turn, int(np.ceil(turn / TURN)) + 1)
            starts.append(np.tile(start, (len(fan), 1)))
            directions.append(fan)
    left = np.radians(np.concatenate(directions) + 90)
    return np.concatenate(starts), np.column_stack([np.cos(left), np.sin(left)])
