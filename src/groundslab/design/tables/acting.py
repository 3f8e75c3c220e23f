"""What acts where: each load case in each combination in which it acts, with its factor and its force."""

from __future__ import annotations

from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.model.resultants import case_forces
from groundslab.results.results import Results


def acting_cases(combined: Results) -> Table:
    """Return the factor of each case as solved in each combination in which it acts; one that acts nowhere has a row.

    The forces are those of all vertical loads of the case on the plate.
    """
    heads = [
        ("case", ""), ("action", ""), ("combination", ""), ("limit state", ""), ("factor", ""),
        ("force of the case", "kN"), ("force with the factor", "kN"),
    ]  # fmt: skip
    forces = case_forces(combined.solved_model)
    rows: list[list[Cell]] = []
    for case in combined.solved_model.cases:
        force = forces.get(case.name, 0.0) / 1e3
        acting = [(combination, dict(combination.factors).get(case.name, 0.0)) for combination in combined.combinations]
        acting = [(combination, factor) for combination, factor in acting if factor]
        rows += [
            [case.name, case.action, combination.name, combination.limit_state, factor, force, factor * force]
            for combination, factor in acting
        ]
        if not acting:
            rows.append([case.name, case.action, None, None, 0.0, force, 0.0])
    notes = ["A case that moves is a case at each of its positions. A row without a combination acts nowhere."]
    return table_of("acting", "What acts where", heads, rows, notes)
