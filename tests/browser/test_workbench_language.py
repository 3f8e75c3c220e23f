"""The page in another language: its words change, what the user has written stays."""

from __future__ import annotations

from pathlib import Path

import pytest

from groundslab.languages.catalogue import messages
from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow
#: A column that is called as a tool of the page is.
CASE = SMALL.replace('"A1"', '"Void"')


def switch(bench: Bench, label: str, language: str) -> None:
    """Choose a language; the page is loaded again."""
    bench.page.get_by_label(label, exact=True).select_option(language)
    bench.page.wait_for_selector(f"html[lang={language}]")
    bench.page.wait_for_selector(".drawing[data-view]")


def test_the_page_is_switched_to_german_and_back(server: Server, bench: Bench, case: Path) -> None:
    """Buttons, titles, the form's words and figures are German; names, values and the text of the case stay."""
    german = messages("de")
    case.write_text(CASE)
    bench.open(server.start(case))
    bench.tab("Form")
    bench.fill("312.5 mm", "plate", "thickness")
    switch(bench, "language", "de")
    bar = bench.page.locator(".top")
    assert (
        bar.get_by_role("button", name=german["Save"], exact=True).get_attribute("title")
        == (german["Save the case file (Ctrl+S)"])
    )
    assert bar.locator(".file-title").inner_text() == "slab.toml"
    assert german["● unsaved"] in bar.inner_text(), "the edit is still there"
    assert bench.page.locator(".drawing").get_by_text("Void", exact=True).count() == 1, "the name of the column"
    bench.tab(german["Form"])
    row = bench.field("plate", "thickness")
    assert row.locator("label").inner_text().startswith(german["thickness"])
    assert row.locator("input").input_value() == "312.5 mm"
    assert bench.text() == CASE.replace("250 mm", "312.5 mm")
    bench.page.locator(".gs-legend").wait_for()
    assert "," in bench.page.locator(".gs-legend-notes").inner_text(), "figures have decimal commas"
    switch(bench, german["language"], "en")
    assert bar.get_by_role("button", name="Save", exact=True).count() == 1


def test_the_language_of_the_case_is_the_first(server: Server, bench: Bench, case: Path) -> None:
    """A case that names a language is shown in it, as long as the user has not chosen another one."""
    german = messages("de")
    case.write_text(f'{SMALL}\n[project]\nlanguage = "de"\n')
    bench.open(server.start(case, by_itself=False))
    assert bench.page.locator("html").get_attribute("lang") == "de"
    switch(bench, german["language"], "en")
    bench.page.reload()
    bench.page.wait_for_selector(".drawing[data-view]")
    assert bench.page.locator("html").get_attribute("lang") == "en"
