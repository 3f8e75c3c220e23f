"""The count of combinations and the time that is left."""

from __future__ import annotations

from dataclasses import replace

import pytest

from groundslab.model.loads.load_cases import Combination
from groundslab.results.records import Step
from groundslab.views.summary.progress import INTERVAL, CombinationCount, in_file


def test_the_time_left_follows_from_the_combinations_that_are_done() -> None:
    """The first, which takes the meshing too, does not count; the present one takes off what it has taken."""
    now = [0.0]
    count = CombinationCount(12, lambda: now[0])
    times = [("A", 0.0), ("B", 30.0), ("C", 32.0), ("D", 36.0)]
    words = []
    for name, now[0] in times:
        count.begin(name)
        words.append(count.words())
    assert words == [
        "1 of 12, A: ",
        "2 of 12, B: ",
        "3 of 12, C, about 20 s left on this mesh: ",  # ten of 2 s
        "4 of 12, D, about 27 s left on this mesh: ",  # nine of 3 s
    ]
    now[0] = 37.0
    assert count.seconds_left() == pytest.approx(26.0)
    assert count.share == 3 / 12
    now[0] = 100.0
    assert count.words() == "4 of 12, D: "  # it takes longer than the others: nothing is promised


def test_each_mesh_begins_from_the_first() -> None:
    """The second mesh, which is finer, is not judged by the first; a single combination has no count."""
    now = [0.0]
    count = CombinationCount(3, lambda: now[0])
    for name, now[0] in (("A", 0.0), ("B", 1.0), ("C", 2.0)):
        count.begin(name)
    assert count.seconds_left() == pytest.approx(1.0)
    now[0] = 3.0
    count.begin("A")
    assert (count.share, count.seconds_left()) == (0.0, None)
    assert CombinationCount(1).words() == ""
    assert CombinationCount(1).share is None


def test_the_number_of_the_mesh_is_told_where_there_may_be_several() -> None:
    """It grows with each mesh, on which the combinations begin anew even if not all were solved on the one before."""
    one, several = CombinationCount(1, mesh=1), CombinationCount(3, mesh=2)
    assert one.words() == "mesh 1: "
    several.begin("A")
    several.begin("B")
    assert several.words() == "mesh 2, 2 of 3, B: "
    several.begin_mesh()
    several.begin("A")
    assert several.words() == "mesh 3, 1 of 3, A: "


def test_engineers_read_what_is_solved_and_whether_the_slab_lifts_off() -> None:
    """No unknowns, no gamma, no nodes in contact; nothing at all where one combination is solved on one mesh."""
    now = [0.0]
    count = CombinationCount(12, lambda: now[0], mesh=2)
    for name, now[0] in (("A", 0.0), ("B", 30.0), ("C", 32.0)):
        count.begin(name)
    place, left = "combination 3 of 12, mesh 2", "about 20 s left on this mesh"
    assert count.describe() == f"{place}, {left}"
    step = Step(12_400, 1, 2.0086, 1, 977, 0, finest=True)
    assert count.describe(step) == f"{place}, {left}"
    lifted = replace(step, iteration=2, changed=11)
    assert count.describe(lifted) == f"{place}, where the slab lifts off (step 2), {left}"
    assert CombinationCount(1).describe(step) == ""
    assert (
        CombinationCount(1).describe(replace(lifted, increment=3)) == "load step 3, where the slab lifts off (step 2)"
    )


def test_a_file_gets_a_line_every_ten_seconds() -> None:
    """None in the first ten, then none that follows another one within ten; each says what is done and what is left."""
    now, lines = [100.0], list[str]()

    def clock() -> float:
        return now[0]

    def step(at: float, iteration: int) -> None:
        now[0] = at
        progress(Step(2400, 1, None, iteration, 90, 3, finest=True))

    def begin(at: float, name: str) -> None:
        now[0] = at
        progress.begin(Combination(name=name, factors={"dead": 1.0}))

    with in_file(CombinationCount(4, clock, mesh=1), lines.append, clock) as progress:
        begin(100.0, "A")
        step(109.9, 1)
        begin(110.0, "B")
        step(112.0, 1)
        begin(114.0, "C")
        step(119.9, 1)
        step(121.0, 2)
        progress.begin_mesh()
        begin(125.0, "A")
        step(199.0, 7)
    assert lines == [
        "10 s: mesh 1, 2 of 4, B: begins",
        "21 s: mesh 1, 3 of 4, C, about 1 s left on this mesh: 2400 unknowns, load 1, contact 2: 90 closed, 3 changed",
        "99 s: mesh 2, 1 of 4, A: 2400 unknowns, load 1, contact 7: 90 closed, 3 changed",
    ]
    assert INTERVAL == 10.0


def test_a_mesh_on_which_few_are_solved_ends_when_one_begins_again() -> None:
    """Those that govern are counted on each mesh; the others follow on the last one."""
    count = CombinationCount(4, lambda: 0.0)
    words = []
    for name in ("A", "B", "C", "D", "B", "D", "B", "D", "A", "C"):
        count.begin(name)
        words.append(count.words())
    assert words[4:] == ["1 of 4, B: ", "2 of 4, D: ", "1 of 4, B: ", "2 of 4, D: ", "3 of 4, A: ", "4 of 4, C: "]
