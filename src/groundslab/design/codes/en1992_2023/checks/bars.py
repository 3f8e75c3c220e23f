"""Bars that are laid by EN 1992-1-1:2023: how far apart, their cover, their stress, how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023 import cracking
from groundslab.design.codes.en1992_2023.annex import RECOMMENDED
from groundslab.design.codes.en1992_2023.checks import crack_steps
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.eurocode2.bent_bars import (
    BarField,
    BentBars,
    BySteps,
    Clauses,
    bars_at,
    bars_in_tension,
    check_cracks,
    check_stresses,
)
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.design.codes.eurocode2.first_cracks import FirstCracks, check_first_cracks
from groundslab.design.codes.eurocode2.materials import strengths
from groundslab.design.rules.bar_checks import check_cover, check_spacing
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_LIMIT, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results
from groundslab.model.design.laid_bars import LaidBars, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results

CODE = "EN 1992-1-1:2023"
#: The limits of stresses and of crack widths are of Tables 9.1 and 9.2.
CLAUSES = Clauses(CODE, stress="9.2.1", yielding="9.2.1", crack="9.2.3", width="w_k,cal")


def checks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the checks of bars that are laid, by layer."""
    yield check_spacing(solved_results(combined)[0], laid, RECOMMENDED.spacing, CODE, "12.4.1, Table 12.2")
    yield _cover(steel)
    concrete, bars = materials(steel)

    def stress(m: Array, h: Array, tension_bars: Bars) -> Array:
        return cracking.bar_stress(m, h, tension_bars, concrete, bars)

    f_yk = strengths(steel)[1]
    bent = bars_in_tension(combined, steel, laid, "characteristic", stress)
    yield from check_stresses(bent, f_yk, CLAUSES, partial(_stress_steps, combined, steel, laid))
    least = FirstCracks(
        lambda h: cracking.minimum_area(h, concrete, bars.f_yk),
        CODE,
        "9.2.2, 9.2",
        "sigma_s = f_yk",
        lambda h, area: crack_steps.least_bars(h, area, concrete, bars),
    )
    if steel.w_max is None:
        words = "w_max is not given, and the limits of Table 9.1 were not read"
        yield not_judged("crack width", NO_LIMIT, words, clause=f"{CODE} 9.2.1")
        return
    yield check_first_cracks(combined, laid, least)
    yield from _cracks(combined, steel, laid, stress)


def _stress_steps(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], bent: BentBars) -> Iterator[Step]:
    """Yield the stress of bars in a cracked section."""
    h, bars = bars_at(combined, steel, laid[bent.layer], bent)
    return crack_steps.stress(bent.moment, h, bars, *materials(steel))


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is what bond asks for, and Delta c_dev, or more (clause 6.5)."""
    # bond asks for the bar's diameter, and 10 mm are the least (6.5.2)
    least = {
        layer: [max(bars.diameter, 0.010) + RECOMMENDED.delta_c_dev for bars in bars_of(steel, layer)]
        for layer in LAYERS
    }
    where = "in any exposure (bond, 6.5.2); durability by exposure resistance classes is not checked"
    return check_cover(steel, least, where, f"{CODE} 6.5", _why)


def _why(_: str, diameter: float) -> Iterator[Step]:
    """Yield the nominal cover [mm] of a bar [m]."""
    phi, deviation = diameter * 1e3, RECOMMENDED.delta_c_dev * 1e3
    c_min = max(phi, 10.0)
    yield Step("least cover for bond", "c_min", c_min, "mm", "max(phi, 10)", "6.5.2")
    yield Step("allowance for deviations", "Delta_c,dev", deviation, "mm", clause="6.5.3")
    yield Step("nominal cover", "c_nom", c_min + deviation, "mm", "c_min + Delta_c,dev", "6.5.1")


def _cracks(
    combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], stress: BarField
) -> Iterator[DesignCheck]:
    """Yield the widest crack at each layer in the quasi-permanent combinations (9.2.3)."""
    concrete, bars = materials(steel)
    assert steel.w_max is not None

    def steps(crack: BentBars) -> Iterator[Step]:
        h, crack_bars = bars_at(combined, steel, laid[crack.layer], crack)
        return crack_steps.steps(crack.moment, h, crack_bars, (concrete, bars, cracking.bond(crack.layer)))

    widths: list[BentBars] = []
    for layer, layer_bars in laid.items():
        k_b = cracking.bond(layer)

        def width(m: Array, h: Array, tension_bars: Bars, k_b: float = k_b) -> Array:
            return cracking.crack_width(m, h, tension_bars, concrete, bars, k_b)

        widths += bars_in_tension(combined, steel, {layer: layer_bars}, "quasi-permanent", width)
    stresses = bars_in_tension(combined, steel, laid, "quasi-permanent", stress)
    by_steps = BySteps(partial(_stress_steps, combined, steel, laid), steps)
    yield from check_cracks(combined, (stresses, widths), (strengths(steel)[1], steel.w_max), CLAUSES, by_steps)
