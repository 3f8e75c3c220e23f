"""Stiffness matrices of buildings as other programs write them: names in the first line, then the rows, as CSV."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from groundslab.case.numbers import find_decimals, parse_number
from groundslab.errors import InputError, Issue
from groundslab.model.structure.building import MOST_BASES
from groundslab.schema.fields import MOST_ISSUES
from groundslab.schema.wording import describe

#: Bytes of a file, at most: rows of so many numbers of 32 letters.
LARGEST = (3 * MOST_BASES) ** 2 * 32
#: Between cells, the first one that the first row of numbers has; after a semicolon commas are rather decimal.
BETWEEN = ("\t", ";", ",")


def with_matrix(tables: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Return the tables of a case with the matrix of its building from the file that it names, if it names one.

    Raises InputError if that cannot be read.
    """
    building = tables.get("building")
    if not isinstance(building, Mapping) or not isinstance(building.get("file"), str) or "matrix" in building:
        return tables
    others = {key: value for key, value in building.items() if key != "file"}
    return tables | {"building": others | _read(folder, building["file"])}


def _cells(line: str, between: str) -> list[str]:
    """Return the cells of one line, which a quote that is not closed does not lead into the next one."""
    try:
        return next(csv.reader([line], delimiter=between, skipinitialspace=True))
    except csv.Error:  # far too many letters in one cell
        return [line]


def _read(folder: Path, name: str) -> dict[str, Any]:
    """Return nodes and matrix in a file of a folder."""
    path = folder / name
    if Path(name).name != name or not path.is_file():
        raise InputError([Issue("building.file", describe(name), f"the name of a file in {folder.absolute()}")])
    where = f"building.file, {path}"
    if path.stat().st_size > LARGEST:
        raise InputError([Issue(where, "a larger file", f"a matrix of at most {3 * MOST_BASES} rows")])
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "a file that is not UTF-8 text"
        raise InputError([Issue(where, reason, "a CSV file")]) from None
    lines = [(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    if len(lines) < 2:
        expected = "names of columns and walls, then rows of numbers"
        raise InputError([Issue(where, f"{len(lines)} lines", expected)])
    between = next((letter for letter in BETWEEN if letter in lines[1][1]), ",")
    names, *rows = (_cells(line, between) for _, line in lines)
    decimals = find_decimals((cell.strip() for row in rows for cell in row), commas=between != ";")
    if decimals is None:
        raise InputError([Issue(where, "numbers whose commas or points may group digits", "one way to read them")])
    matrix, issues = list[list[float]](), list[Issue]()
    for (number, _), row in zip(lines[1:], rows, strict=True):
        numbers = [parse_number(cell.strip(), decimals) for cell in row]
        issues += [
            Issue(
                f"{where}, line {number}, value {position}", describe(cell) if cell.strip() else "nothing", "a number"
            )
            for position, (cell, value) in enumerate(zip(row, numbers, strict=True), start=1)
            if value is None
        ]
        matrix.append([float(value) for value in numbers if value is not None])
    if issues:
        raise InputError(issues[:MOST_ISSUES])
    return {"nodes": [name.strip() for name in names], "matrix": matrix}
