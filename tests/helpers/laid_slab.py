"""A slab of 300 mm with bars that are laid, under one even moment, and the stress of its bars by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from groundslab.design.checks import DesignCheck, check_design
from groundslab.model.model import Model
from groundslab.results.results import Results
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

BARS = {"diameter": 0.012, "spacing": 0.15}
LAID: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)
STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.046, 0.058), "top": (0.046, 0.058)}


def model_of(**changes: Any) -> Model:
    """Return a slab of 300 mm with bars that are laid, and combinations of three limit states."""
    return Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[
            {"name": "ULS", "factors": {"G": 1.35}},
            {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}},
            {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0}},
        ],
        reinforcement={**STEEL, **LAID, **changes},
    )


def checks(m_x: float, **changes: Any) -> dict[str, DesignCheck]:
    """Return the checks of the slab under one even moment m_x [N m/m] in every combination, by name."""
    model = model_of(**changes)
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        plate = replace(one.plate, moment_x=flat + m_x, moment_y=flat, moment_xy=flat, pressure=flat)
        thickness = np.full_like(one.elements.thickness, 0.3)
        made[each.name] = replace(one, plate=plate, elements=replace(one.elements, thickness=thickness))
    return {each.name: each for each in check_design(Results(model, model.combinations, made, {})).checks}


def stress_by_hand(m: float) -> float:
    """Return sigma_s [Pa] of 12 mm bars at 150 mm, d = 254 mm: x^2 / 2 = alpha_e A_s (d - x), m / (A_s (d - x / 3))."""
    area, d, ratio = np.pi * 0.012**2 / 4 / 0.15, 0.254, 200e9 / (22e9 * (38 / 10) ** 0.3)
    x = np.roots([0.5, ratio * area, -ratio * area * d]).max()
    return float(m / (area * (d - x / 3)))
