"""What is wrong with a description: found bit by bit, put into words, and given a place in the end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from groundslab.errors import Issue
from groundslab.schema.wording import describe


@dataclass(frozen=True, slots=True)
class RelativeIssue:
    """A fault before its place is known in full: ``place`` holds keys and positions (from 0) below a part."""

    place: tuple[str | int, ...]
    found: str
    expected: str
    hint: str = ""

    def below(self, place: Sequence[str | int]) -> RelativeIssue:
        """Return the finding as seen from further up."""
        return replace(self, place=(*place, *self.place))

    def issue(self, root: str) -> Issue:
        """Return the fault, named from ``root`` (may be empty), its positions counted from 1."""
        path = root
        for step in self.place:
            if isinstance(step, int):
                path += f"[{step + 1}]"
            else:
                bare = step and step.isascii() and step.replace("_", "").replace("-", "").isalnum()
                key = step if bare and len(step) <= 60 else describe(step)
                path += f".{key}" if path else key
        return Issue(path or "the description", self.found, self.expected, self.hint)


class FieldError(ValueError):
    """Findings on their way through pydantic."""

    def __init__(self, *relative_issues: RelativeIssue) -> None:
        """Keep the findings."""
        super().__init__("see the findings")
        self.relative_issues = relative_issues


def field_error(value: object, expected: str, hint: str = "") -> FieldError:
    """Return the error that says what a value should be."""
    return FieldError(RelativeIssue((), describe(value), expected, hint))
