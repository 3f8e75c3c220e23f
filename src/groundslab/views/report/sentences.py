"""Sentences as they are typeset: symbols of ours with their indices below, units with raised powers, names as given."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from groundslab.messages import with_names
from groundslab.views.report.table_layout import GREEK

if TYPE_CHECKING:
    from groundslab.languages import Translator

#: What a name stands between until it is set; no text has such letters.
_OPEN, _CLOSE = "\ue000", "\ue001"
_MARKS = re.compile(f"[{_OPEN}{_CLOSE}]")
#: A symbol of ours amid words: one letter, or a Greek one by its name, with an index; a key such as soil.k_x is none.
_SYMBOL = re.compile(rf"(?<![\w.])([A-Za-z]|{'|'.join(GREEK)})_([A-Za-z0-9]+(?:,[A-Za-z0-9]+)*)(?![\w(]|\.\w)")
_LENGTH = "(?:mm|cm|m|in|ft)"
#: A unit that has a power, behind its number or in brackets; it may have been said as a name.
_UNIT = re.compile(
    rf"(?:(?<=\d )|(?<=\[)){_OPEN}?((?:[A-Za-z]+/)?{_LENGTH}\^?[234](?:/{_LENGTH}[234]?)?){_CLOSE}?(?!\w)"
)
_POWER = re.compile(r"\^?([234])(?![\d.])")


def raised(unit: str) -> str:
    """Return a unit with its powers raised."""
    return _POWER.sub(lambda power: power[1].translate(str.maketrans("234", "²³⁴")), unit)


def with_powers(text: str) -> str:
    """Return a text in which units have raised powers behind their numbers and in brackets."""
    return _UNIT.sub(lambda unit: raised(unit[1]), text)


def set_sentence(text: str, translate: Translator) -> list[tuple[str, str]]:
    """Return a text in a language as pairs of what stands on the line and what below it; names are as given."""
    said = translate(with_names(text, lambda name: f"{_OPEN}{_MARKS.sub('', name)}{_CLOSE}"))
    pieces: list[tuple[str, str]] = []
    for number, piece in enumerate(_MARKS.split(with_powers(said))):
        pieces += [(piece, "")] if number % 2 else _with_indices(piece)
    return [pair for pair in pieces if pair != ("", "")]


def _with_indices(words: str) -> list[tuple[str, str]]:
    """Return words without names in pairs: up to a symbol and its index, and what follows."""
    pieces: list[tuple[str, str]] = []
    end = 0
    for match in _SYMBOL.finditer(words):
        pieces.append((words[end : match.start()] + GREEK.get(match[1], match[1]), match[2]))
        end = match.end()
    return [*pieces, (words[end:], "")]
