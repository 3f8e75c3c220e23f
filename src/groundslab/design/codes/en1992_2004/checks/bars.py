"""Bars that are laid by EN 1992-1-1: how far apart, their cover, their stress, how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.annex import Annex, annex_of
from groundslab.design.codes.en1992_2004.checks import crack_steps
from groundslab.design.codes.en1992_2004.checks.bent_most import spacing_where_bent_most
from groundslab.design.codes.en1992_2004.checks.restraint import check_restraint
from groundslab.design.codes.en1992_2004.detailing import CLEAR
from groundslab.design.codes.en1992_2004.materials_of_case import (
    deviation,
    least_cover,
    materials,
    strengths,
    widest_crack,
)
from groundslab.design.codes.eurocode2.bent_bars import (
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
from groundslab.design.rules.bar_checks import check_clear, check_cover, check_spacing
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import OTHER_STANDARD, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.design.laid_bars import LaidBars, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results

#: The crack widths of Table 7.1N are those of quasi-permanent combinations.
CLAUSES = Clauses("EN 1992-1-1", stress="7.2(5)", yielding="7.2(4)", crack="7.3.4")


def checks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the checks of bars that are laid, by layer."""
    spacing = annex_of(steel.annex).spacing
    # the clause is that of main reinforcement
    yield check_spacing(solved_results(combined)[0], laid, spacing, "EN 1992-1-1", "9.3.1.1(3)")
    near = spacing_where_bent_most(combined, steel, laid)
    if near is not None:
        yield near
    yield check_clear(steel, laid, CLEAR, "EN 1992-1-1", "8.2(2)")
    yield _cover(steel)
    of_case, f_yk = materials(steel), strengths(steel)[1]

    def stress(m: Array, h: Array, bars: Bars) -> Array:
        return cracking.bar_stress(m, h, bars, *of_case)

    def steps_of_stress(bent: BentBars) -> Iterator[Step]:
        h, bars = bars_at(combined, steel, laid[bent.layer], bent)
        return crack_steps.stress(bent.moment, h, bars, *of_case)

    bent = bars_in_tension(combined, steel, laid, "characteristic", stress)
    yield from check_stresses(bent, f_yk, CLAUSES, steps_of_stress)
    w_max = widest_crack(steel)
    if steel.restraint is not None:
        yield from check_restraint(combined, steel, laid, w_max)
    if w_max is None:
        return
    yield _first_cracks(combined, steel, laid)

    def width(m: Array, h: Array, bars: Bars) -> Array:
        return cracking.crack_width(m, h, bars, *of_case)

    def steps(crack: BentBars) -> Iterator[Step]:
        h, bars = bars_at(combined, steel, laid[crack.layer], crack)
        return crack_steps.steps(crack.moment, h, bars, *of_case)

    state = "quasi-permanent"
    # the bars of a layer are stressed elastically, or no width is valid (7.3.4)
    stresses, widths = (bars_in_tension(combined, steel, laid, state, field) for field in (stress, width))
    yield from check_cracks(combined, (stresses, widths), (f_yk, w_max), CLAUSES, BySteps(steps_of_stress, steps))


def _first_cracks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> DesignCheck:
    """Return whether bars are as much as 7.1 asks for, with k_c = 0.4 and sigma_s = f_yk."""
    concrete, bars = materials(steel)
    rule = FirstCracks(
        lambda h: cracking.minimum_area(h, concrete, bars.f_yk),
        "EN 1992-1-1",
        "7.3.2(2)",
        "k_c = 0.4 and sigma_s = f_yk",
        lambda h, area: crack_steps.least_in_bending(h, area, concrete, bars),
    )
    return check_first_cracks(combined, laid, rule)


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is c_min + Delta c_dev of the exposure class, or of any class, or more (4.4.1)."""
    annex, exposure = annex_of(steel.annex), steel.exposure
    clause = "EN 1992-1-1 4.4.1"
    if exposure is not None and exposure not in annex.c_min_dur:
        return not_judged("cover", OTHER_STANDARD, "this annex leaves it to another standard", clause=clause)
    least = {layer: [least_cover(steel, bars.diameter) or 0.0 for bars in bars_of(steel, layer)] for layer in LAYERS}
    where = (
        "in any exposure (bond, 4.4.1.2(3)); durability is not checked without exposure" if exposure is None
        else Message("in {exposure}, structural class S4, not cast against the ground (4.4.1)", exposure=exposure)
    )  # fmt: skip

    def why(_: str, diameter: float) -> Iterator[Step]:
        return cover_steps(diameter, exposure, annex)

    return check_cover(steel, least, where, clause, why)


_MM = 1e3


def cover_steps(diameter: float, exposure: str | None, annex: Annex) -> Iterator[Step]:
    """Yield c_nom [mm] of a bar [m], of an exposure class or, without one, as bond asks for it."""
    phi, durable = diameter * _MM, 0.0
    yield Step("least cover for bond", "c_min,b", phi, "mm", "phi", "4.4.1.2(3)")
    formula = "max(c_min,b, 10)"
    if exposure is not None:
        durable, formula = annex.c_min_dur[exposure] * _MM, "max(c_min,b, c_min,dur, 10)"
        words = Message("least cover for durability, {exposure}, structural class S4", exposure=exposure)
        yield Step(words, "c_min,dur", durable, "mm", clause="4.4.1.2(5)")
    more, of_bond = deviation(annex, exposure) * _MM, deviation(annex, None) * _MM
    clause = "4.4.1.1(2), 4.1"
    if more != of_bond:
        yield Step("allowance for deviations", "Delta_c,dev", more, "mm", clause="4.4.1.3(1)")
        yield Step("allowance for deviations, for bond", "Delta_c,dev,b", of_bond, "mm", clause="4.4.1.3(1)")
        c_nom = max(durable + more, max(phi, 10.0) + of_bond)
        formula = "max(c_min,dur + Delta_c,dev, max(c_min,b, 10) + Delta_c,dev,b)"
        yield Step("nominal cover", "c_nom", c_nom, "mm", formula, clause)
        return
    c_min = max(phi, durable, 10.0)
    yield Step("least cover", "c_min", c_min, "mm", formula, "4.4.1.2(2), 4.2")
    yield Step("allowance for deviations", "Delta_c,dev", more, "mm", clause="4.4.1.3(1)")
    yield Step("nominal cover", "c_nom", c_min + more, "mm", "c_min + Delta_c,dev", clause)
