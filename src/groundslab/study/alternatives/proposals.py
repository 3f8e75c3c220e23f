"""What is tried in place of a slab as it is drawn: thinner and thicker ones, drop panels at columns that need links."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.case.editing import lengths
from groundslab.case.editing.toml_values import Path, get_value
from groundslab.design.demands.perimeter_loads import footprint_of, thickness_at
from groundslab.design.proposal.links import punching_links
from groundslab.model.model import Model
from groundslab.model.structure.columns import Column
from groundslab.results.results import Results
from groundslab.schema.wording import listed
from groundslab.unit_systems import FOOT, INCH, System

#: By how much thicknesses are changed [m]: about a tenth of the slab's, in these steps.
STEPS: dict[System, float] = {"SI": 0.05, "US": 2 * INCH}
SHARE = 0.1
#: Numbers of steps that are tried.
THICKER = (-1, 1, 2)
#: The first words of what is told of drop panels.
PANELS = "Drop panels"
#: Drop panels are so many steps thicker than the slab.
PANEL_STEPS = 2
#: How far drop panels reach beyond the column's faces, in terms of their thickness: the perimeter at 2 d is inside.
PANEL_REACH = 2.0
#: What that is rounded up to [m].
ROUNDED: dict[System, float] = {"SI": 0.1, "US": FOOT / 4}
#: Resolution of lengths that are written [m].
RESOLUTION = 1e-4


@dataclass(frozen=True, slots=True)
class Proposal:
    """What an alternative changes: keys of the case and their values, thicknesses in meters and new parts as tables."""

    name: str
    words: str
    edits: tuple[tuple[Path, Any], ...] = ()


def thickness_step(model: Model) -> float:
    """Return the step of thicknesses [m]: about a tenth of the slab's, a multiple of 50 mm or 2 in."""
    step = STEPS[model.units]
    return step * max(1, round(SHARE * model.plate.thickness / step))


def other_thicknesses(model: Model, data: dict[str, Any]) -> Iterator[Proposal]:
    """Yield the slab thinner and thicker, with its zones, as far as a step leaves something of it."""
    step = thickness_step(model)
    paths = list(_thickness_paths(data))
    for number in THICKER:
        change = number * step
        new = [_thickness_of(model, path) + change for path in paths]
        if min(new) < step / 2:
            continue
        word = "thicker" if change > 0 else "thinner"
        shown = _shown(abs(change), model.units)
        edits = [(path, _written(get_value(data, path), value)) for path, value in zip(paths, new, strict=True)]
        yield Proposal(f"{shown} {word}", f"The slab and its zones {shown} {word}", tuple(edits))


def drop_panels(results: Results, data: dict[str, Any]) -> Proposal | None:
    """Return the slab with drop panels at the columns where concrete alone does not bear punching; None if it does."""
    model = results.model
    needy = {layout.name for layout in punching_links(results) if layout.support == "column"}
    columns = [column for column in model.columns if column.name in needy]
    if not columns or not results.results:
        return None
    zones = [_panel(model, column, results, data) for column in columns]
    there = get_value(data, ("plate", "zones"), [])
    shown = _shown(PANEL_STEPS * thickness_step(model), model.units)
    names = listed([column.name for column in columns], "and")
    return Proposal(
        f"drop panels, {shown}",
        f"{PANELS} {shown} thicker than the slab, at {names}",
        ((("plate", "zones"), [*there, *zones]),),
    )


def _panel(model: Model, column: Column, results: Results, data: dict[str, Any]) -> dict[str, Any]:
    """Return the drop panel of a column as a zone of the file."""
    first = next(iter(results.results.values()))
    thickness = thickness_at(first, footprint_of(column)) + PANEL_STEPS * thickness_step(model)
    grid = ROUNDED[model.units]
    reach = grid * math.ceil(PANEL_REACH * thickness / grid - 1e-9)
    box = column.ring().bounds
    old = get_value(data, ("plate", "thickness"))
    x, y = ([_written(old, box[low] - reach), _written(old, box[low + 1] + reach)] for low in (0, 2))
    return {"thickness": _written(old, thickness), "shape": {"kind": "rectangle", "x": x, "y": y}}


def _thickness_paths(data: dict[str, Any]) -> Iterator[Path]:
    """Yield where a file states the thickness of plates and zones."""
    plates: Sequence[tuple[Path, Any]] = [
        (("plate",), data["plate"]), *((("plates", n), plate) for n, plate in enumerate(data.get("plates", [])))
    ]  # fmt: skip
    for path, plate in plates:
        if "thickness" in plate:
            yield (*path, "thickness")
        zones = plate.get("zones", [])
        yield from ((*path, "zones", n, "thickness") for n, zone in enumerate(zones) if "thickness" in zone)


def _thickness_of(model: Model, path: Path) -> float:
    """Return the thickness at a path of a file [m]."""
    part: Any = model
    for step in path:
        part = part[step] if isinstance(step, int) else getattr(part, step)
    return float(part)


def _written(old: Any, value: float) -> str:
    """Return a length [m] as a file writes it, in the unit of another one."""
    text: str = lengths.format_lengths(old, [value], RESOLUTION)[0]
    return text


def _shown(value: float, system: System) -> str:
    """Return a change of thickness in words."""
    return f"{value / INCH:g} in" if system == "US" else f"{1e3 * value:.4g} mm"
