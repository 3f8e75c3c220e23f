"""Runs of the solver: what is to be solved, the latest results, and views of them that are waited for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from groundslab.errors import InputError, Issue
from groundslab.messages import Label, Message
from groundslab.workbench.solver.answer import Answer
from groundslab.workbench.solver.process import View

if TYPE_CHECKING:
    from groundslab.workbench.events import Event

#: Number of results that are kept, for pages that still show the previous one.
MAX_RESULTS = 2

T = TypeVar("T")


class Latest(dict[int, T], Generic[T]):
    """What is kept of the latest runs, by their numbers."""

    def add(self, run: int, value: T) -> None:
        """Keep the value of a run in place of the oldest one."""
        self[run] = value
        while len(self) > MAX_RESULTS:
            del self[next(iter(self))]

    @property
    def latest(self) -> T | None:
        """The value added last."""
        return next(reversed(self.values()), None)


@dataclass(slots=True)
class Job:
    """A text to solve from a time on; equal fingerprints mean the same model."""

    run: int
    version: int
    text: str
    fingerprint: object
    due: float
    accuracy: str = ""  # asked for in place of that of the case, "" for that

    def to_json(self) -> dict[str, Any]:
        """Return run and version as data for the page."""
        return {"run": self.run, "version": self.version}


@dataclass(slots=True)
class Result:
    """The results of a run; version is the latest one with the same fingerprint.

    Provisional ones are replaced by those on the next mesh, or with checks; `update` counts how often.
    """

    run: int
    version: int
    fingerprint: object
    answer: Answer
    scene: bytes
    text: str = ""
    update: int = 0

    @property
    def is_provisional(self) -> bool:
        """Whether the mesh is still to be refined."""
        return bool(self.answer.provisional)

    @property
    def event(self) -> Event:
        """The event that announces the result to the page."""
        return "provisional" if self.is_provisional else "solved", self.to_json()

    def to_json(self) -> dict[str, Any]:
        """Return the result as data for the page, with the headline of a design that fails or needs attention."""
        design = self.answer.summary.get("design", {})
        return {
            "run": self.run,
            "version": self.version,
            "seconds": self.answer.seconds,
            "design": design["headline"] if design.get("status") in ("fails", "attention") else "",
            "refused": self.answer.refused,
            "provisional": self.answer.provisional,
            "update": self.update,
        }


class ViewRequests:
    """Reports and tables that other threads wait for."""

    def __init__(self) -> None:
        self._waiting: dict[View, Future[bytes]] = {}

    def add(self, view: View) -> Future[bytes]:
        """Return a future view."""
        return self._waiting.setdefault(view, Future())

    def take_unsent(self) -> Iterator[View]:
        """Yield the messages to the process for new requests."""
        for view, future in self._waiting.items():
            if not future.running():
                future.set_running_or_notify_cancel()
                yield view

    def finish(self, view: View, error: str | Sequence[Issue], content: bytes = b"") -> None:
        """Pass on a view, or the reason or the issues why there is none."""
        future = self._waiting.pop(view, Future())
        if error:
            future.set_exception(make_view_error(view[0], error))
        else:
            future.set_result(content)

    def fail(self, error: str) -> None:
        """Fail all requests."""
        for view in list(self._waiting):
            self.finish(view, error)


def make_view_error(kind: str, reason: str | Sequence[Issue]) -> InputError:
    """Return the error for a report or a table that cannot be made."""
    if not isinstance(reason, str):
        return InputError(reason)
    return InputError([Issue(Message("the {file}", file=Label(kind)), reason, Label("results that are kept"))])
