"""Bars that are laid by EN 1992-1-1: how far apart, their cover, their stress, how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.design.basis.bar_checks import check_cover, check_spacing
from groundslab.design.basis.calculation import Step
from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results, why_none
from groundslab.design.basis.demand_errors import greatest_moments, scaled
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.annex import annex_of
from groundslab.design.en1992.case_materials import least_cover, materials, strengths, widest_crack
from groundslab.design.en1992.checks import crack_steps
from groundslab.design.en1992.checks.first_cracks import check_first_cracks
from groundslab.model.design.laid_bars import LaidBars, axis_of, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS, extreme_node, place_of
from groundslab.results.results import Results

MM = 1e3


def checks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the checks of bars that are laid, by layer."""
    spacing = annex_of(steel.annex).spacing
    # the clause is that of main reinforcement
    yield check_spacing(solved_results(combined)[0], laid, spacing, "EN 1992-1-1", "9.3.1.1(3)")
    yield _cover(steel)
    yield from _stresses(combined, steel, laid)
    w_max = widest_crack(steel)
    if w_max is not None:
        yield check_first_cracks(combined, steel, laid)
        yield from _cracks(combined, steel, laid, w_max)


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is c_min + Delta c_dev of the exposure class, or of any class, or more (4.4.1)."""
    annex, exposure = annex_of(steel.annex), steel.exposure
    clause = "EN 1992-1-1 4.4.1"
    if exposure is not None and exposure not in annex.c_min_dur:
        return DesignCheck("cover", "attention", "not checked: this annex leaves it to another standard", clause=clause)
    least = {layer: [least_cover(steel, bars.diameter) or 0.0 for bars in bars_of(steel, layer)] for layer in LAYERS}
    where = (
        "in any exposure (bond, 4.4.1.2(3)); durability is not checked without exposure" if exposure is None
        else f"in {exposure}, structural class S4, not cast against the ground (4.4.1)"
    )  # fmt: skip
    return check_cover(steel, least, where, clause)


@dataclass(frozen=True, slots=True)
class _Bent:
    """The bars of a layer where a field is largest: its value, the place [m], the combination, the value's error.

    With the moment there [N m/m] and the node.
    """

    layer: str
    value: float
    place: tuple[float, float]
    combination: str
    error: float | None
    moment: float
    node: int


def _bars_in_tension(
    combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], state: str, *, widths: bool
) -> list[_Bent]:
    """Return of each layer the largest stress [Pa] of its bars, or crack width [m], in the combinations of a state."""
    results = [result for result in solved_results(combined) if result.limit_state == state]
    if not results:
        return []
    of_case = materials(steel)
    thickness = results[0].elements.at_nodes(results[0].plate)[0]
    bent = []
    field = cracking.crack_width if widths else cracking.bar_stress
    for layer, layer_bars in laid.items():
        cover = axis_of(steel, layer) - layer_bars.diameter / 2
        bars = cracking.Bars(layer_bars.diameter, layer_bars.spacing, cover, layer_bars.area)
        largest = []
        for result in results:
            m = np.abs(getattr(design_moments(result.plate), layer))
            values = field(m, thickness, bars, *of_case)
            node = extreme_node(result.plate.nodes, values, 1)
            place = place_of(result.plate.nodes, node)
            largest.append((float(values[node]), place, result.combination, float(m[node]), node))
        value, place, combination, moment, node = max(largest)
        greatest, error = greatest_moments(combined.results[combination]), None
        if greatest is not None:
            error = float(field(np.abs(getattr(greatest, layer)), thickness, bars, *of_case).max()) - value
        bent.append(_Bent(layer, value, place, combination, error, moment, node))
    return bent


def _stresses(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the largest stress of bars in characteristic combinations, which may be 0.8 f_yk (7.2(5))."""
    bent = _bars_in_tension(combined, steel, laid, "characteristic", widths=False)
    if not bent:
        return
    worst = max(bent, key=lambda layer: layer.value)
    f_yk = strengths(steel)[1]
    most = cracking.MOST_STRESS * f_yk
    if worst.value > f_yk:
        yield _yields(worst, f_yk, "stress of the bars")
        return
    holds = worst.value <= most
    yield DesignCheck(
        "stress of the bars",
        "no failure found" if holds else "attention",
        f"{worst.layer.replace('_', ' ')}: sigma_s {worst.value / 1e6:.4g} {'<=' if holds else '>'} "
        f'{most / 1e6:.4g} MPa = 0.8 f_yk at {_where(worst)} in "{worst.combination}" (7.2(5))',
        of=worst.layer.replace("_", " "),
        demand=worst.value / 1e6,
        resistance=most / 1e6,
        unit="MPa",
        clause="EN 1992-1-1 7.2(5)",
        combination=worst.combination,
        place=worst.place,
        error=scaled(worst.error, 1e-6),
    )


def _yields(bent: _Bent, f_yk: float, name: str) -> DesignCheck:
    """Return the check of bars that yield in a combination of serviceability."""
    layer = bent.layer.replace("_", " ")
    return DesignCheck(
        name,
        "fails",
        f"{layer}: the bars yield, sigma_s {bent.value / 1e6:.4g} > f_yk {f_yk / 1e6:.4g} MPa of an elastic section at "
        f'{_where(bent)} in "{bent.combination}"; the section fails, and no crack width is valid (7.2(4))',
        of=layer,
        demand=bent.value / 1e6,
        resistance=f_yk / 1e6,
        unit="MPa",
        clause="EN 1992-1-1 7.2(4)",
        combination=bent.combination,
        place=bent.place,
        error=scaled(bent.error, 1e-6),
    )


def _where(bent: _Bent) -> str:
    """Return a place in words."""
    return f"({bent.place[0]:.3f}, {bent.place[1]:.3f}) m"


def _cracks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], w_max: float) -> Iterator[DesignCheck]:
    """Yield the widest crack at each layer in the quasi-permanent combinations (7.3.4, Table 7.1N).

    Where the bars of a layer yield its section fails: the formulas hold for elastic bars.
    """
    state = "quasi-permanent"
    stresses = _bars_in_tension(combined, steel, laid, state, widths=False)
    if not stresses:
        words = f"not checked: {why_none(combined, (state,), 'quasi-permanent combination')}"
        yield DesignCheck("crack width", "attention", words, resistance=w_max * MM, unit="mm")
        return
    f_yk = strengths(steel)[1]
    for stress, crack in zip(stresses, _bars_in_tension(combined, steel, laid, state, widths=True), strict=True):
        name = f"crack width at the {crack.layer.replace('_', ' ')}"
        if stress.value > f_yk:
            yield _yields(stress, f_yk, name)
        else:
            yield _crack(crack, w_max, name, _steps(combined, steel, laid[crack.layer], crack))


def _steps(combined: Results, steel: Reinforcement, laid: LaidBars, crack: _Bent) -> Iterator[Step]:
    """Yield the calculation of the width of a crack."""
    result = combined.results[crack.combination]
    h = float(result.elements.at_nodes(result.plate)[0][crack.node])
    diameter, spacing, area = (float(np.broadcast_to(each, len(result.plate.nodes))[crack.node])
                               for each in (laid.diameter, laid.spacing, laid.area))  # fmt: skip
    bars = cracking.Bars(diameter, spacing, axis_of(steel, crack.layer) - diameter / 2, np.array(area))
    return crack_steps.steps(crack.moment, h, bars, *materials(steel))


def _crack(crack: _Bent, w_max: float, name: str, steps: Iterator[Step]) -> DesignCheck:
    """Return the check of the widest crack at a layer."""
    value, most = crack.value * MM, w_max * MM
    holds = value <= most
    return DesignCheck(
        name,
        "no failure found" if holds else "fails",
        f'w_k {value:.3g} {"<=" if holds else ">"} {most:.3g} mm at {_where(crack)} in "{crack.combination}" (7.3.4)',
        of=crack.layer.replace("_", " "),
        demand=value,
        resistance=most,
        unit="mm",
        clause="EN 1992-1-1 7.3.4",
        combination=crack.combination,
        place=crack.place,
        error=scaled(crack.error, MM),
        steps=tuple(steps),
    )
