"""The page on studies is held to the code: its study runs, its lists are those of the code."""

from __future__ import annotations

import re
import sqlite3
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

import groundslab
from groundslab.study.definition.schema import Correlogram, SamplingKind
from groundslab.study.execution.variant import REASONS
from helpers.paths import DOCS
from helpers.studies import run

PAGE = (DOCS / "study.md").read_text(encoding="utf-8")


def block(page: str, language: str, number: int = 0) -> str:
    """Return a fenced block of a page."""
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[number]


@pytest.mark.slow
def test_study_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The study on the page runs with the smallest case of the input page, and is read as the page says."""
    case = block((DOCS / "input.md").read_text(encoding="utf-8"), "toml") + "\n[mesh]\ncounts = [6, 4]\n"
    study = run(tmp_path, block(PAGE, "toml").replace("count = 2000", "count = 3"), case)
    assert study.counts() == {"solved": 3}
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(compile(block(PAGE, "python", 1), "study.md", "exec"), names)
    opened = names["study"]
    assert isinstance(opened, groundslab.study.Study)
    assert len(opened.table()) == 3
    assert opened.units["k"] == "Pa/m"
    assert np.isfinite(opened.map("settlement", "std").values).all()
    compile(block(PAGE, "python", 0), "study.md", "exec")


def test_lists_of_the_page() -> None:
    """The page lists all ways of sampling, all correlations and all reasons, and no others."""
    section = PAGE.split("## How variants are made")[1].split("##")[0]
    assert set(re.findall(r"^\| `([^`]+)` \| (?!variants)", section, re.MULTILINE)) == set(get_args(SamplingKind))
    section = PAGE.split("## Random fields")[1].split("##")[0]
    assert re.findall(r"^\| `(\w+)` \| (?:exp|\()", section, re.MULTILINE) == list(get_args(Correlogram))
    assert all(f"`{reason}`" in PAGE for reason in REASONS.values())


def test_folder_of_the_page(tmp_path: Path) -> None:
    """The page names the files of a study's folder and its tables."""
    text = 'case = "slab.toml"\n[sampling]\nkind = "list"\n[[vary]]\npath = "plate.nu"\nvalues = [0.2]\n'
    study = run(tmp_path, text + '[[keep]]\nof = "load"\n')
    section = PAGE.split("## What is on the disk")[1].split("##")[0]
    assert all(f"`{path.name}`" in section for path in study.folder.iterdir() if path.name != "lock.sqlite")

    with sqlite3.connect(study.folder / "rows.sqlite") as connection:
        tables = {name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    connection.close()
    assert set(re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE)) == tables
