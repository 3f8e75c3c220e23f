"""The table of walls: what stands on them, how the plate settles and bends along them."""

from __future__ import annotations

from groundslab.design.bars.wall_bars import WallNeed, wall_needs
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.loads.wall_loads import loads_on_wall, settlement_along
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Clause, Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import Results
from groundslab.views.tables.table import Cell, Table, table_of

_HEADS = (
    ("combination", ""), ("wall", ""), ("length", "m"), ("load", "kN"),
    ("least load per length", "kN/m"), ("greatest load per length", "kN/m"), ("moment per length", "kNm/m"),
    ("settlement at the start", "mm"), ("settlement at the end", "mm"),
    ("least settlement", "mm"), ("greatest settlement", "mm"),
    ("deflection", "mm"), ("deflection over length", "mm/m"),
)  # fmt: skip
_NOTES = (
    "The load is the sum of what acts through the wall, with the factors of the cases: line loads that name it, its "
    "part of the loads of its core, and what a building above adds. The moment per length is that of the line moments "
    "that name it, where it is largest. Beside doors the load includes what their lintels bring.",
    "The deflection is the largest distance of the settlement along the wall from the straight line between the "
    "settlements of its ends, positive where the wall sags; a closed wall has none.",
)


#: What walls with a height need.
_NEEDS = (
    ("wall", ""), ("required bars upright", "cm2/m"), ("required bars level", "cm2/m"), ("shear force", "kN"),
    ("shear force that struts bear", "kN"), ("share used", ""), ("from the start", "m"), ("combination", ""),
)  # fmt: skip


def wall_reinforcement(combined: Results, steel: Reinforcement) -> Table:
    """Return the least bars of each part of a wall with a height, and what its shear force uses of its struts."""
    code = code_of(steel)
    assert code.walls is not None
    notes = (
        Message(
            "By {name} {clauses}, with the concrete and the steel of the slab: the least bars of both faces "
            "together, and the shear force that uses most of what struts bear over all ultimate "
            "combinations. Ties, forces along and across, ends, openings and joints of walls with a height "
            "are not designed.",
            name=Name(code.name),
            clauses=Clause(code.walls.clauses),
        ),
    )
    if code.walls.least is None:
        notes = (
            Message(
                "By {name} {clauses}, with the concrete and the steel of the slab: the shear force that uses "
                "most of what struts bear over all ultimate combinations. Least bars, ties, forces along and "
                "across, ends, openings and joints of walls with a height are not designed.",
                name=Name(code.name),
                clauses=Clause(code.walls.clauses),
            ),
        )
    rows: list[list[Cell]] = [
        [need.wall, *_of_least(need), need.force / 1e3, need.borne / 1e3, need.used, need.way,
         need.combination]
        for need in wall_needs(combined, steel)
    ]  # fmt: skip
    return table_of("wall_reinforcement", "Reinforcement of walls", _NEEDS, rows, notes)


def _of_least(need: WallNeed) -> list[Cell]:
    """Return the least bars upright and level [cm2/m], if they are known."""
    return [None if area is None else area * 1e4 for area in (need.upright, need.level)]


_LIMITS = (
    ("combination", ""), ("quantity", ""), ("unit", ""),
    ("least without stiffness", ""), ("least", ""), ("least uncracked", ""),
    ("greatest without stiffness", ""), ("greatest", ""), ("greatest uncracked", ""),
)  # fmt: skip
_LIMIT_NOTES = (
    "The case as it is beside the same with none and with all of the stiffness of its walls, on the same mesh. What is "
    "designed is the case as it is.",
)


def wall_limit_table(combined: Results) -> Table:
    """Return the extremes of the plate with none, with the stated share and with all of its walls' stiffness."""
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        limits = {share: {name: ends for name, *ends in told} for share, told in results.wall_limits}
        for name in next(iter(limits.values()), {}):
            about, values = PLATE_FIELDS[name], getattr(results.plate, name)
            of_each = [limits.get(0.0, {}).get(name), [values.min(), values.max()], limits.get(1.0, {}).get(name)]
            ends: list[Cell] = [None if bounds is None else float(bounds[k] * about.scale) for k in (0, 1)
                                for bounds in of_each]  # fmt: skip
            rows.append([results.combination, about.label, about.unit, *ends])
    values = tuple(name for name, _ in _LIMITS[3:])
    return table_of("wall_limits", "Limits of walls", _LIMITS, rows, _LIMIT_NOTES, values)


def wall_table(combined: Results) -> Table:
    """Return load, settlement and deflection of each wall in each combination."""
    model = combined.model
    walls = [(wall, loads_on_wall(model, wall), settlement_along(model, wall)) for wall in model.placed_walls]
    rows: list[list[Cell]] = []
    for results in solved_results(combined):
        for wall, loads, along in walls:
            force, couple = loads.in_combination(results)
            line = along(results)
            w = line.w * 1e3
            bent: list[Cell] = [None, None]
            if not wall.closed:
                bent = [line.deflection * 1e3, line.deflection / wall.length * 1e3]
            most = max(couple.ravel(), key=abs)
            about: list[Cell] = [results.combination, wall.name, wall.length, loads.sum_of(force) / 1e3]
            ends: list[Cell] = [w[0], w[-1]] if not wall.closed else [None, None]
            rows.append([*about, force.min() / 1e3, force.max() / 1e3, most / 1e3, *ends, w.min(), w.max(), *bent])
    return table_of("walls", "Walls", _HEADS, rows, _NOTES)
