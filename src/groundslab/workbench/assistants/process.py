"""Runs a task in a child process, which ends with the call that wants it."""

from __future__ import annotations

import os
import sys
import time
import traceback
from collections.abc import Awaitable, Callable
from multiprocessing.connection import Connection
from typing import Any

from anyio import to_thread

from groundslab.errors import GroundslabError
from groundslab.views.interface.documents import error_to_json
from groundslab.workbench.child_process import ChildProcess, set_up_child

#: Shortest time between two messages about the progress [s].
PROGRESS_INTERVAL = 0.2
#: Time after which a call that was cancelled is noticed [s].
POLL_INTERVAL = 0.1


class TaskRefused(Exception):
    """A task has no result; ``document`` is that of its error."""

    def __init__(self, document: dict[str, Any]) -> None:
        super().__init__(document)
        self.document = document


async def run(task: Callable[..., Any], *arguments: Any, tell: Callable[[str], Awaitable[None]]) -> Any:
    """Return what a task returns; raises TaskRefused. A call that is cancelled kills the process."""
    process = await to_thread.run_sync(ChildProcess, "groundslab task", main, task, *arguments)
    try:
        while True:
            if not await to_thread.run_sync(process.pipe.poll, POLL_INTERVAL):
                continue
            kind, content = _receive(process)
            if kind == "progress":
                await tell(content)
            elif kind == "done":
                return content
            else:
                raise TaskRefused(content)
    finally:
        process.close()


def _receive(process: ChildProcess) -> tuple[str, Any]:
    """Return the next message of a process."""
    try:
        kind, content = process.pipe.recv()
    except (EOFError, OSError):
        error = RuntimeError("the process of this task ended unexpectedly, perhaps because the memory was used up")
        return "refused", error_to_json(error)
    return kind, content


def main(pipe: Connection, task: Callable[..., Any], *arguments: Any) -> None:
    """Do a task and send ("progress", words), then ("done", result) or ("refused", document)."""
    set_up_child()
    sys.stdout.flush()
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # standard output belongs to the protocol
    sent = float("-inf")

    def tell(words: str) -> None:
        nonlocal sent
        if time.monotonic() - sent >= PROGRESS_INTERVAL:
            pipe.send(("progress", words))
            sent = time.monotonic()

    pipe.send(outcome_of(task, tell, *arguments))


def outcome_of(task: Callable[..., Any], tell: Callable[[str], None], *arguments: Any) -> tuple[str, Any]:
    """Return ("done", result) or ("refused", document) of a task that tells how it goes on."""
    try:
        return "done", task(tell, *arguments)
    except (GroundslabError, OSError, MemoryError) as error:
        return "refused", error_to_json(error)
    except Exception as error:
        traceback.print_exc()
        message = f"an error in groundslab itself: {type(error).__name__}: {error}"
        return "refused", error_to_json(RuntimeError(message))
