"""What a design code consists of: the rules by which a case's slab is designed, each a function or a few of them.

A code is a folder with these rules and one line in `codes.CODES`. Bending is needed; of what else a code has no rule,
the checks say so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.punching_columns import Heads, PunchingColumns
from groundslab.design.bending import BendingRule
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


@dataclass(frozen=True, slots=True)
class Clauses:
    """Where a code rules what the checks of every code cite."""

    bars: str  # of bars that bending needs, the least ones among them
    least_bars: str
    held_bars: str  # of links that hold bars in compression


@dataclass(frozen=True, slots=True)
class PunchingRule:
    """Punching, or two-way shear, at columns and of the plate over piles.

    Attributes
    ----------
    at_columns, over_piles : callable
        What tables have of it.
    checks : callable
        Of all combinations: the checks.
    extremes : tuple
        Those columns of a table whose extremes are wanted.
    with_errors : tuple of str
        Those whose values have discretization errors, besides what acts inside a perimeter.
    """

    at_columns: Callable[[Results, Reinforcement], PunchingColumns]
    over_piles: Callable[[Results, Reinforcement], PunchingColumns]
    checks: Callable[[Results], Iterator[DesignCheck]]
    extremes: Heads
    with_errors: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class DesignCode:
    """The rules of a code.

    Attributes
    ----------
    name : str
        What checks and tables call it, with its edition if that matters.
    clauses : Clauses
        What they cite.
    bending : callable
        Of the case's materials and a limit state: how sections find their bars.
    punching : PunchingRule or None
        Columns and piles that punch the plate.
    """

    name: str
    clauses: Clauses
    bending: Callable[[Reinforcement, str], BendingRule]
    punching: PunchingRule | None = None


def no_rule(code: DesignCode, what: str) -> DesignCheck:
    """Return the check of what a code has no rule for here: it is open."""
    return DesignCheck(what, "attention", f"not checked: {code.name} has no rule for it here")
