"""The document in its versions, with what is found in each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.model.loads.annexes import factors_of, psi_of
from groundslab.model.loads.load_cases import PSI, Combine, LoadCase
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.editing.document import Document

if TYPE_CHECKING:
    from groundslab.workbench.events import Event


def usual_factors(data: Mapping[str, Any] | None) -> dict[str, Any]:
    """Return factors of actions where a case gives none, by its annex: partial ones, psi by category and of others."""
    parts: tuple[Any, ...] = tuple({} if data is None else data.get(name) for name in ("combine", "reinforcement"))
    named = [part["annex"] for part in parts if isinstance(part, Mapping) and isinstance(part.get("annex"), str)]
    annex = named[0] if named else "recommended"
    factors = factors_of(annex)
    return {
        **{key: factors.get(key, Combine.model_fields[key].default) for key in ("permanent", "variable")},
        "psi": {
            **PSI, **psi_of(annex), "variable": [LoadCase.model_fields[f"psi_{n}"].default for n in range(3)],
        },
    }  # fmt: skip


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
            "factors": usual_factors(self.readable),
        }
