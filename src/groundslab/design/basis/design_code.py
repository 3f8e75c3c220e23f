"""What a design code consists of: the rules by which a case's slab is designed, each a function or a few of them.

A code is a folder with these rules and one line in `codes.CODES`. Bending is needed; of what else a code has no rule,
the checks say so.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from groundslab.design.bending import BendingRule
from groundslab.model.design.reinforcement import Reinforcement


@dataclass(frozen=True, slots=True)
class Clauses:
    """Where a code rules what the checks of every code cite."""

    bars: str  # of bars that bending needs, the least ones among them
    least_bars: str
    held_bars: str  # of links that hold bars in compression


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
    """

    name: str
    clauses: Clauses
    bending: Callable[[Reinforcement, str], BendingRule]
