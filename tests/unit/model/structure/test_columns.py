"""Columns of a model: footprints at an angle, and those that overlap."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.structure.columns import Column, overlapping_columns
from groundslab.schema.base import Section

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


def test_a_column_at_an_angle() -> None:
    """Its corners by hand, counterclockwise from x; at right angles sides are exchanged to the last digit."""
    sides = {"name": "C", "x": 1.0, "y": 2.0, "width_x": 0.4, "width_y": 0.2}
    half = math.sqrt(3) / 2
    corners = [
        (1 + half * u - v / 2, 2 + u / 2 + half * v) for u, v in ((-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1))
    ]
    column = Column(**sides, angle=30)
    assert np.array(column.ring().points) == pytest.approx(np.array(corners))
    assert column.extents == pytest.approx((0.4 * half + 0.1, 0.2 + 0.2 * half))
    exchanged = Column(**sides | {"width_x": 0.2, "width_y": 0.4})
    for quarter in (90, -90, 270):
        turned = Column(**sides, angle=quarter)
        assert (turned.ring(), turned.extents) == (exchanged.ring(), exchanged.extents)
    assert Column(**sides, angle=180).ring() == Column(**sides).ring()


@pytest.mark.parametrize(
    ("section", "others", "found"),
    [
        (Column, {"name": "C", "diameter": 0.4}, "Column.angle: found an angle of a circle"),
        (PointLoad, {"P": 1e3, "diameter": 0.4}, "PointLoad.angle: found an angle of a circle"),
        (PointLoad, {"P": 1e3}, "PointLoad.angle: found an angle without widths"),
        (Column, {"name": "C", "width_x": 0.4, "width_y": 0.2, "angle": 400}, "Column.angle: found 400"),
    ],
)
def test_angles_of_what_has_no_sides_are_refused(section: type[Section], others: dict[str, Any], found: str) -> None:
    """A circle, and a force without a footprint, have no angle; 0 is none."""
    with pytest.raises(InputError) as caught:
        section(**{"x": 0.0, "y": 0.0, "angle": 30.0} | others)
    assert found in str(caught.value)
    if "width_x" not in others:
        section(**{"x": 0.0, "y": 0.0, "angle": 0.0} | others)


def test_an_angle_together_with_a_column_is_refused() -> None:
    """The column says at which angle its load is spread."""
    with pytest.raises(InputError, match="angle together with a column"):
        PointLoad(P=1e3, column="C", angle=30.0)


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
