"""Two versions of a case: merged where they changed different tables, else not."""

from __future__ import annotations

import pytest

from groundslab.workbench.editing.merge import compare, merge

BASE = """\
title = "A raft"

[plate]
length_x = "6 m"
thickness = "250 mm"

[ground]
kind = "winkler"
k = "20 MPa/m"

[[loads]]
kind = "uniform"
q = "10 kPa"
"""
COLUMN = '\n[[columns]]\nname = "A"\n'


def test_changes_of_different_tables_are_merged() -> None:
    """Each keeps its lines with their comments, whatever the order; a text that did not change is that of the other."""
    mine = BASE.replace('"250 mm"', '"300 mm"  # thicker')
    theirs = BASE.replace("20 MPa/m", "30 MPa/m").replace("[ground]", "# by the report of March\n[ground]")
    both = mine.replace("20 MPa/m", "30 MPa/m").replace("[ground]", "# by the report of March\n[ground]")
    assert merge(BASE, mine, theirs) == merge(BASE, theirs, mine) == both
    assert merge(BASE, BASE, theirs) == theirs
    assert merge(BASE, mine, BASE) == mine
    assert merge(BASE, mine, mine) is None  # one table that both changed


@pytest.mark.parametrize(
    ("mine", "theirs"),
    [
        (BASE.replace("250 mm", "300 mm"), BASE.replace("6 m", "7 m")),  # other lines of one table
        (BASE + COLUMN, BASE + '\n[[supports]]\nkind = "point"\n'),  # other tables at one place
        (BASE.replace("250 mm", "300 mm"), "[plate"),  # no TOML
        (
            BASE.replace("[[loads]]", "[[loads]]  # mine"),
            BASE.replace('kind = "uniform"', 'kind = "point"'),
        ),  # touching
    ],
)
def test_changes_that_cannot_be_told_apart_are_not(mine: str, theirs: str) -> None:
    """Nothing is guessed."""
    assert merge(BASE, mine, theirs) is None
    assert merge(BASE, theirs, mine) is None


def test_a_comparison_lists_the_lines_that_differ() -> None:
    """Of the file against the page, with a line around; without a common base nothing is merged."""
    theirs = BASE.replace("20 MPa/m", "30 MPa/m")
    compared = compare(None, BASE, theirs)
    assert [line for line in compared.lines if line[:1] in "+-"] == ['-k = "20 MPa/m"', '+k = "30 MPa/m"']
    assert compared.merged is None
    assert compare(BASE, BASE.replace("250 mm", "300 mm"), theirs).merged is not None
