"""Catalogues of messages: whole, alike, and found from the texts that the program makes."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from babel.messages.pofile import read_po
from tests.helpers.paths import PACKAGE, ROOT

from groundslab.languages import LANGUAGES, Language, translator
from groundslab.languages.catalogue import Catalogue, messages, with_commas
from groundslab.messages import CAPITAL, Clause, Label, Message, Name, holes_of, joined, key_of, written
from groundslab.unit_systems import CUSTOMARY

OTHERS: list[Language] = [language for language in LANGUAGES if language != "en"]
#: A hole with a format: of the template of a message.
FORMATTED = re.compile(r"\{[a-z]\w*:[^{}]+\}", re.IGNORECASE)
HOLE = re.compile(r"\{([A-Za-z_]\w*)\}")
#: Where messages are made that reports and summaries show.
SOURCES = (
    "design", "results/fields.py", "model/remarks", "views/summary", "views/report/assumptions.py", "views/tables",
    "views/drawing", "views/ground_comparison",
)  # fmt: skip
#: What raises, compiles or draws has no messages for readers.
ELSEWHERE = {"Issue", "InputError", "RelativeIssue", "compile", "einsum", "ValueError", "import_optional"}
#: Formulas, keys and names of styles.
NO_MESSAGE = re.compile(r"[\^*]|\w\(|->|^[\w.-]+$|^\w+\.\w+$|^bold |[<>]=?\"|^groundslab\b|sha256|^drawn by")


def catalogue(*pairs: tuple[str, str], names: tuple[str, ...] = ()) -> Catalogue:
    """Return a catalogue of a few messages."""
    return Catalogue("de", dict(pairs), frozenset(names))


@pytest.mark.parametrize("language", OTHERS)
def test_catalogues_have_the_same_messages(language: Language) -> None:
    """No language lacks a message that another one has."""
    assert messages(language).keys() == messages("de").keys()


@pytest.mark.parametrize("language", OTHERS)
def test_what_is_read_was_compiled_of_the_catalogue(language: Language) -> None:
    """The JSON has each entry of the .po file (else run make pages), and no entry is doubtful."""
    with (PACKAGE / "languages" / f"{language}.po").open("rb") as file:
        entries = [entry for entry in read_po(file, abort_invalid=True) if entry.id]
    assert not [entry.id for entry in entries if entry.fuzzy]
    assert messages(language) == {entry.id: entry.string for entry in entries}


@pytest.mark.parametrize("language", OTHERS)
def test_translations_have_the_holes_of_their_messages(language: Language) -> None:
    """Each hole by its name; no translation is empty, and none has a hole without a name."""
    for message, translation in messages(language).items():
        assert sorted(HOLE.findall(translation)) == sorted(HOLE.findall(message)), message
        assert translation or not message, message
        assert not re.search(r"[{}]", HOLE.sub("", message + translation)), message


@pytest.mark.parametrize("language", OTHERS)
def test_translations_have_the_numbers_of_their_messages(language: Language) -> None:
    """Limits, clauses and factors are the same; "below 0" may be "negative"."""
    number = re.compile(r"(?<![\w.,])\d+(?:[.,]\d+)?(?!\w|-\w|[.,]\d)")
    for message, translation in messages(language).items():
        here, there = (
            Counter(found.replace(",", ".") for found in number.findall(text) if found != "0")
            for text in (message, translation)
        )
        assert here == there, message


@pytest.mark.parametrize("language", OTHERS)
def test_most_messages_differ_from_english(language: Language) -> None:
    """A catalogue that repeats English would pass all other tests."""
    known = messages(language)
    same = [message for message, translation in known.items() if message == translation]
    assert len(same) < 0.06 * len(known)


def test_english_is_left_alone() -> None:
    """The texts are not looked at."""
    assert translator("en") is str


def test_holes_are_filled_with_translations() -> None:
    """What fills a hole is a label, a number, a message or a name; the order may change."""
    translate = catalogue(
        ("{what} of {of} is too large", "{of}: {what} ist zu groß"), ("settlement", "Setzung"), ("wind", "Wind")
    )
    said = "{what} of {of} is too large"
    assert translate(Message(said, what="settlement", of=Name("wind"))) == "wind: Setzung ist zu groß"
    assert translate(Message("{what:.2f m} of {of} is too large", what=3.5, of="wind")) == "Wind: 3,50 m ist zu groß"
    assert translate(joined(("wind", "settlement"), " and ")) == "Wind und Setzung"


def test_nothing_is_guessed() -> None:
    """A text that is no message is known whole or not at all; names stay, figures have decimal commas."""
    translate = catalogue(("{a} and {b}", "{a} und {b}"), ("wind", "Wind"), ("Save", "Sichern"), names=("Save",))
    for text in ("wind and wind", "wind, wind", "wind. Wind", '"wind"', "Save", "", "Wind 2.5", "wind 2.5"):
        assert translate(text) == text
    assert translate(Label(" wind ")) == " Wind "
    assert [translate(text) for text in ("2.5 kNm/m", "(1.5, 2) m", "0.5 %")] == ["2,5 kNm/m", "(1,5; 2) m", "0,5 %"]
    assert translate(Clause("7.3.4")) == "7.3.4"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("w_k 0.256 <= 0.3 mm (7.3.4)", "w_k 0,256 <= 0,3 mm (7.3.4)"),
        ("(10.000, -2.500) m", "(10,000; -2,500) m"),
        ("(7.007, 4.850)*", "(7,007; 4,850)*"),
        ("6.4.4(2)", "6.4.4(2)"),
        ("EN 1992-1-1 6.4", "EN 1992-1-1 6.4"),
        ("A' = 64.7 m2 (7.15 x 9.04 m)", "A' = 64,7 m2 (7,15 x 9,04 m)"),
        ("1.5e-06", "1,5e-06"),
        ("±1.4 %", "±1,4 %"),
        ("case.toml", "case.toml"),
        ("(0.15, 2) (11.85, 0.15) m", "(0,15; 2) (11,85; 0,15) m"),
        ("1.35, 1", "1,35; 1"),
    ],
)
def test_decimal_commas(text: str, expected: str) -> None:
    """Numbers have them, clauses keep their points."""
    assert with_commas(text) == expected


def test_an_abbreviation_ends_a_sentence_with_its_point() -> None:
    """One point is enough."""
    translate = catalogue(("Governs the {what}.", "Maßgebend: {what}."), ("largest settlement", "Setzung max."))
    assert translate(Message("Governs the {what}.", what="largest settlement")) == "Maßgebend: Setzung max."


def test_french_has_spaces_before_marks() -> None:
    """Also where messages are joined, and no line breaks there."""
    said = joined((joined(("settlement", Name("C4")), ": "), "mesh"), "; ")
    assert translator("fr")(said) == "tassement\xa0: C4\xa0; maillage"


def test_digits_in_groups_are_no_decimals() -> None:
    """1,300 unknowns are not 1.3."""
    assert with_commas("1,300") == "1\N{NARROW NO-BREAK SPACE}300"
    assert with_commas("1,234,567") == "1\N{NARROW NO-BREAK SPACE}234\N{NARROW NO-BREAK SPACE}567"
    assert with_commas("(1.5, 300.25)") == "(1,5; 300,25)"


def made_messages() -> Iterator[str]:
    """Yield the texts of the sources that readers see."""
    for source in SOURCES:
        path = Path(ROOT, "src", "groundslab", source)
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            yield from texts_of(ast.parse(file.read_text(encoding="utf-8")))


def texts_of(tree: ast.AST) -> Iterator[str]:
    """Yield the texts of a module, templates by their keys; not docstrings, what raises and what is put together."""
    for node in ast.iter_child_nodes(tree):
        called = node.func if isinstance(node, ast.Call) else None
        name = getattr(called, "id", getattr(called, "attr", ""))
        if isinstance(node, ast.Raise | ast.JoinedStr) or name in ELSEWHERE:
            continue
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue
        if isinstance(node, ast.Call) and name in ("Message", "counted"):
            for part in (*node.args, *node.keywords):
                given = part.value if isinstance(part, ast.Constant) else None
                yield from [key_of(given)] if isinstance(given, str) else texts_of(part)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            is_template = FORMATTED.search(node.value) and not NO_MESSAGE.search(node.value)
            yield key_of(node.value) if is_template else node.value
        else:
            yield from texts_of(node)


@cache
def modules() -> tuple[tuple[Path, tuple[ast.AST, ...]], ...]:
    """Return the modules of the package with the nodes of each."""
    files = sorted(PACKAGE.rglob("*.py"))
    return tuple((file, tuple(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))) for file in files)


@cache
def said() -> tuple[tuple[str, str, set[str]], ...]:
    """Return where each message of the package is, its template, and the names of its values."""
    return tuple(_said())


def _said() -> Iterator[tuple[str, str, set[str]]]:
    for path, nodes in modules():
        for node in nodes:
            called = getattr(node.func, "id", "") if isinstance(node, ast.Call) else ""
            if isinstance(node, ast.Call) and called in ("Message", "counted"):
                given = {keyword.arg or "" for keyword in node.keywords}
                for part in (part for part in node.args if isinstance(part, ast.Constant)):
                    yield f"{path.name}:{node.lineno}", str(part.value), given


def test_each_hole_has_a_value_and_a_known_unit() -> None:
    """In branches, too, that no test takes: no value is missing or for nothing, and none is left in SI units."""
    templates = said()
    assert len(templates) > 400
    for where, template, given in templates:
        holes = [(name, spec) for _, name, spec in holes_of(template) if name is not None]
        if "" not in given:  # values that are handed on
            assert {name for name, _ in holes} - {"count"} == given - {"count"}, (where, template)
        for _, spec in holes:
            unit = spec.partition(" ")[2].strip("()")
            assert not unit or unit in CUSTOMARY, (where, template)
            assert spec == CAPITAL or written(1.5, spec, "US")


def test_each_text_has_a_translation() -> None:
    """Messages of the whole package, but for commands that speak English alone, and labels that readers see.

    All that lack one are told at once; what one catalogue has, every one has.
    """
    asked = Catalogue("de", messages("de"), unknown=[])
    lacking = {
        key
        for where, template, _ in said()
        if not where.startswith(("case.py", "propose_bars.py")) and is_lacking(key := key_of(template).strip(), asked)
    }
    for text in made_messages():
        if HOLE.search(text):
            lacking |= {text} if is_lacking(text.strip(), asked) else set()
        elif len(re.findall(r"[A-Za-z]{3,}", text)) > 1 and not NO_MESSAGE.search(text):
            asked(text)
    assert sorted(lacking.union(asked.unknown or ())) == []


def is_lacking(key: str, known: Catalogue) -> bool:
    """Return whether a template has words and no translation."""
    return key not in known.whole and re.search(r"[a-z]{3}", HOLE.sub("", key)) is not None


#: Templates that pages make of what items are called, as "{count} beams", "opening {name}" or "mirror {items}".
OF_ITEMS = re.compile(r"\{count\} [a-z ]+|[a-z ]+ \{(?:name|items)\}")


def test_each_template_is_asked_for() -> None:
    """A template stands as it is in a source, as its key; only joined ones make longer texts, part by part."""
    asked, put_together = sources()
    templates = [key for key in messages("de") if re.search(r"[a-z]{3}", HOLE.sub("", key)) and HOLE.search(key)]
    assert len(templates) > 700
    left = [key for key in templates if spaced(key) not in asked and not OF_ITEMS.fullmatch(key)]
    assert [key for key in left if not any(each.fullmatch(spaced(key)) for each in put_together)] == []


def sources() -> tuple[str, list[re.Pattern[str]]]:
    """Return all texts of the program and its pages, and patterns of those with other texts in them."""
    nodes = [node for _, of_module in modules() for node in of_module]
    texts = [node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    for pattern in ("web/src/**/*.ts", "src/groundslab/**/templates/**/*.*"):
        files = [file.read_text(encoding="utf-8") for file in ROOT.glob(pattern) if file.is_file()]
        texts += [re.sub(r"[\"'`]\s*\+\s*[\"'`]", "", file).replace('\\"', '"') for file in files]
    filled = [[part.value if isinstance(part, ast.Constant) else "\0" for part in node.values]
              for node in nodes if isinstance(node, ast.JoinedStr)]  # fmt: skip
    patterns = {re.escape(spaced("".join(map(str, parts)))).replace("\0", ".*") for parts in filled}
    return "\n".join(map(spaced, texts)), [re.compile(each) for each in patterns if re.search("[a-z]{3}", each)]


def spaced(text: str) -> str:
    """Return a text with the names of its holes, each white space a single one."""
    return re.sub(r"\s+", " ", re.sub(r"\{(\w*)[^{}]*\}", r"{\1}", text)).strip().lower()
