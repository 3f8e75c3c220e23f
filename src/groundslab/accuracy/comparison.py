"""What a mesh and the next coarser one together tell of the discretization error."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt

import numpy as np

from groundslab.accuracy.energy import energy, energy_errors, error_density
from groundslab.accuracy.prolongation import Prolongation
from groundslab.arrays import Array
from groundslab.fem.assembly import scatter
from groundslab.fem.shape_functions import areas
from groundslab.model.model import Model
from groundslab.results.balance.beam_forces import beam_results
from groundslab.results.balance.building_forces import base_results
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
    parts, parts_before = (
        energy_errors(model, solution, fields),
        energy_errors(model, coarser, coarser_fields),
    )
    squared, before = float(parts.sum()), float(parts_before.sum())
    total = energy(solution) + squared
    density = error_density(solution, frame, parts.sum(axis=1), total)
    reduction = sqrt(squared / before) if before > 0 else 0.0
    if solution.system.problem.elastic is not None:
        reduction = max(reduction, OF_CELLS)
    coarser_density = error_density(coarser, coarser_frame, parts_before.sum(axis=1), total)
    coarser_fields = replace(coarser_fields, elements=coarser_fields.elements | {ERROR: coarser_density})
    plate, elements, ground = expand(prolongation.apply(coarser_fields), frame)
    of_moments, of_shear = _reductions(
        prolongation,
        parts[solution.system.problem.plate.elements, :2],
        parts_before[coarser.system.problem.plate.elements, :2],
        reduction,
    )
    comparison = Comparison(
        plate=plate,
        elements=elements,
        ground=ground,
        supports=support_results(model, coarser),
        joints=joint_results(model, coarser),
        beams=beam_results(model, coarser),
        bases=base_results(model, coarser),
        constants=ground_constants(coarser),
        energy_error=sqrt(squared / total) if total > 0 else 0.0,
        reduction=reduction,
        moment_reduction=of_moments,
        shear_reduction=of_shear,
    )
    return comparison, replace(fields, elements=fields.elements | {ERROR: density})


def _reductions(prolongation: Prolongation, squared: Array, before: Array, whole: float) -> tuple[Array, Array]:
    """Return by what errors of moments and of shear forces fell around each node of the full plate, (n,) each.

    squared (mp, 2) are those of the elements that meet there, before (mc, 2) those of the coarser ones in which they
    lie. Where these have none it is that of the whole.
    """
    finer, coarser = prolongation.finer, prolongation.coarser
    density = (before / areas(coarser.mesh.xy)[:, None])[prolongation.element]
    both = np.stack([squared, density * areas(finer.mesh.xy)[:, None]], axis=-1)[finer.plate.element]
    elements, n = finer.plate.mesh.elements, len(finer.plate.mesh.nodes)
    reductions = []
    for part in np.moveaxis(both, 1, 0):
        now, then = (scatter(elements, np.tile(values[:, None], 9), n) for values in part.T)
        reductions.append(np.sqrt(np.divide(now, then, out=np.full(n, whole**2), where=then > 0)))
    return reductions[0], reductions[1]
