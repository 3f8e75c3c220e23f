"""How bars end and lap in a case by ACI 318-19."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.codes.aci318 import development
from groundslab.design.codes.aci318.checks.bars import CLEAR, CRACKS, SPACING, crack_spacing, crack_stress, least_cover
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.detailing_rule import BendRule, DetailingRule, EndingBar
from groundslab.model.design.reinforcement import Reinforcement

#: The largest diameters [m] of No. 5, No. 8 and No. 11, a little above them.
NO_5, NO_8, NO_11 = 0.0160, 0.0260, 0.0370
#: The straight part of a hook is at least so long [m], 3 in. (Table 25.3.2).
LEAST_HOOK = 0.0762
#: Bars reach so many diameters, or d, beyond where they are needed (7.7.3.3, by 8.7.4.1.1).
BEYOND = 12


def _length(steel: Reinforcement, bar: EndingBar, *, splice: bool) -> float:
    """Return the development or splice length [m] of a bar."""
    find = development.splice_length if splice else development.development_length
    cover, clear = bar.axis - bar.diameter / 2, bar.spacing - bar.diameter
    return find(*materials(steel), bar.diameter, cover=cover, clear=clear, below=bar.below)


def anchorage_steps(steel: Reinforcement, bar: EndingBar, n: int) -> Iterator[Step]:
    """Yield how the development length of bars number n is found."""
    concrete, bars = materials(steel)
    cover, clear = bar.axis - bar.diameter / 2, bar.spacing - bar.diameter
    divisor, psi_g, psi_t, close = development.factors(bars, bar.diameter, cover, clear, bar.below)
    yield Step("yield strength", "f_y", bars.f_y / MEGA, "MPa", clause="20.2.1")
    yield Step("root of the concrete's strength that counts", "r", concrete.root / MEGA, "MPa", clause="25.4.1.4")
    yield Step("factor of the grade", "psi_g", psi_g, clause="Table 25.4.2.5")
    yield Step("concrete below the axis of the bar", f"h_b,{n}", bar.below, "m")
    yield Step("factor of concrete cast below", f"psi_t,{n}", psi_t, clause="Table 25.4.2.5")
    yield Step("cover of the bar", f"c_{n}", cover, "m")
    yield Step("clear distance of bars", f"c_s,{n}", clear, "m")
    words = "factor of bars closer than 2 d_b, or with less cover than d_b"
    yield Step(words, f"k_{n}", close, clause="Table 25.4.2.3")
    yield Step("divisor of thin or thick bars", f"q_{n}", divisor, clause="Table 25.4.2.3")
    formula = f"max(f_y * psi_t,{n} * psi_g * k_{n} / (q_{n} * r) * phi_{n}, {development.LEAST:g})"
    length = _length(steel, bar, splice=False)
    yield Step("development length", f"l_b,{n}", length, "m", formula, "25.4.2.1, 25.4.2.3")


def _spacing(_: Reinforcement, thickness: float) -> float:
    """Return the largest spacing [m] (8.7.2.2)."""
    times, least, most = SPACING
    return min(max(times * thickness, least), most)


def _crack_spacing(steel: Reinforcement, cover: float) -> float:
    """Return the largest spacing [m] for cracks, at two thirds of f_y (24.3.2), the lesser of both editions."""
    return float(min(crack_spacing(crack_stress(steel), np.array(cover), units) for units in CRACKS))


def _mandrel(diameter: float) -> float:
    """Return the least inside diameter of bends of bars [m] (Table 25.3.1)."""
    return diameter * (6 if diameter < NO_8 else 8 if diameter < NO_11 else 10)


def _link_mandrel(diameter: float) -> float:
    """Return the least inside diameter of bends of stirrups [m] (Table 25.3.2)."""
    return 4 * diameter if diameter <= NO_5 else _mandrel(diameter)


def _hook(diameter: float, angle: float) -> float:
    """Return the straight extension of a stirrup's hook [m] (Table 25.3.2)."""
    if angle <= 90 and diameter > NO_5:
        return 12 * diameter
    return max(6 * diameter, LEAST_HOOK)


RULE = DetailingRule(
    anchorage=lambda steel, bar: _length(steel, bar, splice=False),
    lap=lambda steel, bar: _length(steel, bar, splice=True),
    shift=lambda d, diameter: np.maximum(d, BEYOND * diameter),
    least_cover=lambda _, layer, diameter: least_cover(layer, diameter, "SI"),
    least_clear=lambda steel, diameter: max(diameter, CLEAR[0], CLEAR[1] * (steel.aggregate or 0.0)),
    spacing=_spacing,
    edge_leg=2.0,  # as EN 1992-1-1 Figure 9.8: ACI 318 has no rule
    crack_area=None,
    crack_spacing=_crack_spacing,
    anchorage_steps=anchorage_steps,
    bends=BendRule(_mandrel, _link_mandrel, _hook, "25.3"),
    clauses={"anchorage": "25.4.2", "laps": "25.5.2", "shift": "7.7.3.3", "edges": ""},
)
