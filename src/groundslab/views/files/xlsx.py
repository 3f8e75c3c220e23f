"""All tables of results as one workbook, XLSX, by XlsxWriter."""

from __future__ import annotations

import datetime
import io
import os
import zipfile
import zlib
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.optional import import_optional
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.storage import atomic, checksums, ownership
from groundslab.views.tables.table import Table
from groundslab.views.translation import translated_tables

if TYPE_CHECKING:
    from xlsxwriter import Workbook

#: What a workbook says of itself, by which it is known.
MARK = "Tables of groundslab"
#: A name of a sheet has no more letters; a column is no wider.
LONGEST_NAME, WIDEST = 31, 60
#: The same results give the same bytes.
LOOK = 100_000  # bytes of a workbook's properties that are looked at
CREATED = datetime.datetime(2000, 1, 1)


def write_workbook(results: CombinationResult | Results, path: str | Path) -> Path:
    """Write all tables of results into one workbook, a sheet each, numbers with all digits.

    Parameters
    ----------
    results : CombinationResult or Results
        Results of one or of several combinations.
    path : str or Path
        File to write (XLSX); an existing file is replaced only if it is such a workbook.

    Returns
    -------
    Path
        The path of the workbook.

    Raises
    ------
    InputError
        If XlsxWriter is missing (extra `tables`), or the file cannot be written.

    Notes
    -----
    The same results give the same bytes.

    Examples
    --------
    >>> import groundslab
    >>> results = groundslab.solve(groundslab.load("case.toml"))
    >>> path = groundslab.write_workbook(results, "tables.xlsx")
    """
    check(path)
    combined = results_of(results)
    return write_tables(translated_tables(combined), combined.model.title, path)


def write_tables(tables: Iterable[Table], title: str, path: str | Path) -> Path:
    """Write tables into a workbook, a sheet each; raises InputError. The same tables give the same bytes."""
    target = check(path)
    content = io.BytesIO()
    with _workbook(content) as book:
        book.set_properties({"title": title, "comments": f"{MARK} {__version__}", "created": CREATED})
        bold, plain = book.add_format({"bold": True}), book.add_format({"text_wrap": False})
        for table in tables:
            _add_sheet(book, table, bold, plain)
    checksums.keep_file(target, _is_unchanged)
    atomic.write(target, content.getvalue())
    return Path(path)


def check(path: str | Path) -> Path:
    """Return the full path if a workbook can be written there; else raise InputError saying why not."""
    _import_xlsxwriter()
    return ownership.check_replaceable(path, _is_workbook, "a workbook of groundslab")


def default_path(folder: str | Path) -> Path:
    """Return where the workbook of a folder of results is put: beside the folder, under its name."""
    whole = Path(os.path.realpath(folder))
    return whole.with_name(f"{whole.name}.xlsx")


def _workbook(content: io.BytesIO) -> Workbook:
    """Return an empty workbook whose texts are no formulas and no links, whatever they look like."""
    texts = {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}
    book: Workbook = _import_xlsxwriter().Workbook(content, {"in_memory": True, "nan_inf_to_errors": True, **texts})
    return book


def _import_xlsxwriter() -> Any:
    instead = "the tables in the folder of results are CSV files, which do without it"
    return import_optional("xlsxwriter", "which writes workbooks", "tables", instead)


def _add_sheet(book: Workbook, table: Table, bold: Any, plain: Any) -> None:
    """Add a table as a sheet: its title, its head, its rows, its notes."""
    sheet = book.add_worksheet(table.name[:LONGEST_NAME])
    sheet.write_string(0, 0, table.title, bold)
    for number, column in enumerate(table.columns):
        sheet.write_string(1, number, column.header, bold)
        longest = max([len(column.header), *(len(value) for value in column.values if isinstance(value, str))])
        sheet.set_column(number, number, min(longest + 2, WIDEST))
        for line, value in enumerate(column.values, start=2):
            if isinstance(value, str):
                sheet.write_string(line, number, value, plain)
            elif value is not None:
                sheet.write_number(line, number, value)
    for line, note in enumerate(table.notes, start=len(table) + 3):
        sheet.write_string(line, 0, note)
    sheet.freeze_panes(2, 0)
    if len(table):
        sheet.autofilter(1, 0, len(table) + 1, len(table.columns) - 1)


def _is_workbook(path: Path) -> bool:
    """Return whether a file is a workbook that groundslab wrote."""
    try:
        with zipfile.ZipFile(path) as book:
            return MARK.encode() in _properties(book)
    except (zipfile.BadZipFile, zlib.error, KeyError, ValueError, EOFError, NotImplementedError, RuntimeError):
        return False


def _is_unchanged(path: Path) -> bool:
    """Return whether no program has saved a workbook again, which would enter the date."""
    with zipfile.ZipFile(path) as book:
        return f">{CREATED.isoformat()}Z</dcterms:modified>".encode() in _properties(book)


def _properties(book: zipfile.ZipFile) -> bytes:
    """Return the beginning of a workbook's core properties."""
    with book.open("docProps/core.xml") as file:
        return file.read(LOOK)
