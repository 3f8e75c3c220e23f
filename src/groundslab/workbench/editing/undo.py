"""What the user did, to be undone and done again: texts of the document, each with the words for the step to it."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

#: So many steps can be undone, at most ...
STEPS = 500
#: ... as long as their texts are no longer than this together [characters].
LENGTH = 50_000_000


@dataclass(frozen=True, slots=True)
class Step:
    """A step: the text on its other side, and what the user did."""

    text: str
    words: str


class History:
    """The steps done and undone, the latest one last; the oldest are forgotten where there are too many."""

    def __init__(self) -> None:
        self._done: deque[Step] = deque()
        self._undone: list[Step] = []
        self._open = False  # whether more of the same may join the latest step

    def record(self, before: str, words: str, merges: bool = False) -> None:
        """Note that a text was left; a step that merges joins the one before, if that is open and of the same words."""
        self._undone.clear()
        if merges and self._open and self._done and self._done[-1].words == words:
            return
        self._done.append(Step(before, words))
        self._open = True
        length = sum(len(step.text) for step in self._done)
        while len(self._done) > STEPS or (length > LENGTH and len(self._done) > 1):
            length -= len(self._done.popleft().text)

    def undo(self, present: str) -> str | None:
        """Return the text before the latest step, None if there is none."""
        if not self._done:
            return None
        self._open = False
        step = self._done.pop()
        self._undone.append(Step(present, step.words))
        return step.text

    def redo(self, present: str) -> str | None:
        """Return the text after the step that was undone last, None if there is none."""
        if not self._undone:
            return None
        self._open = False
        step = self._undone.pop()
        self._done.append(Step(present, step.words))
        return step.text

    def settle(self) -> None:
        """Let nothing join the latest step any more."""
        self._open = False

    @property
    def undo_words(self) -> str:
        """What undo would take back, empty if there is nothing."""
        return self._done[-1].words if self._done else ""

    @property
    def redo_words(self) -> str:
        """What redo would do again, empty if there is nothing."""
        return self._undone[-1].words if self._undone else ""

    @property
    def can_undo(self) -> bool:
        """Whether there is a step to undo."""
        return bool(self._done)

    @property
    def can_redo(self) -> bool:
        """Whether there is a step to do again."""
        return bool(self._undone)
