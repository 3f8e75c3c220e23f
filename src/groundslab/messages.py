"""Messages: texts that know the template they were made from, and the values in its holes.

Whoever finds something out says it as a message; units and languages are chosen where it is shown, by its values. As
text a message is English in SI units, which is what programs and tests read.
"""

from __future__ import annotations

import functools
import math
import string
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Self, TypeAlias

from groundslab.unit_systems import System, unit_in
from groundslab.units import format_coordinate, format_drawn, format_drawn_coordinate

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: What fills a hole: a text, a number or a place.
Value: TypeAlias = "str | float | Sequence[float] | NDArray[np.float64]"
#: Returns the text of a value by the format and unit of its hole.
Writer = Callable[[Any, str], str]
#: Formats that Python has not: of coordinates, and of coordinates and numbers on figures.
FORMATS: Mapping[str, Callable[[float], str]] = {
    "at": format_coordinate, "place": format_drawn_coordinate, "number": format_drawn,
}  # fmt: skip
#: The format of a text that begins with a capital letter.
CAPITAL = "capital"


class Name(str):
    """A text that is the same in all languages and units: the name of a thing of a case, a clause, a symbol.

    What a thing without a name is called is a message, and stays one.
    """

    __slots__ = ()

    def __new__(cls, text: object = "") -> Self:
        """Return the text as a name; one that is said already as it is."""
        return text if isinstance(text, cls | Message) else super().__new__(cls, text)  # type: ignore[return-value]

    def __str__(self) -> str:
        """Return the name, which stays one."""
        return self


class Clause(Name):
    """Where something is ruled, as in "EN 1992-1-1 6.4.4(1)": its numbers are no quantities, but a table is a table."""

    __slots__ = ()


class Symbol(Name):
    """A symbol such as "v_Rd,c", which is ours and has an index where it is typeset."""

    __slots__ = ()


class Label(str):
    """A text for people without values, such as the head of a column or a figure, which languages have as a whole."""

    __slots__ = ()

    def __new__(cls, text: object = "") -> Self:
        """Return the text as a label; a name and a message as they are."""
        return text if isinstance(text, cls | Name | Message) else super().__new__(cls, text)  # type: ignore[return-value]


class Message(str):
    """A template with its values.

    Parameters
    ----------
    template : str
        English text with named holes, as in "{beam}: {M:.4g kNm} at {place:.3f m}". A hole has the format of its
        number and its unit of display, in which the value is given. A unit in brackets is not written, as another
        number with the same one follows: "{w:.3g (mm)} <= {limit:.3g mm}". `FORMATS` has formats that Python has not.
    **values : float, tuple of float or str
        What fills the holes: a number, a place, a `Name`, another message.

    Examples
    --------
    >>> said = Message("{beam}: {M:.4g kNm} at {place:.2f m}", beam=Name("B 2 m"), M=120.0, place=(1.0, 2.0))
    >>> said
    'B 2 m: 120 kNm at (1.00, 2.00) m'
    >>> words_in(said, "US")
    'B 2 m: 88.51 kip ft at (3.3, 6.6) ft'
    """

    __slots__ = ("template", "units", "values")

    template: str
    values: Mapping[str, Any]
    units: System

    def __new__(cls, template: str, /, **values: Value) -> Self:
        """Return the message in SI units."""
        return cls._made(template, values, "SI")

    @classmethod
    def _made(cls, template: str, values: Mapping[str, Any], units: System) -> Self:
        made = super().__new__(cls, fill(template, template, values, functools.partial(written, units=units)))
        made.template, made.values, made.units = template, values, units
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        """Return how a copy is made."""
        return type(self)._made, (self.template, dict(self.values), self.units)

    def __str__(self) -> str:
        """Return the message, which stays one."""
        return self

    def __add__(self, other: str) -> Message:
        """Return this message and what follows it as one."""
        return joined((self, other), "") if other else self

    def __radd__(self, other: str) -> Message:
        """Return this message and what goes before as one."""
        return joined((other, self), "") if other else self

    @property
    def key(self) -> str:
        """The template as catalogues have it: its holes by their names alone."""
        return key_of(self.template)

    def in_units(self, units: System) -> Message:
        """Return the message with all its quantities in the units of a system."""
        if units == self.units:
            return self
        values = {name: words_in(each, units) if isinstance(each, str) else each for name, each in self.values.items()}
        return self._made(self.template, values, units)


class Listed(Message):
    """Texts one after another, with a mark between."""

    __slots__ = ()

    @property
    def mark(self) -> str:
        """What stands between."""
        return self.template

    @property
    def parts(self) -> tuple[str, ...]:
        """The texts."""
        return tuple(self.values.values())

    @classmethod
    def _made(cls, template: str, values: Mapping[str, Any], units: System) -> Self:
        made = str.__new__(cls, template.join(values.values()))
        made.template, made.values, made.units = template, values, units
        return made


def joined(parts: Iterable[str], mark: str = ", ") -> Listed:
    """Return texts, messages among them, one after another with a mark between."""
    return Listed._made(mark, {str(number): part for number, part in enumerate(parts, start=1)}, "SI")


def series(parts: Iterable[str]) -> str:
    """Return texts as a list in words: "a, b and c"."""
    *others, last = parts
    return joined((joined(others), last), " and ") if others else last


def capitalized(text: str, change: Callable[[str], str] = str.upper) -> str:
    """Return a text with its first letter in upper case, or in lower case; of a message, that of its template."""
    if isinstance(text, Name) or not text:
        return text
    if not isinstance(text, Message):
        return change(text[0]) + text[1:]
    values, template = dict(text.values), text.template
    if isinstance(text, Listed) or template.startswith("{"):
        first = next(iter(values)) if isinstance(text, Listed) else holes_of(template)[0][1]
        assert first is not None
        if isinstance(values[first], str):
            values[first] = capitalized(values[first], change)
    else:
        template = change(template[0]) + template[1:]
    return type(text)._made(template, values, text.units)


def with_names(text: str, change: Callable[[str], str]) -> str:
    """Return a text in which each name of a case is changed, those in its holes too."""
    if isinstance(text, Name):
        return text if isinstance(text, Clause | Symbol) else Name(change(text))
    if not isinstance(text, Message):
        return text
    values = {hole: with_names(each, change) if isinstance(each, str) else each for hole, each in text.values.items()}
    return type(text)._made(text.template, values, text.units)


def counted(count: int, one: str, many: str, **values: Value) -> Message:
    """Return the message about one thing or that about several; each has a hole for their `count`."""
    return Message(one if count == 1 else many, count=count, **values)


def quantity(value: float, unit: str, form: str = ".4g") -> Message:
    """Return a number in its unit of display, which may be none."""
    return Message(f"{{value:{form} {unit}}}" if unit else f"{{value:{form}}}", value=value)


def quoted(names: Iterable[str], most: int = 5) -> Name:
    """Return the first of some names, in quotes."""
    given = list(names)
    return Name(", ".join(f'"{name}"' for name in given[:most]) + (" ..." if len(given) > most else ""))


def words_in(text: str, units: System) -> str:
    """Return a text with its quantities in the units of a system; what is no message has none."""
    return text.in_units(units) if isinstance(text, Message) else text


def as_values(text: str) -> Any:
    """Return a text as data for JSON: of a message its template and values, of texts in a row these with their mark.

    Numbers that are not finite, which JSON does not know, are words.
    """
    if isinstance(text, Listed):
        return {"mark": text.mark, "texts": [as_values(part) for part in text.parts]}
    if not isinstance(text, Message):
        return {"name": str(text)} if isinstance(text, Name) else str(text)

    def number(value: Any) -> Any:
        plain = value.item() if hasattr(value, "item") else value
        return plain if math.isfinite(plain) else str(plain)

    values = {
        name: as_values(value) if isinstance(value, str)
        else [*map(number, value)] if _is_place(value) else number(value)
        for name, value in text.values.items()
    }  # fmt: skip
    return {"template": text.template, "values": values}


def _is_place(value: Any) -> bool:
    """Return whether a value has several numbers."""
    return isinstance(value, tuple | list) or bool(getattr(value, "ndim", 0))


def fill(text: str, template: str, values: Mapping[str, Any], write: Writer) -> str:
    """Return a text whose holes are those of a template, in any order, with their values written."""
    specs = {name: spec for _, name, spec in holes_of(template) if name is not None}
    return "".join(
        literal + (write(values[name], specs[name]) if name is not None else "") for literal, name, _ in holes_of(text)
    )


@functools.cache
def holes_of(template: str) -> tuple[tuple[str, str | None, str], ...]:
    """Return what stands before each hole, its name, and the format and unit behind its colon; None without a hole."""
    return tuple((literal, name, spec or "") for literal, name, spec, _ in string.Formatter().parse(template))


@functools.cache
def key_of(template: str) -> str:
    """Return a template without formats and units."""
    return "".join(
        literal.replace("{", "{{").replace("}", "}}") + ("" if name is None else f"{{{name}}}")
        for literal, name, _ in holes_of(template)
    )


def written(value: Any, spec: str, units: System = "SI") -> str:
    """Return a value as text: a number or a place by its format and unit, given in SI units, in those of a system."""
    if isinstance(value, str):
        return value[:1].upper() + value[1:] if spec == CAPITAL else value
    form, _, unit = spec.partition(" ")
    shown, factor = unit_in(unit.strip("()"), units)
    if factor != 1.0:
        form = _adapted(form, factor)

    def number(value: Any) -> str:
        scaled = value if factor == 1.0 else value * factor
        return FORMATS[form](scaled) if form in FORMATS else format(scaled, form)

    text = f"({', '.join(map(number, value))})" if _is_place(value) else number(value)
    return f"{text} {shown}" if shown and not unit.startswith("(") else text


def _adapted(form: str, factor: float) -> str:
    """Return the format of a number that is a factor larger: as many digits behind the point less or more.

    A number that is written as it is given has four digits.
    """
    if form == "g":
        return ".4g"
    if not form.endswith("f"):
        return form
    decimals = int(form.partition(".")[2][:-1]) - round(math.log10(factor))
    return f"{form.partition('.')[0]}.{max(0, decimals)}f"
