"""The bench's own logic: what is foreseen, resumed and reported. Nothing is timed here."""

from __future__ import annotations

import importlib
import json
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from groundslab.errors import InputError, Issue
from helpers.paths import ROOT

BENCH = ROOT / "bench"


@pytest.fixture
def report(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module that makes the page."""
    monkeypatch.syspath_prepend(str(BENCH))
    return importlib.import_module("report")


@pytest.fixture
def run(report: ModuleType, monkeypatch: pytest.MonkeyPatch) -> ModuleType:  # noqa: ARG001
    """The runner."""
    return importlib.import_module("run")


def row(unknowns: int, total: float, centre: float = 1.0, corner: float = -1.0) -> dict[str, Any]:
    """Return the figures of a job."""
    return {
        "unknowns": unknowns,
        "total [s]": total,
        "whole process [s]": total + 1,
        "iterations": 5,
        "peak memory [MiB]": 100.0,
        "settlement at the centre [m]": centre,
        "settlement at the corner [m]": corner,
    }


def results(**parts: Any) -> dict[str, Any]:
    """Return results with only some parts in them."""
    empty = {"own": {}, "peers": {}, "small": {}, "machine": {}, "packages": {}, "cap [s]": 600.0}
    return {**empty, "date": "2026-01-01", "commit": "abc", **parts}


def test_the_page_has_a_place_for_every_table(report: ModuleType) -> None:
    """All markers of docs/performance.md and all tables belong together, with or without results."""
    page = report.PAGE.read_text(encoding="utf-8")
    filled = report.filled(page, report.tables(results()))
    assert report.filled(filled, report.tables(results())) == filled
    assert "Not measured yet." in filled


def test_prose_around_markers_stays(report: ModuleType) -> None:
    """Only what stands between the markers changes; an unknown or a missing marker is an error."""
    page = "before\n<!-- begin a -->old<!-- end a -->\nafter"
    assert report.filled(page, {"a": "new"}) == "before\n<!-- begin a -->\n\nnew\n\n<!-- end a -->\nafter"
    with pytest.raises(ValueError, match="no table"):
        report.filled(page, {})
    with pytest.raises(ValueError, match="no markers for b"):
        report.filled(page, {"a": "new", "b": "more"})


def test_verdicts(report: ModuleType) -> None:
    """A figure is held against both limits, from the side that the target says."""
    less = report.Target("", 3, 2, lambda _: None)
    assert [less.verdict(report.Measured(x)) for x in (2, 2.5, 3.1)] == ["aim", "at least", "missed"]
    more = report.Target("", 3, 10, lambda _: None, less=False)
    assert [more.verdict(report.Measured(x)) for x in (10, 3, 2.9)] == ["aim", "at least", "missed"]
    assert less.verdict(None) == "not measured"


def test_a_peer_that_was_cut_off_counts_with_the_cap(report: ModuleType) -> None:
    """Against every peer the slowest ratio counts, and a peer cut off counts with what it surely took."""
    mine = {"250k": row(248_000, 2.0)}
    slow = {"250k": {"not reached": True}}
    found = report.against_every_peer(results(peers={"groundslab": mine, "slow": slow}))
    assert (found.value, found.at_least) == (300.0, True)
    found = report.against_every_peer(results(peers={"groundslab": mine, "slow": slow, "fast": {"250k": row(1, 9.0)}}))
    assert (found.value, found.at_least) == (4.5, False)


def test_errors_below_the_reference_are_not_told(report: ModuleType) -> None:
    """The reference is the mean of two programs' finest meshes; smaller errors than their difference are bounds."""
    ours = {"6k": row(6_000, 1, 2.0), "25k": row(25_000, 1, 1.0)}
    other = {"6k": row(6_000, 1, 1.002)}
    to = report.reference(results(peers={"groundslab": ours, "NGSolve, order 4": other}))
    assert to.value["centre"] == pytest.approx(1.001)
    assert to.apart["centre"] == pytest.approx(0.002 / 1.001)
    assert report.scientific(report.error(ours["25k"], "centre", to), to, "centre") == "< 4e-03"
    assert report.scientific(report.error(ours["6k"], "centre", to), to, "centre") == "1e+00"


def test_the_mesh_from_which_on_errors_are_small_counts(report: ModuleType) -> None:
    """A coarse mesh that is right by accident does not count; one made for an accuracy says what it missed."""

    def solved(unknowns: int, error: float) -> dict[str, Any]:
        return row(unknowns, unknowns / 1000) | {"errors": {"moment": error}}

    meshes = [solved(100, 0.001), solved(1000, 0.02), solved(2000, 0.009), solved(4000, 0.002)]
    load = {
        "reference": {"moment": 1.0},
        "apart": {"moment": 1e-6},
        "adaptive": [solved(500, 0.004), solved(1500, 0.003)],
        "uniform": {"other": meshes},
    }
    accuracies = {"limits": [0.01, 0.001], "loads": {"2.4": load}, "date": "2026-01-01", "commit": "abc"}
    ours, other = report.accuracy_rows(accuracies).splitlines()[4:6]
    assert [cell.strip() for cell in ours.split("|")[2:4]] == ["0.500 (500)", "1.50 (1,500, off by 0.3 %)"]
    assert [cell.strip() for cell in other.split("|")[2:4]] == ["2 (2,000)", "-"]


def test_labels_move_apart_in_order(report: ModuleType) -> None:
    """Labels keep their order and get their gap."""
    places = report.spread([0.0, 0.01, 5.0, -0.01], 0.1)
    assert places[2] == 5.0
    assert places[3] + 0.1 == pytest.approx(places[0], abs=1e-6)
    assert places[0] + 0.1 == pytest.approx(places[1], abs=1e-6)


def test_what_is_foreseen(run: ModuleType) -> None:
    """Time grows on with the power with which it grew last, and at least in proportion."""
    assert run.predicted([(10, 1.0)], 40) == pytest.approx(4.0)
    assert run.predicted([(10, 1.0), (20, 4.0)], 40) == pytest.approx(16.0)
    assert run.predicted([(10, 1.0), (20, 1.1)], 40) == pytest.approx(2.2)


def test_sizes_out_of_reach_are_not_run(run: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A peer stops ascending where the next size would exceed the cap; a resumed run asks for nothing."""
    asked: list[list[str]] = []

    def repeated(_environment: str, command: list[str], _times: int) -> dict[str, Any]:
        asked.append(command)
        n = int(command[1])
        return row(n, (n / 1000) ** 2 / 2)

    monkeypatch.setattr(run, "repeated", repeated)
    monkeypatch.setattr(run, "say", lambda _text: None)
    ledger = run.Ledger.opened(tmp_path / "work.jsonl", resume=False)
    run.peer_jobs(ledger, ["PyNite"], list(run.SIZES), 1)
    assert [command[1] for command in asked] == ["6700", "26400"]
    entries = {key.split("/")[-1]: entry for key, entry in ledger.entries.items()}
    assert all(entries[size]["not reached"] and entries[size]["predicted [s]"] > 600 for size in ("100k", "250k", "1M"))

    again = run.Ledger.opened(tmp_path / "work.jsonl", resume=True)
    assert again.entries == ledger.entries
    run.peer_jobs(again, ["PyNite"], list(run.SIZES), 1)
    assert len(asked) == 2


def test_a_torn_line_is_forgotten(run: ModuleType, tmp_path: Path) -> None:
    """An interrupted run may leave half a line; that job is done again, and so is one that failed."""
    path = tmp_path / "work.jsonl"
    path.write_text(json.dumps({"key": "a"}) + "\n" + json.dumps({"key": "b", "error": "x"}) + '\n{"key": "c', "utf-8")
    ledger = run.Ledger.opened(path, resume=True)
    assert [run.finished(ledger, key) for key in "abc"] == [True, False, False]
    ledger.add("c", {"total [s]": 1.0})
    assert run.finished(run.Ledger.opened(path, resume=True), "c")


def test_figures_are_found_among_other_output(run: ModuleType) -> None:
    """The last line that is a JSON object counts, whatever the program prints around it."""
    assert run.last_figures('{"a": 1}\nbanner\n{"a": 2}\nProcess 0 Terminating\n{broken') == {"a": 2}
    assert run.last_figures("nothing") == {}


def test_timed_phases_are_functions_of_the_package(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every phase that a job times names a function that its module calls by that name."""
    monkeypatch.syspath_prepend(str(BENCH))
    phases = importlib.import_module("job").PHASES
    assert len(phases) > 10
    assert not [(phase, name) for phase, module, name in phases if not callable(getattr(module, name, None))]


@pytest.fixture
def spoilt(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The job that reads spoilt inputs."""
    monkeypatch.syspath_prepend(str(BENCH))
    return importlib.import_module("spoilt_inputs")


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="a process of its own for each input, as Linux has them")
def test_spoilt_inputs_are_read_or_refused(tmp_path: Path) -> None:
    """Of two dozen inputs none raises anything but an error of groundslab's own, or takes long or much memory.

    In a process of its own: what the tests before have left in memory would count.
    """
    program = "import json, spoilt_inputs; print(json.dumps(spoilt_inputs.main(24, 3)))"
    environment = os.environ | {"PYTHONPATH": str(BENCH)}
    run = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, env=environment, capture_output=True, text=True, check=True
    )
    figures = json.loads(run.stdout.splitlines()[-1])
    assert figures["failures"] == []
    assert figures["inputs"] == sum(figures["outcomes"].values()) == 24
    assert {outcome.partition(":")[0] for outcome in figures["outcomes"]} >= {"case", "drawing", "archive", "study"}


@pytest.mark.skipif(sys.platform != "linux", reason="a process of its own for each input, as Linux has them")
def test_what_is_no_refusal_is_found(spoilt: ModuleType, tmp_path: Path) -> None:
    """Another error has its traceback kept, one too large for the memory is known, a refusal is none of them."""

    def fails(_: Path) -> None:
        raise ValueError("mine")

    def refuses(_: Path) -> None:
        raise InputError([Issue("here", "this", "that")])

    log = tmp_path / "log.txt"
    assert spoilt.attempt(fails, tmp_path, log)[0] == spoilt.TRACEBACK
    assert "ValueError: mine" in log.read_text(encoding="utf-8")
    assert spoilt.attempt(refuses, tmp_path, log)[0] == spoilt.REFUSED
    assert spoilt.attempt(lambda _: bytearray(10**11), tmp_path, log)[0] == spoilt.NO_MEMORY
    assert spoilt.attempt(lambda _: None, tmp_path, log)[0] == spoilt.ACCEPTED


def test_json_that_is_nested_too_deeply(tmp_path: Path) -> None:
    """A comparison of grounds and unsaved work of a hundred thousand brackets are refused, without a traceback."""
    from groundslab.views.ground_comparison.files import load_comparison
    from groundslab.workbench.persistence.autosave import HEAD, read_unsaved

    (tmp_path / "ground-comparison.json").write_text("[" * 100_000)
    with pytest.raises(InputError):
        load_comparison(tmp_path)
    (tmp_path / "x.unsaved").write_text(HEAD + "[" * 100_000)
    assert read_unsaved(tmp_path / "x.unsaved") is None
