"""What a code asks of links where a slab is punched: perimeters around a column, pile, zone or end of a wall."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from groundslab.arrays import Array
from groundslab.design.rules.calculation import Step, Support

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from groundslab.model.design.punching_links import PunchingLinks

#: Distances of perimeters are multiples of this [m].
STEP = 0.005


@dataclass(frozen=True, slots=True)
class LinkRow:
    """What a code asks of one perimeter of links."""

    distance: float  # from the face [m]
    area: float  # of all its legs [m2]
    spacing: float  # of its legs along it, at most [m]
    steps: tuple[Step, ...] = ()  # to that


class LinkLimit(NamedTuple):
    """What a code asks of links that are given."""

    what: str
    value: float
    limit: float
    unit: str
    clause: str
    least: bool = False  # whether the value must not be less
    steps: tuple[Step, ...] = ()  # to the limit in its unit, where a calculation says more

    @property
    def used(self) -> float:
        """Return the value over its limit, or the other way round."""
        over, under = (self.limit, self.value) if self.least else (self.value, self.limit)
        return over / under if under > 0 else math.inf if over > 0 else 0.0

    def follow(self) -> Iterator[Step]:
        """Yield the steps to the value, its limit and the share used."""
        yield Step(self.what, "x", self.value, self.unit)
        yield from self.steps
        limit = self.steps[-1].symbol if self.steps else "x_lim"
        if not self.steps:
            yield Step("the least that is allowed" if self.least else "the most that is allowed", limit, self.limit,
                       self.unit, clause=self.clause)  # fmt: skip
        yield Step("share used", "eta", self.used, "", f"{limit} / x" if self.least else f"x / {limit}")


def by_depth(d: float, share: float, clause: str, *, least: bool = False) -> tuple[Step, ...]:
    """Return the steps to a limit of a share of the effective depth d [m]."""
    words = "the least that is allowed" if least else "the most that is allowed"
    limit = Step(words, "x_lim", share * d * 1e3, "mm", f"{share:g} * d", clause)
    return Step("effective depth", "d", d * 1e3, "mm"), limit


@dataclass(frozen=True, slots=True)
class Arrangement:
    """How links may be arranged around what punches.

    Attributes
    ----------
    thickness : float
        Of the slab [m].
    options : callable
        Of a diameter [m]: the perimeters, from the inner to the outer one, for each radial spacing; none where the
        code does not allow the diameter.
    lines : callable
        Of a distance from the face [m]: the pieces (l, 2, 2) [m] of the perimeter there that count, not those that
        openings take off. It raises InputError where there is no such perimeter.
    plan : geometry
        Where the slab is; legs keep off its edges and openings.
    rows : callable
        Of links that are given: what the code asks of each of their perimeters.
    limits : callable
        Of links that are given: what else the code asks of them.
    """

    thickness: float
    options: Callable[[float], Iterator[tuple[LinkRow, ...]]]
    lines: Callable[[float], Array]
    plan: BaseGeometry
    rows: Callable[[PunchingLinks], tuple[LinkRow, ...]]
    limits: Callable[[PunchingLinks], Iterable[LinkLimit]]


@dataclass(frozen=True, slots=True)
class LinkDemand:
    """A column, pile, zone or end of a wall that needs links, and how they may be arranged, or why they may not."""

    support: Support
    name: str
    place: tuple[float, float]  # [m]
    combination: str  # that needs most
    clauses: str
    arrangement: Arrangement | str
    unknown: bool = False  # whether the reason is that the code's rules for it are not known here


def rounded_down(distance: float) -> float:
    """Return the largest multiple of STEP that is no more than a distance [m]."""
    return round(math.floor(distance / STEP + 1e-9) * STEP, 6)


def rounded_up(distance: float) -> float:
    """Return the least multiple of STEP that is no less than a distance [m]."""
    return round(math.ceil(distance / STEP - 1e-9) * STEP, 6)
