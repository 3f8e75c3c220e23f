"""Where each bar lies in space: the corners of its axis, with the upper side of the slab at 0.

Straight bars lie in one plane: as far from the face as their axes are given, from the underside of the thinnest slab
that they cross. Pieces that lap lie beside each other, every second one its diameter off. In pits bars lie as much
lower as the floor does. U-shaped bars stand at the edges, for the thickness that their length is for. Legs against
punching have their hooks along x. Closed links of beams have theirs at an upper corner, where one end passes the other
by a diameter along the beam; their inner legs stand beside them, so far on, with hooks along the beam.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.design.bars.bending import (
    HOOK,
    LEG,
    RIGHT,
    STUD,
    BentBar,
    bent_bars,
    marked_further_links,
    marked_links,
)
from groundslab.design.bars.further_links import LaidLinks
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
    of_beam: bool = False  # a link


def placed_bars(model: Model, links: Sequence[LinkLayout] = ()) -> list[PlacedBar]:
    """Return all bars that a model lays with the links of beams, and of results the legs against punching.

    Neither meshes nor links against one-way shear, which do not stand one by one here.
    """
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
    for mark, laid in marked_further_links(model, links, listed).items():
        placed += _of_beam(laid, bent[mark])
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


def _of_beam(laid: LaidLinks, bent: Sequence[BentBar]) -> Iterator[PlacedBar]:
    """Yield the links of a beam with their inner legs, as they stand along it."""
    if not laid.standing:
        return
    closed, *inner = bent
    across, upright = closed.sides
    link = link_axis(closed)
    steps = np.arange(1, laid.legs - 1) / (laid.legs - 1) - 0.5
    for standing in laid.standing:
        along = np.array([*standing.along, 0.0])
        frame = np.array([along, [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]])
        foot = np.array([*standing.place, standing.top - standing.cover - upright])
        yield PlacedBar(closed, link @ frame + foot, of_beam=True)
        for bar in inner:
            for step in steps * (across - closed.diameter):
                beside = np.array([closed.diameter, step, 0.0])
                yield PlacedBar(bar, (leg_axis(bar) + beside) @ frame + foot, of_beam=True)


def link_axis(bar: BentBar) -> Array:
    """Return the corners (k, 3) of the axis of a closed link along x, whose lower side is at z = 0 [m].

    It begins at an upper corner, runs across, down, back and up; both hooks are turned into its inside.
    """
    across, upright = bar.sides
    half, low, high = (across - bar.diameter) / 2, bar.diameter / 2, upright - bar.diameter / 2
    around = np.array([[0, -half, high], [0, half, high], [0, half, low], [0, -half, low], [0, -half, high]])
    around[-1, 0] = bar.diameter
    if not bar.hooks or bar.mandrel is None:
        return around
    beyond, tail = _hooked(bar, bar.hooks[0])
    around[0, 1] -= beyond
    around[-1, 2] += beyond
    inward = np.array([0.0, 1.0, -1.0]) * tail * math.sqrt(0.5)
    return np.vstack([around[0] + inward, around, around[-1] + inward])


def _hooked(bar: BentBar, hook: float) -> tuple[float, float]:
    """Return how far beyond the axis of the next side a corner at a hook lies, and from there to the hook's end [m].

    Sides are given to the outer tangent of the bend; the axes of both sides meet farther out.
    """
    assert bar.mandrel is not None
    radius = (bar.mandrel + bar.diameter) / 2
    beyond = radius * math.tan(math.radians(HOOK) / 2) - radius
    return beyond, hook - bar.diameter / 2 + beyond


def leg_axis(bar: BentBar) -> Array:
    """Return the corners (k, 3) of the axis of an upright leg that stands at 0, with hooks along x [m].

    At a bend of more than 90 degrees the corner is where the axes of both sides meet, beyond the outer tangent.
    """
    if bar.shape == STUD or not bar.hooks or bar.mandrel is None:
        return np.array([[0.0, 0.0, bar.sides[0]], [0.0, 0.0, 0.0]])
    assert bar.shape == LEG
    beyond, tail = _hooked(bar, bar.hooks[0])
    corner = bar.sides[0] - bar.diameter / 2 + beyond
    turn = math.radians(HOOK)
    end = [tail * math.sin(turn), 0.0, corner + tail * math.cos(turn)]
    foot = bar.hooks[1] - bar.diameter / 2
    assert RIGHT == 90
    return np.array([end, [0.0, 0.0, corner], [0.0, 0.0, bar.diameter / 2], [foot, 0.0, bar.diameter / 2]])
