"""A comparison of grounds in folders: read back as it was, beside results of the same case only."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from groundslab.errors import InputError
from groundslab.storage import atomic
from groundslab.views.files import results_folder
from groundslab.views.ground_comparison.files import FILE, load_comparison, save_comparison
from helpers import grounds, synthetic


def names(folder: Path) -> set[str]:
    """Return the paths of all files in a folder."""
    return {each.relative_to(folder).as_posix() for each in folder.rglob("*") if each.is_file()}


NEW = {FILE, "ground-comparison.svg", "tables/ground_comparison.csv", "tables/ground_curves.csv"}


def test_a_new_folder(tmp_path: Path) -> None:
    """It holds the files and a summary that names them, and can be written again; what is read is what was written."""
    for _ in range(2):
        folder = save_comparison(grounds.comparison(), tmp_path / "raft")
    assert names(folder) == NEW | {"summary.json"}
    assert set(json.loads((folder / "summary.json").read_text())["files"]) == names(folder)
    assert load_comparison(folder) == grounds.comparison()


def test_beside_results(tmp_path: Path) -> None:
    """Results stay as they are and can be read; new results take the place of both."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "raft")
    before = {name: (folder / name).read_bytes() for name in names(folder) - {"summary.json"}}
    save_comparison(grounds.comparison(), folder)
    assert names(folder) == before.keys() | NEW | {"summary.json"}
    assert all((folder / name).read_bytes() == content for name, content in before.items())
    synthetic.assert_same(results_folder.load_results(folder).only, synthetic.results())
    results_folder.save_results(synthetic.results(), folder)
    assert names(folder) == before.keys() | {"summary.json"}
    assert load_comparison(folder) is None


def test_results_of_another_case_are_refused(tmp_path: Path) -> None:
    """A comparison must not stand beside results that it does not belong to; nothing is changed."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "raft")
    before = names(folder)
    with pytest.raises(InputError, match="results of another case"):
        save_comparison(grounds.comparison(synthetic.model().replace(title="another")), folder)
    assert names(folder) == before


def test_what_others_wrote_is_refused(tmp_path: Path) -> None:
    """A folder with a file of somebody else's stays as it is."""
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="groundslab did not write"):
        save_comparison(grounds.comparison(), tmp_path)
    assert names(tmp_path) == {"notes.txt"}


def test_a_failure_leaves_the_folder_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """If the disk is full, the results are still there."""
    folder = results_folder.save_results(synthetic.results(), tmp_path / "raft")
    before = {name: (folder / name).read_bytes() for name in names(folder)}

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic, "_sync", full)
    with pytest.raises(InputError, match="No space left"):
        save_comparison(grounds.comparison(), folder)
    assert {name: (folder / name).read_bytes() for name in names(folder)} == before


@pytest.mark.parametrize("damage", ["{", '{"format": 99}', '{"format": 1, "model": "", "comparison": {}}'])
def test_a_damaged_file_is_named(tmp_path: Path, damage: str) -> None:
    """Anything else in place of a comparison ends in an issue with its path."""
    folder = save_comparison(grounds.comparison(), tmp_path / "raft")
    (folder / FILE).write_text(damage)
    with pytest.raises(InputError, match=FILE):
        load_comparison(folder)
