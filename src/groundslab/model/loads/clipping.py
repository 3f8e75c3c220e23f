"""Loads clipped at the edge of the plate.

Areas and lines may extend beyond the plate's edge or over openings; only what lies on the plate acts, and the rest is
reported. Of a load on the ground only what lies beside the plate acts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Segment, bounding_box
from groundslab.model.loads.acting import AreaPressure, LineForce
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import AnyLoad, Spread
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, list_plates
from groundslab.model.plates.region import NO_PART, PlateRegion, get_plate_region, parts_on_plates
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.wording import quote
from groundslab.units import together

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: A line no farther off a member over an opening than this share of its span acts on it.
ON_SPAN = 1e-4
#: A load that reaches further off the plate than so many times its longer side was not meant so.
FAR = 1e3


@dataclass(frozen=True, slots=True)
class Clipped:
    """The part of a load off the plate, or of a load on the ground that lies under the plate: it does not act."""

    number: int  # of the load, from 1
    name: str
    case: str
    share: float  # of its area or length
    force: float  # [N], of a line moment its couples [N m]
    drawn: float  # of all that is drawn
    where: str  # "off the plate", or "under the plate"
    dimension: str = "force"

    def words(self) -> str:
        """Return a remark for the report."""
        name = f" {quote(self.name)}" if self.name else ""
        (force, drawn), unit = together([self.force, self.drawn], self.dimension)
        return (
            f"loads[{self.number}]{name}: {100 * self.share:.3g} % of it lies {self.where}; "
            f"{force} {unit} of {drawn} {unit} do not act"
        )


@dataclass(frozen=True, slots=True)
class LinePiece:
    """A part of a line force that lies on the plate, all along one edge."""

    edge: Segment
    q: tuple[float, float]  # at its start and its end, linear between [N/m]
    m: tuple[float, float]  # couple per length [N m/m]

    @property
    def force(self) -> float:
        """Return the force [N]."""
        return self.edge.length * sum(self.q) / 2

    @property
    def couple(self) -> float:
        """Return the sum of its couples [N m], whatever their directions."""
        return self.edge.length * sum(self.m) / 2


def find_clipped_loads(
    plate: Plate,
    loads: Sequence[AnyLoad],
    plates: tuple[FurtherPlate, ...] = (),
    walls: tuple[Wall, ...] = (),
    spans: Sequence[Segment] = (),
) -> tuple[Clipped, ...]:
    """Return the parts of loads off all plates and spans of members, of loads on the ground those under a plate."""
    drawn = _drawn_shapes(loads, place_walls(walls, list_plates(plate, plates)))
    region = get_plate_region(plate, plates)
    clipped = [*_find_clipped(region, drawn, spans), *_find_covered(region, drawn)]
    return tuple(sorted(clipped, key=lambda part: part.number))


def check_distributed_loads(
    plate: Plate, plates: tuple[FurtherPlate, ...], loads: tuple[AnyLoad, ...], walls: tuple[Wall, ...]
) -> Iterator[RelativeIssue]:
    """Find areas and lines that lie off the plate entirely, or reach too far off it."""
    import shapely

    expected = "a load at least partly on the plate, not in an opening or outside the outline"
    placed = place_walls(walls, list_plates(plate, plates))
    drawn = [part for part in _drawn_shapes(loads, placed) if not part.on_ground]
    if not drawn:
        return
    region = get_plate_region(plate, plates)
    (x0, x1, y0, y1), far = region.bounds, FAR * region.size
    reach = shapely.bounds([part.covered for part in drawn])
    near = (reach[:, :2] >= (x0 - far, y0 - far)).all(axis=1) & (reach[:, 2:] <= (x1 + far, y1 + far)).all(axis=1)
    for k in np.flatnonzero(~near):
        yield RelativeIssue(("loads", drawn[int(k)].position), "a load that reaches far off the plate", expected)
    for clipped in _find_clipped(region, [drawn[int(k)] for k in np.flatnonzero(near)]):
        if clipped.share >= 1 - NO_PART:
            yield RelativeIssue(("loads", clipped.number - 1), "a load off the plate", expected)


def clip_line(plate: AnyPlate, line: LineForce, plates: tuple[FurtherPlate, ...] = ()) -> list[LinePiece]:
    """Return the parts of a line force that lie on a plate."""
    return _clip_line(get_plate_region(plate, plates), line)


def _clip_line(region: PlateRegion, line: LineForce) -> list[LinePiece]:
    """Return the parts of a line force that lie in a region."""
    return [
        _piece(line, number, low, high)
        for number, edge in enumerate(line.edges)
        for low, high in parts_on_plates(region, edge)
    ]


def _piece(line: LineForce, number: int, low: float, high: float) -> LinePiece:
    """Return the part of a line force on one of its edges from low to high, 0 to 1 of that edge."""
    edge = line.edges[number]
    start = sum(before.length for before in line.edges[:number])

    def between(ends: tuple[float, float]) -> tuple[float, float]:
        growth = (ends[1] - ends[0]) / line.length
        return ends[0] + growth * (start + low * edge.length), ends[0] + growth * (start + high * edge.length)

    return LinePiece(_cut_segment(edge, low, high), between(line.q), between(line.m))


def pieces_on_spans(line: LineForce, spans: Sequence[Segment]) -> list[tuple[int, LinePiece]]:
    """Return what of a line force acts on spans of members over openings: the number of each span, and a piece of it.

    A piece runs along its span.
    """
    pieces = []
    for number, edge in enumerate(line.edges if spans else ()):
        for position, span in enumerate(spans):
            part = _shared_part(edge, span) if edge.straight else None
            if part is None:
                continue
            piece = _piece(line, number, *part)
            if np.subtract(edge.end, edge.start) @ np.subtract(span.end, span.start) < 0:
                (q_1, q_2), (m_1, m_2) = piece.q, piece.m
                piece = LinePiece(Segment(piece.edge.end, piece.edge.start), (q_2, q_1), (-m_2, -m_1))
            pieces.append((position, piece))
    return pieces


def _shared_part(edge: Segment, span: Segment) -> tuple[float, float] | None:
    """Return the part of a straight edge, from 0 to 1, that lies on a span, None if there is none."""
    ends = np.array([edge.start, edge.end])
    way = np.subtract(span.end, span.start)
    L = np.hypot(*way)
    along, across = (ends - span.start) @ way / L, (ends - span.start) @ (-way[1], way[0]) / L
    if abs(along[1] - along[0]) <= NO_PART * L:
        return None
    cuts = np.clip((np.array([0.0, L]) - along[0]) / (along[1] - along[0]), 0.0, 1.0)
    low, high = float(cuts.min()), float(cuts.max())
    off = np.abs(across[0] + np.array([low, high]) * (across[1] - across[0])).max()
    return (low, high) if off <= ON_SPAN * L and (high - low) * edge.length > NO_PART * L else None


@dataclass(frozen=True, slots=True)
class _Drawn:
    """An area or a line as drawn, with the load that it belongs to."""

    position: int  # of the load, from 0
    load: AnyLoad
    shape: AreaPressure | LineForce
    covered: BaseGeometry  # what it covers; of arcs of lines a box around them

    @property
    def on_ground(self) -> bool:
        """Whether it presses on the ground beside the plate."""
        return isinstance(self.shape, AreaPressure) and self.shape.on == "ground"


def _drawn_shapes(loads: Sequence[AnyLoad], walls: tuple[Wall, ...]) -> list[_Drawn]:
    """Return the areas and lines of loads, but for those on walls that are unknown; walls with all of their axes."""
    wall_names = {wall.name for wall in walls}
    walls = tuple(wall.model_copy(update={"openings": ()}) for wall in walls)
    return [
        _Drawn(
            position,
            load,
            shape,
            shape.to_shapely(math.inf)
            if not isinstance(shape, LineForce) or shape.straight
            else bounding_box(shape.edges),
        )
        for position, load in enumerate(loads)
        if isinstance(load, Spread) and getattr(load, "wall", "") in {"", *wall_names}
        for shape in (load.acts_on(walls) if isinstance(load, LineLoad | LineMoment) else load.acts)
    ]


def _find_clipped(region: PlateRegion, drawn: Sequence[_Drawn], spans: Sequence[Segment] = ()) -> Iterator[Clipped]:
    """Yield what lies off the plate, and off spans of members, of loads on it."""
    import shapely

    on_plate = [part for part in drawn if not part.on_ground]
    if not on_plate:
        return
    for k in np.flatnonzero(~shapely.covers(region.grown, [part.covered for part in on_plate])):
        part = on_plate[int(k)]
        shape = part.shape
        off = (
            _off_line(region, shape, spans) if isinstance(shape, LineForce) else _off_area(region, shape, part.covered)
        )
        if off is not None:
            share, force, total = off
            dimension = "moment" if isinstance(shape, LineForce) and not any(shape.q) else "force"
            number = part.position + 1
            yield Clipped(number, part.load.name, part.load.case, share, force, total, "off the plate", dimension)


def _find_covered(region: PlateRegion, drawn: Sequence[_Drawn]) -> Iterator[Clipped]:
    """Yield what lies under the plate of loads on the ground."""
    for part in drawn:
        if isinstance(part.shape, AreaPressure) and part.on_ground:
            pressure = part.shape.pressure
            under = part.covered.intersection(region.area)
            share = under.area / part.covered.area
            if share > NO_PART:
                force = integral(under, pressure)
                total = integral(part.covered, pressure)
                yield Clipped(part.position + 1, part.load.name, part.load.case, share, force, total, "under the plate")


def _off_area(region: PlateRegion, area: AreaPressure, drawn: BaseGeometry) -> tuple[float, float, float]:
    """Return the share of an area that lies off the plate, the force there and in all [N]."""
    off = drawn.difference(region.area)
    return off.area / drawn.area, integral(off, area.pressure), integral(drawn, area.pressure)


def _off_line(region: PlateRegion, line: LineForce, spans: Sequence[Segment]) -> tuple[float, float, float] | None:
    """Return the share of a line that lies off the plate, the force there and in all [N]; None if all is on it.

    Of a line without a force its couples [N m] count.
    """
    pieces = [*_clip_line(region, line), *(piece for _, piece in pieces_on_spans(line, spans))]
    share = 1 - sum(piece.edge.length for piece in pieces) / line.length
    if share <= NO_PART:
        return None
    if any(line.q):
        total = line.length * sum(line.q) / 2
        return share, total - sum(piece.force for piece in pieces), total
    total = line.length * sum(line.m) / 2
    return share, total - sum(piece.couple for piece in pieces), total


def integral(area: BaseGeometry, pressure: Callable[[Array], Array]) -> float:
    """Return the integral of a function of places, cubic in x and y at most, over polygons: of a pressure its force."""
    from shapely import get_coordinates, get_parts

    force = 0.0
    for part in get_parts(area):
        if part.geom_type != "Polygon":
            continue
        for sign, ring in ((1.0, part.exterior), *((-1.0, hole) for hole in part.interiors)):
            # triangles with the first point; corners, middles of sides and center are exact for cubic functions
            at = get_coordinates(ring)
            a, b = at[:-1] - at[0], at[1:] - at[0]
            twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
            corners = at[0] + np.stack([0 * a, a, b], axis=1)
            middles = at[0] + np.stack([a, b, a + b], axis=1) / 2
            center = at[0] + (a + b) / 3
            mean = (
                pressure(corners).sum(axis=1) / 20 + pressure(middles).sum(axis=1) * 2 / 15 + pressure(center) * 9 / 20
            )
            force += sign * math.copysign(1.0, twice.sum()) * float(twice @ mean) / 2
    return force


def _cut_segment(edge: Segment, low: float, high: float) -> Segment:
    """Return a part of an edge."""
    start, end = map(tuple, edge.at(np.array([low, high])).tolist())
    if edge.straight:
        return Segment(start, end)
    return replace(edge, start=start, end=end, angle=edge.angle + low * edge.sweep, sweep=(high - low) * edge.sweep)
