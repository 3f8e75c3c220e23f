"""What panels show: a quantity of one combination, or its envelope over several; scales and extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.envelope import envelope
from groundslab.design.required_bars import bar_fields
from groundslab.design.tables.quantities import nodal_values
from groundslab.results.contact_zone import contact_function, has_line_force
from groundslab.results.fields import BAR_FIELDS, LINE_FORCE, PLATE_FIELDS, extreme, extreme_node, place_of
from groundslab.views.plots.contours import ColorScale, make_scale
from groundslab.views.plots.request import PlotQuantity
from groundslab.views.plots.symbols import load_filter

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.results.results import CombinationResult
    from groundslab.views.plots.request import PlotRequest, PlottedCombination

NOT_CERTIFIED = "NOT CERTIFIED: the certificate does not hold; the result must not be used"


@dataclass(frozen=True, slots=True)
class Panel:
    """One panel: a quantity of one combination, or an extreme of it over several."""

    quantity: PlotQuantity
    source: str  # the combination, or what the extreme is taken over
    values: Array  # (n,), in units of display
    nodes: Array
    elements: Integers
    takes_part: Callable[[AnyLoad], bool]
    line_force: tuple[float, tuple[float, float]] | None  # beside the pressure: the largest [kN/m] and its place [m]
    contact: Array | None = None  # (n,): below zero in contact
    share: float | None = None  # of the plate's area that is in contact
    certified: bool = True
    governs: tuple[tuple[str, ...], Integers] | None = None  # combinations, and the one that each value comes from
    mesh: bool = False  # whether the elements' sides are drawn


def build_panels(request: PlotRequest) -> list[Panel]:
    """Return the panels of a request: by combination, then by quantity; last the fields of bars."""
    of_bars = [quantity for quantity in request.quantities if quantity.name in BAR_FIELDS]
    if of_bars:
        others = replace(
            request, quantities=tuple(quantity for quantity in request.quantities if quantity not in of_bars)
        )
        return [*(build_panels(others) if others.quantities else ()), *_bar_panels(of_bars, request)]
    if request.envelope:
        several = (
            _envelope_panels(quantity, request.combinations, request.envelope) for quantity in request.quantities
        )
        return [replace(panel, mesh=request.mesh) for panel in chain.from_iterable(several)]
    return [
        build_panel(quantity, combination, request.names_combinations, request.mesh)
        for combination in request.combinations
        for quantity in request.quantities
    ]


def build_panel(quantity: PlotQuantity, combination: PlottedCombination, named: bool, mesh: bool = False) -> Panel:
    """Return the panel of a quantity in one combination."""
    results, plate = combination.results, combination.results.plate
    source = f"{combination.name} ({combination.limit_state})" if named else ""
    values, takes_part = nodal_values(results, quantity.name) * quantity.factor, load_filter(results.factors)
    force, contact = _line_force(quantity, [results]), contact_function(results)
    shown = (quantity, source, values, plate.nodes, plate.elements, takes_part, force)
    return Panel(*shown, contact, plate.contact_share, combination.certified, mesh=mesh)


def _line_force(
    quantity: PlotQuantity, several: Sequence[CombinationResult]
) -> tuple[float, tuple[float, float]] | None:
    """Return the largest edge line force of several results, which is named beside their pressure, and its place."""
    if quantity.name != "pressure" or not any(map(has_line_force, several)):
        return None
    largest = []
    for plate in (results.plate for results in several):
        on_edge = np.flatnonzero(plate.edge_length > 0)
        nodes = plate.nodes[on_edge]
        values = plate.line_force[on_edge] * PLATE_FIELDS[LINE_FORCE].scale
        largest.append(extreme(nodes, values, 1))
    return max(largest)


def _envelope_panels(quantity: PlotQuantity, combinations: Sequence[PlottedCombination], state: str) -> Iterator[Panel]:
    """Yield the largest and smallest values of a quantity over combinations, but for those always zero."""
    extremes = envelope(
        {
            combination.name: nodal_values(combination.results, quantity.name) * quantity.factor
            for combination in combinations
        }
    )
    line_force = _line_force(quantity, [combination.results for combination in combinations])
    factors = [pair for combination in combinations for pair in combination.results.factors if pair[1]]
    plate = combinations[0].results.plate
    takes_part = load_filter(factors)
    for word, values, by, nothing in (
        ("Largest", extremes.greatest, extremes.greatest_by, quantity.field.sign == "not positive"),
        ("Smallest", extremes.least, extremes.least_by, quantity.field.sign == "not negative"),
    ):
        if not nothing:
            source = f"{word} of the {len(combinations)} {state} combination{'s' if len(combinations) > 1 else ''}"
            force = line_force if word == "Largest" else None
            governs = (extremes.names, by)
            yield Panel(quantity, source, values, plate.nodes, plate.elements, takes_part, force, governs=governs)


def _bar_panels(quantities: Sequence[PlotQuantity], request: PlotRequest) -> Iterator[Panel]:
    """Yield the fields of bars, over all ultimate combinations."""
    results = ultimate_results(request.combined)
    fields = bar_fields(request.combined)
    plate = results[0].plate
    takes_part = load_filter([pair for result in results for pair in result.factors if pair[1]])
    source = f"All {len(results)} ultimate combinations" if len(results) > 1 else results[0].combination
    for quantity in quantities:
        values = fields[quantity.name] * quantity.field.scale
        yield Panel(quantity, source, values, plate.nodes, plate.elements, takes_part, None, mesh=request.mesh)


def shared_scales(panels: Sequence[Panel]) -> dict[str, ColorScale]:
    """Return the scale of each quantity, the same in all panels, by the quantity's name."""
    scales = {}
    for name in dict.fromkeys(panel.quantity.name for panel in panels):
        alike = [panel for panel in panels if panel.quantity.name == name]
        limit = 100.0 if name.startswith("utilisation") else None
        signed = alike[0].quantity.field.sign == "any"
        scales[name] = make_scale([panel.values for panel in alike], signed=signed, limit=limit)
    return scales


class Extreme(NamedTuple):
    """The largest or the smallest value that is drawn."""

    word: str  # "largest" or "smallest"
    value: float
    place: tuple[float, float]  # [m]
    whose: str  # the combination that it comes from, where there are several


def find_extremes(panel: Panel) -> list[Extreme]:
    """Return the largest and the smallest value with their places, as far as they are not plain zeros."""
    extremes = []
    nodes, values = panel.nodes, panel.values
    size = np.abs(values).max()
    for word, sign in (("largest", 1), ("smallest", -1)):
        node = extreme_node(nodes, values, sign)
        if abs(values[node]) > 1e-9 * size:
            whose = "" if panel.governs is None else panel.governs[0][panel.governs[1][node]]
            extremes.append(Extreme(word, float(values[node]), place_of(nodes, node), whose))
    if len(extremes) == 2 and extremes[0].value - extremes[1].value <= 1e-9 * size:
        del extremes[1]
    return extremes
