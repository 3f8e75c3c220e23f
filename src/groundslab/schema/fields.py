"""Types of fields, each with unit, symbol, range and meaning: checks, messages, JSON schema and docs come from it."""

from __future__ import annotations

import itertools
import numbers
import re
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, get_args

from groundslab import units
from groundslab.messages import Message, Name
from groundslab.schema import ranges, toml_writer
from groundslab.schema.issues import FieldError, RelativeIssue, field_error
from groundslab.schema.repairs import add_unit, meant_word
from groundslab.schema.wording import describe, listed, printable, quote
from groundslab.unit_systems import customary_example

MOST_ISSUES, MOST_VALUES = 100, 10_000  # reported for one table; of a list, unless its key says otherwise
LARGEST_WHOLE = 2**31 - 1


class FieldType:
    """Type of a field that holds a value: how it is read, checked, written and described.

    Stands in the ``Annotated`` of a field. Subclasses are frozen dataclasses with ``symbol`` and ``meaning``.
    """

    symbol: str = ""
    meaning: str = ""
    #: What a value should be, its type in the table of keys, its JSON schema, where they are the same for all fields.
    EXPECTED: ClassVar[str]
    TYPE: ClassVar[str]
    SCHEMA: ClassVar[dict[str, Any]]

    def read(self, value: Any, from_file: bool) -> Any:
        """Return the value in SI units; raises FieldError."""
        raise NotImplementedError

    def expected(self) -> str:
        """Return the expected value in words, for messages and examples."""
        return self.EXPECTED

    def write(self, value: Any) -> str:
        """Return the value as TOML."""
        return toml_writer.value(value)

    def type_text(self) -> str:
        """Return type or unit for the table of keys."""
        return self.TYPE

    def range_text(self) -> str:
        """Return the range for the table of keys."""
        return ""

    def json_schema(self) -> dict[str, Any]:
        """Return the JSON schema of the value in a file."""
        return self.SCHEMA


def as_plain(value: Any) -> Any:
    """Return an array or a number of NumPy as a list or a number of Python, anything else as it is."""
    return value.tolist() if type(value).__module__ == "numpy" else value


def _number(value: Any, expected: str, hint: str = "") -> float:
    """Return a finite number as float; raises FieldError."""
    value = as_plain(value)
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise field_error(value, expected, hint)
    size: Any = abs(value)
    if not size <= sys.float_info.max:
        raise field_error(value, expected, hint or "the number must be finite")
    return float(value)


@dataclass(frozen=True)
class Quantity(FieldType):
    """A number with a unit, text in files, text or a float in SI units in Python; or a word that stands for one."""

    dimension: str
    symbol: str
    meaning: str
    range: ranges.Range = ranges.ANY
    words: tuple[str, ...] = ()
    example: str = ""  # a usual value, by default the dimension's

    def read(self, value: Any, from_file: bool) -> float | str:
        """Return the quantity in SI units, or the word."""
        if isinstance(value, str) and value in self.words:
            return value
        if isinstance(value, str):
            try:
                number = units.parse(value, self.dimension)
            except units.QuantityError as error:
                hint, repairs = meant_word(value, self.words, None)
                repairs = (*add_unit(value, self.dimension, self.range), *repairs)
                raise field_error(value, self.expected(), hint or error.reason, repairs) from None
        elif from_file:
            hint = "write number and unit in quotes" if type(value) in (int, float) else ""
            raise field_error(value, self.expected(), hint, add_unit(value, self.dimension, self.range))
        else:
            si = units.DIMENSIONS[self.dimension].si.replace("%", "parts of 1")
            number = _number(value, f"{self.expected()}, or a number in {si}")
        limits = ranges.quantity_range(self.range, self.dimension)
        if not limits.holds(number):
            wanted = limits.wanted(number, lambda limit: ranges.limit_text(limit, self.dimension))
            raise field_error(value, f"{units.DIMENSIONS[self.dimension].phrase} {wanted}")
        return number

    @property
    def usual(self) -> str:
        """A usual value."""
        return self.example or units.DIMENSIONS[self.dimension].example

    def expected(self) -> str:
        """Return an example, and the words."""
        return listed([units.expectation(self.dimension), *map(quote, self.words)])

    def write(self, value: float | str) -> str:
        """Return the quantity with its SI unit, or the word, in quotes."""
        return quote(value if isinstance(value, str) else units.write(value, self.dimension))

    def type_text(self) -> str:
        """Return the dimension with an example of its units, and the words."""
        example = f"{self.dimension} (`{quote(self.usual)}`)"
        return listed([example, *(f"`{quote(word)}`" for word in self.words)])

    def range_text(self) -> str:
        """Return the range with its unit."""
        limits, unit = ranges.quantity_range(self.range, self.dimension), units.DIMENSIONS[self.dimension].si
        return f"{limits.signs(100 if unit == '%' else 1)} {unit}"

    def json_schema(self) -> dict[str, Any]:
        """Return a string with a number at its front, whose dimension is left to the program, or the words."""
        quantity = {
            "type": "string",
            "pattern": rf"^\s*{units.NUMBER}\s*(?:1/)?[A-Za-zµμ]",
            "maxLength": units.LONGEST,
            "examples": list(dict.fromkeys((self.usual, customary_example(self.usual, self.dimension)))),
            "x-dimension": self.dimension,
            "x-range": self.range_text(),
        }
        return {"anyOf": [quantity, {"enum": list(self.words)}]} if self.words else quantity


@dataclass(frozen=True)
class Number(FieldType):
    """A pure number, or one of some words that stand for a rule to find it."""

    symbol: str
    meaning: str
    range: ranges.Range = ranges.ANY
    words: tuple[str, ...] = ()

    def read(self, value: Any, from_file: bool) -> float | str:  # noqa: ARG002
        """Return the number as float, or the word."""
        if isinstance(value, str) and value in self.words:
            return value
        hint = "write it without quotes" if isinstance(value, str) and re.fullmatch(units.NUMBER, value.strip()) else ""
        number = _number(value, self.expected(), hint)
        limits = ranges.number_range(self.range)
        if not limits.holds(number):
            in_range = replace(self.range, smallest=0.0).holds(number)
            raise field_error(value, f"a number {limits.wanted(number)}" if in_range else self.expected())
        return number

    def expected(self) -> str:
        """Return the range in words."""
        return listed([f"a number {self.range.words()}".strip(), *map(quote, self.words)])

    def type_text(self) -> str:
        """Return that it is a number, or a word."""
        return listed(["number", *(f"`{quote(word)}`" for word in self.words)])

    def range_text(self) -> str:
        """Return the range."""
        return ranges.number_range(self.range).signs()

    def json_schema(self) -> dict[str, Any]:
        """Return a number, or the words."""
        number = {"type": "number", **ranges.number_range(self.range).schema()}
        return {"anyOf": [number, {"enum": list(self.words)}]} if self.words else number


@dataclass(frozen=True)
class Integer(FieldType):
    """A whole number from ``at_least`` to ``at_most``, or one of some words."""

    meaning: str
    at_least: int = 1
    at_most: int = LARGEST_WHOLE
    words: tuple[str, ...] = ()

    def read(self, value: Any, from_file: bool) -> int | str:  # noqa: ARG002
        """Return the number as int, or the word."""
        if isinstance(value, str) and self.words:
            if value not in self.words:
                raise field_error(value, self.expected(), *meant_word(value, self.words, None))
            return value
        integer = isinstance(value, numbers.Integral) and not isinstance(value, bool)
        if not integer or not self.at_least <= value <= self.at_most:
            raise field_error(value, self.expected())
        return int(value)

    def expected(self) -> str:
        """Return the range in words, and the words."""
        return listed([f"a whole number from {self.at_least} to {self.at_most}", *map(quote, self.words)])

    def type_text(self) -> str:
        """Return that it is a whole number, or a word."""
        return listed(["whole number", *(f"`{quote(word)}`" for word in self.words)])

    def range_text(self) -> str:
        """Return the range."""
        return f">= {self.at_least}" if self.at_most == LARGEST_WHOLE else f"{self.at_least} to {self.at_most}"

    def json_schema(self) -> dict[str, Any]:
        """Return an integer, or the words."""
        integer = {"type": "integer", "minimum": self.at_least, "maximum": self.at_most}
        return {"anyOf": [integer, {"enum": list(self.words)}]} if self.words else integer


@dataclass(frozen=True)
class Choice(FieldType):
    """One word out of those of a ``Literal``; ``unlisted`` is the hint for others where one like it may be unsafe."""

    literal: Any
    meaning: str
    unlisted: str | None = None

    @property
    def words(self) -> tuple[str, ...]:
        """The words to choose from."""
        return get_args(self.literal)

    def read(self, value: Any, from_file: bool) -> str:  # noqa: ARG002
        """Return the word."""
        if not isinstance(value, str) or value not in self.words:
            raise field_error(value, self.expected(), *meant_word(value, self.words, self.unlisted))
        return value

    def expected(self) -> str:
        """Return the words."""
        return listed(map(quote, self.words))

    def type_text(self) -> str:
        """Return the words."""
        return listed(f"`{quote(word)}`" for word in self.words)

    def json_schema(self) -> dict[str, Any]:
        """Return the words."""
        return {"enum": list(self.words)}


@dataclass(frozen=True)
class Boolean(FieldType):
    """True or false."""

    EXPECTED: ClassVar = "true or false"
    TYPE: ClassVar = "`true` or `false`"
    SCHEMA: ClassVar = {"type": "boolean"}

    meaning: str

    def read(self, value: Any, from_file: bool) -> bool:  # noqa: ARG002
        """Return the flag."""
        if not isinstance(value, bool):
            raise field_error(value, self.expected(), "write it without quotes" if value in ("true", "false") else "")
        return value


@dataclass(frozen=True)
class Text(FieldType):
    """Free text."""

    EXPECTED: ClassVar = "text in quotes"
    TYPE: ClassVar = "text"
    SCHEMA: ClassVar = {"type": "string"}

    meaning: str

    def read(self, value: Any, from_file: bool) -> Name:  # noqa: ARG002
        """Return the text as it may be shown anywhere, see `printable`, and as it stays wherever it is shown."""
        if not isinstance(value, str):
            raise field_error(value, self.expected())
        if isinstance(value, Message):
            return Name(value)
        if any("\ud800" <= letter <= "\udfff" for letter in value):
            raise field_error(value, "text without lone surrogates")
        return Name(printable(value))


def _read_each(
    kind: FieldType, items: Iterable[tuple[str | int, Any]], from_file: bool, issues: Sequence[RelativeIssue] = ()
) -> list[Any]:
    """Return the values of items by name or position; raises FieldError with their issues behind those given."""
    kept, relative_issues = [], [*issues]
    for place, item in items:
        try:
            kept.append(kind.read(as_plain(item), from_file))
        except FieldError as error:
            relative_issues += [relative.below((place,)) for relative in error.relative_issues]
    if relative_issues:
        raise FieldError(*relative_issues[:MOST_ISSUES])
    return kept


@dataclass(frozen=True)
class ListOf(FieldType):
    """A list of values of one kind, kept as a tuple: of a fixed ``length``, ``rising``, or ``unique``."""

    each: FieldType
    symbol: str
    meaning: str
    length: int | None = None
    rising: bool = False
    unique: bool = False
    least: int = 1  # values, where no length is fixed
    most: int = MOST_VALUES
    members: tuple[str, ...] = ()  # what each of a fixed number of values is

    @property
    def _most(self) -> int:
        return self.length or (len(self.each.words) if self.unique and isinstance(self.each, Choice) else self.most)

    def read(self, value: Any, from_file: bool) -> tuple[Any, ...]:
        """Return the values as a tuple."""
        value = as_plain(value)
        if not isinstance(value, list | tuple) or not (self.length or self.least) <= len(value):
            raise field_error(value, self.expected())
        if len(value) > self._most:
            raise field_error(value, f"at most {self._most} values" if self.length is None else self.expected())
        kept = _read_each(self.each, enumerate(value), from_file)
        pair = f"[{', '.join(describe(item) for item in value[:8])}]"
        if self.rising and not all(a < b for a, b in itertools.pairwise(kept)):
            raise FieldError(RelativeIssue((), pair, "the smaller value first and no empty range"))
        if self.unique and len(set(kept)) < len(kept):
            raise FieldError(RelativeIssue((), pair, "each value at most once"))
        return tuple(kept)

    def expected(self) -> str:
        """Return how many of what."""
        least = {0: "any number", 1: "at least one"}.get(self.least, f"at least {self.least}")
        return f"a list of {self.length or least}, each {self.each.expected()}"

    def write(self, value: Sequence[Any]) -> str:
        """Return the list as TOML."""
        return f"[{', '.join(map(self.each.write, value))}]"

    def type_text(self) -> str:
        """Return how many of what."""
        count = self.length or (f"{self.least} to {self._most}" if self.least else f"up to {self._most}")
        return f"list of {count}: {self.each.type_text()}"

    def range_text(self) -> str:
        """Return each value's range and the order."""
        order = "rising" if self.rising else "no repeats" if self.unique else ""
        return ", ".join(filter(None, (self.each.range_text(), order)))

    def json_schema(self) -> dict[str, Any]:
        """Return an array."""
        count = {"minItems": self.length or self.least, "maxItems": self._most}
        unique = {"uniqueItems": True} if self.unique else {}
        members = {"x-members": list(self.members)} if self.members else {}
        return {"type": "array", "items": self.each.json_schema(), **count, **unique, **members}


@dataclass(frozen=True)
class Factors(FieldType):
    """A table of numbers by names that the file is free to choose, kept as pairs in the order of the file."""

    EACH: ClassVar = Number("", "")
    EXPECTED: ClassVar = "a table of numbers such as {dead = 1.35, live = 1.5}"
    TYPE: ClassVar = "table of numbers"

    symbol: str
    meaning: str

    def read(self, value: Any, from_file: bool) -> tuple[tuple[str, float], ...]:
        """Return the pairs of name and number; a tuple of pairs is taken as well."""
        pairs = tuple(value.items() if isinstance(value, Mapping) else value if isinstance(value, tuple) else ())
        named = (isinstance(pair, tuple) and len(pair) == 2 and isinstance(pair[0], str) for pair in pairs)
        if not pairs or not all(named):
            raise field_error(value, self.expected())
        count = Counter(name for name, _ in pairs)
        twice = [
            RelativeIssue((name,), "a second factor", "one factor for each name") for name in count if count[name] > 1
        ]
        return tuple(zip(map(printable, count), _read_each(self.EACH, pairs, from_file, twice), strict=True))

    def write(self, value: Sequence[tuple[str, float]]) -> str:
        """Return an inline table."""
        return "{" + ", ".join(f"{quote(name)} = {number!r}" for name, number in value) + "}"

    def json_schema(self) -> dict[str, Any]:
        """Return an object of numbers."""
        return {"type": "object", "additionalProperties": self.EACH.json_schema(), "minProperties": 1}


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
