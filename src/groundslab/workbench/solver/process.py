"""The process that solves: it is kept warm, and stops a run between two steps of the analysis.

It receives ("solve", run, text), ("report", run, file) and ("archive", run, file) from ``Solver`` through a pipe. It
sends ("ready",) when it can receive, ("warm",) when it has warmed up, ("progress", run, text, share), ("solved", run,
answer) followed by the bytes of the scene, ("refused", run, message, issues), ("stopped", run), and (kind, run, error)
of a report or an archive, followed by its bytes if the error is empty.
"""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError
from groundslab.workbench.child_process import set_up_child

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model
    from groundslab.results.record import Step
    from groundslab.results.results import Results

#: Shortest time between two messages about the progress [s].
PROGRESS_INTERVAL = 0.1
#: The files about a run that can be asked for.
FILES = ("report", "archive")


@dataclass(frozen=True, slots=True)
class Answer:
    """The outcome of a run without its scene: seconds, reasons of refused combinations, the summary."""

    seconds: float
    refused: dict[str, str]
    summary: dict[str, Any]


#: Called with a text and the share of combinations that are done.
Progress = Callable[[str, float | None], None]
#: Solves a text; returns the answer, the packed scene, and the data for a report.
Task = Callable[[str, Progress], tuple[Answer, bytes, Any]]


class Stopped(BaseException):
    """The run is to stop; not an ``Exception``, so that nothing on the way catches it."""


def solve(text: str, progress: Progress) -> tuple[Answer, bytes, tuple[str, Results]]:
    """Return the results of the case that a text describes; raises GroundslabError."""
    from groundslab.analysis.driver import solve_combinations
    from groundslab.case import casefile
    from groundslab.model.combinations import list_combinations
    from groundslab.views.scene.binary import pack
    from groundslab.views.scene.fields import scene_of
    from groundslab.views.summary.progress import CombinationCount, line
    from groundslab.workbench.solver.summary import build_summary

    start = time.perf_counter()
    model = casefile.loads(text)
    combinations = CombinationCount(len(list_combinations(model)))

    def on_combination(combination: Combination) -> None:
        combinations.begin(combination.name)
        progress(f"{combinations.words()}begins", combinations.share)

    def on_step(step: Step) -> None:
        progress(combinations.words() + line(step), combinations.share)

    combined = solve_combinations(model, on_step, on_combination)
    refused = {name: str(error) for name, error in combined.refused.items()}
    summary, scene = build_summary(combined), pack(scene_of(combined))
    return Answer(time.perf_counter() - start, refused, summary), scene, (text, combined)


def warm_up(progress: Progress) -> None:
    """Solve a small case, so that the libraries are loaded before the first run."""
    from groundslab.case import casefile

    solve(casefile.starter() + '\n[mesh]\nsize = "0.5 m"\n', progress)


def main(pipe: Connection, stop: Any, task: Task, prepare: Callable[[Progress], None] | None) -> None:
    """Serve until the pipe is closed; runs up to the number in ``stop.value`` are stopped."""
    set_up_child()
    pipe.send(("ready",))
    if prepare is not None:
        _prepare(pipe, prepare)
    pipe.send(("warm",))
    latest: tuple[int, Any] | None = None
    while True:
        try:
            kind, run, *rest = pipe.recv()
            if kind == "solve":
                latest = _solve(pipe, stop, task, run, rest[0]) or latest
            else:
                _write_file(pipe, kind, run, rest[0], latest)
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


def _prepare(pipe: Connection, prepare: Callable[[Progress], None]) -> None:
    """Warm up until the first message arrives."""

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
    """Solve a text and send the outcome; return the data for a report."""
    sent = float("-inf")

    def progress(message: str, share: float | None) -> None:
        nonlocal sent
        if stop.value >= run:
            raise Stopped
        if time.monotonic() - sent >= PROGRESS_INTERVAL:
            pipe.send(("progress", run, message, share))
            sent = time.monotonic()

    try:
        progress("begins", None)
        answer, scene, kept = task(text, progress)
    except Stopped:
        pipe.send(("stopped", run))
    except GroundslabError as error:
        pipe.send(("refused", run, str(error), list(error.issues) if isinstance(error, InputError) else []))
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


def _compare(model: Model) -> GroundComparison | None:
    """Return a slab on other models of its ground if its case lists that chapter of the report by name."""
    if "chapters" not in model.report.model_fields_set or "grounds" not in model.report.chapters:
        return None
    from groundslab.analysis.ground_comparison.comparison import compare_grounds

    return compare_grounds(model)


def _write_file(pipe: Connection, kind: str, run: int, file: str, latest: tuple[int, Any] | None) -> None:
    """Send the report or archive of a run, if it is the latest one; file is the name of the case."""
    if latest is None or latest[0] != run:
        pipe.send((kind, run, "the results of that run are not kept any more; solve again"))
        return
    try:
        from groundslab.views.files.archive import pack_results
        from groundslab.views.report.html import render_report

        text, combined = latest[1]
        report = render_report(combined, text=text, file=file, comparison=_compare(combined.model))
        content = report.encode() if kind == "report" else pack_results(combined, text, report)
    except Exception as error:
        traceback.print_exc()
        pipe.send((kind, run, f"the {kind} cannot be written: {error}"))
    else:
        pipe.send((kind, run, ""))
        pipe.send_bytes(content)
