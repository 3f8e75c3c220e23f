"""Checks of laid bars that codes share but for their limits: how far apart they lie, and their cover."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import DesignCheck
from groundslab.messages import Clause, Message
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
        Message(
            "{layer}: {spacing:.4g (mm)} {sign} {most:.4g mm} ({clause})",
            layer=layer.replace("_", " "),
            spacing=spacing,
            sign="<=" if holds else ">",
            most=most,
            clause=Clause(clause),
        ),
        of=layer.replace("_", " "),
        demand=spacing,
        resistance=most,
        unit="mm",
        clause=f"{code} {clause}",
        steps=tuple(spacing_steps(float(thickness[node]), spacing, most, limits, clause)),
    )


def spacing_steps(
    h: float, spacing: float, most: float, limits: tuple[float, float, float], clause: str
) -> Iterator[Step]:
    """Yield the largest distance of bars [mm] of a slab h [m] thick, by limits as `check_spacing` has them."""
    times, least, farthest = limits
    yield Step("thickness", "h", h * _MM, "mm")
    of_slab = f"max({times:g} * h, {least * _MM:g})" if least else f"{times:g} * h"
    yield Step("largest distance", "s_max", most, "mm", f"min({of_slab}, {farthest * _MM:g})", clause)
    yield Step("distance of the bars", "s", spacing, "mm")
    yield Step("share used", "eta", spacing / most, "", "s / s_max", clause)


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
    return DesignCheck(
        "clear distance of bars",
        "no failure found" if holds else "fails",
        Message(
            "{name}: {clear:.4g (mm)} {sign} {most:.4g mm} ({clause}){without}",
            name=name,
            clear=clear,
            sign=">=" if holds else "<",
            most=most,
            clause=Clause(clause),
            without="" if steel.aggregate is not None else "; the size of the aggregate is not given",
        ),
        of=name,
        demand=clear,
        resistance=most,
        unit="mm",
        least=True,
        clause=f"{code} {clause}",
        steps=tuple(_clear_steps(laid[layer], node, steel.aggregate, limits, clause)),
    )


def _clear_steps(
    laid: LaidBars, node: int, aggregate: float | None, limits: tuple[float, float, float], clause: str
) -> Iterator[Step]:
    """Yield the clear distance of bars at a node and the least one, by limits as `check_clear` has them."""
    least, times, more = limits
    phi, clear = float(laid.thickest[node]) * _MM, float(laid.clear[node]) * _MM
    yield Step("diameter of the thickest bars", "phi", phi, "mm")
    yield Step("distance of the bars' axes, of several sets as if it were even", "s", clear + phi, "mm")
    yield Step("clear distance", "s_c", max(clear, 0.0), "mm", "max(s - phi, 0)")
    needed, formula = max(phi, least * _MM), f"max(phi, {least * _MM:g})"
    if aggregate is not None:
        yield Step("largest size of the aggregate", "d_g", aggregate * _MM, "mm")
        needed = max(needed, (times * aggregate + more) * _MM)
        of_aggregate = f"{times:g} * d_g" if times == round(times) else "4 / 3 * d_g"
        formula = f"max(phi, {least * _MM:g}, {of_aggregate}{f' + {more * _MM:g}' if more else ''})"
    yield Step("least clear distance", "s_min", needed, "mm", formula, clause)
    if clear > 0:
        yield Step("share used", "eta", needed / clear, "", "s_min / s_c", clause)


def covers(steel: Reinforcement) -> Iterator[tuple[str, float, int]]:
    """Yield the cover [m] of each set of bars, with its layer and its position among those of the layer."""
    for layer in LAYERS:
        for position, bars in enumerate(bars_of(steel, layer)):
            yield layer, axis_of(steel, layer) - bars.diameter / 2, position


def check_cover(
    steel: Reinforcement,
    least: dict[str, list[float]],
    where: str,
    clause: str,
    why: Callable[[str, float], Iterator[Step]],
) -> DesignCheck:
    """Return the check of the bars whose cover is nearest to the least one [m], or below it by most.

    Why it is the least one, the steps say of a layer and a diameter [m], up to c_nom [mm].
    """
    margins = [(cover, least[layer][position], layer, position) for layer, cover, position in covers(steel)]
    cover, most, layer, position = min(margins, key=lambda margin: margin[0] - margin[1])
    holds, name = cover >= most - ROUNDING, layer.replace("_", " ")
    diameter = bars_of(steel, layer)[position].diameter
    return DesignCheck(
        "cover",
        "no failure found" if holds else "fails",
        Message(
            "{name}: {cover:.4g (mm)} {sign} {most:.4g mm} {where}",
            name=name,
            cover=cover * _MM,
            sign=">=" if holds else "<",
            most=most * _MM,
            where=where,
        ),
        of=name,
        demand=cover * _MM,
        resistance=most * _MM,
        unit="mm",
        least=True,
        clause=clause,
        steps=tuple(cover_steps(cover, diameter, most, why(layer, diameter))),
    )


def cover_steps(cover: float, diameter: float, most: float, why: Iterator[Step]) -> Iterator[Step]:
    """Yield the cover of bars and the least one [m], given the steps up to c_nom."""
    yield Step("distance of the bars' axis from the face", "a", (cover + diameter / 2) * _MM, "mm")
    yield Step("diameter of the bars", "phi", diameter * _MM, "mm")
    yield Step("cover", "c", cover * _MM, "mm", "a - phi / 2")
    yield from why
    if cover > 0:
        yield Step("share used", "eta", most / cover, "", "c_nom / c")
