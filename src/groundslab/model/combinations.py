"""Combinations of a model: those it lists, those by EN 1990, or each load case by itself, at all positions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.model.loads.en1990 import make_combinations
from groundslab.model.loads.load_cases import Combination
from groundslab.model.loads.patterns import expand

if TYPE_CHECKING:
    from groundslab.model.model import Model


def list_combinations(model: Model) -> tuple[Combination, ...]:
    """Return all combinations of a model: those given and those made by EN 1990, at all positions of moving cases.

    With cases and neither of them it is each case by itself; without cases one nameless combination of all loads. Both
    are without partial factors: characteristic (EN 1990 6.5.3), never ultimate.
    """
    return expand(_list_unmoved(model), model.moves)


def _list_unmoved(model: Model) -> tuple[Combination, ...]:
    """Return the combinations as if nothing moved."""
    if not model.cases:
        return (Combination(name="all loads", limit_state="characteristic", factors={"": 1.0}),)
    made: tuple[Combination, ...] = ()
    if model.combine is not None:
        made = make_combinations(model.combine, model.cases)
    if not model.combinations and model.combine is None:
        return tuple(
            Combination(name=case.name, limit_state="characteristic", factors={case.name: 1.0}) for case in model.cases
        )
    return (*model.combinations, *made)
