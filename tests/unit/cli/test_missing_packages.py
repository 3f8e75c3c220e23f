"""Packages that are missing are reported before the work that they are needed for."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NoReturn

import pytest

import groundslab
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.views.files import results_folder
from helpers.reactions import write_case
from helpers.studies import write


def forget(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a package be as if it were not installed."""
    for name in {package, *(name for name in sys.modules if name.partition(".")[0] == package)}:
        monkeypatch.setitem(sys.modules, name, None)


@pytest.fixture
def no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the test fail if results are read."""

    def read(*_: object) -> NoReturn:
        raise AssertionError("results were read")

    monkeypatch.setattr(results_folder, "load_results", read)


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize(
    ("package", "arguments", "extra"),
    [
        ("xlsxwriter", ["tables", "slab-results"], "tables"),
        ("ezdxf", ["bars", "slab-results"], "dxf"),
        ("openpyxl", ["import-saf", "house.xlsx"], "exchange"),
        ("ifcopenshell", ["import-ifc", "house.ifc"], "ifc"),
        ("openpyxl", ["export-saf", "slab-results"], "exchange"),
        ("mcp", ["mcp", "."], "mcp"),
    ],
)
def test_a_missing_package_is_named_before_results_are_read(
    package: str,
    arguments: list[str],
    extra: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Report, tables and bars end at once, with the command that installs what is missing."""
    monkeypatch.chdir(tmp_path)
    forget(package, monkeypatch)
    assert main.main(arguments) == 2
    assert f"pip install groundslab[{extra}]" in capsys.readouterr().err


def test_a_workbook_of_reactions_needs_its_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The message names the extra, and that CSV does without it."""
    forget("openpyxl", monkeypatch)
    (tmp_path / "reactions.xlsx").write_bytes(b"")
    case = write_case(tmp_path)
    assert main.main(["import-reactions", str(tmp_path / "reactions.xlsx"), str(case)]) == 2
    told = capsys.readouterr().err
    assert "pip install groundslab[exchange]" in told
    assert "CSV" in told


def test_without_dask_a_study_leaves_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A study that cannot begin leaves no folder behind, which the next attempt would be refused for."""
    forget("distributed", monkeypatch)
    study = write(tmp_path)
    with pytest.raises(InputError, match=r"groundslab\[study\]; --workers 0 does without it"):
        groundslab.study(study, workers=1, quiet=True)
    assert [path.name for path in tmp_path.iterdir() if path.is_dir()] == []
