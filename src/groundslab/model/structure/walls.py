"""Walls on the plate: where they stand, and how thick they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, ClassVar

import numpy as np

from groundslab.geometry.offsets import parallel
from groundslab.geometry.plan import Segment
from groundslab.model.axes.crossings import AtCrossings
from groundslab.model.ground import POISSON, POSITIVE
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.shapes import AnyShape
from groundslab.model.structure.beams import STIFFNESS
from groundslab.model.structure.edge_lines import WORDS, edge_line
from groundslab.model.structure.lines import (
    LineBulges,
    LinePoints,
    LineShape,
    check_line,
    check_line_length,
    flat_line,
    line_area,
    line_segments,
    part_of_line,
)
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import MOST_VALUES, Integer, Number, Quantity, Text
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove
from groundslab.schema.section_fields import Table

if TYPE_CHECKING:
    from shapely import LineString, Polygon
    from shapely.geometry.base import BaseGeometry


def _check_place(
    points: tuple[tuple[float, float], ...] | None,
    bulges: tuple[float, ...],
    shape: AnyShape | None,
    edge: int | str | None,
    plate: str,
) -> Iterator[RelativeIssue]:
    """Find a wall whose axis is given twice, or not at all."""
    if edge is None:
        if plate:
            yield RelativeIssue(("plate",), "plate without an edge", "an edge of it", "points are places in the plan")
        elif points is None and shape is None:
            expected = "the line's points, a shape whose edge is the axis, or the edge of a plate"
            yield RelativeIssue(("points",), "nothing", expected)
            return
        yield from check_line(points, shape, {"bulges": bulges or None}, "a closed curve has no ends", "the axis")
        return
    keys = {"points": points, "bulges": bulges or None, "shape": shape}
    for name in (name for name, what in keys.items() if what is not None):
        key_with_edge, hint = f"{name} together with an edge", "the plate's edge says where the wall stands"
        yield RelativeIssue((name,), key_with_edge, "one of them", hint, (remove((name,)),))


def _check_ends(start: float, end: float) -> Iterator[RelativeIssue]:
    if end <= start:
        yield RelativeIssue(("end",), f"{end!r} m", f"more than the start, {start!r} m")


def _check_height(height: float | None, given: set[str]) -> Iterator[RelativeIssue]:
    """Find keys that only a wall with a height has a use for."""
    for key in ("E", "nu", "stiffness"):
        if height is None and key in given:
            yield RelativeIssue((key,), f"{key} without a height", "a height", "without it a wall has no stiffness")


class WallOpening(Section):
    """An opening in a wall: where it is less high, or the door of a wall without a height."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_ends,)

    start: Annotated[
        float, Quantity("length", "s_1", "where it begins, along the axis", Range(at_least=0), example="1 m")
    ]
    end: Annotated[float, Quantity("length", "s_2", "where it ends, along the axis", POSITIVE, example="2 m")]
    height: Annotated[
        float,
        Quantity("length", "h_o", "height that is missing there; of a door its height", POSITIVE, example="2.1 m"),
    ]


@dataclass(frozen=True, slots=True)
class WallPiece:
    """A part of a wall between doors, all of one that has none."""

    edges: tuple[Segment, ...]
    start: float  # how far along the wall it begins [m]
    end: float  # where it ends, of a closed wall beyond its length if that is after its start
    thickness: float  # [m]
    closed: bool = False

    def to_shapely(self, chord: float) -> LineString:
        """Return its axis, arcs as chords at most so far off [m]."""
        return flat_line(self.edges, chord)

    def area(self, chord: float) -> Polygon:
        """Return what it stands on, arcs as chords at most so far off [m]."""
        return line_area(self.to_shapely(chord), self.thickness, closed=self.closed)


class Wall(Section):
    """A wall that stands on the plate.

    One along an edge of a plate has an axis once it is placed by `on`.
    """

    constraints: ClassVar[tuple[Check, ...]] = (_check_place, check_line_length, _check_height)
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {"at": ("points",)}

    name: Annotated[str, Text("name of the wall, used by loads")]
    thickness: Annotated[float, Quantity("length", "t_w", "thickness of the wall", POSITIVE, example="250 mm")]
    points: LinePoints = None
    bulges: LineBulges = ()
    shape: LineShape = None
    edge: Annotated[
        int | str | None,
        Integer(
            "edge of a plate on which it stands, its outer face flush with it, instead of points: the whole outline, "
            "the straight edge on one side, or the number of an outline's edge, counted as its points; it runs "
            "counterclockwise",
            at_most=MOST_VALUES,
            words=WORDS,
        ),
    ] = None
    plate: Annotated[str, Text("name of the plate whose edge it is; the first one by default")] = ""
    height: Annotated[
        float | None,
        Quantity("length", "h_w", "height, if the wall stiffens the plate as a deep beam", POSITIVE, example="3 m"),
    ] = None
    E: Annotated[
        float | None,
        Quantity("pressure", "E", "Young's modulus, by default that of the plate", POSITIVE, example="30 GPa"),
    ] = None
    nu: Annotated[float | None, Number("nu", "Poisson's ratio, by default that of the plate", POISSON)] = None
    stiffness: Annotated[float, STIFFNESS] = 1.0
    at: AtCrossings = ()
    openings: Annotated[
        tuple[WallOpening, ...],
        Table(
            "openings in it, where it is less high; without a height they are doors: there it presses on nothing, and "
            "what acts on it over them goes to the wall on both sides",
            1000,
        ),
    ] = ()

    def on(self, plates: Sequence[AnyPlate]) -> Wall:
        """Return the wall with the points or the shape of its axis, itself if it doesn't stand on a plate's edge.

        Raises
        ------
        FieldError
            If there is no such edge, or no room for the wall.
        """
        if self.edge is None:
            return self
        axis = edge_line(plates, self.plate, self.edge, self.thickness)
        where = {"shape": axis.shape, "points": axis.points, "bulges": axis.bulges}
        return self.model_copy(update={"edge": None, "plate": "", **where})

    @property
    def edges(self) -> tuple[Segment, ...]:
        """Return the straight pieces and arcs of its axis, one after the other."""
        assert self.edge is None, "a wall along an edge has an axis once it is placed: Wall.on, Model.placed_walls"
        return line_segments(self.points, self.bulges, self.shape)

    @property
    def curved(self) -> bool:
        """Return whether its axis has arcs."""
        return any(self.bulges) or (self.shape is not None and not self.shape.ring().straight)

    @property
    def line(self) -> tuple[tuple[float, float], ...]:
        """Return the places that its straight axis runs through."""
        edges = self.edges
        return (*(edge.start for edge in edges), edges[-1].end)

    @property
    def closed(self) -> bool:
        """Return whether the axis ends where it starts."""
        return self.shape is not None or (self.points is not None and self.points[0] == self.points[-1])

    @property
    def doors(self) -> tuple[WallOpening, ...]:
        """Return the openings in which the wall doesn't press on the plate, one after the other: without a height."""
        return tuple(sorted(self.openings, key=lambda door: door.start)) if self.height is None else ()

    @property
    def pieces(self) -> tuple[WallPiece, ...]:
        """Return the parts of the wall between its doors, one after the other; of a closed one the last goes on."""
        edges, length, doors = self.edges, self.length, self.doors
        if not doors:
            return (WallPiece(edges, 0.0, length, self.thickness, closed=self.closed),)

        def piece(start: float, end: float) -> WallPiece:
            ways = [(start, end)] if end <= length else [(start, length), (0.0, end - length)]
            parts = [part_of_line(edges, *way) for way in ways]
            line = tuple(edge for points, bulges in parts for edge in line_segments(points, bulges, None))
            return WallPiece(line, start, end, self.thickness)

        ends = [door.end for door in doors], [door.start for door in doors[1:]]
        if self.closed:
            return tuple(map(piece, ends[0], [*ends[1], length + doors[0].start]))
        return tuple(map(piece, [0.0, *ends[0]], [doors[0].start, *ends[1], length]))

    def to_shapely(self, chord: float) -> LineString:
        """Return the axis, arcs as chords at most so far off [m]."""
        return flat_line(self.edges, chord)

    def area(self, chord: float) -> Polygon:
        """Return what the wall stands on, arcs as chords at most so far off [m]."""
        return line_area(self.to_shapely(chord), self.thickness, closed=self.closed)

    @property
    def length(self) -> float:
        """Return the length of its axis [m]."""
        return sum(edge.length for edge in self.edges)


@dataclass(frozen=True, slots=True)
class WallFaces:
    """The axis of a wall and its faces beside each piece of it, to be checked where they lie."""

    wall: Wall

    def to_shapely(self, chord: float) -> BaseGeometry:
        """Return the lines, arcs as chords well less than so far off [m], as those of the plate's edge are off, too."""
        from shapely import LineString, MultiLineString

        lines = [
            parallel(edge, side * self.wall.thickness / 2) for edge in self.wall.edges for side in (-1.0, 0.0, 1.0)
        ]
        pieces = [(line, line.chords(chord / 10)) for line in lines]
        return MultiLineString([LineString(line.at(np.arange(n + 1) / n)) for line, n in pieces])


def place_walls(walls: Iterable[Wall], plates: Sequence[AnyPlate]) -> tuple[Wall, ...]:
    """Return walls with their axes, but for those along edges that do not exist."""
    placed = []
    for wall in walls:
        try:
            placed.append(wall.on(plates))
        except FieldError:
            continue
    return tuple(placed)
