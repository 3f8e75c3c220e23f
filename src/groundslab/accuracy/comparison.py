"""What a mesh and the next coarser one together tell of the discretization error."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt

from groundslab.accuracy.energy import energy, energy_errors, error_density
from groundslab.accuracy.prolongation import Prolongation
from groundslab.model.model import Model
from groundslab.results.fields import ERROR
from groundslab.results.recovery import (
    MeshedFields,
    expand,
    ground_constants,
    joint_results,
    recover_fields,
    support_results,
)
from groundslab.results.results import Comparison
from groundslab.solvers.solution import Solution

#: Cells of constant pressure half as large halve the errors of settlements, whatever the plate's error in energy does.
OF_CELLS = 0.5


def compare(
    model: Model, solution: Solution, coarser: Solution, prolongation: Prolongation, fields: MeshedFields
) -> tuple[Comparison, MeshedFields]:
    """Return the results of a solution on a coarser mesh at the nodes of a finer one, and the errors of both in energy.

    fields are those of the finer one, which are returned with the error of each element of the plate among them.
    """
    frame, coarser_frame = prolongation.finer, prolongation.coarser
    coarser_fields = recover_fields(coarser, coarser_frame)
    by_element = energy_errors(solution, frame, fields.forces)
    squared = float(by_element.sum())
    before_by_element = energy_errors(coarser, coarser_frame, coarser_fields.forces)
    before = float(before_by_element.sum())
    total = energy(solution) + squared
    density = error_density(solution, frame, by_element, total)
    reduction = sqrt(squared / before) if before > 0 else 0.0
    if solution.system.problem.elastic is not None:
        reduction = max(reduction, OF_CELLS)
    coarser_density = error_density(coarser, coarser_frame, before_by_element, total)
    coarser_fields = replace(coarser_fields, elements=coarser_fields.elements | {ERROR: coarser_density})
    plate, elements, ground = expand(prolongation.apply(coarser_fields), frame)
    comparison = Comparison(
        plate=plate,
        elements=elements,
        ground=ground,
        supports=support_results(model, coarser),
        joints=joint_results(model, coarser),
        constants=ground_constants(coarser),
        energy_error=sqrt(squared / total) if total > 0 else 0.0,
        reduction=reduction,
    )
    return comparison, replace(fields, elements=fields.elements | {ERROR: density})
