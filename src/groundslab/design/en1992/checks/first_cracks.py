"""Least bars that control cracks by EN 1992-1-1 7.3.2: they must not yield as the slab first cracks in bending."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.en1992 import cracking
from groundslab.design.en1992.case_materials import materials
from groundslab.model.design.laid_bars import LaidBars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import place_of
from groundslab.results.results import Results

_CM2 = 1e4
NAME = "least bars for cracks"


def check_first_cracks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> DesignCheck:
    """Return whether bars are as much as 7.1 asks for, where a face is in tension in any combination.

    sigma_s = f_yk: how wide the first crack opens is not limited by it.
    """
    results = solved_results(combined)
    plate = results[0].plate
    concrete, bars = materials(steel)
    least = cracking.minimum_area(results[0].elements.at_nodes(plate)[0], concrete, bars.f_yk)
    moments = [design_moments(result.plate) for result in results]
    # (n,) by layer; 0 where its face is never in tension
    used = {
        layer: np.where(_in_tension([getattr(moment, layer) for moment in moments]), least / layer_bars.area, 0.0)
        for layer, layer_bars in laid.items()
    }
    layer = max(used, key=lambda name: float(used[name].max()))
    node = int(np.argmax(used[layer]))
    if not used[layer][node]:
        return DesignCheck(NAME, "no failure found", "no face is in tension", clause="EN 1992-1-1 7.3.2(2)")
    x, y = place_of(plate.nodes, node)
    demand, resistance = float(least[node]) * _CM2, float(laid[layer].area[node]) * _CM2
    holds = demand <= resistance
    name = layer.replace("_", " ")
    return DesignCheck(
        NAME,
        "no failure found" if holds else "fails",
        f"{name}: {demand:.4g} {'<=' if holds else '>'} {resistance:.4g} cm2/m at ({x:.3f}, {y:.3f}) m, k_c = 0.4 and "
        "sigma_s = f_yk (7.3.2(2))",
        of=name,
        demand=demand,
        resistance=resistance,
        unit="cm2/m",
        clause="EN 1992-1-1 7.3.2(2)",
        place=(x, y),
    )


def _in_tension(moments: list[Array]) -> Array:
    """Return where any of a layer's design moments (n,) is not zero (n,)."""
    return np.asarray(np.any(np.array(moments) != 0, axis=0))
