"""Catalogues of messages: whole, alike, and found from the texts that the program makes."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from tests.helpers.paths import ROOT

from groundslab.languages import LANGUAGES, Language, translator
from groundslab.languages.catalogue import Catalogue, Template, messages, with_commas
from groundslab.messages import CAPITAL, holes_of, key_of, written
from groundslab.unit_systems import CUSTOMARY

OTHERS: list[Language] = [language for language in LANGUAGES if language != "en"]
GAP = re.compile(r"\{(\d*)\}")
#: A hole with a format: of the template of a message.
FORMATTED = re.compile(r"\{[a-z]\w*:[^{}]+\}", re.IGNORECASE)
HOLE = re.compile(r"\{([A-Za-z_]\w*)\}")
#: Where messages are made that reports and summaries show.
SOURCES = ("design", "results/fields.py", "model/remarks", "views/summary", "views/report/assumptions.py")
#: What raises, compiles or draws has no messages for readers.
ELSEWHERE = {"Issue", "InputError", "RelativeIssue", "compile", "einsum", "ValueError", "import_optional"}
#: Messages whose verbs are put in, which the reports of examples have whole.
CUT = {"DESIGN NEEDS ATTENTION: 1 of 1 1 it."}
#: Formulas, keys and names of styles.
NO_MESSAGE = re.compile(r"[\^*]|\w\(|->|^[\w.-]+$|^\w+\.\w+$|^bold |[<>]=?\"|^groundslab\b")


def catalogue(*pairs: tuple[str, str], names: tuple[str, ...] = ()) -> Catalogue:
    """Return a catalogue of a few messages."""
    templates: dict[str, tuple[Template, ...]] = {}
    for message, translation in pairs:
        if "{" in message:
            template = Template(tuple(GAP.split(message)[::2]), translation)
            templates[template.word] = (*templates.get(template.word, ()), template)
    whole = {message: translation for message, translation in pairs if "{" not in message}
    return Catalogue("de", whole, templates, frozenset(names))


@pytest.mark.parametrize("language", OTHERS)
def test_catalogues_have_the_same_messages(language: Language) -> None:
    """No language lacks a message that another one has."""
    assert messages(language).keys() == messages("de").keys()


@pytest.mark.parametrize("language", OTHERS)
def test_translations_have_the_gaps_of_their_messages(language: Language) -> None:
    """Each gap once; those with numbers all of them; and no translation is empty."""
    for message, translation in messages(language).items():
        gaps, count = GAP.findall(translation), len(GAP.findall(message))
        in_order, numbered = [""] * count, [str(number) for number in range(1, count + 1)]
        assert gaps == in_order or sorted(gaps) == numbered, message
        assert sorted(HOLE.findall(translation)) == sorted(HOLE.findall(message)), message
        assert translation.strip() or not message.strip(), message
        assert not re.search(r"[{}]", HOLE.sub("", GAP.sub("", message + translation))), message


@pytest.mark.parametrize("language", OTHERS)
def test_translations_have_the_numbers_of_their_messages(language: Language) -> None:
    """Limits, clauses and factors are the same; "below 0" may be "negative"."""
    number = re.compile(r"(?<![\w.,])\d+(?:[.,]\d+)?(?!\w|-\w|[.,]\d)")
    for message, translation in messages(language).items():
        here, there = (
            Counter(found.replace(",", ".") for found in number.findall(GAP.sub("", text)) if found != "0")
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


def test_gaps_are_filled_with_translations() -> None:
    """What fills a gap is a message, a number or a name; the order may change."""
    translate = catalogue(
        ("{} of {} is too large", "{2}: {1} ist zu groß"), ("settlement", "Setzung"), ("wind", "Wind"), names=("wind",)
    )
    assert translate("settlement of wind is too large") == "wind: Setzung ist zu groß"
    assert translate("3.5 of C1 is too large") == "C1: 3,5 ist zu groß"
    assert translate('settlement of "wind" is too large') == '"wind": Setzung ist zu groß'


def test_the_template_that_says_most_is_taken() -> None:
    """Of those that fit, if all that fills their gaps is known."""
    translate = catalogue(
        ("{} at {}", "{} bei {}"), ("largest moment at {}", "größtes Moment bei {}"), ("moment", "Moment"),
        ("largest {}", "größtes {}"),
    )  # fmt: skip
    assert translate("largest moment at (1.5, 2) m") == "größtes Moment bei (1,5; 2) m"
    assert translate("moment at (1.5, 2) m") == "Moment bei (1,5; 2) m"
    assert translate("largest step at (1.5, 2) m") == "größtes step bei (1,5; 2) m"


def test_names_in_quotes_stay() -> None:
    """Alone, in lists, and with marks in them."""
    translate = catalogue(("left out: {}", "fehlt: {}"), ("wind", "Wind"))
    assert translate('left out: "wind, north" and "wind"') == 'fehlt: "wind, north" und "wind"'


def test_brackets_stay_together() -> None:
    """No gap begins within brackets and ends beyond them."""
    translate = catalogue(("ends ({})", "Enden ({})"), ("corners ({})", "Ecken ({})"))
    assert translate("ends (12), corners (1)") == "Enden (12), Ecken (1)"


def test_sentences_are_known_by_themselves() -> None:
    """In a text of several, and from a message of several."""
    translate = translator("de")
    first = "Plate and ground exchange vertical pressure without friction."
    second = "The ground carries no tension: the plate lifts off."
    assert translate(f"{second} {first}") == f"{translate(second)} {translate(first)}"
    assert "Baugrund" in translate(first)


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


def test_of_templates_that_say_as_much_one_is_taken_always() -> None:
    """That with the longest word, whatever the hashes of words are in a process."""
    text = (
        'v_u 11.5 kip/ft at (0, 5.5) ft in "ULS" is 0.877 times phi v_c 13.1 kip/ft with the bars provided (22.5.5.1)'
    )
    assert "mit der vorhandenen Bewehrung" in translator("de", ["ULS"])(text)


def test_names_of_files_stay() -> None:
    """A table's file is where it is, though the table's name has a translation."""
    translate = catalogue(("tables/{}.csv", "tables/{}.csv"), ("columns", "Stützen"))
    assert translate("tables/columns.csv") == "tables/columns.csv"


def test_an_abbreviation_ends_a_sentence_with_its_point() -> None:
    """One point is enough."""
    translate = catalogue(("Governs the {}.", "Maßgebend: {}."), ("largest settlement", "Setzung max."))
    assert translate("Governs the largest settlement.") == "Maßgebend: Setzung max."


def test_french_has_spaces_before_marks() -> None:
    """Also where messages are joined, and no line breaks there."""
    translate = translator("fr")
    assert translate("settlement: C4; mesh") == "tassement\xa0: C4\xa0; maillage"


def test_combinations_and_uses_of_cases() -> None:
    """Limit states by their names, and factors with commas."""
    translate = translator("es", ["G", "Q", "ULS 1"])
    assert translate("ultimate 1.05 to 1.5 (6 of 10); characteristic 1 (5 of 5)") == (
        "ELU 1,05 a 1,5 (6 de 10); característica 1 (5 de 5)"
    )
    assert translate("ULS 1 (ultimate, EN 1990 6.10): 1.35 G + 1.5 Q") == "ULS 1 (ELU, EN 1990 6.10): 1,35 G + 1,5 Q"


def test_messages_are_known_in_both_systems_of_units() -> None:
    """A sentence about kN/m is one about kip/ft in the United States."""
    said = 'v_Ed {} at (1.2, 3.4) {} in "ULS" is 0.4 times v_Rd,c {} with the bars provided (6.2.2)'
    german = (
        'v_Ed {} an (1,2; 3,4) {} in "ULS" beträgt das 0,4-Fache von v_Rd,c {} mit der vorhandenen Bewehrung (6.2.2)'
    )
    for force, length in (("{} kN/m", "m"), ("{} kip/ft", "ft")):
        parts = (force.format("4.24"), length, force.format("10.6"))
        commas = (force.format("4,24"), length, force.format("10,6"))
        assert translator("de")(said.format(*parts)) == german.format(*commas)


def test_digits_in_groups_are_no_decimals() -> None:
    """1,300 unknowns are not 1.3."""
    assert with_commas("1,300") == "1\N{NARROW NO-BREAK SPACE}300"
    assert with_commas("1,234,567") == "1\N{NARROW NO-BREAK SPACE}234\N{NARROW NO-BREAK SPACE}567"
    assert with_commas("(1.5, 300.25)") == "(1,5; 300,25)"


def test_clauses_in_brackets_of_messages_keep_their_points() -> None:
    """As in "(6.1, 9.2.1.1(1))", which are no numbers."""
    translate = catalogue(("by moment ({})", "nach Moment ({})"))
    assert translate("by moment (6.1, 9.2.1.1(1))") == "nach Moment (6.1, 9.2.1.1(1))"
    assert translate("by moment (9.2)") == "nach Moment (9.2)"


def test_long_texts_are_looked_at_once() -> None:
    """A text of a thousand parts that nothing knows is not parted again and again."""
    translate = catalogue(("{} and {}", "{} und {}"), ("such", "solch"))
    text = ", ".join(f"unknown {number} and none; or (such) / that: this" for number in range(1000))
    assert translate(text).count("unknown") == 1000
    assert len(translate._known) < 100


def made_messages() -> Iterator[str]:
    """Yield the texts of the sources that readers see, their gaps filled with a number."""
    for source in SOURCES:
        path = Path(ROOT, "src", "groundslab", source)
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            yield from texts_of(ast.parse(file.read_text(encoding="utf-8")))


def texts_of(tree: ast.AST) -> Iterator[str]:
    """Yield the texts of a module but for docstrings and what raises."""
    for node in ast.iter_child_nodes(tree):
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(node, ast.Raise) or getattr(called, "id", getattr(called, "attr", "")) in ELSEWHERE:
            continue
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue
        if isinstance(node, ast.Call) and getattr(called, "id", "") in ("Message", "counted"):
            for part in (*node.args, *node.keywords):
                given = part.value if isinstance(part, ast.Constant) else None
                yield from [key_of(given)] if isinstance(given, str) else texts_of(part)
        elif isinstance(node, ast.JoinedStr):
            pieces = [str(part.value) if isinstance(part, ast.Constant) else "{}" for part in node.values]
            yield filled("".join(pieces))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            is_template = FORMATTED.search(node.value) and not NO_MESSAGE.search(node.value)
            yield key_of(node.value) if is_template else filled(node.value)
        else:
            yield from texts_of(node)


def filled(message: str) -> str:
    """Return a message with numbers in its gaps; what goes on with a word or a bracket may be nothing."""
    return re.sub(r"\{\w*\}", "1", re.sub(r"(?<=[\w)])(?:\{\w*\})+", "", message))


def said() -> Iterator[tuple[str, str, set[str]]]:
    """Yield where each message of the package is, its template, and the names of its values."""
    for path in sorted(Path(ROOT, "src", "groundslab").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            called = getattr(node.func, "id", "") if isinstance(node, ast.Call) else ""
            if isinstance(node, ast.Call) and called in ("Message", "counted"):
                given = {keyword.arg or "" for keyword in node.keywords}
                for part in (part for part in node.args if isinstance(part, ast.Constant)):
                    yield f"{path.name}:{node.lineno}", str(part.value), given


def test_each_hole_has_a_value_and_a_known_unit() -> None:
    """In branches, too, that no test takes: no value is missing or for nothing, and none is left in SI units."""
    templates = list(said())
    assert len(templates) > 400
    for where, template, given in templates:
        holes = [(name, spec) for _, name, spec in holes_of(template) if name is not None]
        if "" not in given:  # values that are handed on
            assert {name for name, _ in holes} - {"count"} == given - {"count"}, (where, template)
        for _, spec in holes:
            unit = spec.partition(" ")[2].strip("()")
            assert not unit or unit in CUSTOMARY, (where, template)
            assert spec == CAPITAL or written(1.5, spec, "US")


@pytest.mark.parametrize("language", OTHERS)
def test_sources_have_no_message_without_translation(language: Language) -> None:
    """Also those that no example shows; pieces of sentences are read whole in the reports of the examples."""
    translate = translator(language)
    assert isinstance(translate, Catalogue)
    asked = replace(translate, unknown=[])
    for text in made_messages():
        if HOLE.search(text):
            assert text.strip() in translate.whole or not re.search(r"[a-z]{3}", HOLE.sub("", text)), text
        elif len(re.findall(r"[A-Za-z]{3,}", text)) > 1 and not NO_MESSAGE.search(text) and text not in CUT:
            asked(text)
    assert sorted(set(asked.unknown or ())) == []
