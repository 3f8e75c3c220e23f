"""Distance of bars by EN 1992-1-1 9.3.1.1(3) where a slab is bent most, and under columns: nearer than elsewhere."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.annex import annex_of
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.rules.bar_checks import spacing_steps
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import ultimate_results
from groundslab.messages import Message, Name
from groundslab.model.design.laid_bars import LaidBars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import place_of
from groundslab.results.results import CombinationResult, Results

_MM = 1e3


def spacing_where_bent_most(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> DesignCheck | None:
    """Return the check of bars at the largest moment of each layer, and of those at the bottom under columns.

    None without ultimate combinations, and where nothing bends the slab. Both directions count as main ones. How far
    such an area reaches is up to the engineer, so that wider bars need attention.
    """
    results = ultimate_results(combined)
    times, least, farthest = limits = annex_of(steel.annex).spacing_bent_most
    places = [*_places(combined, results)]
    if not places:
        return None
    thickness = results[0].elements.at_nodes(results[0].plate)[0]
    allowed = np.minimum(np.maximum(times * thickness, least), farthest)
    layer, node, where = max(places, key=lambda place: float(laid[place[0]].spacing[place[1]] / allowed[place[1]]))
    spacing, most = float(laid[layer].spacing[node]) * _MM, float(allowed[node]) * _MM
    holds, name = spacing <= most, layer.replace("_", " ")
    x, y = place_of(results[0].plate.nodes, node)
    return DesignCheck(
        "distance of bars where bent most",
        "no failure found" if holds else "attention",
        Message(
            "{name}: {spacing:.4g (mm)} {sign} {most:.4g mm} at {place:.3f m}, {where} (9.3.1.1(3))",
            name=name,
            spacing=spacing,
            sign="<=" if holds else ">",
            most=most,
            place=(x, y),
            where=where,
        ),
        of=name,
        demand=spacing,
        resistance=most,
        unit="mm",
        clause="EN 1992-1-1 9.3.1.1(3)",
        place=(x, y),
        steps=tuple(spacing_steps(float(thickness[node]), spacing, most, limits, "9.3.1.1(3)")),
    )


def _places(combined: Results, results: list[CombinationResult]) -> Iterator[tuple[str, int, str]]:
    """Yield layers and nodes where bars are to be nearer to each other, and why."""
    if not results:
        return
    moments = [design_moments(result.plate) for result in results]
    for layer in ("bottom_x", "bottom_y", "top_x", "top_y"):
        sizes: Array = np.max([np.abs(getattr(of_combination, layer)) for of_combination in moments], axis=0)
        if sizes.max() > 0:
            yield layer, int(np.argmax(sizes)), "at its largest moment"
    nodes = results[0].plate.nodes
    for column in combined.model.columns:
        node = int(np.argmin(((nodes - (column.x, column.y)) ** 2).sum(axis=1)))
        for layer in ("bottom_x", "bottom_y"):
            yield layer, node, Message("under {name}", name=Name(column.name))
