"""Stiffness matrices of buildings as other programs write them: names in the first line, then the rows, as CSV."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.model.structure.building import MOST_BASES
from groundslab.schema.wording import describe

#: Bytes of a file, at most: rows of so many numbers of 32 letters.
LARGEST = (3 * MOST_BASES) ** 2 * 32


def with_matrix(tables: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Return the tables of a case with the matrix of its building from the file that it names, if it names one.

    Raises InputError if that cannot be read.
    """
    building = tables.get("building")
    if not isinstance(building, Mapping) or not isinstance(building.get("file"), str) or "matrix" in building:
        return tables
    others = {key: value for key, value in building.items() if key != "file"}
    return tables | {"building": others | _read(folder / building["file"])}


def _read(path: Path) -> dict[str, Any]:
    """Return nodes and matrix in a file."""
    where = f"building.file, {path}"
    try:
        if path.stat().st_size > LARGEST:
            raise InputError([Issue(where, "a larger file", f"a matrix of at most {3 * MOST_BASES} rows")])
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as error:
        found = getattr(error, "strerror", None) or "a file that is not UTF-8 text"
        raise InputError([Issue(where, found, "a CSV file beside the case")]) from None
    lines = [(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    if not lines:
        raise InputError([Issue(where, "an empty file", "names of columns and walls, then rows of numbers")])
    # tables of countries with a decimal comma have semicolons between cells
    between = ";" if ";" in lines[0][1] else ","
    names, *rows = ([cell.strip().strip('"') for cell in line.split(between)] for _, line in lines)
    matrix, issues = [], list[Issue]()
    for (number, _), row in zip(lines[1:], rows, strict=True):
        values = []
        for position, cell in enumerate(row, start=1):
            try:
                values.append(float(cell.replace(",", ".")))
            except ValueError:
                issues.append(Issue(f"{where}, line {number}, value {position}", describe(cell), "a number"))
        matrix.append(values)
    if issues:
        raise InputError(issues[:100])
    return {"nodes": names, "matrix": matrix}
