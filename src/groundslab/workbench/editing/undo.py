"""Undo history: earlier texts of the document, each with a label for the step."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

#: Most steps that can be undone.
MAX_STEPS = 500
#: Largest total length of their texts [characters].
MAX_LENGTH = 50_000_000


@dataclass(frozen=True, slots=True)
class Step:
    """A step: the text on its other side and a label."""

    text: str
    label: str


class History:
    """Steps done and undone, the latest last; beyond the limits the oldest are dropped."""

    def __init__(self) -> None:
        self._done: deque[Step] = deque()
        self._undone: list[Step] = []
        self._open = False  # whether the latest step can absorb another one

    def record(self, before: str, label: str, merges: bool = False) -> None:
        """Record a change of a text; one that merges joins the latest step if that is open and has the same label."""
        self._undone.clear()
        if merges and self._open and self._done and self._done[-1].label == label:
            return
        self._done.append(Step(before, label))
        self._open = True
        length = sum(len(step.text) for step in self._done)
        while len(self._done) > MAX_STEPS or (length > MAX_LENGTH and len(self._done) > 1):
            length -= len(self._done.popleft().text)

    def undo(self, present: str) -> str | None:
        """Return the text before the latest step, None if there is none."""
        if not self._done:
            return None
        self._open = False
        step = self._done.pop()
        self._undone.append(Step(present, step.label))
        return step.text

    def redo(self, present: str) -> str | None:
        """Return the text after the step that was undone last, None if there is none."""
        if not self._undone:
            return None
        self._open = False
        step = self._undone.pop()
        self._done.append(Step(present, step.label))
        return step.text

    def close_step(self) -> None:
        """Let no change join the latest step any more."""
        self._open = False

    @property
    def undo_label(self) -> str:
        """Label of the step that undo takes back, empty if there is none."""
        return self._done[-1].label if self._done else ""

    @property
    def redo_label(self) -> str:
        """Label of the step that redo repeats, empty if there is none."""
        return self._undone[-1].label if self._undone else ""

    @property
    def can_undo(self) -> bool:
        """Whether there is a step to undo."""
        return bool(self._done)

    @property
    def can_redo(self) -> bool:
        """Whether there is a step to do again."""
        return bool(self._undone)
