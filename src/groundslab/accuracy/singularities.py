"""Where moments, shear forces and pressures have no limit as the mesh is refined, or jump."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.geometry.plan import Place, Ring, Segment
from groundslab.model.loads.load_types import LineLoad
from groundslab.results.result_mesh import load_borders

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags
    from groundslab.model.model import Model

#: Values are judged so many thicknesses away from there.
AWAY = 1.0
#: Arcs are replaced by chords that are off by this share of that distance.
CHORD = 0.02


@dataclass(frozen=True, slots=True)
class Limits:
    """At which nodes values have a limit as the mesh is refined and are judged, (n,) each."""

    moments: Flags
    shear_forces: Flags
    pressures: Flags


def find_limits(model: Model, nodes: Array, in_contact: Flags) -> Limits:
    """Return at which nodes (n, 2) values have a limit as the mesh is refined.

    Moments and shear forces have none at forces and supports without a footprint, at the ends and bends of line loads
    and line supports, and at corners: those that point into the plate, those of zones of other thickness or material,
    those between a clamped and a free edge (Williams 1952), and all where ground with shear continues beyond the plate.
    Shear forces under footprints have one, but no meaning in design, where punching is checked instead. Pressures on
    ground without shear follow the settlement; with shear they jump where loads, lines, zones and voids begin, and
    where the plate lifts off.
    """
    import shapely
    from scipy.spatial import KDTree

    reach = AWAY * model.plate.thickness

    def near(*edges: Segment) -> Flags:
        if not edges:
            return np.zeros(len(nodes), dtype=bool)
        lines = [edge.at(np.arange(n + 1) / n) for edge in edges for n in [edge.chords(CHORD * reach)]]
        return _near(nodes, shapely.multilinestrings([shapely.linestrings(each) for each in lines]), reach)

    moments = ~_near(nodes, shapely.multipoints(np.array([*_singular_places(model)]).reshape(-1, 2)), reach)
    footprints = [edge for load in model.loads if load.kind == "point" for edge in load_borders(load, model)]
    shear_forces = moments & ~near(*footprints)
    if not model.ground_carries_shear:
        return Limits(moments, shear_forces, np.ones(len(nodes), dtype=bool))
    lifted = np.zeros(len(nodes), dtype=bool)
    if not in_contact.all():
        lifted = KDTree(nodes[~in_contact]).query(nodes, distance_upper_bound=reach)[0] <= reach
    return Limits(moments, shear_forces, shear_forces & ~near(*_creases(model)) & ~lifted)


def _near(nodes: Array, shape: object, reach: float) -> Flags:
    """Return which nodes (n, 2) are within reach [m] of a shape of shapely."""
    import shapely

    shapely.prepare(shape)
    found: Flags = shapely.dwithin(shapely.points(nodes), shape, reach)
    return found


def _singular_places(model: Model) -> Iterator[Place]:
    """Yield the places at which moments and shear forces have no limit."""
    plate = model.plate
    for load in model.loads:
        if load.kind == "point":
            own = load.on(model.columns)
            if own.width_x is None and own.diameter is None:
                assert own.x is not None
                assert own.y is not None
                yield own.x, own.y
        elif isinstance(load, LineLoad) and load.points is not None:
            yield from load.points
    for support in model.supports:
        yield from [(support.x, support.y)] if support.kind == "point" else support.points
    any_corner = model.ground_reaches
    yield from _corners(plate.ring(), None if any_corner else 1)
    for opening in plate.openings:
        yield from _corners(opening.ring(), None if any_corner else -1)
    for zone in plate.zones:
        yield from _corners(zone.shape.ring(), None)
    x0, x1, y0, y1 = plate.bounds
    edges = plate.edges
    for x, upright in ((x0, edges.left), (x1, edges.right)):
        for y, level in ((y0, edges.bottom), (y1, edges.top)):
            if {upright, level} == {"clamped", "free"}:
                yield x, y


def _corners(ring: Ring, side: int | None) -> Iterator[Place]:
    """Yield the corners between straight edges: those that point into the plate, or all of them.

    The plate lies inside the curve (side 1), outside (-1) or on both sides (None).
    """
    turn = (side or 1) * np.sign(ring.signed_area)
    edges = ring.segments()
    for before, after in zip((edges[-1], *edges[:-1]), edges, strict=True):
        if before.straight and after.straight:
            (ax, ay), (bx, by) = (np.subtract(each.end, each.start) for each in (before, after))
            sine = turn * (ax * by - ay * bx) / (np.hypot(ax, ay) * np.hypot(bx, by))
            if sine < -1e-9 or (side is None and sine > 1e-9):
                yield after.start


def _creases(model: Model) -> Iterator[Segment]:
    """Yield the lines along which the pressure of ground with shear jumps or has no limit."""
    for load in model.loads:
        yield from load_borders(load, model)
    for support in model.supports:
        if support.kind == "line":
            yield from (Segment(start, end) for start, end in pairwise(support.points))
    plate, soil, voids = model.plate.zones, model.soil_zones, model.contact.voids
    for ring in (
        *(zone.shape.ring() for zone in plate),
        *(zone.shape.ring() for zone in soil),
        *(v.ring() for v in voids),
    ):
        yield from ring.segments()
