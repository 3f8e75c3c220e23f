"""EN 1992-1-1 as a design code."""

from __future__ import annotations

from groundslab.design.basis.design_code import Clauses, DesignCode
from groundslab.design.bending import BendingRule
from groundslab.design.en1992 import bending
from groundslab.design.en1992.case_materials import materials
from groundslab.model.design.reinforcement import Reinforcement


def _bending(steel: Reinforcement, limit_state: str) -> BendingRule:
    """Return how sections of the case find their bars in a limit state."""
    return bending.rule(*materials(steel, limit_state))


EN1992 = DesignCode(
    name="EN 1992-1-1",
    clauses=Clauses(bars="6.1, 9.2.1.1(1)", least_bars="9.2.1.1(1)", held_bars="9.2.1.2(3)"),
    bending=_bending,
)
