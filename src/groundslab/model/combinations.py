"""Combinations of a model: those it lists, those by EN 1990, or each load case by itself, at all positions.

What is solved is the model with its patterns placed: plain loads, cases and combinations.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.arrays import Array
from groundslab.model.loads.en1990 import make_combinations
from groundslab.model.loads.load_cases import Combination, LoadCase
from groundslab.model.loads.load_types import AnyLoad, PointLoad
from groundslab.model.loads.patterns import expand, loads_on_plate, point_loads, position_name, stations
from groundslab.model.plates.region import PlateRegion

if TYPE_CHECKING:
    from groundslab.model.model import Model


def list_combinations(model: Model) -> tuple[Combination, ...]:
    """Return all combinations of a model: those given and those made by EN 1990, at all positions of moving cases.

    With cases and neither of them it is each case by itself; without cases one nameless combination of all loads. Both
    are without partial factors: characteristic (EN 1990 6.5.3), never ultimate.
    """
    return expand(list_unmoved(model), model.moves, _fixed_cases(model))


def as_solved(model: Model) -> Model:
    """Return a case as it is solved: patterns and moving loads placed, its combinations those that are solved.

    It is the model itself where nothing is to be placed or listed.
    """
    placed = place_patterns(model)
    if not placed.cases or (placed.combinations and placed.combine is None):
        return placed
    return placed.model_copy(update={"combinations": list_combinations(placed), "combine": None})


def _fixed_cases(model: Model) -> frozenset[str]:
    """Return the cases in which something stands that does not move."""
    return frozenset(load.case for load in model.loads) | {move.case for move in model.moves if not move.travels}


def list_unmoved(model: Model) -> tuple[Combination, ...]:
    """Return the combinations as if nothing moved: those given first, then those made."""
    if not model.cases:
        return (Combination(name="all loads", limit_state="characteristic", factors={"": 1.0}),)
    generated: tuple[Combination, ...] = ()
    if model.combine is not None:
        generated = make_combinations(model.combine, model.cases)
    if not model.combinations and model.combine is None:
        return tuple(
            Combination(name=case.name, limit_state="characteristic", factors={case.name: 1.0}) for case in model.cases
        )
    return (*model.combinations, *generated)


def case_factors(model: Model, combination: Combination) -> Array:
    """Return the factor of each load case of a model in a combination, (cases,); 1 without cases."""
    factors = dict(combination.factors)
    return np.array([factors.get(case.name, 0.0) for case in model.cases] or [1.0])


def place_patterns(model: Model) -> Model:
    """Return a model whose patterns are point loads, and whose moving cases are cases at each of their positions.

    It is what is solved: the model itself if it has no moves. What else stands in a case that moves keeps the case,
    which then takes part beside each position. On a path, forces beside the plate do not act.

    Parameters
    ----------
    model : Model
        The model.

    Returns
    -------
    Model
        The model without patterns and moves, its combinations those at all positions.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.place_patterns(model) is model
    True
    """
    return _place(model) if model.moves else model


@lru_cache(maxsize=8)
def _place(model: Model) -> Model:
    """Return the model with its patterns placed."""
    loads, moving = _place_forces(model)
    cases = list[LoadCase]()
    fixed = _fixed_cases(model)
    for case in model.cases:
        positions = moving.get(case.name, {})
        stays = not positions or case.name in fixed
        cases += [case] if stays else []
        # horizontal forces stand in one of the cases only
        once = {"H_x": 0.0, "H_y": 0.0} if stays else {}
        cases += [case.model_copy(update={"name": name, **once}) for name in positions]
        loads += [load for at_position in positions.values() for load in at_position]
    changes: dict[str, Any] = {"patterns": (), "moves": (), "cases": tuple(cases), "loads": tuple(loads)}
    if moving:
        changes |= {"combinations": list_combinations(model), "combine": None}
    return model.model_copy(update=changes)


def _place_forces(model: Model) -> tuple[list[AnyLoad], dict[str, dict[str, tuple[PointLoad, ...]]]]:
    """Return the loads with those of patterns at fixed places, and those at each position of each moving case."""
    patterns = {pattern.name: pattern for pattern in model.patterns}
    covered = PlateRegion(model.plate, model.plates)
    loads: list[AnyLoad] = list(model.loads)
    moving: dict[str, dict[str, tuple[PointLoad, ...]]] = {}
    for move in model.moves:
        pattern = patterns[move.pattern]
        for station in stations(move):
            if move.travels:
                name = position_name(move, station)
                placed = loads_on_plate(covered, point_loads(pattern, station, name))
                moving.setdefault(move.case, {})[name] = placed
            else:
                loads += point_loads(pattern, station, move.case)
    return loads, moving
