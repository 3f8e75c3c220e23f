"""Whether the bars of zones go on far enough beyond where they are needed: what of them is developed at each node.

A bar that ends counts in full where it goes on by its anchorage length and the shift of moments, and in proportion
before (EN 1992-1-1 8.4, 9.2.1.3; ACI 318-19 25.4.2, 7.7.3). Bars that run all over the slab, and bars of zones at the
slab's edges, end at edges, where U-shaped bars hold them unless the case says that there are none.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.messages import Clause, Message
from groundslab.model.design.bars import BarZone
from groundslab.model.design.laid_bars import LaidBars, axis_of, bar_area, laid_bars, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import get_plate_region
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import Results

NAME = "anchorage of bars"
CM2 = 1e4
#: A zone ends at the slab's edge if it ends no farther from it [m]: bars have a cover there.
AT_EDGE = 0.1
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
    worst: tuple[float, str, int, Array, Array] | None = None
    for layer in LAYERS:
        zones = [zone for zone in steel.zones if layer in zone.layers]
        if not zones:
            continue
        needed = largest_areas(required, layer)[0]
        laid = laid_bars(steel, layer, plate.nodes)
        lost = sum(
            (_undeveloped(combined, steel, rule, (layer, zone), laid, thickness) for zone in zones),
            start=np.zeros(len(needed)),
        )
        developed = laid.area - lost
        # bars that are too few by themselves are told by the check of areas
        used = np.where(needed <= laid.area, needed / developed, 0.0)
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


def _undeveloped(
    combined: Results,
    steel: Reinforcement,
    rule: DetailingRule,
    of: tuple[str, BarZone],
    laid: LaidBars,
    thickness: Array,
) -> Array:
    """Return what area of a zone's bars in a layer is not developed at the plate's nodes (n,) [m2/m]."""
    layer, zone = of
    nodes = ultimate_results(combined)[0].plate.nodes
    inside, before, after = _to_ends(combined, zone, layer, nodes)
    lost = np.zeros(len(nodes))
    if not len(inside):
        return lost
    diameter, axis, most = zone.bars.diameter, axis_of(steel, layer), float(thickness[inside].max())
    below = most - axis if layer.startswith("top") else axis
    apart = float((laid.clear[inside] + laid.thickest[inside]).min())
    l_b = rule.anchorage(steel, EndingBar(diameter, axis, apart, below, most - below))
    held = steel.detailing is None or steel.detailing.edge_bars
    ends = [np.where(at_edge & held, np.inf, way) for way, at_edge in (before, after)]
    a_l = rule.shift(most - axis, diameter)
    share = np.clip((np.minimum(*ends) - a_l) / l_b, 0.0, 1.0)
    lost[inside] = (1 - share) * bar_area(zone.bars)
    return lost


def _to_ends(
    combined: Results, zone: BarZone, layer: str, nodes: Array
) -> tuple[Integers, tuple[Array, Flags], tuple[Array, Flags]]:
    """Return the nodes in a zone (k,), how far bars go on before and after them [m], and whether to the slab's edge."""
    from shapely import distance, get_coordinates, get_parts, intersection, intersects_xy, linestrings, points

    model, axis = combined.model, "xy".index(layer[-1])
    slab = get_plate_region(model.plate, model.plates).area
    region = polygon_of(zone.shape.ring()).intersection(slab)
    inside = np.flatnonzero(intersects_xy(region, *nodes.T)) if region.area else np.empty(0, dtype=int)
    if not len(inside):
        nothing = np.empty(0), np.empty(0, dtype=bool)
        return inside, nothing, nothing
    low, high = np.array(region.bounds).reshape(2, 2)[:, axis]
    lines = np.repeat(nodes[inside][:, None], 2, axis=1)
    lines[:, 0, axis], lines[:, 1, axis] = low - 1.0, high + 1.0
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
        beyond = nodes[inside].copy()
        beyond[:, axis] = end + sign * AT_EDGE
        off = distance(points(beyond), slab) > 0
        sides.append((np.maximum(sign * (end - nodes[inside][:, axis]), 0.0), np.asarray(off)))
    return inside, sides[0], sides[1]
