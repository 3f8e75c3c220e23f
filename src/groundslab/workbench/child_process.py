"""A child process, the pipe to it, and its end."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from multiprocessing import connection, parent_process
from multiprocessing.context import SpawnProcess
from typing import Any

from groundslab.messages import Message, Name

CONTEXT = multiprocessing.get_context("spawn")


class ChildProcess(SpawnProcess):
    """A process that calls a function with one end of a pipe and some arguments."""

    def __init__(self, name: str, target: Callable[..., None], *arguments: Any) -> None:
        pipe, child_pipe = CONTEXT.Pipe()
        super().__init__(target=target, args=(child_pipe, *arguments), name=name, daemon=True)
        self.start()
        child_pipe.close()  # so that the end of the process closes the pipe
        self.pipe = pipe  # only now, so that the process does not get it

    def kill(self) -> None:
        """Kill the process, unless it has ended already; may be called from any thread."""
        with suppress(ValueError):
            super().kill()

    def close(self) -> None:
        """Kill the process and free its resources."""
        self.kill()
        self.join()
        super().close()
        self.pipe.close()


def explain_error(error: Exception) -> Message:
    """Return in words that the program itself has failed."""
    return Message("an error in groundslab itself: {error}", error=Name(f"{type(error).__name__}: {error}"))


def set_up_child() -> None:
    """Prepare a child process: Ctrl-C is left to the server, whose end, for whatever reason, ends this process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """End this process as soon as its parent has ended."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        sys.stderr.flush()
        os._exit(1)
