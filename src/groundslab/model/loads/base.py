"""What all loads have."""

from __future__ import annotations

from typing import Annotated

from groundslab.schema.base import Section
from groundslab.schema.fields import Text

#: How large a load is: symbol, value in SI units without factors, dimension.
Magnitude = tuple[str, float, str]

Source = Annotated[
    str,
    Text(
        "support in the table of reactions from which it was imported; the next import replaces it, and leaves loads "
        "without a source alone"
    ),
]


class _Load(Section):
    """What all loads have."""

    kind: str
    name: Annotated[str, Text("name of the load, for reference")] = ""
    case: Annotated[str, Text("its load case, one of [[cases]]; none if there are no cases")] = ""
