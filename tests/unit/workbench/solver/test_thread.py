"""The solver's process: the newest state wins, runs stop, crashes are reported and survived."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.workbench.events import Event
from groundslab.workbench.solver import process
from groundslab.workbench.solver import thread as solvers
from groundslab.workbench.solver.answer import Answer
from groundslab.workbench.solver.process import Progress
from groundslab.workbench.solver.thread import Solver
from helpers import workers
from helpers.scenes import unpack

pytestmark = pytest.mark.slow

PATIENCE = 120.0


class Events:
    """Records events, and waits for them."""

    def __init__(self) -> None:
        self.events: list[Event] = []
        self.more = threading.Condition()

    def __call__(self, name: str, about: dict[str, Any]) -> None:
        with self.more:
            self.events.append((name, dict(about)))
            self.more.notify_all()

    def wait(self, name: str, run: int) -> dict[str, Any]:
        """Return the first event of that name on that run."""

        def found() -> dict[str, Any] | None:
            return next((about for word, about in self.events if (word, about["run"]) == (name, run)), None)

        with self.more:
            assert self.more.wait_for(lambda: found() is not None, PATIENCE), self.events
            about = found()
            assert about is not None
            return about

    def wait_for_last(self, name: str, run: int) -> dict[str, Any]:
        """Return the last event, once it is of that name on that run."""
        with self.more:
            wanted = (name, run)
            assert self.more.wait_for(lambda: (self.events[-1][0], self.events[-1][1]["run"]) == wanted, PATIENCE)
            return self.events[-1][1]

    def wait_for_update(self, run: int, update: int) -> dict[str, Any]:
        """Return the first event that announces so late results of a run."""

        def found() -> dict[str, Any] | None:
            return next((each for _, each in self.events if (each["run"], each.get("update")) == (run, update)), None)

        with self.more:
            assert self.more.wait_for(lambda: found() is not None, PATIENCE), self.events
            about = found()
            assert about is not None
            return about

    def names(self, run: int) -> list[str]:
        """Return the names of the events on a run, progress left out."""
        return [name for name, about in self.events if about["run"] == run and name != "progress"]


@pytest.fixture
def events() -> Events:
    """Return a record of events."""
    return Events()


Make = Callable[..., Solver]


@pytest.fixture
def make(events: Events) -> Iterator[Make]:
    """Return what makes a solver whose process takes orders; it is closed in the end."""
    made: list[Solver] = []

    def of(task: Any = workers.obey, prepare: Any = None) -> Solver:
        made.append(Solver(events, task, prepare))
        return made[-1]

    yield of
    for each in made:
        each.close()


def submit(solver: Solver, text: str, version: int = 1, delay: float = 0.0, force: bool = False) -> int:
    """Have a text solved; it means itself."""
    return solver.submit(text, version, text, delay, force)


def wait_until_stuck(file: Path) -> None:
    """Wait until a run that is stuck until there is a file listens no more."""
    end = time.monotonic() + PATIENCE
    while not Path(f"{file}.stuck").exists():
        assert time.monotonic() < end
        time.sleep(0.005)


def test_a_run_is_reported_from_beginning_to_end(make: Make, events: Events) -> None:
    """Solving, progress, solved, in this order; scene and summary are there; results of two runs are kept."""
    solver = make()
    first = submit(solver, "go 1", 7)
    assert events.wait("solved", first)["version"] == 7
    assert events.names(first) == ["solving", "solved"]
    result = solver.schedule.results.get(first)
    assert result is not None
    assert result.scene == b"go 1" * 1000
    assert result.answer.summary == {"text": "go 1"}
    runs = [first]
    for text in ("go 2", "go 3"):
        runs.append(submit(solver, text))
        events.wait("solved", runs[-1])
    assert [solver.schedule.results.get(run) is not None for run in runs] == [False, True, True]
    assert solver.schedule.get_current_events() == [("solved", events.wait("solved", runs[-1]))]
    assert solver.schedule.current is None


def test_a_preview_is_there_until_the_run_ends(make: Make, events: Events, tmp_path: Path) -> None:
    """It is of the combination that is looked at, of none when several are looked at."""
    solver, release = make(), tmp_path / "release"
    solver.shown = "ULS 1"
    run = submit(solver, f"preview {release}", 7)
    assert events.wait("preview", run) == {
        "run": run,
        "version": 7,
        "words": "of ULS 1",
        "figures": {"name": "ULS 1"},
    }
    assert (solver.schedule.get_preview(run), solver.schedule.get_preview(run + 1)) == (b"coarse", None)
    # a page that comes later sees it, too
    assert solver.schedule.get_current_events()[-1] == ("preview", events.wait("preview", run))
    # of the same model under a newer version it is, too
    assert submit(solver, f"preview {release}", 8) == run
    assert solver.schedule.get_current_events()[-1][1]["version"] == 8
    release.touch()
    events.wait("solved", run)
    assert solver.schedule.get_preview(run) is None
    solver.shown = None
    assert events.wait("preview", submit(solver, f"preview {release} "))["words"] == "of nothing"


def test_results_on_each_mesh_are_results(make: Make, events: Events, tmp_path: Path) -> None:
    """They have summary, scene and tables while the run goes on, are replaced by those on the next mesh, and say so."""
    solver, file = make(), tmp_path / "go"
    run = submit(solver, f"provisional {file}", 7)
    first = events.wait("provisional", run)
    assert (first["version"], first["provisional"], first["update"]) == (7, "mesh 1", 0)
    # the run goes on, and a page that comes later sees both
    assert [name for name, _ in solver.schedule.get_current_events()][:2] == ["provisional", "solving"]
    result = solver.schedule.results.get(run)
    assert result is not None
    assert (result.scene, result.answer.summary) == (b"first", {"text": "first"})
    assert b"first" in solver.make_view(("table", run, "words"))
    assert submit(solver, f"provisional {file}", 8) == run
    assert [about["version"] for name, about in events.events if name == "provisional"] == [7, 8]
    Path(f"{file}.first").touch()
    second = events.wait_for_update(run, 1)
    assert (second["provisional"], second["version"]) == ("mesh 2", 8)
    assert b"second" in solver.make_view(("table", run, "words"))
    Path(f"{file}.second").touch()
    last = events.wait("solved", run)
    assert (last["provisional"], last["update"]) == ("", 2)
    assert [name for name in events.names(run) if name != "provisional"] == ["solving", "solved"]


def test_provisional_results_stay_when_the_run_is_cancelled(make: Make, events: Events, tmp_path: Path) -> None:
    """With their tables; but the same model is solved again, as it is not solved yet."""
    solver, file = make(), tmp_path / "go"
    run = submit(solver, f"provisional {file}")
    events.wait("provisional", run)
    solver.cancel()
    events.wait("cancelled", run)
    ((name, about),) = solver.schedule.get_current_events()
    assert (name, about["run"], about["provisional"]) == ("provisional", run, "mesh 1")
    assert b"first" in solver.make_view(("table", run, "words"))
    again = submit(solver, f"provisional {file}")
    assert again != run
    for word in ("first", "second"):
        Path(f"{file}.{word}").touch()
    assert events.wait("solved", again)["provisional"] == ""


def test_tables_of_the_results_before_are_there_while_the_next_run_goes_on(
    make: Make, events: Events, tmp_path: Path
) -> None:
    """What is looked at does not wait for the end of a run."""
    solver = make()
    done = submit(solver, "go 1")
    events.wait("solved", done)
    running = submit(solver, f"wait {tmp_path / 'never'}")
    events.wait("progress", running)
    assert b"go" in solver.make_view(("table", done, "words"), PATIENCE)


def test_the_newest_state_replaces_the_one_that_is_solved(make: Make, events: Events, tmp_path: Path) -> None:
    """A newer state stops the run between two steps; what was asked for in between is never begun."""
    solver = make()
    first = submit(solver, f"wait {tmp_path / 'never'}")
    events.wait("progress", first)
    second, third = submit(solver, "go 2", delay=60.0), submit(solver, "go 3")
    events.wait("solved", third)
    assert events.names(first) == ["solving", "cancelled"]
    assert events.names(second) == []


def test_a_state_waits_until_the_user_pauses(make: Make, events: Events) -> None:
    """Of states that follow each other faster than the delay only the last is solved."""
    solver = make()
    runs = [submit(solver, f"go {number}", delay=30.0) for number in range(5)]
    runs.append(submit(solver, "go 5", delay=0.1))
    events.wait("solved", runs[-1])
    assert [events.names(run) for run in runs[:-1]] == [[]] * 5


def test_a_run_that_does_not_listen_is_ended(
    make: Make, events: Events, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run stuck in a long step is ended with its process after the grace; the next one runs in a new process."""
    monkeypatch.setattr(solvers, "GRACE", 0.2)
    solver = make()
    first = submit(solver, f"stuck {tmp_path / 'never'}")
    wait_until_stuck(tmp_path / "never")
    start = time.monotonic()
    second = submit(solver, "go 2")
    events.wait("solved", second)
    assert time.monotonic() - start >= 0.2
    assert events.names(first) == ["solving", "cancelled"]


def test_cancelling_is_reported_at_once(
    make: Make, events: Events, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run stuck in a long step is over for the pages at once, long before its process is ended; nothing follows."""
    monkeypatch.setattr(solvers, "GRACE", PATIENCE)
    solver, release_file = make(), tmp_path / "release"
    run = submit(solver, f"stuck {release_file}")
    wait_until_stuck(release_file)
    start = time.monotonic()
    solver.cancel()
    events.wait("cancelled", run)
    assert time.monotonic() - start < PATIENCE / 2
    assert (solver.schedule.current, solver.schedule.get_current_events()) == (None, [])
    release_file.touch()  # the run ends with results, which nobody wants any more
    events.wait("solved", submit(solver, "go 2", 2))
    assert events.names(run) == ["solving", "cancelled"]


def test_what_was_told_before_cancelling_stays(
    make: Make, events: Events, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that does not listen is not ended while its tables would be lost, unless there is more to do."""
    monkeypatch.setattr(solvers, "GRACE", 0.1)
    solver, release_file = make(), tmp_path / "release"
    run = submit(solver, f"keeping {release_file}")
    events.wait("provisional", run)  # the server has heard of it, too
    wait_until_stuck(release_file)
    solver.cancel()
    events.wait("cancelled", run)
    release = threading.Timer(0.5, release_file.touch)  # a step that takes five times the grace
    release.start()
    assert b"kept" in solver.make_view(("table", run, "words"), PATIENCE)
    other = submit(solver, f"keeping {tmp_path / 'never'}")
    wait_until_stuck(tmp_path / "never")
    solver.cancel()
    events.wait("cancelled", other)
    events.wait("solved", submit(solver, "go 3"))


def test_cancelling(make: Make, events: Events, tmp_path: Path) -> None:
    """What is solved stops, what waits is forgotten; both are reported; results from before stay."""
    solver = make()
    done = submit(solver, "go 1")
    events.wait("solved", done)
    running = submit(solver, f"wait {tmp_path / 'never'}")
    events.wait("progress", running)
    assert solver.schedule.current is not None
    assert (solver.schedule.current.run, solver.schedule.current.version) == (running, 1)
    assert [name for name, _ in solver.schedule.get_current_events()] == ["solved", "solving", "progress"]
    solver.cancel()
    events.wait("cancelled", running)
    waiting = submit(solver, "go 2", delay=60.0)
    solver.cancel()
    events.wait("cancelled", waiting)
    assert solver.schedule.current is None
    assert solver.schedule.results.latest is not None
    assert solver.schedule.results.latest.run == done
    solver.cancel()  # nothing to do


def test_what_means_the_same_is_not_solved_again(make: Make, events: Events, tmp_path: Path) -> None:
    """The same state under a newer version keeps run and results, while it runs and when it is done."""
    solver, release_file = make(), tmp_path / "release"
    first = submit(solver, f"wait {release_file}", 1)
    events.wait("progress", first)
    assert submit(solver, f"wait {release_file}", 2) == first
    release_file.touch()
    assert events.wait("solved", first)["version"] == 2
    assert submit(solver, f"wait {release_file}", 3) == first
    assert solver.schedule.results.latest is not None
    assert solver.schedule.results.latest.version == 3
    assert events.names(first) == ["solving", "solved", "solved"]
    again = submit(solver, f"wait {release_file}", 3, force=True)
    assert again != first
    events.wait("solved", again)


def test_going_back_to_what_is_solved(make: Make, events: Events, tmp_path: Path) -> None:
    """Undone while something else is being solved: the known results count at once, and are announced last."""
    solver = make()
    first = submit(solver, "go 1")
    events.wait("solved", first)
    second = submit(solver, f"wait {tmp_path / 'never'}", 2)
    events.wait("progress", second)
    assert submit(solver, "go 1", 3) == first
    events.wait("cancelled", second)
    assert events.wait_for_last("solved", first)["version"] == 3


@pytest.mark.parametrize(
    ("word", "words"),
    [
        ("issue", "mesh.size: found"),
        ("refuse", "no"),
        ("memory", "not enough memory"),
        ("bug", "an error in groundslab itself: ZeroDivisionError"),
    ],
)
def test_what_cannot_be_solved_is_refused(make: Make, events: Events, word: str, words: str) -> None:
    """Errors of all kinds are reported in words, issues with their paths; the process lives on."""
    solver = make()
    run = submit(solver, word, 5)
    data = events.wait("refused", run)
    assert words in data["message"]
    assert data["version"] == 5
    assert [issue["path"] for issue in data["issues"]] == ([["mesh", "size"]] if word == "issue" else [])
    events.wait("solved", submit(solver, "go"))


@pytest.mark.parametrize(("word", "how"), [("die", "SIGKILL"), ("leave", "exit code 3")])
def test_a_crash_is_reported_and_survived(make: Make, events: Events, word: str, how: str) -> None:
    """A process that is killed or leaves is reported, with how; the next run has a new one."""
    solver = make()
    events.wait("solved", submit(solver, "go"))
    run = submit(solver, word)
    message = events.wait("refused", run)["message"]
    assert "ended unexpectedly" in message
    assert how in message or how == "SIGKILL"
    assert solver.schedule.results.latest is not None
    events.wait("solved", submit(solver, "go on"))


def test_a_process_that_never_gets_ready_is_not_started_for_ever(make: Make, events: Events) -> None:
    """After some failed starts the state is refused; the next state is tried again."""
    solver = make(prepare=workers.Broken())
    for text in ("go 1", "go 2"):
        assert "exit code 4" in events.wait("refused", submit(solver, text, delay=0.5))["message"]
    with pytest.raises(InputError, match="cannot be started"):
        solver.make_view(("report", 1, "x"))


def test_preparing_gives_way(make: Make, events: Events) -> None:
    """What the process does to get ready stops as soon as there is something to solve."""
    events.wait("solved", submit(make(prepare=workers.prepare_for_ever), "go"))


def test_results_of_another_document_are_forgotten(make: Make, events: Events, tmp_path: Path) -> None:
    """When the document changes, results go, and those of the run that still runs do not come."""
    solver, release_file = make(), tmp_path / "release"
    events.wait("solved", submit(solver, "go"))
    run = submit(solver, f"stuck {release_file}")
    events.wait("solving", run)
    solver.reset()
    release_file.touch()
    events.wait("cancelled", run)
    assert solver.schedule.results.latest is None


TWO = """
[plate]
length_x = "2 m"
length_y = "2 m"
thickness = "200 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "20 MPa/m"
[mesh]
counts = [4, 4]
[[cases]]
name = "down"
[[cases]]
name = "up"
[[loads]]
case = "down"
kind = "uniform"
q = "10 kPa"
[[loads]]
case = "up"
kind = "uniform"
q = "-10 kPa"
"""


def test_the_analysis_behind_it() -> None:
    """Two load cases, one of which lifts the plate off: progress, summary and scene of one, the other's refusal."""
    said: list[tuple[str, float | None, str]] = []
    answer, scene, solved = process.solve(TWO, Progress(lambda *words: said.append(words)))
    assert solved.text == TWO
    assert list(solved.results.results) == ["down"]
    assert list(answer.refused) == ["up"]
    assert [(words, share) for words, share, details in said if details.endswith("begins")] == [
        ("combination 1 of 2", 0.0),
        ("combination 2 of 2", 0.5),
    ]
    assert [details for words, _, details in said if "contact" in words or "unknowns" in words] == []
    down, up = answer.summary["combinations"]
    assert (up["refused"], up["certificate"], up["sections"]) == (answer.refused["up"], None, [])
    assert down["refused"] is None
    assert down["certificate"]["holds"] is True
    rows = {row["key"]: row for section in down["sections"] for row in section["rows"]}
    # 10 kPa on springs of 20 MPa/m: the plate settles evenly, by 0.5 mm
    assert (rows["largest"]["value"], rows["largest"]["unit"]) == ("0.50000", "mm")
    assert (rows["residual"]["ok"], rows["residual"]["note"]) == (True, "ok (limit 1e-06)")
    data = unpack(scene).head["combinations"]
    assert [(each["name"], each["certified"]) for each in data] == [("down", True), ("up", False)]
    with pytest.raises(process.Stopped):
        process.solve(TWO, Progress(_stop))


def test_a_preview_is_of_the_combination_that_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """It has that combination and its figures alone, on another mesh; of one without equilibrium there is none."""
    for shown, names in (("down", [["down"]]), ("", [["down"]]), ("up", []), (None, [])):
        previews: list[tuple[dict[str, Any], bytes]] = []
        tell, show = (lambda *_: None), (lambda _, *shown, previews=previews: previews.append(shown))
        monkeypatch.setattr(process, "PREVIEW_AFTER", 0.0)
        _, scene, _ = process.solve(TWO, Progress(tell, show, shown))
        heads = [unpack(each).head for _, each in previews]
        assert [figures["name"] for figures, _ in previews] == [name for each in names for name in each]
        assert all(figures["certificate"]["holds"] and figures["sections"] for figures, _ in previews)
        assert [[one["name"] for one in head["combinations"]] for head in heads] == names
        assert all(head["mesh"]["nodes"] != unpack(scene).head["mesh"]["nodes"] for head in heads)


def test_a_preview_of_a_combination_that_is_gone_is_of_the_largest(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the one with the largest sum of factors, so that no picture of another model stays."""
    combinations = "".join(
        f'\n[[combinations]]\nname = "{name}"\nfactors = {{ down = {factor} }}\n'
        for name, factor in (("ULS 1", 1.0), ("ULS 2", 1.35))
    )
    previews: list[str] = []
    monkeypatch.setattr(process, "PREVIEW_AFTER", 0.0)
    show = lambda _words, figures, _scene: previews.append(figures["name"])  # noqa: E731
    for shown in ("down", "ULS 1", ""):
        process.solve(TWO + combinations, Progress(lambda *_: None, show, shown))
    assert previews == ["ULS 2", "ULS 1", "ULS 1"]


@pytest.mark.parametrize(
    ("before", "much", "shows"),
    [(None, 33, False), (None, 31, True), (process.SLOW, 31, False), (1.01 * process.SLOW, 33, True)],
)
def test_a_quick_run_has_no_preview(
    monkeypatch: pytest.MonkeyPatch, before: float | None, much: int, shows: bool
) -> None:
    """Its results are there before anybody could look at one: by the run before, else by elements and combinations."""
    previews: list[bytes] = []
    monkeypatch.setattr(process, "PREVIEW_AFTER", PATIENCE)
    monkeypatch.setattr(process, "MUCH_WORK", much)
    show = lambda *shown: previews.append(shown[-1])  # noqa: E731
    answer, _, _ = process.solve(TWO, Progress(lambda *_: None, show, "down", before=before))
    assert bool(previews) is shows
    assert 0.0 < answer.first <= answer.seconds


@pytest.mark.parametrize(
    ("more", "shows"), [("", False), ('\n[[plate.openings]]\nkind = "circle"\nradius = "0.5 m"\n', True)]
)
def test_a_mesh_for_an_accuracy_begins_with_a_preview(monkeypatch: pytest.MonkeyPatch, more: str, shows: bool) -> None:
    """It follows all that is on a slab, so that its size does not tell the work; a plain rectangle has none."""
    previews: list[bytes] = []
    monkeypatch.setattr(process, "PREVIEW_AFTER", PATIENCE)
    show = lambda *shown: previews.append(shown[-1])  # noqa: E731
    text = casefile.starter() + '\n[mesh]\naccuracy = "50 %"\n\n' + more
    process.solve(text, Progress(lambda *_: None, show, ""))
    assert bool(previews) is shows


def test_every_mesh_but_the_last_has_provisional_results() -> None:
    """On the first one at once and again with checks and tables, on the others with them; it goes on from each."""
    kept: list[tuple[Answer, bytes, process.Solved]] = []
    said: list[str] = []
    text = TWO.replace("counts = [4, 4]", 'accuracy = "0.2 %"').replace(
        'kind = "uniform"', 'kind = "point"\nx = "0 m"\ny = "0 m"'
    )
    text = text.replace('q = "10 kPa"', 'P = "100 kN"').replace('q = "-10 kPa"', 'P = "10 kN"')
    tell = lambda words, *_: said.append(words)  # noqa: E731
    last, _, _ = process.solve(text, Progress(tell, keep=lambda *outcome: kept.append(outcome)))
    (first, scene, _), (checked, _, solved), *_ = kept
    assert "design" not in first.summary
    assert "checks" in checked.summary["design"]
    assert first.provisional.startswith("Provisional: mesh 1 (")
    assert first.summary["coarse"] == first.provisional
    assert [one["name"] for one in unpack(scene).head["combinations"]] == ["down", "up"]
    assert solved.results.provisional
    assert first.tables == ()
    assert tuple(solved.tables) == checked.tables
    assert "extremes" in checked.tables
    assert b"Provisional: mesh 1 (" in process._write_report(solved, "slab.toml", lambda *_: None)
    assert last.provisional == ""
    assert 0.0 < first.first == checked.first == last.first < last.seconds
    assert any(words.startswith("combination 1 of 2, mesh 2") for words in said)


def _stop(*_: object) -> None:
    raise process.Stopped


def test_reports_of_runs_that_are_gone(make: Make, events: Events, tmp_path: Path) -> None:
    """A report on what the process does not know any more is refused, as is one whose process ends."""
    solver = make()
    first, second = submit(solver, "go 1"), 0
    events.wait("solved", first)
    second = submit(solver, "go 2")
    events.wait("solved", second)
    with pytest.raises(InputError, match="solve again"):
        solver.make_view(("report", first, "x"))
    waits = submit(solver, f"stuck {tmp_path / 'never'}")
    events.wait("solving", waits)
    refused = threading.Event()

    def ask() -> None:
        with pytest.raises(InputError, match="the server ends"):
            solver.make_view(("report", second, "x"))
        refused.set()

    asking = threading.Thread(target=ask)
    asking.start()
    solver.close()
    asking.join(PATIENCE)
    assert refused.is_set()


class Kept:
    """A pipe that keeps what is sent."""

    def __init__(self) -> None:
        self.messages: list[object] = []
        self.content = b""

    def send(self, message: object) -> None:
        """Keep a message."""
        self.messages.append(message)

    def send_bytes(self, content: bytes) -> None:
        """Keep the bytes that follow it."""
        self.content = content


SOFT = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "continuum"
half_space = {E = "20 MPa", nu = 0.3}
[mesh]
size = "1 m"
[[loads]]
kind = "uniform"
q = "50 kPa"
[report]
chapters = %s
"""


@pytest.mark.slow
@pytest.mark.parametrize(("chapters", "compared"), [('["extremes", "grounds"]', True), ('["extremes"]', False)])
def test_the_report_compares_grounds_where_the_case_lists_that_chapter(chapters: str, compared: bool) -> None:
    """The workbench has no command for it: the chapter's name in the case asks for the comparison."""
    *_, solved = process.solve(SOFT % chapters, Progress(lambda *_: None))
    pipe = Kept()
    process._send_view(pipe, ("report", 1, "slab.toml"), (1, solved))
    *making, last = pipe.messages
    assert last == ("view", ("report", 1, "slab.toml"), "")
    # before each chapter its title, and the share that is made
    titles = ["Extreme values", *(["Ground models compared"] if compared else [])]
    assert making == [("making", 1, title, number / len(titles)) for number, title in enumerate(titles)]
    assert (b"Ground models compared" in pipe.content) is compared


#: A strip to be reinforced.
STRIP_TO_REINFORCE = """# a strip
[plate]
length_x = "4 m"
length_y = "2 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "30 MPa/m"
[mesh]
size = "0.5 m"
[[cases]]
name = "G"
[[loads]]
kind = "point"
P = "300 kN"
x = "0 m"
y = "0 m"
case = "G"
[[combinations]]
name = "one"
limit_state = "ultimate"
factors = {G = 1.35}
[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["50 mm", "62 mm"]
top = ["50 mm", "62 mm"]
"""


def test_bars_are_proposed_as_a_text_of_the_case() -> None:
    """The text has bars in all layers, and what stands above with its comments; without reinforcement it says so."""
    text = STRIP_TO_REINFORCE
    pipe = Kept()
    for run, case in enumerate((text, text.partition("[reinforcement]")[0])):
        *_, solved = process.solve(case, Progress(lambda *_: None))
        process._send_view(pipe, ("bars", run, "."), {run: solved})
    (_, _, first), (_, _, second) = pipe.messages
    assert first == ""
    assert "[reinforcement]" in second[0].expected
    made = casefile.loads(pipe.content.decode())
    assert pipe.content.startswith(b"# a strip")
    assert made.reinforcement is not None
    assert made.reinforcement.laid


def test_an_accuracy_that_was_asked_for_is_not_written_with_bars() -> None:
    """What is put into the case has the accuracy of the case, whatever the run was solved to."""
    text = STRIP_TO_REINFORCE.replace('size = "0.5 m"\n', "")
    *_, solved = process.solve(text, Progress(lambda *_: None, accuracy="draft"))
    pipe = Kept()
    process._send_view(pipe, ("bars", 1, "."), (1, solved))
    assert casefile.loads(solved.text).mesh.accuracy == "draft"
    assert casefile.loads(pipe.content.decode()).mesh == casefile.loads(text).mesh
