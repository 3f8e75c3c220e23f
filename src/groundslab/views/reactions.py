"""What plans write beside supports and walls: the force of each in a combination, and the most along a line."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.demands.loads.wall_loads import loads_on_wall
from groundslab.messages import Message, joined
from groundslab.unit_systems import System, unit_in
from groundslab.units import format_number

if TYPE_CHECKING:
    from groundslab.results.records import SupportResult
    from groundslab.results.results import CombinationResult

#: Digits of a number.
DIGITS = 4
#: Moments below this share of the force times a meter are rounding.
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Reaction:
    """What a support or a wall does to the plate.

    Attributes
    ----------
    name : str
        The name of the support or the wall.
    place : (x, y)
        Where it is written [m].
    force : float
        The sum [N], upwards positive.
    most : float or None
        Of a line the force per length of the largest size [N/m], upwards positive.
    moments : (M_x, M_y)
        With which a support restrains the plate's rotation [N m], as in the table of supports.
    """

    name: str
    place: tuple[float, float]
    force: float
    most: float | None = None
    moments: tuple[float, float] = (0.0, 0.0)

    @property
    def arrow(self) -> str:
        """Return where the force on the plate points; empty of none."""
        return "" if self.force == 0 else ("\N{UPWARDS ARROW}" if self.force > 0 else "\N{DOWNWARDS ARROW}")

    def words(self, units: System, *, signed: bool = True) -> str:
        """Return the force with its unit, the most along a line, and moments; without signs for where an arrow is."""

        def shown(value: float, unit: str, sign: bool) -> str:
            name, factor = unit_in(unit, units)
            size = value / 1e3 * factor
            number = format_number(size if sign else abs(size), DIGITS, trim=True, minus="\N{MINUS SIGN}")
            return f"{number} {name}"

        parts = [shown(self.force, "kN", signed)]
        if self.most is not None:
            # beside an arrow the other sense is negative
            along = self.most if signed or self.force >= 0 else -self.most
            parts.append(Message("max {force}", force=shown(along, "kN/m", True)))
        parts += [
            f"{symbol} = {shown(value, 'kNm', True)}"
            for symbol, value in zip(("M_x", "M_y"), self.moments, strict=True)
            if abs(value) > ROUNDING * max(abs(self.force), 1.0)
        ]
        return joined(parts)


def support_reactions(results: CombinationResult) -> Iterator[Reaction]:
    """Yield what each support does to the plate, but those that none of its nodes is at."""
    for support in results.supports:
        if len(support.nodes):
            moments = float(support.moment_x.sum()), float(support.moment_y.sum())
            yield Reaction(support.name, _place_of(support), support.total, _most_along(support), moments)


def wall_reactions(results: CombinationResult) -> Iterator[Reaction]:
    """Yield what each wall does to the plate: what acts through it, and what the building above adds."""
    for wall in results.model.placed_walls:
        loads = loads_on_wall(results.model, wall)
        force, _ = loads.in_combination(results)
        if force.any():
            edge = wall.edges[len(wall.edges) // 2]
            x, y = edge.at(np.array([0.5]))[0]
            most = float(max(force.ravel(), key=abs))
            yield Reaction(wall.name, (float(x), float(y)), -loads.sum_of(force), -most)


def _place_of(support: SupportResult) -> tuple[float, float]:
    """Return the node of a support that is nearest to the middle of all [m]."""
    off = np.hypot(*(support.nodes - support.nodes.mean(axis=0)).T)
    x, y = support.nodes[int(np.argmin(np.round(off, 9)))]
    return float(x), float(y)


def _most_along(support: SupportResult) -> float | None:
    """Return the force per length of the largest size along a line [N/m], None at a point."""
    on_line = support.length > 0
    if not on_line.any():
        return None
    per_length = support.force[on_line] / support.length[on_line]
    return float(per_length[int(np.argmax(np.abs(per_length)))])
