"""Reading of SAF files in child processes, as they come from others and may take any time and memory."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.workbench.checking.bounded_process import MEMORY, BoundedProcess, CallFailure

#: Time in which a file must be read [s].
READ_LIMIT = 60.0


@dataclass(frozen=True, slots=True)
class ConvertedSlab:
    """The text of a case made from a slab of a file, and the report of what was taken and what was left."""

    text: str
    report: str


class SafReader:
    """Reads one file at a time, each in a process of its own, which then ends."""

    def __init__(self, seconds: float = READ_LIMIT, memory: int = MEMORY) -> None:
        self._seconds, self._memory = seconds, memory
        self._lock = threading.Lock()

    def survey(self, path: Path) -> list[dict[str, Any]]:
        """Return the slabs of a file as data for the page, none if it is another workbook; raises InputError."""
        slabs: list[dict[str, Any]] = self._call(survey_slabs, path)
        return slabs

    def convert(self, path: Path, slab: str) -> ConvertedSlab:
        """Return the case that a slab of a file is; raises InputError."""
        made: ConvertedSlab = self._call(convert_slab, path, slab)
        return made

    def _call(self, function: Callable[..., Any], path: Path, *arguments: Any) -> Any:
        with self._lock:
            caller = BoundedProcess(load_libraries, self._memory)
            try:
                return caller.call(function, path, *arguments, seconds=self._seconds)
            except CallFailure as error:
                found, hint = f"a workbook that cannot be read ({error})", "save only the part that is needed"
                raise InputError([Issue(str(path), found, "a smaller one", hint)]) from None
            finally:
                caller.close()


def load_libraries() -> None:
    """Load what reading needs, before memory is limited."""
    for name in ("shapely", "openpyxl"):
        with suppress(ImportError):  # an issue of the reading itself
            import_module(name)


def survey_slabs(path: Path) -> list[dict[str, Any]]:
    """Return the slabs of a file as data for the page."""
    from groundslab.case.saf import list_slabs

    return [asdict(slab) for slab in list_slabs(path)]


def convert_slab(path: Path, slab: str) -> ConvertedSlab:
    """Return the case that a slab of a file is."""
    from groundslab.case.saf import read_saf

    read = read_saf(path, slab)
    return ConvertedSlab(read.text, read.report_text())
