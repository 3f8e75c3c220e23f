"""The base and the zones of one layer with the least steel, from what its cells need."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.proposal.covering import Options, Window, cover, one_zone
from groundslab.design.bars.proposal.plan_grid import PARTS, PlanGrid, spread_along
from groundslab.design.rules.detailing_rule import DetailingRule, EndingBar
from groundslab.model.design.bars import Bars
from groundslab.model.design.laid_bars import bar_area
from groundslab.model.design.reinforcement import Reinforcement

#: Spacings of a zone's bars over those of the base, and how many of them lie in a gap of the base at most.
MULTIPLES = {0.5: 2, 1.0: 1, 2.0: 1}
#: Candidates are tried until so many in a row were no better than the best.
PATIENCE = 4
#: What counts as rounding, relative.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class LayerTask:
    """What the bars of a layer are chosen for.

    Attributes
    ----------
    needs : callable
        Of a diameter and the base's spacing: what cells need of bars that are no thicker [m2/m], (m, w) along and
        across the bars, PARTS times finer along them.
    axis : int
        Along which they run, 0 of x.
    distance : float
        Of their axes from the face [m].
    at_top : bool
        Whether that is the top.
    thickness : tuple of float
        The least and the greatest of the slab [m].
    diameters, spacings : tuple of float
        That are allowed, of the base [m].
    farthest : callable
        Of a diameter: the largest distance of bars for cracks [m].
    """

    needs: Callable[[float, float], Array]
    axis: int
    distance: float
    at_top: bool
    thickness: tuple[float, float]
    diameters: tuple[float, ...]
    spacings: tuple[float, ...]
    farthest: Callable[[float], float] = lambda _: math.inf

    def bar(self, diameter: float, spacing: float) -> EndingBar:
        """Return a bar of the layer as it is anchored, where the slab is thickest, with most fresh concrete below."""
        below = self.thickness[1] - self.distance if self.at_top else self.distance
        return EndingBar(diameter, self.distance, spacing, below, self.thickness[1] - below)

    def depth(self) -> float:
        """Return the largest effective depth [m]."""
        return self.thickness[1] - self.distance


@dataclass(frozen=True, slots=True)
class LayerProposal:
    """The base of a layer, its zones as bars and cells along x and y, the steel of all, and of zones' edges [m3]."""

    base: Bars
    zones: tuple[tuple[Bars, Window], ...]
    steel: float
    held: float = 0.0


@dataclass(frozen=True, slots=True)
class _Addition:
    """Bars that a zone may have: how far their axes are from the next bars [m], and whether others may lie between."""

    bars: Bars
    apart: float
    nestable: bool


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A base with zones whose bars are no thicker than a diameter, and what cells need beyond the base.

    The bound is the steel of the base and of the excess alone.
    """

    likely: float  # steel: the mean of the bound and of what one zone takes [m3]
    lowest: float  # steel at least [m3]
    base: Bars
    excess: Array
    additions: tuple[Bars, ...]  # that zones may have
    options: Options


def propose_layer(task: LayerTask, grid: PlanGrid, steel: Reinforcement, rule: DetailingRule) -> LayerProposal | None:
    """Return the bars of a layer with the least steel for what cells need; None if none are enough.

    Bases with zones up to each diameter are tried in the order of their likely steel, those left out whose bound is
    above the steel of the best, until PATIENCE in a row were no better.
    """
    area = grid.area if task.axis == 0 else grid.area.T
    fine = np.repeat(area / PARTS, PARTS, axis=0)
    candidates = _candidates(task, fine, grid, steel, rule)
    price = steel.proposal.least_saving * min((candidate.lowest for candidate in candidates), default=0.0)
    best: LayerProposal | None = None
    least = math.inf  # steel and the price of zones
    in_vain = 0
    for candidate in candidates:
        if in_vain == PATIENCE:
            break
        if candidate.lowest + price * bool(candidate.excess.any()) >= least:
            continue
        proposed = _with_zones(candidate, area, grid, steel, price)
        cost = math.inf if proposed is None else proposed.steel + proposed.held + price * len(proposed.zones)
        if cost < least * (1 - ROUNDING):
            best, least, in_vain = proposed, cost, 0
        elif proposed is not None:
            in_vain += 1
    if best is None or task.axis == 0:
        return best
    return replace(best, zones=tuple((bars, (j0, j1, i0, i1)) for bars, (i0, i1, j0, j1) in best.zones))


def _candidates(
    task: LayerTask, fine: Array, grid: PlanGrid, steel: Reinforcement, rule: DetailingRule
) -> list[_Candidate]:
    """Return what may be tried and may be enough, the likeliest to take least steel first."""
    candidates = []
    shifted: dict[tuple[float, float], Array] = {}
    for thickest in task.diameters:
        reach = math.ceil(rule.shift(task.depth(), thickest) / grid.step * PARTS - ROUNDING)
        for spacing in task.spacings:
            needs = spread_along(task.needs(thickest, spacing), reach)
            shifted[thickest, spacing] = np.where(fine > 0, needs, 0.0)
    for base in _bases(task, steel, rule):
        of_base = bar_area(base)
        last: Array | None = None
        for thickest in (diameter for diameter in reversed(task.diameters) if diameter >= base.diameter):
            needs = shifted[thickest, base.spacing]
            excess = np.maximum(needs - of_base * (1 + ROUNDING), 0.0)
            # thinner bars are of use only where cracks then need less
            if np.isinf(excess).any() or (last is not None and np.array_equal(needs, last)):
                continue
            last = needs
            additions = [one for one in _additions(task, base, rule, steel) if one.bars.diameter <= thickest]
            options = _options(task, base, additions, grid, steel, rule)
            one = one_zone(excess, options) * grid.step**2 / PARTS if additions or not excess.any() else math.inf
            if math.isinf(one):
                continue
            of_all = of_base * float(fine.sum())
            bound = of_all + float((excess * fine).sum())
            likely = (bound + of_all + one) / 2
            candidates.append(_Candidate(likely, bound, base, excess, tuple(one.bars for one in additions), options))
    return sorted(candidates, key=lambda one: (one.likely, one.base.diameter, len(one.additions)))


def _options(
    task: LayerTask,
    base: Bars,
    additions: list[_Addition],
    grid: PlanGrid,
    steel: Reinforcement,
    rule: DetailingRule,
) -> Options:
    """Return the bars that zones may have beside a base, with their lengths in cells."""
    anchorage = [rule.anchorage(steel, task.bar(addition.bars.diameter, addition.apart)) for addition in additions]
    least = max(1, math.ceil(steel.proposal.least_size / grid.step - ROUNDING))
    return Options(
        area=np.array([bar_area(addition.bars) for addition in additions]),
        anchorage=np.array(anchorage) / grid.step * PARTS,
        nestable=np.array([addition.nestable for addition in additions], dtype=bool),
        inner=np.array([addition.bars.spacing > (1 - ROUNDING) * base.spacing for addition in additions], dtype=bool),
        least=(least * PARTS, least),
        every=PARTS,
        # both legs and the back of a U bar, at their least length
        edge=(2 * rule.edge_leg + 1) * task.thickness[1] / grid.step * PARTS,
    )


def _bases(task: LayerTask, steel: Reinforcement, rule: DetailingRule) -> Iterator[Bars]:
    """Yield what bars the base may have."""
    for diameter in task.diameters:
        for spacing in task.spacings:
            clear = spacing - diameter >= rule.least_clear(steel, diameter) - ROUNDING
            if clear and spacing <= task.farthest(diameter) + ROUNDING:
                yield Bars(diameter=diameter, spacing=spacing)


def _additions(task: LayerTask, base: Bars, rule: DetailingRule, steel: Reinforcement) -> list[_Addition]:
    """Return what bars a zone may have beside a base."""
    additions = []
    for multiple, in_gap in MULTIPLES.items():
        for diameter in task.diameters if steel.proposal.most_zones else ():
            thickest = max(diameter, base.diameter)
            # bars of a gap divide it evenly; where another zone lies within, there is one more
            apart = [base.spacing / (in_gap + further) for further in (1, 2)]
            room, more_room = (
                axes_apart - thickest >= rule.least_clear(steel, thickest) - ROUNDING for axes_apart in apart
            )
            bars = Bars(diameter=diameter, spacing=round(multiple * base.spacing, 6))
            # thinner bars than those of the base have more cover
            near = min(base.spacing, bars.spacing) <= task.farthest(min(diameter, base.diameter)) + ROUNDING
            if room and near:
                additions.append(_Addition(bars, apart[more_room], more_room))
    return additions


def _with_zones(
    candidate: _Candidate, area: Array, grid: PlanGrid, steel: Reinforcement, price: float
) -> LayerProposal | None:
    """Return a base with the zones that it needs, None if none are enough; cells along and across the bars."""
    base, excess = candidate.base, candidate.excess
    if not excess.any():
        return LayerProposal(base, (), bar_area(base) * float(area.sum()))
    zones = cover(excess, candidate.options, steel.proposal.most_zones, price / grid.step**2 * PARTS)
    if zones is None:
        return None
    total = bar_area(base) * float(area.sum())
    held = 0.0
    whole = []
    for zone in sorted(zones, key=lambda zone: (zone.cells[0], zone.cells[2])):
        i0, i1, j0, j1 = zone.cells
        cells = (i0 // PARTS, i1 // PARTS, j0, j1)
        total += float(candidate.options.area[zone.option] * area[cells[0] : cells[1], j0:j1].sum())
        bars = float(candidate.options.area[zone.option]) * (i1 - i0) * (j1 - j0)
        held += (zone.steel - bars) * grid.step**2 / PARTS
        whole.append((candidate.additions[zone.option], cells))
    return LayerProposal(base, tuple(whole), total, held)
