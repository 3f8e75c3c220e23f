"""How far a study is, on the terminal: a bar with the time that is left, and a few lines where there is none."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

    from groundslab.study.execution.runner import OnProgress, Progress

#: Rows of so many seconds back tell how fast the study runs.
LOOK_BACK = 600.0


@contextmanager
def shown(quiet: bool, console: Console | None = None) -> Iterator[OnProgress]:
    """Return what shows the progress of a study on standard error (or the given console); quiet shows nothing."""
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
    with Bar(*columns, console=console, speed_estimate_period=LOOK_BACK, disable=not console.is_terminal) as bar:
        task = bar.add_task("begins", total=None, failed="")
        told: list[str] = []

        def tell(line: str) -> None:
            if line not in told:
                told.append(line)
                console.print(line, markup=False, highlight=False, soft_wrap=True)

        def on_progress(progress: Progress) -> None:
            for line in (head(progress), *progress.warnings):
                tell(line)
            if progress.where:
                tell(whereabouts(progress))
            # what is there already counts for the bar, not for the speed
            bar.update(task, total=progress.total, completed=progress.rows, failed=failures(progress),
                       description="variants" if progress.where else "begins")  # fmt: skip

        yield on_progress


def head(progress: Progress) -> str:
    """Return what the study is, and what of it is there already."""
    there = f", of which {progress.there} have a row already" if progress.there else ""
    return f"{progress.folder}: {progress.total} variants{there}"


def whereabouts(progress: Progress) -> str:
    """Return where variants are solved, and where that can be watched."""
    watched = f"; Dask's dashboard: {progress.dashboard}" if progress.dashboard else ""
    return f"solving {progress.where}{watched}"


def failures(progress: Progress) -> str:
    """Return how many variants failed and had mishaps, nothing if none did."""
    parts = [f"{progress.failed} failed" if progress.failed else ""]
    parts.append(f"{len(progress.mishaps)} without a row" if progress.mishaps else "")
    return ", ".join(filter(None, parts))
