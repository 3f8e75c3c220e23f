"""Axes of walls along the edges of plates: inside by half the thickness, so that walls stand flush with the edge."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from groundslab.geometry.offsets import NoRoomError, counterclockwise, inset, parallel
from groundslab.geometry.plan import Place, Ring, Segment
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.settings import SIDES
from groundslab.model.shapes import AnyShape, Polygon
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.repairs import remove, set_value, use_nearest
from groundslab.schema.wording import describe, one_of, quote, suggestion

#: The words for edges.
WORDS = ("all", *SIDES)

_COUNTED = "edges are counted as the outline's points are, each from its point to the next"
_ALL = (set_value(("edge",), "all"),)

#: What bends by less than this over a corner goes straight on [rad].
STRAIGHT_ON = 1e-9


@dataclass(frozen=True, slots=True)
class EdgeLine:
    """The axis of a wall along the whole outline of a plate, a shape, or along one edge, a line from point to point."""

    shape: AnyShape | None
    points: tuple[Place, ...] | None = None
    bulges: tuple[float, ...] = ()


def edge_line(plates: Sequence[AnyPlate], plate: str, edge: int | str, thickness: float) -> EdgeLine:
    """Return the axis of a wall along an edge of a plate, the first one if none is named.

    It runs counterclockwise around the plate: the plate is to its left.

    Raises
    ------
    FieldError
        If there is no such plate or edge, or if the edge is too short or too tightly bent for the wall.
    """
    ring = _find_plate(plates, plate).ring()
    try:
        if edge == "all":
            inset(ring, thickness)  # its inner face
            beside = inset(ring, thickness / 2)
            return EdgeLine(Polygon(points=beside.points, bulges=beside.bulges))
        number = _find_edge(ring, edge)
        return _along_one(ring, number, thickness)
    except NoRoomError as error:
        raise FieldError(_too_thick(ring, error.number, thickness)) from None


def _find_plate(plates: Sequence[AnyPlate], name: str) -> AnyPlate:
    """Return the plate of a name, the first one if there is none; raises FieldError."""
    for plate in plates if name else plates[:1]:
        if not name or plate.name == name:
            return plate
    names = [plate.name for plate in plates if plate.name]
    expected = one_of(names) if names else "no plate, as none has a name"
    repairs = (*use_nearest(("plate",), name, names), remove(("plate",), label="remove plate"))
    raise FieldError(RelativeIssue(("plate",), describe(name), expected, suggestion(name, names), repairs))


def _find_edge(ring: Ring, edge: int | str) -> int:
    """Return the position of an edge of an outline, from 0; raises FieldError."""
    edges = ring.segments()
    if isinstance(edge, int):
        if edge <= len(edges):
            return edge - 1
        missing_edge, expected = f"edge {edge} of an outline with {len(edges)}", f"a number from 1 to {len(edges)}"
        raise FieldError(RelativeIssue(("edge",), missing_edge, expected, _COUNTED, _ALL))
    side = next(number for number, word in enumerate(SIDES) if word == edge)
    axis, limit = side // 2, ring.bounds[side]
    on_side = [
        number
        for number, segment in enumerate(edges)
        if segment.straight and segment.start[axis] == segment.end[axis] == limit
    ]
    if len(on_side) == 1:
        return on_side[0]
    count = "no straight edge" if not on_side else f"{len(on_side)} edges"
    unclear_side = f"{quote(edge)} of an outline with {count} on that side"
    expected = f'"all", or the number of an edge from 1 to {len(edges)}'
    raise FieldError(RelativeIssue(("edge",), unclear_side, expected, _COUNTED, _ALL))


def _along_one(ring: Ring, position: int, thickness: float) -> EdgeLine:
    """Return the axis along one edge, as long as the wall's ends stay on the plate; raises NoRoomError."""
    edges, number = counterclockwise(ring), position + 1
    step = 1 if ring.signed_area > 0 else -1
    before, edge, after = (edges[(position + turn) % len(edges)] for turn in (-step, 0, step))
    if not edge.straight:
        if edge.sweep > 0 and edge.radius <= thickness:
            raise NoRoomError(number)
        return _line_along(parallel(edge, thickness / 2))
    cut = [_overhang(first, other, thickness) for first, other in ((before, edge), (edge, after))]
    if sum(cut) >= edge.length:
        raise NoRoomError(number)
    axis = parallel(edge, thickness / 2)
    return _line_along(_shorten(axis, *cut) if any(cut) else axis)


def _line_along(edge: Segment) -> EdgeLine:
    bulges = () if edge.straight else (math.tan(edge.sweep / 4),)
    return EdgeLine(None, (edge.start, edge.end), bulges)


def _overhang(before: Segment, after: Segment, thickness: float) -> float:
    """Return by how much the square end of a wall would stand over the plate at an acute corner [m]."""
    turn = math.remainder(after.direction(0.0) - before.direction(1.0), 2 * math.pi)
    return thickness * math.tan(turn - math.pi / 2) if turn > math.pi / 2 + STRAIGHT_ON else 0.0


def _shorten(edge: Segment, at_start: float, at_end: float) -> Segment:
    """Return a straight edge without some length at both ends [m]."""
    (x0, y0), (x1, y1) = edge.start, edge.end
    a, b = at_start / edge.length, 1 - at_end / edge.length
    return Segment((x0 + a * (x1 - x0), y0 + a * (y1 - y0)), (x0 + b * (x1 - x0), y0 + b * (y1 - y0)))


def _too_thick(ring: Ring, number: int | None, thickness: float) -> RelativeIssue:
    """Return the issue of a wall for which an edge has no room, which the outline has not where no edge is named."""
    where = "the outline" if number is None else f"edge {number} of the outline"
    if number is not None and ring.is_rectangle:
        where = f"a plate of {' m x '.join(f'{side:.6g}' for side in ring.sides)} m"
    hint = "a wall stands inside the plate's edge, its outer face on it"
    return RelativeIssue(("thickness",), f"{thickness:.6g} m, for which {where} has no room", "a thinner wall", hint)
