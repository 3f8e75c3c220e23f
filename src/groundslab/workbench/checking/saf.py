"""Reading of SAF files in child processes."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from groundslab.workbench.checking.file_reader import FileKind, FileReader


@dataclass(frozen=True, slots=True)
class ConvertedSlab:
    """The text of a case made from a slab of a file, and the report of what was taken and what was left."""

    text: str
    report: str


class SafReader(FileReader):
    """Reads one file at a time, each in a process of its own, which then ends."""

    kind = FileKind(
        "a workbook", "a SAF file (XLSX)", "save only the part that is needed", "export it again",
        ("shapely", "openpyxl"), 60.0,
    )  # fmt: skip

    def survey(self, path: Path) -> list[dict[str, Any]]:
        """Return the slabs of a file as data for the page, none if it is another workbook; raises InputError."""
        slabs: list[dict[str, Any]] = self.call(survey_slabs, path)
        return slabs

    def convert(self, path: Path, slab: str) -> ConvertedSlab:
        """Return the case that a slab of a file is; raises InputError."""
        converted: ConvertedSlab = self.call(convert_slab, path, slab)
        return converted


def survey_slabs(path: Path) -> list[dict[str, Any]]:
    """Return the slabs of a file as data for the page."""
    from groundslab.exchange.saf import list_slabs

    return [{"id": slab.name, **asdict(slab)} for slab in list_slabs(path)]


def convert_slab(path: Path, slab: str) -> ConvertedSlab:
    """Return the case that a slab of a file is."""
    from groundslab.exchange.saf import read_saf

    read = read_saf(path, slab)
    return ConvertedSlab(read.text, read.report_text())
