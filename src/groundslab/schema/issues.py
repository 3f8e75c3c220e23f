"""What is wrong with a description: found bit by bit, put into words, and given a place in the end."""

from __future__ import annotations

import difflib
import numbers
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from groundslab.errors import Fault

MOST_NAMES = 10  # told of those that a file has chosen


def describe(value: object) -> str:
    """Return what a value is in at most about fifty characters, for messages."""
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return quote(value if len(value) <= 40 else value[:37] + "...")
    if isinstance(value, int):
        return str(value) if value.bit_length() < 128 else "a huge number"
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list | tuple):
        return f"a list of {len(value)}" if value else "an empty list"
    name = type(value).__name__
    return f"{'an' if name[:1].lower() in 'aeiou' else 'a'} {name}"


def quote(text: str) -> str:
    """Return a text in double quotes, escaped as TOML wants it, which also keeps it from upsetting a terminal."""
    return '"' + "".join(map(_escaped, text)) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return "\\" + letter
    if letter.isprintable():
        return letter
    code = ord(letter)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def listed(words: Iterable[str], last: str = "or") -> str:
    """Return words as a list for people: ``a, b or c``."""
    *most, end = words
    return f"{', '.join(most)} {last} {end}" if most else end


def one_of(names: Sequence[str]) -> str:
    """Return names that a file has chosen as a list for people: of many the first ten, long ones cut."""
    more = [f"{len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return listed([*map(describe, names[:MOST_NAMES]), *more])


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


def suggestion(word: object, known: Iterable[str]) -> str:
    """Return ``did you mean "..."?`` for a word that resembles a known one, else nothing."""
    if not isinstance(word, str) or len(word) > 40:
        return ""
    lower = {each.lower(): each for each in known}
    close = difflib.get_close_matches(word.lower(), lower, n=1)
    return f"did you mean {quote(lower[close[0]])}?" if close else ""
