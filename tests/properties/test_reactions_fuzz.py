"""Damaged tables of reactions: each is read, or refused with issues, never with a traceback."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.errors import Issue
from groundslab.exchange.reactions import ImportedReactions, read_reactions
from helpers import damaged_workbooks
from helpers.examples import examples
from helpers.reactions import BY_HAND, CASE, ETABS, RFEM, write_case, write_table, write_workbook

PER_LENGTH = "Wall;Case;Fx [kN/m];pz [kN/m];Mx [kNm/m]\nW;G;1,5;30;5\nW;Q;0;12,5;-1\n"
TABLES = {"etabs": ETABS, "rfem": RFEM, "by hand": BY_HAND, "per length": PER_LENGTH}
#: What the tables leave open, whether they are damaged or not.
SAID = {"101": "A", "102": "B"}


def attempt(table: Path, case: Path) -> ImportedReactions | None:
    """Return what is imported, None if it is refused with issues; a text that is made is the case that is stated."""
    made, issues = None, tuple[Issue, ...]()
    with damaged_workbooks.within_limits():
        try:
            made = read_reactions(table, case, supports=SAID, horizontal="on the slab")
        except gs.InputError as error:
            issues = error.issues
    if made is None:
        assert issues
        assert all(issue.found and issue.expected for issue in issues)
        return None
    assert casefile.loads(made.text) == made.model
    assert [str(line) for line in (*made.changes, *made.sums, *made.remarks)]
    return made


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES)
def test_changed_texts(name: str, tmp_path: Path) -> None:
    """Of each table: a good part of them can still be read."""
    case = write_case(tmp_path)
    assert attempt(write_table(tmp_path, TABLES[name]), case) is not None
    read = [
        attempt(write_table(tmp_path, damaged_workbooks.change_text(TABLES[name], seed)), case)
        for seed in range(examples(80))
    ]
    assert 0.06 < sum(made is not None for made in read) / len(read) < 0.94


@pytest.mark.slow
def test_changed_workbooks(tmp_path: Path) -> None:
    """Workbooks with cells, rows and bytes of their parts changed."""
    pytest.importorskip("openpyxl")
    case = write_case(tmp_path)
    rows = [[_number(cell) for cell in row] for row in csv.reader(io.StringIO(ETABS))]
    whole = write_workbook(tmp_path / "whole.xlsx", {"Reactions": rows, "Notes": [["a", "b"]]})
    assert attempt(whole, case) is not None
    path = tmp_path / "damaged.xlsx"
    read = [attempt(damaged_workbooks.change_workbook(whole, path, seed), case) for seed in range(examples(120))]
    assert 0.1 < sum(made is not None for made in read) / len(read) < 0.9


def _number(cell: str) -> str | float:
    """Return a cell as a program would write it."""
    try:
        return float(cell.replace(",", ""))
    except ValueError:
        return cell


def test_the_case_is_left_alone(tmp_path: Path) -> None:
    """Nothing is written, whatever the table says."""
    case = write_case(tmp_path)
    for seed in range(5):
        attempt(write_table(tmp_path, damaged_workbooks.change_text(ETABS, seed)), case)
    assert case.read_text(encoding="utf-8") == CASE
