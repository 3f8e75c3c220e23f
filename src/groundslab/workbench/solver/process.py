"""The process that solves: it is kept warm, and stops a run between two steps of the analysis.

It receives ("solve", run, text, shown, before, accuracy), ("report", run, file), ("archive", run, file), ("table", run,
name), ("document", run, name), ("export", run, wanted), ("difference", run, wanted), ("reference", run, file) and
("bars", run, folder) from ``Worker`` through a pipe. It sends ("ready",) when it can receive, ("warm",) when it has
warmed up, ("progress", run, text, share, details), ("preview", run, words, figures) followed by the bytes of a scene,
("provisional", run, answer) and ("solved", run, answer) followed by the bytes of the scene, ("refused", run, message,
issues), ("stopped", run), ("making", run, title, share) while a report is made, and ("view", message, error or issues)
in answer to all but the first, followed by the bytes that were asked for if there is no error. These are answered
between two steps of a run, too.
"""

from __future__ import annotations

import pickle
import time
import traceback
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError
from groundslab.messages import Label, Message, Name
from groundslab.workbench.child_process import explain_error, set_up_child
from groundslab.workbench.exports.files import (
    Wanted,
    export,
    write_difference,
    write_document,
    write_proposal,
    write_reference,
)
from groundslab.workbench.solver.answer import Answer

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model
    from groundslab.results.records import Step
    from groundslab.results.results import Results
    from groundslab.views.report.table_layout import TableLayout

#: Shortest time between two messages about the progress [s].
PROGRESS_INTERVAL = 0.1
#: A run that has no results after so long shows a preview [s].
PREVIEW_AFTER = 1.5
#: It begins with one where the run before had no results after so long [s], or, of the first run, where there are more
#: elements times combinations than are solved soon.
SLOW, MUCH_WORK = 1.0, 8000
#: What the case that warms up has besides: a load at a point, and a mesh for an accuracy.
WARMING = '\n[[loads]]\nkind = "point"\nP = "50 kN"\nx = "1 m"\ny = "0.5 m"\n\n[mesh]\naccuracy = "15 %"\n'
#: The files about a run that can be asked for.
FILES = ("report", "archive")
#: A report on results whose case has changed since.
OUTDATED = "outdated report"


@dataclass(frozen=True, slots=True)
class Progress:
    """Tells how a run goes on, and shows what there is before its end.

    `tell` is called with a text, the share of combinations that are done, and details of the iteration, `show` with
    words about a preview, its figures and its packed scene, `keep` with provisional results as a task returns its own.
    `shown` is the combination that is looked at, None where no preview of it is wanted. `before` is how long the run
    before took to its first results, if known [s]; `accuracy` is asked for in place of that of the case, "" for that.
    """

    tell: Callable[[str, float | None, str], None]
    show: Callable[[str, dict[str, Any], bytes], None] = lambda _words, _figures, _scene: None
    shown: str | None = None
    keep: Callable[[Answer, bytes, Any], None] = lambda _answer, _scene, _kept: None
    before: float | None = None
    accuracy: str = ""

    def __call__(self, text: str, share: float | None, details: str = "") -> None:
        """Tell how the run goes on."""
        self.tell(text, share, details)


#: Called before each chapter of a report with its title and the share that is made.
Told = Callable[[str, float], None]
#: What is made of the results of a run: its kind, the run, and the name of the case or of a table, or what is wanted.
View = tuple[str, int, "str | Wanted"]
#: Solves a text; returns the answer, the packed scene, and the data for a report.
Task = Callable[[str, Progress], tuple[Answer, bytes, Any]]

#: A run, its text, and what `Progress` is told: the combination looked at, seconds of the run before, the accuracy.
Job = tuple[int, str, str | None, float | None, str]

#: Gets the process ready for its first run.
Prepare = Callable[[Progress], None]


@dataclass(frozen=True, slots=True)
class Solved:
    """What is kept of a run for its report and its tables, which are made when they are asked for."""

    text: str
    results: Results
    tables: dict[str, Callable[[], TableLayout]]
    #: The text of the case, without an accuracy that was asked for in place of its own.
    case: str


class Stopped(BaseException):
    """The run is to stop; not an ``Exception``, so that nothing on the way catches it."""


def solve(text: str, progress: Progress) -> tuple[Answer, bytes, Solved]:
    """Return the results of the case that a text describes; raises GroundslabError.

    Those on each mesh that is refined are kept before: on the first one at once, and again with checks and tables.
    """
    from groundslab.analysis.driver import solve_combinations
    from groundslab.case import casefile
    from groundslab.model.combinations import list_combinations
    from groundslab.views.summary.progress import CombinationCount, line
    from groundslab.workbench.solver.cost import with_accuracy

    start = time.perf_counter()
    texts = with_accuracy(text, progress.accuracy), text
    model = casefile.loads(texts[0])
    count = len(list_combinations(model))
    combinations = CombinationCount(count, mesh=1 if model.mesh.adaptive else None)
    first, has_preview = 0.0, progress.shown is None

    def on_combination(combination: Combination) -> None:
        combinations.begin(combination.name)
        progress(combinations.describe(), combinations.share, combinations.words() + Label("begins"))

    def look(after: float) -> None:
        nonlocal has_preview
        if not (first or has_preview) and time.perf_counter() - start > after:
            has_preview = True
            _show_preview(model, progress, progress.shown or "")

    def on_step(step: Step) -> None:
        progress(combinations.describe(step), combinations.share, combinations.words() + line(step))
        look(PREVIEW_AFTER)

    def on_mesh(results: Results) -> None:
        nonlocal first
        if not first:
            first = time.perf_counter() - start
            progress.keep(*_outcome(texts, results, (start, first), with_checks=False))
        progress.keep(*_outcome(texts, results, (start, first)))
        combinations.begin_mesh()

    if _is_slow(model, count, progress.before):
        look(0.0)
    results = solve_combinations(model, on_step, on_combination, on_mesh)
    return _outcome(texts, results, (start, first or time.perf_counter() - start))


def _is_slow(model: Model, count: int, before: float | None) -> bool:
    """Return whether the first results of so many combinations are far, by the run before or by the work for them.

    A mesh for an accuracy follows all that there is on a slab: it has far more elements than its size tells.
    """
    from groundslab.model.consistency import estimate_elements

    if before is not None:
        return before > SLOW
    if model.mesh.adaptive and (count > 1 or not model.plain):
        return True
    return estimate_elements(model.plate, model.plates, model.mesh) * count > MUCH_WORK


def _outcome(
    texts: tuple[str, str], results: Results, times: tuple[float, float], with_checks: bool = True
) -> tuple[Answer, bytes, Solved]:
    """Return the answer, the packed scene and the data for a report of results.

    texts are that which was solved and that of the case, which may ask for another accuracy. times are when the run
    began, and how long it took to its first results [s]. Without checks there are no tables either: which there are
    follows from the checks.
    """
    from groundslab.results.results import refusal_words
    from groundslab.views.scene.binary import pack
    from groundslab.views.scene.fields import scene_of
    from groundslab.views.summary.discretization import provisional_words
    from groundslab.workbench.solver.cost import count_made
    from groundslab.workbench.solver.summary import build_summary
    from groundslab.workbench.solver.tables import layout_makers

    refused = {name: refusal_words(error, results.model.units) for name, error in results.refused.items()}
    summary, scene = build_summary(results, with_checks), pack(scene_of(results))
    tables = layout_makers(results) if with_checks else {}
    start, first = times
    seconds = time.perf_counter() - start
    counts = count_made(results)
    answer = Answer(seconds, refused, summary, tuple(tables), provisional_words(results), first, *counts)
    solved_text, case = texts
    return answer, scene, Solved(solved_text, results, tables, case)


def _show_preview(model: Model, progress: Progress, name: str) -> None:
    """Show one combination on a coarse mesh, if it has a solution there."""
    from groundslab.analysis.driver import solve_preview
    from groundslab.views.scene.binary import pack
    from groundslab.views.scene.fields import scene_of
    from groundslab.workbench.solver.summary import build_summary

    with suppress(GroundslabError):
        preview = solve_preview(model, name, lambda _: progress(Label("a preview on a coarse mesh"), None))
        if len(preview):
            (figures,) = build_summary(preview, with_checks=False)["combinations"]
            progress.show(Label("on a coarse mesh, of this combination only"), figures, pack(scene_of(preview)))


def warm_up(progress: Progress) -> None:
    """Solve a small case, so that the libraries are loaded before the first run, those of the mesher too."""
    from groundslab.case import casefile

    solve(casefile.starter() + WARMING, progress)


def main(pipe: Connection, stop: Any, task: Task, prepare: Prepare | None) -> None:
    """Serve until the pipe is closed; runs up to the number in ``stop.value`` are stopped."""
    set_up_child()
    pipe.send(("ready",))
    if prepare is not None:
        _prepare(pipe, prepare)
    pipe.send(("warm",))
    by_run: Mapping[int, Any] = {}
    while True:
        try:
            kind, run, *rest = pipe.recv()
            if kind == "solve":
                by_run = _solve(pipe, stop, task, (run, *rest), by_run)
            else:
                _send_view(pipe, (kind, run, rest[0]), by_run)
        except (EOFError, BrokenPipeError, ConnectionResetError):
            return


def _prepare(pipe: Connection, prepare: Prepare) -> None:
    """Warm up until the first message arrives."""

    def tell(_text: str, _share: float | None, _details: str) -> None:
        if pipe.poll():
            raise Stopped

    try:
        if not pipe.poll(0.05):
            prepare(Progress(tell))
    except Stopped:
        pass
    except Exception:
        traceback.print_exc()


def _solve(pipe: Connection, stop: Any, task: Task, job: Job, by_run: Mapping[int, Any]) -> Mapping[int, Any]:
    """Solve the text of a run and send the outcome; return the data for reports and tables by run.

    While it is solved, views of what is known of earlier runs and of provisional results are sent.
    """
    run, text, shown, before, accuracy = job
    sent = float("-inf")
    provisional: dict[int, Any] = {}

    def listen() -> None:
        if stop.value >= run:
            raise Stopped
        while pipe.poll():
            try:
                view = pipe.recv()
            except EOFError:
                raise Stopped from None
            _send_view(pipe, view, {**by_run, **provisional})

    def tell(message: str, share: float | None, details: str = "") -> None:
        nonlocal sent
        listen()
        if time.monotonic() - sent >= PROGRESS_INTERVAL:
            pipe.send(("progress", run, message, share, details))
            sent = time.monotonic()

    def show(words: str, figures: dict[str, Any], scene: bytes) -> None:
        listen()
        pipe.send(("preview", run, words, figures))
        pipe.send_bytes(scene)

    def keep(answer: Answer, scene: bytes, kept: Any) -> None:
        provisional[run] = kept
        pipe.send(("provisional", run, answer))
        pipe.send_bytes(scene)
        listen()

    try:
        tell("", None)
        answer, scene, kept = task(text, Progress(tell, show, shown, keep, before, accuracy))
    except Stopped:
        pipe.send(("stopped", run))
    except GroundslabError as error:
        pipe.send(("refused", run, str(error), list(error.issues) if isinstance(error, InputError) else []))
    except MemoryError:
        pipe.send(("refused", run, Label("not enough memory for this analysis; a coarser mesh needs less"), []))
    except Exception as error:
        traceback.print_exc()
        pipe.send(("refused", run, explain_error(error), []))
    else:
        pipe.send(("solved", run, answer))
        pipe.send_bytes(scene)
        return {run: kept}
    return provisional or by_run


def _compare(model: Model) -> GroundComparison | None:
    """Return a slab on other models of its ground if its case lists that chapter of the report by name."""
    if "chapters" not in model.report.model_fields_set or "grounds" not in model.report.chapters:
        return None
    from groundslab.analysis.ground_comparison.comparison import compare_grounds

    return compare_grounds(model)


def _send_view(pipe: Connection, view: View, by_run: Mapping[int, Any]) -> None:
    """Send a report, an archive or a table of a run, if anything is known of it."""
    kind, run, name = view
    if run not in by_run:
        pipe.send(("view", view, Label("the results of that run are not kept any more; solve again")))
        return

    def told(title: str, share: float) -> None:
        pipe.send(("making", run, title, share))

    try:
        content = WRITERS[kind](by_run[run], name, told)
    except InputError as error:
        pipe.send(("view", view, error.issues))
    except Exception as error:
        traceback.print_exc()
        pipe.send(("view", view, Message("it cannot be made: {error}", error=Name(error))))
    else:
        pipe.send(("view", view, ""))
        pipe.send_bytes(content)


def _render_report(solved: Solved, file: str, told: Told, remark: str = "") -> str:
    """Return the report; file is the name of the case."""
    from groundslab.views.report.html import render_report

    results = solved.results
    comparison = _compare(results.model)
    return render_report(results, text=solved.text, file=file, comparison=comparison, remark=remark, told=told)


def _write_report(solved: Solved, file: str, told: Told) -> bytes:
    """Return the report as a file."""
    return _render_report(solved, file, told).encode()


def _write_outdated_report(solved: Solved, file: str, told: Told) -> bytes:
    """Return the report as a file, which says that the case has changed since."""
    from groundslab.views.report.changes import CHANGED

    return _render_report(solved, file, told, Message(CHANGED, file=Name(file))).encode()


def _write_archive(solved: Solved, file: str, told: Told) -> bytes:
    """Return case, results and report as one file."""
    from groundslab.views.files.archive import pack_results

    return pack_results(solved.results, solved.text, _render_report(solved, file, told))


def _write_export(solved: Solved, wanted: Wanted, _: Told) -> bytes:
    """Return a file for other programs, packed with what is said of it."""
    comparison = _compare(solved.results.model) if wanted.file == "report.pdf" else None
    return export(solved.results, wanted, solved.text, comparison).to_bytes()


def _write_table(solved: Solved, name: str, _: Told | None = None) -> bytes:
    """Return a table as data that keep their messages, which the server writes in the language of each page."""
    from groundslab.workbench.solver.tables import table_to_json

    return pickle.dumps(table_to_json(name, solved.tables[name]()))


#: What writes each kind of view.
WRITERS: dict[str, Callable[[Solved, Any, Told], bytes]] = {
    "report": _write_report, OUTDATED: _write_outdated_report, "archive": _write_archive, "table": _write_table,
    "export": _write_export, "document": lambda solved, name, _: write_document(solved.results, name),
    "bars": lambda solved, folder, _: write_proposal(solved.results, solved.case, Path(folder)),
    "difference": lambda solved, wanted, _: write_difference(solved.results, wanted),
    "reference": lambda solved, file, _: write_reference(solved.results, Path(file)),
}  # fmt: skip
