"""Issues of a section, before their location in the file is known, and of arguments of another kind."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from groundslab.errors import InputError, Issue, Repair
from groundslab.schema.repairs import move_below
from groundslab.schema.wording import describe, listed, with_article


@dataclass(frozen=True, slots=True)
class RelativeIssue:
    """An issue whose ``place`` and repairs hold keys and positions (from 0) below a section."""

    place: tuple[str | int, ...]
    found: str
    expected: str
    hint: str = ""
    repairs: tuple[Repair, ...] = field(default=(), compare=False, repr=False)

    def below(self, place: Sequence[str | int]) -> RelativeIssue:
        """Return the issue as seen from further up."""
        repairs = tuple(move_below(place, repair) for repair in self.repairs)
        return replace(self, place=(*place, *self.place), repairs=repairs)

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
        return Issue(path or "the description", self.found, self.expected, self.hint, self.repairs)


class FieldError(ValueError):
    """Says by issues why a value or a section cannot be read."""

    def __init__(self, *relative_issues: RelativeIssue) -> None:
        """Keep the issues."""
        super().__init__(relative_issues)
        self.relative_issues = relative_issues

    def __str__(self) -> str:
        """Return the issues in a line."""
        return "; ".join(f"found {issue.found}, expected {issue.expected}" for issue in self.relative_issues)


def field_error(value: object, expected: str, hint: str = "", repairs: Iterable[Repair] = ()) -> FieldError:
    """Return the error that says what a value should be, and how to repair it where that is known."""
    return FieldError(RelativeIssue((), describe(value), expected, hint, tuple(repairs)))


#: How to read what a function needs from a file or folder, by the name of its class.
_READ = {"Model": "load", "Results": "load_results"}
_CALLED = {"Results": "Results", "str": "the name of its folder"}


def require(value: object, *kinds: type, name: str) -> None:
    """Raise InputError for an argument of another kind than those named."""
    if isinstance(value, kinds):
        return
    names = [kind.__name__ for kind in kinds if kind is not Path]
    reader = next((_READ[word] for word in names if word in _READ), None)
    hint = ""
    if names == ["Results"] and type(value).__name__ == "CombinationResult":
        hint = "give the results of all combinations, as groundslab.solve returns them"
    if reader is not None and isinstance(value, str | Path):
        hint = f"groundslab.{reader}({describe(str(value))}) reads it"
    elif type(value).__name__ in ("PlateResult", "ElementResult", "GroundResult"):
        hint = "it is a part of results: give the results themselves"
    described = describe(str(value) if isinstance(value, Path) else value)
    raise InputError([Issue(name, described, listed([_called(word) for word in names]), hint)])


def _called(name: str) -> str:
    """Return a class in words."""
    return _CALLED.get(name, with_article(name))
