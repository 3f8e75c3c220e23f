"""What counts of a perimeter that reaches slab thinner than where it starts.

No code's formulas are in here: a code says what share of a length counts there. A leg in thinner slab becomes dashes,
short parts of it that are together this share of it. So length, center, moduli and second moments of a perimeter are
those of what counts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.perimeter_loads import CORNER_REACH
from groundslab.design.demands.perimeter_pieces import WeightedLegs
from groundslab.design.demands.perimeters import area_of, outside, within
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

#: Dashes begin no farther from each other than this, over the effective depth.
DASH = 0.1
#: Thicknesses that differ by a smaller share are the same.
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class ThinnerPart:
    """A part of the plate that is thinner than where perimeters start."""

    by: float  # [m]
    away: float  # its least distance from where they start [m]
    region: Polygon | MultiPolygon


#: Of a part, a perimeter's distance [m] and the effective depth where it starts [m]: the share of a length that counts
#: in the part.
Share = Callable[[ThinnerPart, float, float], float]


def depth_share(part: ThinnerPart, _: float, d: float) -> float:
    """Return the share of a length that counts by its effective depth alone."""
    return max(0.0, 1 - part.by / d)


def thinner_parts(
    results: CombinationResult, footprint: Polygon, thickness: float, reach: float
) -> tuple[ThinnerPart, ...]:
    """Return the parts of the plate thinner than a thickness that perimeters reach within a distance [m]."""
    plate, elements = results.plate, results.elements
    if elements.thickness.min() >= (1 - SAME) * thickness:
        return ()
    mesh = Mesh(plate.nodes, plate.elements)
    near = load_vectors.find_elements_near(mesh, footprint.buffer(CORNER_REACH * reach))
    levels = elements.thickness[near]
    regions = {
        level: area_of(plate.nodes, plate.elements[near[levels == level]])
        for level in np.unique(levels)
        if level < (1 - SAME) * thickness
    }
    return tuple(
        ThinnerPart(float(thickness - level), float(footprint.distance(region)), region)
        for level, region in regions.items()
    )


def weighted(
    legs: Array, parts: Sequence[ThinnerPart], share: Share, distance: float, d: float
) -> tuple[WeightedLegs, ...]:
    """Return the legs (l, 2, 2) [m] of a perimeter at a distance by how much of them counts.

    d is the effective depth where the perimeter starts [m].
    """
    thin = []
    for part in parts:
        thinner = within(legs, part.region)
        if len(thinner):
            legs = outside(legs, part.region)
            of_part = share(part, distance, d)
            thin.append(WeightedLegs(thinner, of_part, DASH * d, thinner=(part.by, part.away)))
    return (WeightedLegs(legs), *thin)


def shares_at(places: Array, distance: float, parts: Sequence[ThinnerPart], share: Share, d: float) -> Array:
    """Return the share that counts at places (n, 2) [m] of a perimeter at a distance [m]."""
    from shapely import contains_xy

    shares = np.ones(len(places))
    for part in parts:
        shares[contains_xy(part.region, *places.T)] = share(part, distance, d)
    return shares
