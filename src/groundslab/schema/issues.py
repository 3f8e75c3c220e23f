"""What is wrong with a description: found bit by bit, put into words, and given a place in the end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from groundslab.errors import Fault
from groundslab.schema.wording import describe


@dataclass(frozen=True, slots=True)
class Finding:
    """A fault before its place is known in full: ``place`` holds keys and positions (from 0) below a part."""

    place: tuple[str | int, ...]
    got: str
    expected: str
    mend: str = ""

    def below(self, place: Sequence[str | int]) -> Finding:
        """Return the finding as seen from further up."""
        return replace(self, place=(*place, *self.place))

    def fault(self, root: str) -> Fault:
        """Return the fault, named from ``root`` (may be empty), its positions counted from 1."""
        path = root
        for step in self.place:
            if isinstance(step, int):
                path += f"[{step + 1}]"
            else:
                bare = step and step.isascii() and step.replace("_", "").replace("-", "").isalnum()
                key = step if bare and len(step) <= 60 else describe(step)
                path += f".{key}" if path else key
        return Fault(path or "the description", self.got, self.expected, self.mend)


class Wrong(ValueError):
    """Findings on their way through pydantic."""

    def __init__(self, *findings: Finding) -> None:
        """Keep the findings."""
        super().__init__("see the findings")
        self.findings = findings


def wrong(value: object, expected: str, mend: str = "") -> Wrong:
    """Return the error that says what a value should be."""
    return Wrong(Finding((), describe(value), expected, mend))
