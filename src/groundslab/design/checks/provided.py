"""Bars that are laid: against what bending needs, how far apart they are, their cover, and how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.checks.check import DesignCheck
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.annex import annex_of
from groundslab.design.tables import reinforcement
from groundslab.design.tables.quantities import solved_results
from groundslab.model.design.laid_bars import LaidBars, bars_of, laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS, extreme
from groundslab.results.results import CombinationResult, Results

CM2, MM = 1e4, 1e3
#: Bars are no farther apart than so many thicknesses, but so much [m] in any case, and so much [m] at most: ACI 318.
ACI_SPACING = (2.0, 0.0, 0.45)
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
    needs = reinforcement.governing_needs(combined, steel, {layer: bars.area for layer, bars in laid.items()})
    for layer in LAYERS:
        yield from _area(layer, [need for need in needs if need.layer == layer], CLAUSES[steel.code])
    yield _spacing(results[0], steel, laid)
    if steel.exposure is not None:
        yield _cover(steel)
    w_max = _widest(steel)
    if w_max is not None:
        yield from _cracks(combined, steel, laid, w_max)


def _widest(steel: Reinforcement) -> float | None:
    """Return the largest crack width that is allowed [m]: the case's, else that of its exposure class, if any."""
    if steel.w_max is not None or steel.exposure is None:
        return steel.w_max
    return annex_of(steel.annex).w_max[steel.exposure]


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is c_min + Delta c_dev of the exposure class, or more (4.4.1)."""
    assert steel.exposure is not None
    annex = annex_of(steel.annex)
    clause = "EN 1992-1-1 4.4.1"
    if steel.exposure not in annex.c_min_dur:
        return DesignCheck("cover", "attention", "not checked: this annex leaves it to another standard", clause=clause)
    found = []
    for each in LAYERS:
        for bars in bars_of(steel, each):
            # bond asks for the bar's diameter, and 10 mm are the least (4.4.1.2(2), (3))
            least = max(annex.c_min_dur[steel.exposure], bars.diameter, 0.010) + annex.delta_c_dev
            found.append((reinforcement.axis_of(steel, each) - bars.diameter / 2, least, each))
    cover, least, layer = min(found, key=lambda one: one[0] - one[1])
    cover, least = cover * MM, least * MM
    holds = cover >= least - 1e-6
    return DesignCheck(
        "cover",
        "no failure found" if holds else "fails",
        f"{layer.replace('_', ' ')}: {cover:.4g} {'>=' if holds else '<'} {least:.4g} mm in {steel.exposure}, "
        "structural class S4, not cast against the ground (4.4.1)",
        of=layer.replace("_", " "),
        demand=cover,
        resistance=least,
        unit="mm",
        least=True,
        clause=clause,
    )


def _area(layer: str, needs: list[reinforcement.Need], clauses: tuple[str, str, str]) -> Iterator[DesignCheck]:
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


def _cracks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], w_max: float) -> Iterator[DesignCheck]:
    """Yield the widest crack at each layer in the quasi-permanent combinations (7.3.4, Table 7.1N)."""
    results = [each for each in solved_results(combined) if each.limit_state == "quasi-permanent"]
    if not results:
        words = "not checked: no quasi-permanent combination has a certified result"
        yield DesignCheck("crack width", "attention", words, resistance=w_max * MM, unit="mm")
        return
    concrete, bars_of = reinforcement.materials(steel)
    thickness = results[0].elements.at_nodes(results[0].plate)[0]
    for layer, own in laid.items():
        cover = reinforcement.axis_of(steel, layer) - own.diameter / 2
        bars, found = cracking.Bars(own.diameter, own.spacing, cover, own.area), []
        for each in results:
            m = np.abs(getattr(reinforcement.design_moments(each.plate), layer))
            widths = cracking.crack_width(m, thickness, bars, concrete, bars_of)
            found.append((*extreme(each.plate.nodes, widths, 1), each.combination))
        width, place, combination = max(found)
        value, most, name = width * MM, w_max * MM, layer.replace("_", " ")
        holds = value <= most
        yield DesignCheck(
            f"crack width at the {name}",
            "no failure found" if holds else "fails",
            f"w_k {value:.3g} {'<=' if holds else '>'} {most:.3g} mm at ({place[0]:.3f}, {place[1]:.3f}) m in "
            f'"{combination}" (7.3.4)',
            of=name,
            demand=value,
            resistance=most,
            unit="mm",
            clause="EN 1992-1-1 7.3.4",
            combination=combination,
            place=place,
        )
