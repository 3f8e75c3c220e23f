"""The table that compares both generations of EN 1992-1-1 is what its command gives now."""

from __future__ import annotations

import re
import runpy
import sys

import pytest

from helpers.paths import DOCS, ROOT


@pytest.mark.slow
def test_the_comparison_is_what_the_command_gives(monkeypatch: pytest.MonkeyPatch) -> None:
    """Row by row, else run tools/write_docs.py; numbers to the last digit but one."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "tools"), *sys.path])
    table = runpy.run_path(str(ROOT / "tools" / "compare_generations.py"))["table"]()
    page = (DOCS / "howto" / "two_generations.md").read_text(encoding="utf-8")
    written = page.split("<!-- comparison: begin -->")[1].split("<!-- comparison: end -->")[0].strip()
    number = re.compile(r"\d+\.?\d*")
    rows, known = ([line.split("|") for line in text.strip().splitlines()] for text in (table, written))
    assert [row[1:3] for row in rows] == [row[1:3] for row in known]
    for row, other in zip(rows[2:], known[2:], strict=True):
        for cell, before in zip(row[3:], other[3:], strict=True):
            assert bool(number.search(cell)) == bool(number.search(before))
            if number.search(cell):
                assert float(cell) == pytest.approx(float(before), rel=2e-2, abs=0.011)
