"""Messages: their text, their quantities in both systems of units, and their names, which never change."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest

from groundslab.languages import LANGUAGES, Language, translator
from groundslab.messages import Clause, Message, Name, as_values, joined, key_of, quantity, quoted, words_in

#: Names of a case that look like something else.
NAMES = [
    "pile 12 m", "W1 edge at 2.5 m: 120.4 kN", "settlement", "corners", "6.4.4(2)", "Table 8.2", "<b>bold</b>",
    "{beam}", "{} of {}", "sqrt(f'c)", "3.5, 4.5", "1.5 x 2 m", "at (1.2, 3.4) m", "no failure found", "Q; W",
]  # fmt: skip


def said(name: str) -> Message:
    """Return a message of the design about a thing of that name."""
    return Message(
        "{name}: {force} is {share:.3g} times {most} in \"{governing}\"",
        name=Name(name), force=quantity(1234.5, "kN"), share=0.8215, most=Message("its {given}", given=Name(name)),
        governing=Name(name),
    )  # fmt: skip


def test_what_has_no_name_is_called_by_a_message() -> None:
    """A support that is called by its number is no name, whoever takes it for one."""
    support = Message("support {number}", number=3)
    assert Name(support) is support
    assert translator("de")(Name(support)) == "Lager 3"
    assert isinstance(Name("support 3"), Name)


def test_the_text_is_english_in_si_units() -> None:
    """A message is its text: equal to it, part of it, and joined with others as texts are."""
    message = Message(
        "{V:.4g kN} at {place:.2f m}, {n} of {total}", V=12.345, place=(1.0, -2.5), n=2, total=np.int64(3)
    )
    assert message == "12.35 kN at (1.00, -2.50) m, 2 of 3"
    assert f"{message}." == "12.35 kN at (1.00, -2.50) m, 2 of 3."
    assert Message("{w:.3g (mm)} <= {limit:.3g mm}", w=0.25, limit=0.3) == "0.25 <= 0.3 mm"
    assert Message("{center:at m}", center=np.array([1.25, 123456.7891])) == "(1.25, 123456.789) m"


def test_quantities_change_with_the_units() -> None:
    """By their values, not by their rounded text, with as many digits: 143.641 kPa are 3000 psf."""
    message = Message("{q:.4g kPa} at {place:.3f m}, {w:.3g (mm)} <= {limit:.3g mm}, {share:.3g} %",
                      q=143.6410, place=(3.048, 0.0), w=2.54, limit=25.4, share=12.0)  # fmt: skip
    assert words_in(message, "US") == "3000 psf at (10.00, 0.00) ft, 0.1 <= 1 in, 12 %"
    assert words_in(words_in(message, "US"), "SI") == message


def test_what_is_put_together_stays_values() -> None:
    """Sums and lists of messages, and messages in messages."""
    length = Message("{L:.4g m}", L=3.048)
    for text in (
        "beam " + length + "; long",
        joined(["beam ", length, "; long"], ""),
        Message("beam {L}; long", L=length),
    ):
        assert text == "beam 3.048 m; long"
        assert words_in(text, "US") == "beam 10 ft; long"
    assert words_in(joined([length, length], "; "), "US") == "10 ft; 10 ft"
    assert length + "" is length
    assert str(length) is length


def test_copies_are_messages() -> None:
    """Those of workers and of frozen values."""
    message = said("C1") + "; and more"
    for other in (pickle.loads(pickle.dumps(message)), copy.deepcopy(message)):
        assert other == message
        assert words_in(other, "US") == words_in(message, "US")


@pytest.mark.parametrize("name", NAMES)
def test_names_never_change(name: str) -> None:
    """In no language and in no units, whatever they look like; all around them does."""
    for units in ("SI", "US"):
        text = words_in(said(name), units)
        assert text.count(name) >= 3
        for language in LANGUAGES:
            shown = translator(language)(text)
            assert shown.replace("\xa0", " ").count(name) == text.count(name), (language, shown)
            assert (shown == text) == (language == "en")


@pytest.mark.parametrize("language", [language for language in LANGUAGES if language != "en"])
def test_numbers_are_those_of_the_language(language: Language) -> None:
    """With decimal commas, also in places; clauses keep their points, and a table is a table."""
    translate = translator(language)
    assert translate(Message("{q:.4g kPa} {place:.2f m}", q=12.5, place=(1.0, 2.5))) == "12,5 kPa (1,00; 2,50) m"
    assert translate(Message("({clause})", clause=Clause("6.2"))) == "(6.2)"
    assert translate(Clause("Table 8.2")).endswith(" 8.2")
    assert (translate(Clause("Table 8.2")) == "Table 8.2") == (translate("Table") == "Table")


def test_json_has_template_and_values() -> None:
    """Of names that they are names; of numbers that JSON does not know words."""
    message = Message("{name}: {w:.3g mm} at {place:.2f m} {more}", name=Name("C1"), w=np.float64(2.5),
                      place=np.array([1.0, 2.0]), more=joined(["a", Message("{n}", n=math.inf)], "; "))  # fmt: skip
    assert json.loads(json.dumps(as_values(message), allow_nan=False)) == {
        "template": "{name}: {w:.3g mm} at {place:.2f m} {more}",
        "values": {
            "name": {"name": "C1"},
            "w": 2.5,
            "place": [1.0, 2.0],
            "more": {"mark": "; ", "texts": ["a", {"template": "{n}", "values": {"n": "inf"}}]},
        },
    }


def test_quoted_names_are_one_name() -> None:
    """Of many the first."""
    assert quoted(["a", "b 2 m", "c"], most=2) == '"a", "b 2 m" ...'
    assert words_in(quoted(["b 2 m"]), "US") == '"b 2 m"'


def test_catalogues_know_holes_by_their_names() -> None:
    """Formats and units are none of a translator's business; braces of a text stay."""
    assert key_of("{V:.4g kN} of {{x}} {w:.3g (mm)}") == "{V} of {{x}} {w}"
