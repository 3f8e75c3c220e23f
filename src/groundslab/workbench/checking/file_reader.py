"""Reading of files in child processes, as they come from others and may take any time and memory."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, ClassVar

from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name
from groundslab.workbench.checking.bounded_process import MEMORY, BoundedProcess, CallFailure, MemoryLimit, TimeLimit

#: What is expected of the name of a file.
ENDING = 'a name that ends with "{ending}"'


@dataclass(frozen=True, slots=True)
class FileKind:
    """A kind of file: what it is called, what to do with one that cannot be read, and what reading it takes."""

    words: str  # such as "a drawing"
    expected: str  # such as "a DXF drawing"
    if_large: str
    if_damaged: str
    libraries: tuple[str, ...]  # loaded before memory is limited
    seconds: float  # in which it must be read
    memory: int = MEMORY  # that reading may use [bytes]


class FileReader:
    """Reads one file at a time, each in a process of its own, which then ends."""

    kind: ClassVar[FileKind]

    def __init__(self, seconds: float | None = None, memory: int | None = None) -> None:
        self._seconds = self.kind.seconds if seconds is None else seconds
        self._memory = self.kind.memory if memory is None else memory
        self._lock = threading.Lock()

    def call(self, function: Callable[..., Any], path: str | Path, *arguments: Any) -> Any:
        """Return what a function makes of a file; raises InputError, whatever the file is."""
        with self._lock:
            process = BoundedProcess(partial(load_libraries, self.kind.libraries), self._memory)
            try:
                return process.call(function, path, *arguments, seconds=self._seconds)
            except CallFailure as error:
                issue = Issue(str(path), self._explain(error), "a sound and smaller one", self.kind.if_large)
                raise InputError([issue]) from None
            except InputError:
                raise
            except Exception as error:  # of any kind, as what is damaged may be anything
                damage = Message("a damaged file ({error})", error=Name(f"{type(error).__name__}: {error}"))
                raise InputError([Issue(str(path), damage, self.kind.expected, self.kind.if_damaged)]) from None
            finally:
                process.close()

    def _explain(self, error: CallFailure) -> str:
        """Return in words why a file could not be read."""
        if isinstance(error, TimeLimit):
            return Message("{file} that takes {time} to read", file=self.kind.words, time=str(error))
        if isinstance(error, MemoryLimit):
            return Message(
                "{file} that takes too much memory to read ({error})", file=self.kind.words, error=str(error)
            )
        return Message("{file} that cannot be read ({error})", file=self.kind.words, error=str(error))


def load_libraries(names: tuple[str, ...]) -> None:
    """Load what reading needs, as far as it is there; what is missing is an issue of the reading itself."""
    for name in names:
        with suppress(ImportError):
            import_module(name)
