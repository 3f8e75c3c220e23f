"""The names in a case, which no language and no unit changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from groundslab.arrays import made_once
from groundslab.messages import Name

if TYPE_CHECKING:
    from groundslab.model.model import Model


@made_once
def names_of(model: Model) -> frozenset[str]:
    """Return the names of all that a case has, groups of load cases among them."""
    return frozenset(_names(model.model_dump()))


def _names(value: Any) -> Iterator[str]:
    """Yield the names of all that a part of a case has."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            if key == "name" and isinstance(part, str):
                yield part
            else:
                yield from _names(part)
    elif isinstance(value, Name):
        yield value
    elif isinstance(value, Sequence) and not isinstance(value, str):
        for part in value:
            yield from _names(part)
