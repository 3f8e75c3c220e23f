"""Whether the case has changed since it was solved, which a report on the results must say."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.messages import Message, Name
from groundslab.storage import bounded

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: What the first page says then.
CHANGED = (
    "{file} has changed since this analysis. Results, checks and text in this report are those of the case as it was "
    "solved; solve again for those of the case as it is now."
)


def text_of(folder: str | Path, model: Model) -> str | None:
    """Return the text of the case in a folder of results, as it is there, if it describes the model of the results."""
    return _text_of(Path(folder) / "case.toml", model)


def changes_since(folder: str | Path, model: Model) -> str:
    """Return the warning for a report where the case beside a folder of results describes another model.

    Beside a folder such as raft-results the case is raft.toml. A file that is not there says nothing.
    """
    whole = Path(folder)
    beside = whole.with_name(f"{whole.name.removesuffix('-results')}.toml")
    changed = beside.is_file() and _text_of(beside, model) is None
    return Message(CHANGED, file=Name(beside.name)) if changed else ""


def _text_of(path: Path, model: Model) -> str | None:
    """Return the text of a case file if it describes a model."""
    try:
        text = bounded.read_whole(path, casefile.LARGEST).decode()
        return text if casefile.from_table(casefile.tables(text), path.parent) == model else None
    except (OSError, UnicodeDecodeError, InputError):
        return None
