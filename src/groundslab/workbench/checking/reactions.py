"""Reading of tables of reactions in child processes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from groundslab.exchange.reactions import Choices, import_into
from groundslab.workbench.checking.file_reader import FileKind, FileReader

#: Changes that the page lists.
LISTED = 500


@dataclass(frozen=True, slots=True)
class ReactionPreview:
    """The text of the case with the loads of a table; changes, sums by case and remarks in words, a line each."""

    text: str
    changes: tuple[str, ...]
    sums: tuple[str, ...]
    remarks: tuple[str, ...]


class ReactionReader(FileReader):
    """Reads one table at a time, each in a process of its own, which then ends."""

    kind = FileKind(
        "a table", "a table of reactions (CSV or XLSX)", "save only the cases that are needed", "save it again",
        ("shapely", "openpyxl"), 60.0,
    )  # fmt: skip

    def read(self, path: Path, text: str, folder: Path | None, choices: Choices) -> ReactionPreview:
        """Return what a table changes in the case of a text, whose folder may be known; raises InputError."""
        preview: ReactionPreview = self.call(preview_reactions, path, text, folder, choices)
        return preview


def preview_reactions(path: Path, text: str, folder: Path | None, choices: Choices) -> ReactionPreview:
    """Return what a table changes in a case."""
    imported = import_into(text, folder, path, choices)
    changes = [str(change) for change in imported.changes]
    if len(changes) > LISTED:
        changes[LISTED:] = [f"{len(changes) - LISTED} more"]
    return ReactionPreview(imported.text, tuple(changes), tuple(map(str, imported.sums)), imported.remarks)
