"""What is made of examples: they do not fail, all words are translated, JSON has the shapes that docs promise."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from tests.helpers.combinations import few
from tests.helpers.documents import validate
from tests.helpers.paths import EXAMPLES, TAKE_LONG

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.design.checks import check_design
from groundslab.languages.catalogue import Catalogue
from groundslab.results.results import Results
from groundslab.views import translation
from groundslab.views.interface.documents import tables_to_json
from groundslab.views.report.html import render_report
from groundslab.views.summary import json_summary

NO_DRAWING = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"/>'
#: Examples whose reports have the same sentences with few combinations as with all.
OF_FEW = {
    "bearing_walls",
    "combined_footing",
    "grade_beams",
    "house_raft",
    "pad",
    "raft_on_continuum",
    "raft_under_a_frame",
    "raft_with_pit",
    "ribbed_raft",
}
#: Those of each code, kind of ground, structure and chapter; the others have the same sentences.
REPORTED = sorted({
    "bearing_walls", "cracked_footing", "house_raft", "industrial_floor", "joined_bays", "l_raft", "neighbours",
    "piled_raft", "raft_on_continuum", "raft_under_a_frame", "raft_with_pit", "ribbed_raft", "second_generation",
    "strip", "tank", "us_mat", "warehouse", "wind_turbine",
})  # fmt: skip


@pytest.fixture(scope="module", params=sorted({*REPORTED, *TAKE_LONG}))
def solved(request: pytest.FixtureRequest) -> Results:
    """Return the results of an example on a coarse mesh, reported in German."""
    model = load(EXAMPLES / f"{request.param}.toml")
    model = few(model) if request.param in OF_FEW else model
    project = {} if model.project is None else model.project.model_dump()
    return solve(model.replace(mesh={"size": max(model.sides) / 8}, project={**project, "language": "de"}))


@pytest.mark.slow
@pytest.mark.parametrize("solved", REPORTED, indirect=True)
def test_reports_leave_no_word_in_english(solved: Results, monkeypatch: pytest.MonkeyPatch) -> None:
    """No text of a report or a table lacks a translation, nor a part of one; all catalogues have the same messages."""
    known = translation.translator_of(solved)
    assert isinstance(known, Catalogue)
    translate = replace(known, unknown=[])
    monkeypatch.setattr("groundslab.views.report.html.translator_of", lambda _: translate)
    monkeypatch.setattr(translation, "translator_of", lambda _: translate)
    # words of drawings are translated before these are drawn, which takes long and adds none
    monkeypatch.setattr("matplotlib.figure.Figure.draw_without_rendering", lambda _: None)
    monkeypatch.setattr("matplotlib.figure.Figure.savefig", lambda _, file, **__: file.write(NO_DRAWING))
    chapters = [name for name in solved.model.report.chapters if name != "viewer"]
    page = render_report(solved, chapters=[*chapters, "long_tables"])
    assert len(list(translation.translated_tables(solved))) > 3
    assert sorted(set(translate.unknown or ())) == []
    assert '<html lang="de">' in page


@pytest.mark.slow
def test_it_holds(solved: Results) -> None:
    """Every combination has a certified result, and the design does not fail."""
    assert not solved.refused
    assert all(each.certificate.holds for each in solved.results.values())
    assert check_design(solved).status != "fails"


@pytest.mark.slow
@pytest.mark.parametrize("solved", REPORTED, indirect=True)
def test_documents_have_their_shapes(solved: Results) -> None:
    """Summary and tables, whatever ground, structure and code a case has."""
    validate(read_again(json_summary.to_json(solved)), "summary")
    validate(read_again(tables_to_json(solved)), "tables")


def read_again(document: dict[str, Any]) -> Any:
    """Return a document as who reads it gets it."""
    return json.loads(json.dumps(document))
