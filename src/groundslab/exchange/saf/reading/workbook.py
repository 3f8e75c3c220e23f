"""The workbook of a file: opened with limits on what it may unfold to, its sheets as rows of named cells."""

from __future__ import annotations

import io
import re
import warnings
import zipfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.exchange.filled_rows import has_more_rows
from groundslab.exchange.saf.units import heading_key, heading_unit
from groundslab.optional import import_optional
from groundslab.schema.wording import describe, listed

#: The largest file that is read, what its parts may unfold to [bytes], and how many parts it may have.
LARGEST_FILE, LARGEST_CONTENT, MOST_PARTS = 64_000_000, 256_000_000, 2000
#: Rows and columns of a sheet, and cells of all sheets, at most.
MOST_ROWS, MOST_COLUMNS, MOST_CELLS = 200_000, 400, 5_000_000
#: Letters of a cell, at most.
LONGEST_TEXT = 32_767
#: Letters of a sheet's name that Excel keeps.
LONGEST_NAME = 31

#: Sheets whose rows may be parts of one object.
PARTS = ("StructuralEdgeConnection", "StructuralCurveConnection")
#: Differences of two rows that are listed, at most.
MOST_LISTED = 3

#: Sheets that have their headings in the first column.
UPRIGHT = ("Project", "Model")

_EXPECTED = "an Excel workbook in the Structural Analysis Format (XLSX)"
#: Definitions of entities, which XML of a workbook has no need of and which may unfold without end.
_DEFINITION = re.compile("|".join(("<!DOCTYPE", "<!\0D\0O\0C", "<\0!\0D\0O")).encode())
_PIECE = 1 << 20


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a sheet: its cells by the keys of their columns' headings, and the units in these headings.

    Where two columns of one heading say different things of it, or in different units, there are issues.
    """

    sheet: str
    number: int
    cells: Mapping[str, Any]
    units: Mapping[str, str]
    issues: tuple[Issue, ...] = ()

    @property
    def name(self) -> str:
        """Return the name of the object in the row."""
        return cell_text(self.cells.get("name"))


def cell_text(value: object) -> str:
    """Return what a cell says, numbers as they are written."""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        value = int(value)
    return "" if value is None else str(value).strip()


def read_sheets(path: str, names: frozenset[str]) -> tuple[dict[str, list[Row]], dict[str, int]]:
    """Return the rows of the sheets with some names, and how many rows each of the others has; raises InputError."""
    reader = import_optional("openpyxl", "which reads and writes workbooks", "exchange")
    content = _read_file(path)
    _require_harmless(path, content)
    try:
        # openpyxl warns of styles and validations that it leaves out
        with warnings.catch_warnings(action="ignore"):
            book = reader.load_workbook(io.BytesIO(content), read_only=True, data_only=True, keep_links=False)
            return _sheets_of(book, path, names)
    except (InputError, MemoryError):
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        damage = f"a damaged workbook ({type(error).__name__}: {str(error)[:100]})"
        raise InputError([Issue(path, damage, _EXPECTED, "open it in Excel and save it again")]) from None


def _sheets_of(book: Any, path: str, names: frozenset[str]) -> tuple[dict[str, list[Row]], dict[str, int]]:
    """Return the rows of the sheets with some names, and how many rows each of the others has."""
    shortened = {name[:LONGEST_NAME].lower(): name for name in names}
    sheets: dict[str, list[Row]] = {}
    others: dict[str, int] = {}
    cells = 0
    for sheet in book.worksheets:
        name = shortened.get(sheet.title.strip().lower())
        if name is None:
            others[sheet.title.strip()] = max((sheet.max_row or 1) - 1, 0)
            continue
        if has_more_rows(book, sheet, MOST_ROWS):
            raise InputError([Issue(f"{path}, sheet {name}", f"more than {MOST_ROWS:,} rows", "fewer")])
        rows = sheets.setdefault(name, [])
        for row in _rows_of(sheet, name, path):
            cells += len(row.cells)
            if cells > MOST_CELLS:
                raise InputError([Issue(path, f"more than {MOST_CELLS:,} cells", "fewer")])
            rows.append(row)
    return sheets, others


def _read_file(path: str) -> bytes:
    """Return the bytes of a file; raises InputError for what is none, or too large."""
    try:
        if Path(path).exists() and not Path(path).is_file():
            raise InputError([Issue(path, "no plain file", _EXPECTED)])
        with Path(path).open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise InputError([Issue(path, "no file of that name", _EXPECTED)]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError([Issue(path, f"a file that cannot be read ({reason})", _EXPECTED)]) from None
    if len(content) > LARGEST_FILE:
        raise InputError([Issue(path, "a larger file", f"at most {LARGEST_FILE:,} bytes")])
    return content


def _require_harmless(path: str, content: bytes) -> None:
    """Raise InputError for anything that is no workbook, or one that would unfold to far more than it says."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as parts:
            _require_limits(path, parts)
    except (InputError, MemoryError):
        raise
    except Exception as error:  # of any kind, as above
        raise InputError([Issue(path, f"no workbook ({str(error)[:100]})", _EXPECTED)]) from None


def _require_limits(path: str, parts: zipfile.ZipFile) -> None:
    """Raise InputError for too many or too large parts, and for XML that defines entities."""
    infos = parts.infolist()
    content = sum(info.file_size for info in infos)
    if len(infos) > MOST_PARTS or content > LARGEST_CONTENT:
        excess = f"{len(infos):,} parts that unfold to {content:,} bytes"
        raise InputError([Issue(path, excess, f"at most {MOST_PARTS:,} parts and {LARGEST_CONTENT:,} bytes")])
    for info in infos:
        if info.filename.lower().endswith((".xml", ".rels")):
            with parts.open(info) as part:
                before = b""
                while piece := part.read(_PIECE):
                    if _DEFINITION.search(before + piece):
                        raise InputError([Issue(f"{path}, {info.filename}", "a document type definition", "none")])
                    before = piece[-32:]


def _rows_of(sheet: Any, name: str, path: str) -> Iterator[Row]:
    """Yield the rows of a sheet; of several tables side by side those of one after the other."""
    sheet.reset_dimensions()
    lines = sheet.iter_rows(max_row=1 if name not in UPRIGHT else MOST_ROWS, max_col=MOST_COLUMNS, values_only=True)
    where = f"{path}, sheet {name}"
    if name in UPRIGHT:
        pairs = [(heading_key(line[0]), line[1]) for line in lines if len(line) > 1 and line[0] is not None]
        yield _make_row(name, 1, where, [(key, "", value) for key, value in pairs])
        return
    headings: tuple[Any, ...] = next(lines, ())
    while headings and headings[-1] is None:
        headings = headings[:-1]
    keys = [heading_key(heading) if heading is not None else "" for heading in headings]
    units = [heading_unit(heading) for heading in headings]
    # a table starts where the first heading comes again
    starts = [position for position, key in enumerate(keys) if key and key == keys[0]] or [0]
    lines = sheet.iter_rows(min_row=2, max_row=MOST_ROWS + 1, max_col=max(len(keys), 1), values_only=True)
    for number, line in enumerate(lines, start=2):
        if number > MOST_ROWS and any(value is not None for value in line):
            raise InputError([Issue(where, f"more than {MOST_ROWS:,} rows", "fewer")])
        for start, end in zip(starts, [*starts[1:], len(keys)], strict=True):
            parts = zip(keys[start:end], units[start:end], line[start:end], strict=False)
            row = _make_row(name, number, f"{where}, row {number}", parts)
            if row.cells:
                yield row


def _make_row(sheet: str, number: int, where: str, parts: Iterable[tuple[str, str, Any]]) -> Row:
    """Return a row from keys of headings, their units and values; raises InputError for an overlong text."""
    cells, units, issues = dict[str, Any](), dict[str, str](), list[Issue]()
    for key, unit, value in parts:
        if not key or value is None or value == "":
            continue
        if isinstance(value, str) and len(value) > LONGEST_TEXT:
            raise InputError([Issue(where, f"a text of {len(value):,} letters: {describe(value)}", "a shorter one")])
        said = cells.setdefault(key, value), units.setdefault(key, unit)
        if said != (value, unit):
            both = [describe(f"{cell_text(cell)} {of}".strip()) for cell, of in (said, (value, unit))]
            issues.append(Issue(f"{where}, {key}", f"two columns that say {listed(both, 'and')}", "one"))
    return Row(sheet, number, cells, units, tuple(issues))


def find_doubles(path: str, sheets: Mapping[str, Sequence[Row]]) -> Iterator[Issue]:
    """Yield what sheets say twice: objects with the name of another one, and columns with the heading of another.

    Rows of one line support are parts of it, and are joined where they are read; rows of results have no names.
    """
    for sheet, rows in sheets.items():
        first: dict[str, Row] = {}
        for row in rows:
            yield from row.issues
            other = first.setdefault(row.name, row)
            if sheet in UPRIGHT and row is not rows[0]:
                yield Issue(f"{path}, sheet {sheet}", "two sheets of that name", "one")
            elif other is not row and row.name and sheet not in PARTS:
                repetition = f"the name {describe(row.name)} again, as in row {other.number}, {difference(other, row)}"
                yield Issue(f"{path}, sheet {sheet}, row {row.number}", repetition, "each name once in a sheet")


def difference(row: Row, other: Row) -> str:
    """Return in words what two rows on one thing say differently."""
    keys = [key for key in {**row.cells, **other.cells} if key not in ("id", "name")]
    pairs = [(key, cell_text(row.cells.get(key)), cell_text(other.cells.get(key))) for key in keys]
    differ = [f"{key} {describe(a)} and {describe(b)}" for key, a, b in pairs if a != b]
    more = f" and {len(differ) - MOST_LISTED} more" if len(differ) > MOST_LISTED else ""
    return f"with {', '.join(differ[:MOST_LISTED])}{more}" if differ else "with the same values"
