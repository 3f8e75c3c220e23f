"""Types of fields that hold a fixed number of quantities, each with a name."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab.schema import ranges
from groundslab.schema.fields import ListOf, Quantity


def list_quantities(
    dimension: str,
    symbol: str,
    meaning: str,
    members: Sequence[str],
    limits: ranges.Range = ranges.ANY,
    example: str = "",
) -> ListOf:
    """Return the type of a list of quantities of one dimension, as many as the names of what they are."""
    return ListOf(
        Quantity(dimension, symbol, "", limits, (), example), symbol, meaning, len(members), members=(*members,)
    )
