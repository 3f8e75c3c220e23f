"""Where one-way shear begins beside walls and footprints: at d from them (EN 1992-1-1 6.2.1(8), ACI 318-19 7.4.3.2).

d counts from the face of a wall, and of a force with a footprint that is no column; of a line load without a width from
its axis.
Only what presses on the plate in a combination has such a part around it; beside a wall that pulls, shear counts up to
its axis (ACI 318-19 7.4.3.2(a)). Where several loads stand on a line, their sum decides, piece by piece. Line supports
have no width: d counts from their axis where they push up.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.loads.column_loads import column_of, factors_of
from groundslab.fem.mesh import Mesh, locate
from groundslab.geometry.plan import FLAT
from groundslab.model.loads.acting import LineForce, PointForce
from groundslab.model.loads.clipping import clip_line
from groundslab.model.model import Model
from groundslab.model.supports import LineSupport
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import LineString
    from shapely.geometry.base import BaseGeometry

#: Places along a piece of a line at which the depth of the plate is looked up.
SAMPLES = 5
#: Two lines closer than this lie on each other, as a share of the plate's largest side.
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Bearer:
    """A piece of a line or a footprint by which loads press on the plate, or a line support."""

    shape: BaseGeometry
    force: dict[str, Array]  # by load case: q at both ends of a line (2,) [N/m], P of a footprint (1,) [N]
    face: float = 0.0  # how far the face is from a line [m]
    support: int | None = None  # number of a line support, from 0

    def presses(self, results: CombinationResult, factors: dict[str, float]) -> bool:
        """Return whether the loads press on the plate in a combination, all along the piece, or the support does."""
        if self.support is not None:
            return results.supports[self.support].total > 0
        acting = sum((factors.get(case, 0.0) * value for case, value in self.force.items()), np.zeros(1))
        return bool(acting.min() >= 0 and acting.max() > 0)


def bearers(model: Model) -> list[Bearer]:
    """Return the pieces of lines that loads stand on, the footprints of forces on no column, and line supports."""
    return [*_lines(model), *_footprints(model), *_supports(model)]


def pressing(results: CombinationResult, every: list[Bearer]) -> tuple[int, ...]:
    """Return the positions of those that press on the plate in a combination."""
    factors = factors_of(results)
    return tuple(position for position, bearer in enumerate(every) if bearer.presses(results, factors))


def region_within_d(plate: PlateResult, bearing: list[Bearer], d: Array) -> BaseGeometry:
    """Return the part of the plan nearer than d to the faces of bearers, d (n,) [m] being the depth at the nodes.

    Of different depths along a shape the least one counts.
    """
    from shapely import line_merge, union_all

    mesh = Mesh(plate.nodes, plate.elements)
    by_reach: dict[float, list[BaseGeometry]] = {}
    for bearer in bearing:
        element, _ = locate(mesh, _samples(bearer.shape))
        under = mesh.elements[element[element >= 0]]
        if len(under):
            by_reach.setdefault(bearer.face + float(d[under].min()), []).append(bearer.shape)
    merged = ((reach, union_all(shapes)) for reach, shapes in by_reach.items())
    joined = ((reach, line_merge(shape) if shape.geom_type == "MultiLineString" else shape) for reach, shape in merged)
    return union_all([shape.buffer(reach, cap_style="flat", join_style="mitre") for reach, shape in joined])


def webs_of(model: Model) -> tuple[BaseGeometry, list[LineString]]:
    """Return what the webs of beams cover in plan, whose shear forces are the beams', and their axes."""
    from shapely import union_all

    chord = FLAT * max(model.sides)
    with_webs = [beam for beam in model.beams if beam.width]
    return union_all([beam.area(chord) for beam in with_webs]), [beam.to_shapely(chord) for beam in with_webs]


def _samples(shape: BaseGeometry) -> Array:
    """Return places (k, 2) [m] on a line, or the corners of a footprint and its middle."""
    from shapely import get_coordinates

    if shape.geom_type == "LineString":
        shares = (np.arange(SAMPLES) + 0.5) / SAMPLES
        places: Array = get_coordinates([shape.interpolate(share, normalized=True) for share in shares])
        return places
    return np.concatenate([get_coordinates(shape), get_coordinates(shape.centroid)])


def _lines(model: Model) -> Iterator[Bearer]:
    """Yield the lines of all line loads, cut where they meet, with the loads on each piece."""
    from shapely import LineString, STRtree, get_parts, union_all

    size = max(model.sides)
    loaded: list[tuple[str, LineString, tuple[float, float], float]] = []
    for load, shape in model.acting:
        if isinstance(shape, LineForce) and any(shape.q):
            for piece in clip_line(model.plate, shape, model.plates):
                n = piece.edge.chords(FLAT * size)
                loaded.append((load.case, LineString(piece.edge.at(np.arange(n + 1) / n)), piece.q, shape.width / 2))
    if not loaded:
        return
    tree = STRtree([line for _, line, _, _ in loaded])
    for part in get_parts(union_all([line for _, line, _, _ in loaded])):
        middle = part.interpolate(0.5, normalized=True)
        force = dict[str, Array]()
        on_it = [loaded[number] for number in tree.query(middle, predicate="dwithin", distance=SAME * size)]
        for case, line, q, _ in on_it:
            force[case] = force.get(case, np.zeros(2)) + _at_ends(part, line, q)
        yield Bearer(part, force, min(face for *_, face in on_it))


def _at_ends(part: LineString, line: LineString, q: tuple[float, float]) -> Array:
    """Return q (2,) [N/m] at both ends of a part of a line, linear between those of the line."""
    from shapely import get_point

    ways = np.array([line.project(get_point(part, end), normalized=True) for end in (0, -1)])
    return q[0] + (q[1] - q[0]) * ways


def _footprints(model: Model) -> Iterator[Bearer]:
    """Yield the footprints of forces that stand on no column, those at one place together."""
    chord = FLAT * max(model.sides)
    force: dict[bytes, Bearer] = {}
    for load, point in model.acting:
        if isinstance(point, PointForce) and point.ring is not None and not column_of(model, load):
            shape = point.to_shapely(chord)
            bearer = force.setdefault(shape.wkb, Bearer(shape, {}))
            bearer.force[load.case] = bearer.force.get(load.case, np.zeros(1)) + point.P
    yield from force.values()


def _supports(model: Model) -> Iterator[Bearer]:
    """Yield the line supports."""
    from shapely import LineString

    for number, support in enumerate(model.supports):
        if isinstance(support, LineSupport):
            yield Bearer(LineString(support.points), {}, support=number)
