"""The chapter of calculations: each check on a sheet of its own, with formulas as they are written by hand."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from itertools import groupby
from typing import TYPE_CHECKING, ClassVar, Literal

from groundslab.design.rules.calculation import CONSTANTS, FUNCTIONS, SYMBOL
from groundslab.messages import Message, Name, joined, words_in
from groundslab.unit_systems import unit_in
from groundslab.units import format_number
from groundslab.views.report.drawings.drawings import Drawing
from groundslab.views.report.drawings.perimeter_sketch import draw_sketch
from groundslab.views.report.drawings.perimeter_tables import tables_of_pieces
from groundslab.views.report.table_layout import TableLayout, split_symbol
from groundslab.views.tables.calculations import perimeters
from groundslab.views.tables.table import Table

if TYPE_CHECKING:
    from groundslab.results.results import Results
    from groundslab.unit_systems import System

#: A piece of a formula: its text, and whether it stands as it is, below or above the line, or is a variable.
Piece = tuple[str, Literal["", "var", "sub", "sup"]]
#: A small or a large number, a power, a symbol and what stands between.
_TOKENS = re.compile(
    r"(?P<digits>\d[\d.]*)e(?P<exponent>[-+]\d+)|\^\((?P<power>[^()]+)\)|\^(?P<raised>[\d.]+|[A-Za-z])"
    rf"|(?P<symbol>{SYMBOL.pattern})|(?P<rest>[^^A-Za-z\d]+|[\d.]+(?![\d.e])|.)"
)
#: What is said below the sketch of a perimeter.
SKETCH = "Lengths in m, of arcs with the radius; dashed: what does not count, and tangents."
#: What is said of tables of pieces.
PIECES = (
    "Beside the sketch of a perimeter are its pieces, each from where to where, along axes 1 and 2 from the center of "
    "the column or the end of the wall, and with the center of its length. What they add to the length, to W, the "
    "integral of the distance from the center of all, to I, that of its square, and to l, that of the square of the "
    "cosine of their angle from the axis, is added up below. Arcs are computed as chords, which are shorter by less "
    "than 0.003 %."
)
#: A decimal point.
_POINT = re.compile(r"(?<=\d)\.(?=\d)")
#: How functions and numbers with a name are written, if not by their names.
WRITTEN = {"sqrt": "√", "pi": "π"}


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a sheet; the value is given in another unit too if the case asks for such units."""

    quantity: str
    symbol: str
    formula: str
    numbers: str
    value: str
    unit: str
    clause: str
    other_value: str = ""
    other_unit: str = ""


@dataclass(frozen=True, slots=True)
class Sheet:
    """The calculation of one check at one place in one combination, with the sketch of a perimeter if it has one."""

    check: str
    title: str
    lines: tuple[Line, ...]
    last: float  # what comes out at its end
    sketch: Drawing | None = None
    pieces: tuple[TableLayout, ...] = ()  # of this perimeter, and of others that it calls upon
    of: str = ""  # what is checked, such as a layer of bars and its section
    block: ClassVar = "sheet"


def draw_sheets(combined: Results, table: Table) -> list[Sheet]:
    """Return the sheets of the table of calculations, with sketches of perimeters."""
    sketches = perimeters(combined)
    sheets = []
    for number, (key, sheet) in enumerate(build_sheets(table, combined.model.units).items(), 1):
        if key in sketches:
            label = Message("Perimeter: {title}", title=sheet.title)
            drawn = draw_sketch(combined.solved_model, sketches[key], number, label)
            pieces = tuple(tables_of_pieces(sketches[key], frozenset(line.symbol for line in sheet.lines)))
            sheets.append(replace(sheet, sketch=Drawing(drawn, SKETCH), pieces=pieces))
        else:
            sheets.append(sheet)
    return sheets


def build_sheets(table: Table, units: System) -> dict[tuple[str, str, str], Sheet]:
    """Return the sheets of the table of calculations by check, what they are of, and combination.

    Formulas are in SI units, as codes print them; in other units each value is given beside.
    """
    rows = zip(*(column.values for column in table.columns), strict=True)
    sheets = {}
    for about, of_one in groupby(rows, key=lambda row: row[:3]):
        lines, places, last = [], set(), 0.0
        for *_, quantity, symbol, formula, numbers, value, unit, clause, x, y in of_one:
            if isinstance(value, int | float):
                words = map(str, (symbol, formula, numbers, format_number(float(value)), unit, clause))
                other = _in_other_unit(float(value), str(unit), units)
                last = float(value)
                lines.append(Line(words_in(str(quantity), units), *words, *other))
            if isinstance(x, float) and isinstance(y, float):
                places.add((x, y))
        # places are in the units of the table already
        unit = Name(unit_in("m", units)[0])
        where = [Message("at {place:place} {unit}", place=place, unit=unit) for place in places]
        check, of, combination = map(str, about)
        check_name = Message("{check:capital}", check=check)
        named = [check_name, of if about[1] else "", Name(combination) if about[2] else ""]
        title = joined(filter(None, (*named, *where)))
        sheets[check, of, combination] = Sheet(check, title, tuple(lines), last, of=of)
    return sheets


def _in_other_unit(value: float, unit: str, units: System) -> tuple[str, ...]:
    """Return value and unit in the units of a system; nothing where these are the same."""
    other, factor = unit_in(unit, units)
    return () if other == unit else (format_number(value * factor, fixed=(1e-4, 1e9)), other)


def split_formula(formula: str) -> list[Piece]:
    """Return a formula such as "C * (f_ck / 2)^(1/3)" in pieces, with raised powers and lowered indices."""
    pieces: list[Piece] = []
    for match in _TOKENS.finditer(formula):
        if exponent := match["exponent"]:
            pieces += [(f"{match['digits']} \N{MULTIPLICATION SIGN} 10", ""), (f"{int(exponent)}", "sup")]
        elif power := match["power"] or match["raised"]:
            pieces.append((power, "sup"))
        elif name := match["symbol"]:
            if name in FUNCTIONS + CONSTANTS:
                pieces.append((WRITTEN.get(name, name), ""))
            else:
                base, _, index = name.partition("_")
                ((letter, _), *_) = split_symbol(base)
                pieces += [(letter, "var"), *([(index, "sub")] if index else [])]  # type: ignore[list-item]
        else:
            pieces.append((match["rest"].replace(" * ", " · ").replace("-", "\N{MINUS SIGN}"), ""))
    return pieces


def split_with_commas(formula: str) -> list[Piece]:
    """Return a formula in pieces with decimal commas, and semicolons between what stands in brackets."""
    return [(_POINT.sub(",", text.replace(", ", "; ")), kind) for text, kind in split_formula(formula)]
