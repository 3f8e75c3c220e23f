"""The straight bars of a slab one by one: where each lies, how long it is, and what all of them weigh.

Bars of a set lie as far apart as is given or a little closer at both borders: over a width b there are n = ceil(b / s)
of them, the outer ones (b - (n - 1) s) / 2 from the borders. Each is cut by the outline, by openings, by steps at pits
and by the border of its zone. `detailing/positions` cuts and laps them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import polygon_of
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.results.fields import LAYERS

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: A count is not one more for what a width is larger than a multiple of the spacing by rounding, and what remains of a
#: bar by rounding is none [m].
ROUNDING, SHORTEST = 1e-9, 1e-6


@dataclass(frozen=True)
class BarSet:
    """The bars of one layer that are laid together: all over the slab, or in a zone."""

    layer: str
    zone: str  # its name; empty all over the slab
    mesh: str  # what welded mesh they belong to; empty of single bars
    bars: Bars
    region: BaseGeometry  # where they lie
    ends: Array  # (k, 2, 2): each from its lower end [m]

    @property
    def axis(self) -> int:
        """Return the axis along which they run, 0 of x."""
        return "xy".index(self.layer[-1])

    @cached_property
    def lengths(self) -> Array:
        """Return the lengths (k,) [m]."""
        return np.asarray(np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1))


def bar_sets(model: Model) -> list[BarSet]:
    """Return all bars that are laid, layer by layer: first those all over the slab, then zone by zone."""
    steel = model.reinforcement
    if steel is None or not steel.laid:
        return []
    covered = get_plate_region(model.plate, model.plates)
    plan, steps = covered.area, covered.steps
    layout = []
    for layer in LAYERS:
        base = steel.base_bars(layer)
        assert base is not None
        sets = [("", getattr(steel, f"{layer.split('_')[0]}_mesh") or "", base, plan)]
        sets += [
            (zone.name, zone.mesh or "", zone.bars, polygon_of(zone.shape.ring()).intersection(plan))
            for zone in steel.zones
            if layer in zone.layers
        ]
        for name, mesh, bars, region in sets:
            ends = straight_bars(region, "xy".index(layer[-1]), bars.spacing, steps)
            layout.append(BarSet(layer, name, mesh, bars, region, ends))
    return layout


def straight_bars(region: BaseGeometry, axis: int, spacing: float, steps: BaseGeometry | None = None) -> Array:
    """Return the ends (k, 2, 2) [m] of bars along an axis in a region, from the lowest upwards.

    They end at steps, if there are any.
    """
    from shapely import bounds as bounds_of
    from shapely import get_parts, intersection, length, line_merge, linestrings

    bounds = np.array(region.bounds).reshape(2, 2)  # low, high
    (start, end), (low, high) = bounds[:, axis], bounds[:, 1 - axis]
    count = max(1, math.ceil((high - low) / spacing - ROUNDING))
    across = (low + high) / 2 + spacing * (np.arange(count) - (count - 1) / 2)
    lines = np.empty((count, 2, 2))
    lines[:, :, axis], lines[:, :, 1 - axis] = (start, end), across[:, None]
    # along an edge of the region a line is cut at its corners, and so joined again
    cut = get_parts(line_merge(intersection(linestrings(lines), region)))
    ends = bounds_of(cut[length(cut) > SHORTEST]).reshape(-1, 2, 2)
    ends = ends if steps is None else _cut_at(steps, ends, axis)
    return np.asarray(ends[np.lexsort((ends[:, 0, axis], ends[:, 0, 1 - axis]))])


def _cut_at(steps: BaseGeometry, ends: Array, axis: int) -> Array:
    """Return bars (k, 2, 2) [m] along an axis, cut where they cross steps; one along a step is cut at its corners."""
    from shapely import get_coordinates, intersection, linestrings

    places, bar = get_coordinates(intersection(linestrings(ends), steps), return_index=True)
    cut = list[Array]()
    for number, bar_ends in enumerate(ends):
        stops = np.unique([*bar_ends[:, axis], *places[bar == number, axis].clip(*bar_ends[:, axis])])
        parts = np.repeat(bar_ends[None, :1], len(stops) - 1, axis=0).repeat(2, axis=1)
        parts[:, :, axis] = np.stack([stops[:-1], stops[1:]], axis=1)
        cut.append(parts[np.diff(stops) > SHORTEST])
    return np.concatenate(cut)
