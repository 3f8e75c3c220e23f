"""The text of a case with another reinforcement: keys that mean the same stay as they are written."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from groundslab.case import casefile
from groundslab.case.editing.reinforcement import with_reinforcement
from groundslab.model.design.bars import Bars
from groundslab.model.shapes import Rectangle

MAT = """\
[plate]
length_x = "24 ft"
length_y = "12 ft"
thickness = "36 in"
E = "3600 ksi"
nu = 0.2

[ground]
kind = "winkler"
k = "100 pci"

[reinforcement]   # of the mat
code = "ACI 318"
f_ck = "4000 psi"   # 28 days
f_yk = "60 ksi"
bottom = ["3.5 in", "4.5 in"]
top = ["2.5 in", "3.5 in"]
bottom_x = {diameter = "#7", spacing = "7 in"}
bottom_y = {diameter = "#7", spacing = "7 in"}
top_x = {diameter = "#6", spacing = "8 in"}
top_y = {diameter = "#6", spacing = "8 in"}

[mesh]
size = "2 ft"

[project]
units = "US"

[[cases]]
name = "G"

[[combinations]]
name = "ultimate"
factors = {G = 1.35}

[[loads]]
case = "G"
kind = "uniform"
q = "500 psf"
"""


def test_strengths_and_comments_stay(tmp_path: Path) -> None:
    """Only the bars are others, in inches; tables around stay."""
    model = casefile.loads(MAT)
    steel = model.reinforcement
    assert steel is not None
    model = model.replace(reinforcement=steel.replace(bottom_x=Bars(diameter="#6", spacing=0.127)))
    text = with_reinforcement(MAT, model.reinforcement, tmp_path)
    assert casefile.loads(text) == model
    changed = [line for line in text.splitlines() if line not in MAT.splitlines()]
    assert changed == ['bottom_x = {diameter = "#6", spacing = "5 in"}']


def test_bars_are_in_millimeters_and_other_lengths_in_meters(tmp_path: Path) -> None:
    """In SI units diameters and spacings are those of drawings."""
    text = MAT.replace('[project]\nunits = "US"\n', "").replace('"#7"', '"22 mm"').replace('"#6"', '"20 mm"')
    model = casefile.loads(text)
    steel = model.reinforcement
    assert steel is not None
    zone = {
        "name": "top",
        "layers": ("top_x",),
        "diameter": 0.012,
        "spacing": 0.2,
        "shape": Rectangle(x=(0, 1.5), y=(0, 2)),
    }
    steel = steel.replace(top_x=Bars(diameter=0.01, spacing=0.225)).replace(zones=[zone])
    written = with_reinforcement(text, steel, tmp_path)
    assert casefile.loads(written).reinforcement == steel
    for part in ('diameter = "10 mm"', 'spacing = "225 mm"', 'diameter = "12 mm"', 'x = ["0.0 m", "1.5 m"]'):
        assert part in written
    assert 'f_ck = "4000 psi"   # 28 days' in written


@pytest.mark.parametrize("inline", [True, False])
def test_what_is_gone_is_removed(tmp_path: Path, inline: bool) -> None:
    """Bars of layers that have none any more are no longer in the text, wherever they stood."""
    bars = re.compile(r"^(\w+_[xy]) = \{(.*), (.*)\}\n", re.MULTILINE)
    headed = "".join(f"\n[reinforcement.{layer}]\n{first}\n{other}\n" for layer, first, other in bars.findall(MAT))
    text = MAT if inline else bars.sub("", MAT) + headed
    model = casefile.loads(text)
    steel = model.reinforcement
    assert steel is not None
    assert steel.laid
    model = model.replace(reinforcement=steel.replace(bottom_x=None, bottom_y=None, top_x=None, top_y=None))
    written = with_reinforcement(text, model.reinforcement, tmp_path)
    assert casefile.loads(written) == model
    assert "bottom_x" not in written
    assert "# 28 days" in written
