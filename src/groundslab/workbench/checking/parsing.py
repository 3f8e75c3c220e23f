"""What a case file's text means: its data, what is wrong with it, the plan to draw.

All of this may take long, so it is called in a process of its own, by ``reader``; that process keeps the latest
documents, so that they are not parsed again for each question.
"""

from __future__ import annotations

import hashlib
import math
import traceback
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.editing.document import Document, Edit


@dataclass(frozen=True, slots=True)
class Reading:
    """What a text means.

    meaning is the same for texts that describe the same model, and empty for one that describes none; issues are the
    faults as the page shows them, with paths and lines.
    """

    meaning: str
    issues: tuple[Issue, ...]
    listed: list[dict[str, Any]]
    plan: dict[str, Any] | None


def prepare() -> None:
    """Load what reading needs."""
    understand(Document(casefile.starter()))


def parse(document: Document) -> dict[str, Any] | None:
    """Return the data of a text, None if it is not TOML."""
    data = _latest(document).data
    try:
        return None if data is None else plain(data)
    except RecursionError:
        return None  # what is nested so deeply cannot be edited but as text


def understand(document: Document) -> Reading:
    """Return what a text means; an error of ours is a fault too, so that the text can still be edited and saved."""
    document = _latest(document)
    try:
        from groundslab.views.scene.plan import plan_of

        data = document.data
        model = casefile.loads(document.text, diagnostics.NAME) if data is None else casefile.from_table(data)
        meaning = hashlib.sha256(casefile.to_toml(model).encode()).hexdigest()
        return Reading(meaning, (), [], plan_of(model))
    except InputError as error:
        found = error.issues
    except MemoryError:
        raise
    except Exception as error:
        traceback.print_exc()
        given = f"an error in groundslab itself ({type(error).__name__}: {error})"
        found = (Issue("the description", given, "something that it can read", "undo the last step"),)
    return Reading("", found, diagnostics.text_issues_to_json(found, document.layout, document.data is not None), None)


def edited(document: Document, edits: Sequence[Edit]) -> Document:
    """Return the document after some edits; raises InputError if one of them cannot be."""
    return replace(_latest(document).edited(edits))  # without the data that it remembers


@lru_cache(maxsize=2)
def _latest(document: Document) -> Document:
    """Return an equal document that remembers its data and layout."""
    return document


def plain(data: Any) -> Any:
    """Return the data of a file as JSON can hold it: dates and numbers that are none become texts."""
    if isinstance(data, Mapping):
        return {name: plain(each) for name, each in data.items()}
    if isinstance(data, list):
        return [plain(each) for each in data]
    if isinstance(data, float) and not math.isfinite(data):
        return str(data)
    return data if data is None or isinstance(data, str | bool | int | float) else str(data)
