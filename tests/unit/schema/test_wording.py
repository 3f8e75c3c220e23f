"""Words of messages: quotes, articles, letters that a terminal would obey."""

from __future__ import annotations

from groundslab.schema.wording import as_cell, describe, printable, quote, with_article


def test_quotes_are_escaped_inside_quotes_alone() -> None:
    """A name in quotes has its own ones escaped; a text that stands free keeps them, but no control characters."""
    assert quote('a "b"') == r'"a \"b\""'
    assert printable('INSERT block "COL400"') == 'INSERT block "COL400"'
    assert printable("a\x1b[2J") == r"a\u001b[2J"


def test_articles_go_with_the_first_letter() -> None:
    """An area load, a line load, an odd value of a type."""
    assert [with_article(noun) for noun in ("area load", "line load")] == ["an area load", "a line load"]
    assert describe(object()) == "an object"


def test_letters_that_nobody_sees_are_escaped() -> None:
    """Marks of direction and letters without width are shown by number, white space as a space; scripts stay."""
    assert printable("a\u202eb\u200bc\ufeff\u3164") == r"a\u202eb\u200bc\ufeff\u3164"
    assert printable("a\r\nb\u00a0c\td") == "a  b c d"
    assert printable("a\n\tb\r", keep="\n\t") == "a\n\tb "
    assert printable("Größe Ωμ שלום 梁 −1 …") == "Größe Ωμ שלום 梁 −1 …"


def test_no_cell_is_a_formula() -> None:
    """What a spreadsheet would compute gets an apostrophe; numbers, dashes and other texts stay."""
    assert [as_cell(text) for text in ("=1+1", "@A1", "+A1", "-2+cmd")] == ["'=1+1", "'@A1", "'+A1", "'-2+cmd"]
    assert [as_cell(text) for text in ("-", "-1.5", "+ 3", "1-2", "a=b")] == ["-", "-1.5", "+ 3", "1-2", "a=b"]
