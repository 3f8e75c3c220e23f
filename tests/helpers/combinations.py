"""Cases with fewer combinations, where what is asserted needs no more of them."""

from __future__ import annotations

from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model


def few(model: Model) -> Model:
    """Return a model with the first combination of each limit state; the model itself where loads move."""
    first = {each.limit_state: each for each in reversed(list_combinations(model))}
    return model.replace(combinations=tuple(first.values()), combine=None) if model.cases and not model.moves else model
