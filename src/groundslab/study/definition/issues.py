"""Collects issues of parts of a study file, each with its place."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from inspect import Parameter, Signature

from groundslab.schema.base import Check
from groundslab.schema.issues import FieldError, RelativeIssue


@contextmanager
def issues_below(*place: str | int, collected: list[RelativeIssue] | None = None) -> Iterator[None]:
    """Put issues raised within below a place of the file; collect them in a list, if given, instead of raising."""
    try:
        yield
    except FieldError as error:
        issues = [issue.below(place) for issue in error.relative_issues]
        if collected is None:
            raise FieldError(*issues) from None
        collected += issues


def require_one(one: str, other: str) -> Check:
    """Return the check of a section that exactly one of two keys is given."""

    def check(**given: object) -> Iterator[RelativeIssue]:
        if sum(value is not None for value in given.values()) != 1:
            found = f"neither {one} nor {other}" if given[one] is None else f"both {one} and {other}"
            yield RelativeIssue((), found, f"exactly one of {one} and {other}")

    keys = [Parameter(name, Parameter.KEYWORD_ONLY) for name in (one, other)]
    check.__signature__ = Signature(keys)  # type: ignore[attr-defined]
    return check
