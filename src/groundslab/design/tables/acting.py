"""What acts where: each load case in each combination in which it acts, with its factor and its force."""

from __future__ import annotations

from groundslab.design.punching import outline
from groundslab.design.tables.column_loads import sum_of_others
from groundslab.design.tables.quantities import solved_results
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.results.results import Results


def case_forces(combined: Results) -> dict[str, float]:
    """Return the sum of the vertical loads on the plate of each case as solved [N], downwards positive, unfactored.

    Nothing where no combination has a certified result, as there is no mesh to integrate on.
    """
    solved = solved_results(combined)
    return sum_of_others(solved[0], outline(solved[0].plate), None) if solved else {}


def acting_cases(combined: Results) -> Table:
    """Return the factor of each case as solved in each combination in which it acts; one that acts nowhere has a row.

    The forces are those of all vertical loads of the case on the plate.
    """
    heads = [
        ("case", ""), ("action", ""), ("combination", ""), ("limit state", ""), ("factor", ""),
        ("force of the case", "kN"), ("force with the factor", "kN"),
    ]  # fmt: skip
    forces = case_forces(combined)
    rows: list[list[Cell]] = []
    for case in combined.solved_model.cases:
        force = forces.get(case.name, 0.0) / 1e3
        factors = [dict(combination.factors).get(case.name, 0.0) for combination in combined.combinations]
        acting: list[list[Cell]] = [
            [combination.name, combination.limit_state, factor]
            for combination, factor in zip(combined.combinations, factors, strict=True)
            if factor
        ]
        for where in acting or [[None, None, 0.0]]:
            shown: list[Cell] = [force, float(where[2] or 0.0) * force] if forces else [None, None]
            rows.append([case.name, case.action, *where, *shown])
    notes = ["A case that moves is a case at each of its positions. A row without a combination acts nowhere."]
    return table_of("acting", "What acts where", heads, rows, notes)
