"""The table of bars that are laid: how many of which length, and what they weigh."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.bar_layout import BarSet, bar_sets
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.model.model import Model
from groundslab.model.plates.region import PlateRegion

#: Bars of one set have a row for each length, to the millimeter, unless there are more lengths than this.
MOST_LENGTHS = 6
MM = 1e3


def bars(model: Model) -> Table:
    """Return the quantities of the bars provided, with their sum in the last row."""
    heads = [
        ("layer", ""), ("zone", ""), ("mesh", ""), ("diameter", "mm"), ("spacing", "mm"), ("number", ""),
        ("least length", "m"), ("greatest length", "m"), ("total length", "m"), ("mass", "kg"),
        ("mass per area", "kg/m2"),
    ]  # fmt: skip
    area = PlateRegion(model.plate, model.plates).area.area
    rows = [row for bar_set in bar_sets(model) for row in _rows(bar_set, area)]
    if rows:
        number, length, mass, share = (sum(float(row[i] or 0) for row in rows) for i in (5, 8, 9, 10))
        rows.append(["all layers", None, None, None, None, round(number), None, None, length, mass, share])
    notes = [
        "Straight bars, cut by the outline, by openings and by the borders of zones; of meshes their wires. Laps, "
        "hooks, bars around edges and openings, spacers and waste are not in it, and the cover at the ends of bars is "
        "not taken off. Steel of 7850 kg/m3 (EN 1992-1-1 3.2.7(3)); the mass per area is over all of the slab.",
        f"Of a set with more than {MOST_LENGTHS} different lengths there is one row.",
    ]
    return table_of("bars", "Bars provided", heads, rows, notes)


def _rows(bar_set: BarSet, area: float) -> Iterator[list[Cell]]:
    """Yield the rows of a set of bars on a slab of some area [m2]."""
    rounded = np.round(bar_set.lengths, 3)
    different = np.unique(rounded)
    groups = [rounded == length for length in different[::-1]] if len(different) <= MOST_LENGTHS else [rounded > 0]
    for group in groups:
        lengths = bar_set.lengths[group]
        total = float(lengths.sum())
        mass = bar_set.mass_of(total)
        yield [
            bar_set.layer.replace("_", " "), bar_set.zone or None, bar_set.mesh or None, bar_set.bars.diameter * MM,
            bar_set.bars.spacing * MM, len(lengths), float(lengths.min()), float(lengths.max()),
            total, mass, mass / area,
        ]  # fmt: skip
