"""The scene of a difference: by how much results exceed others, combination by combination, as plots draw it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.results.fields import LAYERS, LINE_FORCE, PLATE_FIELDS, RANGED_FIELDS
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.wording import one_of
from groundslab.unit_systems import System, unit_in
from groundslab.views.difference import Subtracted, find_subtracted, transfer
from groundslab.views.scene.binary import Blocks, Scene
from groundslab.views.scene.fields import (
    ABOUT,
    FORMAT,
    describe_field,
    fields_of,
    mesh_of,
    range_of,
    require_one_mesh,
)
from groundslab.views.scene.plan import plan_of
from groundslab.views.summary import combinations
from groundslab.views.tables.quantities import nodal_values

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from groundslab.arrays import Array
    from groundslab.views.summary.combinations import Entry


def difference_of(combined: Results, minus: Subtracted) -> Scene:
    """Return the scene of all combinations minus those of other results, fields of bars and of contact left out.

    Moments that others are derived of are subtracted after that, as no difference of them gives theirs. Combinations
    from which nothing can be subtracted have no values. Raises InputError if that are all of them, or if nodes lie
    beyond the plate of the others.
    """
    combinations.require_finite(combined)
    entries = combinations.entries(combined)
    solved = {entry.combination.name: entry.results for entry in entries if entry.results is not None}
    require_one_mesh([results.plate for results in solved.values()])
    matches, others = find_subtracted(solved, minus)
    if not matches:
        hint = "choose one of them to subtract it from all"
        raise InputError([Issue("minus", f"results of {one_of(others)}", "a combination that both have", hint)])
    pairs = {name: (solved[name], other.results) for name, other in matches.items() if other.results is not None}
    require_one_mesh([other.plate for _, other in pairs.values()])
    target, source = next(iter(pairs.values()))
    move = transfer(source.plate, target.plate)
    names = _names_of([results for pair in pairs.values() for results in pair])
    blocks, units = Blocks(), combined.model.units

    def values_of(name: str, combination: str) -> Array:
        minuend, subtrahend = pairs[combination]
        factor = unit_in(ABOUT[name].unit, units)[1]
        return factor * (nodal_values(minuend, name) - move(nodal_values(subtrahend, name)))

    head = {
        "format": FORMAT,
        "title": combined.model.title,
        "version": __version__,
        "plan": plan_of(combined.solved_model),
        "mesh": mesh_of(combined.model, list(solved.values()), blocks),
        "fields": [_describe(name, units) for name in names],
        "combinations": [
            _combination(entry, matches.get(entry.combination.name), names, values_of, blocks, target.plate.nodes)
            for entry in entries
        ],
        "left_out": [],
        "difference": "combination" if isinstance(minus, CombinationResult) else "reference",
    }
    return Scene(head, blocks.data)


def _describe(name: str, units: System) -> dict[str, Any]:
    """Return how a field is called and shown; design moments, which have no symbol in tables, get that of pictures."""
    about = describe_field(name, True, units)
    face, _, axis = name.partition("_")
    return about | {"symbol": f"m_{axis} {face}"} if name in LAYERS else about


def _names_of(several: Sequence[CombinationResult]) -> list[str]:
    """Return the fields that all of several results have, and those derived of them."""
    basic = [name for name in fields_of(list(several)) if name != LINE_FORCE]
    return [*basic, *(name for name in RANGED_FIELDS if name not in PLATE_FIELDS)]


def _combination(
    entry: Entry,
    other: Entry | None,
    names: Sequence[str],
    values_of: Callable[[str, str], Array],
    blocks: Blocks,
    nodes: Array,
) -> dict[str, Any]:
    """Return one combination, what is subtracted from it, and by how much its fields exceed those."""
    name = entry.combination.name
    values = {} if other is None else {field: values_of(field, name) for field in names}
    return {
        "name": name,
        "number": entry.number,
        "limit_state": entry.combination.limit_state,
        "factors": [list(pair) for pair in entry.combination.factors],
        "refused": None,
        "certified": entry.refused is None and other is not None and other.refused is None,
        "values": {field: blocks.put_range(part) for field, part in values.items()} or None,
        "extremes": {field: range_of(nodes, part) for field, part in values.items()},
        "minus": None if other is None else other.combination.name,
    }
