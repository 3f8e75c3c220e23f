"""The summary as JSON: summary.json, and what ``groundslab solve --json`` prints.

Every number with a dimension is an object {"value", "unit"} in SI units, with "place" = [x, y] in meters where it is an
extreme ("singular": true if it is a mean around it), and "combination" where it is one over several; counts, ratios and
words stand for themselves. Lists over layers run downwards.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, is_dataclass
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab._version import __version__
from groundslab.errors import NotConverged
from groundslab.messages import as_values
from groundslab.units import UNITS, Unit
from groundslab.views.summary import combinations, sections
from groundslab.views.summary.environment import environment

if TYPE_CHECKING:
    from groundslab.design.checks import DesignCheck
    from groundslab.errors import GroundslabError
    from groundslab.model.remarks.case_use import CaseUse
    from groundslab.results.results import CombinationResult, Results
    from groundslab.views.summary.combinations import Entry, Extreme
    from groundslab.views.summary.rows import Row, SummarySection

#: The version of the interface, of all documents in ``views.interface``; it grows when a key changes name or meaning.
FORMAT = 2


def header() -> dict[str, Any]:
    """Return what every document begins with."""
    return {"program": "groundslab", "version": __version__, "format": FORMAT}


def to_json(combined: Results, folders: Mapping[str, str] | None = None, files: Sequence[str] = ()) -> dict[str, Any]:
    """Return the summary as data for JSON, with the names of the files that stand beside it.

    `folders` are those of the combinations by name. The results of an only combination stand at the top.
    """
    from groundslab.model.remarks.case_use import case_uses
    from groundslab.model.remarks.remarks import find_remarks

    entries = combinations.entries(combined)
    combinations.require_finite(combined)
    document: dict[str, Any] = header() | {
        "environment": environment(combined.model),
        "title": combined.model.title,
        "certified": not combined.refused,
        "provisional": combined.provisional,
        "design": design(combined),
        "cases": [case_to_json(use) for use in case_uses(combined.model, combined.combinations)],
        "remarks": [remark.words for remark in find_remarks(combined.model, combined.combinations)],
    }
    only = combinations.only(entries)
    document |= _several(combined, entries, folders or {}) if only is None else _only(only)
    document["files"] = list(files)
    return document


def json_text(
    combined: Results, folders: Mapping[str, str] | None = None, files: Sequence[str] = (), indent: int | None = 2
) -> str:
    """Return the summary as the text of a JSON file; without an indent it is one line, and made much faster."""
    # numbers of NumPy look like Python's; JSON knows the latter only
    document = to_json(combined, folders, files)
    return json.dumps(document, indent=indent, allow_nan=False, default=lambda number: number.item())


def case_to_json(use: CaseUse) -> dict[str, Any]:
    """Return a load case as data for JSON: its loads, and by limit state its factors and in how many combinations."""
    acting = {factors.limit_state: asdict(factors) for factors in use.acting}
    for about in acting.values():
        del about["limit_state"]
    return {"name": use.case.name, "action": use.case.action, "loads": use.loads, "acting": acting}


def design(combined: Results) -> dict[str, Any]:
    """Return the design checks as data for JSON."""
    from groundslab.design.checks import check_design

    judged = check_design(combined)
    checks = [_check(check) for check in judged.checks]
    return {"status": judged.status, "headline": judged.headline, "checks": checks}


def _check(check: DesignCheck) -> dict[str, Any]:
    """Return a check as data for JSON, which knows no infinite utilization: nothing resists there."""
    numbers = (check.utilization, *(check.between or ()))
    used, *between = (number if number is not None and isfinite(number) else None for number in numbers)
    judged = {"utilization": used, "between": between or None, "verdict": check.verdict}
    return asdict(check) | judged | {"message": as_values(check.words)}


def _only(results: CombinationResult) -> dict[str, Any]:
    """Return the results of an only combination."""
    document = {"combination": results.combination, "limit_state": results.limit_state}
    return document | _sections(sections.summary(results)) | _analysis(results)


def _several(combined: Results, entries: Sequence[Entry], folders: Mapping[str, str]) -> dict[str, Any]:
    """Return the description of all combinations, the extremes over them, and each by itself."""
    document: dict[str, Any] = {}
    if any(entry.results is not None for entry in entries):
        document |= _sections(combinations.description(combined))
    names = {entry.number: entry.combination.name for entry in entries}
    document["extremes"] = {
        section.key: {extreme.row.key: _named(extreme, names) for extreme in rows}
        | ({"notes": list(section.notes)} if section.notes else {})
        for section, rows in combinations.extremes(combined)
    }
    document["certificate"] = {extreme.row.key: _named(extreme, names) for extreme in combinations.worst(combined)}
    document["combinations"] = [_combination(entry, folders.get(entry.combination.name)) for entry in entries]
    return document


def _sections(sections: Sequence[SummarySection]) -> dict[str, Any]:
    """Return sections of the summary as data for JSON, by their keys."""
    document: dict[str, Any] = {}
    for section in sections:
        document[section.key] = {row.key: _row(row) for row in section.rows}
        # a number without unit stands for itself, and so does its error
        plain = [row for row in section.rows if row.error is not None and not isinstance(_row(row), dict)]
        document[section.key] |= {f"{row.key}_error": row.error for row in plain}
        if section.notes:
            document[section.key]["notes"] = list(section.notes)
    return document


def _analysis(results: CombinationResult) -> dict[str, Any]:
    """Return the constants that an analysis ended with, its steps and the meshes that were made as data for JSON."""
    constants = asdict(results.constants)
    for name, unit in (("k0", "MPa/m"), ("k1", "MPa m")):
        constants[name] = [_quantity(value, UNITS[unit]) for value in constants[name]]
    history = None if results.mesh_history is None else asdict(results.mesh_history)
    if history is not None:
        del history["before"]
    return {"constants": constants, "history": [asdict(step) for step in results.steps], "mesh_history": history}


def _named(extreme: Extreme, names: dict[int, str]) -> dict[str, Any]:
    """Return an extreme as data for JSON, with the name of its combination."""
    value, error = _row(extreme.row), extreme.row.error
    plain = {"value": value} | ({} if error is None else {"error": error})
    return (value if isinstance(value, dict) else plain) | {"combination": names[extreme.number]}


def _combination(entry: Entry, folder: str | None) -> dict[str, Any]:
    """Return one combination as data for JSON: its results, or why it has none."""
    document: dict[str, Any] = {
        "name": entry.combination.name,
        "limit_state": entry.combination.limit_state,
        "factors": dict(entry.combination.factors),
        "certified": entry.refused is None,
    }
    if entry.refused is not None:
        document["refused"] = refusal(entry.refused)
    if entry.results is not None:
        if folder is not None:
            document["folder"] = folder
        parts = [*sections.figures(entry.results), sections.certificate_section(entry.results)]
        document |= _sections(parts) | _analysis(entry.results)
    return document


def refusal(error: GroundslabError) -> dict[str, Any]:
    """Return as data for JSON why a combination has no certified result."""
    document: dict[str, Any] = {"error": type(error).__name__, "reason": str(error)}
    if isinstance(error, NotConverged):
        document |= {"what": error.what, "history": [_plain(step) for step in error.history]}
    return document


def _plain(value: Any) -> Any:
    """Return an entry of a history as data for JSON; numbers that JSON cannot hold become words."""
    if is_dataclass(value) and not isinstance(value, type):
        value = asdict(value)
    if isinstance(value, Mapping):
        return {str(name): _plain(entry) for name, entry in value.items()}
    if isinstance(value, np.generic):
        value = value.item()
    return str(value) if isinstance(value, float) and not isfinite(value) else value


def _quantity(value: float, unit: Unit) -> dict[str, Any]:
    """Return a number with a dimension as JSON data."""
    return {"value": value, "unit": unit.si}


def _row(row: Row) -> Any:
    """Return the value of a row as JSON data."""
    if row.tolerance is not None:
        place = {} if row.place is None else {"place": list(row.place)}
        return {"value": row.value, "tolerance": row.tolerance, "ok": bool(row.ok)} | place
    if row.unit is None or row.unit.si == "1":
        return row.value
    assert isinstance(row.value, (int, float))
    place = {} if row.place is None else {"place": list(row.place)}
    error = {} if row.error is None else {"error": row.error}
    singular = {"singular": True} if row.singular else {}
    return _quantity(row.value, row.unit) | error | place | singular
