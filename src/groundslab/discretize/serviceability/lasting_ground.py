"""The described ground under loads that last: all its stiffnesses multiplied by one factor."""

from __future__ import annotations

from typing import TypeVar

from groundslab.model.model import Model
from groundslab.schema.base import Section, get_field_type
from groundslab.schema.fields import Quantity

#: Dimensions of what resists a settlement.
STIFFNESSES = ("pressure", "pressure per length", "pressure times length")

AnySection = TypeVar("AnySection", bound=Section)


def lasts(model: Model, limit_state: str) -> bool:
    """Return whether the ground is that under lasting loads in a limit state."""
    return model.long_term is not None and limit_state in model.long_term.limit_states


def with_lasting_ground(model: Model) -> Model:
    """Return a model with its ground as it is under loads that last."""
    assert model.long_term is not None
    factor = model.long_term.stiffness
    described = {"soil_zones": model.soil_zones, "boreholes": model.boreholes}
    soft = {name: tuple(_scale(each, factor) for each in many) for name, many in described.items()}
    return model.model_copy(update={"ground": _scale(model.ground, factor), **soft})


def _scale(section: AnySection, factor: float) -> AnySection:
    """Return a section with all stiffnesses in it multiplied by a factor."""
    changes: dict[str, object] = {}
    for name, field in type(section).model_fields.items():
        value, kind = getattr(section, name), get_field_type(field)
        if isinstance(kind, Quantity) and kind.dimension in STIFFNESSES and value is not None:
            changes[name] = value * factor
        elif isinstance(value, Section):
            changes[name] = _scale(value, factor)
        elif isinstance(value, tuple) and value and isinstance(value[0], Section):
            changes[name] = tuple(_scale(each, factor) for each in value)
    return section.model_copy(update=changes)
