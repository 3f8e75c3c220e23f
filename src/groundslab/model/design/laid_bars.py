"""What bars lie where: those all over the slab, and those of zones, which are laid between them.

Where zones lie, areas add up. Cracks take one diameter in place of several (EN 1992-1-1 7.3.4(3), 7.12),

    phi_eq = (n_1 phi_1^2 + n_2 phi_2^2) / (n_1 phi_1 + n_2 phi_2),

n_i being the bars per length, 1 / s_i. How far apart bars are at most is the least of their distances: what the closest
set among them has by itself, wherever the others lie. A bar counts in all of its zone; anchorage is not looked at.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.places import same_place
from groundslab.geometry.plan import Ring
from groundslab.model.design.bars import Bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate
from groundslab.model.plates.region import get_plate_region
from groundslab.model.shapes import CHORD
from groundslab.model.structure.columns import Column

if TYPE_CHECKING:
    from shapely import Polygon

#: Width beside a column in which bars count for punching, on each side, and how far from its faces they must reach, in
#: effective depths (EN 1992-1-1 6.4.4(1), 6.4.2(1)).
BESIDE, BEYOND = 3.0, 2.0
#: Density of steel [kg/m3] (EN 1992-1-1 3.2.7(3)).
DENSITY = 7850.0


@dataclass(frozen=True, slots=True)
class LaidBars:
    """The bars of one layer at places."""

    area: Array  # (n,) [m2/m]
    diameter: Array  # (n,): one for all of them, 7.12 [m]
    spacing: Array  # (n,): from axis to axis at most [m]
    clear: Array  # (n,): between bars, of several sets as if they were even, the thickest ones beside each other [m]
    thickest: Array  # (n,): the largest diameter [m]


def bar_area(bars: Bars) -> float:
    """Return the area of bars [m2/m]."""
    return math.pi * bars.diameter**2 / 4 / bars.spacing


def bars_of(steel: Reinforcement, layer: str) -> list[Bars]:
    """Return the sets of bars of a layer: those all over the slab, then those of its zones. Some must be laid."""
    base = steel.base_bars(layer)
    assert base is not None
    return [base, *(zone.bars for zone in steel.zones if layer in zone.layers)]


def axis_of(steel: Reinforcement, layer: str) -> float:
    """Return the distance of a layer's bars from their face [m]."""
    face, axis = layer.split("_")
    distance: float = getattr(steel, f"{face}_axes")["xy".index(axis)]
    return distance


def laid_bars(steel: Reinforcement, layer: str, places: Array) -> LaidBars:
    """Return the bars of a layer at places (n, 2) [m]; those on the border of a zone have its bars. Some must be laid.

    Their clear distance is that inside of zones: on a border that two zones share their bars do not lie between. The
    places are the plate's nodes, whose extent says what counts as rounding there.
    """
    from shapely import intersects_xy

    x, y = places.T
    near = same_place(x.min(), x.max(), y.min(), y.max()) if len(places) else 0.0
    sets = bars_of(steel, layer)
    masks, inside = ([np.ones(len(places), dtype=bool)] for _ in range(2))
    for zone in steel.zones:
        if layer in zone.layers:
            region = polygon_of(zone.shape.ring())
            for which, by in ((masks, near), (inside, -near)):
                which.append(intersects_xy(region.buffer(by, join_style="mitre"), x, y))
    diameter, spacing = (np.array([getattr(bars, name) for bars in sets])[:, None] for name in ("diameter", "spacing"))
    count = np.array(masks) / spacing  # per length
    squares = (count * diameter**2).sum(axis=0)
    farthest = np.where(masks, spacing, np.inf).min(axis=0)
    thickest = np.where(masks, diameter, 0.0).max(axis=0)
    clear = 1 / (np.array(inside) / spacing).sum(axis=0) - np.where(inside, diameter, 0.0).max(axis=0)
    return LaidBars(np.pi / 4 * squares, squares / (count * diameter).sum(axis=0), farthest, clear, thickest)


def mean_area(
    plate: Plate, steel: Reinforcement, layer: str, column: Column, d: float, plates: tuple[FurtherPlate, ...] = ()
) -> float:
    """Return the area of a layer's bars that counts for punching at a column [m2/m], d its effective depth [m].

    It is the mean over the column's width and 3 d on each side (6.4.4(1)), as far as the plate reaches at the column's
    level: the least of those beside the column's center and 2 d off its faces, as bars of a short zone end within the
    perimeter.
    """
    from shapely import LineString

    base = steel.base_bars(layer)
    assert base is not None
    axis = "xy".index(layer[-1])
    x0, x1, y0, y1 = column.ring().bounds
    along, across = ((x0, x1), (y0, y1))[axis], ((x0, x1), (y0, y1))[1 - axis]
    zones = [(zone, polygon_of(zone.shape.ring())) for zone in steel.zones if layer in zone.layers]
    if not zones:
        return bar_area(base)
    plan = get_plate_region(plate, plates).level_at((column.x, column.y))
    areas = list[float]()
    for where in (along[0] - BEYOND * d, (along[0] + along[1]) / 2, along[1] + BEYOND * d):
        ends = [(where, across[0] - BESIDE * d), (where, across[1] + BESIDE * d)]
        cut = LineString(ends if axis == 0 else [end[::-1] for end in ends]).intersection(plan)
        if cut.length > 0:
            more = sum(bar_area(zone.bars) * cut.intersection(region).length for zone, region in zones)
            areas.append(bar_area(base) + more / cut.length)
    return min(areas)


class PunchingBars(NamedTuple):
    """Areas of bars that count for punching, along x and along y [m2/m]."""

    x: float
    y: float

    def ratio(self, d: float) -> float:
        """Return rho_l for an effective depth d [m] (6.4.4(1))."""
        return math.sqrt(self.x * self.y) / d


def punching_bars(
    plate: Plate,
    steel: Reinforcement,
    column: Column,
    d: float,
    plates: tuple[FurtherPlate, ...] = (),
    face: Literal["bottom", "top"] = "bottom",
) -> PunchingBars:
    """Return the bars provided at a face that count for punching at a column, or a pile."""
    return PunchingBars(*(mean_area(plate, steel, layer, column, d, plates) for layer in (f"{face}_x", f"{face}_y")))


def polygon_of(ring: Ring) -> Polygon:
    """Return the polygon inside a ring."""
    x0, x1, y0, y1 = ring.bounds
    return ring.polygon(CHORD * max(x1 - x0, y1 - y0))


def covers_of(steel: Reinforcement) -> tuple[float, float]:
    """Return the covers of the outermost bars at the bottom and the top [m].

    Where only axes are given and no bars, they are the distances of these.
    """
    if steel.cover is not None:
        return steel.cover
    below, above = (min(_cover_of(steel, f"{face}_{axis}") for axis in "xy") for face in ("bottom", "top"))
    return below, above


def _cover_of(steel: Reinforcement, layer: str) -> float:
    """Return the cover of a layer's bars [m], the distance of its axis if there are none."""
    bars = steel.base_bars(layer)
    return axis_of(steel, layer) - (bars.diameter / 2 if bars is not None else 0.0)
