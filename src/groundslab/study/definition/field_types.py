"""Field types that only a study file has: values in the unit of another key, one length or two."""

from __future__ import annotations

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
class OneOrTwo(FieldType):
    """One value for both directions, or two, along x and along y; kept as a pair."""

    each: FieldType
    symbol: str
    meaning: str

    def read(self, value: Any, from_file: bool) -> tuple[Any, Any]:
        """Return the pair."""
        if isinstance(value, list | tuple):
            x, y = ListOf(self.each, "", "", 2).read(value, from_file)
            return x, y
        one = self.each.read(value, from_file)
        return one, one

    def expected(self) -> str:
        """Return both ways to write it."""
        return f"{self.each.expected()}, or a list of two, along x and y"

    def write(self, value: tuple[Any, Any]) -> str:
        """Return one value if both are the same, else the list."""
        x, y = map(self.each.write, value)
        return x if x == y else f"[{x}, {y}]"

    def type_text(self) -> str:
        """Return what each is."""
        return f"{self.each.type_text()}, or a list of two"

    def range_text(self) -> str:
        """Return each one's range."""
        return self.each.range_text()

    def json_schema(self) -> dict[str, Any]:
        """Return one or an array of two."""
        each = self.each.json_schema()
        return {"anyOf": [each, {"type": "array", "items": each, "minItems": 2, "maxItems": 2}]}
