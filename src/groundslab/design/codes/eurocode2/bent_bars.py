"""Bars in tension of laid layers in serviceability: their largest stress and crack width, and the checks of both.

Both generations of EN 1992-1-1 limit them; how wide cracks are, and by which clause, each says itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.eurocode2.cracked_sections import Bars
from groundslab.design.demands.support_moments import bar_moments
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import NO_COMBINATION, DesignCheck, not_judged
from groundslab.design.rules.combinations import solved_results, why_none
from groundslab.design.rules.demand_errors import greatest_moments, scaled
from groundslab.messages import Message, Name
from groundslab.model.design.laid_bars import LaidBars, axis_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import extreme_node, place_of
from groundslab.results.results import Results

MM = 1e3
#: Share of f_yk that bars may be stressed by in characteristic combinations (EN 1992-1-1:2004 k_3 of 7.2(5), EN
#: 1992-1-1:2023 9.2.1).
MOST_STRESS = 0.8
#: A field of moments [N m/m], thicknesses [m] and bars (n,).
BarField = Callable[[Array, Array, Bars], Array]


@dataclass(frozen=True, slots=True)
class Clauses:
    """Where a code rules the stress of bars, their yielding, and the width of cracks, with its name and symbol."""

    code: str
    stress: str
    yielding: str
    crack: str
    width: str = "w_k"


class BySteps(NamedTuple):
    """Calculations of bent bars: of their stress in a cracked section up to sigma_s, and of the width of a crack."""

    stress: Callable[[BentBars], Iterable[Step]]
    width: Callable[[BentBars], Iterable[Step]]


@dataclass(frozen=True, slots=True)
class BentBars:
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

    @property
    def where(self) -> str:
        """Return the place in words."""
        return Message("{place:.3f m}", place=self.place)


def bars_in_tension(
    combined: Results, steel: Reinforcement, laid: dict[str, LaidBars], state: str, field: BarField
) -> list[BentBars]:
    """Return of each layer where a field of its bars is largest in the combinations of a state."""
    results = [result for result in solved_results(combined) if result.limit_state == state]
    if not results:
        return []
    thickness = results[0].elements.at_nodes(results[0].plate)[0]
    bent = []
    for layer, layer_bars in laid.items():
        cover = axis_of(steel, layer) - layer_bars.diameter / 2
        bars = Bars(layer_bars.diameter, layer_bars.spacing, cover, layer_bars.area)
        largest = []
        for result in results:
            m = np.abs(getattr(bar_moments(result, steel), layer))
            values = field(m, thickness, bars)
            node = extreme_node(result.plate.nodes, values, 1)
            place = place_of(result.plate.nodes, node)
            largest.append((float(values[node]), place, result.combination, float(m[node]), node))
        value, place, combination, moment, node = max(largest)
        greatest, error = greatest_moments(combined.results[combination], steel), None
        if greatest is not None:
            error = float(field(np.abs(getattr(greatest, layer)), thickness, bars).max()) - value
        bent.append(BentBars(layer, value, place, combination, error, moment, node))
    return bent


def bars_at(combined: Results, steel: Reinforcement, laid: LaidBars, bent: BentBars) -> tuple[float, Bars]:
    """Return the thickness [m] and the bars where a field is largest."""
    result = combined.results[bent.combination]
    h = float(result.elements.at_nodes(result.plate)[0][bent.node])
    diameter, spacing, area = (float(np.broadcast_to(values, len(result.plate.nodes))[bent.node])
                               for values in (laid.diameter, laid.spacing, laid.area))  # fmt: skip
    return h, Bars(diameter, spacing, axis_of(steel, bent.layer) - diameter / 2, np.array(area))


def check_stresses(
    bent: list[BentBars], f_yk: float, clauses: Clauses, steps: Callable[[BentBars], Iterable[Step]]
) -> Iterator[DesignCheck]:
    """Yield the largest stress of bars in characteristic combinations, which may be 0.8 f_yk.

    The steps are those of the stress in a cracked section, up to sigma_s.
    """
    if not bent:
        return
    worst = max(bent, key=lambda layer: layer.value)
    most = MOST_STRESS * f_yk
    if worst.value > f_yk:
        yield _yields(worst, f_yk, "stress of the bars", clauses, steps(worst))
        return
    holds = worst.value <= most
    yield DesignCheck(
        "stress of the bars",
        "no failure found" if holds else "attention",
        Message(
            "{layer}: sigma_s {value:.4g (MPa)} {sign} {most:.4g MPa} = 0.8 f_yk at {where} in "
            '"{combination}" ({stress})',
            layer=worst.layer.replace("_", " "),
            value=worst.value / 1e6,
            sign="<=" if holds else ">",
            most=most / 1e6,
            where=worst.where,
            combination=Name(worst.combination),
            stress=clauses.stress,
        ),
        of=worst.layer.replace("_", " "),
        demand=worst.value / 1e6,
        resistance=most / 1e6,
        unit="MPa",
        clause=f"{clauses.code} {clauses.stress}",
        combination=worst.combination,
        place=worst.place,
        error=scaled(worst.error, 1e-6),
        steps=(*steps(worst), *_share(worst, f_yk, MOST_STRESS, clauses.stress)),
    )


def _share(bent: BentBars, f_yk: float, most: float, clause: str) -> Iterator[Step]:
    """Yield which share of most f_yk [Pa] the stress of bars uses."""
    yield Step("yield strength", "f_yk", f_yk / MEGA, "MPa")
    formula = "f_yk" if most == 1 else f"{most:g} * f_yk"
    yield Step("largest stress of elastic bars", "sigma_max", most * f_yk / MEGA, "MPa", formula, clause)
    yield Step("share used", "eta", bent.value / (most * f_yk), "", "sigma_s / sigma_max", clause)


def _yields(bent: BentBars, f_yk: float, name: str, clauses: Clauses, steps: Iterable[Step]) -> DesignCheck:
    """Return the check of bars that yield in a combination of serviceability."""
    layer, limit = bent.layer.replace("_", " "), f"f_yk {f_yk / 1e6:.4g} MPa"
    return DesignCheck(
        name,
        "fails",
        Message(
            "{layer}: the bars yield, sigma_s {value:.4g MPa} > {limit} of an elastic section at {where} in "
            '"{combination}"; the section fails, and no crack width is valid ({yielding})',
            layer=layer,
            value=bent.value / 1e6,
            limit=limit,
            where=bent.where,
            combination=Name(bent.combination),
            yielding=clauses.yielding,
        ),
        of=layer,
        demand=bent.value / 1e6,
        resistance=f_yk / 1e6,
        unit="MPa",
        clause=f"{clauses.code} {clauses.yielding}",
        combination=bent.combination,
        place=bent.place,
        error=scaled(bent.error, 1e-6),
        steps=(*steps, *_share(bent, f_yk, 1.0, clauses.yielding)),
    )


def check_cracks(
    combined: Results,
    fields: tuple[list[BentBars], list[BentBars]],
    limits: tuple[float, float],
    clauses: Clauses,
    steps: BySteps,
) -> Iterator[DesignCheck]:
    """Yield the widest crack at each layer in the quasi-permanent combinations.

    Where the bars of a layer yield its section fails: the formulas hold for elastic bars.

    Parameters
    ----------
    combined : Results
        All combinations.
    fields : tuple of list of BentBars
        Stresses [Pa] and crack widths [m] of each layer, none without such combinations.
    limits : tuple of float
        f_yk [Pa] and the largest crack width [m].
    clauses : Clauses
        What checks cite.
    steps : BySteps
        The calculations of the widest crack at a layer, and of bars that yield.
    """
    (f_yk, w_max), (stresses, widths) = limits, fields
    if not stresses:
        words = why_none(combined, ("quasi-permanent",), "quasi-permanent combination")
        yield not_judged("crack width", NO_COMBINATION, words, resistance=w_max * MM, unit="mm")
        return
    for stress, crack in zip(stresses, widths, strict=True):
        name = Message("crack width at the {layer}", layer=crack.layer.replace("_", " "))
        if stress.value > f_yk:
            yield _yields(stress, f_yk, name, clauses, steps.stress(stress))
        else:
            yield _crack(crack, w_max, name, clauses, steps.width(crack))


def _crack(crack: BentBars, w_max: float, name: str, clauses: Clauses, steps: Iterable[Step]) -> DesignCheck:
    """Return the check of the widest crack at a layer."""
    value, most = crack.value * MM, w_max * MM
    holds = value <= most
    return DesignCheck(
        name,
        "no failure found" if holds else "fails",
        Message(
            '{width} {value:.3g (mm)} {sign} {most:.3g mm} at {where} in "{combination}" ({crack})',
            width=clauses.width,
            value=value,
            sign="<=" if holds else ">",
            most=most,
            where=crack.where,
            combination=Name(crack.combination),
            crack=clauses.crack,
        ),
        of=crack.layer.replace("_", " "),
        demand=value,
        resistance=most,
        unit="mm",
        clause=f"{clauses.code} {clauses.crack}",
        combination=crack.combination,
        place=crack.place,
        error=scaled(crack.error, MM),
        steps=(*steps, *_width_share(clauses.width, value, most)),
    )


def _width_share(symbol: str, value: float, most: float) -> Iterator[Step]:
    """Yield which share of the largest width [mm] a crack has."""
    yield Step("largest width", "w_max", most, "mm")
    yield Step("share used", "eta", value / most, "", f"{symbol} / w_max")
