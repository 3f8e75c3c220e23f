"""What is tried in place of a slab as it is drawn: thinner and thicker ones, drop panels at columns that need links."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.case.editing import lengths
from groundslab.case.editing.toml_values import Path, get_value
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.demands.perimeter_loads import footprint_of, thickness_at
from groundslab.messages import Message, Name, series
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.model.structure.columns import Column
from groundslab.results.results import CombinationResult, Results
from groundslab.unit_systems import FOOT, INCH, System

#: By how much thicknesses are changed [m]: about a tenth of the slab's, in these steps.
STEPS: dict[System, float] = {"SI": 0.05, "US": 2 * INCH}
SHARE = 0.1
#: Numbers of steps that are tried.
STEP_COUNTS = (-1, 1, 2)
#: The first words of what is told of drop panels.
PANELS = "Drop panels"
#: Drop panels are so many steps thicker than the slab.
PANEL_STEPS = 2
#: How far drop panels reach beyond the column's faces, in terms of their thickness: the perimeter at 2 d is inside.
PANEL_REACH = 2.0
#: The grid on which their edges are [m].
ROUNDED: dict[System, float] = {"SI": 0.1, "US": FOOT / 4}
#: Resolution of lengths that are written [m].
RESOLUTION = 1e-4


#: A rectangle x0, x1, y0, y1 [m].
Bounds = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Proposal:
    """What an alternative changes: keys of a file and their new values."""

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
    for number in STEP_COUNTS:
        change = number * step
        new = [_thickness_of(model, path) + change for path in paths]
        if min(new) < step / 2:
            continue
        word, size = "thicker" if change > 0 else "thinner", 1e3 * abs(change)
        name, words = (
            Message(f"{about}{{change:.4g mm}} {word}", change=size).in_units(model.units)
            for about in ("", "The slab and its zones ")
        )
        edits = [(path, _written(get_value(data, path), value)) for path, value in zip(paths, new, strict=True)]
        yield Proposal(name, words, tuple(edits))


def drop_panels(results: Results, data: dict[str, Any]) -> Proposal | None:
    """Return the slab with drop panels at the columns where concrete alone does not bear punching; None if it does."""
    model = results.model
    needy = {layout.name for layout in punching_links(results) if layout.support == "column"}
    columns = [column for column in model.columns if column.name in needy]
    if not columns or not results.results:
        return None
    region = get_plate_region(model.plate, model.plates)
    panels = [
        (region.plate_at((column.x, column.y)), *_panel(model, column, next(iter(results.values()))))
        for column in columns
    ]
    change = 1e3 * PANEL_STEPS * thickness_step(model)
    names = series(Name(column.name) for column in columns)
    words = Message(f"{PANELS} {{change:.4g mm}} thicker than the slab, at {{names}}", change=change, names=names)
    name = Message("drop panels, {change:.4g mm}", change=change)
    return Proposal(name.in_units(model.units), words.in_units(model.units), tuple(_add_zones(data, panels)))


def _panel(model: Model, column: Column, results: CombinationResult) -> tuple[float, Bounds]:
    """Return the thickness of the drop panel of a column [m], and where it is: x0, x1, y0, y1 [m].

    It is thicker than all of the slab that it covers.
    """
    added, grid = PANEL_STEPS * thickness_step(model), ROUNDED[model.units]
    reach = PANEL_REACH * (thickness_at(results, footprint_of(column)) + added)
    x0, x1, y0, y1 = column.ring().bounds
    bounds = (
        _down(x0 - reach, grid),
        -_down(-x1 - reach, grid),
        _down(y0 - reach, grid),
        -_down(-y1 - reach, grid),
    )
    plate = results.plate
    lower, upper = (edge(plate.nodes[plate.elements], axis=1) for edge in (np.min, np.max))
    covered = (lower < (bounds[1], bounds[3])).all(axis=1) & (upper > (bounds[0], bounds[2])).all(axis=1)
    return float(results.elements.thickness[covered].max()) + added, bounds


def _down(value: float, grid: float) -> float:
    """Return the next multiple of a grid at a value or below."""
    return grid * math.floor(value / grid + 1e-9)


def _add_zones(data: dict[str, Any], panels: Sequence[tuple[int, float, Bounds]]) -> Iterator[tuple[Path, Any]]:
    """Yield the zones of each plate with its drop panels, the thickest last, as it counts where they overlap."""
    for number in sorted({plate for plate, *_ in panels}):
        path: Path = ("plate",) if number == 0 else ("plates", number - 1)
        old = get_value(data, (*path, "thickness"))
        zones = [
            {
                "thickness": _written(old, thickness),
                "shape": {"kind": "rectangle", "x": _pair(old, x0, x1), "y": _pair(old, y0, y1)},
            }
            for plate, thickness, (x0, x1, y0, y1) in sorted(panels)
            if plate == number
        ]
        yield (*path, "zones"), [*get_value(data, (*path, "zones"), []), *zones]


def _pair(old: Any, low: float, high: float) -> list[str]:
    """Return two lengths [m] as a file writes them, in the unit of another one."""
    return [_written(old, low), _written(old, high)]


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
