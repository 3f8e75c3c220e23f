"""What walls carry, and how the plate settles along them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.loads.building_loads import unit_loads
from groundslab.design.demands.loads.column_loads import factors_of
from groundslab.model.model import Model
from groundslab.model.structure.walls import Wall
from groundslab.results.results import CombinationResult

#: Places along a wall at which the settlement is looked up.
PLACES = 101
#: Places closer to a line than this share of its length lie on it.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class WallLoads:
    """The loads that name a wall, and what the building above adds, by load case: at both ends, linear between."""

    force: dict[str, Array]  # (2,) [N/m], downwards positive
    couple: dict[str, Array]  # (2,) [N m/m], positive if it presses what lies to the left down

    def in_combination(self, results: CombinationResult) -> tuple[Array, Array]:
        """Return force (2,) [N/m] and couple (2,) [N m/m] at both ends in a combination."""
        factors = factors_of(results)

        def total(by_case: dict[str, Array]) -> Array:
            return sum((factors.get(case, 0.0) * ends for case, ends in by_case.items()), np.zeros(2))

        return total(self.force), total(self.couple)


def loads_on_wall(model: Model, wall: Wall) -> WallLoads:
    """Return the loads that name a wall, and those of the building above."""
    force: dict[str, Array] = defaultdict(lambda: np.zeros(2))
    couple: dict[str, Array] = defaultdict(lambda: np.zeros(2))
    for load in model.loads:
        if getattr(load, "wall", "") == wall.name:
            for line in model.shapes(load):
                force[load.case] += getattr(line, "q", (0.0, 0.0))
                couple[load.case] += getattr(line, "m", (0.0, 0.0))
    L, straight = wall.length, len(wall.edges) == 1 and wall.edges[0].straight
    for (case, _), (P, *M) in zip(unit_loads(model).get(wall.name, ()), np.eye(3), strict=False):
        force[case] += P / L
        if straight:
            t = np.subtract(wall.edges[0].end, wall.edges[0].start) / L
            # along the wall a couple is a force per length that grows from end to end, across it a couple per length
            force[case] += 6 * (t @ M) / L**2 * np.array([-1.0, 1.0])
            couple[case] += np.array([-t[1], t[0]]) @ M / L
    return WallLoads(dict(force), dict(couple))


@dataclass(frozen=True, slots=True)
class WallSettlement:
    """The settlement of the plate along a wall's axis."""

    way: Array  # (p,): from the start [m]
    w: Array  # (p,) [m]

    @property
    def deflection(self) -> float:
        """The largest distance [m] of the settlement from the straight line between both ends, sagging positive."""
        chord = self.w[0] + (self.w[-1] - self.w[0]) * self.way / self.way[-1]
        off = self.w - chord
        return float(off[np.argmax(np.abs(off))])


def settlement_along(model: Model, wall: Wall) -> Callable[[CombinationResult], WallSettlement]:
    """Return the function that gives the settlement of the plate along a wall, over openings that of the wall."""
    edges = wall.edges
    starts = np.concatenate([[0.0], np.cumsum([edge.length for edge in edges])])
    way = np.linspace(0.0, starts[-1], PLACES)
    number = np.clip(np.searchsorted(starts, way, side="right") - 1, 0, len(edges) - 1)
    parts = np.clip((way - starts[number]) / np.array([edge.length for edge in edges])[number], 0.0, 1.0)
    places = np.concatenate([edge.at(parts[number == n]) for n, edge in enumerate(edges)])
    over = np.zeros(len(places), dtype=bool)
    near = ROUNDING * wall.length
    for start, end in model.spans_of_walls.get(wall.name, ()):
        over |= (start - near <= way) & (way <= end + near)

    def along(results: CombinationResult) -> WallSettlement:
        w = np.empty(len(way))
        w[~over] = results.plate.value_at("settlement", *places[~over].T)
        if over.any():
            w[over] = np.interp(way[over], *_of_members(model, wall, results))
        return WallSettlement(way, w)

    return along


def _of_members(model: Model, wall: Wall, results: CombinationResult) -> tuple[Array, Array]:
    """Return ways along a wall with a height [m], and its settlement there [m]."""
    stiff = [each.name for each in model.walls if each.height is not None]
    parts = [beam for beam, number in zip(results.beams, model.wall_of_members, strict=True)
             if number >= 0 and stiff[number] == wall.name]  # fmt: skip
    starts = np.cumsum([0.0, *(beam.way[-1] for beam in parts)])
    ways = [start + beam.way for start, beam in zip(starts, parts, strict=False)]
    return np.concatenate(ways), np.concatenate([beam.settlement for beam in parts])
