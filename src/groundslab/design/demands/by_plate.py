"""The results of several plates, plate by plate, and of what of them lies at one level."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace
from functools import lru_cache
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once, made_once_by
from groundslab.messages import Message
from groundslab.model.loads.acting import PlateAction, PointForce
from groundslab.model.loads.load_types import AnyLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, first_sections
from groundslab.model.plates.pits import pits_of
from groundslab.model.plates.region import PlateRegion, get_plate_region
from groundslab.results.plate_result import ElementResult, PlateResult
from groundslab.results.results import CombinationResult, Comparison

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry


def results_by_plate(results: CombinationResult) -> dict[str, PlateResult]:
    """Return the results of each plate by its name, or its number from 1; of a single plate with an empty name."""
    if not results.model.plates:
        return {"": results.plate}
    return {name: results.plate.part(elements) for name, elements in _elements_by_plate(results).items()}


def _elements_by_plate(results: CombinationResult) -> dict[str, Flags]:
    """Return which elements belong to each plate."""
    plates = results.model.every_plate
    number = np.searchsorted(first_sections(plates), results.elements.section, side="right") - 1
    return {plate.name or Message("plate {n}", n=n + 1): number == n for n, plate in enumerate(plates)}


def split_by_plate(results: CombinationResult) -> dict[str, CombinationResult]:
    """Return the results of each plate as if there were no other, by its name as in `results_by_plate`.

    Their models hold one plate and the loads on it; loads that extend over several plates are in the model of each.
    """
    if not results.model.plates:
        return {"": results}
    models = _models_by_plate(results.solved_model)
    parts = zip(_elements_by_plate(results).items(), models, strict=True)
    return {
        name: replace(
            results,
            model=model,
            solved_model=model,
            plate=results.plate.part(those),
            elements=_part_of(results.elements, those),
            comparison=_part_of_comparison(results.comparison, results.plate.elements, those),
        )
        for (name, those), model in parts
    }


def _part_of(elements: ElementResult, those: Flags) -> ElementResult:
    values = {field.name: getattr(elements, field.name) for field in fields(elements)}
    parts: dict[str, Any] = {name: value if value is None else value[those] for name, value in values.items()}
    return ElementResult(**parts)


def _part_of_comparison(comparison: Comparison | None, elements: Integers, those: Flags) -> Comparison | None:
    if comparison is None:
        return None
    nodes = np.unique(elements[those])
    of_moments, of_shear = (
        None if reduction is None else reduction[nodes]
        for reduction in (comparison.moment_reduction, comparison.shear_reduction)
    )
    return replace(
        comparison,
        plate=comparison.plate.part(those),
        elements=_part_of(comparison.elements, those),
        moment_reduction=of_moments,
        shear_reduction=of_shear,
    )


@lru_cache(maxsize=4)
def _models_by_plate(model: Model) -> tuple[Model, ...]:
    """Return a model of each plate alone."""
    region = PlateRegion(model.plate, model.plates)
    return tuple(
        # loads on what lies beside the plate are of no interest here, and would not be valid
        model.model_copy(
            update={
                "plate": plate if isinstance(plate, Plate) else Plate(**dict(plate)),
                "plates": (),
                "joints": (),
                "loads": tuple(load for load in model.loads if _acts_on(load, n, plate, model, region)),
            }
        )
        for n, plate in enumerate(model.every_plate)
    )


def _acts_on(load: AnyLoad, number: int, plate: AnyPlate, model: Model, region: PlateRegion) -> bool:
    """Return whether a load acts on a plate, or may act on it as it extends over an area or along a line."""
    for shape in model.shapes(load):
        if isinstance(shape, PointForce):
            return region.plate_at(shape.place) == number
        if isinstance(shape, PlateAction):
            return shape.plate in ("", plate.name)
    return True


def plate_under(results: CombinationResult, x: float, y: float) -> PlateResult:
    """Return the results of the plate that a place [m] lies on, as if there were no other.

    They are those of what lies at its level: a pit, or all around pits, which bars and perimeters do not leave.
    """
    model = results.model
    number = PlateRegion(model.plate, model.plates).plate_at((x, y)) if model.plates else 0
    plate = list(results_by_plate(results).values())[number]
    if not pits_of(model.every_plate[number]):
        return plate
    region = get_plate_region(model.plate, model.plates)
    return _parts_at_levels(plate, region)[region.levels.index(region.level_at((x, y)))]


@made_once
def _parts_at_levels(plate: PlateResult, region: PlateRegion) -> tuple[PlateResult, ...]:
    """Return the results of what of a plate lies at each level of a region, empty where nothing does."""
    return tuple(plate.part(_at_level(plate, level)) for level in region.levels)


def split_by_level(results: CombinationResult) -> Iterator[CombinationResult]:
    """Yield the results of what of a single plate lies at one level: all around its pits, then each pit."""
    model = results.model
    levels = get_plate_region(model.plate, model.plates).levels
    if len(levels) == 1:
        yield results
        return
    for level in levels:
        those = _at_level(results.plate, level)
        yield replace(
            results,
            plate=results.plate.part(those),
            elements=_part_of(results.elements, those),
            comparison=_part_of_comparison(results.comparison, results.plate.elements, those),
        )


def nodes_at(results: CombinationResult, level: BaseGeometry) -> Flags:
    """Return which nodes (n,) of the plates lie in what is at one level; those at its steps stand once for each."""
    on_level = np.zeros(len(results.plate.nodes), dtype=bool)
    on_level[results.plate.elements[_at_level(results.plate, level)]] = True
    return on_level


def _at_level(plate: PlateResult, level: BaseGeometry) -> Flags:
    """Return which elements (m,) lie in an area at one level, whose borders the mesh follows."""
    from shapely import contains_xy

    return np.asarray(contains_xy(level, *plate.nodes[plate.elements[:, -1]].T))


@made_once_by(attrgetter("plate.nodes", "plate.elements"))
def farthest_from_edges(results: CombinationResult) -> float:
    """Return the largest distance of any node from the edges of all plates [m]."""
    return float(distances_to_edges(results, results.plate.nodes).max())


def distances_to_edges(results: CombinationResult, places: Array) -> Array:
    """Return how far places (k, 2) [m] are from the edges of all plates (k,) [m]."""
    edges = [edge for plate in results.model.every_plate for ring in plate.rings() for edge in ring.segments()]
    nearest: Array = np.min([edge.distance(places) for edge in edges], axis=0)
    return nearest
