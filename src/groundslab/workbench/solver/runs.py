"""Runs of the solver: what is to be solved, results, and reports that are waited for."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.workbench.solver.process import Answer


@dataclass(slots=True)
class Job:
    """A text to solve from a time on; equal fingerprints mean the same model."""

    run: int
    version: int
    text: str
    fingerprint: object
    due: float

    def to_json(self) -> dict[str, Any]:
        """Return run and version as data for the page."""
        return {"run": self.run, "version": self.version}


@dataclass(slots=True)
class Result:
    """The results of a run; version is the latest one with the same fingerprint."""

    run: int
    version: int
    fingerprint: object
    answer: Answer
    scene: bytes

    def to_json(self) -> dict[str, Any]:
        """Return the result as data for the page, with the headline of a design that fails or needs attention."""
        design = self.answer.summary.get("design", {})
        return {
            "run": self.run,
            "version": self.version,
            "seconds": self.answer.seconds,
            "design": design["headline"] if design.get("status") in ("fails", "attention") else "",
            "refused": self.answer.refused,
        }


class FileRequests:
    """Reports and archives that other threads wait for, by kind and run."""

    def __init__(self) -> None:
        self._waiting: dict[tuple[str, int], Future[bytes]] = {}
        self._file = ""  # the name of the case in a report

    def add(self, kind: str, run: int, file: str) -> Future[bytes]:
        """Return the future report or archive of a run."""
        self._file = file
        return self._waiting.setdefault((kind, run), Future())

    def take_unsent(self) -> Iterator[tuple[str, int, str]]:
        """Yield the messages to the process for new requests."""
        for (kind, run), future in self._waiting.items():
            if not future.running():
                future.set_running_or_notify_cancel()
                yield kind, run, self._file

    def finish(self, kind: str, run: int, error: str, content: bytes = b"") -> None:
        """Pass on a file, or the reason why there is none."""
        future = self._waiting.pop((kind, run), Future())
        if error:
            future.set_exception(make_file_error(kind, error))
        else:
            future.set_result(content)

    def fail(self, error: str) -> None:
        """Fail all requests."""
        for kind, run in list(self._waiting):
            self.finish(kind, run, error)


def make_file_error(kind: str, reason: str) -> InputError:
    """Return the error for a report or an archive that cannot be written."""
    return InputError([Issue(f"the {kind}", reason, "results that are kept")])
