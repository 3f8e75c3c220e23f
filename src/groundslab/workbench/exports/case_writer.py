"""Writing of cases without results for other programs, in child processes."""

from __future__ import annotations

import tempfile
import threading
from functools import partial
from pathlib import Path

from groundslab.errors import InputError, Issue
from groundslab.messages import Message
from groundslab.workbench.checking.bounded_process import BoundedProcess, CallFailure
from groundslab.workbench.checking.file_reader import load_libraries
from groundslab.workbench.exports.files import SAF, Exported, limit_notes

#: Time in which a case must be written [s].
SECONDS = 60.0
NO_RESULTS = "results: none, as the case has not been solved as it is now"


class CaseWriter:
    """Writes one case at a time, each in a process of its own, which then ends."""

    def __init__(self, seconds: float = SECONDS) -> None:
        self._seconds = seconds
        self._lock = threading.Lock()

    def write_saf(self, text: str) -> Exported:
        """Return the case of a text in the Structural Analysis Format; raises InputError."""
        with self._lock:
            process = BoundedProcess(partial(load_libraries, ("shapely", "openpyxl")))
            try:
                exported: Exported = process.call(write_saf, text, seconds=self._seconds)
                return exported
            except CallFailure as error:
                failure = Message("a case that cannot be written ({error})", error=str(error))
                raise InputError([Issue("the SAF file", failure, "a smaller case")]) from None
            finally:
                process.close()


def write_saf(text: str) -> Exported:
    """Return the case of a text in the Structural Analysis Format."""
    from groundslab.case import casefile
    from groundslab.views.files import saf

    with tempfile.TemporaryDirectory(prefix="groundslab-") as folder:
        path = Path(folder) / SAF
        notes = saf.write_saf(casefile.loads(text), path)
        return limit_notes(path.read_bytes(), [NO_RESULTS, *notes])
