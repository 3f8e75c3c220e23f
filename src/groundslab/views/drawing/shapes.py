"""What a drawing consists of: lines, circles and texts on layers, in meters, whatever file it is written to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import DRAWN_CHORD, Ring
from groundslab.model.axes.drawn import drawn_axes
from groundslab.model.model import Model
from groundslab.model.plates.pits import pits_of

if TYPE_CHECKING:
    from shapely import LinearRing, Polygon


class Layer(NamedTuple):
    """How a layer looks: a number of AutoCAD's palette, whose 7 is black on white; broken lines; switched off."""

    color: int
    broken: bool = False
    off: bool = False


@dataclass(frozen=True, slots=True)
class Line:
    """A line through points (k, 2) [m], closed or not.

    Where they are chords of arcs, ``curve`` has these; on a contour ``level`` is its quantity, value and unit.
    """

    layer: str
    points: Array
    closed: bool = False
    level: tuple[str, float, str] | None = None
    curve: Ring | None = None


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle [m]."""

    layer: str
    center: tuple[float, float]
    radius: float


@dataclass(frozen=True, slots=True)
class Text:
    """A line of text whose lower left end is at a place [m]; its letters are so high [m], turned counter-clockwise.

    With ``centered`` it is the text's middle that is there.
    """

    layer: str
    place: tuple[float, float]
    height: float
    words: str
    turned: float = 0.0  # [degrees]
    centered: bool = False


Shape = Line | Circle | Text

#: Height of letters over the longer side of the slab.
LETTERS = 1 / 90
#: The layers of what lies on the plate.
PLAN_LAYERS = {
    "OUTLINE": Layer(7), "OPENINGS": Layer(8), "PITS": Layer(8), "COLUMNS": Layer(8), "WALLS": Layer(8),
    "BEAMS": Layer(8), "AXES": Layer(8, broken=True), "AXES_NAMES": Layer(8),
}  # fmt: skip


def plan_shapes(model: Model) -> Iterator[Shape]:
    """Yield outlines, openings, columns, the faces of walls, walls of pits and beams, and axes, where there are any."""
    chord = DRAWN_CHORD * max(model.sides)
    for plate in model.every_plate:
        yield closed("OUTLINE", plate.ring(), chord)
        for opening in plate.openings:
            yield closed("OPENINGS", opening.ring(), chord)
        yield from (Line("PITS", face, closed=True) for pit in pits_of(plate) for face in pit.faces(chord))
    for column in model.columns:
        yield closed("COLUMNS", column.ring(), chord)
    for piece in (piece for wall in model.placed_walls for piece in wall.pieces):
        yield from (Line("WALLS", np.asarray(ring.coords)[:-1], closed=True) for ring in rings(piece.area(chord)))
    for beam in model.beams:
        yield from (Line("BEAMS", np.asarray(ring.coords)[:-1], closed=True) for ring in rings(beam.area(chord)))
    for axis in drawn_axes(model.axes, model.bounds):
        yield Line("AXES", axis.points)
        yield Circle("AXES_NAMES", axis.bubble, axis.radius)
        yield Text("AXES_NAMES", axis.bubble, LETTERS * max(model.sides), axis.name, centered=True)


def closed(layer: str, ring: Ring, chord: float) -> Line:
    """Return a closed curve, with chords at most so far off [m]."""
    return Line(layer, ring.flat(chord), closed=True, curve=ring)


def rings(polygon: Polygon) -> Sequence[LinearRing]:
    """Return the curves around a polygon and its holes."""
    return [polygon.exterior, *polygon.interiors]


def moved(shape: Shape, by: tuple[float, float]) -> Shape:
    """Return a shape moved along x and y [m]."""
    return scaled(shape, 1.0, by)


def scaled(shape: Shape, factor: float, by: tuple[float, float] = (0.0, 0.0)) -> Shape:
    """Return a shape enlarged about the origin, letters too, and then moved along x and y."""

    def put(place: tuple[float, float]) -> tuple[float, float]:
        return (factor * place[0] + by[0], factor * place[1] + by[1])

    if isinstance(shape, Line):
        curve = shape.curve
        if curve is not None:
            curve = replace(curve, points=tuple(map(put, curve.points)))
        return replace(shape, points=factor * shape.points + by, curve=curve)
    if isinstance(shape, Circle):
        return replace(shape, center=put(shape.center), radius=factor * shape.radius)
    return replace(shape, place=put(shape.place), height=factor * shape.height)
