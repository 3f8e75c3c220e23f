"""Links against one-way shear that are proposed where a slab needs some: legs in a grid, in rectangles."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Flags
from groundslab.design.checks.one_way_shear.places import Places, near_forces
from groundslab.design.checks.one_way_shear.shear import ShearCase, read_demand
from groundslab.design.demands.edge_strip import plates_that_count
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.messages import Message
from groundslab.model.design.shear_links import ShearLinks
from groundslab.results.fields import place_of
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Distances of legs are multiples of this, and at least so much [m].
STEP, NEAREST = 0.025, 0.1
#: So far beyond a place that needs links they go on, over its depth.
BEYOND = 0.5
#: What counts as rounding, relative.
ROUNDING = 1e-9


def shear_links(combined: Results, diameters: Sequence[float], rounding: float) -> Iterator[ShearLinks | Message]:
    """Yield links of some diameters [m] where the slab needs some, in rectangles rounded to a distance [m].

    Or why there are none: struts fail, or the slab is too thin.
    """
    case = ShearCase.of(combined)
    if case is None:
        return
    demands = [demand for results in ultimate_results(combined) for demand in _demands(case, results)]
    demands += [demand for demand in case.across() if demand.used > 1]
    possible = [demand for demand in demands if not math.isinf(case.rule.links(case.steel, demand))
                and demand.thickness >= case.rule.least_thickness]  # fmt: skip
    if len(possible) < len(demands):
        yield Message("one-way shear: links do not help everywhere")
    for number, (shape, inside) in enumerate(_rectangles(possible, rounding), 1):
        x0, y0, x1, y1 = shape
        corners = {"kind": "rectangle", "x": (x0, x1), "y": (y0, y1)}
        option = partial(ShearLinks, name=f"links {number}", shape=corners)
        needed = max(case.rule.links(case.steel, demand) for demand in inside)
        apart = math.inf
        if case.rule.link_distance is not None:
            apart = min(case.rule.link_distance(case.steel, demand).value for demand in inside)
        options = [
            option(diameter=diameter, spacing_x=spacing, spacing_y=spacing)
            for diameter in diameters
            if (spacing := _spacing(diameter, needed, apart)) >= NEAREST
        ]
        if options:
            yield min(options, key=lambda links: (links.area, -links.spacing_x))
        else:
            yield Message("no links that are allowed are enough against one-way shear at {place:.3f m}",
                          place=inside[0].place)  # fmt: skip


def _spacing(diameter: float, needed: float, apart: float) -> float:
    """Return how far legs of a diameter [m] in a square grid may be from each other [m] for an area [m2/m2]."""
    most = min(math.sqrt(math.pi * diameter**2 / 4 / needed), apart)
    return round(STEP * math.floor(most / STEP + ROUNDING), 6)


def _demands(case: ShearCase, results: CombinationResult) -> Iterator[ShearDemand]:
    """Yield the demands of all places of a combination that need links."""
    sorted_places = case.places.of(results)
    for plate in plates_that_count(results, relieves=case.steel.line_force_relieves):
        for places in sorted_places.beyond:
            v, rho, _ = read_demand(results, plate, places)
            without = case.rule.resistance(case.steel, results.limit_state, places.d, rho)
            for k in np.flatnonzero(_counts(results, places) & (v > without)).tolist():
                sizes = float(v[k]), float(without[k]), float(places.d[k]), float(places.thickness[k])
                yield ShearDemand(results, place_of(places.xy, k), *sizes, rho=float(rho[k]))


def _counts(results: CombinationResult, places: Places) -> Flags:
    """Return which places count (k,), whatever links stand there."""
    return places.counts & ~near_forces(results, places.xy, places.d)


def _rectangles(
    demands: list[ShearDemand], rounding: float
) -> Iterator[tuple[tuple[float, float, float, float], list[ShearDemand]]]:
    """Yield rectangles that cover what lies around demands, none over another, with the demands in each."""
    from shapely import box, total_bounds

    shapes: list[tuple[BaseGeometry, list[ShearDemand]]] = []
    for demand in demands:
        x, y = demand.place
        reach = BEYOND * demand.d
        rectangle: BaseGeometry = box(x - reach, y - reach, x + reach, y + reach)
        inside = [demand]
        while met := [group for group in shapes if group[0].intersects(rectangle)]:
            shapes = [group for group in shapes if group not in met]
            rectangle = box(*total_bounds([rectangle, *(shape for shape, _ in met)]))
            inside = [*inside, *(met_demand for _, others in met for met_demand in others)]
        shapes.append((rectangle, inside))
    for shape, inside in shapes:
        low = [rounding * math.floor(way / rounding + ROUNDING) for way in shape.bounds[:2]]
        high = [rounding * math.ceil(way / rounding - ROUNDING) for way in shape.bounds[2:]]
        x0, y0, x1, y1 = (round(way, 6) for way in (*low, *high))
        yield (x0, y0, x1, y1), inside
