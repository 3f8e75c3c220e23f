"""Bars that are laid: against what bending needs, how far apart, their cover, their stress, how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from groundslab.design import required_bars
from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results, why_none
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.annex import annex_of
from groundslab.design.en1992.case_materials import materials, strengths
from groundslab.model.design.laid_bars import LaidBars, axis_of, bars_of, laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS, extreme
from groundslab.results.results import CombinationResult, Results

CM2, MM = 1e4, 1e3
#: Bars are no farther apart than so many thicknesses, but so much [m] in any case, and so much [m] at most: ACI 318.
ACI_SPACING = (2.0, 0.0, 0.45)
#: Covers [m] of ACI 318-19 Table 20.5.1.3.1, the lesser of inches and of 318M: cast against the ground; otherwise in
#: contact with it, of bars from No. 6 (19 mm) on and of thinner ones; of slabs not exposed.
ACI_AGAINST_GROUND, _ACI_GROUND, _ACI_THIN, _ACI_INSIDE = 0.075, 0.050, 0.038, 0.019
#: Diameter [m] from which bars are thick in that table.
ACI_THICK = 0.019
#: Covers that differ by less [m] are the same.
ROUNDING = 1e-9
#: Clauses of areas and of distances, by code; that of EN 1992-1-1 is for main reinforcement.
CLAUSES = {
    "EN 1992-1-1": ("EN 1992-1-1", "6.1, 9.2.1.1(1)", "9.3.1.1(3)"),
    "ACI 318": ("ACI 318-19", "22.3, 8.6.1.1", "8.7.2.2"),
}


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of each layer of bars, if any are laid."""
    steel, results = combined.model.reinforcement, solved_results(combined)
    if steel is None or not steel.laid or not results:
        return
    laid = {layer: laid_bars(steel, layer, results[0].plate.nodes) for layer in LAYERS}
    needs = required_bars.governing_needs(combined, steel, {layer: bars.area for layer, bars in laid.items()})
    for layer in LAYERS:
        yield from _area(layer, [need for need in needs if need.layer == layer], CLAUSES[steel.code])
    yield _spacing(results[0], steel, laid)
    yield _cover_by_aci318(steel) if steel.code == "ACI 318" else _cover(steel)
    if steel.code == "EN 1992-1-1":
        yield from _stresses(combined, steel, laid)
    w_max = _widest(steel)
    if w_max is not None:
        yield from _cracks(combined, steel, laid, w_max)


def _widest(steel: Reinforcement) -> float | None:
    """Return the largest crack width that is allowed [m]: the case's, else that of its exposure class, if any."""
    if steel.w_max is not None or steel.exposure is None:
        return steel.w_max
    return annex_of(steel.annex).w_max[steel.exposure]


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is c_min + Delta c_dev of the exposure class, or of any class, or more (4.4.1)."""
    annex, exposure = annex_of(steel.annex), steel.exposure
    clause = "EN 1992-1-1 4.4.1"
    if exposure is not None and exposure not in annex.c_min_dur:
        return DesignCheck("cover", "attention", "not checked: this annex leaves it to another standard", clause=clause)
    durable = 0.0 if exposure is None else annex.c_min_dur[exposure]
    # bond asks for the bar's diameter, and 10 mm are the least (4.4.1.2(2), (3))
    least = {layer: [max(durable, bars.diameter, 0.010) + annex.delta_c_dev for bars in bars_of(steel, layer)]
             for layer in LAYERS}  # fmt: skip
    where = (
        "in any exposure (bond, 4.4.1.2(3)); that of durability is not checked without exposure" if exposure is None
        else f"in {exposure}, structural class S4, not cast against the ground (4.4.1)"
    )  # fmt: skip
    return _least_cover(steel, least, where, clause)


def _cover_by_aci318(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is that of Table 20.5.1.3.1: at the bottom in contact with ground, at the top inside."""
    least = {
        layer: [(_ACI_THIN if bars.diameter < ACI_THICK else _ACI_GROUND) if layer.startswith("bottom") else _ACI_INSIDE
                for bars in bars_of(steel, layer)]
        for layer in LAYERS
    }  # fmt: skip
    where = "formed or on blinding, the top not exposed (Table 20.5.1.3.1)"
    check = _least_cover(steel, least, where, "ACI 318-19 20.5.1.3.1")
    bottom = min(cover for layer, cover, _ in _covers(steel) if layer.startswith("bottom"))
    if check.status == "fails" or bottom >= ACI_AGAINST_GROUND - ROUNDING:
        return check
    words = f"bottom: {bottom * MM:.4g} mm; cast against the ground it needs {ACI_AGAINST_GROUND * MM:.4g} mm"
    return replace(
        check, status="attention", words=f"{words} (Table 20.5.1.3.1)", of="bottom", demand=bottom * MM,
        resistance=ACI_AGAINST_GROUND * MM,
    )  # fmt: skip


def _covers(steel: Reinforcement) -> Iterator[tuple[str, float, int]]:
    """Yield the cover [m] of each set of bars, with its layer and its position among those of the layer."""
    for layer in LAYERS:
        for position, bars in enumerate(bars_of(steel, layer)):
            yield layer, axis_of(steel, layer) - bars.diameter / 2, position


def _least_cover(steel: Reinforcement, least: dict[str, list[float]], where: str, clause: str) -> DesignCheck:
    """Return the check of the bars whose cover is nearest to the least one [m], or below it by most."""
    found = [(cover, least[layer][position], layer.replace("_", " ")) for layer, cover, position in _covers(steel)]
    cover, most, layer = min(found, key=lambda one: one[0] - one[1])
    holds = cover >= most - ROUNDING
    return DesignCheck(
        "cover",
        "no failure found" if holds else "fails",
        f"{layer}: {cover * MM:.4g} {'>=' if holds else '<'} {most * MM:.4g} mm {where}",
        of=layer,
        demand=cover * MM,
        resistance=most * MM,
        unit="mm",
        least=True,
        clause=clause,
    )


def _area(layer: str, needs: list[required_bars.Need], clauses: tuple[str, str, str]) -> Iterator[DesignCheck]:
    """Yield whether the bars of a layer are as much as bending and the minimum need, where it is used most."""
    if not needs:
        return
    worst = max(needs, key=lambda need: need.area / (need.laid or np.inf))
    name, (code, clause, _), laid = layer.replace("_", " "), clauses, worst.laid
    assert laid is not None
    enough = worst.area <= laid
    where = f" at ({worst.place[0]:.3f}, {worst.place[1]:.3f}) m" if worst.place is not None else ""
    by = f' in "{worst.combination}", by {worst.governed_by}' if worst.combination is not None else ""
    yield DesignCheck(
        f"bars at the {name}",
        "no failure found" if enough else "fails",
        f"{worst.area * CM2:.4g} {'<=' if enough else '>'} {laid * CM2:.4g} cm2/m{where}{by} ({clause})",
        of=name,
        demand=worst.area * CM2 if np.isfinite(worst.area) else None,
        resistance=laid * CM2,
        unit="cm2/m",
        clause=f"{code} {clause}",
        combination=worst.combination or "",
        place=worst.place,
    )


def _spacing(results: CombinationResult, steel: Reinforcement, laid: dict[str, LaidBars]) -> DesignCheck:
    """Return whether bars are close enough for a slab."""
    code, _, clause = CLAUSES[steel.code]
    times, least, farthest = annex_of(steel.annex).spacing if steel.code == "EN 1992-1-1" else ACI_SPACING
    thickness = results.elements.at_nodes(results.plate)[0]
    allowed = np.minimum(np.maximum(times * thickness, least), farthest) * MM
    layer = max(laid, key=lambda each: float((laid[each].spacing * MM / allowed).max()))
    node = int(np.argmax(laid[layer].spacing * MM / allowed))
    spacing, most = float(laid[layer].spacing[node]) * MM, float(allowed[node])
    holds = spacing <= most
    return DesignCheck(
        "distance of bars",
        "no failure found" if holds else "fails",
        f"{layer.replace('_', ' ')}: {spacing:.4g} {'<=' if holds else '>'} {most:.4g} mm ({clause})",
        of=layer.replace("_", " "),
        demand=spacing,
        resistance=most,
        unit="mm",
        clause=f"{code} {clause}",
    )


@dataclass(frozen=True, slots=True)
class _Bent:
    """The bars of a layer where a field is largest: its value, the place [m] and the combination."""

    layer: str
    value: float
    place: tuple[float, float]
    combination: str


def _bars_in_tension(
    combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], state: str, *, widths: bool
) -> list[_Bent]:
    """Return of each layer the largest stress [Pa] of its bars, or crack width [m], in the combinations of a state."""
    results = [each for each in solved_results(combined) if each.limit_state == state]
    if not results:
        return []
    of_case = materials(steel)
    thickness, found = results[0].elements.at_nodes(results[0].plate)[0], []
    field = cracking.crack_width if widths else cracking.bar_stress
    for layer, own in laid.items():
        cover = axis_of(steel, layer) - own.diameter / 2
        bars = cracking.Bars(own.diameter, own.spacing, cover, own.area)
        largest = []
        for each in results:
            m = np.abs(getattr(design_moments(each.plate), layer))
            largest.append((*extreme(each.plate.nodes, field(m, thickness, bars, *of_case), 1), each.combination))
        found.append(_Bent(layer, *max(largest)))
    return found


def _stresses(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the largest stress of bars in characteristic combinations, which may be 0.8 f_yk (7.2(5))."""
    found = _bars_in_tension(combined, steel, laid, "characteristic", widths=False)
    if not found:
        return
    worst, f_yk = max(found, key=lambda each: each.value), strengths(steel)[1]
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
    )


def _yields(bent: _Bent, f_yk: float, name: str) -> DesignCheck:
    """Return the check of bars that yield in a combination of serviceability."""
    layer = bent.layer.replace("_", " ")
    return DesignCheck(
        name,
        "fails",
        f"{layer}: the bars yield, sigma_s {bent.value / 1e6:.4g} > f_yk {f_yk / 1e6:.4g} MPa of an elastic section at "
        f'{_where(bent)} in "{bent.combination}"; the section fails, and no crack width holds (7.2(4))',
        of=layer,
        demand=bent.value / 1e6,
        resistance=f_yk / 1e6,
        unit="MPa",
        clause="EN 1992-1-1 7.2(4)",
        combination=bent.combination,
        place=bent.place,
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
        yield _yields(stress, f_yk, name) if stress.value > f_yk else _crack(crack, w_max, name)


def _crack(crack: _Bent, w_max: float, name: str) -> DesignCheck:
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
    )
