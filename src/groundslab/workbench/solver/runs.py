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


class ReportRequests:
    """Reports that other threads wait for, by run."""

    def __init__(self) -> None:
        self._waiting: dict[int, Future[bytes]] = {}
        self._file = ""  # the name of the case in a report

    def add(self, run: int, file: str) -> Future[bytes]:
        """Return the future report on a run."""
        self._file = file
        return self._waiting.setdefault(run, Future())

    def take_unsent(self) -> Iterator[tuple[str, int, str]]:
        """Yield the messages to the process for new requests."""
        for run, future in self._waiting.items():
            if not future.running():
                future.set_running_or_notify_cancel()
                yield "report", run, self._file

    def finish(self, run: int, error: str, content: bytes = b"") -> None:
        """Pass on a report, or the reason why there is none."""
        future = self._waiting.pop(run, Future())
        if error:
            future.set_exception(make_report_error(error))
        else:
            future.set_result(content)

    def fail(self, error: str) -> None:
        """Fail all requests."""
        for run in list(self._waiting):
            self.finish(run, error)


def make_report_error(reason: str) -> InputError:
    """Return the error for a report that cannot be written."""
    return InputError([Issue("the report", reason, "results that are kept")])
