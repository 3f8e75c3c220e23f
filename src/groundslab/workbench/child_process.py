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
from typing import Any

CONTEXT = multiprocessing.get_context("spawn")


class ChildProcess:
    """A process that calls a function with one end of a pipe and some arguments."""

    def __init__(self, name: str, target: Callable[..., None], *arguments: Any) -> None:
        self.pipe, child_pipe = CONTEXT.Pipe()
        self._process = CONTEXT.Process(target=target, args=(child_pipe, *arguments), name=name, daemon=True)
        self._process.start()
        child_pipe.close()  # so that the end of the process closes the pipe
        self.sentinel = self._process.sentinel

    def is_alive(self) -> bool:
        """Whether the process is running."""
        return self._process.is_alive()

    def wait(self) -> int | None:
        """Wait for the end of the process and return its exit code."""
        self._process.join()
        return self._process.exitcode

    def kill(self) -> None:
        """Kill the process, unless it has ended already; may be called from any thread."""
        with suppress(ValueError):
            self._process.kill()

    def close(self) -> None:
        """Kill the process and free its resources."""
        self._process.kill()
        self._process.join()
        self._process.close()
        self.pipe.close()


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
