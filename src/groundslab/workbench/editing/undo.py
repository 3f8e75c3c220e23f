"""Undo history: earlier texts of the document, each with a label for the step."""

from __future__ import annotations

from dataclasses import dataclass, field

#: Most steps that can be undone.
MAX_STEPS = 500
#: Largest total length of their texts [characters].
MAX_LENGTH = 50_000_000

#: The text on the other side of a step, and its label.
Step = tuple[str, str]


@dataclass(slots=True)
class History:
    """Steps done and undone, the latest last; beyond the limits the oldest are dropped."""

    done: list[Step] = field(default_factory=list)
    undone: list[Step] = field(default_factory=list)
    _is_open: bool = False  # whether the latest step can absorb another one

    def record(self, before: str, label: str, merges: bool = False) -> None:
        """Record a change of a text; one that merges joins the latest step if that is open and has the same label."""
        self.undone.clear()
        if merges and self._is_open and label == self.undo_label:
            return
        self.done.append((before, label))
        self._is_open = True
        length = sum(len(text) for text, _ in self.done)
        while len(self.done) > MAX_STEPS or (length > MAX_LENGTH and len(self.done) > 1):
            length -= len(self.done.pop(0)[0])

    def undo(self, present: str) -> str | None:
        """Return the text before the latest step, None if there is none."""
        return self._move_step(self.done, self.undone, present)

    def redo(self, present: str) -> str | None:
        """Return the text after the step that was undone last, None if there is none."""
        return self._move_step(self.undone, self.done, present)

    def _move_step(self, source: list[Step], target: list[Step], present: str) -> str | None:
        if not source:
            return None
        self._is_open = False
        text, label = source.pop()
        target.append((present, label))
        return text

    def close_step(self) -> None:
        """Let no change join the latest step any more."""
        self._is_open = False

    @property
    def undo_label(self) -> str:
        """Label of the step that undo takes back, empty if there is none."""
        return self.done[-1][1] if self.done else ""

    @property
    def redo_label(self) -> str:
        """Label of the step that redo repeats, empty if there is none."""
        return self.undone[-1][1] if self.undone else ""
