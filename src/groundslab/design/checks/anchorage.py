"""Whether the bars of zones go on far enough beyond where they are needed: what of them is developed at each node.

A bar that ends counts in full where it goes on by its anchorage length and the shift of moments, and in proportion
before (EN 1992-1-1 8.4, 9.2.1.3; ACI 318-19 25.4.2, 7.7.3). Bars that run all over the slab, and bars of zones at the
slab's edges, end at edges, where U-shaped bars hold them; where the case says that there are none, these are developed
from the edge on, too.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.messages import Clause, Message
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import LaidBars, axis_of, bar_area, laid_bars, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import get_plate_region
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import Results

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

NAME = "anchorage of bars"
CM2 = 1e4
#: A zone ends at the slab's edge if it ends no farther from it [m]: bars have a cover there.
AT_EDGE = 0.1
#: Nodes on curved edges lie no farther off the polygon that stands for the slab [m].
OFF_CHORD = 1e-3
#: What counts as rounding, relative.
ROUNDING = 1e-6


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield whether bars that are laid are developed where bending and the minimum need them, in the worst layer."""
    steel, results = combined.model.reinforcement, ultimate_results(combined)
    if steel is None or not steel.laid or not steel.zones or not results:
        return
    code = code_of(steel)
    rule = code.detailing
    if rule is None:
        return
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    required = required_areas(steel, results)
    slab = get_plate_region(combined.model.plate, combined.model.plates).area
    worst: tuple[float, str, int, Array, Array] | None = None
    for layer in LAYERS:
        zones = [zone for zone in steel.zones if layer in zone.layers]
        if not zones:
            continue
        needed = largest_areas(required, layer)[0]
        laid = laid_bars(steel, layer, plate.nodes)
        base = steel.base_bars(layer)
        assert base is not None
        ending = _Layer(layer, steel, rule, laid, plate.nodes, thickness, slab)
        developed = np.full(len(needed), bar_area(base)) if ending.held else ending.developed(base, slab)
        for zone in zones:
            developed = developed + ending.developed(zone.bars, polygon_of(zone.shape.ring()).intersection(slab))
        # bars that are too few by themselves are told by the check of areas
        judged = (needed > 0) & (needed <= laid.area)
        used = np.divide(needed, developed, out=np.full(len(needed), np.inf), where=developed > 0)
        used = np.where(judged, used, 0.0)
        node = int(np.argmax(used))
        if worst is None or used[node] > worst[0]:
            worst = float(used[node]), layer, node, needed, developed
    if worst is None:
        return
    used_most, layer, node, needed, developed = worst
    holds = used_most <= 1 + ROUNDING
    clauses = f"{rule.clauses['anchorage']}, {rule.clauses['shift']}"
    words = Message(
        "{layer}: {needed:.4g (cm2/m)} {sign} {developed:.4g cm2/m} of developed bars at {place:.3f m} ({clause})",
        layer=layer.replace("_", " "),
        needed=needed[node] * CM2,
        sign="<=" if holds else ">",
        developed=developed[node] * CM2,
        place=place_of(plate.nodes, node),
        clause=Clause(clauses),
    )
    yield DesignCheck(
        NAME, "no failure found" if holds else "fails", words, of=layer.replace("_", " "),
        demand=float(needed[node]) * CM2, resistance=float(developed[node]) * CM2, unit="cm2/m",
        clause=f"{code.name} {clauses}", place=place_of(plate.nodes, node),
    )  # fmt: skip


class _Layer(NamedTuple):
    """A layer of bars, and where it lies."""

    name: str
    steel: Reinforcement
    rule: DetailingRule
    laid: LaidBars
    nodes: Array  # (n, 2) [m]
    thickness: Array  # (n,) [m]
    slab: BaseGeometry

    @property
    def held(self) -> bool:
        """Return whether U-shaped bars hold the edges of the slab."""
        return self.steel.detailing is None or self.steel.detailing.edge_bars

    def developed(self, bars: Bars, region: BaseGeometry) -> Array:
        """Return what area of bars in a region of the slab is developed at the nodes (n,) [m2/m]."""
        inside, before, after = _to_ends(self.slab, region, self.name, self.nodes)
        developed = np.zeros(len(self.nodes))
        if not len(inside):
            return developed
        axis, most = axis_of(self.steel, self.name), float(self.thickness[inside].max())
        below = most - axis if self.name.startswith("top") else axis
        apart = float((self.laid.clear[inside] + self.laid.thickest[inside]).min())
        l_b = self.rule.anchorage(self.steel, EndingBar(bars.diameter, axis, apart, below, most - below))
        ends = [np.where(at_edge & self.held, np.inf, way) for way, at_edge in (before, after)]
        a_l = self.rule.shift(self.thickness[inside] - axis, bars.diameter)
        developed[inside] = bar_area(bars) * np.clip((np.minimum(*ends) - a_l) / l_b, 0.0, 1.0)
        return developed


def _to_ends(
    slab: BaseGeometry, region: BaseGeometry, layer: str, nodes: Array
) -> tuple[Integers, tuple[Array, Flags], tuple[Array, Flags]]:
    """Return the nodes in a region (k,), how far bars go on on both sides [m], and whether to the slab's edge."""
    from shapely import distance, get_coordinates, get_parts, intersection, length, linestrings, points

    axis = "xy".index(layer[-1])
    inside = np.flatnonzero(distance(points(nodes), region) <= OFF_CHORD) if region.area else np.empty(0, dtype=int)
    if not len(inside):
        nothing = np.empty(0), np.empty(0, dtype=bool)
        return inside, nothing, nothing
    lines = _lines_through(nodes[inside], axis, np.array(region.bounds).reshape(2, 2))
    pieces, which = get_parts(intersection(linestrings(lines), region), return_index=True)
    places, of_piece = get_coordinates(pieces, return_index=True)
    first, last = (
        np.array([reduce(places[of_piece == number, axis]) for number in range(len(pieces))])
        for reduce in (np.min, np.max)
    )
    # a line along a border of the region comes in pieces that go on from each other
    order = np.lexsort((first, which))
    which, first, last = which[order], first[order], last[order]
    begins = np.concatenate([[True], (which[1:] != which[:-1]) | (first[1:] > last[:-1] + ROUNDING)])
    first, last, which = first[begins], np.maximum.reduceat(last, np.flatnonzero(begins)), which[begins]
    at = nodes[inside][which, axis]
    near = np.maximum(np.maximum(first - at, at - last), 0.0)
    order = np.lexsort((near, which))
    _, chosen = np.unique(which[order], return_index=True)
    ends = np.stack([first[order[chosen]], last[order[chosen]]])
    sides = []
    for end, sign in zip(ends, (-1.0, 1.0), strict=True):
        beyond = lines.copy()
        beyond[:, 0, axis], beyond[:, 1, axis] = end, end + sign * AT_EDGE
        off = length(intersection(linestrings(beyond), slab)) < AT_EDGE - ROUNDING
        sides.append((np.maximum(sign * (end - nodes[inside][:, axis]), 0.0), np.asarray(off)))
    return inside, sides[0], sides[1]


def _lines_through(places: Array, axis: int, bounds: Array) -> Array:
    """Return lines (k, 2, 2) along an axis through places (k, 2) that go through all of what has bounds (2, 2) [m]."""
    lines = np.repeat(places[:, None], 2, axis=1)
    lines[:, :, axis] = bounds[:, axis] + (-1.0, 1.0)
    first, last = bounds[:, 1 - axis] + (OFF_CHORD, -OFF_CHORD)
    lines[:, :, 1 - axis] = np.clip(lines[:, :, 1 - axis], first, max(first, last))
    return lines
