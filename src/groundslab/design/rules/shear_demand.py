"""The demand of one-way shear at a place, with what resists it there without links."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from math import inf, isclose, isfinite
from typing import NamedTuple

from groundslab.design.rules.calculation import MEGA, SAME, Step, depth_steps
from groundslab.design.rules.check import DesignCheck, Status
from groundslab.design.rules.demand_errors import scaled
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.design.shear_links import ShearLinks
from groundslab.results.results import CombinationResult


class AlongForce(NamedTuple):
    """What makes the shear force at a place, the face in tension along it, and the ratio of bars there."""

    shear: tuple[float, float]  # q_x, q_y [N/m]
    moments: tuple[float, float, float]  # m_x, m_y, m_xy [N m/m]
    face: str  # in tension
    ratios: tuple[float, float]  # of its bars along x and y


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
    along: AlongForce | None = None  # None of means over a cut
    links: ShearLinks | None = None  # that are given there
    error: Callable[[], float | None] = field(default=lambda: None, repr=False, compare=False)  # of v [N/m]

    @property
    def used(self) -> float:
        """Return the force over what needs no links."""
        return self.v / self.without_links

    @property
    def where(self) -> str:
        """Return place and combination in words."""
        edge = ", with the line force along the edge as pressure on a strip," if self.spread else ""
        name = Name(self.results.combination)
        return Message('{place:.3f m} in "{combination}"', place=self.place, combination=name) + edge

    def check(self, status: Status, words: str, clause: str, steps: Iterable[Step]) -> DesignCheck:
        """Return the check of this place, with its calculation."""
        return DesignCheck(
            "one-way shear", status, words, demand=self.v / 1e3, resistance=self.without_links / 1e3, unit="kN/m",
            clause=clause, combination=self.results.combination, place=self.place, error=scaled(self.error(), 1e-3),
            steps=tuple(steps),
        )  # fmt: skip

    def force_steps(self, symbol: str, clause: str = "") -> Iterator[Step]:
        """Yield the shear force and, unless it is a mean over a cut, what it is made of."""
        if self.along is None:
            yield Step("shear force, mean over the cut", symbol, self.v / MEGA, "MN/m", clause=clause)
            return
        q_x, q_y = self.along.shear
        yield Step("shear force on sections x = const", "q_x", q_x / MEGA, "MN/m")
        yield Step("shear force on sections y = const", "q_y", q_y / MEGA, "MN/m")
        yield Step("largest shear force of any direction", symbol, self.v / MEGA, "MN/m", "sqrt(q_x^2 + q_y^2)", clause)

    def depth_steps(self, steel: Reinforcement, clause: str = "") -> Iterator[Step]:
        """Yield the effective depth, at most places that to the axes of bars at the face where they lie deeper."""
        axes = max(steel.bottom_axes, steel.top_axes, key=sum)
        if isclose(self.thickness - sum(axes) / 2, self.d, rel_tol=SAME):
            yield from depth_steps(self.d, axes, clause=clause)
        else:
            words = "effective depth, mean over the cut" if self.across else "effective depth"
            yield Step(words, "d", self.d, "m", clause=clause)

    def mean_steps(self, resistance: str, force: str, clause: str) -> Iterator[Step]:
        """Yield what needs no links over a cut where depth or bars differ, and the share used."""
        without = self.without_links / MEGA
        yield Step("force that needs no links, mean over the cut", resistance, without, "MN/m", clause=clause)
        yield Step("share used", "eta", self.used, "", f"{force} / {resistance}", clause)

    def ratio_steps(self, symbol: str, force: str, clause: str, most: float = inf) -> Iterator[Step]:
        """Yield the ratio of bars along the force, of the symbol given, from that along x and y; of cuts the ratio.

        No more than `most` counts.
        """
        rho = min(self.rho or 0.0, most)
        if self.along is None or not self.v:
            yield Step("ratio of bars in tension", symbol, rho, clause=clause)
            return
        (q_x, q_y), (m_x, m_y, m_xy), face, (rho_x, rho_y) = self.along
        share = (q_x / self.v) ** 2
        yield Step("cos^2 of the force's angle from x", "s", share, "", f"q_x^2 / {force}^2")
        for name, moment in (("m_x", m_x), ("m_y", m_y), ("m_xy", m_xy)):
            words = (
                "twisting moment" if name == "m_xy" else Message("moment of strips along {name}", name=Name(name[-1]))
            )
            yield Step(words, name, moment / MEGA, "MNm/m")
        m_n = m_x * share + m_y * (1 - share) + 2 * m_xy * q_x * q_y / self.v**2
        formula = f"m_x * s + m_y * (1 - s) + 2 * m_xy * q_x * q_y / {force}^2"
        yield Step(
            "moment along the force, positive where the bottom is in tension", "m_n", m_n / MEGA, "MNm/m", formula
        )
        for axis, ratio in (("x", rho_x), ("y", rho_y)):
            words = Message("bars along {axis} at the {face}", axis=Name(axis), face=face)
            yield Step(words, f"A_{axis}", ratio * self.d * 1e4, "cm2/m")
            words = Message("ratio of bars along {axis}", axis=Name(axis))
            yield Step(words, f"rho_{axis}", ratio, "", f"A_{axis} / (10000 * d)")
        formula = "rho_x * s^2 + rho_y * (1 - s)^2"
        if isfinite(most):
            formula = f"min({most:g}, {formula})"
        yield Step("ratio of bars in tension along the force", symbol, rho, "", formula, clause)
