"""Messages in other languages: catalogues of templates, by the English text that the program makes.

A key of a catalogue is an English message with {} where something is put in: a number, a place, a name, another
message. The translation has {} in the same order, or {1}, {2} ... in another one. A text is translated where it is
shown, as units are: the templates that fit it are found by what stands between their gaps, and what fills these is
translated in turn. See docs/decisions/0039-languages.md.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from itertools import accumulate
from pathlib import Path
from typing import Any, Literal

from groundslab.messages import Clause, Listed, Message, Name, fill, written
from groundslab.unit_systems import message_in
from groundslab.units import NUMBER

#: In what language results are shown.
Language = Literal["en", "de", "fr", "es", "pl"]
LANGUAGES: Mapping[Language, str] = {
    "en": "English", "de": "Deutsch", "fr": "Français", "es": "Español", "pl": "Polski",
}  # fmt: skip
#: What returns a text in a language.
Translator = Callable[[str], str]

#: Where texts that no template fits are parted, and the words there in other languages.
PARTED = ("; ", ": ", ", ", " + ", " / ")
WORDS_BETWEEN: Mapping[str, Mapping[str, str]] = {
    "de": {" and ": " und ", " or ": " oder "},
    "fr": {"; ": " ; ", ": ": " : ", " and ": " et ", " or ": " ou "},
    "es": {" and ": " y ", " or ": " o "},
    "pl": {" and ": " i ", " or ": " lub "},
}
#: A template of fewer letters, such as "{} at {}", is tried last.
FEW_LETTERS = 6
#: Of a text no more parts in each other are looked at than this.
DEEPEST = 8

_GAP = re.compile(r"\{(\d*)\}")
#: A hole of a message that is a value.
_NAMED = re.compile(r"\{([A-Za-z_]\w*)\}")
#: Between sentences.
_SENTENCES = re.compile(r"(?<=[.!?]) (?=[^\W\d_a-z])")
#: The point of an abbreviation and that of a sentence.
_TWO_STOPS = re.compile(r"(?<=[^\W\d_])\.\.(?!\.)")
#: A space that French does not break at.
_BEFORE_MARKS = re.compile(r" (?=[;:!?])")
_QUOTED = re.compile(r'"[^"]*"(?: \.\.\.)?')
_WHOLE_WORDS = re.compile(r"(?<![\0\w])[^\W\d_]+(?![\0\w])")
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
#: One or several clauses as what stands in brackets.
_CLAUSES = re.compile(r"(?:Table )?[\d.]+(?:\(\d+\))?(?:(?:, | and | to )[\d.]+(?:\(\d+\))?)*")
#: Numbers alone, with signs between them or a unit behind.
_NUMBERS = re.compile(
    rf"(?:{_PLACE.pattern}|{_ONE})(?:(?: x | / | \.\. |/| [<>]=? ){_ONE})*(?: ?[^\W\d]\w*(?:/\w+)?| %)?"
)


@dataclass(frozen=True)
class Template:
    """A message with gaps, and its translation."""

    pieces: tuple[str, ...]  # what stands before, between and behind the gaps
    translation: str

    @cached_property
    def letters(self) -> int:
        """Return how many letters of its own it has."""
        return len(re.findall(r"[^\W\d_]", "".join(self.pieces)))

    @cached_property
    def word(self) -> str:
        """Return the longest word that each text which fits has as a whole; empty if there is none."""
        inner = "\0".join(self.pieces)  # what fills a gap may go on with a word that ends there
        return max(_WHOLE_WORDS.findall(inner), key=len, default="")

    def fillings(self, text: str) -> list[str] | None:
        """Return what fills the gaps in a text, each as short as can be; None if the text does not fit."""
        first, *between, last = self.pieces
        if len(text) < len(first) + len(last) or not (text.startswith(first) and text.endswith(last)):
            return None
        filled, at, end = [], len(first), len(text) - len(last)
        for piece in between:
            found = text.find(piece, at, end)
            if found < 0:
                return None
            filled.append(text[at:found])
            at = found + len(piece)
        filled.append(text[at:end])
        return filled if all(map(_balanced, filled)) else None

    def keeps(self, gap: int, filling: str) -> bool:
        """Return whether what fills a gap stays: one clause or several in brackets, or the name of a file."""
        before, behind = self.pieces[gap], self.pieces[gap + 1]
        bracketed = before.endswith("(") and behind.startswith(")")
        return before.endswith("/") or (bracketed and _CLAUSES.fullmatch(filling) is not None)

    def filled(self, fillings: Sequence[str]) -> str:
        """Return the translation with its gaps filled."""
        order = iter(range(len(fillings)))
        filled = _GAP.sub(lambda gap: fillings[int(gap[1]) - 1 if gap[1] else next(order)], self.translation)
        return _TWO_STOPS.sub(".", filled)


#: A template, and what fills its gaps in a text.
Fit = tuple[Template, list[str]]


@dataclass(frozen=True, slots=True)
class Catalogue:
    """The messages of a language: whole ones by their text, those with gaps by a word that they have.

    Of templates that fit a text the one with the most letters of its own counts.
    """

    language: Language
    whole: Mapping[str, str]
    templates: Mapping[str, tuple[Template, ...]]
    names: frozenset[str] = frozenset()  # of things of a case, which stay
    unknown: list[str] | None = None  # gathers what has no translation, for tests
    _known: dict[str, str | None] = field(default_factory=dict)

    def __call__(self, text: str) -> str:
        """Return a text in the language; what has no translation stays."""
        translated = self._translated(text, 0)
        return _BEFORE_MARKS.sub("\N{NO-BREAK SPACE}", translated) if self.language == "fr" else translated

    def _translated(self, text: str, depth: int) -> str:
        if isinstance(text, Clause):
            return self.whole.get(text) or _WORDS.sub(lambda word: self.whole.get(word[0], word[0]), text)
        if isinstance(text, Name):
            if self.unknown is not None and text not in self.names and self.whole.get(text, text) != text:
                self.unknown.append(text)  # a label that was taken for a name
            return text
        if isinstance(text, Listed):
            mark = WORDS_BETWEEN[self.language].get(text.mark, text.mark)
            return mark.join(self._translated(part, depth) for part in text.parts)
        if isinstance(text, Message):
            return self._message(text)
        found = self._found(text, depth)
        if found is not None:
            return found
        sentences = _SENTENCES.split(text)
        if len(sentences) > 1:
            return " ".join(self._translated(each, depth + 1) for each in sentences)
        bare = text.strip()
        fits = self._fitting(bare) if depth < DEEPEST else []
        if fits:
            template, fillings = fits[0]
            filled = template.filled([self._translated(each, depth + 1) for each in fillings])
            return text.replace(bare, filled, 1)
        if self.unknown is not None:
            self.unknown.append(text)
        return text

    def _message(self, said: Message) -> str:
        """Return a message by the translation of its template, its values in the language.

        One of labels alone, such as "error of {name}", has an entry of its own where their words change their form.
        """
        if said in self.whole and all(type(value) is str for value in said.values.values()):
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
            text = self._translated(value, 0) if isinstance(value, str) else written(value, spec, said.units)
            return written(text, spec) if isinstance(value, str) else with_commas(text)

        return _TWO_STOPS.sub(".", fill(template, said.template, said.values, write))

    def _found(self, text: str, depth: int) -> str | None:
        """Return the translation of a text, None if a part of it has none."""
        if text not in self._known and depth <= DEEPEST:
            self._known[text] = self._looked_for(text, depth)
        return self._known.get(text)

    def _looked_for(self, text: str, depth: int) -> str | None:
        bare = text.strip()
        if not bare or bare in self.names or _QUOTED.fullmatch(bare):
            return text
        if bare in self.whole:
            return text.replace(bare, self.whole[bare], 1)
        if not _WORD.search(bare):
            return with_commas(text)
        factor, _, name = bare.partition(" ")
        if name in self.names and _NUMBERS.fullmatch(factor):
            return f"{with_commas(factor)} {name}"
        fits = self._fitting(bare)
        telling = [fit for fit in fits if fit[0].letters >= FEW_LETTERS]
        found = (
            self._joined(_SENTENCES.split(bare), " ", depth)
            or self._by(telling, depth)
            or self._parted(bare, depth)
            or self._by(fits[len(telling) :], depth)
        )
        if found is None and _NUMBERS.fullmatch(bare):
            return with_commas(text)
        return None if found is None else text.replace(bare, found, 1)

    def _fitting(self, bare: str) -> list[Fit]:
        """Return the templates that a text fits with what fills them, those with most letters of their own first.

        Of as many letters that with the longest word comes first, so that the order is the same in every process.
        """
        words = dict.fromkeys(["", *_WORDS.findall(bare)])
        candidates = (each for word in words for each in self.templates.get(word, ()))
        fits = [(each, fillings) for each in candidates if (fillings := each.fillings(bare)) is not None]
        return sorted(fits, key=lambda fit: (-fit[0].letters, -len(fit[0].word)))

    def _by(self, fits: Iterable[Fit], depth: int) -> str | None:
        """Return what the first template says all of whose fillings are known; None if there is none."""
        for template, fillings in fits:
            known = self._all_found(fillings, depth)
            if known is not None:
                kept = [template.keeps(gap, filling) for gap, filling in enumerate(fillings)]
                stay = [filling.replace("Table ", f"{self.whole.get('Table', 'Table')} ") for filling in fillings]
                return template.filled([a if keep else b for a, b, keep in zip(stay, known, kept, strict=True)])
        return None

    def _parted(self, bare: str, depth: int) -> str | None:
        """Return a text that is a list of messages; None if one of them is not known."""
        between = WORDS_BETWEEN[self.language]
        joined = (
            self._joined(split_outside(bare, mark), between.get(mark, mark), depth) for mark in (*PARTED, *between)
        )
        return next(filter(None, joined), None)

    def _joined(self, parts: Sequence[str], between: str, depth: int) -> str | None:
        """Return parts of a text, joined; None if there is one alone, or one of them is not known."""
        known = self._all_found(parts, depth) if len(parts) > 1 else None
        return None if known is None else between.join(known)

    def _all_found(self, texts: Sequence[str], depth: int) -> list[str] | None:
        """Return the translations of all texts, None if one of them has none."""
        known = []
        for text in texts:
            if (found := self._found(text, depth + 1)) is None:
                return None
            known.append(found)
        return known


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


def split_outside(text: str, mark: str) -> list[str]:
    """Return a text parted at a mark, but not within brackets or quotes."""
    if mark not in text:
        return [text]
    parts, start, depth, quoted = [], 0, 0, False
    for at, letter in enumerate(text):
        if not depth and not quoted and at >= start and text.startswith(mark, at):
            parts.append(text[start:at])
            start = at + len(mark)
        depth += (letter in "([") - (letter in ")]")
        quoted ^= letter == '"'
    return [*parts, text[start:]]


def _balanced(text: str) -> bool:
    """Return whether brackets and quotes that open in a text close in it, and no others do."""
    depths = list(accumulate((letter in "([") - (letter in ")]") for letter in text))
    return text.count('"') % 2 == 0 and (not depths or (min(depths) >= 0 and depths[-1] == 0))


def translator(language: Language, names: Iterable[str] = ()) -> Translator:
    """Return what translates messages into a language; names of a case that are messages too stay as they are."""
    if language == "en":
        return str
    read = _catalogue(language)
    return Catalogue(language, read.whole, read.templates, frozenset(names))


def page_messages(language: Language, wanted: Container[str] | None = None) -> dict[str, Any]:
    """Return what a page needs to translate messages: all, or those wanted, and the marks between those of a list."""
    read = messages(language) if language != "en" else {}
    known = dict(_with_sentences(read)) | {
        key.strip(): value.strip() for key, value in read.items() if _NAMED.search(key)
    }
    chosen = {key: value for key, value in known.items() if wanted is None or key in wanted}
    marks = {mark: mark for mark in PARTED} | dict(WORDS_BETWEEN.get(language, {}))
    return {"language": language, "messages": chosen, "marks": marks}


def messages(language: Language) -> dict[str, str]:
    """Return the messages of a language's catalogue by their English text."""
    return tomllib.loads(Path(__file__).with_name(f"{language}.toml").read_text(encoding="utf-8"))


def _with_gaps(message: str, translation: str) -> tuple[str, str]:
    """Return a message with gaps in place of named holes, and its translation, for texts that are no values."""
    names = _NAMED.findall(message)
    if not names:
        return message, translation
    numbered = _NAMED.sub(lambda hole: f"{{{names.index(hole[1]) + 1}}}", translation)
    in_order = [f"{{{number}}}" for number in range(1, len(names) + 1)] == re.findall(r"\{\d+\}", numbered)
    return _NAMED.sub("{}", message), re.sub(r"\{\d+\}", "{}", numbered) if in_order else numbered


@cache
def _catalogue(language: Language) -> Catalogue:
    """Return the catalogue of a language."""
    read = messages(language)
    known = dict(_with_sentences(read))
    whole = {key: value for key, value in known.items() if not _GAP.search(key)}
    whole |= {key.strip(): value.strip() for key, value in read.items() if _NAMED.search(key)}
    templates: dict[str, list[Template]] = {}
    for key, value in known.items():
        if _GAP.search(key):
            template = Template(tuple(_GAP.split(key)[::2]), value)
            templates.setdefault(template.word, []).append(template)
    return Catalogue(language, whole, {word: tuple(those) for word, those in templates.items()})


def _with_sentences(known: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Yield messages, and before those of several sentences each of them, if the translation has as many.

    And those about quantities in both systems of units.

    The space around a message stays as it is in a text.
    """
    known = dict(_with_gaps(*pair) for pair in known.items())
    customary = {message_in(key, "US"): message_in(value, "US") for key, value in known.items()}
    for message, translation in ((key.strip(), value.strip()) for key, value in {**customary, **known}.items()):
        parts, others = _SENTENCES.split(message), _SENTENCES.split(translation)
        if 1 < len(parts) == len(others) and "{1}" not in translation:
            yield from ((part, other) for part, other in zip(parts, others, strict=True) if part not in known)
        yield message, translation
