"""Rows of a study that somebody has changed since they were written are used by no reader."""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

import groundslab
from groundslab.cli import main
from groundslab.errors import CertificateWithdrawn
from helpers.studies import STUDY, run

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a study of three variants, beside its study file and case."""
    return run(tmp_path_factory.mktemp("written"), STUDY.replace("count = 12", "count = 3")).folder.parent


@pytest.fixture
def folder(written: Path, tmp_path: Path) -> Path:
    """Return the study's folder in a copy, to be changed."""
    return Path(shutil.copytree(written, tmp_path / "work")) / "study-study"


def _execute(statement: str) -> Callable[[Path], None]:
    """Return what changes the database."""

    def change(folder: Path) -> None:
        with closing(sqlite3.connect(folder / "rows.sqlite")) as connection, connection:
            assert connection.execute(statement).rowcount

    return change


def _edit(name: str) -> Callable[[Path], None]:
    """Return what adds a remark to a file."""

    def change(folder: Path) -> None:
        with (folder / name).open("a", encoding="utf-8") as file:
            file.write("# a remark\n")

    return change


def _reseed(folder: Path) -> None:
    document = json.loads((folder / "about.json").read_bytes())
    (folder / "about.json").write_text(json.dumps(document | {"seed": 4}), encoding="utf-8")


#: Changes, by what is named then.
CHANGES: dict[str, Callable[[Path], None]] = {
    "rows.sqlite (rows 2)": _execute("UPDATE rows SET machine = 0.9 * machine WHERE number = 2"),
    "rows.sqlite (rows 3)": _execute("UPDATE rows SET status = 'failed', reason = 'NotConverged' WHERE number = 3"),
    "rows.sqlite (rows 1)": _execute("DELETE FROM checksums WHERE part = 'rows 1'"),
    "study.toml": _edit("study.toml"),
    "case.toml": _edit("case.toml"),
    "about.json": _reseed,
}


@pytest.mark.parametrize("what", CHANGES)
def test_no_reader_uses_changed_rows(folder: Path, what: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Opening, evaluating and resuming end with what was changed in the first line, and the exit code is 1."""
    assert len(groundslab.open_study(folder)) == 3
    CHANGES[what](folder)
    study = folder.with_name("study.toml")
    for command in (["evaluate", str(folder)], ["study", str(study), "--resume", "--workers", "0", "--quiet"]):
        assert main.main(command) == 1
        first = capsys.readouterr().err.splitlines()[0]
        assert first.startswith(f"error: certificate withdrawn: {what} in {folder} changed")
    with pytest.raises(CertificateWithdrawn) as caught:
        groundslab.open_study(folder)
    assert caught.value.changed == (what,)
    assert not (folder / "evaluation").exists()


@pytest.mark.parametrize(
    ("table", "change"), [("meshes", "nodes = elements"), ("discretization", "error = 0.1 * error")]
)
def test_changed_meshes_and_errors(folder: Path, table: str, change: str) -> None:
    """Meshes of maps and discretization errors have checksums of their own."""
    _execute(f"UPDATE {table} SET {change}")(folder)
    with pytest.raises(CertificateWithdrawn, match=rf"rows\.sqlite \({table} "):
        groundslab.open_study(folder)


def test_rows_that_are_missing_are_solved_again(folder: Path) -> None:
    """A row that was removed is missing, as is one that was never solved, and is the same after it is solved again."""
    before = groundslab.open_study(folder).table().drop(columns="seconds")
    _execute("DELETE FROM rows WHERE number = 2")(folder)
    assert len(groundslab.open_study(folder)) == 2
    after = run(folder.parent, STUDY.replace("count = 12", "count = 3"), resume=True)
    assert after.table().drop(columns="seconds").equals(before)
