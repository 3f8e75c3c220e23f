"""The base and the zones of one layer with the least steel, from what its cells need."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.proposal.covering import Field, Options, Zone, cover
from groundslab.design.bars.proposal.plan_grid import PARTS, PlanGrid, Rectangle, spread_along
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import bar_area
from groundslab.model.design.reinforcement import Reinforcement

#: Spacings of a zone's bars over those of the base, and how many of them lie in a gap of the base at most.
MULTIPLES = {0.5: 2, 1.0: 1, 2.0: 1}
#: Blocks of cells along and across at most, where all bases are compared, and where the best of them are.
COARSE, FINE = 10, 24
#: How many bases are covered in fine blocks.
BEST = 4
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

    def shifted_needs(self, diameter: float, spacing: float, rule: DetailingRule) -> Array:
        """Return what cells (m, w) need [m2/m] with the shift of moments along the bars, 0 off the plan."""
        shift = rule.shift(self.thickness - self.distance, diameter)
        reach = np.ceil(shift / self.grid.step * PARTS - ROUNDING)
        return np.where(self.area > 0, spread_along(self.needs(diameter, spacing), reach), 0.0)

    @property
    def area(self) -> Array:
        """Return what of the cells (m, w) is in the plan [m2]."""
        area = self.grid.area if self.axis == 0 else self.grid.area.T
        return np.repeat(area / PARTS, PARTS, axis=0)


@dataclass(frozen=True, slots=True)
class LayerProposal:
    """The base of a layer, and the bars of its zones with their rectangles, from the left."""

    base: Bars
    zones: tuple[tuple[Bars, Rectangle], ...]


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A base, what cells need beyond it, and the bars that zones may have, no thicker than is counted on."""

    base: Bars
    field: Field
    additions: tuple[Bars, ...]
    options: Options

    @property
    def of_base(self) -> float:
        """Return the steel of the base [m3]."""
        return bar_area(self.base) * float(self.field.area.sum())

    @property
    def lowest(self) -> float:
        """Return the steel at least [m3]: of the base, and of what is needed beyond it."""
        return self.of_base + float((self.field.excess * self.field.area).sum())


def propose_layer(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> LayerProposal | None:
    """Return the bars of a layer with the least steel for what cells need; None if none are enough.

    Zones beside each base are found in coarse blocks of cells first, in fine ones for those that then take least steel.
    """
    candidates = list(_candidates(task, steel, rule))
    most = steel.proposal.most_zones
    price = steel.proposal.least_saving * min((candidate.lowest for candidate in candidates), default=0.0)

    def best(of: list[_Candidate], blocks: int, number: int) -> list[tuple[float, _Candidate, list[Zone]]]:
        found = list[tuple[float, _Candidate, list[Zone]]]()
        for candidate in sorted(of, key=lambda one: one.lowest):
            if len(found) == number and candidate.lowest >= found[-1][0] * (1 - ROUNDING):
                break
            zones = cover(candidate.field, candidate.options, most, price, blocks)
            if zones is not None:
                cost = candidate.of_base + sum(zone.steel + price * zone.count for zone in zones)
                found = sorted([*found, (cost, candidate, zones)], key=lambda one: one[0])[:number]
        return found

    coarse = best(candidates, COARSE, BEST)
    for _, candidate, zones in best([candidate for _, candidate, _ in coarse], FINE, 1):
        return _proposal(candidate, zones, task)
    return None


def _proposal(candidate: _Candidate, zones: list[Zone], task: LayerTask) -> LayerProposal:
    """Return a base with its zones."""
    laid = list[tuple[Bars, Rectangle]]()
    for zone in zones:
        i0, i1, j0, j1 = zone.cells
        along, across = (i0 // PARTS, i1 // PARTS), (j0, j1)
        cells = (*along, *across) if task.axis == 0 else (*across, *along)
        laid += [(candidate.additions[zone.option], rectangle) for rectangle in task.grid.rectangles(cells)]
    return LayerProposal(candidate.base, tuple(sorted(laid, key=lambda zone: zone[1])))


def _candidates(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> Iterator[_Candidate]:
    """Yield what may be tried and may be enough."""
    area = task.area
    folded = task.grid.folded if task.axis == 0 else task.grid.folded[::-1]
    shifted = {
        (thickest, spacing): task.shifted_needs(thickest, spacing, rule)
        for thickest in task.diameters
        for spacing in task.spacings
    }
    bases = list(_bases(task, steel, rule))
    enough = [base for base in bases if bar_area(base) >= task.least * (1 - ROUNDING)]
    for base in enough or bases:
        last: Array | None = None
        for thickest in (diameter for diameter in reversed(task.diameters) if diameter >= base.diameter):
            needs = shifted[thickest, base.spacing]
            excess = np.maximum(needs - bar_area(base) * (1 + ROUNDING), 0.0)
            # thinner bars are of use only where cracks then need less
            if np.isinf(excess).any() or (last is not None and np.array_equal(needs, last)):
                continue
            last = needs
            additions = [bars for bars in _additions(task, base, rule, steel) if bars.diameter <= thickest]
            if max((bar_area(bars) for bars in additions), default=0.0) * (1 + ROUNDING) >= excess.max():
                field = Field(excess, area, PARTS, folded)
                yield _Candidate(base, field, tuple(additions), _options(task, base, additions, steel, rule))


def _options(task: LayerTask, base: Bars, additions: list[Bars], steel: Reinforcement, rule: DetailingRule) -> Options:
    """Return the bars that zones may have beside a base, with their lengths in cells."""
    step = task.grid.step
    apart = [base.spacing / (MULTIPLES[round(bars.spacing / base.spacing, 3)] + 1) for bars in additions]
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


def _additions(task: LayerTask, base: Bars, rule: DetailingRule, steel: Reinforcement) -> Iterator[Bars]:
    """Yield what bars a zone may have beside a base; those in a gap of the base divide it evenly."""
    for multiple, in_gap in MULTIPLES.items():
        for diameter in task.diameters if steel.proposal.most_zones else ():
            thickest = max(diameter, base.diameter)
            room = base.spacing / (in_gap + 1) - thickest >= rule.least_clear(steel, thickest) - ROUNDING
            bars = Bars(diameter=diameter, spacing=round(multiple * base.spacing, 6))
            # thinner bars than those of the base have more cover
            near = min(base.spacing, bars.spacing) <= task.farthest(min(diameter, base.diameter)) + ROUNDING
            if room and near:
                yield bars
