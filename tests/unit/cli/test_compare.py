"""The command compare-ground: what goes where, and which exit code comes back."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from groundslab.analysis.ground_comparison import comparison as analysis
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.views.files import results_folder
from helpers import grounds, synthetic


@pytest.fixture
def case(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a case file, whose comparison is made up."""

    def compare(model: Any, combination: str | None, on_begin: Any) -> Any:
        assert combination in (None, "all loads")
        assert on_begin is None  # without a terminal nothing is told
        return grounds.comparison(model)

    monkeypatch.setattr(analysis, "compare_grounds", compare)
    path = tmp_path / "raft.toml"
    path.write_text(casefile.to_toml(synthetic.model()), encoding="utf-8")
    return path


def test_prints_the_comparison(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The table goes to standard output; nothing is written without a folder."""
    assert main.main(["compare-ground", str(case), "--combination", "all loads"]) == 0
    out, err = capsys.readouterr()
    assert "settlement w, largest" in out
    assert "+30.0 %" in out
    assert err == ""
    assert [each.name for each in case.parent.iterdir()] == ["raft.toml"]


def test_json_is_alone_on_standard_output(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is what the folder holds."""
    folder = case.parent / "out"
    assert main.main(["compare-ground", str(case), "--json", "--out", str(folder)]) == 0
    out, err = capsys.readouterr()
    assert json.loads(out) == json.loads((folder / "ground-comparison.json").read_text())
    assert err == ""


@pytest.mark.slow
def test_the_report_of_results_has_a_chapter(case: Path, tmp_path: Path) -> None:
    """Beside results the comparison is a chapter of their report; without it there is none."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "raft")
    for out, there in (("before.html", False), ("after.html", True)):
        if there:
            assert main.main(["compare-ground", str(case), "--out", str(folder)]) == 0
        assert main.main(["report", str(folder), "--out", str(tmp_path / out), "--chapters", "grounds"]) == 0
        assert ('<section id="grounds">' in (tmp_path / out).read_text(encoding="utf-8")) == there


def test_results_of_another_case_are_found_before_the_analysis(
    case: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The folder is looked at first, since an analysis may take long."""
    monkeypatch.setattr(analysis, "compare_grounds", None)
    other = synthetic.results(model=synthetic.model().replace(title="another"))
    folder = results_folder.save_results(other, tmp_path / "raft")
    assert main.main(["compare-ground", str(case), "--out", str(folder)]) == 2
    assert "results of another case" in capsys.readouterr().err


def test_springs_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A case without layers of soil is wrong input, and the message says what is needed."""
    path = tmp_path / "springs.toml"
    path.write_text(casefile.to_toml(synthetic.model().replace(ground={"kind": "winkler", "k": 2e7})))
    assert main.main(["compare-ground", str(path)]) == 2
    assert "layers given by E, nu and thickness" in capsys.readouterr().err
