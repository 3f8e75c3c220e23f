"""Models that are the same problem: in other units, or at another place."""

from __future__ import annotations

from typing import Any

from groundslab import units
from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.fields import FieldType, ListOf, Quantity
from groundslab.schema.places import move


def rescale(model: Model, lengths: float, forces: float) -> Model:
    """Return a model whose lengths and forces are multiplied, and all else by its dimension; validated again."""
    return Model.model_validate(_rescale_section(model, lengths, forces))


def _rescale_section(section: Section, lengths: float, forces: float) -> dict[str, Any]:
    """Return the fields that were set, as data."""
    data = {}
    for name in section.model_fields_set | ({"kind"} & set(type(section).model_fields)):
        field, value = type(section).model_fields[name], getattr(section, name)
        key = field.type
        data[name] = _rescale_parts(value, lengths, forces) if key is None else _rescale(value, key, lengths, forces)
    return {name: value for name, value in data.items() if value is not None}


def _rescale_parts(value: Any, lengths: float, forces: float) -> Any:
    """Return the sections that a field holds as data, anything else as it is."""
    if isinstance(value, Section):
        return _rescale_section(value, lengths, forces)
    return [_rescale_parts(item, lengths, forces) for item in value] if isinstance(value, tuple) else value


def _rescale(value: Any, key: FieldType, lengths: float, forces: float) -> Any:
    """Return a value times what its dimension has of lengths and forces."""
    if value is None:
        return None
    if isinstance(key, ListOf):
        return [_rescale(item, key.each, lengths, forces) for item in value]
    if not isinstance(key, Quantity):
        return value
    length, mass, _, _ = units.DIMENSIONS[key.dimension].powers
    # a force is a mass times a length over the square of a time, which stays
    return value * lengths**length * (forces / lengths) ** mass


def move_validated(model: Model, by: tuple[float, float]) -> Model:
    """Return a model moved along x and y [m], validated again."""
    return rescale(move(model, by), 1.0, 1.0)
