"""The progress of the analysis on one line of a terminal."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import Console
    from rich.status import Status

    from groundslab.model.loads.load_cases import Combination
    from groundslab.results.record import Step


class StatusLine:
    """A line on the terminal that shows each step, and the combination that it belongs to."""

    def __init__(self, status: Status, count: int) -> None:
        self._status = status
        self._count = count
        self._number = 0
        self._name = ""

    def begin(self, combination: Combination) -> None:
        """Show that the next combination begins; where there is only one, it is not named."""
        self._number = self._number % self._count + 1  # again from the first on each mesh
        self._name = combination.name
        self._update("begins")

    def __call__(self, step: Step) -> None:
        """Show a step."""
        self._update(line(step))

    def _update(self, words: str) -> None:
        from rich.text import Text

        which = f"{self._number} of {self._count}, {self._name}: " if self._count > 1 else ""
        self._status.update(Text(which + words))  # as text, since a name may hold what rich takes for markup


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
