"""Field types that only a study file has: values in the unit of another key, one length or two."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.schema.fields import FieldType, ListOf
from groundslab.schema.issues import field_error

#: A value as the file or Python gives it, before its key is known.
Raw = str | float | int | bool | tuple[Any, ...]


@dataclass(frozen=True)
class Amount(FieldType):
    """A value of a key elsewhere, with that key's unit and range, which are checked once the key is known."""

    symbol: str
    meaning: str
    like: str = "as the key at path"

    def read(self, value: Any, from_file: bool) -> Raw:
        """Return the value as it is given."""
        if isinstance(value, list | tuple):
            return tuple(self.read(item, from_file) for item in value)
        if hasattr(value, "item"):  # NumPy's numbers
            value = value.item()
        if not isinstance(value, str | int | float | bool):
            raise field_error(value, self.expected())
        return value

    def expected(self) -> str:
        """Return where the unit comes from."""
        return f"a value {self.like}"

    def type_text(self) -> str:
        """Return where the unit comes from."""
        return self.like

    def json_schema(self) -> dict[str, Any]:
        """Return any value."""
        return {"type": ["string", "number", "boolean", "array"]}


@dataclass(frozen=True)
class OneOrTwo(ListOf):
    """One value for both directions, or two, along x and along y; kept as a pair."""

    length: int | None = 2

    def read(self, value: Any, from_file: bool) -> tuple[Any, ...]:
        """Return the pair."""
        if isinstance(value, list | tuple):
            return super().read(value, from_file)
        return (self.each.read(value, from_file),) * 2

    def expected(self) -> str:
        """Return both ways to write it."""
        return f"{self.each.expected()}, or a list of two, along x and y"

    def write(self, value: Sequence[Any]) -> str:
        """Return one value if both are the same, else the list."""
        return self.each.write(value[0]) if value[0] == value[1] else super().write(value)

    def type_text(self) -> str:
        """Return the type of the two values in words."""
        return f"{self.each.type_text()}, or a list of two"

    def json_schema(self) -> dict[str, Any]:
        """Return one or an array of two."""
        return {"anyOf": [self.each.json_schema(), super().json_schema()]}
