"""What the commands print as JSON has the shapes that docs/interface promises, failures included."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from groundslab.analysis import driver
from groundslab.cli import main
from groundslab.errors import GroundslabError, IllConditioned, NotConverged
from groundslab.results.results import Results
from groundslab.views.files import results_folder
from groundslab.views.interface import documents, shapes
from groundslab.views.summary import json_summary
from helpers import small_case, synthetic
from helpers.documents import validate
from helpers.studies import write

#: A pad of 75 kN; under 100 kN with 300 kNm the resultant leaves it, so nothing balances the second combination.
PAD = """title = "Pad"
plate = { length_x = "3 m", length_y = "2 m", thickness = "0.5 m", E = "33 GPa", nu = 0.2 }
ground = { kind = "winkler", k = "30 MPa/m" }
mesh = { size = "0.5 m" }
cases = [{ name = "G" }, { name = "W", action = "variable" }]
loads = [
    { kind = "self weight", case = "G", unit_weight = "25 kN/m^3" },
    { kind = "point", case = "W", P = "100 kN", M_x = "300 kNm", x = "0 m", y = "0 m" },
]
combinations = [{ name = "dead", factors = { G = 1 } }, { name = "wind", factors = { G = 1, W = 1 } }]
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty folder, in which the commands run."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    """Return the exit code of a command, and the document that is alone on its standard output."""
    capsys.readouterr()
    code = main.main([*arguments, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_an_only_combination(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Check, summary, its file, and tables of a case without load cases."""
    (folder / "slab.toml").write_text(small_case.TEXT, encoding="utf-8")
    code, checked = run(capsys, "check", "slab.toml")
    assert (code, checked["status"], checked["issues"]) == (0, "fine", [])
    validate(checked, "check")
    code, summary = run(capsys, "solve", "slab.toml")
    assert code == 0
    validate(summary, "summary")
    validate(json.loads((folder / "slab-results" / "summary.json").read_text(encoding="utf-8")), "summary")
    code, tables = run(capsys, "tables", "slab-results")
    assert code == 0
    validate(tables, "tables")
    (listed,) = [table for table in tables["tables"] if table["name"] == "combinations"]
    assert {column["name"]: column["values"] for column in listed["columns"]}["outcome"] == ["solved"]


def test_a_combination_without_equilibrium(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Check and summary name it with the reason, beside the one that is solved; so does the summary of it alone."""
    (folder / "pad.toml").write_text(PAD, encoding="utf-8")
    code, checked = run(capsys, "check", "pad.toml")
    assert (code, checked["status"]) == (3, "no equilibrium")
    assert list(checked["without_equilibrium"]) == ["wind"]
    validate(checked, "check")
    code, summary = run(capsys, "solve", "pad.toml")
    assert code == 3
    validate(summary, "summary")
    dead, wind = summary["combinations"]
    assert (dead["certified"], wind["refused"]["error"]) == (True, "NoEquilibrium")
    (folder / "wind.toml").write_text(PAD.replace('{ name = "dead", factors = { G = 1 } }, ', ""), encoding="utf-8")
    code, summary = run(capsys, "solve", "wind.toml")
    assert (code, summary["certified"]) == (3, False)
    validate(summary, "summary")


def test_wrong_input(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """All issues are in the check; of every other command with --json there is the document of an error."""
    (folder / "slab.toml").write_text(small_case.TEXT.replace('"3 m"', '"3"').replace("0.2", "0.7"), encoding="utf-8")
    code, checked = run(capsys, "check", "slab.toml")
    assert (code, checked["status"]) == (2, "wrong input")
    assert [issue["location"] for issue in checked["issues"]] == ["plate.length_y", "plate.nu"]
    validate(checked, "check")
    for arguments in (["solve", "slab.toml"], ["compare-ground", "slab.toml"], ["tables", "nothing"]):
        code, error = run(capsys, *arguments)
        assert (code, error["error"]["kind"]) == (2, "InputError")
        assert error["error"]["issues"]
        validate(error, "error")


@pytest.mark.parametrize(
    ("error", "kept"),
    [
        (NotConverged("the contact zone", list(synthetic.results().steps), {}), {"what", "history"}),
        (NotConverged("gamma", [1.0, float("nan")], {}), {"what", "history"}),
        (IllConditioned("too stiff"), set()),
        (OSError("the disk is full"), set()),
        (MemoryError(), set()),
    ],
)
def test_an_analysis_that_fails(
    error: Exception,
    kept: set[str],
    folder: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What ends the command is in the document of an error, with the history of what did not converge."""

    def fail(*_: object) -> Results:
        raise error

    monkeypatch.setattr(driver, "solve", fail)
    (folder / "slab.toml").write_text(small_case.TEXT, encoding="utf-8")
    code, document = run(capsys, "solve", "slab.toml")
    assert code == (2 if isinstance(error, OSError) else 1)
    validate(document, "error")
    assert document["error"].keys() - {"kind", "message", "issues"} == kept


def test_no_combination_has_results(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where several combinations have no results at all, the summary says why of each."""

    def give_up(model: Any, *_: object) -> Results:
        error: GroundslabError = NotConverged("gamma", [1.0, 2.0], {})
        combinations = driver.list_combinations(model)
        return Results(model, combinations, {}, {each.name: error for each in combinations})

    monkeypatch.setattr(driver, "solve", give_up)
    (folder / "pad.toml").write_text(PAD, encoding="utf-8")
    code, summary = run(capsys, "solve", "pad.toml")
    assert code == 1
    assert [each["refused"]["what"] for each in summary["combinations"]] == ["gamma", "gamma"]
    validate(summary, "summary")


def test_a_summary_is_the_only_document_where_the_folder_cannot_be_written(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The results are printed, and no second document about the disk after them."""

    def fail(*_: object, **__: object) -> Path:
        raise OSError("the disk is full")

    monkeypatch.setattr(results_folder, "save_results", fail)
    (folder / "slab.toml").write_text(small_case.TEXT, encoding="utf-8")
    code, summary = run(capsys, "solve", "slab.toml")
    assert code == 2
    validate(summary, "summary")


def test_refused_and_uncertified_combinations() -> None:
    """Summary, checks and tables of combinations of which one is not certified and one has no equilibrium."""
    results = synthetic.combined()
    validate(json.loads(json_summary.json_text(results)), "summary")
    validate(json.loads(documents.to_text(documents.design_to_json(results))), "design")
    tables = json.loads(documents.to_text(documents.tables_to_json(results, ["checks", "tilt"])))
    assert [table["name"] for table in tables["tables"]] == ["tilt", "checks"]
    validate(tables, "tables")


def test_a_study(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The check of a study says what it varies."""
    code, checked = run(capsys, "check", str(write(folder)))
    assert (code, checked["kind"]) == (0, "study")
    validate(checked, "check")


def test_tables_are_printed_or_written(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A file beside --json, and names of tables without it, are refused."""
    assert run(capsys, "tables", "slab-results", "--out", "slab.xlsx")[0] == 2
    assert main.main(["tables", "slab-results", "--only", "checks"]) == 2
    assert "--only" in capsys.readouterr().err
    assert not list(folder.iterdir())


def test_one_version_and_every_shape_has_words() -> None:
    """All documents state the same version, and each shape in a schema says what it is."""
    results = synthetic.combined()
    made = [documents.design_to_json(results), documents.tables_to_json(results), documents.error_to_json(OSError())]
    assert {document["format"] for document in [json_summary.to_json(results), *made]} == {json_summary.FORMAT}
    for name in shapes.DOCUMENTS:
        schema = shapes.json_schema(name)
        assert all(part.get("description") for part in [schema, *schema["$defs"].values()] if "properties" in part)
