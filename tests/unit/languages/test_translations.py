"""What pages get of the catalogues."""

from __future__ import annotations

import pytest

from groundslab.languages import LANGUAGES, catalogue, page_messages


def test_a_page_gets_the_messages_that_it_wants(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that are wanted, else all."""
    known = {"Save": "Speichern", "Undo": "Zurück"}
    monkeypatch.setattr(catalogue, "messages", lambda _: known)
    assert page_messages("de", {"Save", "Saved."}) == {"language": "de", "messages": {"Save": "Speichern"}}
    assert page_messages("de")["messages"] == known


def test_english_has_no_messages() -> None:
    """English is what the program says, so that a page in it needs none."""
    assert next(iter(LANGUAGES)) == "en"
    assert page_messages("en")["messages"] == {}
