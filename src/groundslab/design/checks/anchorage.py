"""Whether the bars of zones go on far enough beyond where they are needed: what of them is developed at each node.

A bar that ends counts in full where it goes on by its anchorage length and the shift of moments, and in proportion
before (EN 1992-1-1 8.4, 9.2.1.3; ACI 318-19 25.4.2, 7.7.3). Bars that run all over the slab, and bars of zones at the
slab's edges, end at edges, where U-shaped bars hold them; where the case says that there are none, these are developed
from the edge on, too. Steps at pits are edges of what lies at either level.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.by_plate import nodes_at
from groundslab.design.rules.calculation import Step
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
    rule = code_of(steel).detailing
    if rule is None:
        return
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    required = required_areas(steel, results)
    covered = get_plate_region(combined.model.plate, combined.model.plates)
    levels = [(level, nodes_at(results[0], level)) for level in covered.levels]
    worst: tuple[float, int, _Layer, Array, list[_Developed]] | None = None
    for layer in LAYERS:
        zones = [zone for zone in steel.zones if layer in zone.layers]
        if not zones:
            continue
        needed = largest_areas(required, layer)[0]
        laid = laid_bars(steel, layer, plate.nodes)
        ending = [_Layer(layer, steel, rule, laid, plate.nodes, thickness, *level) for level in levels]
        sets = [part.base() for part in ending]
        sets += [
            part.developed(zone.bars, polygon_of(zone.shape.ring()).intersection(part.slab))
            for zone in zones
            for part in ending
        ]
        developed = np.sum([bar_set.area for bar_set in sets], axis=0)
        # bars that are too few by themselves are told by the check of areas
        judged = (needed > 0) & (needed <= laid.area)
        used = np.divide(needed, developed, out=np.full(len(needed), np.inf), where=developed > 0)
        used = np.where(judged, used, 0.0)
        node = int(np.argmax(used))
        if worst is None or used[node] > worst[0]:
            worst = float(used[node]), node, ending[0], needed, sets
    if worst is not None:
        yield _check(*worst)


def _check(used: float, node: int, ending: _Layer, needed: Array, sets: list[_Developed]) -> DesignCheck:
    """Return the check of a layer at the node where most of the developed bars is used."""
    holds = used <= 1 + ROUNDING
    clauses = f"{ending.rule.clauses['anchorage']}, {ending.rule.clauses['shift']}"
    name, place = ending.name.replace("_", " "), place_of(ending.nodes, node)
    developed = float(sum(bar_set.area[node] for bar_set in sets))
    words = Message(
        "{layer}: {needed:.4g (cm2/m)} {sign} {developed:.4g cm2/m} of developed bars at {place:.3f m} ({clause})",
        layer=name,
        needed=needed[node] * CM2,
        sign="<=" if holds else ">",
        developed=developed * CM2,
        place=place,
        clause=Clause(clauses),
    )
    return DesignCheck(
        NAME, "no failure found" if holds else "fails", words, of=name,
        demand=float(needed[node]) * CM2, resistance=developed * CM2, unit="cm2/m",
        clause=f"{code_of(ending.steel).name} {clauses}", place=place,
        steps=tuple(_steps(ending, float(needed[node]), [bars for bars in sets if bars.to_end[node] >= 0], node)),
    )  # fmt: skip


def _steps(ending: _Layer, needed: float, sets: list[_Developed], node: int) -> Iterator[Step]:
    """Yield how much of each set of bars (one at least) is developed at a node where an area is needed [m2/m]."""
    clauses, names = ending.rule.clauses, list[str]()
    for n, bar_set in enumerate(sets, 1):
        yield Step(Message("diameter of bars {n}", n=n), f"phi_{n}", bar_set.bars.diameter, "m")
        yield Step(Message("distance of bars {n}", n=n), f"s_{n}", bar_set.bars.spacing, "m")
        area, formula = bar_area(bar_set.bars) * CM2, f"pi / 4 * phi_{n}^2 / s_{n} * 10000"
        yield Step(Message("area of bars {n}", n=n), f"A_{n}", area, "cm2/m", formula)
        names.append(f"A_{n}")
        if bar_set.ending is None or bar_set.shift is None or not np.isfinite(bar_set.to_end[node]):
            continue  # held at edges
        yield Step(Message("distance to the nearer end of bars {n}", n=n), f"x_{n}", float(bar_set.to_end[node]), "m")
        words = Message("shift of moments for bars {n}", n=n)
        yield Step(words, f"a_l,{n}", float(bar_set.shift[node]), "m", clause=clauses["shift"])
        yield from ending.rule.anchorage_steps(ending.steel, bar_set.ending, n)
        words, names[-1] = Message("what is developed of bars {n}", n=n), f"A_d,{n}"
        formula = f"A_{n} * max(0, min(1, (x_{n} - a_l,{n}) / l_b,{n}))"
        yield Step(words, f"A_d,{n}", float(bar_set.area[node]) * CM2, "cm2/m", formula, clauses["anchorage"])
    developed = float(sum(bar_set.area[node] for bar_set in sets)) * CM2
    yield Step("area of developed bars", "A_d", developed, "cm2/m", " + ".join(names))
    yield Step("required area", "A_req", needed * CM2, "cm2/m")
    if developed > 0:
        yield Step("share used", "eta", needed * CM2 / developed, "", "A_req / A_d")


class _Developed(NamedTuple):
    """What of a set of bars is developed at the nodes."""

    bars: Bars
    area: Array  # (n,) [m2/m]
    to_end: Array  # (n,): to the nearer end [m], infinite where it is held, negative where there are no bars
    ending: EndingBar | None = None  # None where no bar ends in the slab
    shift: Array | None = None  # (n,): of moments where bars end [m]


class _Layer(NamedTuple):
    """A layer of bars, and where it lies."""

    name: str
    steel: Reinforcement
    rule: DetailingRule
    laid: LaidBars
    nodes: Array  # (n, 2) [m]
    thickness: Array  # (n,) [m]
    slab: BaseGeometry  # what of the slab lies at one level
    there: Flags  # (n,): which nodes lie at that level

    @property
    def held(self) -> bool:
        """Return whether U-shaped bars hold the edges of the slab."""
        return self.steel.detailing is None or self.steel.detailing.edge_bars

    def base(self) -> _Developed:
        """Return what of the bars all over the slab is developed at the nodes."""
        bars = self.steel.base_bars(self.name)
        assert bars is not None
        if not self.held:
            return self.developed(bars, self.slab)
        return _Developed(bars, np.where(self.there, bar_area(bars), 0.0), np.where(self.there, np.inf, -1.0))

    def developed(self, bars: Bars, region: BaseGeometry) -> _Developed:
        """Return what of bars in a region of the slab is developed at the nodes."""
        inside, before, after = _to_ends(self.slab, region, self.name, self.nodes, self.there)
        developed, to_end = np.zeros(len(self.nodes)), np.full(len(self.nodes), -1.0)
        if not len(inside):
            return _Developed(bars, developed, to_end)
        axis, most = axis_of(self.steel, self.name), float(self.thickness[inside].max())
        below = most - axis if self.name.startswith("top") else axis
        apart = float((self.laid.clear[inside] + self.laid.thickest[inside]).min())
        bar = EndingBar(bars.diameter, axis, apart, below, most - below)
        l_b = self.rule.anchorage(self.steel, bar)
        ends = [np.where(at_edge & self.held, np.inf, way) for way, at_edge in (before, after)]
        to_end[inside] = np.minimum(*ends)
        shift = np.zeros(len(to_end))
        shift[inside] = self.rule.shift(self.thickness[inside] - axis, bars.diameter)
        developed[inside] = bar_area(bars) * np.clip((to_end[inside] - shift[inside]) / l_b, 0.0, 1.0)
        return _Developed(bars, developed, to_end, bar, shift)


def _to_ends(
    slab: BaseGeometry, region: BaseGeometry, layer: str, nodes: Array, at_level: Flags
) -> tuple[Integers, tuple[Array, Flags], tuple[Array, Flags]]:
    """Return the nodes in a region (k,), how far bars go on on both sides [m], and whether to the slab's edge.

    Only nodes at its level (n,) count.
    """
    from shapely import distance, get_coordinates, get_parts, intersection, length, linestrings, points

    axis = "xy".index(layer[-1])
    near = (
        (distance(points(nodes), region) <= OFF_CHORD) & at_level if region.area else np.zeros(len(nodes), dtype=bool)
    )
    inside = np.flatnonzero(near)
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
