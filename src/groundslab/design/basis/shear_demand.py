"""The demand of one-way shear at a place, with what resists it there without links."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from groundslab.design.basis.calculation import Step
from groundslab.design.basis.check import DesignCheck, Status
from groundslab.design.basis.demand_errors import scaled
from groundslab.results.results import CombinationResult


@dataclass(frozen=True, slots=True)
class ShearDemand:
    """Where a combination's shear force is largest against what needs no links."""

    results: CombinationResult
    place: tuple[float, float]  # [m]
    v: float  # [N/m]
    without_links: float  # [N/m]
    d: float  # [m]
    thickness: float  # [m]
    spread: bool = False  # whether the line force along the edge is spread over a strip
    at_support: bool = False  # whether it is nearer than d to what presses there
    rho: float | None = None  # ratio of bars in tension; None if it or d differs over a cut
    across: bool = False  # whether forces are means over a cut
    error: Callable[[], float | None] = field(default=lambda: None, repr=False, compare=False)  # of v [N/m]

    @property
    def used(self) -> float:
        """Return the force over what needs no links."""
        return self.v / self.without_links

    @property
    def where(self) -> str:
        """Return place and combination in words."""
        edge = ", with the line force along the edge as pressure on a strip," if self.spread else ""
        return f'({self.place[0]:.3f}, {self.place[1]:.3f}) m in "{self.results.combination}"{edge}'

    def check(self, status: Status, words: str, clause: str, steps: Iterable[Step]) -> DesignCheck:
        """Return the check of this place, with its calculation."""
        return DesignCheck(
            "one-way shear", status, words, demand=self.v / 1e3, resistance=self.without_links / 1e3, unit="kN/m",
            clause=clause, combination=self.results.combination, place=self.place, error=scaled(self.error(), 1e-3),
            steps=tuple(steps),
        )  # fmt: skip
