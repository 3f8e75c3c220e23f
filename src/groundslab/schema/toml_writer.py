"""TOML text of values, key-value pairs and tables."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from datetime import date, datetime, time
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.schema.wording import describe, quote

#: Longer lines are broken where a list allows it.
WIDTH = 100
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def key(name: str) -> str:
    """Return a key, in quotes where it needs them."""
    return name if _BARE.fullmatch(name) else quote(name)


def value(what: Any) -> str:
    """Return a value on one line; raises InputError for what TOML cannot hold."""
    if isinstance(what, bool):
        return "true" if what else "false"
    if isinstance(what, str):
        _require_writable(what)
        return quote(what)
    if isinstance(what, float):
        return repr(what) if math.isfinite(what) else str(what)
    if isinstance(what, int):
        return str(what)
    if isinstance(what, Mapping):
        pairs = [f"{key(name)} = {value(entry)}" for name, entry in what.items()]
        return f"{{{', '.join(pairs)}}}"
    if isinstance(what, Sequence):
        return f"[{', '.join(map(value, what))}]"
    if isinstance(what, datetime | date | time):
        return what.isoformat()
    raise InputError([Issue("the edit", describe(what), "text, a number, true, false, a list or a table")])


def pair(name: str, what: Any) -> str:
    """Return the line of a key and its value; a long list is broken after some of its values."""
    line = f"{name} = {value(what)}"
    if len(line) <= WIDTH or not isinstance(what, list) or not what:
        return line + "\n"
    lines = [""]
    for text in map(value, what):
        if lines[-1] and len(lines[-1]) + len(text) + 4 > WIDTH:
            lines.append("")
        lines[-1] += f" {text}," if lines[-1] else f"{text},"
    return "\n".join([f"{name} = [", *(f"  {line}" for line in lines), "]\n"])


def is_list_of_tables(what: Any) -> bool:
    """Whether a value is written as double-bracketed tables."""
    return isinstance(what, list) and bool(what) and all(isinstance(item, Mapping) for item in what)


def is_section(path: tuple[str, ...], what: Any) -> bool:
    """Whether a value is written as tables with headers: all at the top, those that hold others, and long ones."""
    if is_list_of_tables(what):
        return True
    if not isinstance(what, Mapping):
        return False
    inner = any(is_section((*path, name), entry) for name, entry in what.items())
    return len(path) == 1 or inner or len(f"{path[-1]} = {value(what)}") > WIDTH


def section(path: tuple[str, ...], what: Any) -> str:
    """Return tables with headers, a blank line between them: one, or a list of them."""
    name = ".".join(map(key, path))
    if isinstance(what, Mapping):
        return _table(f"[{name}]", path, what)
    return "\n".join(_table(f"[[{name}]]", path, table) for table in what)


def _table(header: str, path: tuple[str, ...], table: Mapping[str, Any]) -> str:
    """Return one table below its header: first its pairs, then the tables in it."""
    below = {name: entry for name, entry in table.items() if is_section((*path, name), entry)}
    pairs = [pair(key(name), entry) for name, entry in table.items() if name not in below]
    inner = ["\n" + section((*path, name), entry) for name, entry in below.items()]
    if not pairs and inner and not header.startswith("[["):
        return "".join(inner).removeprefix("\n")  # those in it say that it is there
    return "".join([header + "\n", *pairs, *inner])


def _require_writable(text: str) -> None:
    """Raise InputError for text that no file can hold."""
    if any("\ud800" <= letter <= "\udfff" for letter in text):
        raise InputError([Issue("the edit", describe(text), "text without lone surrogates")])
