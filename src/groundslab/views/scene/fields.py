"""The scene of a solved model: its plan, its mesh, and of each combination the fields and their extremes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab._version import __version__
from groundslab.design.bars.required_bars import bar_fields
from groundslab.errors import GroundslabError
from groundslab.model.plan_origin import plan_origin
from groundslab.results.contact_zone import contact_function, goes_below_zero, has_line_force
from groundslab.results.fields import BAR_FIELDS, LINE_FORCE, RANGED_FIELDS, SHOWN_ELEMENT_FIELDS, extreme
from groundslab.results.results import refusal_words
from groundslab.unit_systems import in_system, unit_in
from groundslab.views.scene.annotations import bars_of, reactions_of
from groundslab.views.scene.binary import Blocks, Scene, put_fields
from groundslab.views.scene.plan import plan_of
from groundslab.views.summary import combinations
from groundslab.views.tables.quantities import nodal_values

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.results.plate_result import PlateResult
    from groundslab.results.results import CombinationResult, Results
    from groundslab.unit_systems import System
    from groundslab.views.summary.combinations import Entry

FORMAT = 3
ABOUT = RANGED_FIELDS | SHOWN_ELEMENT_FIELDS | BAR_FIELDS
#: The nodal fields that a scene has, if need be; all others can be made of them.
SHOWN = (
    "settlement", "rotation_x", "rotation_y", "pressure", LINE_FORCE, "gap", "penetration", "moment_x", "moment_y",
    "moment_xy", "shear_x", "shear_y",
)  # fmt: skip
#: The fields of bars that a scene has begin with these.
SHOWN_OF_BARS = ("required_", "provided_", "utilization_", "missing_")


def scene_of(combined: Results, most: int | None = None) -> Scene:
    """Return the scene of all combinations; values in units of display, quantized in 2^16 levels or as sums of fields.

    It has the fields of so many combinations at most: those that govern an extreme come first, then the others in their
    order; the rest is named in "left_out".
    """
    combinations.require_finite(combined)
    entries = combinations.entries(combined)
    solved = [entry.results for entry in entries if entry.results is not None]
    plates = [results.plate for results in solved]
    require_one_mesh(plates)
    names = fields_of(solved)
    blocks, units = Blocks(), combined.model.units
    of_bars = _fields_of_bars(combined)
    mesh = mesh_of(combined.model, solved, blocks)
    kept = _kept(entries, names, len(entries) if most is None else most)
    values = _fields_of_combinations(
        {entry.number: entry.results for entry in entries if entry.number in kept}, names, blocks
    )
    # bars are those of all combinations
    shared = {name: blocks.put_range(of_all) for name, of_all in of_bars.items()}
    values = {number: fields | shared for number, fields in values.items()}
    head = {
        "format": FORMAT,
        "title": combined.model.title,
        "version": __version__,
        "plan": plan_of(combined.solved_model),
        "mesh": mesh,
        "fields": [_about(name, solved, units) for name in names]
        + [describe_field(name, False, units) for name in of_bars]
        + [_CONTACT],
        "combinations": [_combination(entry, names, values.get(entry.number), units) for entry in entries],
        "bars": bars_of(combined.solved_model),
        "left_out": [
            entry.combination.name for entry in entries if entry.results is not None and entry.number not in kept
        ],
    }
    return Scene(head, blocks.data)


def mesh_of(model: Model, solved: Sequence[CombinationResult], blocks: Blocks) -> dict[str, Any]:
    """Return the mesh that combinations share, empty where there are none."""
    nodes, elements, section = np.zeros((0, 2)), np.zeros((0, 9), dtype=np.int64), np.zeros(0, dtype=np.int64)
    if solved:
        nodes, elements, section = solved[0].plate.nodes, solved[0].plate.elements, solved[0].elements.section
    # single precision is too coarse for coordinates of national grids
    origin = plan_origin(model)
    return {
        "origin": [*origin],
        "nodes": blocks.put(nodes - origin, "f32"),
        "elements": blocks.put(elements, "u32"),
        "section": blocks.put(section, "u16"),
    }


_CONTACT = {
    "name": "contact",
    "symbol": "",
    "unit": "",
    "meaning": "negative where the plate bears on the ground, positive where it does not",
    "averaged": "not averaged",
    "signed": True,
}


def fields_of(solved: list[CombinationResult]) -> list[str]:
    """Return the names of the fields that are shown; a penetration and forces along edges only where there are any.

    Those of elements only if all combinations have them.
    """
    absent = {
        "penetration": not any(results.plate.penetration.any() for results in solved),
        LINE_FORCE: not any(map(has_line_force, solved)),
    }
    of_elements = [
        name for name in SHOWN_ELEMENT_FIELDS if all(getattr(results.elements, name) is not None for results in solved)
    ]
    return [name for name in SHOWN if not absent.get(name)] + (of_elements if solved else [])


def _about(name: str, solved: list[CombinationResult], units: System) -> dict[str, Any]:
    """Return how a field is called and shown; it is signed if its sign matters."""
    sign = ABOUT[name].sign
    signed = sign == "any" or any(goes_below_zero(nodal_values(results, name)) for results in solved)
    return describe_field(name, signed, units)


def describe_field(name: str, signed: bool, units: System) -> dict[str, Any]:
    """Return how a field is called and shown, signed or not."""
    about = ABOUT[name]
    words = {key: getattr(about, key) for key in ("symbol", "meaning", "averaged")}
    return {"name": name, "unit": unit_in(about.unit, units)[0], **words, "signed": signed}


def shown_values(results: CombinationResult, name: str) -> Array:
    """Return a field at the nodes (n,) in the unit that it is shown in."""
    return nodal_values(results, name) * unit_in(ABOUT[name].unit, results.model.units)[1]


def _fields_of_bars(combined: Results) -> dict[str, Array]:
    """Return the required bars and their utilization (n,), where any are enough; the same in all combinations.

    One of them is left out where the concrete is too weak somewhere.
    """
    fields = bar_fields(combined)
    return {
        name: values * in_system(BAR_FIELDS[name].display, combined.model.units).scale
        for name, values in fields.items()
        if name.startswith(SHOWN_OF_BARS) and np.isfinite(values).all()
    }


def _fields_of_combinations(
    combined: Mapping[int, CombinationResult | None], names: list[str], blocks: Blocks
) -> dict[int, dict[str, dict[str, Any]]]:
    """Return the fields of combinations with results, by their numbers."""
    solved = {number: results for number, results in combined.items() if results is not None}
    values: dict[int, dict[str, dict[str, Any]]] = {number: {} for number in solved}
    for name in names if solved else ():
        fields = np.array([shown_values(results, name) for results in solved.values()])
        for of_one, block in zip(values.values(), put_fields(blocks, fields), strict=True):
            of_one[name] = block
    for number, results in solved.items():
        values[number]["contact"] = blocks.put_signed(contact_function(results))
    return values


def _combination(
    entry: Entry,
    names: list[str],
    values: Mapping[str, dict[str, Any]] | None,
    units: System,
) -> dict[str, Any]:
    """Return one combination: what acts together, its fields, their extremes, or why there are none."""
    results = entry.results
    return {
        "name": entry.combination.name,
        "number": entry.number,
        "limit_state": entry.combination.limit_state,
        "factors": [list(pair) for pair in entry.combination.factors],
        "refused": None if entry.refused is None else refusal_words(entry.refused, units),
        "certified": entry.refused is None,
        "values": values,
        "extremes": {} if results is None else dict(_extremes(results, names)),
        "reactions": [] if results is None else reactions_of(results),
    }


def _extremes(results: CombinationResult, names: list[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the extremes of each field with their places: [value, x, y]; of the line force those along the edge."""
    plate = results.plate
    for name in names:
        yield name, range_of(plate.nodes, shown_values(results, name))
    if has_line_force(results):
        on_edge = plate.edge_length > 0
        yield LINE_FORCE, range_of(plate.nodes[on_edge], shown_values(results, LINE_FORCE)[on_edge])


def range_of(nodes: Array, values: Array) -> dict[str, list[float]]:
    """Return the least and the greatest value with their places [m]."""
    (low, at_low), (high, at_high) = (extreme(nodes, values, sign) for sign in (-1, 1))
    return {"min": [low + 0.0, *at_low], "max": [high + 0.0, *at_high]}


def _kept(entries: list[Entry], names: list[str], count: int) -> set[int]:
    """Return the numbers of so many combinations with results: first the certified ones that govern an extreme."""
    plates = {entry.number: entry.results.plate for entry in entries if entry.results and entry.refused is None}
    others = [entry.number for entry in entries if entry.results is not None]
    order: dict[int, None] = {}
    for name in (name for name in names if name in SHOWN):
        for sign in (1, -1):
            highest = {number: float((sign * getattr(plate, name)).max()) for number, plate in plates.items()}
            if highest:
                order[max(highest, key=highest.__getitem__)] = None
    return set([*order, *(number for number in others if number not in order)][:count])


def require_one_mesh(plates: list[PlateResult]) -> None:
    """Raise GroundslabError if the combinations' results stand on different meshes."""
    for plate in plates[1:]:
        if not (np.array_equal(plate.nodes, plates[0].nodes) and np.array_equal(plate.elements, plates[0].elements)):
            raise GroundslabError("the combinations' results are on different meshes; they have no common picture")
