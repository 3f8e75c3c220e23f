"""Short and full reports: what each holds, and what decides which it is."""

from __future__ import annotations

from dataclasses import replace

import pytest
from tests.helpers.combinations import few
from tests.helpers.paths import EXAMPLES

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.design.rules.check import DesignCheck
from groundslab.model.outputs import CHAPTERS
from groundslab.results.results import Results
from groundslab.views.report import html
from groundslab.views.report.calculations import Sheet
from groundslab.views.report.content import build_report
from groundslab.views.report.document import Part, Report
from groundslab.views.report.html import render_report
from groundslab.views.report.length import CHAPTERS as SHORT
from groundslab.views.report.length import governing_sheets, shorten_tables
from groundslab.views.report.table_layout import is_long
from groundslab.views.tables.table import Column, Table


@pytest.fixture(scope="module")
def raft() -> Results:
    """Return the results of a raft on columns with bars, on a coarse mesh."""
    model = few(load(EXAMPLES / "l_raft.toml"))
    return solve(model.replace(mesh={"size": max(model.sides) / 8}))


@pytest.fixture(scope="module")
def both(raft: Results) -> tuple[Report, Report]:
    """Return the short and the full report; what their drawings show is of no account here."""
    with pytest.MonkeyPatch.context() as patched:
        nothing = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"/>'
        patched.setattr("matplotlib.figure.Figure.savefig", lambda _, file, **__: file.write(nothing))
        return build_report(raft, length="short"), build_report(raft)


def blocks_of(report: Report, name: str) -> list[object]:
    """Return the blocks of a chapter."""
    (chapter,) = (chapter for chapter in report.chapters if chapter.name == name)
    return list(chapter.blocks)


def test_chapters(both: tuple[Report, Report]) -> None:
    """The short one has those of results, the full one the appendix, too; without a comparison neither compares."""
    short, full = both
    assert set(short.names) == set(SHORT) - {"grounds"}
    assert set(full.names) == set(CHAPTERS) - {"grounds"}
    assert [name for name in full.names if name in short.names] == list(short.names)


def test_one_calculation_of_each_kind(both: tuple[Report, Report]) -> None:
    """Of all layers of bars the one that governs, and of each other check one; the same sheets as in full."""
    kept, all_of_them = (
        [block for block in blocks_of(report, "calculations") if isinstance(block, Sheet)] for report in both
    )
    assert 1 < len(kept) < len(all_of_them)
    assert len({sheet.check for sheet in kept}) == len(kept)
    assert all(sheet in all_of_them for sheet in kept)
    bending = [sheet.last for sheet in all_of_them if sheet.check == "bending"]
    assert [sheet.last for sheet in kept if sheet.check == "bending"] == [max(bending)]


def test_layers_are_of_one_kind() -> None:
    """What differs in the layer alone is one kind; the largest share stays, in the place of the first."""

    def sheet(check: str, last: float) -> Sheet:
        return Sheet(check, check, (), last)

    sheets = [sheet("crack width at the top x", 0.5), sheet("uplift", 0.1), sheet("crack width at the bottom y", 0.9)]
    assert governing_sheets(sheets, ()) == [sheets[2], sheets[1]]


def test_what_fails_is_followed() -> None:
    """The layer whose check fails stands before one whose calculation ends with a larger number."""
    names = ("crack width at the top x", "crack width at the bottom y")
    sheets = [Sheet(name, name, (), last) for name, last in zip(names, (0.5, 0.9), strict=True)]
    checks = [DesignCheck(name, status, "") for name, status in zip(names, ("fails", "attention"), strict=True)]
    assert governing_sheets(sheets, checks) == sheets[:1]
    bending = [Sheet("bending", of, (), area, of=of) for of, area in (("top x, plate", 5.0), ("bottom y, plate", 60.0))]
    used = [DesignCheck("bars at the top x", "fails", ""), DesignCheck("bars at the bottom y", "no failure found", "")]
    assert governing_sheets(bending, used) == bending[:1]


def test_open_checks_keep_their_reasons(both: tuple[Report, Report]) -> None:
    """What passes is a line without words in short; what fails or needs attention says why in both."""
    short, full = both
    assert [check.name for check in short.checks] == [check.name for check in full.checks]
    for brief, whole in zip(short.checks, full.checks, strict=True):
        assert (brief.demand, brief.limit, brief.used, brief.status) == (
            whole.demand,
            whole.limit,
            whole.used,
            whole.status,
        )
        assert brief.words == ("" if whole.verdict == "good" else whole.words)


def test_tables(both: tuple[Report, Report]) -> None:
    """The short one has no table that the full one lacks, and of columns the ultimate rows."""
    short, full = (
        {block.name: block for block in blocks_of(report, "tables") if isinstance(block, Part)} for report in both
    )
    assert {"table-combinations", "table-reinforcement"} <= set(short) < set(full)


def test_no_table_that_it_has_is_left_out_for_its_length() -> None:
    """Of a long one the short report says where it is."""
    states = tuple(f"load {number}" for number in range(100))
    column = Column("load", "", states)
    long = Table("shear_reinforcement", "Shear reinforcement", (column,), ())
    assert is_long(long)
    assert list(shorten_tables([long.name], {long.name: long}.__getitem__)) == [long]


def test_the_case_decides(raft: Results, monkeypatch: pytest.MonkeyPatch) -> None:
    """The page is full unless the case or the caller says otherwise."""
    asked = replace(raft, model=raft.model.replace(report={"length": "short"}))
    lengths: list[str] = []

    def build(*_: object) -> Report:
        lengths.append(str(_[-1]))
        return build_report(raft, chapters=["certificate"])

    monkeypatch.setattr(html, "build_report", build)
    pages = [render_report(raft), render_report(asked), render_report(asked, length="full")]
    assert lengths == ["full", "short", "full"]
    assert all('id="certificate"' in page for page in pages)
