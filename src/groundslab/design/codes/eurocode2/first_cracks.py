"""Least bars that control cracks: they must not yield as the slab first cracks in bending."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.design_moments import design_moments
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Clause, Message
from groundslab.model.design.laid_bars import LaidBars
from groundslab.results.fields import place_of
from groundslab.results.results import Results

_CM2 = 1e4
NAME = "least bars for cracks"


@dataclass(frozen=True, slots=True)
class FirstCracks:
    """The least area (n,) [m2/m] of a layer for thicknesses h (n,) [m], the code, its clause, and what is assumed.

    With the steps of its calculation, of a thickness [m] and an area that is laid [m2/m], if there are any.
    """

    least: Callable[[Array], Array]
    code: str
    clause: str
    assumed: str
    steps: Callable[[float, float], Iterable[Step]] = lambda *_: ()


def check_first_cracks(combined: Results, laid: dict[str, LaidBars], rule: FirstCracks) -> DesignCheck:
    """Return whether bars are as much as a rule asks for, where a face is in tension in any combination.

    How wide the first crack opens is not limited by it: bars may be stressed up to f_yk.
    """
    results = solved_results(combined)
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    least = rule.least(thickness)
    moments = [design_moments(result.plate) for result in results]
    # (n,) by layer; 0 where its face is never in tension
    used = {
        layer: np.where(_in_tension([getattr(moment, layer) for moment in moments]), least / layer_bars.area, 0.0)
        for layer, layer_bars in laid.items()
    }
    layer = max(used, key=lambda name: float(used[name].max()))
    node = int(np.argmax(used[layer]))
    if not used[layer][node]:
        return DesignCheck(NAME, "no failure found", "no face is in tension", clause=f"{rule.code} {rule.clause}")
    x, y = place_of(plate.nodes, node)
    demand, resistance = float(least[node]) * _CM2, float(laid[layer].area[node]) * _CM2
    holds = demand <= resistance
    name = layer.replace("_", " ")
    return DesignCheck(
        NAME,
        "no failure found" if holds else "fails",
        Message(
            "{name}: {demand:.4g (cm2/m)} {sign} {resistance:.4g cm2/m} at {place:.3f m}, {assumed} ({clause})",
            name=name,
            demand=demand,
            sign="<=" if holds else ">",
            resistance=resistance,
            place=(x, y),
            assumed=rule.assumed,
            clause=Clause(rule.clause),
        ),
        of=name,
        demand=demand,
        resistance=resistance,
        unit="cm2/m",
        clause=f"{rule.code} {rule.clause}",
        place=(x, y),
        steps=tuple(rule.steps(float(thickness[node]), resistance / _CM2)),
    )


def _in_tension(moments: list[Array]) -> Array:
    """Return where any of a layer's design moments (n,) is not zero (n,)."""
    return np.asarray(np.any(np.array(moments) != 0, axis=0))
