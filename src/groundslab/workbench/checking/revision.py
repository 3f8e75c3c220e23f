"""The document in its versions, with what is found in each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.model.loads.load_cases import PSI, Combine, LoadCase
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.editing.document import Document

if TYPE_CHECKING:
    from groundslab.workbench.events import Event


#: Factors of actions where a case gives none: partial ones, and psi by category and of other variable actions.
FACTORS: Mapping[str, Any] = {
    "permanent": Combine.model_fields["permanent"].default,
    "variable": Combine.model_fields["variable"].default,
    "psi": {**PSI, "variable": [LoadCase.model_fields[f"psi_{n}"].default for n in range(3)]},
}


@dataclass(frozen=True, slots=True)
class Revision:
    """A version of the document, and what has been found in it so far."""

    version: int
    document: Document
    folder: Path | None = None  # of its file, beside which others may be that it names
    data: dict[str, Any] | None = None
    result: CheckResult | None = None  # None while it is being checked
    earlier_data: dict[str, Any] | None = None  # of the last text that could be read
    earlier_plan: dict[str, Any] | None = None

    @property
    def readable(self) -> dict[str, Any] | None:
        """The data, those of the last text that could be read while this one is not or cannot be."""
        return self.earlier_data if self.data is None else self.data

    @property
    def plan(self) -> dict[str, Any] | None:
        """The plan, the previous one while the document is being checked and where it cannot be read."""
        return self.earlier_plan if self.result is None or self.data is None else self.result.plan

    @property
    def text(self) -> str:
        """Return the text that describes its model by itself."""
        return self.document.text if self.result is None else self.result.text or self.document.text

    @property
    def event(self) -> Event:
        """The event that announces it."""
        return "state", {"version": self.version}

    def to_json(self) -> dict[str, Any]:
        """Return the revision as data for the page."""
        return {
            "version": self.version,
            "text": self.document.text,
            "data": self.data,
            "readable": self.earlier_data if self.data is None else None,
            "checking": self.result is None,
            "issues": [] if self.result is None else self.result.issues_json,
            "remarks": [] if self.result is None else self.result.remarks_json,
            "plan": self.plan,
            "cases": None if self.result is None else self.result.cases,
            "factors": FACTORS,
        }
