"""Messages in other languages: catalogues of templates, by the English ones of the program.

A key of a catalogue is a template with its holes by their names, or a label without holes; so is its translation, its
holes in any order. A message is looked up by its template and its values are written in the language; all other texts
are looked up whole. See docs/decisions/0041-messages.md.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Literal

from groundslab.errors import GroundslabError
from groundslab.messages import Clause, Label, Listed, Message, Name, fill, written
from groundslab.units import NUMBER

#: In what language results are shown.
Language = Literal["en", "de", "fr", "es", "pl"]
LANGUAGES: Mapping[Language, str] = {
    "en": "English", "de": "Deutsch", "fr": "Français", "es": "Español", "pl": "Polski",
}  # fmt: skip
#: What returns a text in a language.
Translator = Callable[[str], str]

#: Marks between the texts of a list in other languages.
WORDS_BETWEEN: Mapping[str, Mapping[str, str]] = {
    "de": {" and ": " und ", " or ": " oder "},
    "fr": {"; ": " ; ", ": ": " : ", " and ": " et ", " or ": " ou "},
    "es": {" and ": " y ", " or ": " o "},
    "pl": {" and ": " i ", " or ": " lub "},
}

#: A hole of a message that is a value.
_NAMED = re.compile(r"\{([A-Za-z_]\w*)\}")
#: The point of an abbreviation and that of a sentence.
_TWO_STOPS = re.compile(r"(?<=[^\W\d_])\.\.(?!\.)")
#: A space that French does not break at.
_BEFORE_MARKS = re.compile(r" (?=[;:!?])")
_QUOTED = re.compile(r'"[^"]*"(?: \.\.\.)?')
_WORDS = re.compile(r"(?<![\0\w])[^\W\d_]+(?![\0\w])")
_WORDS = re.compile(r"[^\W\d_]+")
#: Units and letters that are written as words.
_NO_WORDS = (
    "MPa|kPa|GPa|kNm|MNm|kip|psi|psf|pcf|pci|ksi|ksf|lbf|rad|mrad|alpha|beta|gamma|eta|theta|lambda|mu|nu|xi|rho|sigma|"
    "tau|phi|omega|cos|sin|tan|exp|sqrt|pardiso|[A-Z]{2,3}|ASCE"
)
#: A text without any of these needs no translation, as symbols, units and clauses do not.
_WORD = re.compile(
    rf"(?<![\w^,])(?!(?:{_NO_WORDS})(?!\w))[^\W\d_]{{3,}}(?!\w)|(?<![\w.])(?:as|at|by|in|is|no|of|on|or|to)(?![\w.,])"
)
_ONE = NUMBER.replace("[+-]", "[+\N{MINUS SIGN}-]")
#: A place, or a number with a fraction that is none of a clause such as "6.4.4(2)", of an edition or of an annex.
_PLACE = re.compile(rf"[(\[]{_ONE}(?:, {_ONE})+[)\]]")
_LISTED = re.compile(rf"{_ONE}(?:, {_ONE})+")
_PLACES = re.compile(rf"{_PLACE.pattern}(?: {_PLACE.pattern})+(?: \w+)?")
_FRACTION = re.compile(r"(?<![\w.,])([+\N{MINUS SIGN}-]?\d*)\.(\d+(?:[eE][+-]?\d+)?)(?![\w.(])")
#: Digits in groups of three, which a narrow space parts where commas are decimal.
_GROUPED = re.compile(r"(?<![\w.,])[+\N{MINUS SIGN}-]?\d{1,3}(?:,\d{3})+(?![\w,.])")
THIN_SPACE = "\N{NARROW NO-BREAK SPACE}"
#: Clauses: of three parts, in brackets but for places, or behind a code.
_CLAUSE = re.compile(
    r"\d+(?:\.\d+){2,}(?:\(\d+\))?|\d+\.\d+\(\d+\)|\((?:Table )?\d+\.\d+(?:, \d+\.\d+)*\)(?! ?(?:m\b|ft\b|\*))"
    r"|\b(?:EN|ACI|TR|DIN|BS|ASCE)[\s\d.:()/-]*"
)
#: Numbers alone, with signs between them or a unit behind.
_NUMBERS = re.compile(
    rf"(?:{_PLACE.pattern}|{_ONE})(?:(?: x | / | \.\. |/| [<>]=? ){_ONE})*(?: ?[^\W\d]\w*(?:/\w+)?| %)?"
)


@dataclass(frozen=True, slots=True)
class Catalogue:
    """The messages of a language by their English text."""

    language: Language
    whole: Mapping[str, str]
    names: frozenset[str] = frozenset()  # of things of a case, which stay
    unknown: list[str] | None = None  # gathers what has no translation, for tests
    _known: dict[str, str] = field(default_factory=dict)

    def __call__(self, text: str) -> str:
        """Return a text in the language; what has no translation stays."""
        translated = self._translated(text)
        return _BEFORE_MARKS.sub("\N{NO-BREAK SPACE}", translated) if self.language == "fr" else translated

    def _translated(self, text: str) -> str:
        if isinstance(text, Clause):
            return self.whole.get(text) or _WORDS.sub(lambda word: self.whole.get(word[0], word[0]), text)
        if isinstance(text, Name):
            if self.unknown is not None and text not in self.names and self.whole.get(text, text) != text:
                self.unknown.append(text)  # a label that was taken for a name
            return text
        if isinstance(text, Listed):
            mark = WORDS_BETWEEN[self.language].get(text.mark, text.mark)
            return mark.join(map(self._translated, text.parts))
        if isinstance(text, Message):
            return self._message(text)
        if text not in self._known:
            self._known[text] = self._label(text)
        return self._known[text]

    def _label(self, text: str) -> str:
        """Return a text without values: words are looked up whole, the numbers of a figure have decimal commas."""
        bare = text.strip()
        if not bare or bare in self.names or _QUOTED.fullmatch(bare):
            return text
        if bare in self.whole:
            return text.replace(bare, self.whole[bare], 1)
        if not _WORD.search(bare) or _NUMBERS.fullmatch(bare):
            return with_commas(text)
        if self.unknown is not None:
            self.unknown.append(text)
        return text

    def _message(self, said: Message) -> str:
        """Return a message by the translation of its template, its values in the language.

        One of labels alone, such as "error of {name}", has an entry of its own where their words change their form.
        """
        if said in self.whole and all(type(value) in (str, Label) for value in said.values.values()):
            return self.whole[said]
        key = said.key
        template = self.whole.get(key.strip())
        if template is None:
            if self.unknown is not None and _WORD.search(_NAMED.sub("", key)):
                self.unknown.append(key)
            template = key
        else:
            template = key.replace(key.strip(), template, 1)

        def write(value: Any, spec: str) -> str:
            text = self._translated(value) if isinstance(value, str) else written(value, spec, said.units)
            return written(text, spec) if isinstance(value, str) else with_commas(text)

        return _TWO_STOPS.sub(".", fill(template, said.template, said.values, write))


def with_commas(text: str) -> str:
    """Return a text without words, its numbers with decimal commas, those of places apart by semicolons.

    Clauses keep their points: "w_k 0.256 <= 0.3 mm (7.3.4)" is "w_k 0,256 <= 0,3 mm (7.3.4)".
    """
    if _PLACE.fullmatch(text.strip()) or _PLACES.fullmatch(text.strip()):
        return _commas(text)
    if _LISTED.fullmatch(text.strip()):
        return _commas(text.replace(", ", "; "))
    pieces, at = [], 0
    for clause in _CLAUSE.finditer(text):
        pieces += [_commas(text[at : clause.start()]), clause[0]]
        at = clause.end()
    return "".join([*pieces, _commas(text[at:])])


def _commas(text: str) -> str:
    spaced = _PLACE.sub(lambda place: place[0].replace(", ", "; "), text)
    grouped = _GROUPED.sub(lambda number: number[0].replace(",", THIN_SPACE), spaced)
    return _FRACTION.sub(r"\1,\2", grouped)


def translator(language: Language, names: Iterable[str] = ()) -> Translator:
    """Return what translates messages into a language; names of a case that are messages too stay as they are."""
    return str if language == "en" else Catalogue(language, messages(language), frozenset(names))


def page_messages(language: Language, wanted: Container[str] | None = None) -> dict[str, Any]:
    """Return what a page needs to say its own words: all messages, or those wanted."""
    translated = messages(language) if language != "en" else {}
    chosen = {key: value for key, value in translated.items() if wanted is None or key in wanted}
    return {"language": language, "messages": chosen}


@cache
def messages(language: Language) -> Mapping[str, str]:
    """Return the messages of a language's catalogue by their English text, as they were compiled of its .po file."""
    try:
        text = (Path(__file__).parent / "static" / f"{language}.json").read_text(encoding="utf-8")
    except OSError:
        raise GroundslabError(
            f"{language}.json, the messages in {LANGUAGES[language]}, are missing from this installation; reinstall "
            "groundslab, or build it from its source: make pages"
        ) from None
    read: dict[str, str] = json.loads(text)
    return read
