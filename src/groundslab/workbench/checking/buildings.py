"""Reading of building models in child processes, as they come from others and may take any time and memory."""

from __future__ import annotations

import threading
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Literal

from groundslab.case.ifc import IfcCase, read_ifc
from groundslab.errors import InputError, Issue
from groundslab.workbench.checking.bounded_process import BoundedProcess, CallFailure, MemoryLimit, TimeLimit

#: Time in which a building must be read [s], and memory that reading may use [bytes].
READ_LIMIT, MEMORY = 120.0, 4_000_000_000


class BuildingReader:
    """Reads one building at a time, each in a process of its own, which then ends."""

    def __init__(self, seconds: float = READ_LIMIT, memory: int = MEMORY) -> None:
        self._seconds, self._memory = seconds, memory
        self._lock = threading.Lock()

    def convert(self, path: str | Path, slab: str, origin: Literal["own", "center"], align: bool = False) -> IfcCase:
        """Return the case of a slab of a building; raises InputError."""
        with self._lock:
            caller = BoundedProcess(load_libraries, self._memory)
            try:
                case: IfcCase = caller.call(read_ifc, str(path), slab, origin, align, seconds=self._seconds)
                return case
            except CallFailure as error:
                raise InputError([_explain_failure(path, error)]) from None
            except InputError:
                raise
            except Exception as error:  # of any kind, as what is damaged may be anything
                hint = "export it again from the building's program"
                found = f"a damaged IFC file ({type(error).__name__}: {error})"
                raise InputError([Issue(str(path), found, "an IFC 4 file", hint)]) from None
            finally:
                caller.close()


def _explain_failure(path: str | Path, error: CallFailure) -> Issue:
    """Return the issue with a building that could not be read."""
    found = "a file that ended the program that reads it: it is damaged, or takes too much memory to read"
    if isinstance(error, TimeLimit):
        found = f"a building that takes {error} to read"
    elif isinstance(error, MemoryLimit):
        found = f"a building that takes too much memory to read ({error})"
    return Issue(str(path), found, "a sound and smaller one", "export the storey of the slab alone")


def load_libraries() -> None:
    """Load what reading needs, before memory is limited."""
    for name in ("shapely", "ifcopenshell", "ifcopenshell.geom"):
        with suppress(ImportError):  # an issue of the reading itself
            import_module(name)
