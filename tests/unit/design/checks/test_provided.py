"""Bars that are laid: enough of them, close enough, cracks narrow enough, each by hand on one even moment."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.materials import Concrete, Steel
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.results.results import Results
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

BARS = {"diameter": 0.012, "spacing": 0.15}
LAID: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)
STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.046, 0.058), "top": (0.046, 0.058)}


def checks(m_x: float, **changes: Any) -> dict[str, DesignCheck]:
    """Return the checks of a slab of 300 mm under one even moment m_x [N m/m] in every combination, by name."""
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[
            {"name": "ULS", "factors": {"G": 1.35}},
            {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}},
        ],
        reinforcement={**STEEL, **LAID, **changes},
    )
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        plate = replace(one.plate, moment_x=flat + m_x, moment_y=flat, moment_xy=flat, pressure=flat)
        thickness = np.full_like(one.elements.thickness, 0.3)
        made[each.name] = replace(one, plate=plate, elements=replace(one.elements, thickness=thickness))
    return {each.name: each for each in check_design(Results(model, model.combinations, made, {})).checks}


def test_bars_against_what_bending_needs() -> None:
    """D = 254 mm: 7.54 cm2/m bear A_s f_yd (d - A_s f_yd / (2 f_cd)) = 81.2 kNm/m; a little more and they fail."""
    area, f_yd, f_cd = np.pi * 0.012**2 / 4 / 0.15, 500e6 / 1.15, 20e6
    most = area * f_yd * (0.254 - area * f_yd / (2 * f_cd))
    assert most == pytest.approx(80.6e3, rel=0.01)
    for m, status, used in ((0.999 * most, "no failure found", 1.0), (1.001 * most, "fails", 1.0)):
        check = checks(m)["bars at the bottom x"]
        assert check.status == status
        assert check.utilisation == pytest.approx(used, rel=2e-3)
        assert check.resistance == pytest.approx(7.540, rel=1e-3)
    assert checks(most)["bars at the top x"].status == "no failure found"


def test_distance_of_bars() -> None:
    """At most 400 mm (3 h = 900 mm)."""
    assert checks(1e3)["distance of bars"].status == "no failure found"
    far = checks(1e3, top_y={"diameter": 0.012, "spacing": 0.41})["distance of bars"]
    assert (far.status, far.of) == ("fails", "top y")


def test_crack_width() -> None:
    """The width of cracking.crack_width at the bottom along x, none at the top; both sides of the limit."""
    m = 60e3
    width = float(cracking.crack_width(np.array([m]), np.array(0.3), cracking.Bars(0.012, 0.15, 0.04),
                                       Concrete(30e6), Steel(500e6))[0])  # fmt: skip
    found = checks(m, w_max=1.01 * width)
    assert found["crack width at the bottom x"].status == "no failure found"
    assert found["crack width at the bottom x"].demand == pytest.approx(1e3 * width)
    assert found["crack width at the top x"].demand == 0.0
    assert checks(m, w_max=0.99 * width)["crack width at the bottom x"].status == "fails"


def test_layers_that_are_missing_and_bars_too_thick() -> None:
    """All four layers or none; bars that stick out of their cover; a crack width without bars."""
    with pytest.raises(InputError, match="bars in all four layers"):
        checks(1e3, top_x=None)
    with pytest.raises(InputError, match="bars thinner than"):
        checks(1e3, bottom_x={"diameter": 0.05, "spacing": 0.1}, bottom=(0.02, 0.058))
    with pytest.raises(InputError, match="bars in all four layers"):
        checks(1e3, w_max=3e-4, **dict.fromkeys(LAID))
