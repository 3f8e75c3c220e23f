"""What a run will cost: from the work there is, the accuracy, and how fast the machine was."""

from __future__ import annotations

import math
import tomllib

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.workbench.checking.work import Work, WorkCounter, count_work
from groundslab.workbench.solver import cost
from groundslab.workbench.solver.answer import Answer
from groundslab.workbench.solver.schedule import Schedule

TEXT = casefile.starter()


def make_answer(seconds: float, unknowns: int, accuracy: float | None = 0.05) -> Answer:
    """Return the answer of a run with two combinations."""
    summary = {"combinations": [{"name": "1"}, {"name": "2"}]}
    return Answer(seconds, {}, summary, unknowns=unknowns, meshes=2, accuracy=accuracy)


def test_a_run_at_the_measured_rate_takes_as_long_as_the_one_that_told_it() -> None:
    """The rate of a run, applied to its own work, gives its time; one that was too short tells none."""
    answer = make_answer(8.0, 40_000)
    rate = cost.measure_rate(answer)
    assert rate is not None
    again = cost.estimate(cost.find_work(answer), 0.05, rate)
    assert again.seconds == pytest.approx(8.0, rel=1e-4)
    assert again.unknowns == pytest.approx(40_000, abs=2)
    assert cost.measure_rate(make_answer(0.4, 40_000)) is None
    assert cost.measure_rate(make_answer(8.0, 0)) is None


def test_accuracy_costs_more_the_smaller_it_is() -> None:
    """In unknowns, meshes and time; a mesh that is given has one cost, and a run that is known its own."""
    work = Work(12, 30_000, 0.05)
    costs = cost.list_costs(work, 80_000.0, ("strict", make_answer(33.0, 61_000)))
    assert set(costs) == {"", "draft", "normal", "strict"}
    assert costs[""] == costs["normal"]
    assert costs["draft"]["meshes"] == 1
    assert costs["draft"]["unknowns"] < costs["normal"]["unknowns"]
    assert costs["draft"]["seconds"] < costs["normal"]["seconds"]
    assert (costs["strict"]["unknowns"], costs["strict"]["seconds"], costs["strict"]["meshes"]) == (61_000, 33.0, 2)
    given = cost.list_costs(Work(12, 30_000, None), 80_000.0)
    assert list(given) == [""]
    assert (given[""]["unknowns"], given[""]["meshes"]) == (30_000, 1)


def test_an_accuracy_is_put_into_the_text_that_is_solved() -> None:
    """And nothing else; without one the text stays."""
    assert cost.with_accuracy(TEXT, "") is TEXT
    changed = cost.with_accuracy(TEXT, "draft")
    assert tomllib.loads(changed) == tomllib.loads(TEXT) | {"mesh": {"accuracy": "draft"}}


def test_the_mesher_counts_what_is_solved_then() -> None:
    """To a fifth, as it counts on the coarser mesh; of a text that describes no model there is nothing."""
    text = TEXT + '\n[mesh]\ncounts = [16, 16]\nsymmetry = "off"\n'
    work = count_work(text)
    (solved,) = groundslab.solve(casefile.loads(text)).values()
    assert (work.combinations, work.accuracy) == (1, None)
    assert work.unknowns == pytest.approx(solved.unknowns, rel=0.2)
    counter = WorkCounter()
    try:
        assert counter.count("one", text) == work
        assert counter.count("none", "[plate]") is None
    finally:
        counter.close()


def test_no_accuracy_is_asked_of_a_given_mesh() -> None:
    """Elements of a given size are solved as they are, whatever was chosen before."""
    given = TEXT + '\n[mesh]\nsize = "1 m"\n'
    assert cost.with_accuracy(given, "draft") == given
    assert casefile.loads(cost.with_accuracy(TEXT, "draft")).mesh.accuracy == "draft"
    assert cost.with_accuracy(TEXT, "") == TEXT


def test_a_run_keeps_the_accuracy_that_it_was_asked_for() -> None:
    """What is chosen while it waits is for the next one."""
    schedule = Schedule(lambda _name, _about: None)
    schedule.submit("text", 1, ("one", "strict"), 0.0, force=True, accuracy="strict")
    job = schedule.begin(math.inf)
    assert job is not None
    assert job.accuracy == "strict"
