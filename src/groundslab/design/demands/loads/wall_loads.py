"""What walls carry, and how the plate settles along them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.design.demands.loads.building_loads import unit_loads
from groundslab.design.demands.loads.column_loads import factors_of
from groundslab.model.loads.acting import LineForce
from groundslab.model.model import Model
from groundslab.model.structure.walls import Wall
from groundslab.results.results import CombinationResult

#: Places along a wall at which the settlement is looked up.
PLACES = 101
#: Places closer to a line than this share of its length lie on it.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class WallLoads:
    """What acts through a wall, and what the building above adds, by load case: at both ends of each of its parts.

    Between the ends of a part it is linear; no part lies where nothing acts, as in a door.
    """

    parts: Array  # (k, 2): from way to way along the wall [m]
    force: dict[str, Array]  # (k, 2) [N/m], downwards positive
    couple: dict[str, Array]  # (k, 2) [N m/m], positive if it presses what lies to the left down

    def in_combination(self, results: CombinationResult) -> tuple[Array, Array]:
        """Return force (k, 2) [N/m] and couple (k, 2) [N m/m] at the ends of the parts in a combination."""
        factors = factors_of(results)

        def total(by_case: dict[str, Array]) -> Array:
            factored = (factors.get(case, 0.0) * ends for case, ends in by_case.items())
            return sum(factored, np.zeros(self.parts.shape))

        return total(self.force), total(self.couple)

    def sum_of(self, ends: Array) -> float:
        """Return the sum over the wall of what acts per length at the ends of the parts (k, 2)."""
        return float(np.diff(self.parts)[:, 0] @ ends.mean(axis=1))

    def at(self, way: float, ends: Array) -> float:
        """Return what acts per length at a way along the wall [m], by the ends of the parts (k, 2).

        Where it jumps it is the mean of both sides, at an end of what is loaded that of the loaded side.
        """
        length = self.parts.max()
        near = ROUNDING * length
        here = (self.parts[:, 0] - near <= way) & (way <= self.parts[:, 1] + near)
        values = [
            np.interp(way, part, end_values) for part, end_values in zip(self.parts[here], ends[here], strict=True)
        ]
        return float(np.mean(values)) if values else 0.0


@made_once
def forces_on_walls(model: Model) -> dict[str, list[tuple[str, LineForce]]]:
    """Return what acts through each wall, by its name, with the load cases."""
    forces: dict[str, list[tuple[str, LineForce]]] = defaultdict(list)
    for load, shape in model.acting:
        if isinstance(shape, LineForce) and shape.wall:
            forces[shape.wall].append((load.case, shape))
    return dict(forces)


def loads_on_wall(model: Model, wall: Wall) -> WallLoads:
    """Return what acts through a wall, and the loads of the building above."""
    lines, L = forces_on_walls(model).get(wall.name, []), wall.length
    units = unit_loads(model).get(wall.name, ())
    parts = _parts(lines, L, everywhere=bool(units) or not lines)
    force: dict[str, Array] = defaultdict(lambda: np.zeros(parts.shape))
    couple: dict[str, Array] = defaultdict(lambda: np.zeros(parts.shape))
    for case, line in lines:
        within = line.start, line.start + line.length
        loaded = (within[0] < parts.mean(axis=1)) & (parts.mean(axis=1) < within[1])
        force[case][loaded] += np.interp(parts[loaded], within, line.q)
        couple[case][loaded] += np.interp(parts[loaded], within, line.m)
    straight = len(wall.edges) == 1 and wall.edges[0].straight
    for (case, _), (P, *M) in zip(units, np.eye(3), strict=False):
        force[case] += P / L
        if straight:
            t = np.subtract(wall.edges[0].end, wall.edges[0].start) / L
            # along the wall a couple is a force per length that grows from end to end, across it a couple per length
            force[case] += 6 * (t @ M) / L**2 * (2 * parts / L - 1)
            couple[case] += np.array([-t[1], t[0]]) @ M / L
    return WallLoads(parts, dict(force), dict(couple))


def _parts(lines: Sequence[tuple[str, LineForce]], length: float, *, everywhere: bool) -> Array:
    """Return the parts (k, 2) of a wall between the ends of all lines, from way to way [m], those that are loaded."""
    within = [(line.start, line.start + line.length) for _, line in lines]
    within += [(0.0, length)] if everywhere else []
    near = ROUNDING * length
    cuts = np.unique(within)
    cuts = cuts[np.concatenate([[True], np.diff(cuts) > near])]
    middles = (cuts[1:] + cuts[:-1]) / 2
    loaded = [any(start < middle < end for start, end in within) for middle in middles]
    return np.column_stack([cuts[:-1], cuts[1:]])[loaded]


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
    stiff = [stiff_wall.name for stiff_wall in model.walls if stiff_wall.height is not None]
    parts = [beam for beam, number in zip(results.beams, model.wall_of_members, strict=True)
             if number >= 0 and stiff[number] == wall.name]  # fmt: skip
    starts = np.cumsum([0.0, *(beam.way[-1] for beam in parts)])
    ways = [start + beam.way for start, beam in zip(starts, parts, strict=False)]
    return np.concatenate(ways), np.concatenate([beam.settlement for beam in parts])
