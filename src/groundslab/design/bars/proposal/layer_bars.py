"""The base and the zones of one layer with the least steel, from what its cells need."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.proposal.base_parts import OVER, BasePart, best_part
from groundslab.design.bars.proposal.covering import Field, Options, Zone, cover
from groundslab.design.bars.proposal.plan_grid import PARTS, PlanGrid, Rectangle, Window, spread_along
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import bar_area
from groundslab.model.design.reinforcement import Reinforcement

#: Spacings of a zone's bars over those of the base, and how many of them lie in a gap of the base at most.
MULTIPLES = {0.5: 2, 1.0: 1, 2.0: 1}
#: The same of additional bars where the base has a part of its own, whose bars lie in each gap: one more there.
BESIDE_PART = {1.0: 2, 2.0: 2}
#: So many bases with a part of their own are covered in coarse blocks.
MOST_PARTS = 10
#: Blocks of cells along and across at most, where all bases are compared, and where the best of them are.
COARSE, FINE = 10, 24
#: How many bases are covered in fine blocks.
BEST = 5
#: What counts as rounding, relative.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class LayerTask:
    """What the bars of a layer are chosen for.

    Attributes
    ----------
    grid : PlanGrid
        The cells of the plan.
    needs : callable
        Of a diameter and the base's spacing: what cells need of bars that are no thicker [m2/m], (m, w) along and
        across the bars, PARTS times finer along them.
    thickness : array (m, w)
        Of the slab in these cells, the largest [m].
    axis : int
        Along which they run, 0 of x.
    distance : float
        Of their axes from the face [m].
    at_top : bool
        Whether that is the top.
    diameters, spacings : tuple of float
        That are allowed, of the base [m].
    least : float
        What the base has at least, if any that is allowed has so much [m2/m].
    farthest : callable
        Of a diameter: the largest distance of bars for cracks [m].
    """

    grid: PlanGrid
    needs: Callable[[float, float], Array]
    thickness: Array
    axis: int
    distance: float
    at_top: bool
    diameters: tuple[float, ...]
    spacings: tuple[float, ...]
    least: float = 0.0
    farthest: Callable[[float], float] = lambda _: math.inf

    def bar(self, diameter: float, spacing: float) -> EndingBar:
        """Return a bar of the layer as it is anchored, where the slab is thickest, with most fresh concrete below."""
        thickest = float(self.thickness.max())
        below = thickest - self.distance if self.at_top else self.distance
        return EndingBar(diameter, self.distance, spacing, below, thickest - below)

    def shift(self, diameter: float, rule: DetailingRule) -> Array:
        """Return how far moments are shifted along the bars, in whole cells (m, w)."""
        shift = rule.shift(self.thickness - self.distance, diameter)
        return np.ceil(np.maximum(shift, 0.0) / self.grid.step * PARTS - ROUNDING)

    def needs_in_plan(self, diameter: float, spacing: float) -> Array:
        """Return what cells (m, w) need [m2/m], 0 off the plan."""
        return np.where(self.area > 0, self.needs(diameter, spacing), 0.0)

    def shifted(self, needs: Array, shift: Array) -> Array:
        """Return what cells (m, w) need [m2/m] with the shift of moments along the bars, 0 off the plan."""
        return np.where(self.area > 0, spread_along(needs, shift), 0.0)

    @property
    def area(self) -> Array:
        """Return what of the cells (m, w) is in the plan [m2]."""
        area = self.grid.area if self.axis == 0 else self.grid.area.T
        return np.repeat(area / PARTS, PARTS, axis=0)


@dataclass(frozen=True, slots=True)
class LayerProposal:
    """The base of a layer, with more bars in a part of the slab, and the bars of zones, with rectangles from the left.

    The part is one rectangle, or as many as it has images where the slab is symmetric.
    """

    base: Bars
    zones: tuple[tuple[Bars, Rectangle], ...]
    part: tuple[tuple[Bars, Rectangle], ...] = ()

    @property
    def thickest(self) -> float:
        """Return the largest diameter [m]."""
        return max(bars.diameter for bars in (self.base, *(bars for bars, _ in (*self.part, *self.zones))))

    def rectangles(self, layer: str) -> dict[str, tuple[Bars, Rectangle]]:
        """Return all bars in rectangles by the names of these, with that of the layer."""
        words = layer.replace("_", " ")
        several = len(self.part) > 1
        of_part = {f"{words} base {n}" if several else f"{words} base": placed for n, placed in enumerate(self.part, 1)}
        return of_part | {f"{words} {n}": placed for n, placed in enumerate(self.zones, 1)}


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A base, what cells need beyond it, and the bars that zones may have, no thicker than is counted on."""

    base: Bars
    field: Field
    additions: tuple[Bars, ...]
    options: Options
    part: BasePart | None = None

    @property
    def of_base(self) -> float:
        """Return the steel of the base and its part [m3]."""
        of_part = 0.0 if self.part is None else self.part.steel(self.field)
        return bar_area(self.base) * float(self.field.area.sum()) + of_part

    @property
    def lowest(self) -> float:
        """Return the steel at least [m3]: of the base, and of what is needed beyond it."""
        return self.of_base + float((self.field.excess * self.field.area).sum())

    def expected(self, over: float) -> float:
        """Return about what steel there will be [m3], zones having so many times what is needed beyond the base."""
        return self.of_base + over * float((self.field.excess * self.field.area).sum())


def propose_layer(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> LayerProposal | None:
    """Return the bars of a layer with the least steel for what cells need; None if none are enough.

    Zones beside each base are found in coarse blocks of cells first, in fine ones for those that then take least steel.
    """
    candidates = list(_candidates(task, steel, rule))
    most = steel.proposal.most_zones
    price = steel.proposal.least_saving * min((candidate.lowest for candidate in candidates), default=0.0)

    def best(of: list[_Candidate], blocks: int, number: int) -> list[tuple[float, _Candidate, list[Zone]]]:
        cheapest = list[tuple[float, _Candidate, list[Zone]]]()
        for candidate in sorted(of, key=lambda trial: trial.lowest):
            if len(cheapest) == number and candidate.lowest >= cheapest[-1][0] * (1 - ROUNDING):
                break
            parts = 0 if candidate.part is None else candidate.part.count(candidate.field)
            if parts > most:
                continue
            without_zones = candidate.of_base + price * parts
            limit = cheapest[-1][0] - without_zones if len(cheapest) == number else math.inf
            zones = cover(candidate.field, candidate.options, most - parts, price, blocks, limit)
            if zones is not None:
                cost = candidate.of_base + sum(zone.steel + price * zone.count for zone in zones) + price * parts
                cheapest = sorted([*cheapest, (cost, candidate, zones)], key=lambda costed: costed[0])[:number]
        return cheapest

    coarse = best(candidates, COARSE, BEST)
    for _, candidate, zones in best([candidate for _, candidate, _ in coarse], FINE, 1):
        return _proposal(candidate, zones, task)
    return None


def _proposal(candidate: _Candidate, zones: list[Zone], task: LayerTask) -> LayerProposal:
    """Return a base with its part and zones."""
    laid = [
        (candidate.additions[zone.option], rectangle)
        for zone in zones
        for rectangle in _rectangles(task, zone.cells)
    ]  # fmt: skip
    part = candidate.part
    of_part = () if part is None else tuple((part.bars, rectangle) for rectangle in _rectangles(task, part.cells))
    return LayerProposal(candidate.base, tuple(sorted(laid, key=lambda zone: zone[1])), of_part)


def _rectangles(task: LayerTask, cells: Window) -> list[Rectangle]:
    """Return the rectangles of cells along and across the bars, and of their images."""
    i0, i1, j0, j1 = cells
    along, across = (i0 // PARTS, i1 // PARTS), (j0, j1)
    return task.grid.rectangles((*along, *across) if task.axis == 0 else (*across, *along))


def _candidates(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> Iterator[_Candidate]:
    """Yield what may be tried and may be enough."""
    bases = list(_bases(task, steel, rule))
    enough = [base for base in bases if bar_area(base) >= task.least * (1 - ROUNDING)]
    needs_of = cache(partial(_needs, task, rule=rule))
    tried = [attempt for base in enough or bases for attempt in _with_base(task, base, needs_of)]
    for base, thickest, _, field in tried:
        additions = [bars for bars in _additions(task, base, MULTIPLES, rule, steel) if bars.diameter <= thickest]
        if _most(additions) * (1 + ROUNDING) >= field.excess.max():
            options = _options(task, base, additions, MULTIPLES, steel, rule)
            yield _Candidate(base, field, tuple(additions), options)
    for over in OVER:
        with_parts = _with_parts(task, tried, steel, rule, over)
        yield from heapq.nsmallest(MOST_PARTS, with_parts, key=lambda candidate: candidate.expected(over))


class _Needs(NamedTuple):
    """What cells (m, w) need of bars that are no thicker, and the shift of moments, in cells."""

    area: Array  # [m2/m]
    shift: Array
    shifted: Array  # with it [m2/m]


def _needs(task: LayerTask, thickest: float, spacing: float, rule: DetailingRule) -> _Needs:
    """Return what cells need of bars of a diameter [m] or thinner ones, the base having a spacing [m]."""
    area, shift = task.needs_in_plan(thickest, spacing), task.shift(thickest, rule)
    return _Needs(area, shift, task.shifted(area, shift))


#: A base, the thickest bars that are counted on, what cells need, and the field beyond the base.
_Tried = tuple[Bars, float, _Needs, Field]


def _with_base(task: LayerTask, base: Bars, needs_of: Callable[[float, float], _Needs]) -> Iterator[_Tried]:
    """Yield a base with what cells need beyond it, by the thickest bars that are counted on and the base's spacing."""
    area = task.area
    folded = task.grid.folded if task.axis == 0 else task.grid.folded[::-1]
    last: Array | None = None
    for thickest in (diameter for diameter in reversed(task.diameters) if diameter >= base.diameter):
        needs = needs_of(thickest, base.spacing)
        excess = _beyond(needs.shifted, base)
        # thinner bars are of use only where cracks then need less
        if np.isinf(excess).any() or (last is not None and np.array_equal(needs.shifted, last)):
            continue
        last = needs.shifted
        yield base, thickest, needs, Field(excess, area, PARTS, folded)


def _beyond(needs: Array, base: Bars) -> Array:
    """Return what cells (m, w) need beyond a base [m2/m]."""
    return np.maximum(needs - bar_area(base) * (1 + ROUNDING), 0.0)


def _with_parts(
    task: LayerTask, tried: Sequence[_Tried], steel: Reinforcement, rule: DetailingRule, over: float
) -> Iterator[_Candidate]:
    """Yield bases with more bars in a part of the slab, that may be enough; `over` as in `best_part`."""
    for base, thickest, needs, field in tried:
        every = [bars for bars in _additions(task, base, BESIDE_PART, rule, steel) if bars.diameter <= thickest]
        if not every:
            continue
        options = _options(task, base, every, BESIDE_PART, steel, rule)
        for bars, anchorage in zip(every, options.anchorage.tolist(), strict=True):
            # a gap of the base has one bar of its part
            part = best_part(field, bars, anchorage, options.least, over) if bars.spacing == base.spacing else None
            if part is None:
                continue
            left = np.maximum(_beyond(needs.area, base) - part.developed(field, needs.shift), 0.0)
            of_zones = replace(field, excess=task.shifted(left, needs.shift))
            if _most(every) * (1 + ROUNDING) >= of_zones.excess.max():
                yield _Candidate(base, of_zones, tuple(every), options, part)


def _most(additions: Sequence[Bars]) -> float:
    """Return the largest area of additional bars [m2/m]."""
    return max((bar_area(bars) for bars in additions), default=0.0)


def _options(
    task: LayerTask,
    base: Bars,
    additions: Sequence[Bars],
    multiples: Mapping[float, int],
    steel: Reinforcement,
    rule: DetailingRule,
) -> Options:
    """Return the bars that zones may have beside a base, with their lengths in cells."""
    step = task.grid.step
    apart = [base.spacing / (multiples[round(bars.spacing / base.spacing, 3)] + 1) for bars in additions]
    anchorage = [
        rule.anchorage(steel, task.bar(bars.diameter, distance))
        for bars, distance in zip(additions, apart, strict=True)
    ]
    least = max(1, math.ceil(steel.proposal.least_size / step - ROUNDING))
    area = np.array([bar_area(bars) for bars in additions])
    return Options(area, np.array(anchorage) / step * PARTS, (least * PARTS, least))


def _bases(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> Iterator[Bars]:
    """Yield what bars the base may have."""
    for diameter in task.diameters:
        for spacing in task.spacings:
            clear = spacing - diameter >= rule.least_clear(steel, diameter) - ROUNDING
            if clear and spacing <= task.farthest(diameter) + ROUNDING:
                yield Bars(diameter=diameter, spacing=spacing)


def _additions(
    task: LayerTask, base: Bars, multiples: Mapping[float, int], rule: DetailingRule, steel: Reinforcement
) -> Iterator[Bars]:
    """Yield what bars a zone may have beside a base; those in a gap of the base divide it evenly."""
    for multiple, in_gap in multiples.items():
        for diameter in task.diameters if steel.proposal.most_zones else ():
            thickest = max(diameter, base.diameter)
            room = base.spacing / (in_gap + 1) - thickest >= rule.least_clear(steel, thickest) - ROUNDING
            bars = Bars(diameter=diameter, spacing=round(multiple * base.spacing, 6))
            # thinner bars than those of the base have more cover
            near = min(base.spacing, bars.spacing) <= task.farthest(min(diameter, base.diameter)) + ROUNDING
            if room and near:
                yield bars
