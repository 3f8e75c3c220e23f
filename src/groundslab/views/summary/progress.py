"""The progress of the analysis on one line of a terminal."""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from rich.console import Console
    from rich.status import Status

    from groundslab.model.loads.load_cases import Combination
    from groundslab.results.record import Step


class CombinationCount:
    """Counts the combinations as they begin, from the first again on each mesh, and estimates the time that is left.

    A mesh is another one when a combination begins again. The estimate is the mean time of those that are done, as if
    all are solved on this mesh: further ones may have only those that govern. The first on a mesh, which takes the
    meshing and the first factorization too, is left out of it.
    """

    def __init__(self, count: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._count, self._clock = count, clock
        self._names: set[str] = set()  # of those that have begun on this mesh
        self._name = ""
        self._begun = self._second_begun = 0.0

    @property
    def share(self) -> float | None:
        """The share of combinations that are done, None where there is only one."""
        return (len(self._names) - 1) / self._count if self._count > 1 else None

    def begin(self, name: str) -> None:
        """Note that the next combination begins."""
        if name in self._names:
            self._names = set()
        self._names.add(name)
        self._name, self._begun = name, self._clock()
        if len(self._names) == 2:
            self._second_begun = self._begun

    def seconds_left(self) -> float | None:
        """Return the time that the combinations of this mesh still take, None before it can be estimated [s]."""
        number = len(self._names)
        if number < 3:
            return None
        mean = (self._begun - self._second_begun) / (number - 2)
        return max(0.0, mean * (self._count - number + 1) - (self._clock() - self._begun))

    def words(self) -> str:
        """Return number and name of the combination and the time left, empty where there is only one."""
        if self._count == 1:
            return ""
        left = self.seconds_left()
        about = "" if left is None or left < 1.0 else f", about {left:.0f} s left on this mesh"
        return f"{len(self._names)} of {self._count}, {self._name}{about}: "


class StatusLine:
    """A line on the terminal that shows each step, and the combination that it belongs to."""

    def __init__(self, status: Status, count: int) -> None:
        self._status = status
        self._combinations = CombinationCount(count)

    def begin(self, combination: Combination) -> None:
        """Show that the next combination begins; where there is only one, it is not named."""
        self._combinations.begin(combination.name)
        self._update("begins")

    def __call__(self, step: Step) -> None:
        """Show a step."""
        self._update(line(step))

    def _update(self, words: str) -> None:
        from rich.text import Text

        self._status.update(
            Text(self._combinations.words() + words)
        )  # as text, since a name may hold what rich takes for markup


@contextmanager
def progress(console: Console | None = None, count: int = 1) -> Iterator[StatusLine]:
    """Show a line on standard error (or the given console) for an analysis of `count` combinations."""
    from rich.console import Console

    console = console or Console(stderr=True)
    with console.status("analysis begins") as status:
        yield StatusLine(status, count)


def line(step: Step) -> str:
    """Return one step of the iteration in words."""
    gamma = "" if step.gamma is None else f", gamma {step.gamma:.5g}"
    return (
        f"{step.unknowns} unknowns, load {step.increment}{gamma}, contact {step.iteration}: "
        f"{step.in_contact} closed, {step.changed} changed"
    )
