"""Documents for other programs: the check of a case, the design of results, their tables, an error.

The summary of results is the fifth (``views.summary.json_summary``). All have the same header with the version of the
interface; docs/interface.md explains them.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.schema.wording import listed, quote, suggestion
from groundslab.views.summary.json_summary import case_to_json, design, header, refusal, to_json

if TYPE_CHECKING:
    from groundslab.design.tables.table import Cell, Table
    from groundslab.model.model import Model
    from groundslab.results.results import Results


def check_case(model: Model, case: str) -> dict[str, Any]:
    """Check a model without solving it and return what was found; raises InputError as `analysis.check.check` does."""
    from groundslab.analysis.check import check, find_unbalanced
    from groundslab.model.combinations import list_combinations
    from groundslab.model.remarks.case_use import case_uses
    from groundslab.model.remarks.remarks import find_remarks

    check(model)
    lost = find_unbalanced(model)
    combinations = list_combinations(model)
    return _check(case, "no equilibrium" if lost else "fine") | {
        "kind": "case",
        "title": model.title,
        "ground": model.ground.kind,
        "plates": len(model.every_plate),
        "loads": len(model.loads),
        "cases": [case_to_json(use) for use in case_uses(model, combinations)],
        "combinations": [
            {"name": each.name, "limit_state": each.limit_state, "factors": dict(each.factors)} for each in combinations
        ],
        "without_equilibrium": {name: str(error) for name, error in lost.items()},
        "remarks": [remark.words for remark in find_remarks(model, combinations)],
    }


def check_study(lines: Sequence[str], study: str) -> dict[str, Any]:
    """Return the check of a study file in which nothing is wrong, described by some lines."""
    return _check(study, "fine") | {"kind": "study", "description": list(lines)}


def refuse_case(error: InputError, case: str) -> dict[str, Any]:
    """Return the check of a file that describes no case, with all its issues."""
    return _check(case, "wrong input") | {"issues": _issues(error)}


def design_to_json(combined: Results) -> dict[str, Any]:
    """Return the design checks of results."""
    return header() | _about(combined) | {"design": design(combined)}


def tables_to_json(combined: Results, names: Collection[str] = ()) -> dict[str, Any]:
    """Return the tables of results with some names, all by default, in the units that the case asks for.

    Raises InputError for a name that no table of these results has.
    """
    from groundslab.design.result_tables import table_makers

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
        about["issues"] = _issues(error)
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


def _check(file: str, status: str) -> dict[str, Any]:
    return header() | {"file": file, "status": status, "issues": []}


def _about(combined: Results) -> dict[str, Any]:
    """Return which results they are, and whether they may be used."""
    return {
        "title": combined.model.title,
        "certified": not combined.refused,
        "provisional": combined.provisional,
    }


def _issues(error: InputError) -> list[dict[str, str]]:
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
