"""Messages are translated as the pages do it: both read the same examples."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from groundslab.languages import LANGUAGES, catalogue, page_messages, translator

EXAMPLES = json.loads(Path(__file__).with_name("translations.json").read_text(encoding="utf-8"))


@pytest.fixture
def translate(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return what translates by the messages of the examples."""
    monkeypatch.setattr(catalogue, "messages", lambda _: EXAMPLES["messages"])
    catalogue._catalogue.cache_clear()
    yield translator(EXAMPLES["language"], EXAMPLES["names"])
    catalogue._catalogue.cache_clear()


@pytest.mark.parametrize(("text", "expected", "rule"), EXAMPLES["cases"])
def test_a_text_is_translated(translate: Any, text: str, expected: str, rule: str) -> None:
    """Each rule has an example with its answer written by hand; the tests of the pages read the same ones."""
    assert translate(text) == expected, rule


def test_a_page_gets_the_messages_that_it_wants(monkeypatch: pytest.MonkeyPatch) -> None:
    """Messages that are wanted, sentences of longer ones among them, and the marks of lists; else all."""
    known = {"Save": "Speichern", "No errors. Saved.": "Keine Fehler. Gespeichert.", "Undo": "Zurück"}
    monkeypatch.setattr(catalogue, "messages", lambda _: known)
    page = page_messages("de", {"Save", "Saved."})
    assert page["language"] == "de"
    assert page["messages"] == {"Save": "Speichern", "Saved.": "Gespeichert."}
    assert (page["marks"]["; "], page["marks"][" and "]) == ("; ", " und ")
    assert page_messages("de")["messages"] == {**known, "No errors.": "Keine Fehler.", "Saved.": "Gespeichert."}


def test_english_has_no_messages() -> None:
    """English is what the program says, so that a page in it needs none."""
    assert next(iter(LANGUAGES)) == "en"
    assert page_messages("en")["messages"] == {}
