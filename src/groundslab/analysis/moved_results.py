"""Results of a model that is moved for its analysis: moved back to where the plan lies, or there from it."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.errors import GroundslabError, NotCertified
from groundslab.fem.continuum.pressed_cells import PressedCells
from groundslab.geometry.plan import Place
from groundslab.model.combinations import as_solved
from groundslab.model.model import Model
from groundslab.results.plate_result import GroundResult, PlateResult
from groundslab.results.records import BaseResult, BeamResult, JointResult, SupportResult
from groundslab.results.results import CombinationResult, Comparison, Increment, Results

WithNodes = TypeVar("WithNodes", PlateResult, GroundResult, SupportResult, JointResult, BeamResult, BaseResult)
State = TypeVar("State", CombinationResult, Comparison, Increment)


def move_back(results: Results, model: Model) -> Results:
    """Return the results of the model that was analyzed as those of the model that was given, where its plan lies."""
    return results if results.model is model else _move(results, model, results.model.origin)


def move_along(results: Results, local: Model) -> Results:
    """Return results as those of their model about its own center."""
    x, y = local.origin
    return _move(results, local, (-x, -y))


def _move(results: Results, model: Model, by: Place) -> Results:
    """Return results of the moved model."""
    models = model, as_solved(model)
    return Results(
        model,
        results.combinations,
        {name: _move_combination(result, models, by) for name, result in results.results.items()},
        {name: _move_refusal(error, models, by) for name, error in results.refused.items()},
    )


def _move_refusal(error: GroundslabError, models: tuple[Model, Model], by: Place) -> GroundslabError:
    """Return why a combination has no results; those that are not certified are moved."""
    return NotCertified(_move_combination(error.results, models, by)) if isinstance(error, NotCertified) else error


def _move_combination(results: CombinationResult, models: tuple[Model, Model], by: Place) -> CombinationResult:
    """Return the results of one combination, moved, with the case as written and the case as solved."""
    comparison = results.comparison
    return replace(
        _move_state(results, by),
        model=models[0],
        solved_model=models[1],
        supports=_move_each(results.supports, by),
        joints=_move_each(results.joints, by),
        beams=_move_each(results.beams, by),
        bases=_move_each(results.bases, by),
        increments=tuple(_move_state(state, by) for state in results.increments),
        comparison=comparison and _move_comparison(comparison, by),
    )


def _move_comparison(other: Comparison, by: Place) -> Comparison:
    """Return what the coarser mesh gave, moved."""
    return replace(
        _move_state(other, by),
        supports=_move_each(other.supports, by),
        joints=_move_each(other.joints, by),
        beams=_move_each(other.beams, by),
        bases=_move_each(other.bases, by),
    )


def _move_state(state: State, by: Place) -> State:
    """Return plate and ground in a state, moved."""
    return replace(state, plate=_move_nodes(state.plate, by), ground=_move_ground(state.ground, by))


def _move_nodes(part: WithNodes, by: Place) -> WithNodes:
    """Return the plate, the ground, a support, a joint, a beam or a base, moved."""
    return replace(part, nodes=_moved(part.nodes, by))


@made_once
def _moved(nodes: Array, by: Place) -> Array:
    """Return nodes, moved; combinations on one mesh have the same ones before and after."""
    return nodes + by


def _move_each(parts: tuple[WithNodes, ...], by: Place) -> tuple[WithNodes, ...]:
    """Return supports, joints, beams or bases, moved."""
    return tuple(_move_nodes(part, by) for part in parts)


def _move_ground(ground: GroundResult, by: Place) -> GroundResult:
    """Return the ground with its cells, moved."""
    return replace(_move_nodes(ground, by), cells=ground.cells and _move_cells(ground.cells, by))


def _move_cells(cells: PressedCells, by: Place) -> PressedCells:
    """Return the cells of an elastic continuum and the loads beside, moved."""
    return replace(cells, center=cells.center + by, beside=cells.beside + np.array([*by, 0.0]))
