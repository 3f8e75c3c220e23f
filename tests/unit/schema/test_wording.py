"""Words of messages: quotes, articles, letters that a terminal would obey."""

from __future__ import annotations

from groundslab.schema.wording import describe, printable, quote, with_article


def test_quotes_are_escaped_inside_quotes_alone() -> None:
    """A name in quotes has its own ones escaped; a text that stands free keeps them, but no control characters."""
    assert quote('a "b"') == r'"a \"b\""'
    assert printable('INSERT block "COL400"') == 'INSERT block "COL400"'
    assert printable("a\x1b[2J") == r"a\u001b[2J"


def test_articles_go_with_the_first_letter() -> None:
    """An area load, a line load, an odd value of a type."""
    assert [with_article(noun) for noun in ("area load", "line load")] == ["an area load", "a line load"]
    assert describe(object()) == "an object"
