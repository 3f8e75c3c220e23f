"""Tables as CSV and as DataFrames hold what was put into them."""

from __future__ import annotations

import csv
import io
import math
import sys

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from groundslab.errors import InputError
from groundslab.views.tables.table import Table, table_of
from helpers.examples import examples

NUMBERS = st.floats(allow_nan=False)
WORDS = st.text(st.characters(codec="utf-8"), max_size=12)
HEADS = [("name", ""), ("load", "kN"), ("count", ""), ("gaps", "mm")]
TABLES = st.lists(st.tuples(WORDS, NUMBERS, st.integers(-(10**12), 10**12), st.none() | NUMBERS), max_size=6).map(
    lambda rows: table_of("t", "T", HEADS, rows)
)


@pytest.mark.slow
@settings(max_examples=examples(100), deadline=None, derandomize=True)
@given(table=TABLES)
@example(table=table_of("t", "T", HEADS, [('a\r"b"\n,', 1e300, -1, None), ("\r", -math.inf, 0, 5e-324)]))
def test_csv_reads_back(table: Table) -> None:
    """Words and whole numbers come back as they were, other numbers to seven digits, nothing as nothing."""
    text = table.csv().encode("utf-8").decode("utf-8")
    header, *rows = csv.reader(io.StringIO(text, newline=""))
    assert header == [column.header for column in table.columns] == ["name", "load [kN]", "count", "gaps [mm]"]
    assert len(rows) == len(table)
    for (word, load, count, gap), (name, P, n, g) in zip(table.rows(), rows, strict=True):
        assert name == word
        assert math.isclose(float(P), load, rel_tol=5e-7, abs_tol=1e-320)
        assert int(n) == count
        assert (g == "") if gap is None else math.isclose(float(g), gap, rel_tol=5e-7, abs_tol=1e-320)


@pytest.mark.slow
@settings(max_examples=examples(100), deadline=None, derandomize=True)
@given(table=TABLES)
def test_frames_hold_the_same(table: Table) -> None:
    """A DataFrame has the same columns and every digit; gaps among numbers are no numbers."""
    pytest.importorskip("pandas", reason="PANDAS IS NOT INSTALLED: no DataFrame was tested")
    frame = table.frame()
    assert list(frame.columns) == [column.header for column in table.columns]
    for column in table.columns:
        for value, there in zip(column.values, frame[column.header], strict=True):
            assert math.isnan(there) if value is None else there == value
    if any(value is not None for value in table["gaps"]):
        assert frame["gaps [mm]"].dtype == float


def test_without_pandas(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where pandas is missing, the error says how to get it."""
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match=r"pip install groundslab\[tables\]"):
        table_of("t", "T", [("a", "")], [(1,)]).frame()
