"""What the workers get next: fast variants together, suspects alone; who is to blame for a worker's death."""

from __future__ import annotations

import random
import signal
from collections import Counter, deque
from collections.abc import Sequence

import pytest

from groundslab.study.execution.tasks import Loss, Tasks, describe_exit
from groundslab.study.execution.variant import SOLVED, Row, WorkerFailure
from groundslab.study.sampling.designs import Variant

DIED = Loss("exit code 9", 1)


def variants(count: int) -> list[Variant]:
    """Return so many variants."""
    return [Variant(number, (), ()) for number in range(1, count + 1)]


def rows_of(task: Sequence[Variant]) -> list[Row]:
    """Return the rows of a task, each of which took a hundredth of a second."""
    return [Row(variant.number, SOLVED, "", "", 0.01, (), ()) for variant in task]


def test_fast_variants_share_a_task() -> None:
    """A task lasts a fraction of a second, and none is so large that threads idle in the end."""
    tasks = Tasks(variants(1000))
    first = tasks.next(32, 2, idle=True)
    assert [len(task) for task in first] == [1] * 32
    for task in first:
        assert tasks.finish(task, row := rows_of(task)) == row
    (some,) = tasks.next(1, 2, idle=False)
    assert 10 <= len(some) <= 0.2 / 0.01
    tasks.left = deque(variants(1000)[-48:])
    assert [len(task) for task in tasks.next(32, 2, idle=False)] == [6] * 8
    assert tasks.next(32, 2, idle=False) == []


def test_suspects_are_tried_one_at_a_time_when_all_others_are_done() -> None:
    """While anything else is solved no suspect is; only one of which two workers died alone is given up."""
    tasks = Tasks(variants(4))
    tasks.seconds = 0.1
    first, second = tasks.next(2, 1, idle=True), tasks.next(2, 1, idle=False)
    assert [[variant.number for variant in task] for task in (*first, *second)] == [[1], [2], [3], [4]]
    assert tasks.finish(first[0], DIED) == []
    assert tasks.finish(first[1], DIED) == []
    assert tasks.next(2, 1, idle=False) == []
    assert tasks.finish(second[0], row := rows_of(second[0])) == row
    assert tasks.finish(second[1], row := rows_of(second[1])) == row
    assert tasks.next(2, 1, idle=True) == [first[0]]
    assert tasks.next(2, 1, idle=False) == []
    # the first death alone may be an accident
    assert tasks.finish(first[0], DIED) == []
    assert tasks.next(2, 1, idle=True) == [first[1]]
    assert tasks.finish(first[1], row := rows_of(first[1])) == row
    assert tasks.next(2, 1, idle=True) == [first[0]]
    failure = WorkerFailure(1, "2 workers died of it with nothing else running: exit code 9")
    assert tasks.finish(first[0], DIED) == [failure]
    assert tasks.next(2, 1, idle=True) == []


@pytest.mark.parametrize(
    ("loss", "message"),
    [
        (Loss("MemoryError: no room"), "MemoryError: no room"),
        (Loss("perhaps out of memory", 4), "4 workers died of it with nothing else running: perhaps out of memory"),
    ],
)
def test_one_loss_alone_is_enough(loss: Loss, message: str) -> None:
    """Of a lack of memory, and where the scheduler has let several workers die of it already."""
    tasks = Tasks(variants(1))
    (task,) = tasks.next(1, 1, idle=True)
    assert tasks.finish(task, loss) == []
    assert tasks.next(1, 1, idle=True) == [task]
    assert tasks.finish(task, loss) == [WorkerFailure(1, message)]


def test_nobody_is_blamed_for_another() -> None:
    """Whatever else dies beside killers, and of an accident, exactly the killers have no row; all others have one."""
    for seed in range(50):
        chance = random.Random(seed)
        count, threads = chance.randint(1, 120), chance.randint(1, 4)
        killers = set(chance.sample(range(1, count + 1), min(count, chance.randint(0, 3))))
        accidents = 1
        tasks, pending = Tasks(variants(count)), list[Sequence[Variant]]()
        outcomes = Counter[tuple[int, bool]]()
        while more := [*pending, *tasks.next(16 * threads - len(pending), threads, idle=not pending)]:
            chance.shuffle(more)
            task, *pending = more
            dies = any(variant.number in killers for variant in task)
            if accidents and chance.random() < 0.05:
                dies, accidents = True, 0
            # those beside it at the same worker, and those whose rows had not been fetched from it
            beside = chance.randint(0, len(pending)) if dies else 0
            ended = [(task, DIED if dies else rows_of(task)), *((other, DIED) for other in pending[:beside])]
            pending = pending[beside:]
            for variants_of_task, outcome in ended:
                for made in tasks.finish(variants_of_task, outcome):
                    outcomes[made.number, isinstance(made, Row)] += 1
        assert outcomes == Counter({(number, number not in killers): 1 for number in range(1, count + 1)})


def test_how_a_process_ended() -> None:
    """A signal has its name; what only a worker's guardian sends, and what the system sends for want of memory, too."""
    assert describe_exit(9, 2**34) == "exit code 9"
    assert describe_exit(None, 2**34) == "perhaps out of memory"
    assert describe_exit(-signal.SIGABRT, 2**34) == "SIGABRT"
    assert describe_exit(-signal.SIGTERM, 2**34) == "more memory than a worker's share of 16 GiB"


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="signals of this kind are POSIX")
def test_killed_by_the_system() -> None:
    """The signal that nothing can catch is what the system sends for want of memory."""
    assert describe_exit(-9, 2**34) == "SIGKILL, perhaps out of memory"
