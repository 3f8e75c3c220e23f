"""What a mesh and the next coarser one together tell of the discretization error."""

from __future__ import annotations

from math import sqrt

from groundslab.accuracy.energy import energy_errors
from groundslab.accuracy.prolongation import Prolongation
from groundslab.model.model import Model
from groundslab.results.certificate import resistance
from groundslab.results.recovery import MeshedFields, expand, recover_fields, support_results
from groundslab.results.results import Comparison
from groundslab.solvers.solution import Solution


def compare(
    model: Model, solution: Solution, coarser: Solution, prolongation: Prolongation, fields: MeshedFields
) -> Comparison:
    """Return the results of a solution on a coarser mesh at the nodes of a finer one, and the errors of both in energy.

    fields are those of the finer one.
    """
    frame, coarser_frame = prolongation.finer, prolongation.coarser
    coarser_fields = recover_fields(coarser, coarser_frame)
    squared = energy_errors(solution, frame, fields.forces).sum()
    before = energy_errors(coarser, coarser_frame, coarser_fields.forces).sum()
    energy = (resistance(solution)[0] * solution.U).sum()
    plate, elements, ground = expand(prolongation.apply(coarser_fields), frame)
    return Comparison(
        plate=plate,
        elements=elements,
        ground=ground,
        supports=support_results(model, coarser),
        energy_error=sqrt(squared / (energy + squared)) if squared > 0 else 0.0,
        reduction=sqrt(squared / before) if before > 0 else 0.0,
    )
