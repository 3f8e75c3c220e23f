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
_POWERED = rf"(?:(?<=\d )|(?<=\[))%s((?:[A-Za-z]+/)?{_LENGTH}\^?[234](?:/{_LENGTH}[234]?)?)%s(?!\w)"
#: A unit that has a power, behind its number or in brackets, and one that was said as a name.
_UNIT, _NAMED_UNIT = re.compile(_POWERED % ("", "")), re.compile(_POWERED % (_OPEN, _CLOSE))
#: A power of ten behind its number.
_EXPONENT = re.compile(r"(?<=\d)e([-+])0?(\d+)(?!\w)")
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+")
_POWER = re.compile(r"\^?([234])(?![\d.])")


def raised(unit: str) -> str:
    """Return a unit with its powers raised."""
    return _POWER.sub(lambda power: power[1].translate(_RAISED), unit)


def with_powers(text: str) -> str:
    """Return a text in which powers of ten are raised, and those of units behind their numbers and in brackets."""
    return _UNIT.sub(lambda unit: raised(unit[1]), written_out(text))


def written_out(number: str) -> str:
    """Return a number such as 4.5e-07 as 4.5·10⁻⁷."""
    return _EXPONENT.sub(lambda power: f"·10{(power[1] + power[2]).translate(_RAISED)}", number)


def set_sentence(text: str, translate: Translator) -> list[tuple[str, str]]:
    """Return a text in a language as pairs of what stands on the line and what below it; names are as given."""
    said = translate(with_names(text, lambda name: f"{_OPEN}{_MARKS.sub('', name)}{_CLOSE}"))
    pieces: list[tuple[str, str]] = []
    said = _NAMED_UNIT.sub(lambda unit: raised(unit[1]), said)
    for number, piece in enumerate(_MARKS.split(said)):
        pieces += [(piece, "")] if number % 2 else _with_indices(with_powers(piece))
    return [pair for pair in pieces if pair != ("", "")]


def _with_indices(words: str) -> list[tuple[str, str]]:
    """Return words without names in pairs: up to a symbol and its index, and what follows."""
    pieces: list[tuple[str, str]] = []
    end = 0
    for match in _SYMBOL.finditer(words):
        pieces.append((words[end : match.start()] + GREEK.get(match[1], match[1]), match[2]))
        end = match.end()
    return [*pieces, (words[end:], "")]
