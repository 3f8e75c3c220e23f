"""Checks of laid bars that codes share but for their limits: how far apart they lie, and their cover."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.basis.check import DesignCheck
from groundslab.model.design.laid_bars import LaidBars, axis_of, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import CombinationResult

_MM = 1e3
#: Covers that differ by less [m] are the same.
ROUNDING = 1e-9


def check_spacing(
    results: CombinationResult, laid: dict[str, LaidBars], limits: tuple[float, float, float], code: str, clause: str
) -> DesignCheck:
    """Return whether bars are close enough for a slab.

    The limits are the distance over the thickness, the length [m] that is allowed in any case, and the most [m].
    """
    times, least, farthest = limits
    thickness = results.elements.at_nodes(results.plate)[0]
    allowed = np.minimum(np.maximum(times * thickness, least), farthest) * _MM
    layer = max(laid, key=lambda name: float((laid[name].spacing * _MM / allowed).max()))
    node = int(np.argmax(laid[layer].spacing * _MM / allowed))
    spacing, most = float(laid[layer].spacing[node]) * _MM, float(allowed[node])
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


def check_clear(
    steel: Reinforcement, laid: dict[str, LaidBars], limits: tuple[float, float, float], code: str, clause: str
) -> DesignCheck:
    """Return whether bars are far enough from each other for concrete to pass.

    The limits of the clear distance, besides the bars' diameter, are the least [m], the factor of the largest size of
    the aggregate, and what is added to that [m].
    """
    least, times, more = limits
    aggregate = 0.0 if steel.aggregate is None else times * steel.aggregate + more
    needed = {layer: np.maximum(bars.thickest, max(least, aggregate)) for layer, bars in laid.items()}
    layer = min(laid, key=lambda name: float((laid[name].clear - needed[name]).min()))
    node = int(np.argmin(laid[layer].clear - needed[layer]))
    clear, most = max(float(laid[layer].clear[node]), 0.0) * _MM, float(needed[layer][node]) * _MM
    holds, name = clear >= most - ROUNDING * _MM, layer.replace("_", " ")
    without = "" if steel.aggregate is not None else "; the size of the aggregate is not given"
    return DesignCheck(
        "clear distance of bars",
        "no failure found" if holds else "fails",
        f"{name}: {clear:.4g} {'>=' if holds else '<'} {most:.4g} mm ({clause}){without}",
        of=name,
        demand=clear,
        resistance=most,
        unit="mm",
        least=True,
        clause=f"{code} {clause}",
    )


def covers(steel: Reinforcement) -> Iterator[tuple[str, float, int]]:
    """Yield the cover [m] of each set of bars, with its layer and its position among those of the layer."""
    for layer in LAYERS:
        for position, bars in enumerate(bars_of(steel, layer)):
            yield layer, axis_of(steel, layer) - bars.diameter / 2, position


def check_cover(steel: Reinforcement, least: dict[str, list[float]], where: str, clause: str) -> DesignCheck:
    """Return the check of the bars whose cover is nearest to the least one [m], or below it by most."""
    margins = [(cover, least[layer][position], layer.replace("_", " ")) for layer, cover, position in covers(steel)]
    cover, most, layer = min(margins, key=lambda margin: margin[0] - margin[1])
    holds = cover >= most - ROUNDING
    return DesignCheck(
        "cover",
        "no failure found" if holds else "fails",
        f"{layer}: {cover * _MM:.4g} {'>=' if holds else '<'} {most * _MM:.4g} mm {where}",
        of=layer,
        demand=cover * _MM,
        resistance=most * _MM,
        unit="mm",
        least=True,
        clause=clause,
    )
