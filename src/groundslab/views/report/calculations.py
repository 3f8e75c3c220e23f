"""The chapter of calculations: each check on a sheet of its own, with formulas as they are written by hand."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import groupby
from typing import Literal

from groundslab.design.basis.calculation import SYMBOL
from groundslab.design.tables.table import Table
from groundslab.units import format_number
from groundslab.views.report.table_layout import split_symbol

#: A piece of a formula: its text, and whether it stands as it is, below or above the line, or is a variable.
Piece = tuple[str, Literal["", "var", "sub", "sup"]]
#: A small or a large number, a power, a symbol and what stands between.
_TOKENS = re.compile(
    r"(?P<digits>\d[\d.]*)e(?P<exponent>[-+]\d+)|\^\((?P<power>[^()]+)\)|\^(?P<raised>[\d.]+)"
    rf"|(?P<symbol>{SYMBOL.pattern})|(?P<rest>[^^A-Za-z\d]+|[\d.]+(?![\d.e])|.)"
)
FUNCTIONS = {"sqrt": "√"}


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a sheet."""

    quantity: str
    symbol: str
    formula: str
    numbers: str
    value: str
    unit: str
    clause: str


@dataclass(frozen=True, slots=True)
class Sheet:
    """The calculation of one check at one place in one combination."""

    title: str
    lines: tuple[Line, ...]


def build_sheets(table: Table) -> list[Sheet]:
    """Return the sheets of the table of calculations."""
    rows = zip(*(column.values for column in table.columns), strict=True)
    sheets = []
    for about, of_one in groupby(rows, key=lambda row: row[:3]):
        lines = [
            Line(
                str(quantity),
                str(symbol),
                str(formula),
                str(numbers),
                format_number(float(value)),
                str(unit),
                str(clause),
            )
            for *_, quantity, symbol, formula, numbers, value, unit, clause in of_one
            if isinstance(value, int | float)
        ]
        title = ", ".join(str(part) for part in about if part)
        sheets.append(Sheet(f"{title[0].upper()}{title[1:]}", tuple(lines)))
    return sheets


def split_formula(formula: str) -> list[Piece]:
    """Return a formula such as "C * (f_ck / 2)^(1/3)" in pieces, with raised powers and lowered indices."""
    pieces: list[Piece] = []
    for match in _TOKENS.finditer(formula):
        if exponent := match["exponent"]:
            pieces += [(f"{match['digits']} \N{MULTIPLICATION SIGN} 10", ""), (f"{int(exponent)}", "sup")]
        elif power := match["power"] or match["raised"]:
            pieces.append((power, "sup"))
        elif name := match["symbol"]:
            if name in FUNCTIONS or name in ("max", "min", "abs"):
                pieces.append((FUNCTIONS.get(name, name), ""))
            else:
                base, _, index = name.partition("_")
                ((letter, _), *_) = split_symbol(base)
                pieces += [(letter, "var"), *([(index, "sub")] if index else [])]  # type: ignore[list-item]
        else:
            pieces.append((match["rest"].replace(" * ", " · ").replace("-", "\N{MINUS SIGN}"), ""))
    return pieces
