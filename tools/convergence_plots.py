"""How the values of a verification case come nearer to their references as the mesh is refined, as a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from groundslab.analysis import driver
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult
from groundslab.verification import runner
from groundslab.verification.runner import Case, Outcome

#: How much larger than the case's elements those of the coarser meshes are.
COARSER = (4.0, 2.0)
#: The most rows in a picture.
CURVES = 8


def coarsened(model: Model, factor: float) -> Model:
    """Return the model with elements so many times as large."""
    mesh = model.mesh
    if mesh.counts is not None:
        n, m = (max(1, round(count / factor)) for count in mesh.counts)
        return model.replace(mesh=mesh.replace(counts=(n, m)))
    assert mesh.size is not None, "a case states its mesh"
    refine = [part.replace(size=part.size * factor) for part in mesh.refine]
    return model.replace(mesh=mesh.replace(size=mesh.size * factor, refine=refine))


def rows_of(case: Case, outcomes: Sequence[Outcome], name: str) -> list[tuple[Mapping[str, Any], Outcome]]:
    """Return the rows, with their outcomes, that take a value of a model's solution on the case's own mesh."""
    return [
        (row, outcome)
        for row, outcome in zip(case.rows, outcomes, strict=True)
        if row["model"] == name
        and not {"counts", "orders", "judged"} & set(row)
        and row["quantity"] not in runner.CONSTANTS
    ][:CURVES]


def draw(
    case: Case, outcomes: Sequence[Outcome], model: Model, name: str, results: CombinationResult, path: Path
) -> bool:
    """Draw differences from the references [%] over the unknowns of three meshes; return whether there is any."""
    from matplotlib.figure import Figure

    rows = rows_of(case, outcomes, name)
    if not rows:
        return False
    solved = [driver.solve(coarsened(model, factor)).only for factor in COARSER] + [results]
    unknowns = [each.unknowns for each in solved]
    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    axes = figure.add_subplot()
    for row, outcome in rows:
        take, reference = runner.QUANTITIES[row["quantity"]][1], float(outcome.published)
        size = runner._unit(row) / row.get("factor", 1.0)
        differences = [100 * abs(take(each, row) / size / reference - 1) for each in solved]
        axes.loglog(unknowns, differences, "o-", label=outcome.label)
    axes.set_xlabel("unknowns")
    axes.set_ylabel("difference from the reference [%]")
    axes.grid(which="major", alpha=0.3)
    axes.legend(fontsize="small")
    figure.savefig(path, dpi=110, metadata={"Software": None})
    return True
