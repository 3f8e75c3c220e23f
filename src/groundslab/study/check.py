"""The check of a case or study file as a document for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.views.interface.documents import issues_to_json
from groundslab.views.summary.json_summary import case_to_json, header

if TYPE_CHECKING:
    from groundslab.model.model import Model
    from groundslab.model.remarks.resultants import Resultant


def check_file(path: Path, name: str) -> dict[str, Any]:
    """Return the check of a case file, or of a study file with its case, which the document calls by a name."""
    try:
        tables = casefile.tables(casefile.read(path), name)
        if "sampling" in tables:
            from groundslab.study import describe_file

            return _begin(name, "fine") | {"kind": "study", "description": describe_file(path)}
        return check_case(casefile.from_table(tables, path.parent), name)
    except InputError as error:
        return refuse_file(error, name)


def check_case(model: Model, case: str) -> dict[str, Any]:
    """Check a model without solving it and return what was found; raises InputError as `groundslab.check` does."""
    from groundslab.analysis.check import check, find_unbalanced
    from groundslab.model.combinations import list_combinations
    from groundslab.model.remarks.case_use import case_uses
    from groundslab.model.remarks.remarks import find_remarks
    from groundslab.model.remarks.resultants import case_sums

    check(model)
    sums = {name: _sum_to_json(total) for name, total in case_sums(model).items()}
    lost = find_unbalanced(model)
    combinations = list_combinations(model)
    return _begin(case, "no equilibrium" if lost else "fine") | {
        "kind": "case",
        "title": model.title,
        "ground": model.ground.kind,
        "plates": len(model.every_plate),
        "loads": len(model.loads),
        "cases": [case_to_json(use) | {"sum": sums[use.case.name]} for use in case_uses(model, combinations)],
        "combinations": [
            {"name": combination.name, "limit_state": combination.limit_state, "factors": dict(combination.factors)}
            for combination in combinations
        ],
        "without_equilibrium": {name: str(error) for name, error in lost.items()},
        "remarks": [remark.words for remark in find_remarks(model, combinations)],
    }


def _sum_to_json(total: Resultant) -> dict[str, Any]:
    units = {"F": "N", "M_x": "N m", "M_y": "N m"}
    return {key: {"value": getattr(total, key), "unit": unit} for key, unit in units.items()}


def refuse_file(error: InputError, name: str) -> dict[str, Any]:
    """Return the check of a file that describes no case or study, with all its issues."""
    return _begin(name, "wrong input") | {"issues": issues_to_json(error)}


def _begin(file: str, status: str) -> dict[str, Any]:
    return header() | {"file": file, "status": status, "issues": []}
