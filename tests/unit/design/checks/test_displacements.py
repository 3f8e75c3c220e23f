"""Displacements that are not small are said, and a mesh that tells nothing is the whole verdict."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import groundslab
from groundslab.cli import main
from groundslab.design.checks import displacements
from groundslab.results.results import Results

#: A strip 10 m long on four springs' worth of ground, bent by its own load at the middle.
CASE = """
[plate]
length_x = "10 m"
length_y = "2 m"
thickness = "{h} m"
E = "30 GPa"
nu = 0
[mesh]
size = "0.5 m"
[ground]
kind = "winkler"
k = "{k} MN/m3"
[[loads]]
kind = "uniform"
q = "{q} kPa"
[[supports]]
kind = "line"
name = "left"
points = [["-5 m", "-1 m"], ["-5 m", "1 m"]]
[[supports]]
kind = "line"
name = "right"
points = [["5 m", "-1 m"], ["5 m", "1 m"]]
"""


def solved(folder: Path, **values: float) -> Results:
    """Return the results of the strip."""
    path = folder / "strip.toml"
    path.write_text(CASE.format(**values), encoding="utf-8")
    return groundslab.solve(groundslab.load(path))


def found(results: Results) -> list[str]:
    """Return the words of the check."""
    return [check.words for check in groundslab.check_design(results).checks if check.name == displacements.NAME]


@pytest.mark.parametrize(("share", "told"), [(0.9, False), (1.1, True)])
def test_half_the_thickness(tmp_path: Path, share: float, told: bool) -> None:
    """A strip on two supports bends off its plane by w less its mean part; that is told above half the thickness.

    By beam theory w = 5 q L^4 / (384 E I), without shear, whose part is (h / L)^2: the sagging curve
    w (16/5) (s - 2 s^3 + s^4) has the mean 16/25 w, and a plane fits it best that is level there. So the ends are off
    by 0.64 w, which is the most.
    """
    h, L, E = 0.1, 10.0, 30e9
    w = share * (0.5 * h) / 0.64
    q = w * 384 * E * (h**3 / 12) / (5 * L**4)
    results = solved(tmp_path, h=h, k=1e-6, q=q / 1e3)
    assert results.plate.settlement.max() == pytest.approx(w, rel=0.01)
    words = found(results)
    assert bool(words) is told
    if told:
        assert words[0].startswith(f'"all loads" bends the slab off a plane by {0.64 * 1e3 * w:.2g}')
        assert groundslab.check_design(results).status == "attention"


def test_settling_as_a_whole_is_no_deflection(tmp_path: Path) -> None:
    """A slab that settles and tilts by more than its thickness, and stays plane, is not told of."""
    nodes = np.random.default_rng(1).uniform(-5, 5, (50, 2))
    w = 3.0 + 0.02 * nodes[:, 0] - 0.01 * nodes[:, 1]
    assert np.abs(displacements._off_plane(nodes, w, np.ones(50))).max() < 1e-12
    assert found(solved(tmp_path, h=0.3, k=20, q=10)) == []


THIN = """
[plate]
length_x = "10 m"
length_y = "6 m"
thickness = "1 mm"
E = "30 GPa"
nu = 0.2
[mesh]
size = "1 m"
[ground]
kind = "winkler"
k = "20 MN/m3"
[[loads]]
kind = "point"
x = "0 m"
y = "0 m"
P = "100 kN"
[[loads]]
kind = "point"
x = "4 m"
y = "0 m"
P = "-20 kN"
"""


def test_one_verdict(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A plate of 1 mm on elements of 1 m lifts by kilometers: that is told first, and nowhere that it is certified."""
    case = tmp_path / "thin.toml"
    case.write_text(THIN, encoding="utf-8")
    assert main.main(["solve", str(case)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "membrane forces, which are left out" in said[: said.index("Plate")]
    assert "Do not use these results" in said
    assert "certified:" not in said
    page = tmp_path / "thin.html"
    assert main.main(["report", str(tmp_path / "thin-results"), "--out", str(page)]) == 0
    html = page.read_text(encoding="utf-8")
    assert "Do not use these results" in html
    assert "membrane forces, which are left out" in html
    assert "The result is certified" not in html[: html.index("<script")]
