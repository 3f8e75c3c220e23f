"""What tables have of punching at columns, piles and zones: columns that a code fills, and notes that codes share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from groundslab.model.design.reinforcement import Reinforcement

Heads = tuple[tuple[str, str], ...]

#: What acts inside a perimeter.
INSIDE: Heads = (
    ("pressure inside", "kN"), ("pressure inside / load", "%"), ("edge line force inside", "kN"),
    ("other loads inside", "kN"),
)  # fmt: skip

#: What of a column's load and of a pile's force punches.
RELIEF = {
    "column": "load + other loads inside - pressure inside",
    "pile": "force + pressure inside + edge line force inside - other loads inside",
    "zone": "load + other loads inside - pressure inside",
}
#: What beams do to it.
BEAMS = "Other loads inside include the shear forces of beams across the perimeter, upwards negative."
#: What counts of a perimeter that leaves a thicker zone.
THINNER = "Where the slab is thinner than that, a length of a perimeter counts by the share that it resists there."
#: The effective depth of columns, of piles and around thicker zones.
DEPTH = {
    "column": "d is the least thickness under the column less the mean distance of the bottom bars' axes.",
    "pile": "d is the least thickness over the pile less the mean distance of the top bars' axes.",
    "zone": "d is the largest thickness at the border of the zone less the mean distance of the bottom bars' axes.",
}
#: What is around a zone.
AROUND = "Perimeters run around the zone, or around its hull if it has reentrant corners, by their distance from it."
_ONE_EDGE = (
    "The line force of the ground along the plate's edge inside is not a pressure: it does not relieve punching, "
    "unless the case sets line_force_relieves; where it pulls, it is added."
)
_RELIEVES = (
    "The line force of the ground along the plate's edge inside is subtracted like the pressure inside, as the case "
    "sets line_force_relieves."
)
_OVER_EDGE = (
    "The line force of the ground along the plate's edge inside adds to the punching force, as the pressure does."
)


@dataclass(frozen=True, slots=True)
class PunchingColumns:
    """The columns that a table has of punching, their cells by combination and name, and what a reader must know."""

    heads: Heads
    cells: Callable[[str, str], list[float | None]]
    notes: tuple[str, ...]


#: Where nothing is known of punching.
NO_COLUMNS = PunchingColumns((), lambda _, __: [], ())


def effective_note(about_center: str) -> str:
    """Return the note on openings, with the properties of the perimeter about its center."""
    return (
        "The part between the tangents to an opening does not count; center, moments and "
        f"{about_center} are those of the remaining part."
    )


def edge_note(steel: Reinforcement, support: str) -> str:
    """Return the effect of the line force along the plate's edge in words, at a "column", "pile" or "zone"."""
    if support == "pile":
        return _OVER_EDGE
    return _RELIEVES if steel.line_force_relieves else _ONE_EDGE


def missing_notes(missing: Mapping[str, str], support: str) -> tuple[str, ...]:
    """Return why some have no perimeter, by their names, as notes."""
    of = "around" if support == "zone" else f"of {support}"
    return tuple(f"no punching {of} {name}: {why}" for name, why in missing.items())


def cells_inside(force: float, pressure: float, edge: float, others: float) -> list[float | None]:
    """Return the forces inside [N], in the order of INSIDE."""
    return [pressure / 1e3, 100 * pressure / force, edge / 1e3, others / 1e3]
