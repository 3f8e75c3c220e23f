"""Types of fields that say where something lies in plan, and sections moved to another place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

from groundslab.schema.base import Section
from groundslab.schema.fields import FieldType, ListOf, Quantity
from groundslab.schema.ranges import Range

#: Coordinates reach further than lengths: national grids count from far away, some with the number of a zone in front.
ANYWHERE = Range(at_least=-1e8, at_most=1e8)


@dataclass(frozen=True)
class Coordinate(Quantity):
    """A coordinate in plan along x (axis 0) or y (axis 1)."""

    axis: int = 0


@dataclass(frozen=True)
class Place(ListOf):
    """A place x, y in plan."""


def coordinate(axis: int, meaning: str) -> Coordinate:
    """Return the type of a coordinate along x (0) or y (1)."""
    return Coordinate("length", "xy"[axis], meaning, ANYWHERE, example="2.5 m", axis=axis)


def extent(axis: int, meaning: str) -> ListOf:
    """Return the type of an extent along x (0) or y (1)."""
    return ListOf(coordinate(axis, ""), "xy"[axis], meaning, 2, rising=True, members=("from", "to"))


def place_in_plan(meaning: str, symbol: str = "x, y") -> Place:
    """Return the type of a place."""
    return Place(Quantity("length", symbol, "", ANYWHERE, example="2.5 m"), symbol, meaning, 2, members=("x", "y"))


Moved = TypeVar("Moved", bound=Section)


def move(section: Moved, by: tuple[float, float], digits: int = 15) -> Moved:
    """Return a section whose places in plan are moved along x and y [m], with so many decimals; unchecked."""
    changes = {}
    for name, field in type(section).model_fields.items():
        value, key = getattr(section, name), field.type
        moved = _move_sections(value, by, digits) if key is None else _move_value(value, key, by, digits)
        if moved != value:
            changes[name] = moved
    return section.model_copy(update=changes) if changes else section


def _move_sections(value: Any, by: tuple[float, float], digits: int) -> Any:
    """Return the sections that a field holds, one or several, in the moved plan; anything else as it is."""
    if isinstance(value, Section):
        return move(value, by, digits)
    if isinstance(value, tuple):
        return tuple(_move_sections(item, by, digits) for item in value)
    return value


def _move_value(value: Any, key: FieldType, by: tuple[float, float], digits: int) -> Any:
    """Return a value of some type in the moved plan: another one if it has coordinates."""
    if value is None:
        return None
    if isinstance(key, Coordinate):
        return round(value + by[key.axis], digits)
    if isinstance(key, Place):
        return round(value[0] + by[0], digits), round(value[1] + by[1], digits)
    if isinstance(key, ListOf):
        return tuple(_move_value(item, key.each, by, digits) for item in value)
    return value
