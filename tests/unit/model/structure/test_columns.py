"""Columns of a model: footprints that overlap."""

from __future__ import annotations

from pathlib import Path

import pytest

from groundslab.cli import main
from groundslab.model.structure.columns import Column, overlapping_columns

CASE = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "400 mm"
E = "33 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "20 MPa/m"
[[columns]]
name = "C1"
x = "1 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"
[[columns]]
name = "C2"
x = "1.1 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"
[[loads]]
kind = "point"
column = "C1"
P = "600 kN"
"""


def test_columns_that_overlap_are_named() -> None:
    """0.3 x 0.4 m of two columns 0.1 m apart; columns that touch, or stand apart, are none."""
    square = {"y": 0.0, "width_x": 0.4, "width_y": 0.4}
    columns = [Column(name=name, x=x, **square) for name, x in (("C1", 1.0), ("C2", 1.1), ("C3", 1.5), ("C4", 3.0))]
    (remark,) = overlapping_columns(tuple(columns))
    assert remark == "columns C1 and C2 overlap by 0.12 m2 of their footprints"
    assert not list(overlapping_columns(()))


def test_check_remarks_columns_that_overlap(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The case is fine, as it can be solved, and the remark names both columns."""
    path = tmp_path / "case.toml"
    path.write_text(CASE, encoding="utf-8")
    assert main.main(["check", str(path)]) == 0
    assert "  remark: columns C1 and C2 overlap by 0.12 m2" in capsys.readouterr().out
