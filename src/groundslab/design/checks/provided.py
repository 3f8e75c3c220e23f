"""Bars that are laid: against what bending needs, how far apart they are, their cover, and how wide cracks open."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.checks.check import DesignCheck
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.annex import annex_of
from groundslab.design.tables import reinforcement
from groundslab.design.tables.quantities import solved_results
from groundslab.model.outputs import Reinforcement
from groundslab.results.fields import LAYERS, extreme
from groundslab.results.results import Results

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
    steel = combined.model.reinforcement
    if steel is None or steel.bottom_x is None:
        return
    laid = {layer: _laid(steel, layer) for layer in LAYERS}
    needs = reinforcement.governing_needs(combined, steel)
    for layer, bars in laid.items():
        yield from _area(layer, bars, [need for need in needs if need.layer == layer], CLAUSES[steel.code])
    yield _spacing(combined, laid)
    if steel.exposure is not None:
        yield _cover(steel, laid)
    w_max = _widest(steel)
    if w_max is not None:
        yield from _cracks(combined, steel, laid, w_max)


def _widest(steel: Reinforcement) -> float | None:
    """Return the largest crack width that is allowed [m]: the case's, else that of its exposure class, if any."""
    if steel.w_max is not None or steel.exposure is None:
        return steel.w_max
    return annex_of(steel.annex).w_max[steel.exposure]


def _laid(steel: Reinforcement, layer: str) -> cracking.Bars:
    """Return the bars of a layer with their cover."""
    bars = getattr(steel, layer)
    return cracking.Bars(bars.diameter, bars.spacing, reinforcement.axis_of(steel, layer) - bars.diameter / 2)


def _cover(steel: Reinforcement, laid: dict[str, cracking.Bars]) -> DesignCheck:
    """Return whether the cover is c_min + Delta c_dev of the exposure class, or more (4.4.1)."""
    assert steel.exposure is not None
    annex = annex_of(steel.annex)
    clause = "EN 1992-1-1 4.4.1"
    if steel.exposure not in annex.c_min_dur:
        return DesignCheck("cover", "attention", "not checked: this annex leaves it to another standard", clause=clause)
    # bond asks for the bar's diameter, and 10 mm are the least (4.4.1.2(2), (3))
    found = {layer: max(annex.c_min_dur[steel.exposure], bars.diameter, 0.010) for layer, bars in laid.items()}
    layer = max(laid, key=lambda each: found[each] - laid[each].cover)
    cover, least = laid[layer].cover * MM, (found[layer] + annex.delta_c_dev) * MM
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


def _area(
    layer: str, bars: cracking.Bars, needs: list[reinforcement.Need], clauses: tuple[str, str, str]
) -> Iterator[DesignCheck]:
    """Yield whether the bars of a layer are as much as bending and the minimum need, in its worst section."""
    if not needs:
        return
    worst = max(needs, key=lambda need: need.area)
    name, (code, clause, _) = layer.replace("_", " "), clauses
    enough = worst.area <= bars.area
    where = f" at ({worst.place[0]:.3f}, {worst.place[1]:.3f}) m" if worst.place is not None else ""
    by = f' in "{worst.combination}", by {worst.governed_by}' if worst.combination is not None else ""
    yield DesignCheck(
        f"bars at the {name}",
        "no failure found" if enough else "fails",
        f"{worst.area * CM2:.4g} {'<=' if enough else '>'} {bars.area * CM2:.4g} cm2/m{where}{by} ({clause})",
        of=name,
        demand=worst.area * CM2 if np.isfinite(worst.area) else None,
        resistance=bars.area * CM2,
        unit="cm2/m",
        clause=f"{code} {clause}",
        combination=worst.combination or "",
        place=worst.place,
    )


def _spacing(combined: Results, laid: dict[str, cracking.Bars]) -> DesignCheck:
    """Return whether bars are close enough for the thinnest part of a slab."""
    steel = combined.model.reinforcement
    assert steel is not None
    code, _, clause = CLAUSES[steel.code]
    times, least, farthest = annex_of(steel.annex).spacing if steel.code == "EN 1992-1-1" else ACI_SPACING
    zones = [zone.thickness for zone in combined.model.plate.zones if zone.thickness is not None]
    most = min(max(times * min([combined.model.plate.thickness, *zones]), least), farthest) * MM
    layer, bars = max(laid.items(), key=lambda each: each[1].spacing)
    spacing = bars.spacing * MM
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


def _cracks(
    combined: Results, steel: Reinforcement, laid: dict[str, cracking.Bars], w_max: float
) -> Iterator[DesignCheck]:
    """Yield the widest crack at each layer in the quasi-permanent combinations (7.3.4, Table 7.1N)."""
    results = [each for each in solved_results(combined) if each.limit_state == "quasi-permanent"]
    if not results:
        words = "not checked: no quasi-permanent combination has a certified result"
        yield DesignCheck("crack width", "attention", words, resistance=w_max * MM, unit="mm")
        return
    concrete, bars_of = reinforcement.materials(steel)
    thickness = results[0].elements.at_nodes(results[0].plate)[0]
    for layer, bars in laid.items():
        found = []
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
