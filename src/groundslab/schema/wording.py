"""Wording of messages: values and names as readers see them."""

from __future__ import annotations

import difflib
import numbers
import re
from collections.abc import Iterable, Mapping, Sequence

from groundslab.messages import Name

MOST_NAMES = 10  # that are listed of those in a file
#: Letters that Python calls printable and nobody sees: the rest of what Unicode lets programs ignore
#: (Default_Ignorable_Code_Point), and the blank pattern of Braille.
_UNSEEN = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0\U000e0100-\U000e01ef]"
)
#: What begins a formula in a spreadsheet; numbers begin with a sign, too.
_FORMULA = re.compile(r"[=@]|[+-](?!\s*[0-9.,]+\s*$)\s*\S")


def describe(value: object) -> str:
    """Return a description of a value in at most about fifty characters, for messages."""
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
    return with_article(type(value).__name__)


def with_article(noun: str) -> str:
    """Return a noun with "a" or "an" before it, by its first letter."""
    return f"{'an' if noun[:1].lower() in 'aeiou' else 'a'} {noun}"


def quote(text: object) -> Name:
    """Return a text in double quotes, escaped as in TOML, which also makes it safe for a terminal; what is none too."""
    return Name(f'"{escape(str(text))}"')


def escape(text: str) -> str:
    """Return a text with its control characters, quotes and backslashes escaped as in TOML, to stand in quotes."""
    return "".join("\\" + letter if letter in '"\\' else _printable(letter) for letter in text)


def printable(text: str, keep: str = "") -> str:
    """Return a text with all letters escaped that are obeyed instead of shown, or that nobody sees.

    The only gate for names on their way out: control characters, which a terminal obeys and XML forbids; marks that
    turn text around, so that 84.04 is shown as 40.48; letters without width, which make two names look alike. White
    space becomes a space, but that in `keep`.
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(letter if letter in keep else " " if letter.isspace() else _printable(letter) for letter in text)


def as_cell(text: str) -> str:
    """Return a text for a cell of a CSV file, which a spreadsheet would take for a formula without the apostrophe."""
    return f"'{text}" if _FORMULA.match(text) else text


def _printable(letter: str) -> str:
    if letter.isprintable() and not _UNSEEN.match(letter):
        return letter
    code = 0xFFFD if 0xD800 <= ord(letter) < 0xE000 else ord(letter)  # lone surrogates are no letters
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def listed(words: Iterable[str], last: str = "or") -> str:
    """Return words as a list for people: ``a, b or c``."""
    *most, end = words
    return f"{', '.join(most)} {last} {end}" if most else end


def one_of(names: Sequence[str]) -> str:
    """Return names from a file as a list for people: of many the first ten, long ones shortened."""
    more = [f"{len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return listed([*map(describe, names[:MOST_NAMES]), *more])


def find_nearest(word: object, words: Iterable[str]) -> str | None:
    """Return the known word that a word resembles most, None if it resembles none."""
    if not isinstance(word, str) or len(word) > 40:
        return None
    lower = {candidate.lower(): candidate for candidate in words}
    close = difflib.get_close_matches(word.lower(), lower, n=1)
    return lower[close[0]] if close else None


def spelled_alike(word: object, words: Iterable[str]) -> tuple[str, ...]:
    """Return the known words with the letters and digits of a word, in any case and with any other signs."""
    return tuple(candidate for candidate in words if isinstance(word, str) and _letters(candidate) == _letters(word))


def _letters(word: str) -> str:
    return "".join(filter(str.isalnum, word[:100])).lower()


def suggestion(word: object, words: Iterable[str]) -> str:
    """Return ``did you mean "..."?`` for a word that resembles a known one, else nothing."""
    nearest = find_nearest(word, words)
    return "" if nearest is None else f"did you mean {quote(nearest)}?"
