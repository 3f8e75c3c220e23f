"""Parsing and checking of a case file's text: its data, its issues, the plan to draw.

These functions may take long, so ``Checker`` calls them in a child process, which caches the latest documents.
"""

from __future__ import annotations

import hashlib
import json
import traceback
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.case.building_file import with_matrix
from groundslab.errors import InputError, Issue
from groundslab.workbench.child_process import explain_error
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.editing.document import Document, Edit


@dataclass(frozen=True, slots=True)
class CheckResult:
    """The result of checking a text.

    The fingerprint is the same for texts that describe the same model, and empty for one that describes none;
    ``issues_json`` and ``remarks_json`` hold the issues, and the remarks on a case without any, as the page shows them,
    with paths and lines. ``text`` describes the model by itself, with what another file holds, empty if none does.
    ``cases`` has the sums of load cases and the combinations that are made of a case without issues.
    """

    fingerprint: str
    issues: tuple[Issue, ...]
    issues_json: list[dict[str, Any]]
    plan: dict[str, Any] | None
    remarks_json: list[dict[str, Any]] = field(default_factory=list)
    text: str = ""
    cases: dict[str, Any] | None = None


def warm_up() -> None:
    """Load the libraries that are needed."""
    check(Document(casefile.starter()))


def parse(document: Document) -> dict[str, Any] | None:
    """Return the data of a text, None if it is not TOML."""
    data = _cache(document).data
    try:
        return None if data is None else to_json_data(data)
    except RecursionError:
        return None  # such deep nesting can only be edited as text


def check(document: Document, folder: Path | None = None) -> CheckResult:
    """Check the text of a file in a folder.

    An error of the program becomes an issue, so that the text can still be edited and saved.
    """
    document = _cache(document)
    try:
        from groundslab.model.combinations import list_combinations
        from groundslab.model.remarks.remarks import find_remarks
        from groundslab.views.scene.plan import plan_of
        from groundslab.workbench.checking.cases import cases_to_json

        data = document.data
        model = casefile.loads(document.text, diagnostics.NAME) if data is None else casefile.from_table(data, folder)
        fingerprint = hashlib.sha256(casefile.to_toml(model).encode()).hexdigest()
        combinations = list_combinations(model)
        remarks = diagnostics.remarks_to_json(find_remarks(model, combinations), document.layout)
        cases = cases_to_json(model, combinations)
        return CheckResult(fingerprint, (), [], plan_of(model), remarks, _by_itself(document, folder), cases)
    except InputError as error:
        issues = error.issues
    except MemoryError:
        raise
    except Exception as error:
        traceback.print_exc()
        failure = explain_error(error)
        issues = (Issue("the description", failure, "a description that it can read", "undo the last step"),)
    issues_json = diagnostics.text_issues_to_json(issues, document.layout, document.data is not None)
    return CheckResult("", issues, issues_json, None)


def _by_itself(document: Document, folder: Path | None) -> str:
    """Return the text with the matrix of the building from the file that it names, empty if it names none."""
    if folder is None or document.data is None or "file" not in document.data.get("building", {}):
        return ""
    building = with_matrix(document.data, folder)["building"]
    edits: list[Edit] = [{"op": "remove", "path": ["building", "file"]}]
    edits += [{"op": "set", "path": ["building", key], "value": building[key]} for key in ("nodes", "matrix")]
    return document.apply(edits).text


def apply_edits(document: Document, edits: Sequence[Edit]) -> Document:
    """Return the document after some edits; raises InputError if one of them is invalid."""
    return replace(_cache(document).apply(edits))  # without cached properties


@lru_cache(maxsize=2)
def _cache(document: Document) -> Document:
    """Return an equal document whose data and layout may be cached."""
    return document


def to_json_data(data: Any) -> Any:
    """Return the data of a file as JSON supports it: dates and numbers that are not finite become texts."""
    return json.loads(json.dumps(data, default=str), parse_constant=lambda name: str(float(name)))
