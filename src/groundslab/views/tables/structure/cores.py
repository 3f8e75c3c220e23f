"""The tables of cores: their sections, and what their walls bring to the slab in each load case."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.core_loads import CoreLoad
from groundslab.model.structure.cores import Core, CoreSection, section_of
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

_SECTIONS = (
    ("core", ""), ("x", "m"), ("y", "m"), ("area", "m2"), ("I_xx", "m4"), ("I_yy", "m4"), ("I_xy", "m4"),
    ("share of the larger principal moment", "%"),
)  # fmt: skip
_SECTION_NOTES = (
    "Of the axes of its walls with their thicknesses, without openings. x and y are those of its center, about which "
    "moments of its loads are given; I_xx, I_yy and I_xy are the sums of area times x x, y y and x y about it. The "
    "share is the smaller principal moment of inertia over the larger one.",
)
_LOADS = (
    ("case", ""), ("core", ""), ("wall", ""), ("from the start", "m"), ("up to", "m"),
    ("load per length at the start", "kN/m"), ("load per length at the end", "kN/m"),
    ("force", "kN"), ("M_x", "kNm"), ("M_y", "kNm"),
)  # fmt: skip
_LOAD_NOTES = (
    "Without factors: a wall's thickness times the stress of the core's section, which stays plane; negative where a "
    "wall pulls at the slab. Moments are about the center of the core. The sum of all walls is what is given.",
)
ALL_WALLS = "all walls"
#: A sum below this part of the sum of sizes is nothing but rounding.
ROUNDING = 1e-9


def core_table(combined: Results) -> Table:
    """Return center, area and moments of inertia of the section of each core."""
    rows: list[list[Cell]] = []
    for core, section in _sections(combined):
        (xx, xy), (_, yy) = section.inertia
        least, most = np.linalg.eigvalsh(np.array(section.inertia))
        rows.append([core.name, *section.center, section.area, xx, yy, xy, 100 * max(float(least / most), 0.0)])
    return table_of("cores", "Cores", _SECTIONS, rows, _SECTION_NOTES)


def core_load_table(combined: Results) -> Table:
    """Return what the walls of each core bring to the slab in each load case, and the sums."""
    rows: list[list[Cell]] = []
    model = combined.model
    for case in [case.name for case in model.cases] or [""]:
        for core, section in _sections(combined):
            loads = [load for load in model.loads if isinstance(load, CoreLoad)]
            acting = [load.acts_on(section) for load in loads if (load.core, load.case) == (core.name, case)]
            total, size = np.zeros(3), np.zeros(3)
            for lines in zip(*acting, strict=True):
                q = np.sum([line.q for line in lines], axis=0)
                sums = _resultant(lines[0], q, section)
                total, size = total + sums, size + np.abs(sums)
                where = lines[0].wall, lines[0].start, lines[0].start + lines[0].length
                rows.append([case, core.name, *where, *(q / 1e3), *(sums / 1e3)])
            if acting:
                total[np.abs(total) < ROUNDING * size] = 0.0
                rows.append([case, core.name, ALL_WALLS, None, None, None, None, *(total / 1e3)])
    return table_of("core_loads", "Loads of cores", _LOADS, rows, _LOAD_NOTES)


def _sections(combined: Results) -> Iterator[tuple[Core, CoreSection]]:
    """Yield each core with its section."""
    model = combined.model
    for core in model.cores:
        yield core, section_of(core, model.walls, model.every_plate)


def _resultant(line: LineForce, q: Array, section: CoreSection) -> Array:
    """Return force [N] and moments about the center of a core [N m] (3,) of a linear force per length on a line."""
    (edge,) = line.edges
    start, end = (np.subtract(place, section.center) for place in (edge.start, edge.end))
    moments = (q[0] * (2 * start + end) + q[1] * (start + 2 * end)) / 6
    force: Array = edge.length * np.array([q.sum() / 2, *moments])
    return force
