"""Files that earlier versions wrote are read with the same meaning, or refused with what to do.

In tests/data/old are folders of results as groundslab wrote them at the beginning (layout 1), at 0.1.0 (layout 6) and
between releases (layout 10), without the files for ParaView and the tables, and a case and a study of 0.1.0 as people
wrote them.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

import groundslab
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.study.check import check_file
from groundslab.views.files import npz, results_folder
from groundslab.views.summary import json_summary
from helpers.paths import ROOT

OLD = ROOT / "tests" / "data" / "old"
FOLDERS = ["layout-01", "layout-06", "layout-10"]


def settlements(document: dict[str, Any]) -> list[float]:
    """Return the largest settlement of each combination in a summary [m]."""
    entries = document.get("combinations", [document])
    return [entry["settlement"]["largest"]["value"] for entry in entries]


@pytest.mark.parametrize("name", FOLDERS)
def test_old_results_are_refused_with_what_to_do(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The message names both versions and the case to solve again; so do the commands that read results."""
    with pytest.raises(npz.OtherLayout, match=rf"layout {int(name[-2:])}\b.*solve the case.toml of the folder again"):
        groundslab.load_results(OLD / name)
    for command in (["report"], ["tables", "--json"], ["view", "--no-browser"], ["plot"]):
        assert main.main([command[0], str(OLD / name), *command[1:]]) == 2
        assert "solve the case.toml of the folder again" in capsys.readouterr().err


@pytest.mark.parametrize("name", FOLDERS)
def test_the_case_of_old_results_means_the_same(name: str) -> None:
    """The case in an old folder is read, and its settlements are those that were found then, to rounding."""
    results = groundslab.solve(groundslab.load(OLD / name / "case.toml"))
    then = json.loads((OLD / name / "summary.json").read_text(encoding="utf-8"))
    assert settlements(json_summary.to_json(results)) == pytest.approx(settlements(then), rel=1e-9)


@pytest.mark.parametrize("name", FOLDERS)
def test_an_old_folder_is_replaced_as_a_new_one_is(name: str, tmp_path: Path) -> None:
    """Results solved again take the place of old ones, whose summary is understood."""
    folder = tmp_path / "results"
    shutil.copytree(OLD / name, folder)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    assert set(summary["files"]) >= {"case.toml", "summary.json"}
    results = groundslab.solve(groundslab.load(folder / "case.toml"))
    results_folder.save_results(results, folder)
    assert groundslab.load_results(folder).keys() == results.keys()


def test_results_of_a_newer_version_say_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a layout that is yet to come, a newer groundslab is named as the way to read it."""
    folder = tmp_path / "results"
    results = groundslab.solve(groundslab.load(OLD / "layout-01" / "case.toml"))
    with monkeypatch.context() as later:
        later.setattr(npz, "FORMAT", npz.FORMAT + 1)
        results_folder.save_results(results, folder)
    with pytest.raises(InputError, match="read it with a newer groundslab"):
        groundslab.load_results(folder)


def test_case_and_study_of_a_release_are_read() -> None:
    """The case and study files that came with 0.1.0 have no issue today."""
    for path in (OLD / "example-0.1.0.toml", *sorted((OLD / "study-0.1.0").glob("*.toml"))):
        assert check_file(path, path.name)["status"] == "fine"
