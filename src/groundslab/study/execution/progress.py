"""Shows the progress of a study on the terminal: a bar with the remaining time, or a few lines without a terminal."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

    from groundslab.study.execution.runner import OnProgress, Progress

#: Period over which the speed of a study is estimated [s].
SPEED_PERIOD = 600.0


@contextmanager
def show_progress(quiet: bool, console: Console | None = None) -> Iterator[OnProgress]:
    """Provide a function that shows the progress of a study on standard error (or a console); quiet shows nothing."""
    if quiet:
        yield lambda _: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, SpinnerColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    console = console or Console(file=sys.stderr)
    columns = (
        SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(),
        TextColumn("left {task.fields[failed]}"),
    )  # fmt: skip
    with Bar(*columns, console=console, speed_estimate_period=SPEED_PERIOD, disable=not console.is_terminal) as bar:
        task = bar.add_task("starting", total=None, failed="")
        printed: set[str] = set()

        def on_progress(progress: Progress) -> None:
            for line in (describe_start(progress), *progress.warnings, describe_place(progress)):
                if line and line not in printed:
                    printed.add(line)
                    console.print(line, markup=False, highlight=False, soft_wrap=True)
            # rows of earlier runs count for the bar, not for the speed
            bar.update(task, total=progress.total, completed=progress.rows, failed=describe_failures(progress),
                       description="variants" if progress.where else "starting")  # fmt: skip

        yield on_progress


def describe_start(progress: Progress) -> str:
    """Return the folder of a study, its size, and how many rows it has already."""
    already = f", of which {progress.there} have a row already" if progress.there else ""
    return f"{progress.folder}: {progress.total} variants{already}"


def describe_place(progress: Progress) -> str:
    """Return where variants are solved, empty before it is known, and the address of the dashboard."""
    dashboard = f"; Dask's dashboard: {progress.dashboard}" if progress.dashboard else ""
    return f"solving {progress.where}{dashboard}" if progress.where else ""


def describe_failures(progress: Progress) -> str:
    """Return how many variants failed and how many have no row, empty if none."""
    parts = [f"{progress.failed} failed" if progress.failed else ""]
    parts.append(f"{len(progress.failures)} without a row" if progress.failures else "")
    return ", ".join(filter(None, parts))
