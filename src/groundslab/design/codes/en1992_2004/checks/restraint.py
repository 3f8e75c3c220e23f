"""Bars against restrained shortening by EN 1992-1-1 7.3.2 and 7.3.4: the slab cracks all through, k_c = 1.

The bars at each face bear half of the force at which it cracks. They must not yield, nor may cracks open wider than the
case allows. k is the recommended one, 1 up to 300 mm and 0.65 from 800 mm on, in every annex.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.checks import crack_steps
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import BARS_YIELD, NO_BARS, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.design.laid_bars import LaidBars, axis_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import place_of
from groundslab.results.results import Results

BARS, WIDTH = "bars against restraint", "crack width by restraint"
_CLAUSE = "EN 1992-1-1 7.3.2(2)"
_CM2, _MM = 1e4, 1e3


def check_restraint(
    combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], w_max: float | None
) -> Iterator[DesignCheck]:
    """Yield whether bars yield as the slab cracks all through, and how wide it opens, w_max [m] being allowed."""
    results = solved_results(combined)[0]
    thickness, nodes = results.elements.at_nodes(results.plate)[0], results.plate.nodes
    concrete, bars = materials(steel)
    f_ct = tensile_strength(steel)
    force = cracking.tension_force(thickness, f_ct)
    stresses = {layer: force / layer_bars.area for layer, layer_bars in laid.items()}
    layer, node = _largest(stresses)
    yields = stresses[layer][node] > bars.f_yk
    here, h = _bars(steel, layer, laid[layer], node), float(thickness[node])
    yield _areas(layer, place_of(nodes, node), tuple(crack_steps.least_in_tension(h, here, bars, f_ct)))
    if w_max is None:
        words = "the width of cracks by restraint is not checked, as neither w_max nor exposure is given"
        yield DesignCheck(WIDTH, "not checked", words, clause="EN 1992-1-1 7.3.4")
        return
    if yields:
        words, clause = "the bars yield, so that no crack width is valid", "EN 1992-1-1 7.3.4"
        yield not_judged(WIDTH, BARS_YIELD, words, resistance=w_max * _MM, unit="mm", clause=clause)
        return
    widths = {
        layer: cracking.tension_crack_width(thickness, _bars(steel, layer, layer_bars), concrete, bars, f_ct)
        for layer, layer_bars in laid.items()
    }
    layer, node = _largest(widths)
    here, h = _bars(steel, layer, laid[layer], node), float(thickness[node])
    steps = tuple(crack_steps.in_tension(h, here, concrete, bars, f_ct))
    yield _width(layer, place_of(nodes, node), float(widths[layer][node]), w_max, steps)


def tensile_strength(steel: Reinforcement) -> float:
    """Return f_ct,eff [Pa] of a case with restraint."""
    assert steel.restraint is not None
    return steel.restraint.f_ct_eff or materials(steel)[0].f_ct_least


def without_bars(steel: Reinforcement, thickness: Array) -> DesignCheck:
    """Return what each layer needs where no bars are laid, of thicknesses (n,) [m]."""
    least = float(cracking.tension_force(thickness, tensile_strength(steel)).max()) / materials(steel)[1].f_yk * _CM2
    words = Message(
        "no bars are laid; each layer needs {least:.4g cm2/m} where the slab is thickest, more for "
        "narrow cracks (7.3.2(2))",
        least=least,
    )
    return not_judged(BARS, NO_BARS, words, clause=_CLAUSE)


def _largest(values: dict[str, Array]) -> tuple[str, int]:
    """Return the layer and the node with the largest of values (n,)."""
    layer = max(values, key=lambda name: float(values[name].max()))
    return layer, int(np.argmax(values[layer]))


def _bars(steel: Reinforcement, layer: str, laid: LaidBars, node: int | None = None) -> Bars:
    """Return the bars of a layer at all nodes (n,), or at one."""
    nodes = slice(None) if node is None else node
    diameter, spacing, area = (values[nodes] for values in (laid.diameter, laid.spacing, laid.area))
    return Bars(diameter, spacing, axis_of(steel, layer) - diameter / 2, np.asarray(area))


def _areas(layer: str, place: tuple[float, float], steps: tuple[Step, ...]) -> DesignCheck:
    """Return whether the bars of the layer that is used most are enough."""
    values = {step.symbol: step.value for step in steps}
    demand, resistance, name = values["A_min"], values["A_s"], layer.replace("_", " ")
    holds = demand <= resistance
    return DesignCheck(
        BARS,
        "no failure found" if holds else "fails",
        Message(
            "{name}: {demand:.4g (cm2/m)} {sign} {resistance:.4g cm2/m} at {place:.3f m}, k_c = 1, sigma_s = "
            "f_yk and f_ct,eff {f_ct:.3g MPa} (7.3.2(2))",
            name=name,
            demand=demand,
            sign="<=" if holds else ">",
            resistance=resistance,
            place=place,
            f_ct=values["f_ct"],
        ),
        of=name,
        demand=demand,
        resistance=resistance,
        unit="cm2/m",
        clause=_CLAUSE,
        place=place,
        steps=steps,
    )


def _width(layer: str, place: tuple[float, float], width: float, w_max: float, steps: tuple[Step, ...]) -> DesignCheck:
    """Return whether a crack [m] at the layer where it is widest is narrow enough."""
    holds, name = width <= w_max, layer.replace("_", " ")
    return DesignCheck(
        WIDTH,
        "no failure found" if holds else "fails",
        Message(
            "{name}: w_k {width:.3g (mm)} {sign} {w_max:.3g mm} at {place:.3f m} as the slab cracks all "
            "through (7.3.4)",
            name=name,
            width=width * _MM,
            sign="<=" if holds else ">",
            w_max=w_max * _MM,
            place=place,
        ),
        of=name,
        demand=width * _MM,
        resistance=w_max * _MM,
        unit="mm",
        clause="EN 1992-1-1 7.3.4",
        place=place,
        steps=steps,
    )
