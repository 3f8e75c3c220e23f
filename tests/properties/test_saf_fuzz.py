"""Damaged files in the Structural Analysis Format: each is read, or refused with issues, never with a traceback."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.errors import Issue
from helpers import damaged_workbooks, saf_files
from helpers.examples import examples

pytest.importorskip("openpyxl")

#: What cells may hold by mistake.
ODD: list[Any] = [
    None, "", " ", 0, -1, 1, 1e300, -1e-300, 1e14, "nan", "inf", "1,5", "=1+1", "N1", "N1; N1; N1; N1", "Line",
    "Circular Arc", "Circle and Point", "Spline-3", "Spline", "Bezier; Line", "C1:-1; C2:2", "(1;2;3)", ";;;", "S1",
    "S6", "R1", "LC1", "Z", "Vector", "Local", "Rigid", "Relative", "x" * 40_000, "\u202e", True, 12.5, "Trapez",
    "Absolute", "From end",
]  # fmt: skip


def damage(sheets: saf_files.Sheets, chance: random.Random) -> None:
    """Change some cells, rows, headings or sheets."""
    for _ in range(chance.randint(1, 6)):
        name = chance.choice(sorted(sheets))
        rows = sheets[name]
        what = chance.random()
        if what < 0.04:
            del sheets[name]
        elif what < 0.1:
            del rows[chance.randrange(len(rows))]
            sheets[name] = rows or [["Name"]]
        elif what < 0.16:
            rows.append(list(chance.choice(rows)))
        else:
            row = chance.choice(rows)
            if row:
                row[chance.randrange(len(row))] = chance.choice([*ODD, chance.choice(chance.choice(rows) or [None])])


def attempt(path: Path) -> gs.SafCase | None:
    """Return what is read, None if it is refused with issues; a text that is made is a case file."""
    issues: tuple[Issue, ...] = ()
    with damaged_workbooks.within_limits():
        try:
            read = gs.read_saf(path)
        except gs.InputError as error:
            issues = error.issues
    if issues:
        assert all(issue.found and issue.expected for issue in issues)
        return None
    assert read.report_text()
    casefile.tables(read.text)
    try:
        model = read.model
    except gs.InputError:
        return read
    assert casefile.loads(read.text) == model
    return read


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(examples(3)))
def test_changed_cells(batch: int, tmp_path: Path) -> None:
    """Houses with changed cells, rows and sheets: a good part of them can still be read."""
    read = 0
    for number in range(20):
        sheets = saf_files.house()
        damage(sheets, random.Random(1000 * batch + number))
        if sheets:
            read += attempt(saf_files.write(tmp_path / f"{number}.xlsx", sheets)) is not None
    assert 2 <= read <= 18


@pytest.mark.slow
def test_changed_bytes(tmp_path: Path) -> None:
    """Files cut off, or with other bytes in the archive."""
    whole = saf_files.write(tmp_path / "whole.xlsx", saf_files.house())
    content = whole.read_bytes()
    path = tmp_path / "damaged.xlsx"
    for seed in range(examples(40)):
        chance = random.Random(seed)
        damaged = bytearray(content)
        for _ in range(chance.randint(1, 20)):
            damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        path.write_bytes(bytes(damaged[: chance.randrange(len(damaged))] if seed % 4 == 0 else damaged))
        attempt(path)


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(examples(3)))
def test_changed_parts(batch: int, tmp_path: Path) -> None:
    """Files with formulas, links, dates, joined cells, giant extents and other bytes in the XML of their parts."""
    whole = saf_files.write(tmp_path / "whole.xlsx", saf_files.house())
    path, read = tmp_path / "damaged.xlsx", 0
    for seed in range(25 * batch, 25 * batch + 25):
        read += attempt(damaged_workbooks.change_workbook(whole, path, seed)) is not None
    assert 2 <= read <= 23
