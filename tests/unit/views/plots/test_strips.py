"""Curves along design strips: mean moments over the ultimate combinations, and the bars that they need."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.design.demands.cuts.section_cuts import strip
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.plots.strips import curves_of_strips
from groundslab.views.report.drawings.drawings import draw_beams
from helpers.solve_once import solve_once

F_YD, F_CD, D = 500e6 / 1.15, 30e6 / 1.5, 0.45


def solved(**changes: Any) -> Results:
    """Return a slab under a line load along y, which bends along x alone, in two ultimate combinations."""
    given: dict[str, Any] = {
        "plate": {"length_x": 8.0, "length_y": 4.0, "thickness": 0.5, "E": 33e9, "nu": 0.0},
        "ground": {"kind": "winkler", "k": 25e6}, "cases": [{"name": "G"}],
        "loads": [{"kind": "line", "case": "G", "q": 600e3, "points": [(0, -2), (0, 2)]}],
        "combinations": [
            {"name": name, "factors": {"G": factor}} for name, factor in (("U", 1.35), ("L", 1.0))
        ],
        "reinforcement": {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.06), "top": (0.05, 0.06)},
        "output": {"strips": [
            {"name": "S", "start": (-4, 0), "end": (4, 0), "width": 2.0, "stations": 9},
            {"name": "oblique", "start": (-3, -1), "end": (3, 1), "width": 1.0, "stations": 5},
        ]},
        "mesh": {"size": 0.5},
    }  # fmt: skip
    return solve_once(Model(**given | changes))


def test_curves_are_means_and_bars_by_hand() -> None:
    """The larger combination governs the sagging middle; A_s of its moment by the rectangular stress block."""
    results = solved()
    of, oblique = curves_of_strips(results)
    means = [strip(each.plate, (-4, 0), (4, 0), 2.0, 9).mean_moment / 1e3 for each in results.results.values()]
    assert of.values["moment"][0] == pytest.approx(np.max(means, axis=0))
    assert of.values["moment"][1] == pytest.approx(np.min(means, axis=0))
    m = float(of.values["moment"][0].max()) * 1e3
    z = D * (1 + np.sqrt(1 - 2 * m / (F_CD * D**2))) / 2
    assert of.values["bars"][0].max() == pytest.approx(m / (z * F_YD) * 1e4, rel=5e-3)
    assert (of.values["bars"][1] <= 0).all()
    assert "bars" not in oblique.values  # the layers of x and y are at an angle to it


def test_the_report_shows_strips_of_plates_once() -> None:
    """As one picture; without steel the moments alone, and none of strips that are beams."""
    captions = [str(drawing.caption) for drawing in draw_beams(solved())]
    assert sum("Along the strips" in caption for caption in captions) == 1
    beam = {"strips": [{"name": "S", "start": (-4, 0), "end": (4, 0), "width": 4.0, "design": "beam"}]}
    plate = {"length_x": 8.0, "length_y": 4.0, "thickness": 0.9, "E": 33e9, "nu": 0.0}
    assert curves_of_strips(solved(output=beam, plate=plate)) == []
    (of, _) = curves_of_strips(solved(reinforcement=None))
    assert list(of.values) == ["moment"]
