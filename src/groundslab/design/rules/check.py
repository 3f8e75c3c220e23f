"""A check: what is demanded where, what resists it, by which clause, and how it ended.

A check that can be made of what is known is made. One that cannot needs attention, says why and what to do, and is
counted by itself in the headline. What no check ever looks at, such as anchorage, is "not checked" instead.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeVar

from groundslab.design.rules.calculation import Step
from groundslab.messages import Message, Name, quoted, words_in
from groundslab.model.design.checks import CheckOff
from groundslab.unit_systems import System, unit_in

T = TypeVar("T")
Status = Literal["fails", "attention", "switched off", "no failure found", "not checked"]
#: Statuses in the order in which they are listed.
ORDER: tuple[Status, ...] = ("fails", "attention", "switched off", "no failure found", "not checked")
#: What lies beyond a limit by a smaller share of it is rounding.
ROUNDING = 1e-6


#: So many of those that a check is about are named.
MOST_NAMED = 5


@dataclass(frozen=True, slots=True)
class Unjudged:
    """A way in which checks end without a verdict.

    Attributes
    ----------
    name : str
        What it is called.
    do : str
        What the engineer is to do.
    """

    name: str
    do: str


#: Punching: another support acts inside the perimeter, and the check does not hold with the worse of what it may do.
SUPPORT_INSIDE = Unjudged(
    "support-inside", "check a perimeter around both by hand, or design what is between by struts and ties"
)
#: Punching: openings and edges leave nothing of the perimeter.
NO_PERIMETER = Unjudged("no-perimeter", "move the openings or the load, or design the slab there by hand")
#: Punching of floors: a force without a footprint has no perimeter.
NO_FOOTPRINT = Unjudged("no-footprint", "give it width_x and width_y, or a diameter")
#: One-way shear: punching is checked everywhere, or nothing can be, and no cut goes from edge to edge.
NO_PLACE = Unjudged("no-place", "check cuts through the slab by hand")
#: Equilibrium: glued ground pulls so that its force has no place under the plate, but supports might do without.
GLUED = Unjudged("glued-to-the-ground", "set contact.tensionless = true")
#: A combination has no certified result.
UNSOLVED = Unjudged("no-certified-result", "see why it was not solved, and solve it again")
#: No combination of the limit state that is asked for has a certified result.
NO_COMBINATION = Unjudged("no-combination", "add such a combination")
#: Limits between columns: there are no two columns whose settlements could differ.
ONE_COLUMN = Unjudged("fewer-than-two-columns", "remove the limit, or describe the columns")
#: The program has no rule of the code for it.
NO_RULE = Unjudged("no-rule", "check it by hand, or choose another code")
#: Beams: a beam is described by its stiffness alone, so that its strength is not known.
GIVEN_SECTION = Unjudged("section-by-its-properties", "check its strength by hand, or describe it by width and height")
#: Crack width by EN 1992-1-1:2023, resistance of piles, sliding: neither the case nor the program knows what resists.
NO_LIMIT = Unjudged("no-limit", "give it in the case")
#: Edges of the plate that are supported hold it down.
HELD_EDGE = Unjudged("supported-edge", "describe the edge as a line support with a limit")
#: Restraint: no bars are laid.
NO_BARS = Unjudged("no-bars", "lay the bars")
#: Restraint: the bars yield, so that no crack width is valid.
BARS_YIELD = Unjudged("bars-yield", "lay more bars")
#: Cover: the annex leaves it to another standard.
OTHER_STANDARD = Unjudged("another-standard", "take it from there")
#: Dowels: neither [floor] by TR34 nor [reinforcement] gives the concrete.
NO_CONCRETE = Unjudged("no-concrete", "give one of them")
#: All of them, in the order in which the documentation lists them.
UNJUDGED = (
    SUPPORT_INSIDE, NO_PERIMETER, NO_FOOTPRINT, NO_PLACE, GLUED, UNSOLVED, NO_COMBINATION, ONE_COLUMN,
    NO_RULE, GIVEN_SECTION, NO_LIMIT, HELD_EDGE, NO_BARS, BARS_YIELD, OTHER_STANDARD, NO_CONCRETE,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class SwitchedOff:
    """Why a check is switched off, and how it would have ended."""

    reason: str
    status: Status


@dataclass(frozen=True, slots=True)
class DesignCheck:
    """One check at its governing place.

    Attributes
    ----------
    name : str
        What is checked.
    status : str
        How it ended.
    words : str
        The worst of it in words.
    of : str
        What it is about, such as a column or a layer of bars; empty if it is the slab.
    demand, resistance : float or None
        The two that are compared, in `unit`; None where the check is none of numbers.
    unit : str
        The unit of both, empty for ratios.
    least : bool
        Whether the demand must not be less than the resistance, as with an area in contact.
    clause : str
        Where it is ruled.
    combination : str
        The combination that governs.
    place : tuple of float or None
        Where it governs [m].
    foundation : bool
        Whether it is about what holds the slab, ground and supports, rather than about the slab.
    error : float or None
        The estimated discretization error of the demand, in `unit`, with that of a resistance which depends on the
        results. None where none is known, and where the demand does not depend on the mesh.
    steps : tuple of Step
        The calculation at the governing place, to be followed by hand; empty where there is none.
    unjudged : Unjudged or None
        Why there is no verdict; None where there is one.
    off : SwitchedOff or None
        Why it is switched off; None where it is not.
    """

    name: str
    status: Status
    words: str
    of: str = ""
    demand: float | None = None
    resistance: float | None = None
    unit: str = ""
    least: bool = False
    clause: str = ""
    combination: str = ""
    place: tuple[float, float] | None = None
    foundation: bool = False
    error: float | None = None
    steps: tuple[Step, ...] = ()
    unjudged: Unjudged | None = None
    off: SwitchedOff | None = None

    @property
    def utilization(self) -> float | None:
        """Return demand over resistance, or the other way round where it must not be less; None without numbers."""
        return None if self.demand is None else self._used(self.demand)

    @property
    def between(self) -> tuple[float, float] | None:
        """Return the least and the greatest utilization within the error of the demand; None without an error."""
        if self.demand is None or self.resistance is None or self.error is None:
            return None
        used = [self._used(max(self.demand + sign * self.error, 0.0)) for sign in (-1, 1)]
        low, high = sorted(value for value in used if value is not None)
        return low, high

    @property
    def utilization_error(self) -> float | None:
        """Return by how much the utilization may be larger, None without an error."""
        if self.between is None or self.utilization is None:
            return None
        return self.between[1] - self.utilization

    @property
    def hangs(self) -> bool:
        """Return whether the verdict hangs on the discretization error: a limit lies within it."""
        return self.off is None and self.between is not None and self.between[0] <= 1 < self.between[1] - ROUNDING

    @property
    def verdict(self) -> str:
        """Return how it ended, and whether that hangs on the discretization error."""
        return Message("{status}, but within the error", status=self.status) if self.hangs else self.status

    def _used(self, demand: float) -> float | None:
        """Return the utilization by a demand."""
        if self.resistance is None:
            return None
        over, under = (self.resistance, demand) if self.least else (demand, self.resistance)
        return over / under if under else float("inf") if over else 0.0


def severity(status: Status) -> int:
    """Return a number that is the larger the worse a check ended: what ends worst is shown, whatever its share."""
    return -ORDER.index(status)


def not_judged(name: str, why: Unjudged, words: str, **about: Any) -> DesignCheck:
    """Return a check that ends without a verdict, with what to do in its words."""
    return DesignCheck(
        name, "attention", Message("not judged: {text}; {do}", text=words, do=why.do), unjudged=why, **about
    )


def switched_off(check: DesignCheck, off: Iterable[CheckOff], of: str = "") -> DesignCheck:
    """Return a check as it is where one of those that are switched off covers it, of something or of all."""
    reason = next((entry.reason for entry in off if entry.covers(check.name, of)), None)
    if reason is None or check.off is not None or check.status == "not checked":
        return check
    template = "switched off ({reason}); otherwise {status}: {text}"
    words = Message(template, reason=Name(reason), status=check.status, text=check.words)
    outcome = SwitchedOff(reason, check.status)
    return replace(check, status="switched off", words=words, of=check.of or of, unjudged=None, off=outcome)


def judge_apart(
    items: Sequence[T],
    name_of: Callable[[T], str],
    off: Sequence[CheckOff],
    judge: Callable[[list[T]], Iterable[DesignCheck]],
) -> Iterator[DesignCheck]:
    """Yield the checks of the worst of many; where one is switched off of some alone, those of the others and of each.

    Only so can a check be switched off of one alone: what other checks are of is the worst, and nobody would look at
    the second.
    """
    names = dict.fromkeys(name_of(item) for item in items)
    alone = [entry for entry in off if entry.of in names]
    for check in judge(list(items)):
        apart = [entry.of for entry in alone if entry.covers(check.name, entry.of)]
        if not apart:
            yield check
            continue
        rest = [item for item in items if name_of(item) not in apart]
        yield from (judged for judged in (judge(rest) if rest else ()) if judged.name == check.name)
        for name in dict.fromkeys(apart):
            of_name = judge([item for item in items if name_of(item) == name])
            yield from (switched_off(judged, off, name) for judged in of_name if judged.name == check.name)


def in_units(check: DesignCheck, system: System) -> DesignCheck:
    """Return a check with its numbers and words in the units of a system; names, its place [m] and its steps stay."""
    if system == "SI":
        return check
    unit, factor = unit_in(check.unit, system)
    demand, resistance, error = (
        None if value is None else value * factor for value in (check.demand, check.resistance, check.error)
    )
    words = words_in(check.words, system)
    return replace(check, words=words, demand=demand, resistance=resistance, unit=unit, error=error)


def some(names: Sequence[str], most: int = 5) -> str:
    """Return the first of some names, quoted."""
    return quoted(names, most)
