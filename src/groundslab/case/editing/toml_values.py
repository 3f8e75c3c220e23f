"""Values of a TOML file as Python data: compared, looked up and replaced by path."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

#: Keys and indices (from 0) from the top of a file downwards.
Path = tuple[str | int, ...]
MISSING: Any = object()


def equal_values(a: Any, b: Any) -> bool:
    """Whether two values mean the same in a file: 1 equals 1.0, but not true."""
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        return a.keys() == b.keys() and all(equal_values(a[name], b[name]) for name in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(equal_values, a, b))
    return isinstance(a, bool) is isinstance(b, bool) and bool(a == b or (a != a and b != b))


def get_value(data: Any, path: Path, default: Any = None) -> Any:
    """Return the value at a path, or a default if there is none."""
    for step in path:
        exists = step in data if isinstance(data, Mapping) else isinstance(data, list) and step in range(len(data))
        if not exists:
            return default
        data = data[step]
    return data


def replace_value(data: Any, path: Path, new: Any) -> Any:
    """Return a copy of the data with another value at a path; missing tables on the way are created."""
    if not path:
        return new
    step, rest = path[0], path[1:]
    if isinstance(step, int):
        return [replace_value(item, rest, new) if index == step else item for index, item in enumerate(data)]
    table = dict(data) if isinstance(data, Mapping) else {}
    table[step] = replace_value(table.get(step), rest, new)
    return table
