"""Shear forces of beams at columns and supports: those at the distance d from a face, and those at the face itself.

Where a column or support presses on the face of a web opposite to the one at which the slab's load enters it, links are
those at d from its face (EN 1992-1-1 6.2.1(8), ACI 318-19 9.4.3.2): a support below a rib that lies below the slab, a
column on a rib above. Elsewhere all shear force up to the face counts. What the slab hands over beside a support makes
the beam's own shear force dip there, so that at a face it is that at d, and at its slope from there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import FLAT
from groundslab.model.model import Model
from groundslab.model.structure.beams import Beam, RibSection
from groundslab.model.structure.lines import flat_line
from groundslab.model.structure.walls import WallPiece
from groundslab.model.supports import LineSupport
from groundslab.results.records import BeamResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: The slope at d is that over this share of it.
OVER = 0.5
#: A shear force that is larger than its slope says by this share of it has met another force.
SLACK = 0.02
#: Places so close, relative to a beam's length, are one.
NEAR = 1e-6


@dataclass(frozen=True, slots=True)
class Faces:
    """A column or support on a beam: ways [m] to its faces, and whether it is direct, so that d counts from them."""

    low: float
    high: float
    direct: bool


def faces_on(model: Model, beam: Beam, length: float) -> list[Faces]:
    """Return what a beam of a length [m] meets, columns, supports, walls and other beams, and its ends without any."""
    side = beam.section.side if isinstance(beam.section, RibSection) else ""
    chord = FLAT * max(model.sides)
    axis = beam.to_shapely(chord)
    near = NEAR * axis.length
    faces = []
    for shape, direct in _shapes(model, beam, side, chord, near):
        met = axis.intersection(shape)
        # a line along the beam is no place of its own
        if met.is_empty or (shape.area == 0 and met.length > near):
            continue
        ways = [axis.project(place) for part in getattr(met, "geoms", [met]) for place in _ends(part)]
        low, high = (float(way) * length / axis.length for way in (min(ways), max(ways)))
        faces.append(Faces(low, high, direct))
    if not beam.closed:
        faces += [Faces(end, end, direct=False) for end in (0.0, length)
                  if not any(face.low - near <= end <= face.high + near for face in faces)]  # fmt: skip
    return sorted(faces, key=lambda face: face.low)


def _shapes(model: Model, beam: Beam, side: str, chord: float, near: float) -> Iterator[tuple[BaseGeometry, bool]]:
    """Yield what a beam on a side of the plate may meet, and whether it lies between the plate and that."""
    from shapely import LineString, Point

    for column in model.columns:
        yield column.to_shapely(chord), side == "above"
    for support in model.supports:
        if isinstance(support, LineSupport):
            yield LineString(support.points), side == "below"
        else:
            yield Point(support.x, support.y).buffer(max((support.diameter or 0.0) / 2, near)), side == "below"
    others: list[Beam | WallPiece] = [*model.beams, *(piece for wall in model.placed_walls for piece in wall.pieces)]
    for other in others:
        if other is not beam:
            yield flat_line(other.edges, chord), False


def _ends(part: BaseGeometry) -> list[BaseGeometry]:
    """Return both ends of a line, or a point."""
    from shapely import Point

    return [Point(part.coords[0]), Point(part.coords[-1])]


def shear_forces(beam: BeamResult, part: BeamResult, faces: list[Faces], d: float) -> tuple[Array, Array]:
    """Return the sizes of shear forces [N] that links carry, and those that struts bear, at the places (k,) of a part.

    The part has places of the beam at least d [m] from its ends. What struts bear at a face is told up to d off.
    """
    links = np.abs(part.shear)
    struts, raw = links.copy(), links.copy()
    first, last = part.way[[0, -1]]
    near = NEAR * beam.way[-1]
    for number, support in enumerate(faces):
        middle = (support.low + support.high) / 2
        for face, away, beside in ((support.low, -1.0, number - 1), (support.high, 1.0, number + 1)):
            at = face + away * d
            # at ends part begins a quarter of the length of a short beam from it
            at = first if face <= 0 < away else last if face >= beam.way[-1] and away < 0 else at
            next_one = faces[beside] if 0 <= beside < len(faces) else None
            met = next_one is not None and away * (at - (next_one.low if away > 0 else next_one.high)) > 0
            if met or not first - near <= at <= last + near:
                continue
            beyond = float(np.clip(at + away * OVER * d, first, last))
            V, further = np.abs(beam.at(np.sort([at, beyond])).shear)[:: int(away)]
            step = abs(beyond - at)
            V_face = V + (max(V - further, 0.0) / step * abs(at - face) if step > near else 0.0)
            inside = (away * (part.way - middle) >= -near) & (away * (part.way - at) < -near)
            outside = inside & (away * (part.way - face) > near)
            alone = raw[outside].max(initial=0.0) <= (1 + SLACK) * V_face
            # the place at d, or the one nearest to it, has what is told there
            here = inside.copy()
            here[np.argmin(np.abs(part.way - at))] = True
            struts[here] = np.maximum(struts[here], V_face)
            if support.direct and alone:
                links[inside] = np.minimum(links[inside], V)
                links[here & ~inside] = np.maximum(links[here & ~inside], V)
                links[outside] = V
            else:
                links[here] = np.maximum(links[here], V_face)
    return links, struts
