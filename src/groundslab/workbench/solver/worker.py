"""The process that solves, seen from the server."""

from __future__ import annotations

import signal
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

from groundslab.messages import Message
from groundslab.workbench.child_process import CONTEXT, ChildProcess
from groundslab.workbench.solver import process


class Worker:
    """A process that solves, from its start to its end."""

    def __init__(self, task: process.Task, prepare: process.Prepare | None) -> None:
        self._stop = CONTEXT.RawValue("q", 0)  # runs up to this number are to be stopped
        self._child = ChildProcess("groundslab solver", process.main, self._stop, task, prepare)
        self.pipe, self.sentinel = self._child.pipe, self._child.sentinel
        self.is_ready = False
        self.has_started = False

    def send(self, messages: Iterable[tuple[Any, ...]]) -> None:
        """Send messages; of a process that has just ended, the event loop will notice."""
        with suppress(OSError):
            for message in messages:
                self.pipe.send(message)

    def receive(self) -> tuple[str, list[Any], bytes] | None:
        """Return the kind of a message, what it says, and the bytes that follow it; None at the process's end."""
        try:
            kind, *rest = self.pipe.recv()
            has_content = kind in ("preview", "provisional", "solved") or (kind == "view" and not rest[1])
            return kind, rest, self.pipe.recv_bytes() if has_content else b""
        except (EOFError, OSError):
            return None

    def stop(self, run: int) -> None:
        """Have a run stopped between two steps of the analysis."""
        self._stop.value = run

    def kill(self) -> None:
        """Kill the process."""
        self._child.close()

    def wait_for_end(self) -> str:
        """Return how the process ended, in words."""
        self._child.join()
        code = self._child.exitcode
        if code is None or code >= 0:
            return Message("exit code {code}", code=str(code))
        with suppress(ValueError):
            name = signal.Signals(-code).name
            return Message("{name}, perhaps because the memory was used up", name=name) if name == "SIGKILL" else name
        return Message("signal {number}", number=-code)
