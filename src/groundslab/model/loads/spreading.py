"""Line forces with a width, such as those on walls, as pressures on the areas about their lines."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.offsets import parallel
from groundslab.geometry.plan import Segment
from groundslab.model.loads.acting import LineForce, Pressure
from groundslab.model.loads.clipping import LinePiece, clip_line
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate
from groundslab.model.plates.region import PlateRegion, enclosing_line, get_plate_region

if TYPE_CHECKING:
    from shapely import Polygon

#: Arcs whose force varies are chords that turn by this angle [rad] at most: a tenth of a thousandth of the radius off
#: on average.
TURN = math.radians(2.0)


@lru_cache(maxsize=256)
def spread_line(
    plate: Plate, line: LineForce, plates: tuple[FurtherPlate, ...] = ()
) -> tuple[tuple[LinePiece, ...], tuple[tuple[Polygon, Pressure], ...]]:
    """Return the parts of a line force that lie on a plate, and those that have a width as pressures on areas.

    A pressure is linear across the width, with the force and the couple of the line. A part whose width does not lie on
    the plate entirely acts along its axis: of a force nothing is cut off.
    """
    pieces = clip_line(plate, line, plates)
    if not line.width:
        return tuple(pieces), ()
    region = get_plate_region(plate, plates)
    along: list[LinePiece] = []
    areas: list[tuple[Polygon, Pressure]] = []
    for piece in pieces:
        if _has_room(region, piece.edge, line.width):
            areas += _spread(piece, line.width)
        else:
            along.append(piece)
    return tuple(along), tuple(areas)


def lines_without_width(plate: Plate, line: LineForce, plates: tuple[FurtherPlate, ...] = ()) -> list[Segment]:
    """Return the edges along which a line force acts without being spread: section forces jump across them."""
    return [piece.edge for piece in spread_line(plate, line, plates)[0]] if line.width else [*line.edges]


def _has_room(region: PlateRegion, axis: Segment, width: float) -> bool:
    """Return whether a width about an edge lies on the plate, and within the radius of an arc."""
    from shapely import LineString

    if not axis.straight and axis.radius <= width / 2:
        return False
    faces = [parallel(axis, side * width / 2) for side in (-1.0, 1.0)]
    return all(region.grown.covers(LineString(enclosing_line(face))) for face in faces)


def _spread(piece: LinePiece, width: float) -> Iterator[tuple[Polygon, Pressure]]:
    """Yield areas with pressures that together make a piece of a line: one, of arcs that vary one for each chord."""
    edge = piece.edge
    if edge.straight:
        yield _band(edge, np.array([0.0, 1.0]), width), _pressure_across(edge, piece.q, piece.m, width)
        return
    parts = np.linspace(0, 1, max(2, math.ceil(abs(edge.sweep) / TURN)) + 1)
    if piece.q[0] == piece.q[1] and not any(piece.m):
        area = _band(edge, parts, width)
        yield area, Pressure(piece.force / area.area)
        return
    curvature = math.copysign(1 / edge.radius, edge.sweep)
    for low, high in itertools.pairwise(parts.tolist()):
        start, end = map(tuple, edge.at(np.array([low, high])).tolist())
        chord = Segment(start, end)
        longer = edge.length * (high - low) / chord.length
        q, m = (
            (longer * (ends[0] + (ends[1] - ends[0]) * low), longer * (ends[0] + (ends[1] - ends[0]) * high))
            for ends in (piece.q, piece.m)
        )
        yield _band(edge, np.array([low, high]), width), _pressure_across(chord, q, m, width, curvature)


def _band(edge: Segment, parts: Array, width: float) -> Polygon:
    """Return the area of a width about an edge, by the places after parts (p,) of it."""
    from shapely import Polygon

    axis, across = edge.at(parts), width / 2 * edge.left(parts)
    return Polygon(np.vstack([axis + across, (axis - across)[::-1]]))


def _pressure_across(
    edge: Segment, q: tuple[float, float], m: tuple[float, float], width: float, curvature: float = 0.0
) -> Pressure:
    """Return the pressure about a straight edge with its force per length q and its couple per length m.

    At n to the left of it p = a + b n, with q and m the sums of p and p n over the width. About the chord of an arc,
    which is longer at its outer side, these count 1 - curvature n times.
    """
    (dx, dy) = ((edge.end[k] - edge.start[k]) / edge.length for k in (0, 1))
    nx, ny = -dy, dx
    span = width * (1 - (curvature * width) ** 2 / 12)
    mean = [(force + curvature * couple) / span for force, couple in zip(q, m, strict=True)]
    tilt = [12 * couple / width**3 + curvature * a for couple, a in zip(m, mean, strict=True)]
    growth, bend = ((ends[1] - ends[0]) / edge.length for ends in (mean, tilt))
    slope = (growth * dx + tilt[0] * nx, growth * dy + tilt[0] * ny)
    second = (2 * bend * dx * nx, bend * (dx * ny + dy * nx), 2 * bend * dy * ny)
    return Pressure(mean[0], slope, second, edge.start)
