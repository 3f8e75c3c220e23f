"""Numbers as programs of many countries write them, exact as they are printed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from decimal import Decimal
from typing import get_args

from groundslab.model.reactions import Decimals

_SIGN, _POWER = r"[+-]?", r"(?:[eE][+-]?[0-9]{1,3})?"
Cell = str | float
_PLAIN = re.compile(rf"{_SIGN}(?:[0-9]{{1,40}}(?:\.[0-9]{{0,40}})?|\.[0-9]{{1,40}}){_POWER}")
_GROUPED = re.compile(rf"{_SIGN}[1-9][0-9]{{0,2}}(?:[ '][0-9]{{3}})+(?:\.[0-9]{{0,20}})?{_POWER}")
_LIKE = re.compile(rf"{_SIGN}[0-9.,' ]*[0-9][0-9.,' ]*{_POWER}")
_MARKS = str.maketrans({"−": "-", "–": "-", "\u00a0": " ", "\u202f": " ", "’": "'"})
#: Digits of the numbers of a workbook, which are floats: what is printed of them.
DIGITS = 12


def find_decimals(cells: Iterable[Cell], commas: bool) -> Decimals | None:
    """Return what stands before decimals in the numbers of a table; None if they leave it open.

    Parameters
    ----------
    cells : iterable of str or float
        The numbers; other text is passed over.
    commas : bool
        Whether commas stand between cells, so that those within a cell more likely group digits.
    """
    texts = (cell.translate(_MARKS) for cell in cells if isinstance(cell, str))
    kinds: Counter[str] = Counter()
    firm = set[Decimals]()
    for text in texts:
        if not _LIKE.fullmatch(text):
            continue
        if "." in text and "," in text:
            firm.add("point" if text.rfind(".") > text.rfind(",") else "comma")
            continue
        for mark in ".,":
            # 1.234 and 1,234 may be grouped digits as well as decimals
            grouped = re.fullmatch(rf"[+-]?[1-9][0-9]{{0,2}}(?:[{mark}][0-9]{{3}})+", text)
            kinds[mark + "?" * bool(grouped)] += mark in text
    if firm:
        return firm.pop() if len(firm) == 1 else None
    if kinds["."] and kinds[","]:
        return None
    if kinds["."] or kinds[","]:
        return "point" if kinds["."] else "comma"
    if kinds[",?"]:
        return None if commas or kinds[".?"] else "comma"
    return "point"


def parse_number(cell: Cell, decimals: Decimals) -> Decimal | None:
    """Return the number in a cell exactly as it is written; None for anything else."""
    if isinstance(cell, float):
        return Decimal(f"{cell:.{DIGITS}g}")
    text = cell.translate(_MARKS).strip()
    mark, other = (",", ".") if decimals == "comma" else (".", ",")
    text = text.replace(other, "'").replace(mark, ".")
    if not (_PLAIN.fullmatch(text) or _GROUPED.fullmatch(text)):
        return None
    return Decimal(text.replace("'", "").replace(" ", ""))


def readings(text: str) -> tuple[Decimal, ...]:
    """Return the numbers that a text may be: two where commas and points mean other things in other countries."""
    numbers = (parse_number(text, decimals) for decimals in get_args(Decimals))
    return tuple(dict.fromkeys(number for number in numbers if number is not None))


def why_unclear(text: str) -> str:
    """Return that a text may be two numbers, nothing if it is at most one."""
    numbers = readings(text)
    return f"{text.strip()} may be {' or '.join(map(format_number, numbers))}" if len(numbers) > 1 else ""


def format_number(number: Decimal) -> str:
    """Return a number without an exponent and without zeros at its end, such as 812.4; 0 is without a sign."""
    if not number:
        return "0"
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text
