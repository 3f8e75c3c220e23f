"""Functions called in a process of their own, within limits of time and memory; one that breaks them is replaced.

What comes from a file or a page may take any time and any memory to read. Here that ends in an error of the one who
asked, while everything else goes on.
"""

from __future__ import annotations

import multiprocessing
import signal
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import connection
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler
from pathlib import Path
from typing import Any, Protocol

from groundslab.workbench.solver.process import end_with_parent

#: Memory that a function may take beyond what the process has when it is ready [bytes].
MEMORY = 2_000_000_000
#: Length of the largest answer [bytes].
LARGEST = 100_000_000
#: A process that is not ready after so long counts as failed [s].
START = 60.0
#: A call that is not wanted any more is left to itself for so long before its process is ended [s].
GRACE = 0.5
#: How often a call that lasts is asked whether it is still wanted [s].
PULSE = 0.05


class TimeLimit(Exception):
    """The function took longer than it may."""


class MemoryLimit(Exception):
    """The function took more memory than it may, or its answer is too large."""


class Interrupted(Exception):
    """The call was not wanted any more."""


class ProcessEnded(Exception):
    """The process ended by itself, or could not be started."""


class Caller(Protocol):
    """Calls functions within limits."""

    def call(
        self, function: Callable[..., Any], *arguments: Any, seconds: float, wanted: Callable[[], bool] = ...
    ) -> Any:
        """Return what the function returns; raises what it raises, and the errors above."""

    def close(self) -> None:
        """End."""


@dataclass(slots=True)
class _Process:
    process: Any
    pipe: Connection


class BoundedProcess:
    """A process that calls one function at a time; started when it is first needed, and after each end."""

    def __init__(self, prepare: Callable[[], object] | None = None, memory: int = MEMORY) -> None:
        """`prepare` is called when a process starts, before time and memory count."""
        self._prepare = prepare
        self._memory = memory
        self._context = multiprocessing.get_context("spawn")
        self._turn = threading.Lock()
        self._process: _Process | None = None
        self._closed = False

    def call(
        self,
        function: Callable[..., Any],
        *arguments: Any,
        seconds: float,
        wanted: Callable[[], bool] = lambda: True,
    ) -> Any:
        """Return what a function returns, or raise what it raises; both must be possible to pickle.

        Raises TimeLimit after so many seconds, MemoryLimit, Interrupted soon after `wanted` returns False, and
        ProcessEnded.
        """
        with self._turn:
            try:
                pipe = self._started()
                pipe.send((function, arguments))
                self._wait(seconds, wanted, TimeLimit(f"longer than {seconds:g} s"))
                returned, outcome = pipe.recv()
            except (EOFError, OSError) as error:
                self._end()
                raise ProcessEnded(str(error) or "the process ended") from None
            if not returned and isinstance(outcome, MemoryError | MemoryLimit):
                self._end()  # what is left of the memory is not known
                raise MemoryLimit(str(outcome) or "more memory than there is") from None
        if not returned:
            raise outcome
        return outcome

    def close(self) -> None:
        """End the process and whatever it does."""
        self._closed = True
        process = self._process
        if process is not None:
            with suppress(ValueError):  # ended by the call that it was at
                process.process.kill()
        with self._turn:
            self._end()

    def _started(self) -> Connection:
        """Return the pipe to a process that is ready."""
        if self._closed:
            raise ProcessEnded("the server ends")
        if self._process is not None and not self._process.process.is_alive():
            self._end()
        if self._process is None:
            here, there = self._context.Pipe()
            arguments = (there, self._prepare, self._memory)
            process = self._context.Process(target=_main, args=arguments, name="groundslab reader", daemon=True)
            process.start()
            there.close()  # so that the end of the process is the end of the pipe
            self._process = _Process(process, here)
            self._wait(START, lambda: not self._closed, ProcessEnded("it cannot be started"))
            here.recv()
        return self._process.pipe

    def _wait(self, seconds: float, wanted: Callable[[], bool], late: Exception) -> None:
        """Wait until the process says something or ends; ends it when it is late or not wanted."""
        assert self._process is not None
        sources = [self._process.pipe, self._process.process.sentinel]
        deadline, interrupted = time.monotonic() + seconds, False
        while not connection.wait(sources, PULSE):
            if not interrupted and not wanted():
                interrupted, deadline = True, min(deadline, time.monotonic() + GRACE)
            if time.monotonic() > deadline:
                self._end()
                raise Interrupted if interrupted else late

    def _end(self) -> None:
        """End the process, if there is one."""
        process, self._process = self._process, None
        if process is not None:
            process.process.kill()
            process.process.join()
            process.process.close()
            process.pipe.close()


def _main(pipe: Connection, prepare: Callable[[], object] | None, memory: int) -> None:
    """Call what is asked for until the other end of the pipe is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which then ends this process
    threading.Thread(target=end_with_parent, daemon=True).start()
    if prepare is not None:
        prepare()
    _limit_memory(memory)
    pipe.send("ready")
    while True:
        try:
            function, arguments = pipe.recv()
            pipe.send_bytes(_answer(function, arguments, memory))
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


def _answer(function: Callable[..., Any], arguments: tuple[Any, ...], memory: int) -> Any:
    """Return what a function returns or raises, pickled."""
    try:
        content = ForkingPickler.dumps((True, function(*arguments)))
        if len(content) <= LARGEST:
            return content
        error: Exception = MemoryLimit(f"an answer of more than {LARGEST // 1_000_000} MB")
    except MemoryError:
        error = MemoryLimit(f"more than {memory / 1e9:g} GB")
    except Exception as found:
        error = found
    try:
        return ForkingPickler.dumps((False, error))
    except Exception:
        traceback.print_exc()
        return ForkingPickler.dumps((False, RuntimeError(str(error))))


def _limit_memory(more: int) -> None:
    """Allow the process so many bytes more than it has, where the system can do that; time is limited everywhere."""
    try:
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    except (ImportError, OSError):
        return
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    limit = pages * resource.getpagesize() + more
    resource.setrlimit(resource.RLIMIT_AS, (limit if most < 0 else min(limit, most), most))
