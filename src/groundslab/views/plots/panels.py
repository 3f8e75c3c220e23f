"""What panels show: an amount of one combination, or its envelope over several; scales and extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.design.envelope import envelope
from groundslab.design.tables.quantities import nodal
from groundslab.results.contact_zone import contact_function, has_line_force
from groundslab.results.fields import LINE_FORCE, PLATE_FIELDS, extreme, extreme_node, place_of
from groundslab.views.plots.amounts import NOT_ABOVE, NOT_BELOW, Amount
from groundslab.views.plots.scale import Scale, scale_of
from groundslab.views.plots.symbols import in_combination

if TYPE_CHECKING:
    from groundslab.arrays import Array, Integers
    from groundslab.model.loads.load_types import AnyLoad
    from groundslab.results.results import Results
    from groundslab.views.plots.request import Drawn, Wish

NOT_CERTIFIED = "NOT CERTIFIED: the certificate does not hold; the result must not be used"


@dataclass(frozen=True, slots=True)
class View:
    """One panel: an amount of one combination, or an extreme of it over several."""

    amount: Amount
    of: str  # the combination, or what the extreme is taken over
    values: Array  # (n,), in units of display
    nodes: Array
    elements: Integers
    line_force: tuple[float, tuple[float, float]] | None  # beside the pressure: the largest [kN/m] and its place [m]
    contact: Array | None  # (n,): below zero in contact
    share: float | None  # of the plate's area that is in contact
    takes_part: Callable[[AnyLoad], bool]
    certified: bool
    governs: tuple[tuple[str, ...], Integers] | None = None  # combinations, and the one that each value comes from


def views_of(wish: Wish) -> list[View]:
    """Return the panels that are asked for: by combination, then by amount."""
    if wish.envelope:
        return [view for amount in wish.amounts for view in _enveloped(amount, wish.drawn, wish.envelope)]
    return [view_of(amount, each, wish.several) for each in wish.drawn for amount in wish.amounts]


def view_of(amount: Amount, drawn: Drawn, several: bool) -> View:
    """Return the panel of an amount in one combination."""
    results = drawn.results
    plate = results.plate
    return View(
        amount,
        f"{drawn.name} ({drawn.limit_state})" if several else "",
        nodal(results, amount.name),
        plate.nodes,
        plate.elements,
        _line_force(amount, [results]),
        contact_function(results),
        plate.contact_share,
        in_combination(results.factors),
        drawn.certified,
    )


def _line_force(amount: Amount, several: Sequence[Results]) -> tuple[float, tuple[float, float]] | None:
    """Return the largest edge line force of several results, to be told beside their pressure, and its place."""
    if amount.name != "pressure" or not any(map(has_line_force, several)):
        return None
    found = []
    for plate in (results.plate for results in several):
        on_edge = np.flatnonzero(plate.edge_length > 0)
        nodes, values = plate.nodes[on_edge], plate.line_force[on_edge] * PLATE_FIELDS[LINE_FORCE].scale
        found.append(extreme(nodes, values, 1))
    return max(found)


def _enveloped(amount: Amount, drawn: Sequence[Drawn], state: str) -> Iterator[View]:
    """Yield the largest and the smallest values of an amount over combinations, as far as they tell anything."""
    found = envelope({each.name: nodal(each.results, amount.name) for each in drawn})
    line_force = _line_force(amount, [each.results for each in drawn])
    factors = [pair for each in drawn for pair in each.results.factors if pair[1]]
    plate = drawn[0].results.plate
    takes_part = in_combination(factors)
    for word, values, by, nothing in (
        ("Largest", found.greatest, found.greatest_by, amount.name in NOT_ABOVE),
        ("Smallest", found.least, found.least_by, amount.name in NOT_BELOW),
    ):
        if not nothing:
            of = f"{word} of the {len(drawn)} {state} combination{'s' if len(drawn) > 1 else ''}"
            yield View(
                amount,
                of,
                values,
                plate.nodes,
                plate.elements,
                line_force if word == "Largest" else None,
                None,
                None,
                takes_part,
                True,
                (found.names, by),
            )


def scales_of(views: Sequence[View]) -> dict[str, Scale]:
    """Return the scale of each amount, the same in all panels, by the amount's name."""
    found = {}
    for name in dict.fromkeys(view.amount.name for view in views):
        own = [view for view in views if view.amount.name == name]
        found[name] = scale_of([view.values for view in own], signed=own[0].amount.signed)
    return found


class Extreme(NamedTuple):
    """The largest or the smallest value that is drawn."""

    word: str  # "largest" or "smallest"
    value: float
    place: tuple[float, float]  # [m]
    whose: str  # the combination that it comes from, where there are several


def extremes_of(view: View) -> list[Extreme]:
    """Return the largest and the smallest value with their places, as far as they are not plain zeros."""
    found = []
    nodes, values = view.nodes, view.values
    size = np.abs(values).max()
    for word, sign in (("largest", 1), ("smallest", -1)):
        node = extreme_node(nodes, values, sign)
        if abs(values[node]) > 1e-9 * size:
            whose = "" if view.governs is None else view.governs[0][view.governs[1][node]]
            found.append(Extreme(word, float(values[node]), place_of(nodes, node), whose))
    if len(found) == 2 and found[0].value - found[1].value <= 1e-9 * size:
        del found[1]
    return found
