"""Function calls in a child process with limits of time and memory.

Input from a file or a page may take any time and memory to process. A call that exceeds the limits raises an error, and
the process is replaced.
"""

from __future__ import annotations

import errno
import os
import signal
import threading
import time
import traceback
from collections.abc import Callable
from importlib import import_module
from multiprocessing import connection
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler
from pathlib import Path
from typing import Any

from groundslab.errors import GroundslabError
from groundslab.messages import Message, Name
from groundslab.workbench.child_process import ChildProcess, set_up_child

#: Memory that a function may use beyond what the process uses when it is ready [bytes].
MEMORY = 2_000_000_000
#: Size of the largest result [bytes].
MAX_RESULT = 100_000_000
#: Time in which a process must be ready [s].
START_LIMIT = 60.0
#: Time that a call that is no longer needed has to end before its process is ended [s].
GRACE = 0.5
#: Interval at which a running call is checked for whether it is still needed [s].
POLL_INTERVAL = 0.05
#: How a process ends whose native code gets no memory: by a signal, SIGKILL being the system's, or as OpenBLAS ends it.
_OUT_OF_MEMORY = {-signal.SIGSEGV, -signal.SIGABRT, -getattr(signal, "SIGBUS", 7), -getattr(signal, "SIGKILL", 9), 1}
#: A process has used up its memory above this share of the most that it may have.
FULL = 0.9


class CallFailure(Exception):
    """A call has no result."""


class TimeLimit(CallFailure):
    """The function takes too long."""


class MemoryLimit(CallFailure):
    """The function needs too much memory, or its result is too large."""


class Interrupted(CallFailure):
    """The call is no longer needed."""


class ProcessEnded(CallFailure):
    """The process ended by itself, or cannot be started."""


class BoundedProcess:
    """A process that calls one function at a time; it starts when first needed, and again after each end."""

    def __init__(self, prepare: Callable[[], object] | None = None, memory: int = MEMORY) -> None:
        """``prepare`` is called when a process starts, before the limits of time and memory apply."""
        self._prepare = prepare
        self._memory = memory
        self._call_lock = threading.Lock()
        self._process: ChildProcess | None = None
        self._limit = self._most_used = 0  # of the process's address space [bytes]
        self._closed = False

    def call(
        self,
        function: Callable[..., Any],
        *arguments: Any,
        seconds: float,
        needed: Callable[[], bool] = lambda: True,
    ) -> Any:
        """Return the result of a function, or raise its exception; both must be picklable.

        Raises TimeLimit after so many seconds, MemoryLimit, Interrupted soon after ``needed`` returns False, and
        ProcessEnded.
        """
        with self._call_lock:
            try:
                pipe = self._start()
                pipe.send((function, arguments))
                self._wait(seconds, needed, TimeLimit(Message("longer than {seconds:g} s", seconds=seconds)))
                succeeded, outcome = pipe.recv()
            except (EOFError, OSError) as error:
                raise self._why_ended(error) from None
            if not succeeded and isinstance(outcome, MemoryError | MemoryLimit):
                self._end()  # the memory that is left is not known
                raise MemoryLimit(str(outcome) or "more memory than there is") from None
        if not succeeded:
            raise outcome
        return outcome

    def close(self) -> None:
        """End the process and the call that it is executing."""
        self._closed = True
        process = self._process
        if process is not None:
            process.kill()
        with self._call_lock:
            self._end()

    def _start(self) -> Connection:
        """Start the process unless it is running, and return the pipe to it."""
        if self._closed:
            raise ProcessEnded("the server ends")
        if self._process is not None and not self._process.is_alive():
            self._end()
        if self._process is None:
            self._process = ChildProcess("groundslab reader", _main, self._prepare, self._memory)
            self._wait(START_LIMIT, lambda: not self._closed, ProcessEnded("it cannot be started"))
            self._limit, self._most_used = self._process.pipe.recv(), _peak_memory(self._process.pid)
        return self._process.pipe

    def _wait(self, seconds: float, needed: Callable[[], bool], timeout: Exception) -> None:
        """Wait for a message or the end of the process; end it after the time, or when the call is not needed."""
        assert self._process is not None
        sources: list[Any] = [self._process.pipe, self._process.sentinel]
        deadline, interrupted = time.monotonic() + seconds, False
        while not connection.wait(sources, POLL_INTERVAL):
            self._most_used = max(self._most_used, _peak_memory(self._process.pid))
            if not interrupted and not needed():
                interrupted, deadline = True, min(deadline, time.monotonic() + GRACE)
            if time.monotonic() > deadline:
                self._end()
                raise Interrupted if interrupted else timeout

    def _why_ended(self, error: Exception) -> CallFailure:
        """Return why the process has ended by itself, and free it.

        Native code that gets no memory ends a process without a word. What the process took last tells.
        """
        process = self._process
        if process is None or self._closed:
            self._end()
            return ProcessEnded("the server ends" if self._closed else str(error) or "the process ended")
        process.join(GRACE)
        code, used = process.exitcode, self._most_used
        self._end()
        is_code = code is None or code >= 0
        how = Message("exit code {code}", code=str(code)) if is_code else Name(signal.Signals(-(code or 0)).name)
        if code in _OUT_OF_MEMORY and used > FULL * self._limit:
            return MemoryLimit(Message("more than {memory:g} GB ({how})", memory=self._memory / 1e9, how=how))
        if code in _OUT_OF_MEMORY:
            return ProcessEnded(Message("the process ended ({how}, perhaps for lack of memory)", how=how))
        return ProcessEnded(Message("the process ended ({how})", how=how))

    def _end(self) -> None:
        """End the process, if there is one."""
        process, self._process = self._process, None
        if process is not None:
            process.close()


def _main(pipe: Connection, prepare: Callable[[], object] | None, memory: int) -> None:
    """Execute calls until the pipe is closed."""
    set_up_child()
    if prepare is not None:
        prepare()
    # NumPy's BLAS reserves memory as it is loaded, and ends a process that gets none
    import_module("numpy")
    # made while there is room
    exhausted = ForkingPickler.dumps((False, MemoryLimit(Message("more than {memory:g} GB", memory=memory / 1e9))))
    pipe.send(_limit_memory(memory))
    while True:
        try:
            try:
                message = pipe.recv_bytes()
            except MemoryError:
                pipe.send_bytes(exhausted)
                return  # the rest of the message is still in the pipe
            pipe.send_bytes(_call(message, exhausted))
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


def _call(message: bytes, exhausted: Any) -> Any:
    """Return the result or the exception of the function in a message, pickled; `exhausted` where memory runs out.

    Reading the message imports the module of the function, for which there may be too little memory already.
    """
    try:
        function, arguments = ForkingPickler.loads(message)
        content = ForkingPickler.dumps((True, function(*arguments)))
        if len(content) <= MAX_RESULT:
            return content
        error: Exception = MemoryLimit(Message("a result of more than {size} MB", size=MAX_RESULT // 1_000_000))
    except Exception as found:
        if _is_out_of_memory(found):
            return exhausted
        error = found
    try:
        return ForkingPickler.dumps((False, error))
    except MemoryError:
        return exhausted
    except Exception:
        traceback.print_exc()
        return ForkingPickler.dumps((False, RuntimeError(str(error))))


def _is_out_of_memory(error: Exception) -> bool:
    """Return whether an exception says that there is no memory left, also for a library that is being loaded.

    Libraries that get none may say anything else: that counts, too, in a process that has used up its memory.
    """
    if isinstance(error, ImportError):
        return "failed to map segment" in str(error)  # what the loader of Linux says
    of_library = not isinstance(error, GroundslabError) or error.__context__ is not None
    if of_library and _peak_memory(os.getpid()) > FULL * _memory_limit() > 0:
        return True
    return isinstance(error, MemoryError) or (isinstance(error, OSError) and error.errno == errno.ENOMEM)


def _peak_memory(pid: int | None) -> int:
    """Return the largest address space that a process has had [bytes], 0 where the system does not tell."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="ascii", errors="replace")
        return 1024 * int(status.partition("VmPeak:")[2].split(maxsplit=1)[0])
    except (OSError, ValueError, IndexError):
        return 0


def _memory_limit() -> int:
    """Return how many bytes this process may use, 0 where nothing limits it."""
    try:
        import resource
    except ImportError:
        return 0
    return max(resource.getrlimit(resource.RLIMIT_AS)[0], 0)


def _limit_memory(more: int) -> int:
    """Limit the process to so many bytes more than it uses; return how many it may use, 0 where that is impossible."""
    try:
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    except (ImportError, OSError):
        return 0
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    limit = pages * resource.getpagesize() + more
    limit = limit if most < 0 else min(limit, most)
    resource.setrlimit(resource.RLIMIT_AS, (limit, most))
    return limit
