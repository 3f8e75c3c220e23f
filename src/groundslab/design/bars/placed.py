"""Where each bar lies in space: the corners of its axis, with the upper side of the slab at 0.

Straight bars lie in one plane: as far from the face as their axes are given, from the underside of the thinnest slab
that they cross. Pieces that lap lie beside each other, every second one its diameter off. In pits bars lie as much
lower as the floor does. U-shaped bars stand at the edges, for the thickness that their length is for. Legs against
punching have their hooks along x.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.design.bars.bending import HOOK, LEG, RIGHT, STUD, BentBar, bent_bars, marked_links
from groundslab.design.bars.positions import (
    STRAIGHT,
    U_SHAPE,
    Position,
    cut_bars,
    edge_thickness,
    inside_of,
    positions,
)
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.model.design.laid_bars import axis_of, covers_of, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


#: Bars as they are cut and bent by the marks of their positions.
Bent = Mapping[int, Sequence[BentBar]]


@dataclass(frozen=True, slots=True)
class PlacedBar:
    """A bar: what it is cut and bent to, and the corners (k, 3) of its axis [m]."""

    bar: BentBar
    corners: Array


def placed_bars(model: Model, links: Sequence[LinkLayout] = ()) -> list[PlacedBar]:
    """Return all bars that a model lays, and of results the legs against punching; neither meshes nor other links."""
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return []
    listed = positions(model)
    bent: dict[int, list[BentBar]] = {}
    for bar in bent_bars(model, links):
        bent.setdefault(int(bar.mark.partition("-")[0]), []).append(bar)
    placed = [
        piece
        for bar_set in bar_sets(model)
        if not bar_set.mesh
        for piece in _straight(model, steel, bar_set, listed, bent)
    ]
    placed += [
        piece for position in listed if position.shape == U_SHAPE for piece in _at_edges(model, steel, position, bent)
    ]
    for mark, layout in marked_links(links, listed).items():
        placed += _legs(steel, layout, bent[mark][0])
    return placed


def _straight(
    model: Model, steel: Reinforcement, bar_set: BarSet, listed: Sequence[Position], bent: Bent
) -> Iterator[PlacedBar]:
    """Yield the bars of a set, each piece by itself."""
    of_set = [
        position
        for position in listed
        if (position.layer, position.zone, position.shape) == (bar_set.layer, bar_set.zone, STRAIGHT)
    ]
    alike = [bar for position in of_set for bar in bent[position.mark]]
    axis, off = bar_set.axis, axis_of(steel, bar_set.layer)
    slabs = list(_slabs(model))
    for bar in cut_bars(model, steel, bar_set):
        length = bar.length
        bent_bar = min(alike, key=lambda each: abs(each.length - length))
        height = _height(slabs, bar.ends, bar_set.layer, off)
        for number, piece in enumerate(bar.pieces(axis)):
            corners = np.column_stack([piece, [height, height]])
            corners[:, 1 - axis] += number % 2 * bar_set.bars.diameter
            yield PlacedBar(bent_bar, corners)


def _slabs(model: Model) -> Iterator[tuple[BaseGeometry, float, float]]:
    """Yield the parts of all plates with their thickness and the height of their upper side [m]."""
    region = get_plate_region(model.plate, model.plates)
    for plate, area in zip(region.every, region.areas, strict=True):
        rest = area
        for zone in reversed(plate.zones):
            ring = polygon_of(zone.shape.ring())
            yield rest.intersection(ring), zone.thickness or plate.thickness, zone.level or 0.0
            rest = rest.difference(ring)
        yield rest, plate.thickness, 0.0


def _height(slabs: Sequence[tuple[BaseGeometry, float, float]], bar: Array, layer: str, off: float) -> float:
    """Return the height of a bar's axis [m]: from its face, at the bottom of the thinnest slab that it crosses."""
    from shapely import LineString

    line = LineString(bar)
    shares = [(line.intersection(part).length, level, thickness) for part, thickness, level in slabs]
    met = [(level, thickness) for share, level, thickness in shares if share > 1e-6] or [
        min(((level, thickness) for _, level, thickness in shares), key=lambda slab: slab[1])
    ]
    level, thickness = max(met, key=lambda slab: slab[0] - slab[1])
    return level - off if layer.startswith("top") else level - thickness + off


def _at_edges(model: Model, steel: Reinforcement, position: Position, bent: Bent) -> Iterator[PlacedBar]:
    """Yield the U-shaped bars of a position, their backs the cover off the edge."""
    assert position.places is not None
    assert position.lap is not None
    axis, inside = "xy".index(position.layer[-1]), inside_of(model)
    bar = bent[position.mark][0]
    offs = [axis_of(steel, f"{face}_{'xy'[axis]}") for face in ("bottom", "top")]
    low, high = offs[0] - edge_thickness(model), -offs[1]
    cover = min(offs) - position.bars.diameter / 2
    for place in position.places:
        way = 1.0 if inside(place, axis, 1e-3) else -1.0
        back, end = cover + position.bars.diameter / 2, cover + position.lap
        corners = np.zeros((4, 3))
        corners[:, :2] = place
        corners[:, axis] += way * np.array([end, back, back, end])
        corners[:, 2] = low, low, high, high
        yield PlacedBar(bar, corners)


def _legs(steel: Reinforcement, layout: LinkLayout, bar: BentBar) -> Iterator[PlacedBar]:
    """Yield the legs around one column, pile, zone or end of a wall."""
    axis = leg_axis(bar)
    top = -covers_of(steel)[1]
    for place in (place for perimeter in layout.perimeters for place in perimeter.places):
        foot = np.array([float(place[0]), float(place[1]), top - layout.leg])
        yield PlacedBar(bar, axis + foot)


def leg_axis(bar: BentBar) -> Array:
    """Return the corners (k, 3) of the axis of an upright leg that stands at 0, with hooks along x [m].

    At a bend of more than 90 degrees the corner is where the axes of both sides meet, beyond the outer tangent.
    """
    if bar.shape == STUD or not bar.hooks or bar.mandrel is None:
        return np.array([[0.0, 0.0, bar.sides[0]], [0.0, 0.0, 0.0]])
    assert bar.shape == LEG
    radius = (bar.mandrel + bar.diameter) / 2
    outer = radius + bar.diameter / 2
    beyond = radius * math.tan(math.radians(HOOK) / 2)
    corner = bar.sides[0] - outer + beyond
    tail = bar.hooks[0] - outer + beyond
    turn = math.radians(HOOK)
    end = [tail * math.sin(turn), 0.0, corner + tail * math.cos(turn)]
    foot = bar.hooks[1] - bar.diameter / 2
    assert RIGHT == 90
    return np.array([end, [0.0, 0.0, corner], [0.0, 0.0, bar.diameter / 2], [foot, 0.0, bar.diameter / 2]])
