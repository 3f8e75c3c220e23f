"""What changes when a table of reactions is imported again."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from groundslab.exchange.reactions.forces import Resultant
from groundslab.exchange.reactions.matching import Moved
from groundslab.geometry.plan import Place, format_place
from groundslab.model.model import Model
from groundslab.units import together

#: Share of a force or moment by which it must change to be listed.
THRESHOLD = 0.01


@dataclass(frozen=True, slots=True)
class ReactionChange:
    """A difference between the loads of a case and a table of reactions.

    Attributes
    ----------
    kind : str
        "new" or "gone" for loads, "changed" for those that change by more than the threshold, "less" for those that
        change by less, "moved" for columns and walls that the table has elsewhere.
    name : str
        Column or wall.
    case : str
        Load case; empty if moved.
    before, after : Resultant or None
        Force [N] and moments [N m] on it; None if there are none.
    places : tuple
        Where a moved one is in the case and in the table [m]; empty for loads.
    H : tuple
        H_x and H_y of the load case before and after [N]; empty for loads.
    """

    kind: Literal["new", "gone", "changed", "less", "moved"]
    name: str
    case: str = ""
    before: Resultant | None = None
    after: Resultant | None = None
    places: tuple[Place, ...] = ()
    H: tuple[tuple[float, float], ...] = ()

    def __str__(self) -> str:
        """Return the change on one line."""
        if self.places:
            return f"moved: {self.name} from {format_place(self.places[0])} m to {format_place(self.places[1])} m"
        if self.H:
            along_x, along_y = zip(*self.H, strict=True)
            words = (_pair("H_x", *along_x, dimension="force"), _pair("H_y", *along_y, dimension="force"))
            return f"{self.kind}: {self.case}: {', '.join(filter(None, words))}"
        values = [_words(self.before, self.after, "P", "force")]
        values += [_words(self.before, self.after, name, "moment") for name in ("M_x", "M_y")]
        return f"{self.kind}: {self.name} in {self.case}: {', '.join(filter(None, values))}"


def _words(before: Resultant | None, after: Resultant | None, name: str, dimension: str) -> str:
    """Return a value before and after; nothing if both are 0."""
    return _pair(name, *(getattr(value, name) for value in (before, after) if value is not None), dimension=dimension)


def _pair(name: str, *values: float, dimension: str) -> str:
    """Return one value, or two before and after; nothing if all are 0."""
    if not any(values):
        return ""
    texts, unit = together(values, dimension)
    return f"{name} {' -> '.join(dict.fromkeys(texts))} {unit}"


@dataclass(frozen=True, slots=True)
class CaseSum:
    """Sums of the imported loads of one load case.

    Attributes
    ----------
    case : str
        Load case.
    before, after : Resultant
        Force [N] and moments about x = y = 0 [N m], before and after.
    """

    case: str
    before: Resultant
    after: Resultant

    def __str__(self) -> str:
        """Return the sums on one line."""
        values = (_words(self.before, self.after, name, unit) for name, unit in SUMMED)
        return f"{self.case}: {', '.join(filter(None, values)) or 'nothing'}"


SUMMED = (("P", "force"), ("M_x", "moment"), ("M_y", "moment"))
Resultants = Mapping[tuple[str, str], Resultant]


def find_changes(
    before: Resultants, after: Resultants, moved: Iterable[Moved], threshold: float = THRESHOLD
) -> Iterator[ReactionChange]:
    """Yield the differences between two states of imported loads, and what has moved."""
    for move in moved:
        yield ReactionChange("moved", move.name, places=(move.before, move.after))
    for key in dict.fromkeys((*after, *before)):
        old, new = before.get(key), after.get(key)
        if old is None or new is None:
            yield ReactionChange("gone" if new is None else "new", *key, old, new)
        elif old != new:
            large = any(
                abs(getattr(new, name) - getattr(old, name)) > threshold * abs(getattr(old, name)) for name, _ in SUMMED
            )
            yield ReactionChange("changed" if large else "less", *key, old, new)


def find_pushes(before: Model, after: Model, threshold: float = THRESHOLD) -> Iterator[ReactionChange]:
    """Yield the load cases whose horizontal forces change."""
    old = {case.name: (case.H_x, case.H_y) for case in before.cases}
    for case in after.cases:
        H_before, H_after = old.get(case.name, (0.0, 0.0)), (case.H_x, case.H_y)
        if H_before != H_after:
            large = any(abs(b - a) > threshold * abs(a) for a, b in zip(H_before, H_after, strict=True))
            yield ReactionChange("changed" if large else "less", "", case.name, H=(H_before, H_after))


def sum_cases(
    before: Resultants, after: Resultants, old: Mapping[str, Place], new: Mapping[str, Place]
) -> tuple[CaseSum, ...]:
    """Return the sums by case, of loads on columns and walls with their middles before and after [m]."""
    cases = dict.fromkeys(case for _, case in (*after, *before))
    return tuple(CaseSum(case, _sum(before, case, old), _sum(after, case, new)) for case in cases)


def _sum(forces: Resultants, case: str, places: Mapping[str, Place]) -> Resultant:
    """Return force and moments about x = y = 0 of what acts in a case."""
    acting = [(force, places.get(name, (0.0, 0.0))) for (name, load_case), force in forces.items() if load_case == case]
    return Resultant(
        math.fsum(force.P for force, _ in acting),
        math.fsum(force.M_x + force.P * x for force, (x, _) in acting),
        math.fsum(force.M_y + force.P * y for force, (_, y) in acting),
    )
