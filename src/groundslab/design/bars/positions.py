"""The positions of a bar list: bars of one shape, diameter and length, each set of bars by itself.

Without `reinforcement.detailing` bars are straight, as long as the plan cuts them. With it,

- a bar ends a cover before an edge of the plan, and in full at the border of its zone;
- one that is longer than bars are delivered, L > l, is cut into n = ceil((L - l_0) / (l - l_0)) pieces of the same
  length (L + (n - 1) l_0) / n, which lap by l_0, all of them counted as lapped in one section;
- a bar of U shape holds each end at an edge: of the base as many as the face with more bars has there, as thick as the
  thicker ones; its legs are the lap of such bars or more, and 2 h (EN 1992-1-1 9.3.1.4, Figure 9.8), its back is what
  covers leave of the thickness. Bends are measured as corners.

Meshes are delivered as sheets and have none of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.bars.bar_layout import BarSet, bar_sets
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import DENSITY, axis_of, bars_of, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.unit_systems import INCH, System

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Bars of one set have a position for each length that they are cut to, unless there are more lengths than this.
MOST_LENGTHS = 6
#: A bar ends at an edge that is no farther than this [m].
AT_EDGE = 1e-4
STRAIGHT: Literal["straight"] = "straight"
U_SHAPE: Literal["U"] = "U"


@dataclass(frozen=True, slots=True)
class Position:
    """A position of the bar list.

    Attributes
    ----------
    mark : int
        Its number, from 1.
    layer, zone, mesh : str
        The set of bars that it belongs to; of bars of U shape the direction and both faces.
    shape : str
        STRAIGHT or U_SHAPE.
    bars : Bars
        Diameter and spacing.
    lengths : array (k,)
        Of its pieces [m].
    lap : float or None
        Length of laps [m], where pieces are lapped or of legs that lap.
    places : array (k, 2) or None
        Of bars of U shape where each is [m].
    """

    mark: int
    layer: str
    zone: str
    mesh: str
    shape: str
    bars: Bars
    lengths: Array
    lap: float | None = None
    places: Array | None = None

    @property
    def total(self) -> float:
        """Return the length of all pieces [m]."""
        return float(self.lengths.sum())

    @property
    def mass(self) -> float:
        """Return their mass [kg]."""
        return DENSITY * math.pi * self.bars.diameter**2 / 4 * self.total


def positions(model: Model) -> list[Position]:
    """Return the positions of all bars that a model lays, numbered in order: straight ones, then those at edges."""
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return []
    laid = [position for bar_set in bar_sets(model) for position in _of_set(model, steel, bar_set)]
    if steel.detailing is not None and steel.detailing.edge_bars:
        laid += _edge_bars(model, steel)
    return [replace(position, mark=number) for number, position in enumerate(laid, start=1)]


def to_cut(lengths: Array, units: System, *, bent: bool = False) -> Array:
    """Return lengths [m] to which bars are cut, or their sides are bent: as they are measured where the units are.

    In SI units to the millimeter; in those of the United States to the inch, bent sides to a quarter of it.
    """
    per_meter = 1e3 if units == "SI" else (4 if bent else 1) / INCH
    return np.asarray(np.rint(lengths * per_meter) / per_meter)


def cut(length: float, stock: float, lap: float) -> tuple[int, float]:
    """Return into how many pieces a bar is cut, and how long each is [m], laps included; stock is longer than a lap."""
    if length <= stock:
        return 1, length
    count = math.ceil((length - lap) / (stock - lap) - 1e-9)
    return count, (length + (count - 1) * lap) / count


class CutBar(NamedTuple):
    """A straight bar between its ends, and the pieces that it is cut into."""

    ends: Array  # (2, 2): the covers off edges [m]
    parts: int  # number of pieces
    length: float  # of each, laps included [m]
    lap: float  # [m], 0 where nothing is lapped

    def pieces(self, axis: int) -> Array:
        """Return the ends (p, 2, 2) of the pieces [m] of a bar along an axis."""
        pieces = np.repeat(self.ends[None], self.parts, axis=0)
        starts = self.ends[0, axis] + np.arange(self.parts) * (self.length - self.lap)
        pieces[:, :, axis] = starts[:, None] + [0.0, self.length]
        return pieces


def cut_bars(model: Model, steel: Reinforcement, bar_set: BarSet) -> list[CutBar]:
    """Return the bars of a set as they are laid, those that covers leave nothing of left out.

    Without detailing they end where the plan cuts them, and so do the wires of meshes.
    """
    axis, detailing, ends = bar_set.axis, steel.detailing, bar_set.ends.copy()
    if detailing is None or bar_set.mesh:
        return [CutBar(bar, 1, float(np.ptp(bar[:, axis])), 0.0) for bar in ends]
    rule = code_of(steel).detailing
    assert rule is not None
    cover = axis_of(steel, bar_set.layer) - bar_set.bars.diameter / 2
    ends[:, :, axis] += cover * at_edge(model, ends) * [1.0, -1.0]
    lap = lap_of(model, steel, bar_set.layer, bar_set.bars, rule)
    bars = []
    for bar in ends[ends[:, 1, axis] > ends[:, 0, axis]]:
        count, length = cut(float(bar[1, axis] - bar[0, axis]), detailing.bar_length, lap)
        bars.append(CutBar(bar, count, length, lap if count > 1 else 0.0))
    return bars


def largest_thickness(model: Model) -> float:
    """Return the largest thickness of all plates and their zones [m]."""
    return max(thicknesses(model))


def thicknesses(model: Model) -> set[float]:
    """Return the thicknesses of all plates and their zones [m]."""
    zones = {zone.thickness for plate in model.every_plate for zone in plate.zones if zone.thickness is not None}
    return zones | {plate.thickness for plate in model.every_plate}


def edge_thickness(model: Model) -> float:
    """Return the largest thickness of plates, and of those zones that reach an edge [m]."""
    edges = get_plate_region(model.plate, model.plates).area.boundary
    zones = [
        zone.thickness
        for plate in model.every_plate
        for zone in plate.zones
        if zone.thickness is not None and polygon_of(zone.shape.ring()).distance(edges) <= AT_EDGE
    ]
    return max([*(plate.thickness for plate in model.every_plate), *zones])


def lap_of(model: Model, steel: Reinforcement, layer: str, bars: Bars, rule: DetailingRule) -> float:
    """Return the lap [m] of bars of a layer, counted where the slab is thickest and bars of a zone lie between."""
    axis, h = axis_of(steel, layer), largest_thickness(model)
    base, *zones = (layer_bars.spacing for layer_bars in bars_of(steel, layer))
    apart = 1 / (1 / base + 1 / min(zones)) if zones else base
    below = h - axis if layer.startswith("top") else axis
    return rule.lap(steel, EndingBar(bars.diameter, axis, apart, below, h - below))


def _of_set(model: Model, steel: Reinforcement, bar_set: BarSet) -> Iterator[Position]:
    """Yield the positions of a set of straight bars, without marks, the longest first."""
    bars = cut_bars(model, steel, bar_set)
    if not bars:
        return
    lengths = np.repeat([bar.length for bar in bars], [bar.parts for bar in bars])
    lap = max(bar.lap for bar in bars) or None
    rounded = to_cut(lengths, model.units)
    different = np.unique(rounded)
    groups = [rounded == length for length in different[::-1]] if len(different) <= MOST_LENGTHS else [rounded > 0]
    for group in groups:
        yield Position(0, bar_set.layer, bar_set.zone, bar_set.mesh, STRAIGHT, bar_set.bars, lengths[group], lap)


def at_edge(model: Model, ends: Array) -> Flags:
    """Return which ends (k, 2, 2) of bars lie at an edge of the plan, (k, 2)."""
    import shapely

    edges: BaseGeometry = get_plate_region(model.plate, model.plates).area.boundary
    return np.asarray(shapely.distance(shapely.points(ends), edges) <= AT_EDGE)


def inside_of(model: Model) -> Callable[[Array, int, float], bool]:
    """Return whether the plan is on the upper side of a place along an axis, so far from it [m]."""
    from shapely import Point

    area = get_plate_region(model.plate, model.plates).area

    def inside(place: Array, axis: int, off: float) -> bool:
        beside = place.copy()
        beside[axis] += off
        return bool(area.intersects(Point(beside)))

    return inside


def _edge_bars(model: Model, steel: Reinforcement) -> Iterator[Position]:
    """Yield the bars of U shape along x, then along y: those of the base, then those of zones."""
    sets = [bar_set for bar_set in bar_sets(model) if not bar_set.mesh]
    rule = code_of(steel).detailing
    assert rule is not None
    for axis in "xy":
        faces = {bar_set.layer: bar_set for bar_set in sets if not bar_set.zone and bar_set.layer.endswith(axis)}
        if faces:
            places = {layer: _places(model, bar_set) for layer, bar_set in faces.items()}
            most = max(faces, key=lambda layer: len(places[layer]))
            diameter = max(bar_set.bars.diameter for bar_set in faces.values())
            bars = Bars(diameter=diameter, spacing=faces[most].bars.spacing)
            yield from _u_bars(model, steel, axis, "", bars, places[most], rule)
        for bar_set in sets:
            if bar_set.zone and bar_set.layer.endswith(axis):
                yield from _u_bars(model, steel, axis, bar_set.zone, bar_set.bars, _places(model, bar_set), rule)


def _places(model: Model, bar_set: BarSet) -> Array:
    """Return where bars of a set end at edges (k, 2) [m]."""
    return np.asarray(bar_set.ends[at_edge(model, bar_set.ends)])


def _u_bars(
    model: Model, steel: Reinforcement, axis: str, zone: str, bars: Bars, places: Array, rule: DetailingRule
) -> Iterator[Position]:
    """Yield the bars of U shape at places (k, 2) [m], if there are any."""
    if not len(places):
        return
    h = edge_thickness(model)
    lap = max(lap_of(model, steel, f"{face}_{axis}", bars, rule) for face in ("bottom", "top"))
    leg = max(rule.edge_leg * h, lap)
    covers = sum(axis_of(steel, f"{face}_{axis}") - bars.diameter / 2 for face in ("bottom", "top"))
    length = 2 * leg + max(h - covers, 0.0)
    yield Position(0, f"edges_{axis}", zone, "", U_SHAPE, bars, np.full(len(places), length), leg, places)
