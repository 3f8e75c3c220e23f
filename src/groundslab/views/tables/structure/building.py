"""The tables of the building above: what its stiffness adds to the loads of columns and walls, storey by storey."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.loads.column_loads import by_column, factors_of
from groundslab.design.demands.loads.wall_loads import loads_on_wall
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.table import Cell, Table, table_of

_HEADS = (
    ("combination", ""), ("base", ""), ("load on a rigid base", "kN"), ("load", "kN"), ("change of load", "kN"),
    ("change over load", "%"), ("change of M_x", "kNm"), ("change of M_y", "kNm"), ("settlement", "mm"),
    ("slope along x", "mm/m"), ("slope along y", "mm/m"),
)  # fmt: skip
#: Storeys matter until all changes of loads are within this share of the largest one.
MATTERS = 0.05
_NOTES = (
    "The load on a rigid base is that of the case, with the factors of its load cases; its change is what the "
    "building's stiffness adds as the slab settles, downwards positive. All changes together are in equilibrium.",
)
_STOREYS = (
    Message(
        "Changes by the lowest storeys alone, with the contact of all of them. Storeys matter until "
        "every change is within {matters:.0f} % of the largest one of all storeys.",
        matters=100 * MATTERS,
    ),
)


def building_table(combined: Results) -> Table:
    """Return what the building adds to the load of each base in each combination."""
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        for base in results.bases:
            on_rigid = _on_rigid_base(combined.model, base.name, results)
            change = float(base.force.sum())
            row: list[Cell] = [results.combination, base.name, on_rigid / 1e3, (on_rigid + change) / 1e3, change / 1e3]
            row += [100 * change / on_rigid if on_rigid else None, base.moment_x.sum() / 1e3, base.moment_y.sum() / 1e3]
            rows.append([*row, *(1e3 * motion.sum() for motion in (base.settlement, base.slope_x, base.slope_y))])
    return table_of("building", "Building above", _HEADS, rows, _NOTES)


def storey_table(combined: Results) -> Table:
    """Return what the lowest storeys alone would add, column by column, and how many matter."""
    first = next((results.bases[0].by_storeys for results in solved_results(combined)), np.zeros((1, 0)))
    counts = range(1, first.shape[1] + 1)
    heads = [
        ("combination", ""),
        ("base", ""),
        *((Message("change by {storeys}", storeys=_storeys(n)), "kN") for n in counts),
        ("storeys that matter", ""),
    ]
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        changes = np.concatenate([base.by_storeys for base in results.bases])
        for base, change in zip(results.bases, changes, strict=True):
            rows.append([results.combination, base.name, *(change / 1e3), storeys_that_matter(changes)])
    return table_of("storeys", "Storeys of the building above", heads, rows, _STOREYS)


def storeys_that_matter(changes: Array) -> int:
    """Return how many storeys it takes until all changes (b, s) are near those of all storeys."""
    off = np.abs(changes - changes[:, -1:]).max(axis=0)
    enough = off <= MATTERS * np.abs(changes[:, -1]).max()
    return int(np.flatnonzero(~enough).max(initial=-1)) + 2


def _storeys(count: int) -> str:
    """Return a number of storeys in words."""
    return Message("{count} storey", count=count) if count == 1 else Message("{count} storeys", count=count)


def _on_rigid_base(model: Model, name: str, results: CombinationResult) -> float:
    """Return the load of a column or wall [N] without what the building adds."""
    factors = {case: factor for case, factor in factors_of(results).items() if not case.startswith("\0")}
    if any(column.name == name for column in model.columns):
        return float(sum(factors.get(case, 0.0) * sums[0] for case, sums in by_column(model, name).items()))
    wall = next(wall for wall in model.placed_walls if wall.name == name)
    loads = loads_on_wall(model, wall)
    return float(sum(factors.get(case, 0.0) * loads.sum_of(ends) for case, ends in loads.force.items()))
