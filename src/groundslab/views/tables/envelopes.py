"""Extremes over the combinations of each limit state: as a table, and at every node of the plate."""

from __future__ import annotations

from collections.abc import Iterator
from typing import get_args

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars import required_bars
from groundslab.design.demands.envelope import envelope
from groundslab.design.rules.combinations import solved_results, ultimate_results
from groundslab.errors import GroundslabError
from groundslab.messages import Message, Name
from groundslab.model.loads.load_cases import LimitState
from groundslab.results.fields import BAR_FIELDS, LAYERS, RANGED_FIELDS, extreme_node, place_of
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.quantities import nodal_values, ranged_fields
from groundslab.views.tables.reinforcement import CM2
from groundslab.views.tables.table import Cell, Table, table_of


def envelopes(combined: Results) -> Table:
    """Return the least and the greatest value of every quantity over the combinations of each limit state."""
    heads = [
        ("limit state", ""), ("quantity", ""), ("unit", ""),
        ("least", ""), ("x of the least", "m"), ("y of the least", "m"), ("combination of the least", ""),
        ("greatest", ""), ("x of the greatest", "m"), ("y of the greatest", "m"), ("combination of the greatest", ""),
    ]  # fmt: skip
    rows = []
    for state, group in _by_limit_state(combined):
        nodes = group[0].plate.nodes
        for about, name, where in ranged_fields(group[0]):
            e = envelope({result.combination: nodal_values(result, name)[where] for result in group})
            row: list[Cell] = [state, about.label, about.unit]
            for sign, values, by in ((-1, e.least, e.least_by), (1, e.greatest, e.greatest_by)):
                node = extreme_node(nodes[where], values, sign)
                row += [float(values[node]), *place_of(nodes[where], node), e.names[by[node]]]
            rows.append(row)
    notes = [
        "Of nodal values, over the combinations of one limit state. Values in different rows need not belong to one "
        "combination; design moments are those of each combination, not of enveloped moments.",
        "Of combinations with the same value the first is named.",
    ]
    return table_of("envelope", "Envelope over the combinations", heads, rows, notes, ("least", "greatest"))


def fields_of_envelope(combined: Results) -> dict[str, Array | Integers]:
    """Return arrays (n,) at the plate's nodes, by names with units: envelopes over each limit state, reinforcement.

    "ultimate greatest settlement w [mm]" and "ultimate least ..." hold the values of each quantity;
    "ultimate combination of greatest settlement w" holds which combination they come from: its position in
    `combined.combinations`, from 0. With reinforcement given, "reinforcement bottom x [cm2/m]" and so on hold the
    largest area over the ultimate combinations; it is inf where "reinforcement fails" is 1. "reinforcement needs links"
    is 1 where bars in compression are counted on. Where bars are laid, "provided area bottom x [cm2/m]", "utilization
    bottom x [%]" and "missing area bottom x [cm2/m]" compare with them. Empty if no combination has a result.
    """
    number = {combination.name: i for i, combination in enumerate(combined.combinations)}
    fields: dict[str, Array | Integers] = {}
    for state, group in _by_limit_state(combined):
        numbers: Integers = np.array([number[result.combination] for result in group], dtype=np.int64)
        for name, about in RANGED_FIELDS.items():
            e = envelope({result.combination: nodal_values(result, name) for result in group})
            fields[Message("{state} greatest {name}", state=state, name=Name(about.name))] = e.greatest
            fields[Message("{state} least {name}", state=state, name=Name(about.name))] = e.least
            fields[Message("{state} combination of greatest {label}", state=state, label=about.label)] = numbers[
                e.greatest_by
            ]
            fields[Message("{state} combination of least {label}", state=state, label=about.label)] = numbers[
                e.least_by
            ]
    if combined.model.reinforcement is not None:
        fields |= _reinforcement(combined)
    return fields


def _reinforcement(combined: Results) -> dict[str, Array | Integers]:
    """Return the required areas [cm2/m] and flags at the plate's nodes."""
    assert combined.model.reinforcement is not None
    required = required_bars.required_areas(combined.model.reinforcement, ultimate_results(combined))
    if not required:
        return {}
    areas = {layer: required_bars.largest_areas(required, layer)[0] for layer in LAYERS}
    fields: dict[str, Array | Integers] = {
        Message("reinforcement {layer} [cm2/m]", layer=layer.replace("_", " ")): area * CM2
        for layer, area in areas.items()
    }
    fails: Flags = np.any([np.isinf(area) for area in areas.values()], axis=0)
    for name, values in required_bars.bar_fields(combined).items():
        if not name.startswith("required"):  # which is there as reinforcement
            fields[Message("{quantity} [{unit}]", quantity=BAR_FIELDS[name].quantity, unit=BAR_FIELDS[name].unit)] = (
                values * BAR_FIELDS[name].scale
            )
    fields["reinforcement fails"] = fails.astype(np.int64)
    fields["reinforcement needs links"] = required_bars.needs_links(required).astype(np.int64)
    return fields


def _by_limit_state(combined: Results) -> Iterator[tuple[str, list[CombinationResult]]]:
    """Yield each limit state that has results, with these."""
    results = solved_results(combined)
    for result in results[1:]:
        if not np.array_equal(result.plate.nodes, results[0].plate.nodes):
            raise GroundslabError("the combinations' results are on different meshes; they have no envelope")
    for state in get_args(LimitState):
        group = [result for result in results if result.limit_state == state]
        if group:
            yield state, group
