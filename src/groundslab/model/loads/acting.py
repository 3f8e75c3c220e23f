"""What acts on slabs and on the ground: a few shapes, of which every load is made.

Nodal forces, symmetry, meshes, singular places and drawings read these shapes and no kinds of loads.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, assert_never

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.areas import equal_area_polygon, inertia
from groundslab.geometry.plan import Place, Ring, Segment

if TYPE_CHECKING:
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

Surface = Literal["plate", "ground"]

#: Edges that meet at a smaller angle [rad] run on smoothly.
SMOOTH = 1e-6


@dataclass(frozen=True, slots=True)
class Pressure:
    """A pressure [Pa], downwards positive, at most quadratic in x and y."""

    q: float  # at `about`
    slope: tuple[float, float] = (0.0, 0.0)  # growth along x and y [Pa/m]
    bend: tuple[float, float, float] = (0.0, 0.0, 0.0)  # second derivatives by xx, xy, yy [Pa/m2]
    about: Place = (0.0, 0.0)

    @property
    def constant(self) -> bool:
        """Whether the pressure is the same everywhere."""
        return not any(self.slope) and not any(self.bend)

    def __call__(self, places: Array) -> Array:
        """Return the pressure at places (..., 2) [m]."""
        if self.constant:
            return np.full(places.shape[:-1], self.q)
        xx, xy, yy = self.bend
        r = places - np.array(self.about)
        x = r[..., 0]
        y = r[..., 1]
        q: Array = self.q + r @ np.array(self.slope) + (xx * x * x + 2 * xy * x * y + yy * y * y) / 2
        return q


@dataclass(frozen=True, slots=True)
class PointForce:
    """A force [N], downwards positive, with couples [N m], at a place or spread over a footprint."""

    place: Place
    P: float
    M: tuple[float, float]  # M_x, M_y: positive if they press the side of larger x, or y, down
    ring: Ring | None = None  # around the footprint

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the footprint, or the point; arcs as chords at most so far off [m]."""
        from shapely import Point

        return Point(self.place) if self.ring is None else self.ring.polygon(chord)

    def pressure(self, footprint: Polygon) -> Pressure:
        """Return the pressure on the footprint: uniform by the force, linear by the couples."""
        center, moments_of_area = inertia(footprint)
        slope_x, slope_y = np.array(self.M) @ np.linalg.inv(moments_of_area)
        return Pressure(self.P / footprint.area, (float(slope_x), float(slope_y)), about=(center[0], center[1]))


@dataclass(frozen=True, slots=True)
class LineForce:
    """A force and a couple per length along edges, one after the other, both linear from the start to the end."""

    edges: tuple[Segment, ...]
    q: tuple[float, float] = (0.0, 0.0)  # at start and end [N/m], downwards positive
    m: tuple[float, float] = (0.0, 0.0)  # [N m/m], positive if it presses what lies to the left down
    width: float = 0.0  # across the line, over which they are spread [m]
    wall: str = field(default="", compare=False)  # name of the wall through which it acts
    start: float = field(default=0.0, compare=False)  # how far along that wall it begins [m]

    @property
    def length(self) -> float:
        """The length of all edges [m]."""
        return sum(edge.length for edge in self.edges)

    @property
    def straight(self) -> bool:
        """Whether no edge is an arc."""
        return all(edge.straight for edge in self.edges)

    @property
    def closed(self) -> bool:
        """Whether the line ends where it starts."""
        return math.dist(self.edges[0].start, self.edges[-1].end) <= SMOOTH * self.length

    @property
    def ring(self) -> Ring:
        """The curve along a closed line."""
        return Ring(tuple(edge.start for edge in self.edges), tuple(math.tan(edge.sweep / 4) for edge in self.edges))

    @property
    def corners(self) -> tuple[Place, ...]:
        """The ends of the line, and where it bends."""
        joints = list(zip(self.edges, self.edges[1:], strict=False))
        if self.closed:
            joints.append((self.edges[-1], self.edges[0]))
        ends = () if self.closed else (self.edges[0].start, self.edges[-1].end)
        return (*ends, *(after.start for before, after in joints if _bends(before, after)))

    def flat(self, chord: float) -> Array:
        """Return places (p, 2) along the line from its start to its end, arcs as chords at most so far off [m]."""
        parts = [edge.at(np.arange(n) / n) for edge in self.edges for n in (edge.chords(chord),)]
        return np.concatenate([*parts, [self.edges[-1].end]])

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the line, arcs as chords at most so far off [m]."""
        from shapely import LineString

        return LineString(self.flat(chord))


def _bends(before: Segment, after: Segment) -> bool:
    """Return whether a line bends from one edge to the next."""
    turn = after.direction(0.0) - before.direction(1.0)
    return abs(math.remainder(turn, 2 * math.pi)) > SMOOTH


@dataclass(frozen=True, slots=True)
class AreaPressure:
    """A pressure on an area of the plate, or of the ground's surface beside the plate."""

    rings: tuple[Ring, ...]  # around the area, then around its holes
    pressure: Pressure
    on: Surface = "plate"

    def to_shapely(self, chord: float = math.inf) -> BaseGeometry:  # noqa: ARG002
        """Return the loaded area, its arcs as chords that enclose the same area."""
        from shapely import union_all

        return union_all(loaded_parts(*self.rings))


def loaded_parts(around: Ring, *holes: Ring) -> list[Polygon]:
    """Return the polygons of an area without its holes; arcs as chords that enclose the same area."""
    from shapely import get_parts, union_all

    area = equal_area_polygon(around)
    if not holes:
        return [area]
    rest = area.difference(union_all([equal_area_polygon(hole) for hole in holes]))
    return [part for part in get_parts(rest) if part.geom_type == "Polygon" and part.area > 0]


@dataclass(frozen=True, slots=True)
class PlateAction:
    """What acts all over a plate, on every plate if none is named."""

    plate: str
    pressure: Pressure = Pressure(0.0)
    unit_weight: float = 0.0  # [N/m3]
    temperature: float = 0.0  # of the bottom face less that of the top face [K]
    shrinkage: float = 0.0  # of the top face less that of the bottom face [-]

    @property
    def presses(self) -> bool:
        """Whether there is a pressure beside weight and strains."""
        return self.pressure != Pressure(0.0)


@dataclass(frozen=True, slots=True)
class SupportSettlement:
    """A settlement [m] that is forced on a support."""

    support: str
    w: float


Acting = PointForce | LineForce | AreaPressure | PlateAction | SupportSettlement


def borders_of(shape: Acting) -> Iterator[Segment]:
    """Yield the lines along which a shape begins, ends or stands."""
    if isinstance(shape, LineForce):
        yield from shape.edges
    yield from (edge for ring in rings_of(shape) for edge in ring.segments())


def rings_of(shape: Acting) -> tuple[Ring, ...]:
    """Return the curves around what a shape acts on, none of one all over the plate, on a line or at a point."""
    if isinstance(shape, AreaPressure):
        return shape.rings
    if isinstance(shape, PointForce):
        return () if shape.ring is None else (shape.ring,)
    if not isinstance(shape, LineForce | PlateAction | SupportSettlement):
        assert_never(shape)
    return ()
