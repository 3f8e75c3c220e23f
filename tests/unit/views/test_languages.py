"""Everything that people read is translated, and has the same numbers."""

from __future__ import annotations

import io
import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from html import unescape
from pathlib import Path

import pytest
from pypdf import PdfReader
from tests.helpers.combinations import few
from tests.helpers.languages import in_language
from tests.helpers.paths import EXAMPLES

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.languages import LANGUAGES, Language
from groundslab.results.results import Results
from groundslab.views import translation
from groundslab.views.plots import plot
from groundslab.views.report.html import render_report, write_report
from groundslab.views.summary.terminal import print_summary
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import WORDS

OTHERS: list[Language] = [language for language in LANGUAGES if language != "en"]
#: Numbers as English writes them and the other languages do.
NUMBER = re.compile(r"(?<![\w.,])\d+(?:[.,]\d+)?(?!\w|[.,]\d)")


@pytest.fixture(scope="module")
def house() -> Results:
    """Return the results of the raft of a house on a coarse mesh."""
    model = few(load(EXAMPLES / "house_raft.toml"))
    return solve(model.replace(mesh={"size": max(model.sides) / 8}))


def numbers(text: str) -> Counter[str]:
    """Return the numbers of a text, with decimal points."""
    return Counter(number.replace(",", ".") for number in NUMBER.findall(text))


def figures_of(page: str) -> str:
    """Return what the figures of a page show."""
    return words_of("".join(re.findall(r"<svg\b.*?</svg>", page, flags=re.DOTALL)))


def beside_figures(page: str) -> str:
    """Return what a page shows beside its figures."""
    return words_of(re.sub(r"<svg\b.*?</svg>", " ", page, flags=re.DOTALL))


def words_of(page: str) -> str:
    """Return what a page shows, without its style, script and the text of the case."""
    body = re.sub(r"<(script|style|pre|code)\b.*?</\1>", " ", page, flags=re.DOTALL)
    return unescape(re.sub(r"<[^>]+>", "\n", body))


#: Chapters with numbers.
CHAPTERS = ["extremes", "pictures", "loads", "tables", "calculations", "certificate"]


@pytest.fixture(scope="module")
def pages(house: Results) -> Callable[[Language], str]:
    """Return the report in a language."""
    return cache(lambda language: render_report(in_language(house, language), chapters=CHAPTERS))


def test_paper_has_the_numbers_of_the_page(house: Results, pages: Callable[[Language], str], tmp_path: Path) -> None:
    """Each number beside figures stands on paper, as often as on the page, and each result of a calculation.

    In the language whose letters are farthest from English.
    """
    language: Language = "pl"
    apart = r'<section class="part noprint".*?</section>|<footer>.*?</footer>|<figure.*?</figure>'
    printed = re.sub(apart, "", pages(language), flags=re.DOTALL)
    before, calculations = printed.split('<section id="calculations">')
    calculations, after = calculations.split('<section id="tables">')
    # small numbers are powers of ten on paper
    wanted = numbers(re.sub(r"(\d)e[-+]\d+", r"\1 10", words_of(before + after)))
    wanted += numbers(" ".join(re.findall(r'<td class="number">= ([^<]*)<', calculations)))
    paper = PdfReader(
        write_report(in_language(house, language), tmp_path / "house.pdf", chapters=CHAPTERS, length="full")
    )
    assert not wanted - numbers("\n".join(leaf.extract_text() for leaf in paper.pages))


@pytest.mark.parametrize("language", OTHERS)
def test_reports_have_the_same_numbers(pages: Callable[[Language], str], language: Language) -> None:
    """Each as often as in English, with a comma instead of a point; contours have as many labels as there is room."""
    report, english = pages(language), pages("en")
    there = beside_figures(report)
    assert numbers(there) == numbers(beside_figures(english))
    assert len(re.findall(r"\d,\d", there)) > 500
    in_figures = numbers(figures_of(report))
    assert in_figures.keys() == numbers(figures_of(english)).keys()
    assert in_figures.total() > 300


@pytest.mark.parametrize("language", OTHERS)
def test_summaries_have_the_same_numbers(house: Results, language: Language) -> None:
    """On the terminal, whose lines wrap elsewhere."""
    here, there = (terminal(each) for each in (house, in_language(house, language)))
    assert numbers(here) == numbers(there)
    assert "discretization" not in there


def terminal(results: Results) -> str:
    """Return the summary as it is printed."""
    from rich.console import Console

    page = io.StringIO()
    print_summary(results, Console(file=page, width=80))
    return page.getvalue()


def test_tables_have_the_same_values(house: Results) -> None:
    """Only titles, headings, notes and sentences are in the other language; English ones are left alone."""
    assert [table.csv() for table in translation.translated_tables(house)] == [
        table.csv() for table in tables_of(house)
    ]
    for here, there in zip(tables_of(house), translation.translated_tables(in_language(house, "de")), strict=True):
        assert here.name == there.name
        for column, other in zip(here.columns, there.columns, strict=True):
            assert column.unit == other.unit
            if column.name not in WORDS:
                assert column.values == other.values
    titles = {table.name: table.title for table in translation.translated_tables(in_language(house, "de"))}
    assert titles["extremes"] == "Extremwerte jeder Kombination"


def test_names_of_a_case_stay(house: Results) -> None:
    """Also those that are messages: a load case called "wind" and a column called "settlement"."""
    model = house.model.replace(title="Settlement", project={"language": "de", "name": "bending"})
    translate = translation.translator_of(replace(house, model=model))
    assert translate("Settlement") == "Settlement"
    assert translate("bending") == "bending"
    assert translate("ULS 1") == "ULS 1"
    assert translate("settlement") == "Setzung"


def test_figures_are_translated(house: Results) -> None:
    """Titles, labels and numbers at axes."""
    from matplotlib.text import Text

    figure = plot(in_language(house, "de"), "settlement", combination="ULS 1")
    figure.draw_without_rendering()
    texts = [text.get_text() for text in figure.findobj(Text)]
    assert any("Setzung" in text for text in texts)
    assert not any("settlement" in text.lower() for text in texts)


def test_figures_show_as_much_in_each_language(house: Results) -> None:
    """Numbers at axes in another language do not widen these."""
    limits = [
        [(axes.get_xlim(), axes.get_ylim()) for axes in plot(results, mesh=True, combination="ULS 1").axes]
        for results in (house, in_language(house, "fr"))
    ]
    assert limits[0] == limits[1]
