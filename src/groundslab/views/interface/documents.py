"""Documents for other programs: the design of results, their tables, an error.

Two are elsewhere: the summary of results (``views.summary.json_summary``), and the check of a case or study file, which
needs no results (``study.check``). All have the same header with the version of the interface; docs/interface.md
explains them.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping
from math import isfinite
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.schema.wording import listed, quote, suggestion
from groundslab.views.summary.json_summary import design, header, refusal, to_json

if TYPE_CHECKING:
    from groundslab.results.results import Results
    from groundslab.views.tables.table import Cell, Table


def design_to_json(combined: Results) -> dict[str, Any]:
    """Return the design checks of results."""
    return header() | _about(combined) | {"design": design(combined)}


def tables_to_json(combined: Results, names: Collection[str] = ()) -> dict[str, Any]:
    """Return the tables of results with some names, all by default, in the units that the case asks for.

    Raises InputError for a name that no table of these results has.
    """
    from groundslab.views.tables.result_tables import table_makers

    makers = table_makers(combined)
    unknown = [name for name in dict.fromkeys(names) if name not in makers]
    if unknown:
        expected = f"one of {listed(list(makers))}"
        raise InputError([Issue("tables", quote(name), expected, suggestion(name, list(makers))) for name in unknown])
    tables = [_table(make()) for name, make in makers.items() if not names or name in names]
    return header() | _about(combined) | {"units": combined.model.units, "tables": tables}


def error_to_json(error: Exception) -> dict[str, Any]:
    """Return why there is no other document: kind and message, issues of an input, the history of an iteration."""
    about: dict[str, Any] = {"kind": type(error).__name__, "message": str(error) or "not enough memory", "issues": []}
    if isinstance(error, InputError):
        about["issues"] = issues_to_json(error)
    elif isinstance(error, GroundslabError):
        about |= {key: value for key, value in refusal(error).items() if key in ("what", "history")}
    return header() | {"error": about}


def to_text(document: Mapping[str, Any]) -> str:
    """Return a document as text."""
    # numbers of NumPy look like Python's; JSON knows the latter only
    return json.dumps(document, indent=2, allow_nan=False, default=lambda number: number.item())


#: Documents about results by their names.
DOCUMENTS: dict[str, Callable[[Results], dict[str, Any]]] = {
    "summary": to_json, "design": design_to_json, "tables": tables_to_json,
}  # fmt: skip


def _about(combined: Results) -> dict[str, Any]:
    """Return which results they are, and whether they may be used."""
    return {
        "title": combined.model.title,
        "certified": not combined.refused,
        "provisional": combined.provisional,
    }


def issues_to_json(error: InputError) -> list[dict[str, str]]:
    """Return the issues of an input."""
    return [
        {"location": issue.location, "found": issue.found, "expected": issue.expected, "hint": issue.hint}
        for issue in error.issues
    ]


def _table(table: Table) -> dict[str, Any]:
    """Return a table column by column."""
    columns = [
        {
            "name": column.name,
            "unit": column.unit,
            "error_of": column.error_of,
            "values": [_cell(value) for value in column.values],
        }
        for column in table.columns
    ]
    return {"name": table.name, "title": table.title, "columns": columns, "notes": list(table.notes)}


def _cell(value: Cell) -> Cell:
    """Return a cell; JSON knows no infinite number, which becomes a word."""
    return str(value) if isinstance(value, float) and not isfinite(value) else value
