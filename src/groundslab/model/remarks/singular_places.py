"""Where moments and shear forces grow without limit as the mesh is refined."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np

from groundslab.arrays import Array, Flags, made_once
from groundslab.geometry.plan import FLAT, Place, Ring, numbers_within
from groundslab.messages import Message, joined
from groundslab.model.loads.acting import LineForce, PointForce

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.model.plate import Plate
    from groundslab.model.plates.other_plates import AnyPlate

#: Within so many thicknesses of them section forces are reported as means over a width.
REACH = 1.0
#: What is said beside that of forces.
FINITE = "The moment under a force is finite if the force has a footprint."


def near_singular(model: Model, nodes: Array, thickness: Array) -> Flags:
    """Return which nodes (n, 2) lie within a thickness (n,) [m] of a singular place."""
    return near_places([place for places in singular_places(model).values() for place in places], nodes, thickness)


def near_places(places: Sequence[Place], nodes: Array, thickness: Array) -> Flags:
    """Return which nodes (n, 2) lie within a thickness (n,) [m] of one of some places."""
    near = np.zeros(len(nodes), dtype=bool)
    reach = REACH * thickness * (1 + 1e-9)
    most = reach.max(initial=0.0)
    for x, y in places:
        inside = numbers_within(nodes, (x - most, x + most, y - most, y + most))
        near[inside[np.linalg.norm(nodes[inside] - (x, y), axis=1) <= reach[inside]]] = True
    return near


def notes_on_singular_places(model: Model, mark: str = "") -> tuple[str, ...]:
    """Return the note on the places where section forces are singular, and on their mark; empty without such places."""
    places = singular_places(model)
    what = joined(Message("{kind} ({number})", kind=kind, number=len(of_kind)) for kind, of_kind in places.items())
    singular = Message(
        "Moments and shear forces are singular{mark} at {places}: within a thickness of these they are means over a "
        "disc whose diameter is the thickness.",
        mark=mark,
        places=what,
    )
    return (joined((singular, FINITE), " "),) if places else ()


@made_once
def singular_places(model: Model) -> dict[str, list[Place]]:
    """Return the places at which moments have no limit, by what is there.

    Forces and supports without a footprint, the ends and bends of line loads and line supports, the ends of beams, and
    corners: those that point into the plate, those of zones of other thickness or material, where the border of such a
    zone meets the plate's edge, and corners between a clamped and a free edge (Williams 1952).
    """
    plates = model.every_plate
    ends = [*_kinks_of_lines(model)]
    ends += [place for support in model.supports if support.edges for place in support.points]
    corners = [*_between_edges(model.plate)]
    for plate in plates:
        corners += corners_of(plate.ring(), 1)
        corners += [place for opening in plate.openings for place in corners_of(opening.ring(), -1)]
        corners += [place for zone in plate.zones for place in _corners_of_zone(zone.shape.ring(), plate)]
    by_kind = {
        "forces without a footprint": [*forces_without_footprint(model)],
        "point supports": [support.points[0] for support in model.supports if not support.edges],
        "ends and bends of lines": ends,
        "ends of beams": [place for beam in model.members for place in beam.ends],
        "corners": corners,
    }
    return {what: places for what, places in by_kind.items() if places}


def forces_without_footprint(model: Model) -> Iterator[Place]:
    """Yield where forces without a footprint act."""
    for _, shape in model.acting:
        if isinstance(shape, PointForce) and shape.ring is None:
            yield shape.place


def kinks_of_loads(model: Model) -> Iterator[Place]:
    """Yield where forces without a footprint act, and where line loads end or bend: what carries them has a kink."""
    yield from forces_without_footprint(model)
    yield from _kinks_of_lines(model)


def _kinks_of_lines(model: Model) -> Iterator[Place]:
    """Yield where line loads end or bend, but for ends where the next one goes on the same in its load case."""
    lines = [(load.case, shape) for load, shape in model.acting if isinstance(shape, LineForce)]
    starts, ends = (Counter((case, *_at_end(line, end)) for case, line in lines) for end in (0, -1))
    continued = {place for _, place, *_ in starts & ends}
    kinks = {place for _, place, *_ in (starts - ends) | (ends - starts)}
    kinks |= {place for _, line in lines for place in line.corners[0 if line.closed else 2 :]}
    for _, line in lines:
        yield from (place for place in line.corners if place in kinks or place not in continued)


def _at_end(line: LineForce, end: Literal[0, -1]) -> tuple[object, ...]:
    """Return the place of a line's start (0) or end (-1), and all in which a line that goes on there is the same."""
    edge = line.edges[end]
    place, direction = (edge.end, edge.direction(1.0)) if end else (edge.start, edge.direction(0.0))
    return place, round(direction, 6), line.q[end], line.m[end], line.width


def _between_edges(plate: Plate) -> Iterator[Place]:
    """Yield the corners between a clamped and a free edge."""
    x0, x1, y0, y1 = plate.bounds
    edges = plate.edges
    for x, upright in ((x0, edges.left), (x1, edges.right)):
        for y, level in ((y0, edges.bottom), (y1, edges.top)):
            if {upright, level} == {"clamped", "free"}:
                yield x, y


def _corners_of_zone(ring: Ring, plate: AnyPlate) -> Iterator[Place]:
    """Yield the corners of a zone that lie on the plate, and where its border meets the plate's edges."""
    import shapely

    chord = FLAT * max(plate.sides)
    edges = shapely.union_all([edge.polygon(chord).exterior for edge in plate.rings()])
    sheet = plate.ring().polygon(chord).buffer(chord)
    for place in corners_of(ring, None):
        if sheet.intersects(shapely.Point(place)):
            yield place
    for part in shapely.get_parts(ring.polygon(chord).exterior.intersection(edges)):
        yield from ((float(x), float(y)) for x, y in shapely.get_coordinates(part.boundary if part.length else part))


def corners_of(ring: Ring, side: int | None) -> Iterator[Place]:
    """Yield the corners between straight edges: those that point into the plate, or all of them.

    The plate lies inside the curve (side 1), outside (-1) or on both sides (None).
    """
    turn = (side or 1) * np.sign(ring.signed_area)
    edges = ring.segments()
    for before, after in zip((edges[-1], *edges[:-1]), edges, strict=True):
        if before.straight and after.straight:
            (ax, ay), (bx, by) = (np.subtract(edge.end, edge.start) for edge in (before, after))
            sine = turn * (ax * by - ay * bx) / (np.hypot(ax, ay) * np.hypot(bx, by))
            if sine < -1e-9 or (side is None and sine > 1e-9):
                yield after.start
