"""Issues of a section, before their location in the file is known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from groundslab.errors import Issue
from groundslab.schema.wording import describe


@dataclass(frozen=True, slots=True)
class RelativeIssue:
    """An issue whose ``place`` holds keys and positions (from 0) below a section."""

    place: tuple[str | int, ...]
    found: str
    expected: str
    hint: str = ""

    def below(self, place: Sequence[str | int]) -> RelativeIssue:
        """Return the issue as seen from further up."""
        return replace(self, place=(*place, *self.place))

    def issue(self, root: str) -> Issue:
        """Return the issue with its location below ``root`` (may be empty), positions counted from 1."""
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
    """Carries issues through pydantic."""

    def __init__(self, *relative_issues: RelativeIssue) -> None:
        """Keep the issues."""
        super().__init__("see relative_issues")
        self.relative_issues = relative_issues


def field_error(value: object, expected: str, hint: str = "") -> FieldError:
    """Return the error that says what a value should be."""
    return FieldError(RelativeIssue((), describe(value), expected, hint))
