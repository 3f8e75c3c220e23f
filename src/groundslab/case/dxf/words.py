"""Texts from a drawing, made fit for messages, terminals and TOML."""

from __future__ import annotations


def quote(text: str) -> str:
    """Return a text in quotes, escaped as TOML wants it, which also keeps it from upsetting a terminal."""
    return '"' + "".join(map(_escaped, text)) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return "\\" + letter
    if letter.isprintable():
        return letter
    # What stood for bytes without meaning is no letter.
    code = 0xFFFD if 0xD800 <= ord(letter) < 0xE000 else ord(letter)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def named(text: str) -> str:
    """Return a text from a drawing in quotes, shortened if it is long."""
    return quote(text if len(text) <= 40 else text[:37] + "...")


def safe(text: str) -> str:
    """Return a text from a drawing without letters that upset a terminal."""
    return quote(text)[1:-1]
