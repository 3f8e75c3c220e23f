"""What panels show: a quantity of one combination, or its envelope over several; scales and extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.design.bars.required_bars import bar_fields
from groundslab.design.demands.envelope import envelope
from groundslab.design.rules.combinations import ultimate_results
from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name, counted
from groundslab.results.contact_zone import contact_function, has_line_force, require_finite
from groundslab.results.fields import BAR_FIELDS, LINE_FORCE, PLATE_FIELDS, extreme, extreme_node, place_of
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.wording import one_of, quote
from groundslab.views.difference import find_subtracted, transfer
from groundslab.views.plots.contours import ColorScale, make_scale
from groundslab.views.plots.request import PlotQuantity, PlottedCombination, require_element_fields
from groundslab.views.plots.symbols import load_filter
from groundslab.views.tables.quantities import nodal_values

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.views.plots.request import PlotRequest
    from groundslab.views.summary.combinations import Entry

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
    difference: bool = False  # whether other results have been subtracted


def subtract(request: PlotRequest, minus: CombinationResult | Results) -> PlotRequest:
    """Return a request that draws by how much its results exceed others: the combination of the same name, or the only.

    Raises InputError if there is no such combination, or the request is for no plan of fields of combinations.
    """
    issues = []
    if request.kind != "plan":
        issues.append(Issue("minus", f"other results, as kind is {quote(request.kind)}", 'none, or kind = "plan"'))
    if request.envelope:
        issues.append(Issue("minus", "other results, as an envelope is drawn", "one of the two"))
    issues += [
        Issue("FIELD", f"{quote(quantity.name)} minus other results", "a field of combinations")
        for quantity in request.quantities
        if quantity.name in BAR_FIELDS
    ]
    if issues:
        raise InputError(issues)
    names = [combination.name for combination in request.combinations]
    matches, others = find_subtracted(names, minus)
    subtracted = tuple(_plotted(matches[name]) for name in names if name in matches)
    hint = "name one combination of the other results, or one that both have"
    missing = [name for name in names if name not in matches]
    issues = [Issue("minus", f"no results of {quote(name)}", one_of(others), hint) for name in missing]
    if issues:
        raise InputError(issues)
    for other in subtracted:
        require_finite(other.results)
    require_element_fields(request.quantities, subtracted)
    return replace(request, minus=subtracted)


def _plotted(entry: Entry) -> PlottedCombination:
    """Return a combination that has results, as it is drawn."""
    combination = entry.combination
    assert entry.results is not None
    return PlottedCombination(combination.name, combination.limit_state, entry.results, entry.refused is None)


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
    if request.minus:
        pairs = zip(request.combinations, request.minus, strict=True)
        return [
            _difference_panel(quantity, combination, other, request.mesh)
            for combination, other in pairs
            for quantity in request.quantities
        ]
    return [
        build_panel(quantity, combination, request.names_combinations, request.mesh)
        for combination in request.combinations
        for quantity in request.quantities
    ]


def _difference_panel(
    quantity: PlotQuantity, combination: PlottedCombination, minus: PlottedCombination, mesh: bool
) -> Panel:
    """Return by how much a quantity exceeds that of other results, whose fields are interpolated at its nodes.

    Raises InputError if nodes lie beyond the plate of the other results.
    """
    panel = build_panel(quantity, combination, True, mesh)
    move = transfer(minus.results.plate, combination.results.plate)
    values = move(nodal_values(minus.results, quantity.name) * quantity.factor)
    names = [
        Name(
            f"{plotted.results.model.title} {plotted.name}".strip() if combination.name == minus.name else plotted.name
        )
        for plotted in (combination, minus)
    ]
    return replace(
        panel, source=Message("{first} minus {second}", first=names[0], second=names[1]),
        values=panel.values - values, line_force=None, contact=None,
        share=None, certified=combination.certified and minus.certified, difference=True,
    )  # fmt: skip


def build_panel(quantity: PlotQuantity, combination: PlottedCombination, named: bool, mesh: bool = False) -> Panel:
    """Return the panel of a quantity in one combination."""
    results, plate = combination.results, combination.results.plate
    source = combination.words if named else ""
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
            singular, plural = (f"{word} of the {{count}} {{state}} combination{s}" for s in ("", "s"))
            source = counted(len(combinations), singular, plural, state=state)
            force = line_force if word == "Largest" else None
            governs = (extremes.names, by)
            yield Panel(quantity, source, values, plate.nodes, plate.elements, takes_part, force, governs=governs)


def _bar_panels(quantities: Sequence[PlotQuantity], request: PlotRequest) -> Iterator[Panel]:
    """Yield the fields of bars, over all ultimate combinations."""
    results = ultimate_results(request.combined)
    fields = bar_fields(request.combined)
    plate = results[0].plate
    takes_part = load_filter([pair for result in results for pair in result.factors if pair[1]])
    source: str = Name(results[0].combination)
    if len(results) > 1:
        source = Message("All {count} ultimate combinations", count=len(results))
    for quantity in quantities:
        values = fields[quantity.name] * quantity.field.scale
        yield Panel(quantity, source, values, plate.nodes, plate.elements, takes_part, None, mesh=request.mesh)


def shared_scales(panels: Sequence[Panel]) -> dict[str, ColorScale]:
    """Return the scale of each quantity, the same in all panels, by the quantity's name."""
    scales = {}
    for name in dict.fromkeys(panel.quantity.name for panel in panels):
        alike = [panel for panel in panels if panel.quantity.name == name]
        limit = 100.0 if name.startswith("utilization") else None
        difference = any(panel.difference for panel in alike)
        signed = difference or alike[0].quantity.field.sign == "any"
        values = [panel.values for panel in alike]
        # the scale of a difference has zero in its middle
        values += [-nodal for nodal in values] if difference else []
        scales[name] = make_scale(values, signed=signed, limit=limit)
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
