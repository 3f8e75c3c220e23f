"""Ground under loads that last: its stiffness, which consolidation and creep make smaller."""

from __future__ import annotations

from typing import Annotated, TypeVar

from groundslab.model.loads.load_cases import LimitState
from groundslab.schema.base import Section
from groundslab.schema.fields import Choice, ListOf, Number, Quantity
from groundslab.schema.ranges import Range

RATIO = Range(at_least=0.01, at_most=1)
#: Dimensions of what resists a settlement.
STIFFNESSES = ("pressure", "pressure per length", "pressure times length")

AnySection = TypeVar("AnySection", bound=Section)


class LongTerm(Section):
    """Ground that is softer under loads that last: all of it, zones and boreholes too."""

    stiffness: Annotated[
        float,
        Number("", "stiffness of the ground under long-term loads, relative to the one given, such as 0.5", RATIO),
    ]
    limit_states: Annotated[
        tuple[LimitState, ...], ListOf(Choice(LimitState, "", ""), "", "limit states with long-term loads", unique=True)
    ] = ("quasi-permanent",)


def scale_stiffnesses(section: AnySection, factor: float) -> AnySection:
    """Return a section with all stiffnesses in it multiplied by a factor."""
    changes: dict[str, object] = {}
    for name, field in type(section).model_fields.items():
        value = getattr(section, name)
        kind = field.type
        if isinstance(kind, Quantity) and kind.dimension in STIFFNESSES and value is not None:
            changes[name] = value * factor
        elif isinstance(value, Section):
            changes[name] = scale_stiffnesses(value, factor)
        elif isinstance(value, tuple) and value and isinstance(value[0], Section):
            changes[name] = tuple(scale_stiffnesses(part, factor) for part in value)
    return section.model_copy(update=changes)
