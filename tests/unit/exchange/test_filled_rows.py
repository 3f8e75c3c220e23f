"""Rows of workbooks are counted before any is read."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from groundslab.errors import InputError
from groundslab.exchange.filled_rows import has_more_rows
from groundslab.exchange.reactions import cells
from groundslab.exchange.saf.reading import workbook

openpyxl = pytest.importorskip("openpyxl")


def write(path: Path, rows: int, blank: int = 0) -> Path:
    """Write a workbook with a heading, rows with numbers and texts, and blank ones that have a format."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "StructuralPointAction"
    sheet.append(["Name", "Value [kN]"])
    for number in range(rows):
        sheet.append([f"F{number}", float(number)])
    for number in range(blank):
        sheet.cell(row=rows + 2 + number, column=1).font = openpyxl.styles.Font(bold=True)
    book.save(path)
    return path


@pytest.mark.parametrize(("rows", "blank"), [(0, 0), (1, 50), (60_000, 3)])
def test_rows_with_something_are_counted(tmp_path: Path, rows: int, blank: int) -> None:
    """Exactly those with a value count, also over the borders of the pieces that are read at a time."""
    book = openpyxl.load_workbook(write(tmp_path / "a.xlsx", rows, blank), read_only=True)
    sheet = book.worksheets[0]
    assert has_more_rows(book, sheet, rows)
    assert not has_more_rows(book, sheet, rows + 1)
    book.close()


def test_nothing_is_read_of_a_sheet_with_too_many_rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both readers refuse it before they look at a row; one with as many as are allowed is read."""

    def read(*_: Any, **__: Any) -> Any:
        raise AssertionError("a row was read")

    fits, many = write(tmp_path / "fits.xlsx", 29), write(tmp_path / "many.xlsx", 30)
    monkeypatch.setattr(workbook, "MOST_ROWS", 30)
    monkeypatch.setattr(cells, "MOST_ROWS", 30)
    assert len(workbook.read_sheets(str(fits), frozenset({"StructuralPointAction"}))[0]["StructuralPointAction"]) == 29
    assert len(cells.read_grids(fits)[0].rows) == 30
    monkeypatch.setattr(openpyxl.worksheet._read_only.ReadOnlyWorksheet, "iter_rows", read)
    with pytest.raises(InputError, match="more than 30 rows"):
        workbook.read_sheets(str(many), frozenset({"StructuralPointAction"}))
    with pytest.raises(InputError, match="more than 30 rows"):
        cells.read_grids(many)
