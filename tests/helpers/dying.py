"""What a process does in tests that is killed while it saves results."""

from __future__ import annotations

import itertools
import os
import signal
from pathlib import Path
from typing import Any

from groundslab.views.files import npz, results_folder, vtk  # noqa: F401
from groundslab.views.summary import sections  # noqa: F401
from helpers import synthetic


def save(function: str, number: int, moment: str, folder: Path, several: bool) -> None:
    """Save results, and be killed before or after so many calls of a function of the system, in whatever thread."""
    original, calls = getattr(os, function), itertools.count(1)

    def fatal(*arguments: Any, **options: Any) -> Any:
        call = next(calls)
        if call == number and moment == "before":
            die()
        value = original(*arguments, **options)
        if call == number:
            die()
        return value

    setattr(os, function, fatal)
    results_folder.save_results(synthetic.combined() if several else synthetic.results(lifts=False), folder)


def die() -> None:
    """End this process without a chance to clean up."""
    if hasattr(signal, "SIGKILL"):
        os.kill(os.getpid(), signal.SIGKILL)
    os._exit(9)
