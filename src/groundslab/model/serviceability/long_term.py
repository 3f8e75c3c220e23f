"""Ground under loads that last: its stiffness, which consolidation and creep make smaller."""

from __future__ import annotations

from typing import Annotated

from groundslab.model.loads.load_cases import LimitState
from groundslab.schema.base import Section
from groundslab.schema.fields import Choice, ListOf, Number
from groundslab.schema.ranges import Range

RATIO = Range(at_least=0.01, at_most=1)


class LongTerm(Section):
    """Ground that is softer under loads that last: all of it, zones and boreholes too."""

    stiffness: Annotated[
        float,
        Number("", "stiffness of the ground under long-term loads, relative to the one given, such as 0.5", RATIO),
    ]
    limit_states: Annotated[
        tuple[LimitState, ...], ListOf(Choice(LimitState, "", ""), "", "limit states with long-term loads", unique=True)
    ] = ("quasi-permanent",)
