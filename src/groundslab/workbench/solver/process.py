"""The process that solves: kept warm, told what to solve, stopped between two steps of the analysis or killed.

It speaks with ``solver`` through a pipe. What it is told: ("solve", run, text), ("report", run, file). What it says:
("ready",) for the first run, ("warm",) when it has prepared, ("progress", run, text, share), ("solved", run, answer)
with the scene's bytes behind, ("refused", run, message, faults), ("stopped", run), ("report", run, message) with the
report's bytes behind if there is no message.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing import connection, parent_process
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError

if TYPE_CHECKING:
    from groundslab.model.loads.load_cases import Combination
    from groundslab.results.record import Step
    from groundslab.results.results import Combined

#: At most one word about the progress in so many seconds.
PAUSE = 0.1


@dataclass(frozen=True, slots=True)
class Answer:
    """What came out of a run: seconds, why combinations are refused, the summary; the scene goes beside it."""

    seconds: float
    refused: dict[str, str]
    summary: dict[str, Any]


#: Solves a text: is told whom to tell of the progress (text, share), gives answer, packed scene, and what a report
#: needs.
Progress = Callable[[str, float | None], None]
Task = Callable[[str, Progress], tuple[Answer, bytes, Any]]


class Stopped(BaseException):
    """The run is not wanted any more; no ``except Exception`` on the way shall catch this."""


def solve(text: str, progress: Progress) -> tuple[Answer, bytes, tuple[str, Combined]]:
    """Return the results of the case that a text describes; raises GroundslabError."""
    from groundslab.analysis.driver import solve_combinations
    from groundslab.case import casefile
    from groundslab.model.combinations import combinations_of
    from groundslab.views.scene.binary import packed
    from groundslab.views.scene.fields import scene_of
    from groundslab.views.summary.progress import line
    from groundslab.workbench.solver.summary import summary_of

    start = time.perf_counter()
    model = casefile.loads(text)
    count, begun, name = len(combinations_of(model)), 0, ""

    def share() -> float | None:
        return (begun - 1) / count if count > 1 else None

    def on_combination(combination: Combination) -> None:
        nonlocal begun, name
        begun += 1
        name = f"{begun} of {count}, {combination.name}: " if count > 1 else ""
        progress(f"{name}begins", share())

    def on_step(step: Step) -> None:
        progress(name + line(step), share())

    combined = solve_combinations(model, on_step, on_combination)
    refused = {name: str(error) for name, error in combined.refused.items()}
    summary, scene = summary_of(combined), packed(scene_of(combined))
    return Answer(time.perf_counter() - start, refused, summary), scene, (text, combined)


def warm(progress: Progress) -> None:
    """Solve something small, so that the first run need not wait for libraries to load."""
    from groundslab.case import casefile

    solve(casefile.starter() + '\n[mesh]\nsize = "0.5 m"\n', progress)


def main(pipe: Connection, stop: Any, task: Task, prepare: Callable[[Progress], None] | None) -> None:
    """Serve until the other end of the pipe is closed; runs up to the number in ``stop.value`` are to be stopped."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which then ends this process
    threading.Thread(target=end_with_parent, daemon=True).start()
    pipe.send(("ready",))
    if prepare is not None:
        _prepare(pipe, prepare)
    pipe.send(("warm",))
    latest: tuple[int, Any] | None = None
    while True:
        try:
            word, run, *rest = pipe.recv()
            if word == "solve":
                latest = _solve(pipe, stop, task, run, rest[0]) or latest
            else:
                _report(pipe, run, rest[0], latest)
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


def _prepare(pipe: Connection, prepare: Callable[[Progress], None]) -> None:
    """Get ready for the first run as long as it has not been asked for."""

    def progress(_text: str, _share: float | None) -> None:
        if pipe.poll():
            raise Stopped

    try:
        if not pipe.poll(0.05):
            prepare(progress)
    except Stopped:
        pass
    except Exception:
        traceback.print_exc()


def _solve(pipe: Connection, stop: Any, task: Task, run: int, text: str) -> tuple[int, Any] | None:
    """Solve a text and say what came of it; return what a report on it needs."""
    said = float("-inf")

    def progress(words: str, share: float | None) -> None:
        nonlocal said
        if stop.value >= run:
            raise Stopped
        if time.monotonic() - said >= PAUSE:
            pipe.send(("progress", run, words, share))
            said = time.monotonic()

    try:
        progress("begins", None)
        answer, scene, kept = task(text, progress)
    except Stopped:
        pipe.send(("stopped", run))
    except InputError as error:
        pipe.send(("refused", run, str(error), list(error.issues)))
    except GroundslabError as error:
        pipe.send(("refused", run, str(error), []))
    except MemoryError:
        pipe.send(("refused", run, "the memory is too small for this analysis; a coarser mesh needs less", []))
    except Exception as error:
        traceback.print_exc()
        pipe.send(("refused", run, f"an error in groundslab itself: {type(error).__name__}: {error}", []))
    else:
        pipe.send(("solved", run, answer))
        pipe.send_bytes(scene)
        return run, kept
    return None


def _report(pipe: Connection, run: int, file: str, latest: tuple[int, Any] | None) -> None:
    """Send the report on a run, if it is the latest one; file is what the case is called in it."""
    if latest is None or latest[0] != run:
        pipe.send(("report", run, "the results of that run are not kept any more; solve again"))
        return
    try:
        from groundslab.views.report.html import html_of

        text, combined = latest[1]
        content = html_of(combined, text=text, file=file).encode()
    except Exception as error:
        traceback.print_exc()
        pipe.send(("report", run, f"the report cannot be written: {error}"))
    else:
        pipe.send(("report", run, ""))
        pipe.send_bytes(content)


def end_with_parent() -> None:
    """End this process at once when the server is gone, however it went."""
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        sys.stderr.flush()
        os._exit(1)
