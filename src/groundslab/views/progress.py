"""What the analysis is doing, on one line of a terminal that renews itself."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from rich.console import Console

    from groundslab.results import Step


@contextmanager
def progress(console: Console | None = None) -> Iterator[Callable[[Step], None]]:
    """Show a line on standard error (or the given console); the context's value is called with each step."""
    from rich.console import Console

    console = console or Console(stderr=True)
    with console.status("analysis begins") as status:

        def show(step: Step) -> None:
            status.update(line(step))

        yield show


def line(step: Step) -> str:
    """Return one step of the iteration in words."""
    gamma = "" if step.gamma is None else f", gamma {step.gamma:.5g}"
    return (
        f"{step.unknowns} unknowns, load {step.increment}{gamma}, contact {step.iteration}: "
        f"{step.in_contact} nodes, {step.changed} changed"
    )
