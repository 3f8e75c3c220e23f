"""How the factor beta of punching is found: by moments, by constants, by sectors, or as given."""

from __future__ import annotations

from typing import Literal

from groundslab.schema.fields import Number
from groundslab.schema.ranges import Range

BetaWord = Literal["code", "constant", "sectors"]
Beta = BetaWord | float


def beta_field(whose: str) -> Number:
    """Return the field of beta, of the whole case or of a column."""
    meaning = (
        f"factor of uneven punching {whose}: by moments (EN 1992-1-1 6.4.3), constant (Figure 6.21N), by the slab's "
        "shear forces in sectors of the perimeter, or a number"
    )
    return Number("beta", meaning, Range(at_least=1, at_most=10), words=("code", "constant", "sectors"))
