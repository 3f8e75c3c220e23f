"""Cells of tables that other programs write: CSV in their dialects, and sheets of workbooks."""

from __future__ import annotations

import csv
import io
import warnings
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.exchange.filled_rows import has_more_rows
from groundslab.optional import import_optional
from groundslab.schema.wording import describe, one_of, printable

#: Bytes of a file, and of all that a workbook holds once it is unpacked.
LARGEST, UNPACKED = 50_000_000, 500_000_000
MOST_ROWS, MOST_COLUMNS, MOST_SHEETS = 100_000, 500, 100
#: Cells of all sheets that hold something, at most.
MOST_CELLS = 1_000_000
#: Characters of a cell that are read; no name or number is longer.
LONGEST = 200
#: What may stand between the cells of a line, the first one that half of the lines have: commas may be decimal.
BETWEEN = ("\t", ";", ",")
_WORKBOOKS = (".xlsx", ".xlsm")
_ENDINGS = (*_WORKBOOKS, ".csv", ".txt", ".tsv")

Cell = str | float


@dataclass(frozen=True, slots=True)
class Grid:
    """The cells of a table, as long as they are in each row: text without spaces around it, or numbers of a workbook.

    Attributes
    ----------
    rows : tuple of tuple of str or float
        The rows from the first one of the file.
    name : str
        File, and sheet, for messages.
    commas : bool
        Whether commas stand between the cells.
    sheet : str
        Name of the sheet; empty for a text file.
    """

    rows: tuple[tuple[Cell, ...], ...]
    name: str
    commas: bool = False
    sheet: str = ""


def read_grids(path: str | Path) -> tuple[Grid, ...]:
    """Return the cells of a CSV file, or of each sheet of a workbook.

    Parameters
    ----------
    path : str or pathlib.Path
        The file; ``.xlsx`` and ``.xlsm`` are workbooks, of which the values that were saved are read: formulas are not
        computed, macros and links to other files not followed.

    Raises
    ------
    InputError
        If the file cannot be read, or is larger than a table of reactions could be.
    """
    path = Path(path)
    if path.suffix.lower() not in _ENDINGS:
        ending = f'"{path.suffix}"' if path.suffix else "a name without an ending"
        raise InputError([Issue(str(path), ending, f"a name that ends with {one_of(_ENDINGS)}")])
    content = _read_bytes(path)
    if path.suffix.lower() in _WORKBOOKS:
        return _read_workbook(content, str(path))
    return (_read_text(content, str(path)),)


def _read_bytes(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError([Issue(str(path), f"a file that cannot be read ({reason})", "a table")]) from None
    if len(content) > LARGEST:
        raise _too_large(str(path), f"more than {LARGEST // 1_000_000} MB")
    return content


def _too_large(name: str, found: str) -> InputError:
    expected = f"a table of at most {MOST_ROWS:,} rows and {MOST_COLUMNS} columns"
    return InputError([Issue(name, found, expected, "save only reactions, of the cases that are needed")])


def _read_text(content: bytes, name: str) -> Grid:
    """Return the cells of a text file."""
    text = _decode(content, name)
    lines = text.splitlines()
    if len(lines) > MOST_ROWS:
        raise _too_large(name, f"{len(lines):,} lines")
    between = _find_between(lines)
    rows = []
    try:
        for row in csv.reader(io.StringIO(text), delimiter=between, skipinitialspace=True):
            rows.append(tuple(printable(cell).strip()[:LONGEST] for cell in row))
            if len(row) > MOST_COLUMNS:
                raise _too_large(name, f"{len(row):,} columns in line {len(rows)}")
    except csv.Error as error:
        where = f"{name}, line {len(rows) + 1}"
        raise InputError([Issue(where, f"text that is no table ({error})", "cells, each on one line")]) from None
    return Grid(tuple(rows), name, between == ",")


def _decode(content: bytes, name: str) -> str:
    """Return a text by its byte order mark, else as UTF-8, else in the code page of Western Windows."""
    marked = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}.get(content[:2])
    for encoding in (marked,) if marked else ("utf-8-sig", "cp1252"):
        try:
            text = content.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise InputError([Issue(name, "bytes that are no text", "a CSV file", "save it as CSV, UTF-8")])


def _find_between(lines: Sequence[str]) -> str:
    """Return what stands between cells."""
    first = [line for line in lines[:500] if line.strip()]
    counts = {letter: sum(letter in line for line in first) for letter in BETWEEN}
    return next((letter for letter in BETWEEN if 2 * counts[letter] >= max(1, len(first))), ",")


def _read_workbook(content: bytes, name: str) -> tuple[Grid, ...]:
    """Return the cells of the sheets of a workbook."""
    openpyxl = import_optional("openpyxl", "to read workbooks", "exchange", "or save the table as CSV")
    _require_small(content, name)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of styles and extensions that are of no use here
            return tuple(_read_sheets(openpyxl, content, name))
    except InputError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        damage = f"a damaged workbook ({type(error).__name__})"
        hint = "save it again in the program that made it, or as CSV"
        raise InputError([Issue(name, damage, "a workbook (XLSX)", hint)]) from None


def _read_sheets(openpyxl: Any, content: bytes, name: str) -> Iterator[Grid]:
    """Yield the cells of each sheet, without links, and with the values that were saved in place of formulas."""
    saved, written = (
        openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=data_only, keep_links=False)
        for data_only in (True, False)
    )
    if len(saved.worksheets) > MOST_SHEETS:
        raise _too_large(name, f"{len(saved.worksheets)} sheets")
    left = MOST_CELLS
    for values, formulas in zip(saved.worksheets, written.worksheets, strict=True):
        where = f"{name}, sheet {values.title}"
        if has_more_rows(saved, values, MOST_ROWS):
            raise _too_large(where, f"more than {MOST_ROWS:,} rows")
        for sheet in (values, formulas):
            sheet.reset_dimensions()  # what a program says of them may be wrong, and would cut off rows
        both = zip(values.iter_rows(values_only=True), formulas.iter_rows(values_only=True), strict=False)
        rows = _rows(both, where, left)
        left -= sum(map(len, rows))
        yield Grid(rows, where, sheet=values.title)


def _require_small(content: bytes, name: str) -> None:
    """Raise InputError for what is no archive, or would be very large once it is unpacked."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            size = sum(entry.file_size for entry in archive.infolist())
    except Exception as error:  # of any kind, as what is damaged may be anything
        no_workbook = f"a file that is no workbook ({type(error).__name__})"
        raise InputError([Issue(name, no_workbook, "a workbook (XLSX)", "save it again, or as CSV")]) from None
    if size > UNPACKED:
        raise _too_large(name, f"{size // 1_000_000:,} MB once it is unpacked")


def _rows(rows: Iterable[tuple[Sequence[Any], Sequence[Any]]], name: str, most: int) -> tuple[tuple[Cell, ...], ...]:
    """Return the rows of a sheet up to its last one with a value, from values as saved and as written."""
    kept: list[tuple[Cell, ...]] = []
    filled = count = 0
    for number, (saved, written) in enumerate(rows, start=1):
        if number > 2 * MOST_ROWS:
            break  # blank rows without end
        cells = [_cell(value, formula) for value, formula in zip(saved[: 2 * MOST_COLUMNS], written, strict=False)]
        while cells and cells[-1] == "":
            cells.pop()
        kept.append(tuple(cells))
        count += len(cells)
        if count > most:
            raise _too_large(name, f"more than {MOST_CELLS:,} cells")
        if cells:
            filled = number
            if number > MOST_ROWS:
                raise _too_large(name, f"more than {MOST_ROWS:,} rows")
            if len(cells) > MOST_COLUMNS:
                raise _too_large(name, f"{len(cells)} columns in row {number}")
    return tuple(kept[:filled])


def _cell(value: Any, written: Any) -> Cell:
    """Return a value of a workbook as text or number; a formula as text where no value of it was saved."""
    if value is None:
        return "" if written is None else printable(str(written))[:LONGEST]
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value) if abs(value) < 1e300 else describe(value)
    return printable(str(value)).strip()[:LONGEST]
